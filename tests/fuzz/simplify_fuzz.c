/*
 * Triangles of any corners on a small grid, so that they coincide, fold, cross
 * and share edges by the dozen, in a few features: whatever they are, they are
 * simplified, and what comes out is a sound object that is no larger.
 *
 * Three bytes are a triangle: six bits for each corner, the rest its feature.
 */
#include <stdint.h>
#include <stdlib.h>

#include "labels.h"
#include "simplify/object_simplifier.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { FEATURES = 8, MAX_TRIANGLES = 400 };

static void
require(bool so)
{
	if (!so)
		abort();
}

static void
add_features(struct tcs_object *object)
{
	static const uint16_t classes[FEATURES] = {TCS_CLASS_Building,
		TCS_CLASS_WallSurface, TCS_CLASS_Window, TCS_CLASS_RoofSurface,
		TCS_CLASS_BuildingInstallation, TCS_CLASS_BuildingInstallation,
		TCS_CLASS_BuildingPart, TCS_CLASS_WallSurface};
	static const uint32_t parents[FEATURES] = {
		TCS_NONE, 0, 1, 0, 0, 0, 0, 6};

	require(!array_grow(&object->features, FEATURES));
	for (int i = 0; i < FEATURES; i++)
		object->features.at[object->features.count++] =
			(struct tcs_feature){
				.class = classes[i], .parent = parents[i]};
}

static void
add_triangle(struct tcs_object *object, uint32_t bits, uint32_t feature)
{
	struct tcs_polygon polygon = {.surface = feature,
		.first_vertex = (uint32_t)object->vertices.count,
		.vertex_count = 3,
		.first_triangle = (uint32_t)object->triangles.count,
		.triangle_count = 1};
	uint32_t first = polygon.first_vertex;

	require(!array_grow(&object->polygons, 1) &&
		!array_grow(&object->vertices, 3) &&
		!array_grow(&object->triangles, 1));
	object->polygons.at[object->polygons.count++] = polygon;
	for (int k = 0; k < 3; k++, bits >>= 6)
		object->vertices.at[object->vertices.count++] =
			(struct tcs_point){
				bits & 3, bits >> 2 & 3, bits >> 4 & 3};
	object->triangles.at[object->triangles.count++] =
		(struct tcs_triangle){{first, first + 1, first + 2}};
}

/* One geometry per feature, of the triangles that say so. */
static void
make_object(struct tcs_object *object, const uint8_t *data, size_t size)
{
	size_t count = size / 3 < MAX_TRIANGLES ? size / 3 : MAX_TRIANGLES;

	require(!array_grow(&object->text, 1) &&
		!array_grow(&object->geometries, FEATURES));
	object->text.at[object->text.count++] = '\0';
	add_features(object);
	for (uint32_t feature = 0; feature < FEATURES; feature++) {
		struct tcs_geometry geometry = {.feature = feature,
			.first_polygon = (uint32_t)object->polygons.count,
			.lod = 3,
			.kind = TCS_MULTI_SURFACE};

		for (size_t i = 0; i < count; i++) {
			uint32_t bits = data[3 * i] |
				(uint32_t)data[3 * i + 1] << 8 |
				(uint32_t)data[3 * i + 2] << 16;

			if ((bits >> 18) % FEATURES == feature)
				add_triangle(object, bits, feature);
		}
		geometry.polygon_count = (uint32_t)object->polygons.count -
			geometry.first_polygon;
		object->geometries.at[object->geometries.count++] = geometry;
	}
}

static void
simplify(const struct tcs_object *object, bool in_place,
	enum placement placement, double max_error)
{
	struct simplify_settings settings = {
		.levels = {{{BUDGET_RATE, 0.4}, in_place ? LOD_IN_PLACE : 2},
			{{BUDGET_RATE, 0.9}, 1}},
		.level_count = in_place ? 1 : 2,
		.source = SELECT_HIGHEST,
		.base_ratio = 2,
		.placement = placement,
		.max_error = max_error,
		.crs = {.metres_per_unit = 1, .metres_per_unit_up = 1}};
	struct object_simplifier simplifier = {0};
	struct report report = {0};
	const struct tcs_object *out;
	struct tcs_fault fault;

	require(!simplify_object(
		&simplifier, &settings, object, &out, &report, &fault));
	require(!object_check(out, &fault));
	if (in_place)
		require(out->triangles.count <= object->triangles.count);
	report_release(&report);
	object_simplifier_release(&simplifier);
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct tcs_object object = {0};
	struct tcs_fault fault;

	make_object(&object, data, size);
	require(!object_check(&object, &fault));
	simplify(&object, true, PLACE_HALF_EDGE, 0);
	simplify(&object, false, PLACE_OPTIMAL, 0);
	simplify(&object, true, PLACE_OPTIMAL, 0.7);
	object_release(&object);
	return 0;
}
