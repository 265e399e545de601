/*
 * Footprints and roof edges. CityGML 2.0 has properties of the building for
 * them; in 3.0 a roof edge is a roof surface at level 0, and a footprint a
 * ground surface, or the geometry of the building itself at that level.
 */
#include <string.h>

#include "citygml_compose.h"
#include "labels.h"

static const char roof_edge[] = "lod0RoofEdge";
static const char footprint[] = "lod0FootPrint";

/* The property for what a surface of this class is at level 0; NULL for
 * nothing. */
static const char *
property_of(unsigned class)
{
	if (class == TCS_CLASS_RoofSurface)
		return roof_edge;
	return class == TCS_CLASS_GroundSurface ? footprint : NULL;
}

static bool
is_flat(const struct tcs_geometry *geometry)
{
	return geometry->lod == 0 &&
		(geometry->kind == TCS_MULTI_SURFACE ||
			geometry->kind == TCS_COMPOSITE_SURFACE);
}

/* ---- up to 2.0 ----------------------------------------------------------------- */

static void
mark_geometry(struct composer *composer, const struct tcs_geometry *geometry,
	bool flat)
{
	const struct tcs_object *object = &composer->object;

	if (is_flat(geometry) == flat &&
		property_of(object->features.at[geometry->feature].class))
		composer->nodes.at[geometry->feature].flat = flat;
	for (uint32_t i = 0; i < geometry->polygon_count && !flat; i++) {
		uint32_t surface =
			object->polygons.at[geometry->first_polygon + i]
				.surface;

		if (surface != geometry->feature)
			composer->nodes.at[surface].flat = false;
	}
}

void
plan_view_mark(struct composer *composer)
{
	const struct tcs_object *object = &composer->object;

	if (compose_is_3(composer))
		return;
	for (int pass = 0; pass < 2; pass++)
		for (size_t i = 0; i < object->geometries.count; i++)
			mark_geometry(
				composer, &object->geometries.at[i], pass == 0);
	for (size_t i = 0; i < object->instances.count; i++)
		composer->nodes.at[object->instances.at[i].feature].flat =
			false;
	for (size_t i = 1; i < object->features.count; i++)
		composer->nodes.at[object->features.at[i].parent].flat = false;
}

static enum tcs_status
place_as_property(struct composer *composer, uint32_t index, bool *placed,
	struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	uint32_t feature = geometry->feature;
	const char *name =
		property_of(composer->object.features.at[feature].class);
	uint32_t owner = compose_written(composer, feature);
	uint16_t property;

	owner = composer->nodes.at[owner].host;
	if (!name || owner == feature)
		return TCS_OK;
	property = schema_find(composer->nodes.at[owner].class, name);
	if (property == SCHEMA_NONE)
		return TCS_OK;
	*placed = true;
	if (composer->nodes.at[owner].taken >> property & 1)
		return place_geometry_beside(
			composer, index, owner, property, fault);
	return place_geometry_at(composer, index, owner, property, 0, fault);
}

/* ---- 3.0 ----------------------------------------------------------------------- */

static enum tcs_status
place_as_surface(struct composer *composer, uint32_t index, bool *placed,
	struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry =
		&composer->object.geometries.at[index];
	uint32_t owner = compose_written(composer, geometry->feature);
	enum tcs_status status;

	if (strcmp(compose_text(composer, geometry->role), roof_edge) != 0 ||
		schema_find_child(composer->nodes.at[owner].class,
			TCS_CLASS_RoofSurface, "") == SCHEMA_NONE)
		return TCS_OK;
	*placed = true;
	status = shelter_surface(
		composer, index, owner, TCS_CLASS_RoofSurface, fault);
	if (status)
		return status;
	return compose_note(composer, REPORT_NOTE, "roof edge",
		"a roof surface at level 0 in this version",
		composer->nodes.at[owner].id, fault);
}

enum tcs_status
plan_view_place(struct composer *composer, uint32_t index, bool *placed,
	struct tcs_fault *fault)
{
	*placed = false;
	if (!is_flat(&composer->object.geometries.at[index]))
		return TCS_OK;
	return compose_is_3(composer)
		? place_as_surface(composer, index, placed, fault)
		: place_as_property(composer, index, placed, fault);
}
