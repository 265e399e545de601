#include "simplify/face_budget.h"
#include <math.h>

#include "check.h"
#include "collapse_sample.h"

static const struct collapse_settings plain = {
	.base_ratio = 2, .contact_cost = INFINITY};

static struct structure_counts
count(const struct collapse_sample *sample)
{
	struct structure_counts counts;
	struct tcs_fault fault;

	CHECK(!structure_count(&sample->work, &counts, &fault));
	return counts;
}

static size_t
find(const struct collapse_sample *sample, enum budget_kind kind, double amount)
{
	const struct face_budget budget = {kind, amount};
	struct tcs_fault fault;
	size_t faces;

	CHECK(!face_budget_find(&budget, &sample->work, &faces, &fault));
	return faces;
}

static void
a_box_has_twelve_lines_and_eight_corners(void)
{
	struct collapse_sample sample = {0};
	struct structure_counts counts;

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){1, 2, 3});
	sample_begin(&sample, &plain);
	counts = count(&sample);
	CHECK(counts.open_edges == 0);
	CHECK(counts.lines == 12);
	CHECK(counts.corners == 8);
	sample_release(&sample);
}

/* 4 × 3 squares: the rim is 14 edges, and no edge is sharp. */
static void
a_level_sheet_has_a_rim_and_nothing_else(void)
{
	struct collapse_sample sample = {0};
	struct structure_counts counts;

	sample_add_sheet(&sample, 1, (struct tcs_point){0, 0, 0}, 1, 4, 3);
	sample_begin(&sample, &plain);
	counts = count(&sample);
	CHECK(counts.open_edges == 14);
	CHECK(counts.lines == 0);
	CHECK(counts.corners == 0);
	sample_release(&sample);
}

/* Two sheets that meet in a straight border of three edges. */
static void
borders_are_lines_and_what_divides_them_no_corners(void)
{
	struct collapse_sample sample = {0};
	struct structure_counts counts;

	sample_add_sheet(&sample, 1, (struct tcs_point){0, 0, 0}, 1, 2, 3);
	sample_add_sheet(&sample, 2, (struct tcs_point){2, 0, 0}, 1, 2, 3);
	sample_begin(&sample, &plain);
	counts = count(&sample);
	CHECK(counts.lines == 3);
	CHECK(counts.corners == 0);
	sample_release(&sample);
}

static void
every_kind_of_budget_says_what_stays(void)
{
	struct collapse_sample sample = {0};

	sample_add_sheet(&sample, 1, (struct tcs_point){0, 0, 0}, 1, 10, 10);
	sample_begin(&sample, &plain);
	CHECK(find(&sample, BUDGET_RATE, 0.25) == 150);
	CHECK(find(&sample, BUDGET_RATE, 0.999) == 1);
	CHECK(find(&sample, BUDGET_TRIANGLES, 17) == 17);
	CHECK(find(&sample, BUDGET_TRIANGLES, 1e9) == 200);
	CHECK(find(&sample, BUDGET_STRUCTURE, 4) == 160);
	CHECK(find(&sample, BUDGET_STRUCTURE, 1000) == 200);
	CHECK(find(&sample, BUDGET_ERROR, 0) == 0);
	sample_release(&sample);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(a_box_has_twelve_lines_and_eight_corners),
		CHECK_TEST(a_level_sheet_has_a_rim_and_nothing_else),
		CHECK_TEST(borders_are_lines_and_what_divides_them_no_corners),
		CHECK_TEST(every_kind_of_budget_says_what_stays),
		{0},
	};

	return check_run(tests);
}
