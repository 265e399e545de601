/*
 * Error quadrics: the sum of weighted squared distances from planes, as a
 * function of a point. Positions should be near 0; metres, the weight of a
 * face is its area in square metres.
 *
 * source: M. Garland, P. Heckbert, Surface simplification using quadric error
 * metrics, 1997.
 */
#ifndef TESSERA_QUADRIC_H
#define TESSERA_QUADRIC_H

#include "vector.h"

struct quadric {
	double xx, yy, zz, xy, xz, yz; /* Σ w n nᵀ */
	double x, y, z; /* Σ w d n */
	double rest; /* Σ w d² */
};

/* Add the plane n · p + d = 0, n of length 1. */
static inline void
quadric_add_plane(
	struct quadric *q, struct tcs_point n, double d, double weight)
{
	struct tcs_point w = vector_scaled(n, weight);

	q->xx += w.x * n.x;
	q->yy += w.y * n.y;
	q->zz += w.z * n.z;
	q->xy += w.x * n.y;
	q->xz += w.x * n.z;
	q->yz += w.y * n.z;
	q->x += w.x * d;
	q->y += w.y * d;
	q->z += w.z * d;
	q->rest += weight * d * d;
}

static inline void
quadric_add(struct quadric *q, const struct quadric *more)
{
	q->xx += more->xx;
	q->yy += more->yy;
	q->zz += more->zz;
	q->xy += more->xy;
	q->xz += more->xz;
	q->yz += more->yz;
	q->x += more->x;
	q->y += more->y;
	q->z += more->z;
	q->rest += more->rest;
}

/* Never negative: what rounding leaves below 0 is 0. */
static inline double
quadric_at(const struct quadric *q, struct tcs_point p)
{
	double x = q->xx * p.x + q->xy * p.y + q->xz * p.z + 2 * q->x;
	double y = q->xy * p.x + q->yy * p.y + q->yz * p.z + 2 * q->y;
	double z = q->xz * p.x + q->yz * p.y + q->zz * p.z + 2 * q->z;
	double value = x * p.x + y * p.y + z * p.z + q->rest;

	return value > 0 ? value : 0;
}

#endif
