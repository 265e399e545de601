/*
 * One boolean under way, for the files that carry it out.
 */
#ifndef TESSERA_SOLID_CUTTER_H
#define TESSERA_SOLID_CUTTER_H

#include "solid.h"
#include "solid_inside.h"
#include "solid_outline.h"

struct solid_box {
	struct tcs_point lower, upper;
};

/* What is known of a tool before the cut. */
struct solid_tool_state {
	struct solid_box box;
	double volume; /* positive */
	bool turned, used;
};

struct solid_cutter {
	struct solid_carver carver;
	struct solid_inside inside;
	struct solid_outline outline;
	struct solid_points edge_points;
	TCS_ARRAY(struct solid_tool_state) tools;
	struct solid_numbers half_spaces; /* of each: its plane, and 1 where
	                                     the plane's normal is its own */
	/* Of the task under way: */
	const struct solid_task *task;
	double tolerance;
	struct tcs_point origin;
	struct solid_measure host;
	double tool_volume; /* of all tools that are used */
};

/* The box of all that can be part of the result, with some room around it,
 * relative to cutter->origin, which is chosen. */
struct solid_box solid_cutter_box(struct solid_cutter *cutter);

/*
 * Measure the operands of cutter->task, count and note the tools' faults, and
 * leave out tools that cannot reach the host. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_operands_measure(struct solid_cutter *cutter,
	struct solid_report *report, enum solid_tool_fault *tool_faults,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Give the host's faces, the only pieces so far, limits along their edges that
 * no other face meets: pieces of no solid, which stand on them. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status solid_limits_add(
	struct solid_cutter *cutter, struct tcs_fault *fault) TCS_CHECKED;

/* Write what the cells make of the task. Fails with TCS_NO_MEMORY. */
enum tcs_status solid_result_write(struct solid_cutter *cutter,
	struct solid *out, struct tcs_fault *fault) TCS_CHECKED;

#endif
