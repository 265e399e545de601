/*
 * How far one surface lies from another, one way: from every point of the
 * first to the nearest of the second. Metres.
 */
#ifndef TESSERA_COMPARE_DISTANCE_H
#define TESSERA_COMPARE_DISTANCE_H

#include "compare_side.h"

/*
 * `max` is reached at a point; no point is farther than `at_most`. Mean and
 * root mean square are over the area, from the centres of equal pieces into
 * which each triangle is cut so that they lie about `spacing` apart.
 */
struct surface_distance {
	double max, at_most, mean, rms, spacing;
};

/*
 * The bound uses that the distance to one triangle is convex: over a piece it
 * is largest at a corner. Pieces are cut in four until both are within
 * `tolerance`, or 8 times. INFINITY where one side is empty.
 */
struct surface_distance surface_distance_measure(
	const struct compare_side *from, const struct compare_side *to,
	double tolerance);

#endif
