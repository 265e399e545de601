#include "simplify/overlaps.h"
#include <math.h>

#include "check.h"
#include "collapse_sample.h"

static const struct collapse_settings plain = {
	.base_ratio = 2, .contact_cost = INFINITY};

/* A wall of 4 × 3 metres in the plane x = 0 that looks along x, and a pane of
   one square metre that stands `before` it. */
static void
add_wall_and_pane(struct collapse_sample *sample, double before)
{
	sample_add_quad(sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){0, 4, 0}, (struct tcs_point){0, 4, 3},
		(struct tcs_point){0, 0, 3});
	sample_add_quad(sample, 2, (struct tcs_point){before, 1, 1},
		(struct tcs_point){before, 2, 1},
		(struct tcs_point){before, 2, 2},
		(struct tcs_point){before, 1, 2});
	sample_begin(sample, &plain);
}

/* As if simplification had moved the pane. */
static void
move_pane(struct collapse_sample *sample, double from, double to)
{
	for (size_t i = 0; i < sample->work.positions.count; i++) {
		struct tcs_point *at = &sample->work.positions.at[i];

		if (at->y > 0.5 && at->y < 2.5 && fabs(at->x - from) < 1e-9)
			at->x = to;
	}
}

/* Where the pane comes to, from where it was and where it is. */
static double
pane_after(double was, double is)
{
	struct collapse_sample sample = {0};
	struct overlaps overlaps = {0};
	struct tcs_fault fault;
	double x = NAN;

	add_wall_and_pane(&sample, was);
	move_pane(&sample, was, is);
	CHECK(!overlaps_part(&overlaps, &sample.work, &fault));
	for (size_t i = 0; i < sample.work.positions.count; i++) {
		struct tcs_point at = sample.work.positions.at[i];

		if (at.y > 0.5 && at.y < 2.5)
			x = at.x;
		else
			CHECK(at.x > -1e-12 && at.x < 1e-12);
	}
	overlaps_release(&overlaps);
	sample_release(&sample);
	return x;
}

static bool
is_near(double a, double b)
{
	return fabs(a - b) < 1e-9;
}

static void
a_pane_laid_into_its_wall_comes_forward(void)
{
	CHECK(is_near(pane_after(0.02, 0), 0.002));
	CHECK(is_near(pane_after(0.02, 0.0005), 0.002));
	CHECK(is_near(pane_after(0.0015, 0), 0.0015));
}

static void
a_pane_sunk_into_its_wall_comes_forward(void)
{
	CHECK(is_near(pane_after(0.02, -0.005), 0.002));
}

static void
a_pane_behind_its_wall_stays_behind(void)
{
	CHECK(is_near(pane_after(-0.02, 0), -0.002));
}

static void
what_is_in_order_stays(void)
{
	CHECK(is_near(pane_after(0.02, 0.01), 0.01));
	CHECK(is_near(pane_after(-0.02, -0.003), -0.003));
	CHECK(is_near(pane_after(0.02, -0.05), -0.05));
}

static void
what_was_flush_from_the_beginning_stays(void)
{
	CHECK(is_near(pane_after(0, 0), 0));
	CHECK(is_near(pane_after(0.0004, -0.0004), -0.0004));
}

/* Two boxes that come to stand on each other: their faces look at each other,
   and a smaller one beside a larger does not cover it. */
static void
faces_that_look_at_each_other_or_lie_beside_stay(void)
{
	struct collapse_sample sample = {0};
	struct overlaps overlaps = {0};
	struct tcs_fault fault;

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){2, 2, 1});
	sample_add_box(&sample, 2, (struct tcs_point){0, 2, 1.01},
		(struct tcs_point){2, 2, 1});
	sample_begin(&sample, &plain);
	for (size_t i = 0; i < sample.work.positions.count; i++)
		if (is_near(sample.work.positions.at[i].z, 1.01))
			sample.work.positions.at[i].z = 1;
	CHECK(!overlaps_part(&overlaps, &sample.work, &fault));
	CHECK(overlaps.parted == 0);
	overlaps_release(&overlaps);
	sample_release(&sample);
}

/* The whole box keeps its shape but for the side that came forward. */
static void
what_hangs_on_a_parted_face_stays_closed(void)
{
	struct collapse_sample sample = {0};
	struct overlaps overlaps = {0};
	struct tcs_fault fault;
	size_t forward = 0;

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){1, 4, 3});
	sample_add_box(&sample, 2, (struct tcs_point){0.5, 1, 1},
		(struct tcs_point){0.53, 1, 1});
	sample_begin(&sample, &plain);
	for (size_t i = 0; i < sample.work.positions.count; i++)
		if (is_near(sample.work.positions.at[i].x, 1.03))
			sample.work.positions.at[i].x = 1;
	CHECK(!overlaps_part(&overlaps, &sample.work, &fault));
	CHECK(overlaps.parted > 0);
	for (size_t i = 0; i < sample.work.positions.count; i++)
		forward += is_near(sample.work.positions.at[i].x, 1.002);
	CHECK(forward == 4);
	overlaps_release(&overlaps);
	sample_release(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_pane_laid_into_its_wall_comes_forward),
	CHECK_TEST(a_pane_sunk_into_its_wall_comes_forward),
	CHECK_TEST(a_pane_behind_its_wall_stays_behind),
	CHECK_TEST(what_is_in_order_stays),
	CHECK_TEST(what_was_flush_from_the_beginning_stays),
	CHECK_TEST(faces_that_look_at_each_other_or_lie_beside_stay),
	CHECK_TEST(what_hangs_on_a_parted_face_stays_closed),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
