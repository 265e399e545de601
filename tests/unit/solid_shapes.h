/*
 * Solids for tests, and what must hold of what is made of them.
 */
#ifndef TESSERA_SOLID_SHAPES_H
#define TESSERA_SOLID_SHAPES_H

#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "parsers/solid.h"

static struct tcs_fault shape_fault;

static inline void
shape_must(enum tcs_status status)
{
	if (status)
		abort();
}

/* A turn, then a shift. */
struct shape_place {
	double turn[9];
	struct tcs_point shift;
};

static const struct shape_place shape_upright = {
	{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};

static inline struct tcs_point
shape_placed(const struct shape_place *place, double x, double y, double z)
{
	const double *m = place->turn;

	return (struct tcs_point){
		m[0] * x + m[1] * y + m[2] * z + place->shift.x,
		m[3] * x + m[4] * y + m[5] * z + place->shift.y,
		m[6] * x + m[7] * y + m[8] * z + place->shift.z};
}

/* Every point of a solid. */
static inline void
shape_move(struct solid *solid, const struct shape_place *place)
{
	for (size_t i = 0; i < solid->points.count; i++) {
		struct tcs_point *at = &solid->points.at[i];

		*at = shape_placed(place, at->x, at->y, at->z);
	}
}

static inline void
shape_add_box(struct solid *solid, double x, double y, double z, double to_x,
	double to_y, double to_z)
{
	const struct tcs_point base[4] = {
		{x, y, z}, {to_x, y, z}, {to_x, to_y, z}, {x, to_y, z}};
	const uint32_t four = 4;

	shape_must(solid_add_prism(solid, base, &four, 1,
		(struct tcs_point){0, 0, to_z - z}, 0, &shape_fault));
}

static inline struct solid
shape_box(double x, double y, double z, double to_x, double to_y, double to_z)
{
	struct solid solid = {0};

	shape_add_box(&solid, x, y, z, to_x, to_y, to_z);
	return solid;
}

/* Without the last face, a quadrangle. */
static inline void
shape_drop_face(struct solid *solid)
{
	solid->faces.count--;
	solid->ring_ends.count--;
	solid->points.count -= 4;
}

/* An upright prism over a regular polygon, its first corner at `turn`. */
static inline struct solid
shape_column(double x, double y, double radius, uint32_t corners, double turn,
	double low, double high)
{
	struct tcs_point base[64];
	struct solid solid = {0};

	for (uint32_t i = 0; i < corners; i++) {
		double angle = turn + i * 6.283185307179586 / corners;

		base[i] = (struct tcs_point){
			x + radius * cos(angle), y + radius * sin(angle), low};
	}
	shape_must(solid_add_prism(&solid, base, &corners, 1,
		(struct tcs_point){0, 0, high - low}, 0, &shape_fault));
	return solid;
}

static inline struct solid_measure
shape_measure(const struct solid *solid)
{
	struct solid_measure out;

	shape_must(solid_measure(solid, &out, &shape_fault));
	return out;
}

/* Numbers that look random, and always the same ones. */
static inline uint32_t
shape_random(uint64_t *state)
{
	*state = *state * 6364136223846793005u + 1442695040888963407u;
	return (uint32_t)(*state >> 33);
}

#endif
