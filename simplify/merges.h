/*
 * Touching parts of one surface that become one simpler part: the bars and the
 * pane of a window a panel, the treads of a stair a ramp, boards that lie side
 * by side a box. No collapse gets there: a closed part keeps four triangles,
 * and a box needs twelve.
 *
 * What takes their place is a prism around all of them (prism.h), so that its
 * sides lie where their outermost faces did, and what touched them there still
 * does. It costs what its sides and theirs are off, squared, by the area that
 * is seen of them, more where one could look through; and what breaks all the
 * same. They keep the surface they had, and the paint of the largest face that
 * looked the same way.
 *
 * source: aggregation as in N. Regnauld, R. McMaster, A synoptic view of
 * generalisation operators, 2007; groups, prism and cost are ours.
 */
#ifndef TESSERA_MERGES_H
#define TESSERA_MERGES_H

#include "merge_build.h"
#include "merge_price.h"

/* All zero is empty; reused from object to object. */
struct merges {
	struct merge_groups groups;
	TCS_ARRAY(struct merge_known) known; /* per group */
	struct node_queue queue; /* of groups, by their price */
	struct merge_plan plan; /* scratch */
	struct merge_pricing pricing; /* scratch */
	struct merge_builder builder; /* scratch */
	struct component_set *set; /* borrowed: boxes grow */
	struct collapses *work; /* borrowed */
	struct removals *removals; /* borrowed */
	TCS_ARRAY(uint32_t) features; /* see merges_features */
	TCS_ARRAY(struct queue_entry) postponed; /* groups, see merges_aim */
	size_t least; /* faces that have to be left */
	size_t joined; /* parts that are in others now, since set to 0 */
};

/*
 * List the groups of a mesh nothing of which is collapsed, and whose removals
 * have begun; none where the error is watched. The set is that of `work`. Takes
 * as long as merge_groups_find. Fails with TCS_NO_MEMORY.
 */
enum tcs_status merges_find(struct merges *merges, struct component_set *set,
	struct collapses *work, struct removals *removals,
	struct tcs_fault *fault) TCS_CHECKED;

/* So many faces are wanted from now on: nothing is merged that would leave
   clearly less. Fails with TCS_NO_MEMORY. */
enum tcs_status merges_aim(struct merges *merges, size_t target,
	struct tcs_fault *fault) TCS_CHECKED;

/* What the next one costs per collapse that it saves, at least; INFINITY when
   none is left. */
double merges_next_cost(const struct merges *merges);

/*
 * Look closer at the next one: make its parts one if that costs what it seemed
 * to; else it is dearer from then on. Fails with TCS_NO_MEMORY, TCS_SYSTEM.
 */
enum tcs_status merges_try(
	struct merges *merges, struct tcs_fault *fault) TCS_CHECKED;

/* The features whose parts became one, in order, each once. */
size_t merges_features(struct merges *merges, const uint32_t **features);

/* Nothing will be merged any more: give back all but the features. */
void merges_end(struct merges *merges);

void merges_release(struct merges *merges);

#endif
