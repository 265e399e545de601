/*
 * What stands in a hole that is closed comes forward through what closes it, so
 * that a window is still seen in its wall: the parts of one feature, a frame and
 * its panes, become a panel across the hole.
 *
 * A panel is a prism around them, see merge_plan.h, drawn out until it stands
 * out by a centimetre on every side that is closed; what reached farther than
 * another panel in the same hole does so by one more.
 *
 * source: ours; in cartography that is exaggeration (R. McMaster, K. Shea,
 * Generalization in digital cartography, 1992).
 */
#ifndef TESSERA_PANELS_H
#define TESSERA_PANELS_H

#include "merge_build.h"
#include "rims.h"

struct panel {
	uint32_t first, count; /* of `parts` */
	bool fine; /* it can be built */
	double low, high; /* metres along the way across the hole: the parts, */
	double to_low, to_high; /* and the panel */
	double cost; /* square metres times area: what is seen is off */
	double faces; /* that there will be more, or less */
};

/* All zero is empty; reused from hole to hole. */
struct panels {
	TCS_ARRAY(struct panel) at;
	TCS_ARRAY(uint32_t) parts; /* feature by feature */
	size_t made; /* since it was set to 0 */
	struct tcs_point way; /* of length 1 */
	TCS_ARRAY(double) levels; /* scratch */
	struct merge_plan plan; /* scratch */
	struct merge_builder builder; /* scratch */
};

/*
 * Plan panels for some of the parts that stand in a hole with these rims: those
 * of features of which something is seen. Fails with TCS_NO_MEMORY.
 */
enum tcs_status panels_plan(struct panels *panels, struct collapses *work,
	const struct removals *removals, const struct rims *rims,
	const uint32_t *numbers, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Build those that can be; the parts of the others are not seen any more. The
 * set is that of `work`, its boxes grow. Fails with TCS_NO_MEMORY.
 */
enum tcs_status panels_build(struct panels *panels, struct component_set *set,
	struct collapses *work, struct removals *removals,
	struct tcs_fault *fault) TCS_CHECKED;

void panels_release(struct panels *panels);

#endif
