#include "simplify/compare_distance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "simplify/split_work.h"
#include "simplify/vector.h"

static uint64_t random_state;

/* From 0 to 1. */
static double
next_random(void)
{
	random_state =
		random_state * 6364136223846793005u + 1442695040888963407u;
	return (double)(random_state >> 11) * 0x1p-53;
}

static void
side_add(struct compare_side *side, struct tcs_point a, struct tcs_point b,
	struct tcs_point c)
{
	const struct tcs_point corners[3] = {a, b, c};
	struct tcs_fault fault;

	CHECK(!component_set_add(&side->set, corners, 0, TCS_NONE, &fault));
}

static void
side_build(struct compare_side *side, unsigned jobs)
{
	size_t count = side->set.triangles.count;
	uint32_t *items = calloc(count + 1, sizeof *items);
	struct tcs_fault fault;

	if (!items)
		abort();
	for (size_t i = 0; i < count; i++)
		items[i] = (uint32_t)i;
	side->set.jobs = jobs;
	CHECK(!component_set_build(&side->set, &fault));
	CHECK(!triangle_tree_add(&side->surfaces, side->set.points.at,
		side->set.triangles.at, items, count, &side->whole, &fault));
	free(items);
}

/* A square of n by n quads at height z + bend · x · y, from 0 to 1. */
static void
side_sheet(struct compare_side *side, int n, double z, double bend)
{
	for (int i = 0; i < n * n; i++) {
		struct tcs_point at[4];

		for (int k = 0; k < 4; k++) {
			double x = (i % n + k % 2) / (double)n;
			double y = (i / n + k / 2) / (double)n;

			at[k] = (struct tcs_point){x, y, z + bend * x * y};
		}
		side_add(side, at[0], at[1], at[3]);
		side_add(side, at[0], at[3], at[2]);
	}
	side_build(side, 1);
}

static struct surface_distance
distance_between(const struct compare_side *from, const struct compare_side *to)
{
	struct surface_distance out;
	struct tcs_fault fault;

	CHECK(!surface_distance_measure(from, to, 0.001, &out, &fault));
	return out;
}

static void
the_same_plane_cut_otherwise_is_nowhere_apart(void)
{
	struct compare_side a = {0}, b = {0};
	struct surface_distance found;

	side_sheet(&a, 3, 5, 0);
	side_sheet(&b, 7, 5, 0);
	found = distance_between(&a, &b);
	CHECK(found.max < 1e-9 && found.at_most < 1e-3);
	CHECK(found.mean < 1e-9 && found.rms < 1e-9);
	side_release(&a);
	side_release(&b);
}

static void
parallel_planes_are_as_far_apart_everywhere(void)
{
	struct compare_side a = {0}, b = {0};
	struct surface_distance found;

	side_sheet(&a, 3, 5, 0);
	side_sheet(&b, 4, 5.25, 0);
	found = distance_between(&a, &b);
	CHECK(fabs(found.max - 0.25) < 1e-9);
	CHECK(found.at_most >= found.max && found.at_most < 0.251);
	CHECK(fabs(found.mean - 0.25) < 1e-9);
	CHECK(fabs(found.rms - 0.25) < 1e-9);
	side_release(&a);
	side_release(&b);
}

/* The distance from x, y of a sheet to the plane is the height: x · y there,
   of mean 1/4 and mean square 1/9. */
static void
a_bent_sheet_has_the_mean_that_its_integral_has(void)
{
	struct compare_side a = {0}, b = {0};
	struct surface_distance found;

	side_sheet(&a, 40, 0, 0.1);
	side_add(&b, (struct tcs_point){-9, -9, 0},
		(struct tcs_point){99, -9, 0}, (struct tcs_point){-9, 99, 0});
	side_build(&b, 1);
	found = distance_between(&a, &b);
	CHECK(fabs(found.max - 0.1) < 1e-9);
	CHECK(found.at_most >= found.max && found.at_most < 0.1011);
	CHECK(fabs(found.mean - 0.025) < 1e-3);
	CHECK(fabs(found.rms - 0.1 / 3) < 1e-3);
	side_release(&a);
	side_release(&b);
}

static struct tcs_point
random_near(struct tcs_point at, double size)
{
	struct tcs_point way = {
		next_random() - 0.5, next_random() - 0.5, next_random() - 0.5};

	return vector_along(at, way, size);
}

static void
side_random(struct compare_side *side, unsigned seed, int count, unsigned jobs)
{
	random_state = seed;
	for (int i = 0; i < count; i++) {
		struct tcs_point at =
			random_near((struct tcs_point){0, 0, 0}, 10);

		side_add(side, random_near(at, 3), random_near(at, 3),
			random_near(at, 3));
	}
	side_build(side, jobs);
}

static double
brute_distance(const struct compare_side *side, struct tcs_point from)
{
	double least = INFINITY;

	for (size_t i = 0; i < side->set.triangles.count; i++) {
		struct triangle_shape shape =
			component_set_shape(&side->set, i);
		struct tcs_point at = triangle_nearest(&shape, from);

		least = fmin(least, vector_length(vector_difference(at, from)));
	}
	return least;
}

/* The largest of brute force over a grid of points on every triangle. */
static double
brute_max(const struct compare_side *from, const struct compare_side *to, int n)
{
	double most = 0;

	for (size_t i = 0; i < from->set.triangles.count; i++) {
		struct triangle_shape t = component_set_shape(&from->set, i);

		for (int k = 0; k <= n; k++)
			for (int m = 0; k + m <= n; m++) {
				struct tcs_point at = vector_along(
					vector_along(t.corner[0],
						vector_difference(t.corner[1],
							t.corner[0]),
						(double)k / n),
					vector_difference(
						t.corner[2], t.corner[0]),
					(double)m / n);

				most = fmax(most, brute_distance(to, at));
			}
	}
	return most;
}

static void
the_largest_is_that_of_brute_force(void)
{
	for (unsigned seed = 1; seed < 6; seed++) {
		struct compare_side a = {0}, b = {0};
		struct surface_distance found;

		side_random(&a, seed, 40, 1);
		side_random(&b, seed + 100, 60, 1);
		found = distance_between(&a, &b);
		/* No grid point is farther than the bound. */
		CHECK(brute_max(&a, &b, 20) <= found.at_most + 1e-9);
		/* Corners are among the points that are looked at. */
		CHECK(brute_max(&a, &b, 1) <= found.max + 1e-9);
		CHECK(found.at_most - found.max < 0.0011);
		side_release(&a);
		side_release(&b);
	}
}

static void
the_number_of_threads_changes_nothing(void)
{
	struct surface_distance found[2];

	for (unsigned i = 0; i < 2; i++) {
		struct compare_side a = {0}, b = {0};

		side_random(&a, 7, 3000, i ? 3 : 1);
		side_random(&b, 8, 2000, 1);
		found[i] = distance_between(&a, &b);
		side_release(&a);
		side_release(&b);
	}
	CHECK(!memcmp(&found[0], &found[1], sizeof *found));
}

static void
to_nothing_there_is_no_distance(void)
{
	struct compare_side a = {0}, b = {0};

	side_sheet(&a, 1, 0, 0);
	CHECK(isinf(distance_between(&a, &b).max));
	CHECK(isinf(distance_between(&b, &a).mean));
	side_release(&a);
}

/* ---- the loop on several threads ----------------------------------------- */

struct marks {
	unsigned char seen[1000];
	size_t pieces[100];
};

static void
mark(void *context, size_t piece, size_t first, size_t end)
{
	struct marks *marks = context;

	marks->pieces[piece] = end - first;
	for (size_t i = first; i < end; i++)
		marks->seen[i]++;
}

static void
every_number_is_worked_on_once(void)
{
	static const size_t counts[] = {0, 1, 13, 14, 999};
	struct tcs_fault fault;

	for (unsigned jobs = 0; jobs < 5; jobs++) {
		struct marks marks = {0};
		size_t count = counts[jobs];

		CHECK(!split_work(count, 13, jobs, mark, &marks, &fault));
		for (size_t i = 0; i < 1000; i++)
			CHECK(marks.seen[i] == (i < count));
		for (size_t i = 0; i < split_pieces(count, 13); i++)
			CHECK(marks.pieces[i] ==
				(13 * i + 13 <= count ? 13 : count % 13));
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(the_same_plane_cut_otherwise_is_nowhere_apart),
	CHECK_TEST(parallel_planes_are_as_far_apart_everywhere),
	CHECK_TEST(a_bent_sheet_has_the_mean_that_its_integral_has),
	CHECK_TEST(the_largest_is_that_of_brute_force),
	CHECK_TEST(the_number_of_threads_changes_nothing),
	CHECK_TEST(to_nothing_there_is_no_distance),
	CHECK_TEST(every_number_is_worked_on_once),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
