#include "parsers/citygml_digests.h"

#include "check.h"

static void
digests_count_what_differs(void)
{
	enum { COUNT = 3000 };
	struct digest_table table = {0};
	struct tcs_fault fault;
	uint32_t number;
	bool added;

	for (uint32_t round = 0; round < 2; round++)
		for (uint32_t i = 0; i < COUNT; i++) {
			CHECK(!digests_add(
				&table, &i, sizeof i, &number, &added, &fault));
			CHECK(number == i && added == !round);
		}
	CHECK(!digests_add(&table, "", 0, &number, &added, &fault));
	CHECK(number == COUNT && added);
	digests_release(&table);
}

static const struct check_test tests[] = {
	CHECK_TEST(digests_count_what_differs),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
