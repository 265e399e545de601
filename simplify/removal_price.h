/*
 * What it costs to take parts away, per collapse that it saves: see removals.h.
 */
#ifndef TESSERA_REMOVAL_PRICE_H
#define TESSERA_REMOVAL_PRICE_H

#include "removals.h"

/* A contact of which both sides are seen, or a surface that is, is worth so
   many times as much. */
#define SEEN_FACTOR 4

/* Of one part, with what is known so far of how far it is and how much of it is
   seen. Fails with TCS_NO_MEMORY. */
enum tcs_status removal_price(struct removals *removals, uint32_t part,
	double *price, struct tcs_fault *fault) TCS_CHECKED;

/* Find out how far a part is from what stays. Fails with TCS_NO_MEMORY,
   TCS_LIMIT. */
enum tcs_status removal_measure(struct removals *removals, uint32_t part,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Of a part and all that would hang in the air without it, which stands in
 * parts.hanging then; INFINITY where that is too much, or nothing would stay
 * around it. Fails with TCS_NO_MEMORY, TCS_LIMIT.
 */
enum tcs_status removal_stack_price(struct removals *removals, uint32_t part,
	double *price, struct tcs_fault *fault) TCS_CHECKED;

#endif
