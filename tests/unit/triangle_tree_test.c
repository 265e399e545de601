#include "simplify/triangle_tree.h"

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "simplify/vector.h"

enum { TRIANGLES = 700, QUERIES = 300 };

static uint64_t random_state;

/* From 0 to 1. */
static double
next_random(void)
{
	random_state =
		random_state * 6364136223846793005u + 1442695040888963407u;
	return (double)(random_state >> 11) * 0x1p-53;
}

static struct tcs_point
random_point(double size)
{
	double x = next_random(), y = next_random(), z = next_random();

	return (struct tcs_point){size * x, size * y, size * z};
}

struct scene {
	struct tcs_point points[3 * TRIANGLES];
	struct tcs_triangle triangles[TRIANGLES];
	uint32_t items[TRIANGLES];
	struct triangle_tree tree;
	uint32_t roots[2]; /* even triangles, odd ones */
};

static struct triangle_shape
shape_at(const struct scene *scene, size_t i)
{
	return (struct triangle_shape){{scene->points[3 * i],
		scene->points[3 * i + 1], scene->points[3 * i + 2]}};
}

/* Small triangles in a cube of 10 m; every tenth is a segment or a point. */
static void
scene_begin(struct scene *scene, unsigned seed)
{
	struct tcs_fault fault;

	*scene = (struct scene){0};
	random_state = seed;
	for (uint32_t i = 0; i < TRIANGLES; i++) {
		struct tcs_point at = random_point(10);

		for (uint32_t k = 0; k < 3; k++) {
			scene->points[3 * i + k] =
				vector_sum(at, random_point(2));
			scene->triangles[i].corner[k] = 3 * i + k;
		}
		if (i % 10 == 9)
			scene->points[3 * i + 1] = scene->points[3 * i];
		if (i % 20 == 19)
			scene->points[3 * i + 2] = scene->points[3 * i];
	}
	for (uint32_t half = 0; half < 2; half++) {
		for (uint32_t i = 0; i < TRIANGLES / 2; i++)
			scene->items[i] = 2 * i + half;
		if (triangle_tree_add(&scene->tree, scene->points,
			    scene->triangles, scene->items, TRIANGLES / 2,
			    &scene->roots[half], &fault))
			abort();
	}
}

static double
distance_between(struct tcs_point a, struct tcs_point b)
{
	return vector_length(vector_difference(a, b));
}

static void
the_nearest_point_is_that_of_brute_force(void)
{
	static struct scene scene;

	scene_begin(&scene, 1);
	for (int q = 0; q < QUERIES; q++) {
		struct tcs_point from = random_point(14);
		struct tree_hit hit = triangle_tree_nearest(
			&scene.tree, scene.roots[q % 2], from, INFINITY);
		double least = INFINITY;

		for (size_t i = (size_t)q % 2; i < TRIANGLES; i += 2) {
			struct triangle_shape shape = shape_at(&scene, i);

			least = fmin(least,
				distance_between(
					from, triangle_nearest(&shape, from)));
		}
		CHECK(fabs(hit.distance - least) < 1e-9);
		CHECK(fabs(distance_between(from, hit.point) - least) < 1e-9);
		CHECK(isinf(triangle_tree_nearest(
			&scene.tree, scene.roots[q % 2], from, least * 0.999)
				    .distance));
	}
	triangle_tree_release(&scene.tree);
}

static void
the_first_triangle_of_a_ray_is_that_of_brute_force(void)
{
	static struct scene scene;
	int hits = 0;

	scene_begin(&scene, 2);
	for (int q = 0; q < QUERIES; q++) {
		struct tcs_point from = random_point(10);
		struct tcs_point way =
			vector_difference(random_point(1), random_point(1));
		struct tree_hit hit = triangle_tree_ray(
			&scene.tree, scene.roots[0], from, way, INFINITY);
		double first = INFINITY;

		for (size_t i = 0; i < TRIANGLES; i += 2) {
			struct triangle_shape shape = shape_at(&scene, i);
			double t, margin;

			if (triangle_hit(&shape, from, way, &t, &margin) &&
				t > 0)
				first = fmin(first, t);
		}
		CHECK(hit.distance == first);
		hits += isfinite(first);
	}
	CHECK(hits > QUERIES / 10);
	triangle_tree_release(&scene.tree);
}

static double
brute_gap(const struct scene *scene)
{
	double least = INFINITY;

	for (size_t i = 0; i < TRIANGLES; i += 2) {
		for (size_t k = 1; k < TRIANGLES; k += 2) {
			struct triangle_shape a = shape_at(scene, i);
			struct triangle_shape b = shape_at(scene, k);
			struct tcs_point points[2];

			least = fmin(least, triangle_gap(&a, &b, points));
		}
	}
	return least;
}

/* The odd triangles of a second scene are moved away from the even ones. */
static void
the_gap_between_two_trees_is_that_of_brute_force(void)
{
	static struct scene scene;
	struct tcs_fault fault;

	for (unsigned seed = 1; seed < 9; seed++) {
		struct tree_gap gap;
		double least;

		scene_begin(&scene, seed);
		for (size_t i = 1; i < TRIANGLES; i += 2)
			for (size_t k = 0; k < 3; k++)
				scene.points[3 * i + k].x += 1.8 * seed;
		triangle_tree_release(&scene.tree);
		for (uint32_t half = 0; half < 2; half++) {
			for (uint32_t i = 0; i < TRIANGLES / 2; i++)
				scene.items[i] = 2 * i + half;
			CHECK(!triangle_tree_add(&scene.tree, scene.points,
				scene.triangles, scene.items, TRIANGLES / 2,
				&scene.roots[half], &fault));
		}
		least = brute_gap(&scene);
		gap = triangle_tree_gap(&scene.tree, scene.roots[0],
			scene.roots[1], INFINITY, 0);
		CHECK(fabs(gap.distance - least) < 1e-9);
		CHECK(fabs(distance_between(gap.points[0], gap.points[1]) -
			      least) < 1e-9);
		triangle_tree_release(&scene.tree);
	}
}

static void
the_gap_of_one_triangle_is_that_of_brute_force(void)
{
	static struct scene scene;
	int reached = 0;

	scene_begin(&scene, 3);
	for (size_t i = 0; i < TRIANGLES; i += 14) {
		struct triangle_shape from = shape_at(&scene, i);
		struct tcs_point points[2];
		struct tree_gap gap;
		double least = INFINITY;

		for (size_t k = 1; k < TRIANGLES; k += 2) {
			struct triangle_shape other = shape_at(&scene, k);

			least = fmin(
				least, triangle_gap(&from, &other, points));
		}
		gap = triangle_tree_gap_from(
			&scene.tree, scene.roots[1], &from, 0.1);
		reached += least > 0 && least < 0.1;
		if (least < 0.0999)
			CHECK(fabs(gap.distance - least) < 1e-9);
		else if (least > 0.1001)
			CHECK(isinf(gap.distance));
	}
	CHECK(reached > 0);
	triangle_tree_release(&scene.tree);
}

struct near_count {
	const struct scene *scene;
	unsigned char seen[TRIANGLES];
};

static bool
note_near(void *context, uint32_t position)
{
	struct near_count *count = context;

	count->seen[count->scene->tree.boxes.items.at[position]]++;
	return true;
}

static void
what_is_near_a_box_is_visited_once(void)
{
	static struct scene scene;
	const struct box box = {{2, 3, 4}, {5, 4, 6}};
	struct near_count count = {.scene = &scene};

	scene_begin(&scene, 4);
	box_tree_near(&scene.tree.boxes, scene.roots[0], &box, 0.5, note_near,
		&count);
	for (size_t i = 0; i < TRIANGLES; i++) {
		struct box own = BOX_EMPTY;

		for (size_t k = 0; k < 3; k++)
			box_add_point(&own, scene.points[3 * i + k]);
		CHECK(count.seen[i] <= (i % 2 == 0));
		if (i % 2 == 0 && box_gap_squared(&own, &box) <= 0.25)
			CHECK(count.seen[i] == 1);
	}
	triangle_tree_release(&scene.tree);
}

/* ---- pairs -------------------------------------------------------------- */

static bool
mark_pair(void *context, uint32_t a, uint32_t b)
{
	unsigned char *seen = context;

	seen[a * TRIANGLES + b]++;
	return true;
}

static struct box
box_at(const struct scene *scene, uint32_t position)
{
	struct box box = BOX_EMPTY;

	for (int k = 0; k < 3; k++)
		box_add_point(&box, scene->tree.shapes.at[position].corner[k]);
	return box;
}

static void
every_pair_in_reach_is_visited_once(void)
{
	static struct scene scene;
	static unsigned char seen[TRIANGLES * TRIANGLES];
	uint32_t half = TRIANGLES / 2;
	size_t missed = 0, twice = 0, near = 0;

	scene_begin(&scene, 3);
	box_tree_pairs(&scene.tree.boxes, scene.roots[0], scene.roots[0], 0.05,
		mark_pair, seen);
	box_tree_pairs(&scene.tree.boxes, scene.roots[0], scene.roots[1], 0.05,
		mark_pair, seen);
	for (uint32_t a = 0; a < half; a++) {
		for (uint32_t b = a + 1; b < TRIANGLES; b++) {
			struct box p = box_at(&scene, a);
			struct box q = box_at(&scene, b);
			int count = seen[a * TRIANGLES + b];

			if (b < half)
				count += seen[b * TRIANGLES + a];
			twice += count > 1;
			if (box_gap_squared(&p, &q) > 0.05 * 0.05)
				continue;
			near++;
			missed += !count;
		}
	}
	CHECK(near > 100);
	CHECK(missed == 0);
	CHECK(twice == 0);
	triangle_tree_release(&scene.tree);
}

static void
boxes_that_are_all_alike_make_a_flat_tree(void)
{
	enum { COUNT = 10000 };
	static struct box boxes[COUNT];
	static uint32_t items[COUNT];
	struct box_tree tree = {0};
	struct tcs_fault fault;
	uint32_t root;

	for (uint32_t i = 0; i < COUNT; i++) {
		boxes[i] = (struct box){{0, 0, 0}, {1, 1, 1}};
		items[i] = i;
	}
	CHECK(!box_tree_add(&tree, boxes, items, COUNT, &root, &fault));
	CHECK(tree.items.count == COUNT);
	CHECK(tree.nodes.count < COUNT);
	box_tree_release(&tree);
}

/* Each box lies twice as far away as the one before. */
static void
boxes_ever_farther_apart_keep_the_tree_shallow(void)
{
	enum { COUNT = 900 };
	static struct box boxes[COUNT];
	static uint32_t items[COUNT];
	static unsigned char seen[TRIANGLES * TRIANGLES * 2];
	struct box_tree tree = {0};
	struct tcs_fault fault;
	uint32_t root;

	for (uint32_t i = 0; i < COUNT; i++) {
		double at = ldexp(1, (int)i - 450);

		boxes[i] = (struct box){{at, 0, 0}, {at, 0, 0}};
		items[i] = i;
	}
	CHECK(!box_tree_add(&tree, boxes, items, COUNT, &root, &fault));
	/* Asserts in the walk watch the height of its stack. */
	box_tree_pairs(&tree, root, root, 0, mark_pair, seen);
	box_tree_release(&tree);
}

/* A cube from 0 to 1 of 12 triangles. */
static const struct tcs_point cube_points[] = {
	{0, 0, 0},
	{1, 0, 0},
	{1, 1, 0},
	{0, 1, 0},
	{0, 0, 1},
	{1, 0, 1},
	{1, 1, 1},
	{0, 1, 1},
};
static const struct tcs_triangle cube[] = {
	{{0, 2, 1}},
	{{0, 3, 2}},
	{{4, 5, 6}},
	{{4, 6, 7}},
	{{0, 1, 5}},
	{{0, 5, 4}},
	{{1, 2, 6}},
	{{1, 6, 5}},
	{{2, 3, 7}},
	{{2, 7, 6}},
	{{3, 0, 4}},
	{{3, 4, 7}},
};

static void
a_cube_encloses_what_is_inside(void)
{
	const uint32_t items[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
	struct triangle_tree tree = {0};
	struct tcs_fault fault;
	uint32_t root;

	CHECK(!triangle_tree_add(
		&tree, cube_points, cube, items, 12, &root, &fault));
	random_state = 5;
	for (int i = 0; i < 1000; i++)
		CHECK(triangle_tree_encloses(&tree, root, random_point(1)));
	CHECK(triangle_tree_encloses(
		&tree, root, (struct tcs_point){0.5, 0.5, 0.5}));
	for (int i = 0; i < 1000; i++) {
		struct tcs_point at = random_point(1);

		at.x += 1 + 1e-9;
		CHECK(!triangle_tree_encloses(&tree, root, at));
	}
	triangle_tree_release(&tree);
}

static void
triangles_that_cross_have_no_gap(void)
{
	const struct triangle_shape flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
	const struct triangle_shape upright = {
		{{1, 1, -1}, {1.5, 1, -1}, {1, 1, 2}}};
	const struct triangle_shape above = {
		{{1, 1, 0.25}, {1.5, 1, 3}, {1, 1, 2}}};
	const struct triangle_shape beside = {
		{{-3, 0, 0}, {-0.5, 2, 0}, {-3, 4, 0}}};
	struct tcs_point points[2];

	CHECK(triangle_gap(&flat, &upright, points) == 0);
	CHECK(fabs(points[0].z) < 1e-12);
	CHECK(triangle_gap(&flat, &above, points) == 0.25);
	CHECK(points[0].z == 0 && points[1].z == 0.25);
	CHECK(triangle_gap(&flat, &beside, points) == 0.5);
	CHECK(triangle_area(&flat) == 8);
}

static const struct check_test tests[] = {
	CHECK_TEST(the_nearest_point_is_that_of_brute_force),
	CHECK_TEST(the_first_triangle_of_a_ray_is_that_of_brute_force),
	CHECK_TEST(the_gap_between_two_trees_is_that_of_brute_force),
	CHECK_TEST(the_gap_of_one_triangle_is_that_of_brute_force),
	CHECK_TEST(what_is_near_a_box_is_visited_once),
	CHECK_TEST(every_pair_in_reach_is_visited_once),
	CHECK_TEST(boxes_that_are_all_alike_make_a_flat_tree),
	CHECK_TEST(boxes_ever_farther_apart_keep_the_tree_shallow),
	CHECK_TEST(a_cube_encloses_what_is_inside),
	CHECK_TEST(triangles_that_cross_have_no_gap),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
