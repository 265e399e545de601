/*
 * Whether two triangles cross: whether an edge of one passes through the inside
 * of the other, and both its ends are more than a tenth of a millimetre off, as
 * is the place from the other's edges. So what only touches, ends in the other,
 * or lies in its plane, does not cross it, nor does what rounding moved through
 * it.
 *
 * source: C. Ericson, Real-Time Collision Detection, 2005, 5.2.10.
 */
#ifndef TESSERA_CROSSING_H
#define TESSERA_CROSSING_H

#include "triangle_shape.h"

#define CROSSING_DEPTH 1e-4 /* metres */

bool triangles_cross(
	const struct triangle_shape *a, const struct triangle_shape *b);

/* The same, for who has the normal of the first, of length 1. */
bool triangles_cross_along(const struct triangle_shape *a,
	struct tcs_point normal, const struct triangle_shape *b);

#endif
