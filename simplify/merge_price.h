/*
 * What it costs to make parts one: see merges.h.
 */
#ifndef TESSERA_MERGE_PRICE_H
#define TESSERA_MERGE_PRICE_H

#include "merge_plan.h"

/* All zero is empty; reused from object to object. */
struct merge_pricing {
	/* Per face: as much of it as another part did not hide before its own
	   one was merged; per part: what its shape has cost so far. */
	TCS_ARRAY(float) exposed;
	TCS_ARRAY(double) paid;
	TCS_ARRAY(uint32_t) swallowed; /* scratch: contacts, one per point */
};

/* Begin: nothing is merged. Fails with TCS_NO_MEMORY. */
enum tcs_status merge_pricing_begin(struct merge_pricing *pricing,
	const struct removals *removals, struct tcs_fault *fault) TCS_CHECKED;

/* How far the shape is off, square metres times area, if all of it is seen: it
   does not change while the parts are the same. Fails with TCS_NO_MEMORY,
   TCS_LIMIT. */
enum tcs_status merge_off(const struct merge_plan *plan,
	struct merge_pricing *pricing, struct removals *removals, double *off,
	struct tcs_fault *fault) TCS_CHECKED;

/* How much of the parts is seen, or counts as if it were: at least that where
   nobody has looked yet. */
double merge_seen_share(
	const struct merge_plan *plan, const struct removals *removals);

/* What the parts have cost so far is no more to be paid. */
double merge_paid(
	const struct merge_plan *plan, const struct merge_pricing *pricing);

/*
 * What breaks, in contacts: those with others whose points stand deep in the
 * prism, and what it comes to cross. *fine is false where it
 * must not be there. Fails with TCS_NO_MEMORY.
 */
enum tcs_status merge_harm(const struct merge_plan *plan,
	struct merge_pricing *pricing, struct removals *removals, double *harm,
	bool *fine, struct tcs_fault *fault) TCS_CHECKED;

/* How many square metres of its outlines one could look through before. */
double merge_open_area(
	const struct merge_plan *plan, const struct removals *removals);

void merge_pricing_release(struct merge_pricing *pricing);

#endif
