/* What a collapse costs, rule by rule. */
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "collapse_sample.h"

/* Nothing costs less than what the shorter edge is preferred by. */
static const double free_cost = 1e-6;

static double
cost(const struct collapse_sample *sample, struct tcs_point from,
	struct tcs_point to)
{
	uint32_t node = sample_node(sample, from.x, from.y, from.z);
	uint32_t target = sample_node(sample, to.x, to.y, to.z);

	CHECK(node != TCS_NONE && target != TCS_NONE);
	return collapse_cost(&sample->work, node, target, INFINITY);
}

/* A slab of 8 × 8 × 1 metres and, through its upper face, an upright sheet of
   squares of a metre that begins below it. */
static void
add_slab_and_sheet(struct collapse_sample *sample, double base_ratio)
{
	const struct collapse_settings settings = {
		.base_ratio = base_ratio, .contact_cost = INFINITY};

	sample_add_box(sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){8, 8, 1});
	for (int x = 1; x < 6; x++)
		for (int z = 0; z < 4; z++)
			sample_add_quad(sample, 2,
				(struct tcs_point){x, 4, z + 0.5},
				(struct tcs_point){x + 1, 4, z + 0.5},
				(struct tcs_point){x + 1, 4, z + 1.5},
				(struct tcs_point){x, 4, z + 1.5});
	sample_begin(sample, &settings);
}

static const struct tcs_point stuck = {3, 4, 0.5}, beside = {4, 4, 0.5},
			      above = {3, 4, 1.5}, loose = {3, 4, 2.5},
			      higher = {3, 4, 3.5};

static void
an_ordinary_vertex_in_a_plane_costs_nothing(void)
{
	struct collapse_sample sample = {0};

	add_slab_and_sheet(&sample, 2);
	CHECK(cost(&sample, loose, higher) < free_cost);
	sample_release(&sample);
}

/* W4: at 0 degrees nothing separates, at 90 degrees all does. */
static void
pulling_out_of_a_contact_costs_more_than_sliding_along_it(void)
{
	struct collapse_sample sample = {0};

	add_slab_and_sheet(&sample, 2);
	CHECK(cost(&sample, stuck, beside) < free_cost);
	CHECK(cost(&sample, stuck, above) > 1);
	sample_release(&sample);
}

/* Straight out of a contact is as dear as any way out of it may be: twice what
   the shape costs. */
static void
a_pull_straight_out_has_a_bound(void)
{
	struct collapse_sample sample = {0};
	uint32_t node;

	add_slab_and_sheet(&sample, 1);
	node = sample_node(&sample, 3, 4, 0.5);
	CHECK(node != TCS_NONE);
	CHECK(fabs(cost(&sample, stuck, above) -
		      2 * collapse_cost_at(&sample.work, node, above)) < 1e-9);
	sample_release(&sample);
}

/* W5: a boundary vertex costs `a` times as much, an ordinary one does not. */
static void
the_base_ratio_multiplies_what_boundary_vertices_cost(void)
{
	struct collapse_sample sample = {0};
	double one, four, plain;

	add_slab_and_sheet(&sample, 1);
	one = cost(&sample, stuck, above);
	plain = cost(&sample, loose, higher);
	sample_release(&sample);
	add_slab_and_sheet(&sample, 4);
	four = cost(&sample, stuck, above);
	CHECK(fabs(four - 4 * one) < 1e-9 * four);
	CHECK(fabs(cost(&sample, loose, higher) - plain) < 1e-12);
	sample_release(&sample);
}

/* A post in a corner of two slabs: along the one is out of the other. */
static void
of_several_contacts_the_worst_counts(void)
{
	const struct collapse_settings settings = {
		.base_ratio = 1, .contact_cost = INFINITY};
	struct collapse_sample sample = {0};

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, -1},
		(struct tcs_point){8, 8, 1});
	sample_add_box(&sample, 2, (struct tcs_point){-1, 0, 0},
		(struct tcs_point){1, 8, 8});
	sample_add_box(&sample, 3, (struct tcs_point){0, 4, 0},
		(struct tcs_point){2, 1, 2});
	sample_begin(&sample, &settings);
	/* Along the floor out of the wall, and along the wall out of the
	   floor. Along both it stays with both. */
	CHECK(cost(&sample, (struct tcs_point){0, 4, 0},
		      (struct tcs_point){2, 4, 0}) > 10);
	CHECK(cost(&sample, (struct tcs_point){0, 4, 0},
		      (struct tcs_point){0, 4, 2}) > 10);
	CHECK(cost(&sample, (struct tcs_point){0, 4, 0},
		      (struct tcs_point){0, 5, 0}) < 10);
	sample_release(&sample);
}

/* W5, hole vertices; an open rim is held by planes across it, see
   feature_planes.c: it may lose vertices along a straight line, and no more. */
static void
an_open_rim_is_not_free_to_leave_its_line(void)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY};
	struct collapse_sample sample = {0};

	sample_add_sheet(&sample, 1, (struct tcs_point){0, 0, 0}, 1, 6, 6);
	sample_begin(&sample, &settings);
	CHECK(cost(&sample, (struct tcs_point){3, 3, 0},
		      (struct tcs_point){3, 4, 0}) < free_cost);
	CHECK(cost(&sample, (struct tcs_point){3, 0, 0},
		      (struct tcs_point){4, 0, 0}) < free_cost);
	CHECK(cost(&sample, (struct tcs_point){3, 0, 0},
		      (struct tcs_point){3, 1, 0}) > 0.5);
	CHECK(cost(&sample, (struct tcs_point){0, 0, 0},
		      (struct tcs_point){1, 0, 0}) > 0.5);
	sample_release(&sample);
}

/* L2: a roof of two slopes; one that is hardly bent. */
static void
a_sharp_edge_is_a_line_and_a_blunt_one_is_none(void)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY};
	double costs[2];

	for (int i = 0; i < 2; i++) {
		struct collapse_sample sample = {0};
		double rise = i ? 1 : 0.1;

		for (int y = 0; y < 4; y++)
			for (int x = -2; x < 2; x++)
				sample_add_quad(&sample, 1,
					(struct tcs_point){
						x, y, -rise * abs(x)},
					(struct tcs_point){
						x + 1, y, -rise * abs(x + 1)},
					(struct tcs_point){x + 1, y + 1,
						-rise * abs(x + 1)},
					(struct tcs_point){
						x, y + 1, -rise * abs(x)});
		sample_begin(&sample, &settings);
		/* Off the ridge; its planes alone cost rise² / (1 + rise²) per
		   square metre. */
		costs[i] = cost(&sample, (struct tcs_point){0, 2, 0},
				   (struct tcs_point){1, 2, -rise}) /
			(rise * rise / (1 + rise * rise));
		CHECK(cost(&sample, (struct tcs_point){0, 2, 0},
			      (struct tcs_point){0, 1, 0}) < free_cost);
		sample_release(&sample);
	}
	CHECK(costs[1] > costs[0] + 0.5);
}

/* Borders between surfaces stay within a centimetre while they are kept. */
static void
a_border_between_surfaces_may_not_be_left_unless_it_must(void)
{
	struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY};
	struct collapse_sample sample = {0};

	sample_add_sheet(&sample, 1, (struct tcs_point){0, 0, 0}, 1, 3, 6);
	sample_add_sheet(&sample, 2, (struct tcs_point){3, 0, 0}, 1, 3, 6);
	sample_begin(&sample, &settings);
	CHECK(isinf(cost(&sample, (struct tcs_point){3, 3, 0},
		(struct tcs_point){2, 3, 0})));
	CHECK(cost(&sample, (struct tcs_point){3, 3, 0},
		      (struct tcs_point){3, 4, 0}) < free_cost);
	sample.work.settings.contact_cost = 0;
	CHECK(cost(&sample, (struct tcs_point){3, 3, 0},
		      (struct tcs_point){2, 3, 0}) > 0.1);
	sample_release(&sample);
}

/* The surface is one, the paint ends at x = 3. */
static void
a_seam_of_the_paint_is_a_border(void)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY};
	struct collapse_sample sample = {0};
	uint32_t charts[72], homes[SAMPLE_FEATURES] = {3, 3, 3, 3};
	struct tcs_fault fault;

	for (int i = 0; i < 72; i++)
		charts[i] = i >= 36;
	sample.charts = charts;
	sample_add_sheet(&sample, 1, (struct tcs_point){0, 0, 0}, 1, 3, 6);
	sample_add_sheet(&sample, 1, (struct tcs_point){3, 0, 0}, 1, 3, 6);
	sample_begin(&sample, &settings);
	CHECK(isinf(cost(&sample, (struct tcs_point){3, 3, 0},
		(struct tcs_point){2, 3, 0})));
	CHECK(cost(&sample, (struct tcs_point){3, 3, 0},
		      (struct tcs_point){3, 4, 0}) < free_cost);
	/* Both sides are painted as another surface. */
	CHECK(!collapses_dissolve(&sample.work, homes, &fault));
	CHECK(cost(&sample, (struct tcs_point){3, 3, 0},
		      (struct tcs_point){2, 3, 0}) < free_cost);
	sample_release(&sample);
}

static void
what_stands_on_the_ground_is_not_lifted_off_it(void)
{
	const struct collapse_settings settings = {
		.base_ratio = 2, .contact_cost = INFINITY};
	struct collapse_sample sample = {0};

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){1, 1, 1});
	sample_begin(&sample, &settings);
	CHECK(isinf(cost(&sample, (struct tcs_point){0, 0, 0},
		(struct tcs_point){0, 0, 1})));
	CHECK(isfinite(cost(&sample, (struct tcs_point){0, 0, 0},
		(struct tcs_point){1, 0, 0})));
	CHECK(isfinite(cost(&sample, (struct tcs_point){0, 0, 1},
		(struct tcs_point){0, 0, 0})));
	sample_release(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(an_ordinary_vertex_in_a_plane_costs_nothing),
	CHECK_TEST(pulling_out_of_a_contact_costs_more_than_sliding_along_it),
	CHECK_TEST(a_pull_straight_out_has_a_bound),
	CHECK_TEST(the_base_ratio_multiplies_what_boundary_vertices_cost),
	CHECK_TEST(of_several_contacts_the_worst_counts),
	CHECK_TEST(an_open_rim_is_not_free_to_leave_its_line),
	CHECK_TEST(a_sharp_edge_is_a_line_and_a_blunt_one_is_none),
	CHECK_TEST(a_border_between_surfaces_may_not_be_left_unless_it_must),
	CHECK_TEST(a_seam_of_the_paint_is_a_border),
	CHECK_TEST(what_stands_on_the_ground_is_not_lifted_off_it),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
