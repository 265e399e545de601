#include "check.h"
#include "lib/byte_index.h"
#include "lib/lod_select.h"
#include "town_sample.h"
#include "writers/gltf_name.h"

static struct tcs_fault fault;
static struct tcs_object object;
static struct selection selection;

static void
feature(uint32_t parent, uint16_t class)
{
	SAMPLE_PUSH(object.features,
		(struct tcs_feature){.parent = parent, .class = class});
}

/* A geometry of one triangle, or of none. */
static void
geometry(uint32_t owner, uint8_t lod, uint8_t kind, uint32_t triangles)
{
	SAMPLE_PUSH(object.geometries,
		(struct tcs_geometry){.feature = owner,
			.lod = lod,
			.kind = kind,
			.first_polygon = (uint32_t)object.polygons.count,
			.polygon_count = 1});
	SAMPLE_PUSH(object.polygons,
		(struct tcs_polygon){.triangle_count = triangles});
}

/* Building 0 with wall 1, its door 2, and installation 3. */
static void
start(void)
{
	object_clear(&object);
	feature(TCS_NONE, TCS_CLASS_Building);
	feature(0, TCS_CLASS_WallSurface);
	feature(1, TCS_CLASS_Door);
	feature(0, TCS_CLASS_BuildingInstallation);
}

static bool
drawn(size_t number)
{
	return selection.geometries.at[number];
}

static void
surfaces_share_the_level_of_their_host(void)
{
	start();
	geometry(0, 1, TCS_SOLID, 1);
	geometry(1, 2, TCS_MULTI_SURFACE, 1);
	geometry(1, 3, TCS_MULTI_SURFACE, 1);
	geometry(2, 3, TCS_MULTI_SURFACE, 1);
	geometry(3, 2, TCS_MULTI_SURFACE, 1);
	CHECK(!selection_make(&selection, &object, SELECT_HIGHEST, &fault));
	CHECK(!drawn(0) && !drawn(1) && drawn(2) && drawn(3) && drawn(4));
}

static void
curves_and_empty_geometries_do_not_win(void)
{
	start();
	geometry(0, 2, TCS_SOLID, 1);
	geometry(0, 4, TCS_MULTI_CURVE, 0);
	geometry(0, 3, TCS_MULTI_SURFACE, 0);
	CHECK(!selection_make(&selection, &object, SELECT_HIGHEST, &fault));
	CHECK(drawn(0) && !drawn(1) && !drawn(2));
	CHECK(!selection_make(&selection, &object, SELECT_ALL, &fault));
	CHECK(drawn(0) && !drawn(1) && drawn(2));
}

static void
no_level_is_drawn_only_where_nothing_else_is(void)
{
	start();
	geometry(0, TCS_LOD_NONE, TCS_SOLID, 1);
	geometry(3, 0, TCS_SOLID, 1);
	geometry(3, TCS_LOD_NONE, TCS_SOLID, 1);
	CHECK(!selection_make(&selection, &object, SELECT_HIGHEST, &fault));
	CHECK(drawn(0) && drawn(1) && !drawn(2));
}

/* Building 0 with parts 1 and 2, the wall 3 of part 1, and installation 4. */
static void
a_building_is_not_drawn_over_its_better_parts(void)
{
	object_clear(&object);
	feature(TCS_NONE, TCS_CLASS_Building);
	feature(0, TCS_CLASS_BuildingPart);
	feature(0, TCS_CLASS_BuildingPart);
	feature(1, TCS_CLASS_WallSurface);
	feature(0, TCS_CLASS_BuildingInstallation);
	geometry(0, 1, TCS_SOLID, 1);
	geometry(3, 2, TCS_MULTI_SURFACE, 1);
	geometry(2, 1, TCS_SOLID, 1);
	geometry(4, 3, TCS_MULTI_SURFACE, 1);
	CHECK(!selection_make(&selection, &object, SELECT_HIGHEST, &fault));
	CHECK(!drawn(0) && drawn(1) && drawn(2) && drawn(3));
	geometry(0, 2, TCS_SOLID, 1);
	CHECK(!selection_make(&selection, &object, SELECT_HIGHEST, &fault));
	CHECK(!drawn(0) && drawn(1) && drawn(2) && drawn(3) && drawn(4));
	CHECK(!selection_make(&selection, &object, 1, &fault));
	CHECK(drawn(0) && !drawn(1) && drawn(2));
}

static void
a_level_that_is_asked_for_is_the_only_one(void)
{
	start();
	geometry(0, 1, TCS_SOLID, 1);
	geometry(0, 2, TCS_SOLID, 1);
	CHECK(!selection_make(&selection, &object, 1, &fault));
	CHECK(drawn(0) && !drawn(1));
	selection_release(&selection);
	object_release(&object);
}

static void
an_index_numbers_strings_by_first_appearance(void)
{
	struct byte_index index = {.heap = {NULL, 0, 0}};
	uint32_t number;
	bool added;
	char text[32];

	for (unsigned round = 0; round < 2; round++)
		for (unsigned i = 0; i < 1000; i++) {
			size_t length = (size_t)snprintf(
				text, sizeof text, "%u", i * 7919);

			CHECK(!byte_index_add(
				&index, text, length, &number, &added, &fault));
			CHECK(number == i && added == !round);
		}
	CHECK(byte_index_find(&index, "7919", 4) == 1);
	CHECK(byte_index_find(&index, "791", 3) == INDEX_NONE);
	CHECK(byte_index_find(&index, "", 0) == INDEX_NONE);
	CHECK(!byte_index_add(&index, "", 0, &number, &added, &fault) && added);
	CHECK(byte_index_find(&index, "", 0) == 1000);
	byte_index_clear(&index);
	CHECK(byte_index_find(&index, "7919", 4) == INDEX_NONE);
	byte_index_release(&index);
}

static void
the_bin_stands_beside_the_gltf(void)
{
	static const char *const names[][3] = {
		{"a/town.gltf", "a/town.bin", "town.bin"},
		{"Town.GLTF", "Town.bin", "Town.bin"},
		{"town", "town.bin", "town.bin"},
		{"./old town%.gltf", "./old town%.bin", "old%20town%25.bin"},
	};

	for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
		char *bin = name_of_bin(names[i][0]), *uri = name_as_uri(bin);

		CHECK(!strcmp(bin, names[i][1]));
		CHECK(!strcmp(uri, names[i][2]));
		free(bin);
		free(uri);
	}
	CHECK(!name_is_gltf(".gltf") && !name_is_gltf("a.glb"));
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(surfaces_share_the_level_of_their_host),
		CHECK_TEST(curves_and_empty_geometries_do_not_win),
		CHECK_TEST(no_level_is_drawn_only_where_nothing_else_is),
		CHECK_TEST(a_building_is_not_drawn_over_its_better_parts),
		CHECK_TEST(a_level_that_is_asked_for_is_the_only_one),
		CHECK_TEST(an_index_numbers_strings_by_first_appearance),
		CHECK_TEST(the_bin_stands_beside_the_gltf),
		{0},
	};

	return check_run(tests);
}
