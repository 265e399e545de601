#include "simplify/triangle_shape.h"

#include <math.h>

#include "check.h"
#include "simplify/vector.h"

enum { TRIANGLES = 2000, STEPS = 12 };

/* From -1 to 1, the same in every run. */
static double
next_number(uint64_t *state)
{
	*state = *state * 6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 33) / (double)(1u << 30) - 1;
}

static struct tcs_point
next_point(uint64_t *state)
{
	double x = next_number(state), y = next_number(state);

	return (struct tcs_point){x, y, next_number(state)};
}

static struct triangle_shape
next_triangle(uint64_t *state)
{
	struct tcs_point a = next_point(state), b = next_point(state);

	return (struct triangle_shape){{a, b, next_point(state)}};
}

static struct tcs_point
point_of(const struct triangle_shape *t, double u, double v)
{
	return vector_along(
		vector_along(t->corner[0],
			vector_difference(t->corner[1], t->corner[0]), u),
		vector_difference(t->corner[2], t->corner[0]), v);
}

static double
distance(struct tcs_point a, struct tcs_point b)
{
	return vector_length(vector_difference(a, b));
}

/* Of a point from the triangle, seen at steps along both sides. */
static double
distance_by_steps(const struct triangle_shape *t, struct tcs_point from)
{
	double least = INFINITY;

	for (int i = 0; i <= STEPS; i++)
		for (int k = 0; k <= STEPS - i; k++)
			least = fmin(least,
				distance(from,
					point_of(t, (double)i / STEPS,
						(double)k / STEPS)));
	return least;
}

static void
no_point_is_nearer_than_the_nearest(void)
{
	uint64_t state = 1;

	for (int n = 0; n < TRIANGLES; n++) {
		struct triangle_shape t = next_triangle(&state);
		struct tcs_point from = next_point(&state);
		double found = distance(from, triangle_nearest(&t, from));
		double steps = distance_by_steps(&t, from);

		CHECK(found <= steps + 1e-12);
		/* Steps are no farther apart than this. */
		CHECK(found >= steps - 4.0 / STEPS);
	}
}

static void
the_nearest_point_is_on_the_triangle(void)
{
	uint64_t state = 2;

	for (int n = 0; n < TRIANGLES; n++) {
		struct triangle_shape t = next_triangle(&state);
		struct tcs_point at = triangle_nearest(&t, next_point(&state));
		struct tcs_point again = triangle_nearest(&t, at);

		CHECK(distance(at, again) < 1e-9);
		CHECK(distance_by_steps(&t, at) < 4.0 / STEPS);
	}
}

static void
what_is_moved_along_the_normal_stays_above(void)
{
	uint64_t state = 3;

	for (int n = 0; n < TRIANGLES; n++) {
		struct triangle_shape t = next_triangle(&state);
		struct tcs_point normal = triangle_normal(&t);
		double u = next_number(&state), v = next_number(&state);
		bool inside = u > 0 && v > 0 && u + v < 1;
		struct tcs_point point = vector_along(
			point_of(&t, u, v), normal, next_number(&state));

		CHECK(triangle_is_above(&t, normal, point) == inside);
	}
}

static void
of_a_triangle_without_area_the_longest_side_is_left(void)
{
	struct triangle_shape t = {{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}};
	struct tcs_point at =
		triangle_nearest(&t, (struct tcs_point){1.5, 1, 1});

	CHECK(distance(at, (struct tcs_point){1.5, 0, 0}) < 1e-12);
}

static const struct check_test tests[] = {
	CHECK_TEST(no_point_is_nearer_than_the_nearest),
	CHECK_TEST(the_nearest_point_is_on_the_triangle),
	CHECK_TEST(what_is_moved_along_the_normal_stays_above),
	CHECK_TEST(of_a_triangle_without_area_the_longest_side_is_left),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
