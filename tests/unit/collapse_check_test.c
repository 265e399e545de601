/* Which collapses may not be done, rule by rule. */
#include "check.h"
#include "collapse_sample.h"
#include <math.h>

static const struct collapse_settings plain = {
	.base_ratio = 2, .contact_cost = INFINITY};

static bool
may(struct collapse_sample *sample, struct tcs_point from, struct tcs_point to)
{
	uint32_t node = sample_node(sample, from.x, from.y, from.z);
	uint32_t target = sample_node(sample, to.x, to.y, to.z);
	struct tcs_fault fault;
	bool fine;

	CHECK(node != TCS_NONE && target != TCS_NONE);
	CHECK(!collapse_check(&sample->work, node, target, &fine, &fault));
	return fine;
}

/* A fan about `centre` over a level ring of six points, one of which is pulled
   in so far that the rest cannot be seen from it. */
static void
add_dented_fan(struct collapse_sample *sample)
{
	static const struct tcs_point ring[6] = {{2, 0, 0}, {2, 4, 0},
		{-2, 4, 0}, {-2, 0, 0}, {-0.5, 1.5, 0}, {0.5, 1.5, 0}};

	for (int i = 0; i < 6; i++)
		sample_add(sample, 1, (struct tcs_point){0, 2, 0}, ring[i],
			ring[(i + 1) % 6]);
	sample_begin(sample, &plain);
}

/* L4: the normal. */
static void
a_face_may_not_turn_over(void)
{
	struct collapse_sample sample = {0};

	add_dented_fan(&sample);
	CHECK(may(&sample, (struct tcs_point){0, 2, 0},
		(struct tcs_point){0.5, 1.5, 0}));
	CHECK(!may(&sample, (struct tcs_point){0, 2, 0},
		(struct tcs_point){2, 0, 0}));
	sample_release(&sample);
}

/* L4: the area. A ring vertex in line with two others would leave a face
   without any. */
static void
a_face_may_not_become_a_sliver(void)
{
	static const struct tcs_point ring[5] = {
		{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}};
	struct collapse_sample sample = {0};

	for (int i = 0; i < 5; i++)
		sample_add(&sample, 1, (struct tcs_point){2, 1, 0}, ring[i],
			ring[(i + 1) % 5]);
	sample_begin(&sample, &plain);
	CHECK(may(&sample, (struct tcs_point){2, 1, 0},
		(struct tcs_point){2, 0, 0}));
	CHECK(!may(&sample, (struct tcs_point){2, 1, 0},
		(struct tcs_point){0, 0, 0}));
	sample_release(&sample);
}

/* The link condition: a tube of three sides would close in its middle. */
static void
a_tube_may_not_be_pinched(void)
{
	static const struct tcs_point around[3] = {
		{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
	struct collapse_sample sample = {0};

	for (int z = 0; z < 3; z++)
		for (int i = 0; i < 3; i++) {
			struct tcs_point a = around[i];
			struct tcs_point b = around[(i + 1) % 3];

			sample_add_quad(&sample, 1,
				(struct tcs_point){a.x, a.y, z},
				(struct tcs_point){b.x, b.y, z},
				(struct tcs_point){b.x, b.y, z + 1},
				(struct tcs_point){a.x, a.y, z + 1});
		}
	sample_begin(&sample, &plain);
	CHECK(!may(&sample, (struct tcs_point){0, 0, 1},
		(struct tcs_point){1, 0, 1}));
	sample_release(&sample);
}

/* Two boxes that touch with a side: its corners hold the contact. */
static void
a_seam_holds(void)
{
	struct collapse_sample sample = {0};

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){1, 1, 1});
	sample_add_box(&sample, 2, (struct tcs_point){1, 0.25, 0.25},
		(struct tcs_point){2, 0.5, 0.5});
	sample_begin(&sample, &plain);
	CHECK(sample.contacts.count == 1);
	CHECK(!may(&sample, (struct tcs_point){1, 0.25, 0.25},
		(struct tcs_point){3, 0.25, 0.25}));
	sample_release(&sample);
	/* The same where nothing is touched. */
	sample_add_box(&sample, 2, (struct tcs_point){1, 0.25, 0.25},
		(struct tcs_point){2, 0.5, 0.5});
	sample_begin(&sample, &plain);
	CHECK(may(&sample, (struct tcs_point){1, 0.25, 0.25},
		(struct tcs_point){3, 0.25, 0.25}));
	sample_release(&sample);
}

/* Two boxes that share a side of half a meter: of its four corners and what
   lies between one may go, and its contact is ajar then. */
static void
what_a_contact_costs_is_counted(void)
{
	const struct collapse_settings priced = {
		.base_ratio = 2, .contact_cost = 1};
	struct collapse_sample sample = {0};

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){1, 1, 1});
	sample_add_box(&sample, 2, (struct tcs_point){1, 0.25, 0.25},
		(struct tcs_point){2, 0.5, 0.5});
	sample_begin(&sample, &priced);
	CHECK(may(&sample, (struct tcs_point){1, 0.25, 0.25},
		(struct tcs_point){3, 0.25, 0.25}));
	CHECK(fabs(sample.work.broken - SEAM_HALF_OPEN) < 1e-12);
	CHECK(may(&sample, (struct tcs_point){3, 0.25, 0.25},
		(struct tcs_point){1, 0.25, 0.25}));
	CHECK(!(sample.work.broken > 0));
	sample_release(&sample);
}

/* A gable that stands on a slab becomes a triangle with its base, and one
   without, once it is known what the contact is worth. */
static void
a_contact_breaks_for_its_price(void)
{
	static const struct tcs_point gable[5] = {
		{0, 4, 0}, {8, 4, 0}, {8, 4, 3}, {4, 4, 6}, {0, 4, 3}};
	const struct collapse_settings priced = {
		.base_ratio = 2, .contact_cost = 1e4};
	struct collapse_sample sample = {0};
	const struct seam_count *count;
	struct tcs_fault fault;

	sample_add_box(&sample, 1, (struct tcs_point){0, 0, -1},
		(struct tcs_point){8, 8, 1});
	for (int i = 1; i < 4; i++)
		sample_add(&sample, 2, gable[0], gable[i], gable[i + 1]);
	sample_begin(&sample, &priced);
	CHECK(sample.seams.counts.count == 1);
	count = &sample.seams.counts.at[0];
	sample_run(&sample, 0);
	CHECK(sample.work.wants_worths);
	CHECK(seam_broken(count, count->open) < 0.1);
	CHECK(!array_grow(&sample.work.worths, 1));
	sample.work.worths.at[sample.work.worths.count++] = 4;
	CHECK(!collapses_run(&sample.work, 0, 1.2e4, &fault));
	CHECK(seam_broken(count, count->open) < 0.1);
	sample_run(&sample, 0);
	CHECK(seam_broken(count, count->open) > 0.3);
	CHECK(count->open < count->points);
	sample_release(&sample);
}

/* A quarter of a square is a surface of its own, and goes with two of the four
   edges of the middle. */
static void
every_surface_keeps_a_face(void)
{
	static const struct tcs_point ring[4] = {
		{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
	struct collapse_sample sample = {0};

	for (int i = 0; i < 4; i++)
		sample_add(&sample, i == 0 ? 2 : 1, (struct tcs_point){1, 1, 0},
			ring[i], ring[(i + 1) % 4]);
	sample_begin(&sample, &plain);
	CHECK(!may(&sample, (struct tcs_point){1, 1, 0},
		(struct tcs_point){0, 0, 0}));
	CHECK(may(&sample, (struct tcs_point){1, 1, 0},
		(struct tcs_point){2, 2, 0}));
	sample.work.settings.contact_cost = 0;
	CHECK(may(&sample, (struct tcs_point){1, 1, 0},
		(struct tcs_point){0, 0, 0}));
	sample_release(&sample);
}

/* A square that is there twice, cut along one diagonal and along the other. */
static void
no_face_may_become_the_same_as_another(void)
{
	static const struct tcs_point ring[4] = {
		{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

	for (int twice = 0; twice < 2; twice++) {
		struct collapse_sample sample = {0};

		sample_add_quad(&sample, 1, ring[0], ring[1], ring[2], ring[3]);
		if (twice)
			sample_add_quad(
				&sample, 1, ring[1], ring[2], ring[3], ring[0]);
		sample_begin(&sample, &plain);
		CHECK(may(&sample, ring[1], ring[0]) == !twice);
		sample_release(&sample);
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(a_face_may_not_turn_over),
	CHECK_TEST(a_face_may_not_become_a_sliver),
	CHECK_TEST(a_tube_may_not_be_pinched),
	CHECK_TEST(a_seam_holds),
	CHECK_TEST(what_a_contact_costs_is_counted),
	CHECK_TEST(a_contact_breaks_for_its_price),
	CHECK_TEST(every_surface_keeps_a_face),
	CHECK_TEST(no_face_may_become_the_same_as_another),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
