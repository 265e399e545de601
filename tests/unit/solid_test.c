#include "parsers/solid.h"

#include <math.h>

#include "check.h"

static struct tcs_fault fault;

static bool
near(double a, double b)
{
	return fabs(a - b) <= 1e-9 * (1 + fabs(b));
}

static struct solid_measure
measured(const struct solid *solid)
{
	struct solid_measure out;

	CHECK(!solid_measure(solid, &out, &fault));
	return out;
}

/* A square of 4 by 4 with a square hole of 1 by 1. */
static const struct tcs_point frame[] = {{0, 0, 1}, {4, 0, 1}, {4, 4, 1},
	{0, 4, 1}, {1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}};
static const uint32_t frame_rings[] = {4, 4};

static void
a_prism_is_closed_and_looks_outwards(void)
{
	struct solid solid = {0};
	struct solid_measure measure;

	CHECK(!solid_add_prism(&solid, frame, frame_rings, 2,
		(struct tcs_point){1, 0, 3}, 7, &fault));
	measure = measured(&solid);
	CHECK(solid.faces.count == 10 && solid.faces.at[9].label == 7);
	CHECK(measure.closed && near(measure.volume, 45));
	CHECK(measure.lower.z == 1 && measure.upper.z == 4);
	CHECK(measure.lower.x == 0 && measure.upper.x == 5);
	CHECK(near(measure.area, 30 + 5 * 3 * 2 + 5 * sqrt(10) * 2));
	solid_release(&solid);
}

static void
a_prism_downwards_looks_outwards_too(void)
{
	struct solid solid = {0};
	struct solid_measure measure;

	CHECK(!solid_add_prism(&solid, frame, frame_rings, 2,
		(struct tcs_point){0, 0, -2}, 0, &fault));
	measure = measured(&solid);
	CHECK(measure.closed && near(measure.volume, 30));
	solid_release(&solid);
}

static void
a_missing_face_leaves_it_open(void)
{
	struct solid solid = {0};

	CHECK(!solid_add_prism(&solid, frame, frame_rings, 1,
		(struct tcs_point){0, 0, 1}, 0, &fault));
	CHECK(measured(&solid).closed);
	solid.faces.count--;
	solid.ring_ends.count--;
	solid.points.count -= 4;
	CHECK(!measured(&solid).closed);
	solid_release(&solid);
}

static void
nothing_has_no_volume(void)
{
	struct solid solid = {0};
	struct solid_measure measure = measured(&solid);

	CHECK(measure.closed && measure.volume == 0 && measure.area == 0);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_prism_is_closed_and_looks_outwards),
	CHECK_TEST(a_prism_downwards_looks_outwards_too),
	CHECK_TEST(a_missing_face_leaves_it_open),
	CHECK_TEST(nothing_has_no_volume),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
