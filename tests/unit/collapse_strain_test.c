/* What is done only if nothing cheaper is left. */
#include "check.h"
#include "collapse_sample.h"

static const struct collapse_settings plain = {.base_ratio = 2};

static bool
is_strained(struct collapse_sample *sample, uint32_t node, uint32_t target)
{
	struct tcs_fault fault;
	bool fine;

	CHECK(!collapse_check(&sample->work, node, target, &fine, &fault));
	CHECK(fine);
	return sample->work.is_strained;
}

/* L4: the normal. Earlier steps tilted the face at the origin far to the one
   side, and this one tilts it to the other. */
static void
a_face_that_turns_too_far_at_once_strains(void)
{
	static const struct tcs_point ring[5] = {
		{0, 0, 0}, {1, 0, 0}, {1.5, 1, 0}, {0.5, 2, 0}, {-0.5, 1, 0}};
	struct tcs_point *at;
	uint32_t middle, target;
	struct collapse_sample sample = {0};

	for (int i = 0; i < 5; i++)
		sample_add(&sample, 1, (struct tcs_point){0.5, 1, 0}, ring[i],
			ring[(i + 1) % 5]);
	sample_begin(&sample, &plain);
	middle = sample_node(&sample, 0.5, 1, 0);
	target = sample_node(&sample, 0.5, 2, 0);
	CHECK(!is_strained(&sample, middle, target));
	at = sample.work.positions.at;
	at[target] = (struct tcs_point){0.5, 0.1, 1};
	at[middle] = (struct tcs_point){0.5, 0.1, 0.9};
	CHECK(!is_strained(&sample, middle, target));
	at[middle] = (struct tcs_point){0.5, 0.1, -1};
	CHECK(is_strained(&sample, middle, target));
	sample_release(&sample);
}

static void
add_pyramid(struct collapse_sample *sample, uint32_t feature, double x,
	double side, double height)
{
	const struct tcs_point ring[4] = {
		{x, 0, 0}, {x + side, 0, 0}, {x + side, side, 0}, {x, side, 0}};

	for (int i = 0; i < 4; i++)
		sample_add(sample, feature,
			(struct tcs_point){x + side / 2, side / 2, height},
			ring[i], ring[(i + 1) % 4]);
}

/* L4: the area. */
static void
faces_that_grow_or_shrink_too_much_strain(void)
{
	for (int i = 1; i < 5; i++) {
		struct collapse_sample sample = {0};

		/* It has i times the area of its base, and a little more. */
		add_pyramid(&sample, 1, 0, 2, sqrt(i * i * 1.1 - 1));
		sample_begin(&sample, &plain);
		CHECK(is_strained(&sample,
			      sample_node(&sample, 1, 1, sqrt(i * i * 1.1 - 1)),
			      sample_node(&sample, 0, 0, 0)) == (i == 4));
		sample_release(&sample);
	}
}

/* Collapse one of two nodes. */
static void
run_one(struct collapse_sample *sample, uint32_t a, uint32_t b)
{
	sample_run(sample, sample->work.face_count); /* only judges */
	for (uint32_t i = 0; i < sample->sheets.node_count; i++)
		if (i != a && i != b) {
			node_queue_set(&sample->work.queue, i, INFINITY);
			sample->work.targets.at[i] = TCS_NONE;
		}
	sample_run(sample, sample->work.face_count - 1);
}

/* A needle costs less than a flat pyramid, but not 200 times less. */
static void
what_strains_is_done_last(void)
{
	struct collapse_sample sample = {0};
	uint32_t needle, flat;
	double cost[2];

	add_pyramid(&sample, 1, 0, 0.02, 0.2);
	add_pyramid(&sample, 2, 1, 0.1, 0.02);
	sample_begin(&sample, &plain);
	needle = sample_node(&sample, 0.01, 0.01, 0.2);
	flat = sample_node(&sample, 1.05, 0.05, 0.02);
	cost[0] = collapse_cost(
		&sample.work, needle, sample_node(&sample, 0, 0, 0), INFINITY);
	cost[1] = collapse_cost(
		&sample.work, flat, sample_node(&sample, 1, 0, 0), INFINITY);
	CHECK(cost[0] < cost[1] && cost[1] < 200 * cost[0]);
	run_one(&sample, needle, flat);
	CHECK(sample.work.surfaces.at[1] == 4);
	CHECK(sample.work.surfaces.at[2] == 2);
	run_one(&sample, needle, flat);
	CHECK(sample.work.surfaces.at[1] == 2);
	sample_release(&sample);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_face_that_turns_too_far_at_once_strains),
	CHECK_TEST(faces_that_grow_or_shrink_too_much_strain),
	CHECK_TEST(what_strains_is_done_last),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
