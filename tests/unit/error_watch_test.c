#include "simplify/error_watch.h"
#include <math.h>

#include "check.h"
#include "collapse_sample.h"

/* A level sheet of 8 × 8 metres with one vertex pulled up. */
static void
add_tent(struct collapse_sample *sample, double height)
{
	const struct tcs_point top = {4, 4, height};

	for (int y = 0; y < 8; y++)
		for (int x = 0; x < 8; x++) {
			struct tcs_point at[4];

			for (int i = 0; i < 4; i++) {
				at[i] = (struct tcs_point){
					x + (i == 1 || i == 2), y + (i > 1), 0};
				if (at[i].x == top.x && at[i].y == top.y)
					at[i] = top;
			}
			sample_add_quad(sample, 1, at[0], at[1], at[2], at[3]);
		}
}

static bool
keeps_top(double height, double max_error)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = 0, .max_error = max_error};
	struct collapse_sample sample = {0};
	bool kept;

	add_tent(&sample, height);
	sample_begin(&sample, &settings);
	sample_run(&sample, 4);
	kept = sample_has(&sample, 4, 4, height);
	sample_release(&sample);
	return kept;
}

static void
what_moves_less_than_the_limit_goes_and_more_stays(void)
{
	CHECK(!keeps_top(0.09, 0.1));
	CHECK(keeps_top(0.11, 0.1));
	CHECK(!keeps_top(0.9, 1));
	CHECK(keeps_top(1.1, 1));
}

static void
without_a_limit_nothing_is_watched(void)
{
	CHECK(!keeps_top(0.5, 0));
}

/* A tube of many sides: every step is small, their sum must be, too. */
static void
many_small_steps_do_not_add_up(void)
{
	enum { SIDES = 256, RINGS = 8 };
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY, .max_error = 0.02};
	struct collapse_sample sample = {0};
	const double step = 2 * 3.14159265358979323846 / SIDES;
	size_t faces = 0;

	for (int i = 0; i < SIDES * RINGS; i++) {
		double from = i % SIDES * step;
		double to = (i % SIDES + 1) % SIDES * step;
		double z = i / SIDES;

		sample_add_quad(&sample, 1,
			(struct tcs_point){cos(from), sin(from), z},
			(struct tcs_point){cos(to), sin(to), z},
			(struct tcs_point){cos(to), sin(to), z + 1},
			(struct tcs_point){cos(from), sin(from), z + 1});
	}
	sample_begin(&sample, &settings);
	sample_run(&sample, 4);
	faces = sample.work.face_count;
	CHECK(faces < 64);
	for (uint32_t i = 0; i < 2 * SIDES * RINGS; i++) {
		struct triangle_shape shape;
		struct tcs_point centre;
		uint32_t nodes[3];

		if (!collapses_face(&sample.work, i, nodes))
			continue;
		for (int k = 0; k < 3; k++)
			shape.corner[k] = sample.work.positions.at[nodes[k]];
		centre = triangle_centre(&shape);
		CHECK(hypot(centre.x, centre.y) > 1 - 2 * 0.02);
	}
	sample_release(&sample);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(what_moves_less_than_the_limit_goes_and_more_stays),
		CHECK_TEST(without_a_limit_nothing_is_watched),
		CHECK_TEST(many_small_steps_do_not_add_up),
		{0},
	};

	return check_run(tests);
}
