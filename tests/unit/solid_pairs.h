/*
 * Two solids out of bytes, near to each other in every way: on a coarse grid,
 * so that planes, edges and corners coincide, or all but coincide. And what must
 * hold of their booleans.
 */
#ifndef TESSERA_SOLID_PAIRS_H
#define TESSERA_SOLID_PAIRS_H

#include <stdint.h>

#include "parsers/solid_points.h"
#include "solid_shapes.h"

struct pair_bytes {
	const uint8_t *at;
	size_t left;
};

struct solid_pair {
	struct solid a, b;
	struct solid_half_space half;
	bool sound; /* both are closed and do not cross themselves */
};

static inline unsigned
pair_byte(struct pair_bytes *bytes, unsigned below)
{
	if (!bytes->left)
		return 0;
	bytes->left--;
	return *bytes->at++ % below;
}

static inline double
pair_coordinate(struct pair_bytes *bytes)
{
	static const double off[] = {
		0, 0, 0, 0, 1e-6, -1e-6, 3e-6, 1e-7, -2e-5, 1e-5, 1e-9};
	double at = pair_byte(bytes, 7) * 0.5;

	return at + off[pair_byte(bytes, 11)];
}

/* Where two coordinates are less than 0.4 apart, the upper is raised. */
static inline void
pair_interval(struct pair_bytes *bytes, double *low, double *high)
{
	double a = pair_coordinate(bytes), b = pair_coordinate(bytes);

	*low = fmin(a, b);
	*high = fmax(a, b);
	*high += *high - *low < 0.4 ? 1 : 0;
}

static inline void
pair_box(struct pair_bytes *bytes, struct solid *solid)
{
	double low[3], high[3];

	for (int i = 0; i < 3; i++)
		pair_interval(bytes, &low[i], &high[i]);
	shape_add_box(solid, low[0], low[1], low[2], high[0], high[1], high[2]);
}

/* The corners of a star around a point, counterclockwise. */
static inline uint32_t
pair_star(struct pair_bytes *bytes, struct tcs_point star[16])
{
	struct tcs_point centre = {pair_coordinate(bytes),
		pair_coordinate(bytes), pair_coordinate(bytes)};
	uint32_t count = 3 + pair_byte(bytes, 10);
	double turn = pair_byte(bytes, 8) * 0.7853981633974483;

	for (uint32_t i = 0; i < count; i++) {
		double angle = turn + i * 6.283185307179586 / count;
		double radius = 0.5 + 0.5 * pair_byte(bytes, 3);

		star[i] = (struct tcs_point){centre.x + radius * cos(angle),
			centre.y + radius * sin(angle), centre.z};
	}
	return count;
}

static inline void
pair_prism(struct pair_bytes *bytes, struct solid *solid)
{
	struct tcs_point star[16];
	uint32_t count = pair_star(bytes, star);
	struct tcs_point along = {0.5 * pair_byte(bytes, 3) - 0.5,
		0.5 * pair_byte(bytes, 3) - 0.5,
		0.5 + 0.5 * pair_byte(bytes, 4)};

	shape_must(solid_add_prism(
		solid, star, &count, 1, along, 1, &shape_fault));
}

static inline void
pair_pyramid(struct pair_bytes *bytes, struct solid *solid)
{
	static const uint32_t three = 3;
	struct tcs_point star[16], base[16], apex;
	uint32_t count = pair_star(bytes, star);

	apex = star[0];
	apex.x += 0.5 * pair_byte(bytes, 3);
	apex.z += 0.5 + 0.5 * pair_byte(bytes, 4);
	for (uint32_t i = 0; i < count; i++) {
		struct tcs_point side[3] = {
			star[i], star[(i + 1) % count], apex};

		base[i] = star[count - 1 - i];
		shape_must(solid_add_face(
			solid, side, &three, 1, 2, &shape_fault));
	}
	shape_must(solid_add_face(solid, base, &count, 1, 3, &shape_fault));
}

/* Faces that mean nothing. */
static inline void
pair_soup(struct pair_bytes *bytes, struct solid *solid)
{
	unsigned faces = pair_byte(bytes, 24);

	for (unsigned i = 0; i < faces; i++) {
		struct tcs_point ring[8];
		uint32_t count = pair_byte(bytes, 8);

		for (uint32_t j = 0; j < count; j++)
			ring[j] = (struct tcs_point){pair_coordinate(bytes),
				pair_coordinate(bytes), pair_coordinate(bytes)};
		shape_must(solid_add_face(
			solid, ring, &count, 1, 4, &shape_fault));
	}
}

/* Whether it is sound. Stars' pyramids need not be: their apex stands over a
 * corner. */
static inline bool
pair_solid(struct pair_bytes *bytes, struct solid *solid)
{
	switch (pair_byte(bytes, 8)) {
	case 0:
	case 1:
		pair_box(bytes, solid);
		return true;
	case 2:
	case 3:
	case 4:
		pair_prism(bytes, solid);
		return true;
	case 5:
		pair_pyramid(bytes, solid);
		return false;
	case 6:
		pair_box(bytes, solid);
		pair_prism(bytes, solid);
		return false;
	default:
		pair_soup(bytes, solid);
		return false;
	}
}

/* A plane through the grid. */
static inline struct solid_half_space
pair_half_space(struct pair_bytes *bytes, const struct shape_place *place)
{
	struct shape_place turn = *place;
	double at[3], up[3];

	for (int i = 0; i < 3; i++) {
		at[i] = pair_coordinate(bytes);
		up[i] = (double)pair_byte(bytes, 5) - 2;
	}
	if (up[0] == 0 && up[1] == 0 && up[2] == 0)
		up[2] = 1;
	turn.shift = (struct tcs_point){0, 0, 0};
	return (struct solid_half_space){
		shape_placed(place, at[0], at[1], at[2]),
		shape_placed(&turn, up[0], up[1], up[2]), 5};
}

static inline struct solid_pair
pair_read(const uint8_t *at, size_t size)
{
	static const struct tcs_point shifts[] = {
		{0, 0, 0}, {691000.25, 5333000.5, 512}};
	struct pair_bytes bytes = {at, size};
	struct solid_pair pair = {.sound = true};
	double p = 0.3 * pair_byte(&bytes, 6), q = 0.41 * pair_byte(&bytes, 6);
	struct shape_place place = {
		{cos(p), -sin(p) * cos(q), sin(p) * sin(q), sin(p),
			cos(p) * cos(q), -cos(p) * sin(q), 0, sin(q), cos(q)},
		shifts[pair_byte(&bytes, 2)]};

	pair.sound &= pair_solid(&bytes, &pair.a);
	pair.sound &= pair_solid(&bytes, &pair.b);
	pair.half = pair_half_space(&bytes, &place);
	shape_move(&pair.a, &place);
	shape_move(&pair.b, &place);
	return pair;
}

static inline void
pair_release(struct solid_pair *pair)
{
	solid_release(&pair->a);
	solid_release(&pair->b);
}

/* ---- what must hold ---------------------------------------------------------- */

/* The area of a face. */
static inline double
pair_face_area(const struct solid *solid, size_t number)
{
	const struct solid_face *face = &solid->faces.at[number];
	struct tcs_point sum = {0, 0, 0};

	for (uint32_t i = 0; i < face->ring_count; i++) {
		size_t count;
		const struct tcs_point *ring =
			solid_ring(solid, face->first_ring + i, &count);

		for (size_t j = 2; j < count; j++) {
			struct tcs_point a = point_minus(ring[j - 1], ring[0]);
			struct tcs_point b = point_minus(ring[j], ring[0]);

			sum = point_plus(sum, point_cross(a, b));
		}
	}
	return sqrt(point_dot(sum, sum)) / 2;
}

/* One task. Adds to *volume; returns what is wrong with it, or NULL. */
static inline const char *
pair_do(struct solid_cutter *cutter, const struct solid_task *task, bool sound,
	double *volume)
{
	enum solid_tool_fault tool_fault = SOLID_TOOL_SOUND;
	struct solid_report report;
	struct solid_measure measure;
	struct solid out = {0};
	const char *wrong = NULL;

	shape_must(solid_cut(
		cutter, task, &out, &report, &tool_fault, &shape_fault));
	measure = shape_measure(&out);
	*volume += measure.volume;
	if (report.outcome <= SOLID_EMPTY && !measure.closed)
		wrong = "a result is not closed";
	if (sound && report.outcome > SOLID_EMPTY)
		wrong = report.reason ? report.reason : "a host is open";
	if (sound && tool_fault)
		wrong = "a tool is at fault";
	if (sound && report.crossing)
		wrong = "a host crosses itself";
	for (size_t i = 0; sound && i < out.faces.count; i++) {
		if (out.faces.at[i].face == SOLID_NO_FACE &&
			!task->half_space_count)
			wrong = "a face comes from none";
		if (pair_face_area(&out, i) < 1e-13)
			wrong = "a face has no area";
	}
	solid_release(&out);
	return wrong;
}

static inline const char *
pair_cut(struct solid_cutter *cutter, enum solid_operation operation,
	const struct solid *host, const struct solid *tool, bool sound,
	double *volume)
{
	struct solid_task task = {.operation = operation,
		.host = host,
		.tools = &tool,
		.tool_count = 1};

	return pair_do(cutter, &task, sound, volume);
}

/* What a plane parts is all there still. */
static inline const char *
pair_part(struct solid_cutter *cutter, const struct solid_pair *pair,
	const struct solid_measure *whole)
{
	struct solid_half_space half = pair->half;
	struct solid_task task = {
		.host = &pair->a, .half_spaces = &half, .half_space_count = 1};
	double volume = 0;
	const char *wrong = pair_do(cutter, &task, pair->sound, &volume);

	if (wrong)
		return wrong;
	half.normal = point_minus((struct tcs_point){0, 0, 0}, half.normal);
	wrong = pair_do(cutter, &task, pair->sound, &volume);
	if (!wrong && pair->sound &&
		fabs(volume - whole->volume) >
			4 * SOLID_TOLERANCE * whole->area)
		wrong = "what a plane parts is not all there";
	return wrong;
}

/* Returns what does not hold, or NULL. */
static inline const char *
pair_check(struct solid_cutter *cutter, const struct solid_pair *pair)
{
	const struct solid *a = &pair->a, *b = &pair->b;
	struct solid_measure in_a = shape_measure(a), in_b = shape_measure(b);
	double less = 0, both = 0, any = 0, none = 0, same = 0;
	double slack = 4 * SOLID_TOLERANCE * (in_a.area + in_b.area);
	const char *wrong[5] = {
		pair_cut(cutter, SOLID_DIFFERENCE, a, b, pair->sound, &less),
		pair_cut(cutter, SOLID_INTERSECTION, a, b, pair->sound, &both),
		pair_cut(cutter, SOLID_UNION, a, b, pair->sound, &any),
		pair_cut(cutter, SOLID_DIFFERENCE, a, a, pair->sound, &none),
		pair_cut(cutter, SOLID_INTERSECTION, a, a, pair->sound, &same)};

	for (int i = 0; i < 5; i++)
		if (wrong[i])
			return wrong[i];
	if (!pair->sound)
		return NULL;
	if (fabs(in_a.volume - both - less) > slack)
		return "a is not what a and b share and a without b";
	if (fabs(any + both - in_a.volume - in_b.volume) > slack)
		return "a and b are not a or b and a and b";
	if (fabs(none) > slack)
		return "something is left of a without a";
	if (fabs(same - in_a.volume) > slack)
		return "a within a is not a";
	return pair_part(cutter, pair, &in_a);
}

#endif
