/* That nothing comes to go through what it did not. */
#include "simplify/crossing.h"
#include <math.h>

#include "check.h"
#include "collapse_sample.h"

static const struct collapse_settings plain = {
	.base_ratio = 2, .contact_cost = INFINITY};

/* A pyramid of two metres without a floor, one metre high. */
static void
add_pyramid(struct collapse_sample *sample)
{
	static const struct tcs_point ring[4] = {
		{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

	for (int i = 0; i < 4; i++)
		sample_add(sample, 1, (struct tcs_point){1, 1, 1}, ring[i],
			ring[(i + 1) % 4]);
}

/* Whether its tip may go to a corner, which lays it flat, and what breaks. */
static bool
breaks_flat(struct collapse_sample *sample,
	const struct collapse_settings *settings, double *broken)
{
	struct tcs_fault fault;
	bool fine;

	sample_begin(sample, settings);
	CHECK(!collapse_check(&sample->work, sample_node(sample, 1, 1, 1),
		sample_node(sample, 0, 0, 0), &fine, &fault));
	*broken = sample->work.broken;
	sample_release(sample);
	return fine;
}

static bool
may_be_flat(struct collapse_sample *sample)
{
	double broken;

	return breaks_flat(sample, &plain, &broken);
}

static void
other_components_are_not_gone_through(void)
{
	for (int deep = 0; deep < 2; deep++) {
		struct collapse_sample sample = {0};

		add_pyramid(&sample);
		sample_add_box(&sample, 2,
			(struct tcs_point){1.2, 0.9, deep ? 0.1 : -0.1},
			(struct tcs_point){0.2, 0.2, 0.2});
		CHECK(may_be_flat(&sample) == (deep == 1));
	}
}

static void
other_components_are_gone_through_at_a_price(void)
{
	static const struct collapse_settings priced = {
		.base_ratio = 2, .contact_cost = 1};
	double broken;

	for (int deep = 0; deep < 2; deep++) {
		struct collapse_sample sample = {0};

		add_pyramid(&sample);
		sample_add_box(&sample, 2,
			(struct tcs_point){1.2, 0.9, deep ? 0.1 : -0.1},
			(struct tcs_point){0.2, 0.2, 0.2});
		CHECK(breaks_flat(&sample, &priced, &broken));
		CHECK((broken > 0) == (deep == 0));
	}
}

/* What it breaks to put a square over the foot of the pyramid instead of it. */
static double
broken_by_a_floor(struct collapse_sample *sample)
{
	static const struct collapse_settings priced = {
		.base_ratio = 2, .contact_cost = 1};
	const uint32_t faces[4] = {0, 1, 2, 3};
	static const int around[6] = {0, 1, 2, 2, 3, 0};
	uint32_t corners[6];
	struct refill refill = {.faces = faces,
		.face_count = 4,
		.corners = corners,
		.count = 2};
	struct tcs_fault fault;
	double broken;
	bool fine;

	sample_begin(sample, &priced);
	for (int i = 0; i < 6; i++)
		corners[i] = sample->sheets.corners.at[3 * around[i] + 1];
	CHECK(!crossing_watch_admits(&sample->work, &refill, &fine, &fault));
	CHECK(fine);
	broken = sample->work.broken;
	sample_release(sample);
	return broken;
}

static void
closing_goes_through_others_for_more_than_a_collapse(void)
{
	static const struct collapse_settings priced = {
		.base_ratio = 2, .contact_cost = 1};
	double collapse;

	for (int deep = 0; deep < 2; deep++) {
		struct collapse_sample samples[2] = {0};

		for (int i = 0; i < 2; i++) {
			add_pyramid(&samples[i]);
			sample_add_box(&samples[i], 2,
				(struct tcs_point){1.2, 0.9, deep ? 0.1 : -0.1},
				(struct tcs_point){0.2, 0.2, 0.2});
		}
		CHECK(breaks_flat(&samples[0], &priced, &collapse));
		if (deep)
			CHECK(!(broken_by_a_floor(&samples[1]) > 0));
		else
			CHECK(broken_by_a_floor(&samples[1]) > 100 * collapse);
	}
}

/* Only at a corner, so that it is another sheet of the same component. */
static void
add_fin(struct collapse_sample *sample, double top)
{
	sample_add(sample, 1, (struct tcs_point){2, 2, 0},
		(struct tcs_point){1.2, 1, -0.5},
		(struct tcs_point){1.2, 1, top});
}

static void
the_own_component_is_not_gone_through(void)
{
	struct collapse_sample sample = {0};

	add_pyramid(&sample);
	add_fin(&sample, -0.1);
	CHECK(may_be_flat(&sample));
	add_pyramid(&sample);
	add_fin(&sample, 0.3);
	CHECK(!may_be_flat(&sample));
}

static void
what_was_gone_through_may_be(void)
{
	struct collapse_sample sample = {0};

	add_pyramid(&sample);
	add_fin(&sample, 3);
	CHECK(may_be_flat(&sample));
}

static struct tcs_point
on_ball(double radius, int latitude, int longitude)
{
	double up = 3.14159265358979 * latitude / 12;
	double around = 3.14159265358979 * (longitude % 24) / 12;

	return (struct tcs_point){radius * sin(up) * cos(around),
		radius * sin(up) * sin(around), radius * cos(up)};
}

/* Open at the poles. */
static void
add_ball(struct collapse_sample *sample, uint32_t feature, double radius)
{
	for (int i = 1; i < 11; i++)
		for (int k = 0; k < 24; k++)
			sample_add_quad(sample, feature, on_ball(radius, i, k),
				on_ball(radius, i + 1, k),
				on_ball(radius, i + 1, k + 1),
				on_ball(radius, i, k + 1));
}

static bool
load(const struct collapse_sample *sample, uint32_t face,
	struct triangle_shape *out)
{
	uint32_t nodes[3];

	if (!collapses_face(&sample->work, face, nodes))
		return false;
	for (int k = 0; k < 3; k++)
		out->corner[k] = sample->work.positions.at[nodes[k]];
	return true;
}

static size_t
count_crossings(const struct collapse_sample *sample)
{
	size_t count = 0;

	for (uint32_t i = 0; i < sample->sheets.face_triangles.count; i++)
		for (uint32_t k = 0; k < i; k++) {
			struct triangle_shape a, b;

			count += load(sample, i, &a) && load(sample, k, &b) &&
				triangles_cross(&a, &b);
		}
	return count;
}

/* Step after step, with faces that have grown far beyond where they were. */
static void
shells_stay_one_in_the_other(void)
{
	struct collapse_sample sample = {0};

	add_ball(&sample, 1, 2);
	add_ball(&sample, 2, 1.95);
	add_ball(&sample, 3, 1.8);
	sample_begin(&sample, &plain);
	CHECK(count_crossings(&sample) == 0);
	sample_run(&sample, 150);
	CHECK(sample.work.face_count < 400);
	CHECK(count_crossings(&sample) == 0);
	sample_release(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(other_components_are_not_gone_through),
	CHECK_TEST(other_components_are_gone_through_at_a_price),
	CHECK_TEST(closing_goes_through_others_for_more_than_a_collapse),
	CHECK_TEST(the_own_component_is_not_gone_through),
	CHECK_TEST(what_was_gone_through_may_be),
	CHECK_TEST(shells_stay_one_in_the_other),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
