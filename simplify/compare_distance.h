/*
 * How far one surface lies from another, one way: from every point of the
 * first to the nearest of the second. Metres.
 */
#ifndef TESSERA_COMPARE_DISTANCE_H
#define TESSERA_COMPARE_DISTANCE_H

#include "compare_side.h"

/*
 * `max` is reached at a point; no point is farther than `at_most`. Mean and
 * root mean square are over the area, from points spread evenly over each
 * triangle, one for every square of `spacing` and at least one.
 */
struct surface_distance {
	double max, at_most, mean, rms, spacing;
};

/*
 * The bound uses that the distance to one triangle is convex: over a piece it
 * is largest at a corner. Pieces are cut along the edges of the triangle
 * nearest to their middle, or in half, the worst first, until both are
 * within `tolerance`, but no more than 40,000 times for a thousand triangles.
 * INFINITY where one side is empty. Uses from->set.jobs threads, with the same
 * result for any number. Fails with TCS_NO_MEMORY, TCS_SYSTEM.
 */
enum tcs_status surface_distance_measure(const struct compare_side *from,
	const struct compare_side *to, double tolerance,
	struct surface_distance *out, struct tcs_fault *fault) TCS_CHECKED;

#endif
