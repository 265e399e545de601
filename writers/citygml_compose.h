/*
 * From an object of the stream to its CityGML text: the work of one worker.
 *
 * First everything gets its place (citygml_plan.c, citygml_places.c): each
 * feature its class in the target version and the property that holds it; each
 * attribute, geometry, polygon, relation an item in a property of its feature.
 * Then the items are sorted by feature and property, which is the order the
 * schema wants, and written:
 *
 *     citygml_shelter.c    features that are not in the stream
 *     citygml_plan_view.c  footprints and roof edges
 *     citygml_compose.c    features, from the top down
 *     citygml_naming.c     ids
 *     citygml_value_tree.c attributes as a tree
 *     citygml_group_roles.c  roles of members of groups
 *     citygml_values.c     simple and structured attributes
 *     citygml_spelling.c   values as the schema spells them
 *     citygml_generic.c    generic attributes
 *     citygml_address.c    addresses, between the versions of xAL
 *     citygml_shapes.c     geometry
 *     citygml_paint_order.c  which paints, in which order
 *     citygml_paints.c     appearance
 *     citygml_surface_data.c  its materials and images
 *     citygml_pieces.c     polygons: repeated ones, ids
 *     citygml_merge.c      polygons that have only triangles, joined
 *
 * Nothing recurses. What has no place is in the report.
 */
#ifndef TESSERA_CITYGML_COMPOSE_H
#define TESSERA_CITYGML_COMPOSE_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#include "arena.h"
#include "array.h"
#include "citygml_ids.h"
#include "citygml_markup.h"
#include "citygml_schema.h"
#include "coplanar.h"
#include "report.h"
#include "tcs.h"

enum item_kind {
	ITEM_NAME, /* the name of the feature */
	ITEM_ATTRIBUTE, /* in its standard place */
	ITEM_HEIGHT, /* measuredHeight as a structured height */
	ITEM_MEASURED, /* the other way */
	ITEM_GENERIC,
	ITEM_APPEARANCE, /* all of them */
	ITEM_GEOMETRY,
	ITEM_POLYGON, /* of the geometry of another feature */
	ITEM_INSTANCE,
	ITEM_CHILD,
	ITEM_RELATION,
	ITEM_INSIDE, /* relationToConstruction, by the class */
	ITEM_PART_OF, /* the id of the feature it was taken out of */
	ITEM_ORIGINAL_ID, /* an id that was not legal */
	ITEM_MEMBER, /* a feature that only is a member of a group there */
	ITEM_REQUIRED, /* a property that must be there and came without */
};

struct item {
	uint32_t feature;
	uint32_t index; /* in the array its kind is about */
	uint32_t order; /* of arrival */
	uint16_t property; /* of the feature's class */
	uint8_t kind; /* enum item_kind */
};

/* A feature on its way out. */
struct node {
	const struct schema_class *class;
	const char *module; /* that of the class, or of the host of a surface */
	const char *id; /* NULL: none */
	const char *note; /* its role as a member of a group; NULL: none */
	uint32_t parent; /* the written feature around it; TCS_NONE */
	uint32_t host; /* itself, or for a surface what it bounds */
	uint32_t first_item, item_end;
	uint16_t property; /* of the parent; SCHEMA_NONE: a member */
	uint64_t taken; /* bit n: property n has its geometry */
	uint8_t lods[8]; /* of a host: where each LOD goes; by its number */
	uint16_t number; /* of the class */
	bool has_roles; /* a group: its members have their roles as notes */
	bool melted; /* not written: what is below belongs to the parent */
	bool spread; /* a group: what was below it hangs by the parent */
	bool inside; /* said to be inside its construction */
	bool flat; /* all it has is a geometry at level 0 */
};

/* A polygon on its way out. */
struct piece {
	const char *id; /* NULL: none needed */
	uint32_t home; /* the feature below which it is written */
	uint32_t first; /* polygon of which it is a repetition; TCS_NONE */
	uint32_t first_face; /* of one without rings: the joined polygons
	                        that go by its id */
	uint32_t face_count;
	uint32_t first_ring_id; /* of `ring_ids`; TCS_NONE: not needed. A
	                           patch has one for each triangle. */
	bool foreign; /* written by an earlier object */
	bool rings_need_ids; /* a texture refers to them */
	bool is_target; /* something refers to it */
};

/* A polygon joined from triangles. */
struct face {
	const char *id; /* of all but the first, whose id is the polygon's */
	uint32_t first_ring, ring_count; /* of `merged`; the outer one first */
	uint32_t rings_before; /* of earlier faces of the same polygon */
};

/* A triangulated surface, whose triangles GML gives no ids: what paints them
 * names the surface, and of a texture their rings. */
struct surface {
	const char *id; /* NULL: none needed */
	bool is_target;
	bool in_parts; /* a material paints some of it only */
};

/* A paint's material, or its texture. */
struct painting {
	uint32_t index; /* of the paint */
	uint32_t surface; /* geometry that a patch is part of; TCS_NONE */
	bool textured;
};

/* An address, and the geometry that says where it is. */
struct address {
	uint32_t attribute;
	uint32_t points; /* TCS_NONE: none */
};

/* Where an instance's geometry belongs in the text. */
struct hole {
	size_t at;
	uint32_t prototype;
	unsigned depth; /* of indentation */
};

/* The images and materials of the stream so far. */
struct gml_palette {
	struct tcs_palette all;
	/* per entry: the number of the object behind it, which keeps its id */
	TCS_ARRAY(uint64_t) material_objects;
	TCS_ARRAY(uint64_t) image_objects;
	pthread_rwlock_t lock;
};

/* Append entries that stand before the object of this number, without the
 * bytes of images. Takes the lock. Fails with TCS_NO_MEMORY. */
enum tcs_status gml_palette_add(struct gml_palette *palette,
	const struct tcs_palette *more, uint64_t object,
	struct tcs_fault *fault) TCS_CHECKED;
void gml_palette_release(struct gml_palette *palette);

/* An entry of the palette, copied: it may grow meanwhile. `id` is "" where the
 * entry must not have one here. Text is in the composer's arena. */
struct gml_material {
	struct tcs_material is;
	const char *id;
};

struct gml_image {
	struct tcs_image is;
	const char *id, *uri, *mime, *type;
};

/* What all workers are told; constant. */
struct compose_plan {
	struct schema schema;
	struct hash_key key; /* of ids */
	struct gml_palette *palette;
	bool from_3; /* the source is CityGML 3.0 */
	bool writes_images; /* that the stream carries, beside the document */
	bool north_first; /* the source's axis order */
	bool geographic; /* x and y are degrees */
	double metres, metres_up; /* per unit of x and y, of z */
};

/* What comes of one object. */
struct composed {
	struct markup markup;
	struct markup appearance; /* of a prototype, as members of the model */
	struct report report;
	TCS_ARRAY(uint64_t) defined; /* ids, hashed */
	TCS_ARRAY(uint64_t) needed; /* ids of earlier objects */
	TCS_ARRAY(uint64_t) linked; /* ids that relations name */
	TCS_ARRAY(struct hole) holes;
	TCS_ARRAY(char) outer_id; /* of a prototype: what instances link to */
	struct tcs_point lower, upper; /* of its vertices */
	bool has_bounds;
	uint64_t members; /* city objects */
	uint64_t polygons; /* written in full */
};

void composed_release(struct composed *composed);

/* One worker's scratch, reused; all zero is empty. */
struct composer {
	const struct compose_plan *plan;
	const struct id_set *taken; /* ids of the file so far, or NULL */
	struct tcs_object object;
	struct arena arena;
	struct composed *out;
	uint64_t number; /* of the object, or the prototype, in the stream */
	uint64_t before; /* objects before it */
	TCS_ARRAY(struct node) nodes; /* by feature, then those made up */
	TCS_ARRAY(struct item) items;
	TCS_ARRAY(struct piece) pieces;
	TCS_ARRAY(uint32_t) owners; /* geometry of each polygon */
	TCS_ARRAY(struct surface) surfaces; /* one for each geometry */
	TCS_ARRAY(uint32_t) roots; /* features written as members */
	TCS_ARRAY(uint32_t) stack; /* features being written */
	TCS_ARRAY(uint32_t) first_member; /* of attributes, as a tree */
	TCS_ARRAY(uint32_t) next_member;
	TCS_ARRAY(uint32_t) last_member;
	TCS_ARRAY(struct address) addresses; /* in the order of features */
	TCS_ARRAY(struct painting) paints; /* in the order they are written */
	TCS_ARRAY(struct face) faces;
	struct coplanar merged;
	TCS_ARRAY(struct tcs_triangle) triangles; /* being joined */
	TCS_ARRAY(uint32_t) triangle_polygons;
	TCS_ARRAY(uint64_t) coats; /* of vertices, where there are textures */
	TCS_ARRAY(const struct tcs_paint *) textures;
	TCS_ARRAY(const char *) ring_ids;
	TCS_ARRAY(uint32_t) slots; /* a hash table of polygon ids */
	struct id_set ids; /* defined in this object */
	struct id_numbers numbers; /* made of ids that were not free */
	uint64_t made; /* ids made up so far */
	const char *outer_id; /* of a prototype's geometry, once written */
	bool wants_outer_id;
	bool is_prototype; /* in coordinates of its own */
};

void composer_release(struct composer *composer);

/*
 * Compose the text of an object record. With `taken`, no id of it is defined
 * again, and what earlier objects must have defined is written in full where
 * they have not. Fails with TCS_BAD_INPUT (a broken record) and TCS_NO_MEMORY.
 */
enum tcs_status compose_object(struct composer *composer,
	const struct tcs_record *record, const struct id_set *taken,
	struct composed *out, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Compose the geometry of a prototype record, the content of an implicit
 * geometry's property, and its id.
 */
enum tcs_status compose_prototype(struct composer *composer,
	const struct tcs_record *record, const struct id_set *taken,
	struct composed *out, struct tcs_fault *fault) TCS_CHECKED;

/* ---- shared by the files of the composer --------------------------------- */

static inline bool
compose_is_3(const struct composer *composer)
{
	return composer->plan->schema.version == GML_3_0;
}

static inline const char *
compose_text(const struct composer *composer, tcs_text text)
{
	return composer->object.text.at + text;
}

static inline const struct property *
compose_property(const struct composer *composer, const struct item *item)
{
	return &composer->nodes.at[item->feature]
			.class->properties[item->property];
}

/* The module of a property of a feature: surfaces follow their host's. */
const char *compose_module(const struct composer *composer, uint32_t feature,
	const struct property *property);

enum tcs_status compose_note(struct composer *composer,
	enum report_severity severity, const char *item, const char *reason,
	const char *id, struct tcs_fault *fault) TCS_CHECKED;

/* The same for what is found while writing; want of memory is remembered. */
void compose_lose(struct composer *composer, const char *item,
	const char *reason, const char *id);

/* The feature that is written for one, itself or around it. */
static inline uint32_t
compose_written(const struct composer *composer, uint32_t feature)
{
	while (composer->nodes.at[feature].melted)
		feature = composer->nodes.at[feature].parent;
	return feature;
}

/* The length of a unit along each axis, near the object, in metres. */
struct tcs_point compose_metres(const struct composer *composer);

/* A property that links to a feature; `note` is the role of a group member. */
void link_write(struct composer *composer, const struct item *item,
	const char *target, const char *note);

/* ---- citygml_naming.c ---------------------------------------------------- */

/*
 * An id to define: `wanted` made legal and unique, or one made up when it is
 * empty. Registers it. NULL without memory.
 */
const char *compose_id(struct composer *composer, const char *wanted);

/*
 * An id for a geometry or for what is in it. The original may stand beside a
 * simplified one and keeps its ids; those of the other say which level it is
 * of.
 */
const char *compose_id_in(struct composer *composer,
	const struct tcs_geometry *geometry, tcs_text wanted);

/* ---- citygml_plan.c, citygml_places.c ------------------------------------ */

/* Nodes: class, place and id of every feature. */
enum tcs_status plan_features(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_elements.c -------------------------------------------------- */

/* Whether the feature was a product of IFC. */
bool element_is_ifc(const struct composer *composer, uint32_t feature);

/* The boundary surface that a constructive element is in 1.0 and 2.0;
   Unknown for none, and in 3.0. */
unsigned element_surface(const struct composer *composer, uint32_t feature);

/* For each feature the one in whose opening it stands; TCS_NONE for none.
   Fails with TCS_NO_MEMORY. */
enum tcs_status elements_find_hosts(const struct composer *composer,
	uint32_t *hosts, struct tcs_fault *fault) TCS_CHECKED;

/* ---- */

enum tcs_status item_add(struct composer *composer, uint32_t feature,
	uint16_t property, enum item_kind kind, uint32_t index,
	struct tcs_fault *fault) TCS_CHECKED;

/* Items: everything else, sorted. */
enum tcs_status place_items(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* The property for a geometry at a level; SCHEMA_NONE for none. Bit n of
 * `taken`: property n has one. */
uint16_t place_find(const struct composer *composer,
	const struct schema_class *class, uint64_t taken,
	const struct tcs_geometry *geometry, unsigned lod);

/* Put the geometry there: the property is taken then. */
enum tcs_status place_geometry_at(struct composer *composer, uint32_t index,
	uint32_t feature, uint16_t property, unsigned lod,
	struct tcs_fault *fault) TCS_CHECKED;

/* The polygons of one join the geometry that the property has already. */
enum tcs_status place_geometry_beside(struct composer *composer, uint32_t index,
	uint32_t feature, uint16_t property,
	struct tcs_fault *fault) TCS_CHECKED;

/* The same for an instance: the nearest level will do. */
uint16_t place_find_instance(
	const struct schema_class *class, uint64_t taken, unsigned lod);

/* ---- citygml_plan_view.c -------------------------------------------------- */

/* Features that are the footprint or the roof edge of what holds them, where
 * that has properties for these: they are not written. */
void plan_view_mark(struct composer *composer);

/* Put a footprint or a roof edge where the other version has it; *placed:
 * whether it was one. */
enum tcs_status plan_view_place(struct composer *composer, uint32_t index,
	bool *placed, struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_shelter.c ---------------------------------------------------- */

/* The class that takes what no other does. */
unsigned shelter_class(const struct composer *composer);

/*
 * A node for no feature of the stream, in a property of the parent, or a
 * member of the model for SCHEMA_NONE. Its number in *made.
 */
enum tcs_status shelter_add(struct composer *composer, uint32_t parent,
	uint16_t property, unsigned class, uint32_t *made,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Give a geometry, or an instance, that its feature has no place for a generic
 * feature of its own, below that one or beside it, and say so; or say that it
 * is left out. `crowded`: another level of detail has its place.
 */
enum tcs_status shelter_geometry(struct composer *composer, uint32_t index,
	uint32_t owner, bool crowded, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status shelter_instance(struct composer *composer, uint32_t index,
	uint32_t owner, struct tcs_fault *fault) TCS_CHECKED;

/* A surface of the owner for a geometry, at level 0. */
enum tcs_status shelter_surface(struct composer *composer, uint32_t index,
	uint32_t owner, unsigned class, struct tcs_fault *fault) TCS_CHECKED;

/* Ids for all of them. */
void shelters_name(struct composer *composer);

/* What was taken out of its parent says so. */
enum tcs_status shelter_say_part_of(struct composer *composer, uint32_t feature,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_pieces.c ---------------------------------------------------- */

/* One for each polygon, at home nowhere yet. */
enum tcs_status pieces_clear(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* Once they are at home: those that repeat an earlier polygon. */
enum tcs_status pieces_find_repetitions(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* Part of a triangulated surface; whether its ring is a triangle, and how many
 * it is written as. */
bool pieces_is_patch(const struct composer *composer, uint32_t polygon);
bool pieces_is_triangle(const struct composer *composer, uint32_t polygon);
uint32_t pieces_patch_count(const struct composer *composer, uint32_t polygon);

/* Once it is known what refers to them: faces, and ids. */
enum tcs_status pieces_name(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* Every polygon of a prototype at home in its first feature. */
enum tcs_status place_prototype(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* ---- citygml_value_tree.c ----------------------------------------------- */

/* Fill in first_member and next_member. */
enum tcs_status value_link_members(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* The member of a set called `name`; TCS_NONE for none. */
uint32_t value_member(
	const struct composer *composer, uint32_t set, const char *name);

/* The same in an external reference of 2.0 or 3.0. */
uint32_t value_deep_member(
	const struct composer *composer, uint32_t set, const char *name);

/* What an external reference is to, which it cannot be written without; NULL
 * for nothing. */
const char *value_external_target(
	const struct composer *composer, uint32_t set, bool *by_name);

/* A member of a group as 3.0 has it: its link, NULL for none, and its role. */
const char *value_role_target(
	const struct composer *composer, uint32_t set, const char **note);

/* The value of a height that measuredHeight may stand for; TCS_NONE. */
uint32_t value_measured(const struct composer *composer, uint32_t set);

/*
 * Roles of members that stand in their group: its attributes that say nothing
 * but a role, one for each such member, in their order. They become the nodes'
 * notes; where they are more or fewer, nobody knows whose they are. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status value_find_roles(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;
bool value_is_role(const struct composer *composer, uint32_t attribute);

/* A member that is an XML attribute; whether others are elements. */
bool value_is_xml_attribute(const struct composer *composer, uint32_t member);
bool value_has_elements(const struct composer *composer, uint32_t set);

/* ---- citygml_values.c, citygml_spelling.c ------------------------------------------------------ */

/*
 * Attributes of all features as items: in their standard place, converted if
 * the versions differ, or generic.
 */
enum tcs_status values_place(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;
void value_write(struct composer *composer, const struct item *item);

/* The value as this content spells it; NULL where it cannot. */
const char *value_as(struct composer *composer,
	const struct tcs_attribute *attribute, unsigned content);

/* A date as a year, or a time as a date, that says more than that. */
bool value_is_shortened(const struct composer *composer,
	const struct tcs_attribute *attribute, unsigned content);

/* ---- citygml_generic.c --------------------------------------------------- */

void generic_write(struct composer *composer, uint32_t attribute);
/* A generic attribute of no attribute: a string. */
void generic_write_string(
	struct composer *composer, const char *name, const char *value);

/* ---- citygml_address.c --------------------------------------------------- */

void address_write(struct composer *composer, const struct item *item);
/* Whether the other version of xAL has no place for parts of it. */
bool address_is_shortened(const struct composer *composer, uint32_t attribute);
/* Elements below a structured value, as the attribute tree has them. */
void members_write(struct composer *composer, uint32_t set, const char *module);

/* ---- citygml_shapes.c ---------------------------------------------------- */

/* A run of items of one geometry property. */
void shapes_write(
	struct composer *composer, const struct item *items, size_t count);
void address_points_write(struct composer *composer, uint32_t address);
void prototype_write(struct composer *composer);
void instance_write(struct composer *composer, const struct item *item);

/* ---- citygml_surface_data.c ---------------------------------------------- */

struct gml_material gml_material_at(struct composer *composer, uint32_t index);
struct gml_image gml_image_at(struct composer *composer, uint32_t index);

/* ---- citygml_paint_order.c, citygml_paints.c ----------------------------- */

/* Once the surfaces are clear: those that a material paints in part. */
enum tcs_status paints_find_parts(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* Where a geometry may be of any kind, such a surface becomes polygons, which
 * have ids. */
enum tcs_status paints_break_surface(struct composer *composer, uint32_t index,
	struct tcs_fault *fault) TCS_CHECKED;

/* Which polygons, rings and surfaces need ids for being painted. */
enum tcs_status paints_prepare(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* The polygon that stands in the text for a painted one; TCS_NONE for none. */
uint32_t paint_polygon(
	const struct composer *composer, const struct tcs_paint *paint);

/* Local to the object; those of a prototype into out->appearance. */
void appearances_write(struct composer *composer);
void prototype_appearances_write(struct composer *composer);

/* ---- citygml_merge.c ----------------------------------------------------- */

/* Join the triangles of polygons without rings to faces of their pieces. */
enum tcs_status merge_polygons(
	struct composer *composer, struct tcs_fault *fault) TCS_CHECKED;

/* The coordinate in a texture of a vertex of a face that `paint` paints. */
struct tcs_texcoord merged_texcoord(const struct composer *composer,
	const struct tcs_paint *paint, uint32_t vertex);

#endif
