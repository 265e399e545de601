/* Where geometries, polygons, instances and relations go. */
#include <stdlib.h>
#include <string.h>

#include "citygml_compose.h"
#include "labels.h"

#define LOD_LOST 254
#define NO_FIT 255

/* How far around a surface a place for its polygons is looked for. */
enum { MAX_CLIMB = 16 };

enum tcs_status
item_add(struct composer *composer, uint32_t feature, uint16_t property,
	enum item_kind kind, uint32_t index, struct tcs_fault *fault)
{
	if (array_grow(&composer->items, 1))
		return fault_memory(fault);
	composer->items.at[composer->items.count] = (struct item){
		.feature = feature,
		.index = index,
		.order = (uint32_t)composer->items.count,
		.property = property,
		.kind = (uint8_t)kind,
	};
	composer->items.count++;
	return TCS_OK;
}

/* ---- levels of detail ------------------------------------------------------ */

static unsigned
levels_of(const struct schema_class *class)
{
	unsigned levels = 0;

	for (uint16_t i = 0; i < class->count; i++) {
		const struct property *property = &class->properties[i];

		if (property->lod != SCHEMA_LOD_NONE &&
			content_is_geometry(property->content) &&
			property->content != CONTENT_MULTICURVE &&
			property->content != CONTENT_COMPLEX &&
			property->content != CONTENT_POINT)
			levels |= 1u << property->lod;
	}
	return levels;
}

/* The level nearest to one that the class has; upwards first. */
static unsigned
nearest_level(unsigned levels, unsigned lod)
{
	for (unsigned up = lod; up <= 4; up++)
		if (levels & 1u << up)
			return up;
	while (lod-- > 0)
		if (levels & 1u << lod)
			return lod;
	return LOD_LOST;
}

/* Two levels that would become one: the higher one stays. */
static void
map_levels(struct node *node, unsigned used)
{
	unsigned levels = levels_of(node->class), taken = 0;

	for (unsigned lod = 5; lod-- > 0;) {
		unsigned to = levels ? nearest_level(levels, lod) : lod;

		if (!(used & 1u << lod))
			to = lod;
		else if (to == LOD_LOST || (taken & 1u << to))
			to = LOD_LOST;
		else
			taken |= 1u << to;
		node->lods[lod] = (uint8_t)to;
	}
}

static enum tcs_status
map_all_levels(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	size_t count = composer->nodes.count;

	array_clear(&composer->stack);
	if (array_grow(&composer->stack, count))
		return fault_memory(fault);
	memset(composer->stack.at, 0, count * sizeof *composer->stack.at);
	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];
		uint32_t feature = compose_written(composer, geometry->feature);

		if (geometry->lod <= 4)
			composer->stack.at[composer->nodes.at[feature].host] |=
				1u << geometry->lod;
	}
	for (size_t i = 0; i < count; i++)
		if (!composer->nodes.at[i].melted)
			map_levels(
				&composer->nodes.at[i], composer->stack.at[i]);
	return TCS_OK;
}

static unsigned
level_at(const struct composer *composer, uint32_t feature, unsigned lod)
{
	uint32_t host = composer->nodes.at[feature].host;

	return lod <= 4 ? composer->nodes.at[host].lods[lod] : TCS_LOD_NONE;
}

/* ---- geometries -------------------------------------------------------------- */

static uint32_t
solid_count(const struct composer *composer, const struct tcs_geometry *of)
{
	uint32_t last = of->first_shell + of->shell_count - 1;

	return of->shell_count ? composer->object.shells.at[last].solid + 1 : 0;
}

/* How well a property takes a geometry: 0 is best. */
static unsigned
fit(const struct composer *composer, unsigned content,
	const struct tcs_geometry *geometry)
{
	/* per kind: contents from the best; 0 ends them */
	static const unsigned char best[][5] = {
		[TCS_SOLID] = {CONTENT_SOLID, CONTENT_GEOMETRY,
			CONTENT_MULTISOLID, CONTENT_MULTISURFACE,
			CONTENT_SURFACE},
		[TCS_COMPOSITE_SOLID] = {CONTENT_SOLID, CONTENT_GEOMETRY,
			CONTENT_MULTISOLID, CONTENT_MULTISURFACE,
			CONTENT_SURFACE},
		[TCS_MULTI_SOLID] = {CONTENT_MULTISOLID, CONTENT_GEOMETRY,
			CONTENT_SOLID, CONTENT_MULTISURFACE, CONTENT_SURFACE},
		[TCS_MULTI_SURFACE] = {CONTENT_MULTISURFACE, CONTENT_SURFACE,
			CONTENT_GEOMETRY, CONTENT_POLYGON, CONTENT_TIN},
		[TCS_COMPOSITE_SURFACE] = {CONTENT_SURFACE,
			CONTENT_MULTISURFACE, CONTENT_GEOMETRY, CONTENT_POLYGON,
			CONTENT_TIN},
		[TCS_TIN] = {CONTENT_TIN, CONTENT_GEOMETRY,
			CONTENT_MULTISURFACE, CONTENT_SURFACE},
		[TCS_MULTI_CURVE] = {CONTENT_MULTICURVE, CONTENT_COMPLEX,
			CONTENT_GEOMETRY},
		[TCS_MULTI_POINT] = {CONTENT_MULTIPOINT, CONTENT_GEOMETRY,
			CONTENT_POINT},
	};

	if (!content_is_geometry(content))
		return NO_FIT;
	if ((content == CONTENT_POLYGON || content == CONTENT_POINT) &&
		geometry->polygon_count != 1)
		return NO_FIT;
	if (content == CONTENT_SOLID && geometry->kind == TCS_MULTI_SOLID &&
		solid_count(composer, geometry) != 1)
		return NO_FIT;
	for (unsigned i = 0; i < 5; i++)
		if (best[geometry->kind][i] == content)
			return i;
	return NO_FIT;
}

static bool
is_terrain(const char *name)
{
	return strstr(name, "Terrain") != NULL;
}

uint16_t
place_find(const struct composer *composer, const struct schema_class *class,
	uint64_t taken, const struct tcs_geometry *geometry, unsigned lod)
{
	const char *role = compose_text(composer, geometry->role);
	unsigned least = NO_FIT;
	uint16_t found = SCHEMA_NONE;

	for (uint16_t i = 0; i < class->count; i++) {
		const struct property *property = &class->properties[i];
		bool named = !strcmp(property->name, role);
		unsigned how = fit(composer, property->content, geometry);

		if (how == NO_FIT || (!property->many && (taken >> i & 1)))
			continue;
		if (named &&
			(property->lod == lod ||
				property->lod == SCHEMA_LOD_NONE))
			return i;
		if (property->lod != lod &&
			!(property->lod == SCHEMA_LOD_NONE &&
				(property->content == CONTENT_TIN ||
					property->content == CONTENT_GEOMETRY)))
			continue;
		if (is_terrain(role) == is_terrain(property->name) &&
			how < least) {
			least = how;
			found = i;
		}
	}
	return found;
}

/* Where a surface has its polygons of a level; SCHEMA_NONE for nowhere. */
static uint16_t
find_surface_property(
	const struct composer *composer, uint32_t feature, unsigned lod)
{
	const struct schema_class *class = composer->nodes.at[feature].class;
	uint16_t found = SCHEMA_NONE;

	for (uint16_t i = 0; i < class->count; i++) {
		const struct property *property = &class->properties[i];

		if (property->lod != lod)
			continue;
		if (property->content == CONTENT_MULTISURFACE)
			return i;
		if (property->content == CONTENT_SURFACE ||
			property->content == CONTENT_GEOMETRY)
			found = i;
	}
	return found;
}

/*
 * The polygon goes to its surface, or the nearest one around it that has
 * geometry of this level, up to the owner of the geometry.
 */
static enum tcs_status
place_polygon(struct composer *composer, uint32_t polygon, uint32_t owner,
	unsigned lod, bool flat, struct tcs_fault *fault)
{
	const uint32_t given = compose_written(
		composer, composer->object.polygons.at[polygon].surface);
	struct piece *piece = &composer->pieces.at[polygon];
	uint32_t surface = given;

	piece->home = owner;
	for (unsigned i = 0; i < MAX_CLIMB && !flat && surface != owner; i++) {
		const struct node *node = &composer->nodes.at[surface];
		uint16_t property =
			find_surface_property(composer, surface, lod);

		if (property != SCHEMA_NONE) {
			piece->home = surface;
			piece->is_target = true;
			return item_add(composer, surface, property,
				ITEM_POLYGON, polygon, fault);
		}
		if (node->property == SCHEMA_NONE)
			break;
		surface = node->parent;
	}
	if (flat || given == owner)
		return TCS_OK;
	return compose_note(composer, REPORT_NOTE,
		label_of(composer->nodes.at[given].number)->name,
		"no place for its polygons at their level: those of its host",
		composer->nodes.at[given].id, fault);
}

/* Where it is written as no solid, though it is one. */
static enum tcs_status
note_solid(struct composer *composer, const struct tcs_geometry *geometry,
	unsigned content, struct tcs_fault *fault)
{
	if (!geometry->shell_count ||
		(content != CONTENT_MULTISURFACE && content != CONTENT_SURFACE))
		return TCS_OK;
	return compose_note(composer, REPORT_NOTE, "solid",
		"there is no place for solids of its kind: written as surfaces",
		compose_text(composer, geometry->id), fault);
}

static bool
is_surfaces(unsigned kind)
{
	return kind == TCS_MULTI_SURFACE || kind == TCS_COMPOSITE_SURFACE ||
		kind == TCS_TIN;
}

enum tcs_status
place_geometry_beside(struct composer *composer, uint32_t index,
	uint32_t feature, uint16_t property, struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; i < geometry->polygon_count && !status; i++) {
		uint32_t polygon = geometry->first_polygon + i;

		composer->pieces.at[polygon].home = feature;
		status = item_add(composer, feature, property, ITEM_POLYGON,
			polygon, fault);
	}
	return status;
}

/* Points of an address go to the first one of the feature without. */
static bool
place_address(struct composer *composer, uint32_t index)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	const struct tcs_attribute *attributes = composer->object.attributes.at;
	size_t low = 0, high = composer->addresses.count;

	if (geometry->kind != TCS_MULTI_POINT ||
		strcmp(compose_text(composer, geometry->role), "multiPoint"))
		return false;
	/* those of earlier features, and those that have points, come first */
	while (low < high) {
		size_t middle = low + (high - low) / 2;
		const struct address *at = &composer->addresses.at[middle];
		uint32_t feature = attributes[at->attribute].feature;

		if (feature < geometry->feature ||
			(feature == geometry->feature &&
				at->points != TCS_NONE))
			low = middle + 1;
		else
			high = middle;
	}
	if (low == composer->addresses.count ||
		attributes[composer->addresses.at[low].attribute].feature !=
			geometry->feature)
		return false;
	composer->addresses.at[low].points = index;
	for (uint32_t i = 0; i < geometry->polygon_count; i++)
		composer->pieces.at[geometry->first_polygon + i].home =
			geometry->feature;
	return true;
}

enum tcs_status
place_geometry_at(struct composer *composer, uint32_t index, uint32_t feature,
	uint16_t property, unsigned lod, struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	bool flat = geometry->kind == TCS_MULTI_CURVE ||
		geometry->kind == TCS_MULTI_POINT || lod > 4 ||
		(lod < 2 && (geometry->flags & TCS_GEOMETRY_SIMPLIFIED)) ||
		feature >= composer->object.features.count;
	struct node *node = &composer->nodes.at[feature];
	enum tcs_status status = TCS_OK;

	node->taken |= (uint64_t)1 << property;
	if (node->class->properties[property].content != CONTENT_TIN)
		status = paints_break_surface(composer, index, fault);
	if (!status)
		status = note_solid(composer, geometry,
			node->class->properties[property].content, fault);
	if (!status)
		status = item_add(composer, feature, property, ITEM_GEOMETRY,
			index, fault);
	for (uint32_t i = 0; i < geometry->polygon_count && !status; i++) {
		composer->owners.at[geometry->first_polygon + i] = index;
		status = place_polygon(composer, geometry->first_polygon + i,
			feature, lod, flat, fault);
	}
	return status;
}

static enum tcs_status
place_geometry(
	struct composer *composer, uint32_t index, struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	uint32_t owner = compose_written(composer, geometry->feature);
	unsigned lod = level_at(composer, owner, geometry->lod);
	const struct node *node = &composer->nodes.at[owner];
	uint16_t property;
	bool placed;
	enum tcs_status status;

	if (place_address(composer, index))
		return TCS_OK;
	status = plan_view_place(composer, index, &placed, fault);
	if (status || placed)
		return status;
	if (lod == LOD_LOST)
		return shelter_geometry(composer, index, owner, true, fault);
	property =
		place_find(composer, node->class, node->taken, geometry, lod);
	if (property != SCHEMA_NONE)
		return place_geometry_at(
			composer, index, owner, property, lod, fault);
	if (is_surfaces(geometry->kind)) {
		property = place_find(composer, node->class, 0, geometry, lod);
		if (property != SCHEMA_NONE)
			return place_geometry_beside(
				composer, index, owner, property, fault);
	}
	return shelter_geometry(composer, index, owner, false, fault);
}

/* ---- the rest ------------------------------------------------------------------ */

uint16_t
place_find_instance(
	const struct schema_class *class, uint64_t taken, unsigned lod)
{
	unsigned least = 16;
	uint16_t found = SCHEMA_NONE;

	for (uint16_t i = 0; i < class->count; i++) {
		const struct property *property = &class->properties[i];
		unsigned apart = property->lod > lod ? property->lod - lod
						     : lod - property->lod;

		if (property->content == CONTENT_IMPLICIT &&
			!(taken >> i & 1) && apart < least) {
			least = apart;
			found = i;
		}
	}
	return found;
}

static enum tcs_status
place_instance(
	struct composer *composer, uint32_t index, struct tcs_fault *fault)
{
	const struct tcs_instance *instance =
		&composer->object.instances.at[index];
	uint32_t feature = compose_written(composer, instance->feature);
	struct node *node = &composer->nodes.at[feature];
	unsigned lod = level_at(composer, feature, instance->lod);
	uint16_t found = place_find_instance(node->class, node->taken, lod);

	if (found == SCHEMA_NONE)
		return shelter_instance(composer, index, feature, fault);
	node->taken |= (uint64_t)1 << found;
	if (node->class->properties[found].lod != lod) {
		enum tcs_status status = compose_note(composer, REPORT_NOTE,
			"implicit geometry",
			"its level has no place: written at another one",
			compose_text(composer, instance->id), fault);

		if (status)
			return status;
	}
	return item_add(composer, feature, found, ITEM_INSTANCE, index, fault);
}

static bool
may_link(const struct property *property)
{
	switch (property->content) {
	case CONTENT_FEATURE:
	case CONTENT_MEMBER:
	case CONTENT_ROLE:
	case CONTENT_LINK:
	case CONTENT_ADDRESS:
		return true;
	default:
		return false;
	}
}

static enum tcs_status
place_relation(
	struct composer *composer, uint32_t index, struct tcs_fault *fault)
{
	const struct tcs_relation *relation =
		&composer->object.relations.at[index];
	uint32_t feature = compose_written(composer, relation->feature);
	const struct schema_class *class = composer->nodes.at[feature].class;
	const char *role = compose_text(composer, relation->role);
	uint16_t property = schema_find(class, role);

	if (property != SCHEMA_NONE && may_link(&class->properties[property]))
		return item_add(composer, feature, property, ITEM_RELATION,
			index, fault);
	property = schema_find_content(class, CONTENT_GENERIC);
	if (property == SCHEMA_NONE)
		return compose_note(composer, REPORT_SKIPPED, "link",
			"this version has no place for it", role, fault);
	return item_add(
		composer, feature, property, ITEM_RELATION, index, fault);
}

static int
compare_items(const void *left, const void *right)
{
	const struct item *a = left, *b = right;

	if (a->feature != b->feature)
		return a->feature < b->feature ? -1 : 1;
	if (a->property != b->property)
		return a->property < b->property ? -1 : 1;
	return a->order < b->order ? -1 : a->order > b->order;
}

static void
sort_items(struct composer *composer)
{
	uint32_t count = (uint32_t)composer->items.count, at = 0;

	if (count)
		qsort(composer->items.at, count, sizeof *composer->items.at,
			compare_items);
	for (uint32_t i = 0; i < composer->nodes.count; i++) {
		composer->nodes.at[i].first_item = at;
		while (at < count && composer->items.at[at].feature == i)
			at++;
		composer->nodes.at[i].item_end = at;
	}
}

/* What the schema insists on and nothing has brought. */
static enum tcs_status
place_required(
	struct composer *composer, uint32_t feature, struct tcs_fault *fault)
{
	const struct node *node = &composer->nodes.at[feature];
	enum tcs_status status = TCS_OK;

	for (uint16_t i = 0; i < node->class->count && !status; i++) {
		bool has = false;

		if (!node->class->properties[i].required)
			continue;
		for (uint32_t j = node->first_item; j < node->item_end; j++)
			has |= composer->items.at[j].property == i;
		if (!has)
			status = item_add(composer, feature, i, ITEM_REQUIRED,
				feature, fault);
	}
	return status;
}

enum tcs_status
place_items(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	enum tcs_status status = map_all_levels(composer, fault);

	if (!status)
		status = pieces_clear(composer, fault);
	if (!status)
		status = paints_find_parts(composer, fault);
	if (!status)
		status = values_place(composer, fault);
	for (uint32_t i = 0; i < object->geometries.count && !status; i++)
		status = place_geometry(composer, i, fault);
	for (uint32_t i = 0; i < object->instances.count && !status; i++)
		status = place_instance(composer, i, fault);
	for (uint32_t i = 0; i < object->relations.count && !status; i++)
		status = place_relation(composer, i, fault);
	if (!status)
		status = pieces_find_repetitions(composer, fault);
	if (!status)
		status = paints_prepare(composer, fault);
	if (!status)
		status = pieces_name(composer, fault);
	if (status)
		return status;
	shelters_name(composer);
	sort_items(composer);
	for (uint32_t i = 0; i < composer->nodes.count && !status; i++)
		if (!composer->nodes.at[i].melted)
			status = place_required(composer, i, fault);
	sort_items(composer);
	return status;
}
