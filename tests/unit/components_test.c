#include "simplify/components.h"

#include <stdlib.h>

#include "check.h"
#include "simplify/weld.h"

enum { ROOM = 64 };

struct mesh {
	struct tcs_triangle triangles[ROOM];
	uint32_t features[ROOM], components[ROOM];
	size_t count;
};

static void
add(struct mesh *mesh, uint32_t feature, uint32_t a, uint32_t b, uint32_t c)
{
	mesh->triangles[mesh->count] = (struct tcs_triangle){{a, b, c}};
	mesh->features[mesh->count++] = feature;
}

static size_t
count_bodies(struct mesh *mesh, const uint32_t *bodies)
{
	struct edge_table table = {0};
	struct tcs_fault fault;
	size_t count = 0;

	CHECK(!edge_table_build(
		&table, mesh->triangles, mesh->count, ROOM, &fault));
	CHECK(!components_find(mesh->triangles, mesh->features, bodies,
		mesh->count, ROOM, &table, mesh->components, &count, &fault));
	edge_table_release(&table);
	return count;
}

static size_t
count_components(struct mesh *mesh)
{
	return count_bodies(mesh, mesh->features);
}

/* Number the points; how many are distinct. */
static size_t
weld_all(const struct tcs_point *points, size_t count, uint32_t *numbers)
{
	struct tcs_point *distinct = calloc(count, sizeof *distinct);
	struct weld weld = {0};
	struct tcs_fault fault;
	size_t found = 0;

	if (!distinct)
		abort();
	for (size_t i = 0; i < count; i++) {
		CHECK(!weld_find(&weld, distinct, found, &points[i],
			&numbers[i], &fault));
		if (numbers[i] == found)
			distinct[found++] = points[i];
	}
	weld_release(&weld);
	free(distinct);
	return found;
}

static void
equal_positions_are_one_point(void)
{
	const struct tcs_point points[] = {
		{1, 2, 3},
		{0, 0, 0},
		{1, 2, 3},
		{-0.0, 0, -0.0},
		{1, 2, 3.0000000000000004},
	};
	uint32_t numbers[5];

	CHECK(weld_all(points, 5, numbers) == 3);
	CHECK(numbers[0] == 0 && numbers[1] == 1 && numbers[2] == 0);
	CHECK(numbers[3] == 1 && numbers[4] == 2);
}

/* A grid, twice, in millimetres at city coordinates. */
static void
a_grid_welds_with_its_copy(void)
{
	enum { SIDE = 300, COUNT = SIDE * SIDE };
	struct tcs_point *points = calloc(2 * COUNT, sizeof *points);
	uint32_t *numbers = calloc(2 * COUNT, sizeof *numbers);
	size_t wrong = 0;

	if (!points || !numbers)
		abort();
	for (size_t i = 0; i < 2 * COUNT; i++)
		points[i] = (struct tcs_point){
			458000 + (double)(i % COUNT % SIDE) / 1000,
			5438000 + (double)(i % COUNT / SIDE) / 1000, 112};
	CHECK(weld_all(points, 2 * COUNT, numbers) == COUNT);
	for (size_t i = 0; i < 2 * COUNT; i++)
		wrong += numbers[i] != i % COUNT;
	CHECK(wrong == 0);
	free(points);
	free(numbers);
}

static void
a_shared_point_joins_inside_a_feature_only(void)
{
	struct mesh mesh = {0};

	add(&mesh, 1, 0, 1, 2);
	add(&mesh, 1, 2, 3, 4);
	add(&mesh, 2, 4, 5, 6);
	CHECK(count_components(&mesh) == 2);
	CHECK(mesh.components[0] == 0 && mesh.components[1] == 0);
	CHECK(mesh.components[2] == 1);
}

static void
a_feature_is_joined_over_another_at_a_point(void)
{
	struct mesh mesh = {0};

	add(&mesh, 1, 0, 1, 2);
	add(&mesh, 2, 2, 3, 4);
	add(&mesh, 1, 2, 5, 6);
	add(&mesh, 2, 2, 7, 8);
	CHECK(count_components(&mesh) == 2);
	CHECK(mesh.components[0] == 0 && mesh.components[1] == 1);
	CHECK(mesh.components[2] == 0 && mesh.components[3] == 1);
}

static void
an_edge_of_two_joins_across_features(void)
{
	struct mesh mesh = {0};

	add(&mesh, 1, 0, 1, 2);
	add(&mesh, 2, 2, 1, 3);
	CHECK(count_components(&mesh) == 1);
	/* A third and a fourth: two solids that touch along the edge. */
	add(&mesh, 3, 1, 2, 4);
	add(&mesh, 4, 2, 1, 5);
	CHECK(count_components(&mesh) == 4);
}

/* Two walls and a closure each, around one edge. */
static void
an_edge_of_two_joins_inside_a_body(void)
{
	const uint32_t bodies[] = {0, 1, 0, 1, 0};
	struct mesh mesh = {0};

	add(&mesh, 2, 0, 1, 2);
	add(&mesh, 4, 1, 0, 3);
	add(&mesh, 3, 1, 0, 4);
	add(&mesh, 5, 0, 1, 6);
	CHECK(count_components(&mesh) == 4);
	CHECK(count_bodies(&mesh, bodies) == 2);
	CHECK(mesh.components[0] == 0 && mesh.components[2] == 0);
	CHECK(mesh.components[1] == 1 && mesh.components[3] == 1);
	/* A third of the same: which of them belong together is not known. */
	add(&mesh, 0, 0, 1, 5);
	CHECK(count_bodies(&mesh, bodies) == 4);
}

static void
components_count_in_the_order_of_their_first_triangles(void)
{
	struct mesh mesh = {0};

	add(&mesh, 1, 10, 11, 12);
	add(&mesh, 2, 0, 1, 2);
	add(&mesh, 3, 20, 21, 22);
	add(&mesh, 2, 2, 3, 4);
	add(&mesh, 1, 12, 13, 14);
	CHECK(count_components(&mesh) == 3);
	for (uint32_t i = 0; i < 3; i++)
		CHECK(mesh.components[i] == i);
	CHECK(mesh.components[3] == 1 && mesh.components[4] == 0);
}

static void
collapsed_triangles_join_by_points_only(void)
{
	struct mesh mesh = {0};

	add(&mesh, 1, 0, 1, 1);
	add(&mesh, 2, 0, 1, 2);
	add(&mesh, 3, 1, 0, 3);
	add(&mesh, 1, 5, 5, 5);
	CHECK(count_components(&mesh) == 3);
	CHECK(mesh.components[1] == mesh.components[2]);
}

static void
an_empty_mesh_has_no_components(void)
{
	struct mesh mesh = {0};

	CHECK(count_components(&mesh) == 0);
}

static void
uses_of_an_edge_stand_together(void)
{
	const struct tcs_triangle triangles[] = {
		{{3, 1, 2}}, {{2, 1, 0}}, {{1, 2, 4}}};
	struct edge_table table = {0};
	struct tcs_fault fault;
	size_t at = 0;

	CHECK(!edge_table_build(&table, triangles, 3, 5, &fault));
	CHECK(table.uses.count == 9);
	while (table.uses.at[at].low != 1 || table.uses.at[at].high != 2)
		at += edge_table_run(&table, at);
	CHECK(edge_table_run(&table, at) == 3);
	CHECK(table.uses.at[at].forward && table.uses.at[at].triangle == 0);
	CHECK(!table.uses.at[at + 1].forward);
	CHECK(table.uses.at[at + 2].forward);
	edge_table_release(&table);
}

static const struct check_test tests[] = {
	CHECK_TEST(equal_positions_are_one_point),
	CHECK_TEST(a_grid_welds_with_its_copy),
	CHECK_TEST(a_shared_point_joins_inside_a_feature_only),
	CHECK_TEST(a_feature_is_joined_over_another_at_a_point),
	CHECK_TEST(an_edge_of_two_joins_across_features),
	CHECK_TEST(an_edge_of_two_joins_inside_a_body),
	CHECK_TEST(components_count_in_the_order_of_their_first_triangles),
	CHECK_TEST(collapsed_triangles_join_by_points_only),
	CHECK_TEST(an_empty_mesh_has_no_components),
	CHECK_TEST(uses_of_an_edge_stand_together),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
