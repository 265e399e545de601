/*
 * Where two components touch, and how much of that gapes when they are
 * simplified.
 */
#ifndef TESSERA_COMPARE_SEAM_H
#define TESSERA_COMPARE_SEAM_H

#include "compare_match.h"

/*
 * Whether a quarter of the seam or more gapes over 2 eps. The seam is known by
 * its points: of every triangle of one side that is within eps of the other,
 * where it is nearest, and its corners, middles of edges and centre as far as
 * they are within eps; of a hundred triangles, evenly chosen, where there are
 * more. A point gapes when, from where either side is nearest to it after, the
 * other is more than 2 eps away and does not enclose it: closed components are
 * full, and a side that became part of one is all of it, unless both did; then
 * they gape where that component is neither within 2 eps nor around the point.
 * Takes some log n steps for each triangle of one side in the box of the other.
 */
bool seam_is_half_open(const struct compare_side *before,
	const struct compare_side *after, const struct compare_match *match,
	const struct contact *contact, double eps);

/*
 * Whether no point of the component has moved by more than `far`: each of its
 * triangles lies as near as that to a single triangle of its images. May be
 * false for what has not moved, where it was triangulated anew.
 */
bool component_is_still(const struct compare_side *before, uint32_t component,
	const struct compare_side *after, const struct compare_match *match,
	double far);

#endif
