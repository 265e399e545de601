/*
 * Welding: equal positions are one point. Equal is bit for bit, but -0 is 0.
 *
 * source: W, segmentation (Wang et al. 2021, ISPRS IJGI 10, 422).
 */
#ifndef TESSERA_WELD_H
#define TESSERA_WELD_H

#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "tcs.h"

/* Which points there are. All zero is none. */
struct weld {
	/* Each names a point, plus one; 0 is free. A power of two of them. */
	TCS_ARRAY(uint32_t) slots;
};

/*
 * The number of the point that is equal to one, of `count` distinct points all
 * of which were found so before; `count` where it is new, and the caller puts
 * it behind them. All finite, fewer than 2³¹ of them. Takes a step on the
 * average. Fails with TCS_NO_MEMORY.
 */
enum tcs_status weld_find(struct weld *weld, const struct tcs_point *points,
	size_t count, const struct tcs_point *point, uint32_t *number,
	struct tcs_fault *fault) TCS_CHECKED;

/* No point is there; the room is kept unless it is much. */
void weld_clear(struct weld *weld);

void weld_release(struct weld *weld);

#endif
