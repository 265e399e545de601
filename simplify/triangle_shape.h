/*
 * Distances between points, segments and triangles in space, in the unit of
 * the coordinates. Triangles may be degenerate: they are then the segment or
 * the point that is left of them. Coordinates should be local: what is lost to
 * rounding is a few units of the last place of the largest coordinate.
 *
 * source: C. Ericson, Real-Time Collision Detection, 2005, 5.1.5 and 5.1.9.
 */
#ifndef TESSERA_TRIANGLE_SHAPE_H
#define TESSERA_TRIANGLE_SHAPE_H

#include <stdbool.h>

#include "vector.h"

struct triangle_shape {
	struct tcs_point corner[3];
};

/* The point of the triangle that is nearest to `point`. */
struct tcs_point triangle_nearest(
	const struct triangle_shape *triangle, struct tcs_point point);

/* The same, for who has the triangle's normal already, of any length. */
struct tcs_point triangle_nearest_along(const struct triangle_shape *triangle,
	struct tcs_point normal, struct tcs_point point);

/* The points of two segments that are nearest to each other; their distance. */
double segment_gap(const struct tcs_point a[2], const struct tcs_point b[2],
	struct tcs_point out[2]);

/*
 * The points of two triangles that are nearest to each other, out[0] on the
 * first; their distance, 0 where they intersect.
 */
double triangle_gap(const struct triangle_shape *a,
	const struct triangle_shape *b, struct tcs_point out[2]);

/* Whether the segment passes through the triangle from one side to the other,
   and where. A segment that only touches, or lies in the plane, does not. */
bool triangle_pierced(const struct triangle_shape *triangle,
	const struct tcs_point segment[2], struct tcs_point *at);

/* Whether the point, projected on the triangle's plane, lies in the triangle;
   `normal` is its normal, of any length. */
bool triangle_is_above(const struct triangle_shape *triangle,
	struct tcs_point normal, struct tcs_point point);

/*
 * Where origin + t · direction meets the triangle. *margin is how far inside
 * the triangle it does: its smallest barycentric coordinate, 0 on an edge.
 */
bool triangle_hit(const struct triangle_shape *triangle,
	struct tcs_point origin, struct tcs_point direction, double *t,
	double *margin);

/* Twice the area, along the normal; counterclockwise is towards the viewer. */
static inline struct tcs_point
triangle_normal(const struct triangle_shape *triangle)
{
	const struct tcs_point *corner = triangle->corner;

	return vector_cross(vector_difference(corner[1], corner[0]),
		vector_difference(corner[2], corner[0]));
}

static inline struct tcs_point
triangle_centre(const struct triangle_shape *triangle)
{
	const struct tcs_point *corner = triangle->corner;

	return vector_scaled(
		vector_sum(corner[0], vector_sum(corner[1], corner[2])),
		1.0 / 3);
}

static inline double
triangle_area(const struct triangle_shape *triangle)
{
	return vector_length(triangle_normal(triangle)) / 2;
}

#endif
