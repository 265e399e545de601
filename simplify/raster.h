/*
 * Pictures of a mesh as numbers: which triangle each pixel shows, seen in
 * perspective from a place or along parallel rays, opaque from both sides.
 */
#ifndef TESSERA_RASTER_H
#define TESSERA_RASTER_H

#include "tcs.h"

/* Where the eye is and how it looks; unit vectors at right angles. */
struct view {
	struct tcs_point eye, right, up, forward;
	double scale; /* 1 / tangent of half the angle of view; of parallel
	                 rays, 1 / half the width of the picture */
	double nearest; /* what is not farther along `forward` is not seen */
	double farthest; /* of parallel rays: beyond, nothing is seen */
	bool parallel;
};

/* From `eye` to `target`, upright, so that a sphere around the target just
   fits. The eye is outside of it and not straight above. What is as near as a
   thousandth of the way is not seen. */
struct view view_of(
	struct tcs_point eye, struct tcs_point target, double radius);

/* Along `forward`, of unit length, so that a sphere around the target just
   fits; nothing outside of the sphere is seen. */
struct view view_parallel(
	struct tcs_point forward, struct tcs_point target, double radius);

/* Where a point is in the picture, in pixels, and how near it is, as in a
   raster; 0 for what is not seen. */
struct spot {
	double x, y, nearness;
};

struct spot view_spot(
	const struct view *view, unsigned size, struct tcs_point point);

/* The direction in which the middle of a pixel looks in perspective; not of unit
   length. */
struct tcs_point view_ray(
	const struct view *view, unsigned size, unsigned x, unsigned y);

#define RASTER_NOTHING UINT32_MAX

/* size × size pixels, row by row from the top. All zero is empty. */
struct raster {
	unsigned size;
	uint32_t *triangles; /* of each pixel; RASTER_NOTHING */
	float *nearness; /* 1 / depth along `forward`, or how much before
	                    `farthest`; 0 for nothing */
};

/*
 * Draw all triangles whose corners are seen. A pixel shows what is nearest at
 * its middle. `fronts` has 1 for a triangle that is seen only from where it is
 * counterclockwise, -1 only from the other side, 0 from both; NULL: all are
 * seen from both. Fails with TCS_NO_MEMORY.
 */
enum tcs_status raster_draw(struct raster *raster, unsigned size,
	const struct view *view, const struct tcs_point *points,
	size_t point_count, const struct tcs_triangle *triangles,
	size_t triangle_count, const signed char *fronts,
	struct tcs_fault *fault) TCS_CHECKED;
void raster_release(struct raster *raster);

#endif
