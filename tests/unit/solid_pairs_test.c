/* Booleans of many pairs of solids, as bytes that look random make them. */
#include "solid_pairs.h"

#include <stdio.h>

enum { PAIRS = 1500, BYTES = 64 };

static void
what_must_hold_of_pairs_holds(void)
{
	struct solid_cutter *cutter = solid_cutter_new();
	uint64_t state = 1;

	for (int i = 0; i < PAIRS; i++) {
		uint8_t bytes[BYTES];
		struct solid_pair pair;
		const char *wrong;

		for (int j = 0; j < BYTES; j++)
			bytes[j] = (uint8_t)shape_random(&state);
		pair = pair_read(bytes, BYTES);
		wrong = pair_check(cutter, &pair);
		CHECK(!wrong);
		if (wrong)
			fprintf(stderr, "pair %d: %s\n", i, wrong);
		pair_release(&pair);
	}
	solid_cutter_free(cutter);
}

static const struct check_test tests[] = {
	CHECK_TEST(what_must_hold_of_pairs_holds),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
