/* Components that lose their volume. */
#include "check.h"
#include "collapse_sample.h"

static const struct collapse_settings plain = {.base_ratio = 2};

/* Two pyramids of a height of `up` and `down`, base to base, 1 by 1 m; whole or
   without a face of the lower one. */
static void
add_spindle(struct collapse_sample *sample, double up, double down, bool whole)
{
	static const struct tcs_point ring[4] = {
		{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

	for (int i = 0; i < 4; i++) {
		struct tcs_point a = ring[i], b = ring[(i + 1) % 4];

		sample_add(sample, 1, (struct tcs_point){0.5, 0.5, up}, a, b);
		if (i > 0 || whole)
			sample_add(sample, 1,
				(struct tcs_point){0.5, 0.5, -down}, b, a);
	}
}

/* What collapsing the upper point to a corner breaks. */
static double
harm(double up, double down, bool whole)
{
	struct collapse_sample sample = {0};
	struct tcs_fault fault;
	double broken;
	bool fine;

	add_spindle(&sample, up, down, whole);
	sample_begin(&sample, &plain);
	CHECK(!collapse_check(&sample.work, sample_node(&sample, 0.5, 0.5, up),
		sample_node(&sample, 0, 0, 0), &fine, &fault));
	CHECK(fine);
	broken = sample.work.broken;
	sample_release(&sample);
	return broken;
}

static void
a_solid_that_falls_flat_is_worth_something(void)
{
	CHECK(harm(1, 0.05, true) > 0);
	CHECK(!(harm(1, 0.2, true) > 0));
}

static void
what_has_no_volume_loses_none(void)
{
	CHECK(!(harm(1, 0.05, false) > 0));
}

/* A ball of 8 by 12 faces; every third is folded in, so that it is not convex. */
static void
add_ball(struct collapse_sample *sample)
{
	enum { ROUND = 12, HIGH = 8 };
	struct tcs_point at[HIGH + 1][ROUND];

	for (int i = 0; i <= HIGH; i++)
		for (int k = 0; k < ROUND; k++) {
			double up = acos(-1) * i / HIGH;
			double turn = 2 * acos(-1) * k / ROUND;
			double radius = k % 3 ? 1 : 0.8;

			at[i][k] = i % HIGH
				? (struct tcs_point){radius * sin(up) *
						  cos(turn),
					  radius * sin(up) * sin(turn), cos(up)}
				: (struct tcs_point){0, 0, i ? -1 : 1};
		}
	for (int i = 0; i < HIGH; i++)
		for (int k = 0; k < ROUND; k++) {
			int next = (k + 1) % ROUND;

			if (i > 0)
				sample_add(sample, 1, at[i][k], at[i + 1][k],
					at[i][next]);
			if (i + 1 < HIGH)
				sample_add(sample, 1, at[i][next], at[i + 1][k],
					at[i + 1][next]);
		}
}

static void
the_volume_is_that_of_what_is_left(void)
{
	for (int optimal = 0; optimal < 2; optimal++) {
		struct collapse_settings settings = plain;
		struct collapse_sample sample = {0};

		settings.optimal = optimal;
		add_ball(&sample);
		sample_begin(&sample, &settings);
		for (size_t faces = 160; faces >= 20; faces -= 20) {
			sample_run(&sample, faces);
			CHECK(sample.work.face_count <= faces);
			CHECK(fabs(sample_volume(&sample, 1) -
				      sample.work.volume.volumes.at[0]) < 1e-9);
		}
		sample_release(&sample);
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(a_solid_that_falls_flat_is_worth_something),
	CHECK_TEST(what_has_no_volume_loses_none),
	CHECK_TEST(the_volume_is_that_of_what_is_left),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
