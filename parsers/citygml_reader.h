/*
 * The CityGML reader: XML events in, raw objects out.
 *
 * A stack holds one frame per open element. A frame's role says what the
 * element is to the reader; the parent's role and the child's name decide the
 * child's role. The files beside this one share the state:
 *
 *     citygml_reader.c      the stack, coordinate systems and bounds
 *     citygml_model.c       the model and its members
 *     citygml_features.c    features and their properties
 *     citygml_attributes.c  what becomes of the text of properties
 *     citygml_geometry.c    GML geometry
 *     citygml_implicit.c    templates and where they are placed
 *     citygml_mesh.c        templates that are files of their own
 *     citygml_appearance.c  themes, materials and textures
 *     citygml_palette_add.c  what these are
 *     citygml_textured.c    those that stand in a surface, as was the custom
 *     citygml_mapping.c     where textures lie on surfaces
 *     citygml_georeference.c  where georeferenced ones do
 *
 * Nothing recurses: depth costs one frame, up to a limit.
 */
#ifndef TESSERA_CITYGML_READER_H
#define TESSERA_CITYGML_READER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "citygml_keys.h"
#include "citygml_names.h"
#include "citygml_palette.h"
#include "citygml_raw.h"
#include "citygml_store.h"
#include "citygml_xml.h"
#include "folder.h"
#include "srs.h"

enum frame_role {
	ROLE_DOCUMENT, /* below the stack: only a root may come */
	ROLE_MODEL,
	ROLE_MODEL_TEXT, /* its name or description */
	ROLE_MEMBER,
	ROLE_FEATURE,
	ROLE_PROPERTY, /* of a feature: text, a feature, a geometry, … */
	ROLE_ATTRIBUTE, /* an element below a property that is neither */
	ROLE_GENERIC, /* a generic attribute or set */
	ROLE_GENERIC_PART, /* its name or value */
	ROLE_BOUNDS, /* gml:boundedBy and below */
	ROLE_GEOMETRY, /* see geometry_child */
	ROLE_IMPLICIT, /* an ImplicitGeometry and below, see implicit_child */
	ROLE_APPEARANCE, /* see appearance_child */
};

struct frame {
	struct name *name;
	enum frame_role role;
	bool wants_text;
	bool has_children;
	bool reversed; /* geometry: below orientation="-" */
	bool interior; /* geometry: the shell or ring bounds a void or hole */
	bool is_shell; /* geometry: holds the surfaces of a solid */
	bool paints; /* geometry: what a TexturedSurface shows … */
	bool back; /* … on its back */
	uint8_t dimension; /* geometry: srsDimension in force; 0: none */
	uint32_t attribute; /* of the object; TCS_NONE: not made yet */
	uint32_t feature; /* the innermost feature */
	tcs_text id; /* gml:id in the object's text */
	tcs_text unit, code_space; /* of a property, until it is made */
	uint32_t first_member; /* geometry: the members below start here */
	uint32_t polygon; /* geometry: being read; TCS_NONE */
	uint32_t shell; /* geometry: in force; TCS_NONE */
};

/* A coordinate system that the file names. */
struct gml_srs {
	char *name; /* owned */
	struct srs srs;
	const char *assumed; /* about its axis order */
	bool decided; /* north_first is known */
	bool north_first;
};

TCS_ARRAY_TYPE(srs_list, struct gml_srs);

/* Text of one element that others need; NUL-terminated once kept. */
TCS_ARRAY_TYPE(kept_text, char);

/* What a texture says, until it is complete. */
struct texture_text {
	struct kept_text uri;
	struct kept_text mime;
	struct kept_text type;
	struct kept_text wrap;
	struct kept_text border;
};

/* Where a georeferenced texture says that its image lies. */
struct georeference {
	double orientation[4]; /* row by row, as written */
	double anchor[2]; /* as written */
	bool has_orientation, has_anchor;
	bool north_first; /* the anchor */
};

struct gml_options {
	struct xml_limits xml;
	uint64_t max_feature; /* bytes of a top-level feature, give or take the
	                         pieces that are fed; 0: any */
	const char *folder; /* of the document's other files; NULL: none */
	uint64_t max_library; /* bytes of one that is read as a template */
	bool drop_extensions; /* what is of no namespace of CityGML's or GML's
	                         below the model is not read */
};

enum gml_pass {
	PASS_APPEARANCES, /* only global appearances are read */
	PASS_OBJECTS,
};

struct gml_reader {
	struct names names;
	struct gml_options options;
	struct xml_handler handler;
	struct xml_parser *xml;
	enum gml_pass pass;
	TCS_ARRAY(struct frame) frames;
	TCS_ARRAY(char) text; /* of the innermost element */

	bool skip; /* the element that begins is not read, nor any below */
	bool is_helper; /* reads single members: see citygml_members.h */
	bool out_of_turn; /* what a helper met cannot be read by it */

	struct raw_object *raw; /* being filled; NULL between objects */
	struct raw_object *ready, **ready_end; /* complete ones, in order */
	struct raw_object *spare;
	uint64_t objects; /* top-level features begun */
	uint64_t serial; /* counts what this reader has begun */
	uint64_t object_bytes; /* fed since the one being read began */
	uint64_t head_end; /* behind the start tag of the model; 0: unknown */
	struct xml_stretch member; /* the start tag of the one being read */

	/* the model; what it says of itself behind its first member comes too
	   late for the head of the stream */
	struct kept_text model_id, model_name, model_description;
	struct srs_list systems;
	uint32_t model_srs; /* index; TCS_NONE */
	uint32_t first_srs; /* of the first geometry that names one */
	double corner[2][3]; /* of the model's envelope */
	bool has_corner[2];
	struct report report; /* what belongs to no object */

	/* the object */
	uint32_t object_srs; /* of its own envelope; TCS_NONE */
	uint32_t geometry_srs; /* of the geometry being read; TCS_NONE */
	uint32_t solids; /* of the geometry being read */
	uint32_t pos_ring; /* geometry: the ring that takes positions */

	/* templates, numbered as they come; by id, by file, or else by place */
	struct key_table templates;
	struct key_table meshes; /* files that are no templates … */
	TCS_ARRAY(const char *) mesh_problems; /* … and why */

	/* appearance */
	struct kept_text theme;
	struct kept_text source; /* gml:id of the surface data being read */
	struct tcs_material material; /* being read */
	struct texture_text texture; /* being read */
	struct georeference georeference; /* being read */
	uint32_t next_texring; /* being read: rings before it have names */
	bool back; /* the surface data paints backs */
	uint32_t first_paint; /* its targets start here */
	struct folder folder;
	struct palette_numbers numbers;
	struct paint_store store; /* global appearances */
};

/* Zero is valid for gml_release. Fails with TCS_NO_MEMORY. */
enum tcs_status gml_begin(struct gml_reader *reader,
	const struct gml_options *options, struct tcs_fault *fault) TCS_CHECKED;
void gml_release(struct gml_reader *reader);

/* Start a pass over the document from its first byte. */
enum tcs_status gml_start_pass(struct gml_reader *reader, enum gml_pass pass,
	struct tcs_fault *fault) TCS_CHECKED;

/* The next bytes of the document; length 0 ends it. */
enum tcs_status gml_feed(struct gml_reader *reader, const char *bytes,
	size_t length, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The bytes fed from now on stand here in the document, and the features in
 * them count from this number.
 */
void gml_move(
	struct gml_reader *reader, uint64_t at, uint64_t line, uint64_t number);

/* The next complete object, or NULL; give it back with gml_recycle. */
struct raw_object *gml_take(struct gml_reader *reader);
void gml_recycle(struct gml_reader *reader, struct raw_object *raw);

/* ---- shared by the files of the reader ------------------------------- */

/* An empty object to fill; complete, it joins the ready ones. */
enum tcs_status gml_open_object(
	struct gml_reader *reader, struct tcs_fault *fault) TCS_CHECKED;
void gml_close_object(struct gml_reader *reader);

struct frame *gml_top(struct gml_reader *reader);

/* A frame of this role on top of the stack; the parent may have moved. */
enum tcs_status gml_push(struct gml_reader *reader, struct name *name,
	enum frame_role role, struct frame **out,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * For what depends on more than the member and the head of the document: a
 * helper reads no more of the member; false for any other reader.
 */
bool gml_out_of_turn(struct gml_reader *reader);

/* Do not read the element that begins, nor anything below it. */
enum tcs_status gml_skip(struct gml_reader *reader);

/* The text of the innermost element without white space around it. */
void gml_trimmed(
	const struct gml_reader *reader, const char **at, size_t *length);

/* Append to the text of the object. */
enum tcs_status gml_text(struct gml_reader *reader, const char *bytes,
	size_t length, tcs_text *out, struct tcs_fault *fault) TCS_CHECKED;

/* The place of a local name in the text of the object, once per object. */
enum tcs_status gml_name_text(struct gml_reader *reader, struct name *name,
	tcs_text *out, struct tcs_fault *fault) TCS_CHECKED;

/* The attribute of this name; NULL for none. Most elements have no attribute. */
static inline const struct xml_attribute *
attribute_find(
	const struct xml_attribute *attributes, size_t count, const char *local)
{
	for (size_t i = 0; i < count; i++)
		if (*attributes[i].local == *local &&
			!strcmp(attributes[i].local, local))
			return &attributes[i];
	return NULL;
}

/* gml:id, in any spelling met in files. */
static inline const struct xml_attribute *
attribute_find_id(const struct xml_attribute *attributes, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (!strcmp(attributes[i].local, "id") ||
			!strcmp(attributes[i].local, "gml_id"))
			return &attributes[i];
	return NULL;
}

/* The number of a coordinate system; read once per spelling. */
enum tcs_status gml_srs(struct gml_reader *reader, const char *name,
	size_t length, uint32_t *out, struct tcs_fault *fault) TCS_CHECKED;

/* Whether a system comes north first, given its first position as text. */
bool gml_north_first(struct gml_reader *reader, uint32_t system,
	const char *position, size_t length);

/* The system in force for a position of the object: the given one, else the
 * object's, else the model's; TCS_NONE for none. */
uint32_t gml_system(const struct gml_reader *reader, uint32_t given);

enum tcs_status gml_skipped(struct gml_reader *reader, const char *item,
	const char *reason, const char *id,
	struct tcs_fault *fault) TCS_CHECKED;

/* Elements below the document, the model and its members. */
enum tcs_status document_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status model_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status member_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* A name or a description of the model is complete. */
enum tcs_status model_text_end(struct gml_reader *reader,
	const struct frame *frame, struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status feature_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status feature_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status feature_end(struct gml_reader *reader, struct frame *frame,
	struct tcs_fault *fault) TCS_CHECKED;

/* Whether an attribute can come of the element: a property or below one. */
bool attribute_may_come_of(const struct frame *frame);

/* uom and codeSpace wait in the frame for the attribute. */
enum tcs_status attribute_take_unit(struct gml_reader *reader,
	struct frame *frame, const struct xml_attribute *attributes,
	size_t count, struct tcs_fault *fault) TCS_CHECKED;

/* The gml:id of an element that is no feature becomes a member "@id". */
enum tcs_status attribute_add_id(struct gml_reader *reader, size_t index,
	struct tcs_fault *fault) TCS_CHECKED;

/* XML attributes that say more become members "@name" of the top frame's. */
enum tcs_status attribute_add_members(struct gml_reader *reader,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* The element of the frame with this index was a leaf: its text is a value. */
enum tcs_status attribute_finish(struct gml_reader *reader, size_t index,
	struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status generic_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status generic_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status generic_part_end(struct gml_reader *reader,
	const struct frame *frame, struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status geometry_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status geometry_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status geometry_text(struct gml_reader *reader, const char *bytes,
	size_t length, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status geometry_end(struct gml_reader *reader, struct frame *frame,
	struct tcs_fault *fault) TCS_CHECKED;

/* Whether an element of this name begins a geometry. */
bool geometry_is(const struct name *name);

/* A geometry property that only links: <lod2MultiSurface xlink:href="…"/>. */
enum tcs_status geometry_link(struct gml_reader *reader, struct frame *property,
	const struct xml_attribute *href, struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status implicit_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status implicit_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status implicit_end(struct gml_reader *reader, struct frame *frame,
	struct tcs_fault *fault) TCS_CHECKED;

/* A geometry of the object is the template of this key. */
enum tcs_status template_add(struct gml_reader *reader, const char *key,
	uint32_t geometry, struct raw_instance *instance,
	struct tcs_fault *fault) TCS_CHECKED;

/* The text of a libraryObject is the template of this instance. */
enum tcs_status mesh_take(struct gml_reader *reader,
	struct raw_instance *instance, struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status appearance_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status appearance_end(struct gml_reader *reader, struct frame *frame,
	struct tcs_fault *fault) TCS_CHECKED;

/* The appearance of a TexturedSurface, on top of the stack, and an element in
 * it: a material or a texture. */
enum tcs_status textured_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status textured_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* The texture that ends is one of these: its coordinates go to the rings. */
enum tcs_status textured_end(
	struct gml_reader *reader, struct tcs_fault *fault) TCS_CHECKED;

/* The members of the object from this one on are a target of paints, with an
 * id that cannot be one of the document's. */
enum tcs_status members_name(struct gml_reader *reader, uint32_t first,
	tcs_text *id, struct tcs_fault *fault) TCS_CHECKED;

/* Keep the trimmed text of the innermost element, or these bytes. */
enum tcs_status gml_keep(struct gml_reader *reader, struct kept_text *to,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status text_keep(struct kept_text *to, const char *bytes,
	size_t length, struct tcs_fault *fault) TCS_CHECKED;

/* What a material is where nothing is said of it (CityGML 2.0 9.2). */
struct tcs_material material_plain(void);

/* What is being read joins the palette of the object; its number there. */
enum tcs_status material_add(struct gml_reader *reader, uint32_t *out,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status image_add(struct gml_reader *reader, uint32_t *out,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * The last target of the surface data being read; NULL before the first. How
 * the texture lies on it is read next.
 */
struct raw_paint *paint_last(struct gml_reader *reader);

/* It lies on its last target as on another one. */
enum tcs_status mapping_link(struct gml_reader *reader,
	const struct xml_attribute *href, struct tcs_fault *fault) TCS_CHECKED;

/* Elements that say how a texture lies on its target, begun and ended. */
enum tcs_status mapping_child(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status mapping_end(struct gml_reader *reader,
	const struct frame *frame, struct tcs_fault *fault) TCS_CHECKED;

/* The same of elements that say where an image lies in the world. */
enum tcs_status georeference_child(struct gml_reader *reader,
	struct frame *frame, const struct xml_attribute *attributes,
	size_t count, struct tcs_fault *fault) TCS_CHECKED;
void georeference_end(struct gml_reader *reader, const struct frame *frame);

/*
 * Give all targets of the georeferenced texture its mapping. Without one they
 * are dropped, and the texture is reported.
 */
enum tcs_status georeference_apply(
	struct gml_reader *reader, struct tcs_fault *fault) TCS_CHECKED;

void appearance_release(struct gml_reader *reader);

#endif
