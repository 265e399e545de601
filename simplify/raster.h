/*
 * Pictures of a mesh as numbers: which triangle each pixel shows, seen in
 * perspective from a place, opaque from both sides.
 */
#ifndef TESSERA_RASTER_H
#define TESSERA_RASTER_H

#include "component_set.h"

/* Where the eye is and how it looks; unit vectors at right angles. */
struct view {
	struct tcs_point eye, right, up, forward;
	double scale; /* 1 / tangent of half the angle of view */
	double nearest; /* what is not farther along `forward` is not seen */
};

/* From `eye` to `target`, upright, so that a sphere around the target just
   fits. The eye is outside of it and not straight above. What is as near as a
   thousandth of the way is not seen. */
struct view view_of(
	struct tcs_point eye, struct tcs_point target, double radius);

/* The direction in which the middle of a pixel looks; not of unit length. */
struct tcs_point view_ray(
	const struct view *view, unsigned size, unsigned x, unsigned y);

#define RASTER_NOTHING UINT32_MAX

/* size × size pixels, row by row from the top. All zero is empty. */
struct raster {
	unsigned size;
	uint32_t *triangles; /* of each pixel; RASTER_NOTHING */
	float *nearness; /* 1 / depth along `forward`; 0 for nothing */
};

/*
 * Draw all triangles whose corners lie before the eye. A pixel shows what is
 * nearest at its middle. Fails with TCS_NO_MEMORY.
 */
enum tcs_status raster_draw(struct raster *raster, unsigned size,
	const struct view *view, const struct component_set *set,
	struct tcs_fault *fault) TCS_CHECKED;
void raster_release(struct raster *raster);

#endif
