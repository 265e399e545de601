#include "simplify/contacts.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

#include "check.h"
#include "simplify/vector.h"

/* A box of 12 triangles as a feature of its own. */
static void
add_box(struct component_set *set, uint32_t feature, struct tcs_point low,
	struct tcs_point size)
{
	static const unsigned char corners[12][3] = {{0, 2, 1}, {1, 2, 3},
		{4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3},
		{3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
	struct tcs_fault fault;

	for (int i = 0; i < 12; i++) {
		struct tcs_point at[3];

		for (int k = 0; k < 3; k++) {
			unsigned corner = corners[i][k];

			at[k] = (struct tcs_point){
				low.x + (corner & 1 ? size.x : 0),
				low.y + (corner & 2 ? size.y : 0),
				low.z + (corner & 4 ? size.z : 0)};
		}
		CHECK(!component_set_add(set, at, feature, TCS_NONE, &fault));
	}
}

static const struct tcs_point unit = {1, 1, 1};

/* Two boxes; whether they are in contact, at most 1 cm apart. */
static bool
are_in_contact(struct tcs_point low, struct tcs_point size, bool inside)
{
	struct component_set set = {0};
	struct contact_list contacts = {0};
	struct tcs_fault fault;
	bool found;

	add_box(&set, 1, (struct tcs_point){0, 0, 0}, unit);
	add_box(&set, 2, low, size);
	CHECK(!component_set_build(&set, &fault));
	CHECK(set.components.count == 2);
	CHECK(!contacts_find(&set, 0.01, &contacts, &fault));
	CHECK(contacts.count <= 1);
	found = contacts.count == 1;
	if (found)
		CHECK(contacts.at[0].a == 0 && contacts.at[0].b == 1 &&
			contacts.at[0].inside == inside);
	array_release(&contacts);
	component_set_release(&set);
	return found;
}

static void
boxes_that_touch_are_in_contact(void)
{
	/* Face on face, exactly and partly. */
	CHECK(are_in_contact((struct tcs_point){0.5, 0.25, 1}, unit, false));
	/* Edge on edge, corner on corner, where no point is shared. */
	CHECK(are_in_contact((struct tcs_point){1, 0.3, 1}, unit, false));
	CHECK(are_in_contact((struct tcs_point){1, 1, 1},
		(struct tcs_point){2, 2, 2}, false));
	/* Through each other. */
	CHECK(are_in_contact((struct tcs_point){0.4, 0.4, -1},
		(struct tcs_point){0.2, 0.2, 3}, false));
}

/* Small on large: no edge of one crosses the other. */
static void
a_box_that_rests_on_a_slab_is_in_contact(void)
{
	CHECK(are_in_contact((struct tcs_point){0.4, 0.4, 1},
		(struct tcs_point){0.1, 0.1, 0.1}, false));
	CHECK(are_in_contact((struct tcs_point){-5, -5, -0.2},
		(struct tcs_point){11, 11, 0.2}, false));
}

static void
small_gaps_count_and_five_centimetres_do_not(void)
{
	CHECK(are_in_contact((struct tcs_point){0, 0, 1.009}, unit, false));
	CHECK(!are_in_contact((struct tcs_point){0, 0, 1.011}, unit, false));
	CHECK(!are_in_contact((struct tcs_point){1.05, 0, 0}, unit, false));
	CHECK(!are_in_contact((struct tcs_point){5, 5, 5}, unit, false));
}

static void
a_box_inside_another_is_in_contact(void)
{
	CHECK(are_in_contact((struct tcs_point){0.4, 0.4, 0.4},
		(struct tcs_point){0.2, 0.2, 0.2}, true));
	CHECK(are_in_contact((struct tcs_point){-1, -1, -1},
		(struct tcs_point){3, 3, 3}, true));
}

/* Boxes of the shapes overlap, the shapes do not: an L around a box. */
static void
a_corner_does_not_enclose_what_stands_before_it(void)
{
	struct component_set set = {0};
	struct contact_list contacts = {0};
	struct tcs_fault fault;

	add_box(&set, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){4, 0.2, 4});
	add_box(&set, 1, (struct tcs_point){0, 0.2, 0},
		(struct tcs_point){0.2, 3.8, 4});
	add_box(&set, 2, (struct tcs_point){2, 2, 2}, unit);
	CHECK(!component_set_build(&set, &fault));
	CHECK(set.components.count == 2);
	CHECK(!contacts_find(&set, 0.01, &contacts, &fault));
	CHECK(contacts.count == 0);
	array_release(&contacts);
	component_set_release(&set);
}

static void
what_is_measured_of_a_box_is_exact(void)
{
	struct component_set set = {0};
	struct tcs_fault fault;

	add_box(&set, 1, (struct tcs_point){100, 200, 300},
		(struct tcs_point){2, 3, 4});
	CHECK(!component_set_build(&set, &fault));
	CHECK(set.points.count == 8);
	CHECK(set.components.at[0].closed);
	CHECK(fabs(set.components.at[0].volume - 24) < 1e-9);
	CHECK(fabs(set.components.at[0].area - 52) < 1e-9);
	CHECK(fabs(box_diagonal(&set.bounds) - sqrt(29)) < 1e-9);
	CHECK(contact_reach(&set) == 0.01);
	component_set_clear(&set);
	add_box(&set, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){30, 0, 40});
	CHECK(!component_set_build(&set, &fault));
	CHECK(contact_reach(&set) == 0.05);
	component_set_clear(&set);
	add_box(&set, 1, (struct tcs_point){0, 0, 0},
		(struct tcs_point){300, 0, 400});
	CHECK(!component_set_build(&set, &fault));
	CHECK(contact_reach(&set) == 0.1);
	component_set_release(&set);
}

static void
without_components_there_are_no_contacts(void)
{
	struct component_set set = {0};
	struct contact_list contacts = {0};
	struct tcs_fault fault;

	CHECK(!component_set_build(&set, &fault));
	CHECK(!contacts_find(&set, 0.01, &contacts, &fault));
	CHECK(contacts.count == 0 && set.components.count == 0);
}

/*
 * Rows of boxes, each touching the next in its row, all on one slab: the slab
 * has as many contacts as there are boxes.
 */
static void
a_hundred_thousand_components_take_seconds(void)
{
	enum { SIDE = 316, COUNT = SIDE * SIDE };
	struct component_set set = {0};
	struct contact_list contacts = {0};
	struct tcs_fault fault;
	clock_t began = clock();

	add_box(&set, 0, (struct tcs_point){-1, -1, -1},
		(struct tcs_point){SIDE + 2, 2 * SIDE + 2, 1});
	for (uint32_t i = 0; i < COUNT; i++)
		add_box(&set, i + 1,
			(struct tcs_point){i % SIDE, 2.0 * (i / SIDE), 0},
			unit);
	CHECK(!component_set_build(&set, &fault));
	CHECK(set.components.count == COUNT + 1);
	CHECK(!contacts_find(&set, 0.01, &contacts, &fault));
	CHECK(contacts.count == COUNT + (SIDE - 1) * SIDE);
	CHECK((double)(clock() - began) / CLOCKS_PER_SEC < 60);
	array_release(&contacts);
	component_set_release(&set);
}

static const struct check_test tests[] = {
	CHECK_TEST(boxes_that_touch_are_in_contact),
	CHECK_TEST(a_box_that_rests_on_a_slab_is_in_contact),
	CHECK_TEST(small_gaps_count_and_five_centimetres_do_not),
	CHECK_TEST(a_box_inside_another_is_in_contact),
	CHECK_TEST(a_corner_does_not_enclose_what_stands_before_it),
	CHECK_TEST(what_is_measured_of_a_box_is_exact),
	CHECK_TEST(without_components_there_are_no_contacts),
	CHECK_TEST(a_hundred_thousand_components_take_seconds),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
