/* Polygons taken out of an object, and all that goes with them. */
#include "simplify/object_filter.h"

#include <string.h>

#include "check.h"
#include "tcs_codec.h"

enum { BUILDING, WALL, ROOF, ROOM, LAMP, SIGN, FEATURES };

static const char *const ids[FEATURES] = {
	"building", "wall", "roof", "room", "lamp", "sign"};

static const uint32_t parents[FEATURES] = {
	TCS_NONE, BUILDING, BUILDING, BUILDING, ROOM, BUILDING};

#define ROOM_FOR(array) ((array)->at + (array)->count++)

static tcs_text
text(struct tcs_object *object, const char *string)
{
	struct tcs_fault fault;
	tcs_text out = 0;

	CHECK(!text_append(object, string, strlen(string), &out, &fault));
	return out;
}

/* A triangle; its vertices have its number as their height. */
static void
polygon_add(struct tcs_object *object, uint32_t surface)
{
	uint32_t number = (uint32_t)object->polygons.count;
	uint32_t first = (uint32_t)object->vertices.count;

	CHECK(!array_grow(&object->polygons, 1) &&
		!array_grow(&object->rings, 1) &&
		!array_grow(&object->triangles, 1) &&
		!array_grow(&object->vertices, 3));
	*ROOM_FOR(&object->polygons) = (struct tcs_polygon){.surface = surface,
		.first_vertex = first,
		.vertex_count = 3,
		.first_ring = (uint32_t)object->rings.count,
		.ring_count = 1,
		.first_triangle = (uint32_t)object->triangles.count,
		.triangle_count = 1};
	*ROOM_FOR(&object->rings) =
		(struct tcs_ring){.first_vertex = first, .vertex_count = 3};
	*ROOM_FOR(&object->triangles) =
		(struct tcs_triangle){{first, first + 1, first + 2}};
	for (int i = 0; i < 3; i++)
		*ROOM_FOR(&object->vertices) =
			(struct tcs_point){i == 1, i == 2, number};
}

static void
geometry_add(struct tcs_object *object, uint32_t feature, uint8_t kind,
	uint32_t first, uint32_t count)
{
	CHECK(!array_grow(&object->geometries, 1));
	*ROOM_FOR(&object->geometries) =
		(struct tcs_geometry){.feature = feature,
			.first_shell = (uint32_t)object->shells.count,
			.first_polygon = first,
			.polygon_count = count,
			.kind = kind,
			.lod = 3};
}

/* A shell of the last geometry. */
static void
shell_add(struct tcs_object *object, uint32_t first, uint32_t count,
	uint32_t solid)
{
	CHECK(!array_grow(&object->shells, 1));
	*ROOM_FOR(&object->shells) = (struct tcs_shell){
		.first_polygon = first, .polygon_count = count, .solid = solid};
	object->geometries.at[object->geometries.count - 1].shell_count++;
}

static void
attribute_add(struct tcs_object *object, uint32_t feature, const char *name,
	uint32_t parent, uint16_t type)
{
	CHECK(!array_grow(&object->attributes, 1));
	*ROOM_FOR(&object->attributes) =
		(struct tcs_attribute){.feature = feature,
			.parent = parent,
			.name = text(object, name),
			.type = type};
}

static void
relation_add(struct tcs_object *object, uint32_t feature, const char *target)
{
	CHECK(!array_grow(&object->relations, 1));
	*ROOM_FOR(&object->relations) = (struct tcs_relation){
		.feature = feature, .target = text(object, target)};
}

/* A paint with a texture, whose coordinates have the polygon's number. */
static void
paint_add(struct tcs_object *object, uint32_t polygon)
{
	CHECK(!array_grow(&object->paints, 1) &&
		!array_grow(&object->texcoords, 3));
	*ROOM_FOR(&object->paints) = (struct tcs_paint){.polygon = polygon,
		.material = TCS_NONE,
		.image = 0,
		.first_texcoord = (uint32_t)object->texcoords.count};
	for (int i = 0; i < 3; i++)
		*ROOM_FOR(&object->texcoords) =
			(struct tcs_texcoord){polygon, i};
}

/*
 * Polygons 0 and 1 of the wall, 2 and 3 of the roof, as a solid; 4 and 5 of a
 * lamp, as a surface. The sign never had any.
 */
static void
sample_build(struct tcs_object *object)
{
	*object = (struct tcs_object){.text = {.count = 0}};
	for (uint32_t i = 0; i < FEATURES; i++) {
		CHECK(!array_grow(&object->features, 1));
		*ROOM_FOR(&object->features) = (struct tcs_feature){
			.id = text(object, ids[i]), .parent = parents[i]};
	}
	attribute_add(object, WALL, "colour", TCS_NONE, TCS_STRING);
	attribute_add(object, ROOF, "tiles", TCS_NONE, TCS_SET);
	attribute_add(object, ROOF, "colour", 1, TCS_STRING);
	attribute_add(object, SIGN, "reads", TCS_NONE, TCS_STRING);
	relation_add(object, BUILDING, "lamp");
	relation_add(object, LAMP, "building");
	relation_add(object, BUILDING, "elsewhere");
	for (uint32_t i = 0; i < 4; i++)
		polygon_add(object, i < 2 ? WALL : ROOF);
	geometry_add(object, BUILDING, TCS_SOLID, 0, 4);
	shell_add(object, 0, 4, 0);
	polygon_add(object, LAMP);
	polygon_add(object, LAMP);
	geometry_add(object, LAMP, TCS_COMPOSITE_SURFACE, 4, 2);
	paint_add(object, 1);
	paint_add(object, 3);
	paint_add(object, 5);
}

/* What is left is sound, and every polygon has what it had before. */
static void
sample_check(const struct tcs_object *object)
{
	struct tcs_fault fault;
	size_t painted = 0;

	CHECK(!object_check(object, &fault));
	for (size_t i = 0; i < object->polygons.count; i++) {
		const struct tcs_polygon *polygon = object->polygons.at + i;
		const struct tcs_point *first =
			object->vertices.at + polygon->first_vertex;
		const uint32_t *corner =
			object->triangles.at[polygon->first_triangle].corner;

		CHECK(first[0].z == first[2].z && first[1].x == 1);
		CHECK(object->vertices.at[corner[2]].z == first->z);
		CHECK(object->rings.at[polygon->first_ring].first_vertex ==
			polygon->first_vertex);
	}
	for (size_t i = 0; i < object->paints.count; i++, painted += 3) {
		const struct tcs_paint *paint = object->paints.at + i;
		const struct tcs_polygon *polygon =
			object->polygons.at + paint->polygon;

		CHECK(paint->first_texcoord == painted);
		CHECK(object->texcoords.at[painted].s ==
			object->vertices.at[polygon->first_vertex].z);
	}
	CHECK(object->texcoords.count == painted);
}

static void
sample_keep(struct tcs_object *object, const bool *keep)
{
	struct tcs_fault fault;

	CHECK(!object_keep_polygons(object, keep, &fault));
	sample_check(object);
}

static bool
has_feature(const struct tcs_object *object, const char *id)
{
	for (size_t i = 0; i < object->features.count; i++)
		if (!strcmp(object_text(object, object->features.at[i].id), id))
			return true;
	return false;
}

static void
all_kept_changes_nothing(void)
{
	const bool keep[6] = {true, true, true, true, true, true};
	struct tcs_record before = {0}, after = {0};
	struct tcs_object object;
	struct tcs_fault fault;

	sample_build(&object);
	CHECK(!object_encode(&object, TCS_OBJECT, &before, &fault));
	sample_keep(&object, keep);
	CHECK(!object_encode(&object, TCS_OBJECT, &after, &fault));
	CHECK(before.bytes.count == after.bytes.count &&
		!memcmp(before.bytes.at, after.bytes.at, before.bytes.count));
	record_release(&before);
	record_release(&after);
	object_release(&object);
}

static void
a_solid_without_some_polygons_is_a_surface(void)
{
	const bool keep[6] = {true, true, false, true, true, true};
	struct tcs_object object;

	sample_build(&object);
	sample_keep(&object, keep);
	CHECK(object.geometries.count == 2 && object.polygons.count == 5);
	CHECK(object.geometries.at[0].kind == TCS_MULTI_SURFACE);
	CHECK(object.geometries.at[0].polygon_count == 3);
	CHECK(object.geometries.at[0].shell_count == 0);
	CHECK(object.shells.count == 0);
	CHECK(object.geometries.at[1].first_polygon == 3);
	CHECK(object.geometries.at[1].kind == TCS_COMPOSITE_SURFACE);
	CHECK(object.features.count == FEATURES);
	CHECK(object.paints.count == 3 && object.paints.at[1].polygon == 2);
	object_release(&object);
}

static void
features_with_nothing_left_go_with_what_is_theirs(void)
{
	const bool keep[6] = {true, true, false, false, false, false};
	struct tcs_object object;

	sample_build(&object);
	sample_keep(&object, keep);
	CHECK(object.features.count == 3);
	CHECK(has_feature(&object, "wall") && !has_feature(&object, "roof"));
	CHECK(!has_feature(&object, "room") && !has_feature(&object, "lamp"));
	/* Never had any geometry: stays. */
	CHECK(has_feature(&object, "sign"));
	CHECK(object.geometries.count == 1 && object.paints.count == 1);
	CHECK(object.attributes.count == 2);
	CHECK(object.attributes.at[1].feature == 2);
	CHECK(object.relations.count == 1);
	CHECK(!strcmp(object_text(&object, object.relations.at[0].target),
		"elsewhere"));
	object_release(&object);
}

static void
members_of_sets_keep_their_sets(void)
{
	const bool keep[6] = {false, false, true, true, false, true};
	struct tcs_object object;

	sample_build(&object);
	sample_keep(&object, keep);
	CHECK(!has_feature(&object, "wall") && has_feature(&object, "lamp"));
	CHECK(object.attributes.count == 3);
	CHECK(object.attributes.at[0].type == TCS_SET);
	CHECK(object.attributes.at[1].parent == 0);
	CHECK(object.attributes.at[0].feature == 1);
	CHECK(object.relations.count == 3);
	CHECK(object.geometries.at[1].kind == TCS_MULTI_SURFACE);
	object_release(&object);
}

static void
of_many_solids_those_that_are_whole_stay_solids(void)
{
	const bool one[4] = {false, false, true, true};
	const bool some[4] = {true, true, true, false};
	struct tcs_object object;

	for (int i = 0; i < 2; i++) {
		sample_build(&object);
		object.geometries.count = object.shells.count = 0;
		object.polygons.count = object.rings.count = 4;
		object.triangles.count = 4;
		object.vertices.count = 12;
		object.paints.count = 2;
		object.texcoords.count = 6;
		geometry_add(&object, BUILDING, TCS_COMPOSITE_SOLID, 0, 4);
		shell_add(&object, 0, 2, 0);
		shell_add(&object, 2, 2, 1);
		sample_keep(&object, i ? some : one);
		CHECK(object.geometries.at[0].kind ==
			(i ? TCS_MULTI_SURFACE : TCS_MULTI_SOLID));
		CHECK(object.geometries.at[0].shell_count == (i ? 0 : 1));
		CHECK(object.shells.count == (i ? 0 : 1));
		if (!i)
			CHECK(object.shells.at[0].solid == 0 &&
				object.shells.at[0].first_polygon == 0);
		object_release(&object);
	}
}

static void
the_object_itself_stays_when_nothing_is_left(void)
{
	const bool keep[6] = {false};
	struct tcs_object object;

	sample_build(&object);
	sample_keep(&object, keep);
	CHECK(object.features.count == 2 && object.polygons.count == 0);
	CHECK(object.geometries.count == 0 && object.vertices.count == 0);
	object_release(&object);
}

static void
instances_count_as_geometry(void)
{
	const bool keep[6] = {true, true, true, true, false, false};
	struct tcs_object object;

	sample_build(&object);
	CHECK(!array_grow(&object.instances, 1));
	*ROOM_FOR(&object.instances) = (struct tcs_instance){
		.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
		.feature = LAMP};
	sample_keep(&object, keep);
	CHECK(has_feature(&object, "room") && has_feature(&object, "lamp"));
	CHECK(object.instances.count == 1);
	CHECK(object.instances.at[0].feature == LAMP);
	object_release(&object);
}

static const struct check_test tests[] = {
	CHECK_TEST(all_kept_changes_nothing),
	CHECK_TEST(a_solid_without_some_polygons_is_a_surface),
	CHECK_TEST(features_with_nothing_left_go_with_what_is_theirs),
	CHECK_TEST(members_of_sets_keep_their_sets),
	CHECK_TEST(of_many_solids_those_that_are_whole_stay_solids),
	CHECK_TEST(the_object_itself_stays_when_nothing_is_left),
	CHECK_TEST(instances_count_as_geometry),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
