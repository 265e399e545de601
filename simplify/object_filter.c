#include "object_filter.h"

#include <stdlib.h>
#include <string.h>

#include "byte_index.h"

struct filtering {
	struct tcs_object *object;
	const bool *keep; /* per polygon */
	uint32_t *polygons; /* the new number of each, TCS_NONE for none */
	uint32_t *features; /* the same */
	bool *had, *has; /* per feature: geometry, before and after */
	uint32_t vertices, rings, triangles, texcoords, shells; /* kept */
};

/* ---- what there was ------------------------------------------------------ */

static bool
polygon_is_kept(const struct filtering *filtering, uint32_t polygon)
{
	return filtering->keep[polygon];
}

static void
note_features(struct filtering *filtering)
{
	const struct tcs_object *object = filtering->object;

	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];
		bool any = !geometry->polygon_count;

		for (uint32_t k = 0; k < geometry->polygon_count; k++) {
			uint32_t polygon = geometry->first_polygon + k;
			uint32_t surface = object->polygons.at[polygon].surface;

			filtering->had[surface] = true;
			filtering->has[surface] |=
				polygon_is_kept(filtering, polygon);
			any |= polygon_is_kept(filtering, polygon);
		}
		filtering->had[geometry->feature] = true;
		filtering->has[geometry->feature] |= any;
	}
	for (size_t i = 0; i < object->instances.count; i++) {
		filtering->had[object->instances.at[i].feature] = true;
		filtering->has[object->instances.at[i].feature] = true;
	}
	for (size_t i = object->features.count; i-- > 1;) {
		uint32_t parent = object->features.at[i].parent;

		filtering->had[parent] |= filtering->had[i];
		filtering->has[parent] |= filtering->has[i];
	}
}

/* ---- runs ---------------------------------------------------------------- */

static void
polygon_move(struct filtering *filtering, uint32_t from, uint32_t to)
{
	struct tcs_object *object = filtering->object;
	struct tcs_polygon polygon = object->polygons.at[from];
	uint32_t back = polygon.first_vertex - filtering->vertices;

	memmove(object->vertices.at + filtering->vertices,
		object->vertices.at + polygon.first_vertex,
		polygon.vertex_count * sizeof *object->vertices.at);
	for (uint32_t i = 0; i < polygon.ring_count; i++) {
		struct tcs_ring *ring = &object->rings.at[filtering->rings + i];

		*ring = object->rings.at[polygon.first_ring + i];
		ring->first_vertex -= back;
	}
	for (uint32_t i = 0; i < polygon.triangle_count; i++) {
		struct tcs_triangle *triangle =
			&object->triangles.at[filtering->triangles + i];

		*triangle = object->triangles.at[polygon.first_triangle + i];
		for (int k = 0; k < 3; k++)
			triangle->corner[k] -= back;
	}
	polygon.first_vertex = filtering->vertices;
	polygon.first_ring = filtering->rings;
	polygon.first_triangle = filtering->triangles;
	filtering->vertices += polygon.vertex_count;
	filtering->rings += polygon.ring_count;
	filtering->triangles += polygon.triangle_count;
	object->polygons.at[to] = polygon;
}

static void
paints_keep(struct filtering *filtering, const uint32_t *vertex_counts)
{
	struct tcs_object *object = filtering->object;
	size_t kept = 0;

	for (size_t i = 0; i < object->paints.count; i++) {
		struct tcs_paint paint = object->paints.at[i];
		uint32_t count = vertex_counts[paint.polygon];

		if (!polygon_is_kept(filtering, paint.polygon))
			continue;
		paint.polygon = filtering->polygons[paint.polygon];
		if (paint.first_texcoord != TCS_NONE) {
			memmove(object->texcoords.at + filtering->texcoords,
				object->texcoords.at + paint.first_texcoord,
				count * sizeof *object->texcoords.at);
			paint.first_texcoord = filtering->texcoords;
			filtering->texcoords += count;
		}
		object->paints.at[kept++] = paint;
	}
	object->paints.count = kept;
	object->texcoords.count = filtering->texcoords;
}

/* Whether all or none of the polygons of each solid are kept. */
static bool
solids_are_whole(
	const struct filtering *filtering, const struct tcs_geometry *geometry)
{
	const struct tcs_shell *shells =
		filtering->object->shells.at + geometry->first_shell;
	uint32_t first = TCS_NONE; /* polygon of the solid */

	for (uint32_t i = 0; i < geometry->shell_count; i++) {
		const struct tcs_shell *shell = shells + i;

		if (i && shell->solid != shells[i - 1].solid)
			first = TCS_NONE;
		for (uint32_t k = 0; k < shell->polygon_count; k++) {
			uint32_t polygon = shell->first_polygon + k;

			if (first == TCS_NONE)
				first = polygon;
			if (filtering->keep[polygon] != filtering->keep[first])
				return false;
		}
	}
	return true;
}

static void
shells_keep(struct filtering *filtering, const struct tcs_geometry *old,
	struct tcs_geometry *geometry)
{
	struct tcs_shell *shells = filtering->object->shells.at;
	uint32_t next = geometry->first_polygon, solids = 0;
	uint32_t last = TCS_NONE;

	for (uint32_t i = 0; i < old->shell_count; i++) {
		struct tcs_shell shell = shells[old->first_shell + i];

		if (!shell.polygon_count ||
			!polygon_is_kept(filtering, shell.first_polygon))
			continue;
		if (last != TCS_NONE && shell.solid != last)
			solids++;
		last = shell.solid;
		shell.solid = solids;
		shell.first_polygon = next;
		next += shell.polygon_count;
		shells[filtering->shells++] = shell;
		geometry->shell_count++;
	}
}

static uint8_t
kind_of_some(uint8_t kind)
{
	return kind == TCS_COMPOSITE_SURFACE  ? TCS_MULTI_SURFACE
		: kind == TCS_COMPOSITE_SOLID ? TCS_MULTI_SOLID
					      : kind;
}

static bool
is_solid(unsigned kind)
{
	return kind == TCS_SOLID || kind == TCS_MULTI_SOLID ||
		kind == TCS_COMPOSITE_SOLID;
}

/* The geometry without what goes of it; false when nothing is left. */
static bool
geometry_keep(struct filtering *filtering, struct tcs_geometry *geometry,
	uint32_t first_polygon)
{
	struct tcs_geometry old = *geometry;
	bool whole = solids_are_whole(filtering, &old);

	geometry->first_polygon = first_polygon;
	geometry->polygon_count = 0;
	for (uint32_t i = 0; i < old.polygon_count; i++) {
		uint32_t polygon = old.first_polygon + i;

		if (!polygon_is_kept(filtering, polygon))
			continue;
		filtering->polygons[polygon] =
			first_polygon + geometry->polygon_count++;
		polygon_move(filtering, polygon, filtering->polygons[polygon]);
	}
	geometry->first_shell = filtering->shells;
	geometry->shell_count = 0;
	if (old.polygon_count && !geometry->polygon_count)
		return false;
	if (geometry->polygon_count != old.polygon_count)
		geometry->kind = kind_of_some(geometry->kind);
	if (whole)
		shells_keep(filtering, &old, geometry);
	else if (is_solid(old.kind))
		geometry->kind = TCS_MULTI_SURFACE;
	return true;
}

static enum tcs_status
geometries_keep(struct filtering *filtering, struct tcs_fault *fault)
{
	struct tcs_object *object = filtering->object;
	uint32_t *counts = calloc(object->polygons.count + 1, sizeof *counts);
	uint32_t polygons = 0;
	size_t kept = 0;

	if (!counts)
		return fault_memory(fault);
	for (size_t i = 0; i < object->polygons.count; i++)
		counts[i] = object->polygons.at[i].vertex_count;
	for (size_t i = 0; i < object->geometries.count; i++) {
		struct tcs_geometry geometry = object->geometries.at[i];

		if (!geometry_keep(filtering, &geometry, polygons))
			continue;
		polygons += geometry.polygon_count;
		object->geometries.at[kept++] = geometry;
	}
	paints_keep(filtering, counts);
	object->geometries.count = kept;
	object->shells.count = filtering->shells;
	object->polygons.count = polygons;
	object->vertices.count = filtering->vertices;
	object->rings.count = filtering->rings;
	object->triangles.count = filtering->triangles;
	free(counts);
	return TCS_OK;
}

/* ---- features ------------------------------------------------------------ */

static enum tcs_status
features_keep(struct filtering *filtering, struct byte_index *gone,
	struct tcs_fault *fault)
{
	struct tcs_object *object = filtering->object;
	uint32_t kept = 0, number;
	bool added;

	for (uint32_t i = 0; i < object->features.count; i++) {
		struct tcs_feature feature = object->features.at[i];
		bool keeps = i == 0 ||
			((filtering->has[i] || !filtering->had[i]) &&
				filtering->features[feature.parent] !=
					TCS_NONE);
		const char *id = object_text(object, feature.id);

		filtering->features[i] = keeps ? kept : TCS_NONE;
		if (keeps) {
			if (i)
				feature.parent =
					filtering->features[feature.parent];
			object->features.at[kept++] = feature;
		} else if (*id &&
			byte_index_add(
				gone, id, strlen(id), &number, &added, fault)) {
			return TCS_NO_MEMORY;
		}
	}
	object->features.count = kept;
	return TCS_OK;
}

static enum tcs_status
attributes_keep(struct filtering *filtering, struct tcs_fault *fault)
{
	struct tcs_object *object = filtering->object;
	uint32_t *numbers =
		calloc(object->attributes.count + 1, sizeof *numbers);
	uint32_t kept = 0;

	if (!numbers)
		return fault_memory(fault);
	for (size_t i = 0; i < object->attributes.count; i++) {
		struct tcs_attribute attribute = object->attributes.at[i];

		attribute.feature = filtering->features[attribute.feature];
		if (attribute.feature == TCS_NONE)
			continue;
		if (attribute.parent != TCS_NONE)
			attribute.parent = numbers[attribute.parent];
		numbers[i] = kept;
		object->attributes.at[kept++] = attribute;
	}
	object->attributes.count = kept;
	free(numbers);
	return TCS_OK;
}

static void
relations_keep(struct filtering *filtering, const struct byte_index *gone)
{
	struct tcs_object *object = filtering->object;
	size_t kept = 0;

	for (size_t i = 0; i < object->relations.count; i++) {
		struct tcs_relation relation = object->relations.at[i];
		const char *target = object_text(object, relation.target);

		relation.feature = filtering->features[relation.feature];
		if (relation.feature != TCS_NONE &&
			byte_index_find(gone, target, strlen(target)) ==
				INDEX_NONE)
			object->relations.at[kept++] = relation;
	}
	object->relations.count = kept;
}

/* Give what is left the new numbers of the features. */
static void
features_renumber(struct filtering *filtering)
{
	struct tcs_object *object = filtering->object;

	for (size_t i = 0; i < object->geometries.count; i++) {
		uint32_t *feature = &object->geometries.at[i].feature;

		*feature = filtering->features[*feature];
	}
	for (size_t i = 0; i < object->polygons.count; i++) {
		uint32_t *feature = &object->polygons.at[i].surface;

		*feature = filtering->features[*feature];
	}
	for (size_t i = 0; i < object->instances.count; i++) {
		uint32_t *feature = &object->instances.at[i].feature;

		*feature = filtering->features[*feature];
	}
}

enum tcs_status
object_keep_polygons(
	struct tcs_object *object, const bool *keep, struct tcs_fault *fault)
{
	size_t features = object->features.count;
	size_t polygons = object->polygons.count;
	struct filtering filtering = {.object = object,
		.keep = keep,
		.polygons = calloc(polygons + 1, sizeof(uint32_t)),
		.features = calloc(features + 1, sizeof(uint32_t)),
		.had = calloc(features + 1, sizeof(bool)),
		.has = calloc(features + 1, sizeof(bool))};
	struct byte_index gone = {.slots.count = 0};
	enum tcs_status status = TCS_OK;

	if (!filtering.polygons || !filtering.features || !filtering.had ||
		!filtering.has)
		status = fault_memory(fault);
	if (!status) {
		note_features(&filtering);
		status = geometries_keep(&filtering, fault);
	}
	if (!status)
		status = features_keep(&filtering, &gone, fault);
	if (!status)
		status = attributes_keep(&filtering, fault);
	if (!status) {
		relations_keep(&filtering, &gone);
		features_renumber(&filtering);
	}
	byte_index_release(&gone);
	free(filtering.polygons);
	free(filtering.features);
	free(filtering.had);
	free(filtering.has);
	return status;
}
