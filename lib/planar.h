/*
 * A polygon in a plane: what the parts of the triangulation share.
 */
#ifndef TESSERA_PLANAR_H
#define TESSERA_PLANAR_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "tcs.h"

struct planar_point {
	double x, y;
};

TCS_ARRAY_TYPE(planar_points, struct planar_point);

/*
 * How the plane lies in space. A point of the plane is origin plus x and y
 * along two of the axes and, along the third, `height` plus the slopes.
 */
struct planar_plane {
	struct tcs_point origin;
	struct tcs_point normal; /* unit */
	unsigned char axes[3]; /* 0 to 2: that of x, of y, the third */
	double height;
	double slope_x, slope_y;
	double cosine; /* between the normal and the third axis */
	double noise; /* the area that rounded coordinates may feign */
};

/*
 * Rings as cycles over the vertices, the outer one counterclockwise and holes
 * clockwise, so that the inside is to the left of every edge. Points equal to
 * the one before them are in no cycle, nor are holes of fewer than three
 * points. Edge i leads from vertex i to next[i].
 */
struct planar {
	struct planar_points points; /* of every vertex as given */
	TCS_ARRAY(uint32_t) next; /* by vertex */
	TCS_ARRAY(uint32_t) previous;
	TCS_ARRAY(uint32_t) kept; /* the vertices in cycles, ring by ring */
	TCS_ARRAY(uint32_t) firsts; /* one vertex of each cycle, outer first */
	struct planar_plane plane;
	double area; /* the outer ring's less those of the holes */
	double extent; /* the larger side of the bounding box */
};

TCS_ARRAY_TYPE(triangle_list, struct tcs_triangle);
TCS_ARRAY_TYPE(point_list, struct tcs_point);

/* Room for so many elements in an array that is empty. */
#define planar_room(array, count) \
	((array)->room < (count) && array_grow((array), (count)))

/* fmax for numbers, without its call. */
static inline double
planar_larger(double a, double b)
{
	return a > b ? a : b;
}

/*
 * Twice the signed area of a triangle, positive when it is counterclockwise.
 * The sign is exact for coordinates from 1e-75 to 1e75, the value rounded.
 *
 * source: J. R. Shewchuk, Adaptive precision floating-point arithmetic and
 * fast robust geometric predicates, 1997; the bound of its first stage.
 */
double planar_orient_exact(
	struct planar_point a, struct planar_point b, struct planar_point c);

static inline double
planar_orient(
	struct planar_point a, struct planar_point b, struct planar_point c)
{
	double left = (a.x - c.x) * (b.y - c.y);
	double right = (a.y - c.y) * (b.x - c.x);
	double area = left - right;
	double bound = 3.3306690738754716e-16 * (fabs(left) + fabs(right));

	if (area > bound || area < -bound || bound == 0)
		return area;
	return planar_orient_exact(a, b, c);
}

static inline double
planar_side(const struct planar *polygon, uint32_t edge, struct planar_point at)
{
	const struct planar_point *points = polygon->points.at;

	return planar_orient(points[edge], points[polygon->next.at[edge]], at);
}

/* A point of the plane in space, `off` it along the third axis. */
struct tcs_point planar_lift(
	const struct planar_plane *plane, struct planar_point at, double off);

/* How far off the plane a point in space is, along the third axis. */
double planar_height(const struct planar_plane *plane, struct planar_point at,
	struct tcs_point position);

/*
 * Find the plane of a ring and of all vertices: Newell's normal decides which
 * axis is left out. `flatness` is the largest distance of a vertex from the
 * plane. Returns NULL, or a static text where the ring has no plane.
 */
const char *planar_find(struct planar_plane *plane,
	const struct tcs_point *vertices, size_t outer, size_t count,
	double *flatness);

struct planar_point planar_project(
	const struct planar_plane *plane, struct tcs_point point);

/*
 * Project the polygon into polygon->plane and link its cycles. Returns NULL, or
 * a static text where there is nothing to link. *status is TCS_OK or
 * TCS_NO_MEMORY.
 */
const char *planar_lay(struct planar *polygon, const struct tcs_point *vertices,
	const uint32_t *rings, size_t ring_count, size_t count,
	enum tcs_status *status);

/*
 * The points moved by so much out of the polygon, or into it where `by` is
 * negative: rings that only touch then touch no more. Those of no cycle are
 * left unset. Fails with TCS_NO_MEMORY.
 */
enum tcs_status planar_nudge(const struct planar *polygon, double by,
	struct planar_points *out, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Whether more than so many pairs of edges overlap in x, or cross or touch:
 * what a repair would have to pay for. Counts no further than that. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status planar_tangle(const struct planar *polygon, uint64_t most_pairs,
	uint64_t most_crossings, bool *tangled,
	struct tcs_fault *fault) TCS_CHECKED;

/* Give back what a large polygon took; the plane stays. */
void planar_trim(struct planar *polygon);
void planar_release(struct planar *polygon);

#endif
