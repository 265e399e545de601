/* Vectors of three doubles. */
#ifndef TESSERA_VECTOR_H
#define TESSERA_VECTOR_H

#include <math.h>

#include "tcs.h"

static inline struct tcs_point
vector_sum(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* a - b */
static inline struct tcs_point
vector_difference(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline struct tcs_point
vector_scaled(struct tcs_point a, double factor)
{
	return (struct tcs_point){a.x * factor, a.y * factor, a.z * factor};
}

/* a + factor · b */
static inline struct tcs_point
vector_along(struct tcs_point a, struct tcs_point b, double factor)
{
	return vector_sum(a, vector_scaled(b, factor));
}

static inline struct tcs_point
vector_middle(struct tcs_point a, struct tcs_point b)
{
	return vector_scaled(vector_sum(a, b), 0.5);
}

static inline double
vector_dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct tcs_point
vector_cross(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
		a.x * b.y - a.y * b.x};
}

static inline double
vector_length(struct tcs_point a)
{
	return sqrt(vector_dot(a, a));
}

#endif
