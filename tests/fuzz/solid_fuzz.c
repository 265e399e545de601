/*
 * Booleans of two solids that nearly coincide: closed whatever they are, and
 * with the volumes that they must have where the solids are sound.
 */
#include "solid_pairs.h"

#include <stdio.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	struct solid_cutter *cutter = solid_cutter_new();
	struct solid_pair pair = pair_read(bytes, size);
	const char *wrong = cutter ? pair_check(cutter, &pair) : NULL;

	if (wrong) {
		fprintf(stderr, "%s\n", wrong);
		abort();
	}
	pair_release(&pair);
	solid_cutter_free(cutter);
	return 0;
}
