#include "simplify/removals.h"
#include <math.h>

#include "collapse_sample.h"

static const struct collapse_settings settings = {
	.base_ratio = 2, .contact_cost = INFINITY};

static void
begin(struct collapse_sample *sample, struct removals *removals)
{
	struct tcs_fault fault;

	sample_begin(sample, &settings);
	CHECK(!removals_begin(removals, &sample->work, &sample->contacts,
		contact_reach(&sample->set), false, &fault));
}

static void
end(struct collapse_sample *sample, struct removals *removals)
{
	removals_release(removals);
	sample_release(sample);
}

/* The part of the box that was added with a feature; TCS_NONE. */
static uint32_t
part_of(const struct collapse_sample *sample, const struct removals *removals,
	uint32_t feature)
{
	for (size_t i = 0; i < sample->work.features.count; i++)
		if (sample->work.features.at[i] == feature)
			return removals->parts.numbers.at[i];
	return TCS_NONE;
}

static bool
take_away(const struct collapse_sample *sample, struct removals *removals,
	uint32_t feature)
{
	struct tcs_fault fault;
	bool gone;

	CHECK(!parts_take_away(&removals->parts,
		part_of(sample, removals, feature), &gone, &fault));
	return gone;
}

enum { LEG, OTHER_LEG, TOP, VASE };

/* A top on legs, and a vase on it, all 1 m high and touching. */
static void
add_table(struct collapse_sample *sample, double z, bool other_leg)
{
	sample_add_box(sample, LEG, (struct tcs_point){0, 0, z},
		(struct tcs_point){1, 1, 1});
	if (other_leg)
		sample_add_box(sample, OTHER_LEG, (struct tcs_point){9, 0, z},
			(struct tcs_point){1, 1, 1});
	sample_add_box(sample, TOP, (struct tcs_point){-1, -1, z + 1},
		(struct tcs_point){12, 3, 1});
	sample_add_box(sample, VASE, (struct tcs_point){4, 0, z + 2},
		(struct tcs_point){0.5, 0.5, 1});
}

static void
what_carries_stays(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};

	add_table(&sample, 0, false);
	begin(&sample, &removals);
	CHECK(removals.parts.count == 3);
	CHECK(!take_away(&sample, &removals, LEG));
	CHECK(!take_away(&sample, &removals, TOP));
	CHECK(take_away(&sample, &removals, VASE));
	CHECK(!take_away(&sample, &removals, LEG));
	CHECK(take_away(&sample, &removals, TOP));
	CHECK(take_away(&sample, &removals, LEG));
	end(&sample, &removals);
}

static void
one_of_two_legs_goes(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};

	add_table(&sample, 0, true);
	begin(&sample, &removals);
	CHECK(take_away(&sample, &removals, LEG));
	CHECK(!take_away(&sample, &removals, OTHER_LEG));
	CHECK(!take_away(&sample, &removals, TOP));
	end(&sample, &removals);
}

/* Two in the air are no better off, but must not come apart. */
static void
what_hangs_together(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};

	sample_add_box(&sample, LEG, (struct tcs_point){100, 0, 0},
		(struct tcs_point){1, 1, 1});
	add_table(&sample, 50, false);
	begin(&sample, &removals);
	CHECK(!take_away(&sample, &removals, TOP));
	CHECK(take_away(&sample, &removals, VASE));
	end(&sample, &removals);
}

/* How many would hang in the air without a part, itself among them. */
static size_t
count_hanging(const struct collapse_sample *sample, struct removals *removals,
	uint32_t feature)
{
	struct tcs_fault fault;
	uint32_t part = part_of(sample, removals, feature);

	CHECK(!parts_find_hanging(&removals->parts, part, &fault));
	CHECK(removals->parts.hanging.at[0] == part);
	CHECK(parts_hangs(&removals->parts, part));
	return removals->parts.hanging.count;
}

static void
what_hangs_without_a_part_is_known(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};

	add_table(&sample, 0, true);
	begin(&sample, &removals);
	CHECK(count_hanging(&sample, &removals, LEG) == 1);
	CHECK(count_hanging(&sample, &removals, TOP) == 2);
	CHECK(parts_hangs(&removals.parts, part_of(&sample, &removals, VASE)));
	CHECK(!parts_hangs(
		&removals.parts, part_of(&sample, &removals, OTHER_LEG)));
	CHECK(take_away(&sample, &removals, OTHER_LEG));
	CHECK(count_hanging(&sample, &removals, LEG) == 3);
	end(&sample, &removals);
}

/* A flat foot costs hardly anything, but carries what is large: both are cheaper
   by the triangle than the large one alone. */
static void
what_stands_on_a_part_goes_with_it(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};
	struct tcs_fault fault;

	sample_add_box(&sample, TOP, (struct tcs_point){0, 0, 0},
		(struct tcs_point){20, 20, 1});
	sample_add_box(&sample, LEG, (struct tcs_point){9.5, 9.5, 1},
		(struct tcs_point){1, 1, 0.1});
	sample_add_box(&sample, VASE, (struct tcs_point){8, 8, 1.1},
		(struct tcs_point){4, 4, 4});
	begin(&sample, &removals);
	while (sample.work.face_count == 36 &&
		removals_next_cost(&removals) < INFINITY)
		CHECK(!removals_try(&removals, &fault));
	CHECK(sample.work.face_count == 12);
	CHECK(sample_has(&sample, 20, 20, 1));
	end(&sample, &removals);
}

static void
try_all(struct removals *removals)
{
	struct tcs_fault fault;

	while (removals_next_cost(removals) < INFINITY)
		CHECK(!removals_try(removals, &fault));
}

/* However far it goes, the last one stays. */
static void
something_stays(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};

	add_table(&sample, 0, true);
	begin(&sample, &removals);
	try_all(&removals);
	CHECK(sample.work.face_count == 12);
	end(&sample, &removals);
}

/* What lies in a closed box is not seen, and goes first, but for what would
   hang in the air. */
static void
the_hidden_go_first(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};
	struct tcs_fault fault;

	sample_add_box(&sample, TOP, (struct tcs_point){0, 0, 0},
		(struct tcs_point){10, 10, 10});
	sample_add_box(&sample, LEG, (struct tcs_point){4, 4, 0},
		(struct tcs_point){1, 1, 0.5});
	sample_add_box(&sample, VASE, (struct tcs_point){4, 4, 10},
		(struct tcs_point){1, 1, 0.5});
	begin(&sample, &removals);
	while (sample.work.face_count == 36 &&
		removals_next_cost(&removals) < INFINITY)
		CHECK(!removals_try(&removals, &fault));
	CHECK(sample.work.face_count == 24);
	CHECK(!sample_has(&sample, 4, 4, 0.5));
	CHECK(sample_has(&sample, 4, 4, 10.5));
	end(&sample, &removals);
}

static double
cost_of(const struct collapse_sample *sample, struct tcs_point from,
	struct tcs_point to)
{
	return collapse_cost(&sample->work,
		sample_node(sample, from.x, from.y, from.z),
		sample_node(sample, to.x, to.y, to.z), INFINITY);
}

/* What lies in a closed box loses its shape at half the price. */
static void
the_shape_of_the_hidden_costs_less(void)
{
	const struct tcs_point low = {0, 0, 10}, high = {10, 0, 10};
	const struct tcs_point in = {4, 4, 1.5}, beside = {5, 4, 1.5};
	struct collapse_sample sample = {0};
	struct removals removals = {0};
	struct tcs_fault fault;
	double seen, hidden;

	sample_add_box(&sample, TOP, (struct tcs_point){0, 0, 0},
		(struct tcs_point){10, 10, 10});
	sample_add_box(&sample, LEG, (struct tcs_point){4, 4, 1},
		(struct tcs_point){1, 1, 0.5});
	begin(&sample, &removals);
	seen = cost_of(&sample, low, high);
	hidden = cost_of(&sample, in, beside);
	CHECK(hidden > 0);
	CHECK(!removals_look(&removals, &fault));
	CHECK(fabs(cost_of(&sample, low, high) - seen) < 1e-9 * seen);
	CHECK(fabs(cost_of(&sample, in, beside) - hidden / 2) < 1e-6 * hidden);
	end(&sample, &removals);
}

/* The contacts of what is gone are open, and hold nobody back. */
static void
seams_come_open(void)
{
	struct collapse_sample sample = {0};
	struct removals removals = {0};
	const struct seam_count *count;
	struct tcs_fault fault;

	sample_add_box(&sample, LEG, (struct tcs_point){0, 0, 0},
		(struct tcs_point){9, 9, 1});
	sample_add_box(&sample, VASE, (struct tcs_point){4, 4, 1},
		(struct tcs_point){1, 1, 1});
	begin(&sample, &removals);
	CHECK(sample.seams.counts.count == 1);
	while (sample.work.face_count == 24)
		CHECK(!removals_try(&removals, &fault));
	count = &sample.seams.counts.at[0];
	CHECK(count->points > 0);
	CHECK(count->open == count->points);
	CHECK(!sample_has(&sample, 4, 4, 2));
	end(&sample, &removals);
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(what_carries_stays),
		CHECK_TEST(one_of_two_legs_goes),
		CHECK_TEST(what_hangs_together),
		CHECK_TEST(what_hangs_without_a_part_is_known),
		CHECK_TEST(what_stands_on_a_part_goes_with_it),
		CHECK_TEST(something_stays),
		CHECK_TEST(the_hidden_go_first),
		CHECK_TEST(the_shape_of_the_hidden_costs_less),
		CHECK_TEST(seams_come_open),
		{0},
	};

	return check_run(tests);
}
