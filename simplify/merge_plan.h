/*
 * What it would be to make some parts one: the prism around them, and which
 * faces and vertices of theirs become it.
 *
 * A prism takes the place of all their faces. Its own are those of one
 * component, for faces and vertices know their component for life; so one of
 * the parts has to have come with as many as it needs.
 */
#ifndef TESSERA_MERGE_PLAN_H
#define TESSERA_MERGE_PLAN_H

#include "merge_groups.h"
#include "prism.h"
#include "removals.h"

/* What is known of a group that was looked at. */
struct merge_known {
	uint32_t parts; /* that were there; 0: nothing is known */
	struct prism prism; /* no sides: there is none */
	double off; /* see merge_off; negative: not known */
	double shape; /* what it costs that it is off, as was last found */
};

/* All zero is empty; reused from group to group. */
struct merge_plan {
	TCS_ARRAY(uint32_t) parts; /* ascending; that are there */
	uint32_t host; /* of them: the one that stays */
	struct prism prism;
	TCS_ARRAY(uint32_t) faces; /* ascending; that are left of them */
	double area; /* square metres, of the parts as they came */
	/* For collapses_refill: */
	uint32_t numbers[PRISM_TRIANGLES];
	uint32_t corners[3 * PRISM_TRIANGLES];
	struct tcs_point places[3 * PRISM_TRIANGLES];
	uint32_t models[PRISM_TRIANGLES];
	TCS_ARRAY(struct tcs_point) points; /* scratch */
	TCS_ARRAY(uint32_t) slots; /* scratch: faces */
	TCS_ARRAY(uint32_t) vertices; /* scratch */
	struct prism_outline outline;
};

/*
 * Plan for a group, of which something may be known; what of its family lies in
 * the prism anyway becomes part of it, too. *fine is false if fewer than two of its parts are there,
 * some face is open, what is left has no more faces than the prism would, or
 * there is no prism or no host. Fails with TCS_NO_MEMORY.
 */
enum tcs_status merge_plan_make(struct merge_plan *plan, struct collapses *work,
	const struct removals *removals, const struct merge_groups *groups,
	uint32_t group, struct merge_known *known, bool *fine,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Plan for parts that are listed, with the axis along which the prism reaches
 * from `low` to `high`, which is all that they reach and more. There may be more
 * faces then than before. *fine is false if a part was drawn out before, some
 * face is open, or there is no prism or no host. Fails with TCS_NO_MEMORY.
 */
enum tcs_status merge_plan_panel(struct merge_plan *plan,
	struct collapses *work, const struct removals *removals,
	const uint32_t *numbers, size_t count, struct tcs_point axis,
	double low, double high, bool *fine,
	struct tcs_fault *fault) TCS_CHECKED;

/* Choose what the triangles of a plan continue, before it is built. */
void merge_plan_choose_models(struct merge_plan *plan,
	const struct collapses *work, const struct parts *parts);

/* What takes the place of what. */
struct refill merge_plan_refill(const struct merge_plan *plan);

void merge_plan_release(struct merge_plan *plan);

#endif
