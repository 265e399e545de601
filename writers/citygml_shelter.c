/*
 * Features that the stream does not have: generic ones for what has no place
 * elsewhere, and spaces around what bounds them.
 */
#include "citygml_compose.h"

unsigned
shelter_class(const struct composer *composer)
{
	return compose_is_3(composer) ? TCS_CLASS_GenericOccupiedSpace
				      : TCS_CLASS_GenericCityObject;
}

enum tcs_status
shelter_add(struct composer *composer, uint32_t parent, uint16_t property,
	unsigned class, uint32_t *made, struct tcs_fault *fault)
{
	struct node *node;

	if (array_grow(&composer->nodes, 1) || array_grow(&composer->roots, 1))
		return fault_memory(fault);
	*made = (uint32_t)composer->nodes.count++;
	node = &composer->nodes.at[*made];
	*node = (struct node){.class = &composer->plan->schema.classes[class],
		.parent = parent,
		.host = *made,
		.property = property,
		.lods = {0, 1, 2, 3, 4},
		.number = (uint16_t) class};
	node->module = node->class->module;
	if (property == SCHEMA_NONE) {
		composer->roots.at[composer->roots.count++] = *made;
		return TCS_OK;
	}
	return item_add(composer, parent, property, ITEM_CHILD, *made, fault);
}

/* What was taken out of its parent says so. */
enum tcs_status
shelter_say_part_of(
	struct composer *composer, uint32_t feature, struct tcs_fault *fault)
{
	struct node *node = &composer->nodes.at[feature];
	uint16_t generic;

	if (node->melted || node->parent == TCS_NONE ||
		node->property != SCHEMA_NONE)
		return TCS_OK;
	generic = schema_find_content(node->class, CONTENT_GENERIC);
	if (generic == SCHEMA_NONE)
		return TCS_OK;
	if (!composer->nodes.at[node->parent].id)
		composer->nodes.at[node->parent].id = compose_id(composer, "");
	return item_add(
		composer, feature, generic, ITEM_PART_OF, node->parent, fault);
}

/* GML 3.2 wants ids; what has one of its own is named before. */
void
shelters_name(struct composer *composer)
{
	if (!compose_is_3(composer))
		return;
	for (size_t i = composer->object.features.count;
		i < composer->nodes.count; i++)
		composer->nodes.at[i].id = compose_id(composer, "");
}

/* ---- geometry --------------------------------------------------------------- */

/* A feature that may take a geometry: a surface of the owner, or a feature of
 * the model. */
struct shelter {
	uint32_t owner;
	unsigned class;
	bool inside;
};

static bool
is_known(const struct composer *composer, const struct shelter *shelter)
{
	if (!composer->plan->schema.classes[shelter->class].module)
		return false;
	return !shelter->inside ||
		schema_find_child(composer->nodes.at[shelter->owner].class,
			shelter->class, "") != SCHEMA_NONE;
}

/* Its node in *made. */
static enum tcs_status
build(struct composer *composer, const struct shelter *shelter, uint32_t *made,
	struct tcs_fault *fault)
{
	const struct schema_class *owner =
		composer->nodes.at[shelter->owner].class;
	enum tcs_status status = shelter_add(composer, shelter->owner,
		shelter->inside ? schema_find_child(owner, shelter->class, "")
				: SCHEMA_NONE,
		shelter->class, made, fault);

	return status ? status : shelter_say_part_of(composer, *made, fault);
}

/* The property for it in such a feature, at the nearest level. */
static uint16_t
find_in(const struct composer *composer, const struct shelter *shelter,
	const struct tcs_geometry *geometry, unsigned *lod, unsigned apart)
{
	const struct schema_class *class =
		&composer->plan->schema.classes[shelter->class];
	unsigned from = geometry->lod > 4 ? 2 : geometry->lod;
	uint16_t property = SCHEMA_NONE;

	if (!is_known(composer, shelter))
		return SCHEMA_NONE;
	for (int down = 0; down < 2 && property == SCHEMA_NONE; down++) {
		if (down ? from < apart : from + apart > 4)
			continue;
		*lod = down ? from - apart : from + apart;
		property = place_find(composer, class, 0, geometry, *lod);
	}
	return property;
}

/* What a message says of a geometry: its id, or that of its feature. */
static const char *
geometry_name(
	const struct composer *composer, const struct tcs_geometry *geometry)
{
	return compose_text(composer,
		geometry->id
			? geometry->id
			: composer->object.features.at[geometry->feature].id);
}

static enum tcs_status
lose_geometry(struct composer *composer, const struct tcs_geometry *geometry,
	const char *reason, struct tcs_fault *fault)
{
	for (uint32_t i = 0; i < geometry->polygon_count; i++)
		composer->pieces.at[geometry->first_polygon + i].home =
			TCS_NONE;
	return compose_note(composer, REPORT_SKIPPED, "geometry", reason,
		geometry_name(composer, geometry), fault);
}

static enum tcs_status
move_geometry(struct composer *composer, uint32_t index,
	const struct shelter *shelter, uint16_t property, unsigned lod,
	bool crowded, struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	uint32_t made;
	enum tcs_status status = build(composer, shelter, &made, fault);

	if (!status)
		status = place_geometry_at(
			composer, index, made, property, lod, fault);
	if (status)
		return status;
	return compose_note(composer, REPORT_NOTE, "geometry",
		crowded ? "another level of detail has its place: in a generic "
			  "object"
			: "this version has no place for it: in a generic "
			  "object",
		geometry_name(composer, geometry), fault);
}

enum tcs_status
shelter_geometry(struct composer *composer, uint32_t index, uint32_t owner,
	bool crowded, struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	const struct shelter shelters[] = {
		{owner, TCS_CLASS_GenericThematicSurface, true},
		{owner, shelter_class(composer), false},
		{owner, TCS_CLASS_GenericThematicSurface, false}};

	for (unsigned apart = 0; apart <= 4; apart++) {
		for (size_t i = crowded; i < 3; i++) {
			unsigned lod;
			uint16_t property = find_in(
				composer, &shelters[i], geometry, &lod, apart);

			if (property != SCHEMA_NONE)
				return move_geometry(composer, index,
					&shelters[i], property, lod, crowded,
					fault);
		}
	}
	return lose_geometry(composer, geometry,
		crowded ? "another level of detail has its place"
			: "this version has no place for it",
		fault);
}

enum tcs_status
shelter_surface(struct composer *composer, uint32_t index, uint32_t owner,
	unsigned class, struct tcs_fault *fault)
{
	const struct shelter shelter = {owner, class, true};
	uint16_t property =
		place_find(composer, &composer->plan->schema.classes[class], 0,
			&composer->object.geometries.at[index], 0);
	enum tcs_status status;
	uint32_t made;

	status = build(composer, &shelter, &made, fault);
	return status
		? status
		: place_geometry_at(composer, index, made, property, 0, fault);
}

enum tcs_status
shelter_instance(struct composer *composer, uint32_t index, uint32_t owner,
	struct tcs_fault *fault)
{
	const struct tcs_instance *instance =
		&composer->object.instances.at[index];
	const struct shelter shelter = {owner, shelter_class(composer), false};
	uint16_t property = place_find_instance(
		&composer->plan->schema.classes[shelter.class], 0,
		instance->lod > 4 ? 2 : instance->lod);
	enum tcs_status status;
	uint32_t made;

	if (property == SCHEMA_NONE)
		return compose_note(composer, REPORT_SKIPPED,
			"implicit geometry", "this version has no place for it",
			compose_text(composer, instance->id), fault);
	status = build(composer, &shelter, &made, fault);
	if (!status)
		status = item_add(
			composer, made, property, ITEM_INSTANCE, index, fault);
	if (status)
		return status;
	return compose_note(composer, REPORT_NOTE, "implicit geometry",
		"this version has no place for it: in a generic object",
		compose_text(composer, instance->id), fault);
}
