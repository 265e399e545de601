/*
 * What is said of a level of one object: whether it is what was asked for, which
 * surfaces have no triangle left, and what was done to get there.
 */
#ifndef TESSERA_LEVEL_REPORT_H
#define TESSERA_LEVEL_REPORT_H

#include "object_simplifier.h"

/* `target` is how many triangles were wanted. Fails with TCS_NO_MEMORY. */
enum tcs_status level_report(const struct object_simplifier *simplifier,
	const struct tcs_object *in, const struct simplify_level *level,
	size_t target, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* What happened on the way to it: holes that were closed, parts that were
   merged. It is forgotten then. Fails with TCS_NO_MEMORY. */
enum tcs_status level_report_work(struct object_simplifier *simplifier,
	const struct tcs_object *in, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* Whether every triangle that is not collapsed is as it came. */
bool level_is_unchanged(const struct object_simplifier *simplifier);

#endif
