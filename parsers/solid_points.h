/*
 * Points as numbers: equal positions are one point.
 */
#ifndef TESSERA_SOLID_POINTS_H
#define TESSERA_SOLID_POINTS_H

#include "array.h"
#include "fault.h"
#include "tcs.h"

/* Plain vectors. */
static inline struct tcs_point
point_minus(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline struct tcs_point
point_plus(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline struct tcs_point
point_cross(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
		a.x * b.y - a.y * b.x};
}

static inline double
point_dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

TCS_ARRAY_TYPE(solid_numbers, uint32_t);

/* Scratch memory, reused; all zero is empty. */
struct solid_points {
	struct solid_numbers slots; /* hash table: index + 1, 0 is free */
	struct solid_numbers numbers; /* of each point */
	size_t distinct;
};

/*
 * numbers.at[i] is the number of points[i]: equal for equal positions, counting
 * from 0 in the order of first occurrence. -0 is 0. Fewer than 2³⁰ points.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_points_number(struct solid_points *all,
	const struct tcs_point *points, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

void solid_points_release(struct solid_points *all);

#endif
