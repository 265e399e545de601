/*
 * The prism that was planned for some parts takes their place.
 */
#ifndef TESSERA_MERGE_BUILD_H
#define TESSERA_MERGE_BUILD_H

#include "merge_plan.h"

/* Scratch; all zero is empty. */
struct merge_builder {
	TCS_ARRAY(uint32_t) components; /* of the parts */
};

/*
 * Build it: the parts are one, the plan's host, and covered by it (parts.h,
 * cover_watch.h). The set is that of `work`; a component's box grows. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status merge_build(struct merge_builder *builder,
	struct merge_plan *plan, struct component_set *set,
	struct collapses *work, struct removals *removals,
	struct tcs_fault *fault) TCS_CHECKED;

void merge_builder_release(struct merge_builder *builder);

#endif
