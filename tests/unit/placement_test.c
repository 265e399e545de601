#include "simplify/placement.h"
#include <math.h>

#include "check.h"
#include "collapse_sample.h"

static const double pi = 3.14159265358979323846;

enum { AROUND = 48, ACROSS = 24 };

static struct tcs_point
ball_point(struct tcs_point centre, double radius, int i, int k)
{
	double turn = 2 * pi * (i % AROUND) / AROUND;
	double rise = pi * k / ACROSS - pi / 2;

	if (k == 0 || k == ACROSS)
		return (struct tcs_point){
			centre.x, centre.y, centre.z + (k ? radius : -radius)};
	return (struct tcs_point){
		centre.x + radius * cos(rise) * cos(turn),
		centre.y + radius * cos(rise) * sin(turn),
		centre.z + radius * sin(rise),
	};
}

static void
add_ball(struct collapse_sample *sample, uint32_t feature,
	struct tcs_point centre, double radius)
{
	for (int i = 0; i < AROUND; i++)
		for (int k = 0; k < ACROSS; k++) {
			struct tcs_point a = ball_point(centre, radius, i, k);
			struct tcs_point b =
				ball_point(centre, radius, i + 1, k);
			struct tcs_point c =
				ball_point(centre, radius, i + 1, k + 1);
			struct tcs_point d =
				ball_point(centre, radius, i, k + 1);

			if (k > 0)
				sample_add(sample, feature, a, b, c);
			if (k < ACROSS - 1)
				sample_add(sample, feature, a, c, d);
		}
}

static size_t
count_moved(const struct collapse_sample *sample)
{
	size_t moved = 0;

	for (uint32_t i = 0; i < sample->sheets.node_count; i++)
		moved += collapses_is_moved(&sample->work, i);
	return moved;
}

/* How far the centres of the faces that are left are from a sphere of radius 1
   about the origin, the root of the mean square. */
static double
error_of_ball(bool optimal)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY, .optimal = optimal};
	struct collapse_sample sample = {0};
	double sum = 0, faces = 0;

	add_ball(&sample, 1, (struct tcs_point){0, 0, 0}, 1);
	sample_begin(&sample, &settings);
	sample_run(&sample, 120);
	CHECK(sample.work.face_count <= 120);
	CHECK((count_moved(&sample) > 10) == optimal);
	for (uint32_t i = 0; i < sample.sheets.face_triangles.count; i++) {
		struct triangle_shape shape;
		uint32_t nodes[3];
		double off;

		if (!collapses_face(&sample.work, i, nodes))
			continue;
		for (int k = 0; k < 3; k++)
			shape.corner[k] = sample.work.positions.at[nodes[k]];
		off = vector_length(triangle_centre(&shape)) - 1;
		sum += off * off;
		faces++;
	}
	sample_release(&sample);
	return sqrt(sum / faces);
}

static void
moved_vertices_fit_a_ball_better(void)
{
	CHECK(error_of_ball(true) < 0.8 * error_of_ball(false));
}

/* A ball that a plate touches: what touches, and what is touched, stays. */
static void
boundary_vertices_are_never_moved(void)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY, .optimal = true};
	struct collapse_sample sample = {0};
	size_t boundary = 0;

	add_ball(&sample, 1, (struct tcs_point){0, 0, 0}, 1);
	sample_add_box(&sample, 2, (struct tcs_point){-2, -2, -1.5},
		(struct tcs_point){4, 4, 1});
	sample_begin(&sample, &settings);
	sample_run(&sample, 300);
	CHECK(count_moved(&sample) > 10);
	for (uint32_t i = 0; i < sample.sheets.node_count; i++) {
		if (sample.seams.nodes.at[i] == TCS_NONE)
			continue;
		boundary++;
		CHECK(!collapses_is_moved(&sample.work, i));
	}
	CHECK(boundary > 10);
	sample_release(&sample);
}

/* A vault that is open on all four sides. */
static void
vertices_on_a_rim_are_never_moved(void)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY, .optimal = true};
	struct collapse_sample sample = {0};

	for (int x = 0; x < 16; x++)
		for (int y = 0; y < 16; y++) {
			struct tcs_point at[4];

			for (int i = 0; i < 4; i++) {
				double u = x + (i == 1 || i == 2);
				double v = y + (i > 1);

				at[i] = (struct tcs_point){u, v,
					sin(pi * u / 16) + sin(pi * v / 16)};
			}
			sample_add_quad(&sample, 1, at[0], at[1], at[2], at[3]);
		}
	sample_begin(&sample, &settings);
	sample_run(&sample, 60);
	CHECK(count_moved(&sample) > 0);
	for (uint32_t i = 0; i < sample.sheets.node_count; i++)
		CHECK(!sample.work.fixed.at[i] ||
			!collapses_is_moved(&sample.work, i));
	sample_release(&sample);
}

static void
a_limit_on_the_error_holds_for_moved_vertices(void)
{
	const struct collapse_settings settings = {.base_ratio = 2,
		.contact_cost = INFINITY,
		.optimal = true,
		.max_error = 0.02};
	struct collapse_sample sample = {0};

	add_ball(&sample, 1, (struct tcs_point){0, 0, 0}, 1);
	sample_begin(&sample, &settings);
	sample_run(&sample, 4);
	CHECK(sample.work.face_count < 500);
	CHECK(count_moved(&sample) > 10);
	for (uint32_t i = 0; i < sample.sheets.node_count; i++)
		CHECK(fabs(vector_length(sample.work.positions.at[i]) - 1) <
			0.02);
	sample_release(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(moved_vertices_fit_a_ball_better),
	CHECK_TEST(boundary_vertices_are_never_moved),
	CHECK_TEST(vertices_on_a_rim_are_never_moved),
	CHECK_TEST(a_limit_on_the_error_holds_for_moved_vertices),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
