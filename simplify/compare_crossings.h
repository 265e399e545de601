/*
 * Which triangles and which components of one side of a comparison go through
 * each other, see crossing.h.
 */
#ifndef TESSERA_COMPARE_CROSSINGS_H
#define TESSERA_COMPARE_CROSSINGS_H

#include "compare_match.h"

/* Two components that cross, a < b, and a triangle of each that do. */
struct crossing_pair {
	uint32_t a, b;
	uint32_t triangles[2];
};

/* All zero is empty. */
struct crossings {
	size_t own; /* pairs of triangles of one component */
	TCS_ARRAY(struct crossing_pair) pairs; /* by a, then b */
};

/*
 * Find them, on set->jobs threads with the same result for any number. Takes
 * n log n steps for n triangles, and a few for every pair whose boxes meet.
 * Fails with TCS_NO_MEMORY, TCS_SYSTEM.
 */
enum tcs_status crossings_find(const struct component_set *set,
	struct crossings *crossings, struct tcs_fault *fault) TCS_CHECKED;

/* How many pairs after come from components that did not cross before. */
size_t crossings_count_new(const struct crossings *before,
	const struct crossings *after, const struct compare_match *match);

void crossings_release(struct crossings *crossings);

#endif
