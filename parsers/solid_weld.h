/*
 * Points that are less than a tolerance apart as one.
 */
#ifndef TESSERA_SOLID_WELD_H
#define TESSERA_SOLID_WELD_H

#include "solid_pieces.h"

/* All zero is empty. */
struct solid_weld {
	struct solid_point_list points;
	struct solid_numbers slots; /* first point in it + 1, or 0 */
	struct solid_numbers next; /* of each point: next in the slot, + 1 */
	double tolerance;
};

/* `count` is about how many points there will be. Fails with TCS_NO_MEMORY. */
enum tcs_status solid_weld_begin(struct solid_weld *weld, double tolerance,
	size_t count, struct tcs_fault *fault) TCS_CHECKED;

/* The number of the nearest point within the tolerance; of a new one where
 * there is none. Fails with TCS_NO_MEMORY. */
enum tcs_status solid_weld_add(struct solid_weld *weld, struct tcs_point point,
	uint32_t *number, struct tcs_fault *fault) TCS_CHECKED;

void solid_weld_release(struct solid_weld *weld);

#endif
