/*
 * Planes, and points as triples of them: on which side of a plane a point lies
 * is exact, whatever its coordinates round to.
 */
#ifndef TESSERA_SOLID_PLANES_H
#define TESSERA_SOLID_PLANES_H

#include "array.h"
#include "fault.h"
#include "solid_points.h"
#include "tcs.h"

/*
 * The points whose product with the normal is `reach`. The normal has length 1
 * but for rounding: its coordinates are multiples of 2⁻⁴⁰, so that products of
 * three neither overflow nor underflow.
 */
struct solid_plane {
	struct tcs_point normal;
	double reach;
};

TCS_ARRAY_TYPE(solid_plane_list, struct solid_plane);

/* All zero is empty. */
struct solid_planes {
	struct solid_plane_list list;
	struct solid_numbers slots; /* by direction: first plane + 1, or 0 */
	struct solid_numbers next; /* of each plane: next in the slot, + 1 */
	double tolerance;
	double extent; /* of all there is, from 0 */
};

/* Where three planes meet. */
struct solid_corner {
	uint32_t planes[3];
	struct tcs_point at; /* rounded */
	double error; /* no coordinate is further off */
};

/* Fails with TCS_NO_MEMORY. */
enum tcs_status solid_planes_begin(struct solid_planes *planes,
	double tolerance, double extent, struct tcs_fault *fault) TCS_CHECKED;
void solid_planes_release(struct solid_planes *planes);

/*
 * The plane that all points lie in up to the tolerance: one that is there, or a
 * new one. The first `outer` points are a ring. *side is 1 where it turns
 * counterclockwise as seen from where the plane's normal points to, -1 where
 * clockwise, and 0 where there is no plane: the points are bent, or the ring is
 * narrower than the tolerance. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_planes_find(struct solid_planes *planes,
	const struct tcs_point *points, size_t outer, size_t count,
	uint32_t *plane, int *side, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The same for a plane through a point with a normal of length 1. *side is -1
 * where the plane's normal points the other way. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_planes_place(struct solid_planes *planes,
	struct tcs_point point, struct tcs_point normal, uint32_t *plane,
	int *side, struct tcs_fault *fault) TCS_CHECKED;

/* How far a point is from a plane, rounded. */
static inline double
solid_plane_distance(const struct solid_plane *plane, struct tcs_point at)
{
	return point_dot(plane->normal, at) - plane->reach;
}

/* The corner of three planes that meet in one point. */
struct solid_corner solid_corner_of(
	const struct solid_plane *planes, uint32_t a, uint32_t b, uint32_t c);

/* The exact sign of the corner's distance. */
int solid_corner_side_exact(const struct solid_plane *planes,
	const struct solid_corner *corner, uint32_t plane);

static inline int
solid_corner_side(const struct solid_plane *planes,
	const struct solid_corner *corner, uint32_t plane)
{
	double distance;

	if (corner->planes[0] == plane || corner->planes[1] == plane ||
		corner->planes[2] == plane)
		return 0;
	distance = solid_plane_distance(&planes[plane], corner->at);
	if (distance > corner->error)
		return 1;
	if (distance < -corner->error)
		return -1;
	return solid_corner_side_exact(planes, corner, plane);
}

#endif
