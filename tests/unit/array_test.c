#include "array.h"

#include <stdint.h>

#include "check.h"

static void
a_lent_array_is_copied_when_it_grows(void)
{
	int lent[3] = {1, 2, 3};
	TCS_ARRAY(int) array = {lent, 3, 0};

	CHECK(!array_grow(&array, 1));
	CHECK(array.at != lent && array.room >= 4 && array.count == 3);
	CHECK(array.at[0] == 1 && array.at[2] == 3);
	array.at[0] = 9;
	CHECK(lent[0] == 1);
	array_release(&array);
	CHECK(!array.at && !array.count && !array.room);
}

static void
a_lent_array_is_never_freed(void)
{
	int lent[1] = {7};
	TCS_ARRAY(int) array = {lent, 1, 0};

	array_clear(&array);
	CHECK(!array.at && !array.count);
	array.at = lent;
	array.count = 1;
	array_release(&array);
	CHECK(lent[0] == 7 && !array.at);
}

static void
room_at_least_doubles_and_clearing_keeps_it(void)
{
	TCS_ARRAY(char) array = {0};
	size_t grown = 0;

	for (int i = 0; i < 10000; i++) {
		size_t room = array.room;

		CHECK(!array_grow(&array, 1));
		grown += array.room != room;
		array.at[array.count++] = 'x';
	}
	CHECK(grown < 15);
	grown = array.room;
	array_clear(&array);
	CHECK(!array.count && array.room == grown);
	array_release(&array);
}

static void
trimming_gives_back_what_is_large(void)
{
	TCS_ARRAY(double) array = {0};

	CHECK(!array_grow(&array, 1000));
	array.count = 1000;
	array_trim(&array);
	CHECK(!array.count && array.room == 1000);
	CHECK(!array_grow(&array, 200000));
	array_trim(&array);
	CHECK(!array.at && !array.count && !array.room);
}

static void
a_size_that_overflows_is_refused(void)
{
	TCS_ARRAY(double) array = {0};

	CHECK(array_grow(&array, SIZE_MAX) == -1);
	CHECK(array_grow(&array, SIZE_MAX / 8) == -1);
	CHECK(!array.at && !array.room);
	CHECK(!array_grow(&array, 1));
	array.count = 1;
	CHECK(array_grow(&array, SIZE_MAX) == -1);
	CHECK(array.count == 1);
	array_release(&array);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_lent_array_is_copied_when_it_grows),
	CHECK_TEST(a_lent_array_is_never_freed),
	CHECK_TEST(room_at_least_doubles_and_clearing_keeps_it),
	CHECK_TEST(trimming_gives_back_what_is_large),
	CHECK_TEST(a_size_that_overflows_is_refused),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
