/* What goes through what, by which depth. */
#include "simplify/crossing.h"

#include "check.h"
#include "collapse_sample.h"
#include "simplify/compare_crossings.h"

static const struct triangle_shape floor_shape = {
	{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

/* Both ways round. */
static bool
crosses_floor(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	const struct triangle_shape other = {{a, b, c}};
	bool crosses = triangles_cross(&floor_shape, &other);

	CHECK(triangles_cross(&other, &floor_shape) == crosses);
	return crosses;
}

static void
what_passes_through_crosses(void)
{
	CHECK(crosses_floor((struct tcs_point){1, 1, -1},
		(struct tcs_point){1, 1, 1}, (struct tcs_point){8, 8, 0}));
	/* Only the floor's edge passes through the other. */
	CHECK(crosses_floor((struct tcs_point){2, -1, -2},
		(struct tcs_point){2, -1, 2}, (struct tcs_point){2, 1, 0.1}));
	CHECK(!crosses_floor((struct tcs_point){3, 3, -1},
		(struct tcs_point){3, 3, 1}, (struct tcs_point){8, 8, 0}));
}

static void
what_touches_does_not(void)
{
	/* It stands on it. */
	CHECK(!crosses_floor((struct tcs_point){1, 1, 0},
		(struct tcs_point){2, 1, 0}, (struct tcs_point){1, 1, 3}));
	/* It lies in its plane, half on it. */
	CHECK(!crosses_floor((struct tcs_point){1, 1, 0},
		(struct tcs_point){9, 1, 0}, (struct tcs_point){9, 9, 0}));
	/* It runs past its edge. */
	CHECK(!crosses_floor((struct tcs_point){1, 0, -1},
		(struct tcs_point){1, 0, 1}, (struct tcs_point){1, -3, 0}));
	/* They have a corner in common. */
	CHECK(!crosses_floor((struct tcs_point){0, 0, 0},
		(struct tcs_point){1, -1, -1}, (struct tcs_point){1, -1, 1}));
	/* One is a line. */
	CHECK(!crosses_floor((struct tcs_point){9, 9, 9},
		(struct tcs_point){9, 9, 9}, (struct tcs_point){9, 9, 9}));
}

static void
less_than_the_depth_does_not_count(void)
{
	for (int i = 0; i < 2; i++) {
		double deep = i ? 2e-4 : 0.5e-4;

		CHECK(crosses_floor((struct tcs_point){1, 1, -deep},
			      (struct tcs_point){1, 1, 1},
			      (struct tcs_point){2, 1, 1}) == (i == 1));
		CHECK(crosses_floor((struct tcs_point){1, deep, -1},
			      (struct tcs_point){1, deep, 1},
			      (struct tcs_point){1, -3, 0}) == (i == 1));
	}
}

/* A corner is shared, and the far edge passes through all the same. */
static void
a_neighbour_may_cross(void)
{
	CHECK(crosses_floor((struct tcs_point){0, 0, 0},
		(struct tcs_point){2, 1, -1}, (struct tcs_point){1, 2, 1}));
}

static void
components_are_told_from_one_another(void)
{
	struct collapse_sample sample = {0};
	struct crossings crossings = {0};
	struct tcs_fault fault;

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){2, 2, 2});
	sample_add_box(&sample, 2, (struct tcs_point){5, 0, 0},
		(struct tcs_point){2, 2, 2});
	sample_add_box(&sample, 3, (struct tcs_point){1.5, 0.5, 0.5},
		(struct tcs_point){4, 1, 1});
	/* Two sheets that have a point in common go through each other. */
	sample_add(&sample, 4, (struct tcs_point){20, 0, 0},
		(struct tcs_point){24, 0, 0}, (struct tcs_point){20, 4, 0});
	sample_add(&sample, 4, (struct tcs_point){20, 0, 0},
		(struct tcs_point){22, 1, -1}, (struct tcs_point){21, 2, 1});
	CHECK(!component_set_build(&sample.set, &fault));
	CHECK(!crossings_find(&sample.set, &crossings, &fault));
	CHECK(crossings.own == 1);
	CHECK(crossings.pairs.count == 2);
	if (crossings.pairs.count == 2) {
		CHECK(crossings.pairs.at[0].a == 0);
		CHECK(crossings.pairs.at[0].b == 2);
		CHECK(crossings.pairs.at[1].a == 1);
		CHECK(crossings.pairs.at[1].b == 2);
	}
	crossings_release(&crossings);
	sample_release(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(what_passes_through_crosses),
	CHECK_TEST(what_touches_does_not),
	CHECK_TEST(less_than_the_depth_does_not_count),
	CHECK_TEST(a_neighbour_may_cross),
	CHECK_TEST(components_are_told_from_one_another),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
