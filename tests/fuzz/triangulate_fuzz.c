/*
 * Rings on a small grid, so that they touch, cross and repeat, in a plane of
 * one of several kinds. Whatever they do, the triangles must cover what is
 * inside by the odd–even rule, once, and nothing else.
 */
#include "triangulate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_RINGS = 6, MOST_VERTICES = 96, SAMPLES = 64 };

struct flat_point {
	double x, y;
};

/* The grid's place in space: origin, and what x and y are there. */
struct placement {
	struct tcs_point origin, x, y;
	double bend; /* the height of every other vertex */
};

static const struct placement placements[] = {
	{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0},
	{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0},
	{{691051.25, 5333770.5, 512}, {0, 1, 0}, {0, 0, 1}, 0},
	{{691051.4379, 5333770.123, 512.7}, {0.6, 0.37, 0}, {0, 0, 0.51}, 0},
	{{5e6, 5e6, 0}, {0.001, 0, 0}, {0, 0.001, 0}, 0},
	{{691051.4379, 5333770.123, 512.7}, {0.6, 0.37, 0}, {0, 0, 0.51}, 0.3},
	{{0, 0, 0}, {-1e60, 0, 0}, {0, 1e60, 0}, 0},
	{{0, 0, 0}, {1e-60, 0, 0}, {0, 0, 1e-60}, 0},
};

struct polygon {
	const struct placement *placement;
	struct flat_point flat[MOST_VERTICES];
	struct tcs_point vertices[MOST_VERTICES];
	uint32_t rings[MOST_RINGS];
	size_t ring_count, vertex_count;
};

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct tcs_point
placed(const struct placement *place, struct flat_point at, size_t i)
{
	const struct tcs_point *o = &place->origin, *x = &place->x,
			       *y = &place->y;
	double bend = i % 2 ? place->bend : 0;

	return (struct tcs_point){o->x + at.x * x->x + at.y * y->x + bend,
		o->y + at.x * x->y + at.y * y->y,
		o->z + at.x * x->z + at.y * y->z};
}

/* The axes of every placement are orthogonal. */
static struct flat_point
unplaced(const struct placement *place, struct tcs_point at)
{
	struct tcs_point off = {at.x - place->origin.x, at.y - place->origin.y,
		at.z - place->origin.z};

	return (struct flat_point){dot(off, place->x) / dot(place->x, place->x),
		dot(off, place->y) / dot(place->y, place->y)};
}

static void
polygon_read(struct polygon *polygon, const uint8_t *bytes, size_t length)
{
	size_t at = 1;

	memset(polygon, 0, sizeof *polygon);
	polygon->placement = &placements[length ? bytes[0] % 8 : 0];
	while (at < length && polygon->ring_count < MOST_RINGS) {
		uint32_t count = bytes[at++] % 24;
		uint32_t *ring = &polygon->rings[polygon->ring_count++];

		for (; *ring < count && at < length &&
			polygon->vertex_count < MOST_VERTICES;
			++*ring, at++) {
			size_t i = polygon->vertex_count++;

			polygon->flat[i] = (struct flat_point){
				bytes[at] % 16, bytes[at] / 16};
			polygon->vertices[i] =
				placed(polygon->placement, polygon->flat[i], i);
		}
	}
}

/* ---- the oracle --------------------------------------------------------------- */

static double
turn(struct flat_point a, struct flat_point b, struct flat_point c)
{
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static bool
is_near(struct flat_point a, struct flat_point b, struct flat_point at)
{
	double length = hypot(b.x - a.x, b.y - a.y);

	if (length == 0)
		return hypot(at.x - a.x, at.y - a.y) < 1e-4;
	return fabs(turn(a, b, at)) / length < 1e-4;
}

static bool
crosses(struct flat_point a, struct flat_point b, struct flat_point at)
{
	return (a.y > at.y) != (b.y > at.y) &&
		(turn(a, b, at) > 0) == (b.y > a.y);
}

/* 1 inside, 0 outside, -1 too near to an edge to tell. */
static int
parity(const struct polygon *polygon, struct flat_point at)
{
	const struct flat_point *ring = polygon->flat;
	int inside = 0;

	for (size_t i = 0; i < polygon->ring_count; i++) {
		uint32_t count = polygon->rings[i];

		for (uint32_t j = 0; j < count; j++) {
			struct flat_point a = ring[j];
			struct flat_point b = ring[(j + 1) % count];

			if (is_near(a, b, at))
				return -1;
			inside ^= crosses(a, b, at);
		}
		ring += count;
	}
	return inside;
}

static struct flat_point
corner_of(const struct polygon *polygon, const struct triangulation *out,
	uint32_t corner)
{
	if (corner < polygon->vertex_count)
		return polygon->flat[corner];
	return unplaced(
		polygon->placement, out->extra[corner - polygon->vertex_count]);
}

static int
cover(const struct polygon *polygon, const struct triangulation *out,
	struct flat_point at)
{
	int count = 0;

	for (size_t i = 0; i < out->triangle_count; i++) {
		const uint32_t *corner = out->triangles[i].corner;
		struct flat_point a = corner_of(polygon, out, corner[0]);
		struct flat_point b = corner_of(polygon, out, corner[1]);
		struct flat_point c = corner_of(polygon, out, corner[2]);

		if (is_near(a, b, at) || is_near(b, c, at) || is_near(c, a, at))
			return -1;
		count += crosses(a, b, at) ^ crosses(b, c, at) ^
			crosses(c, a, at);
	}
	return count;
}

static void
fail(const struct polygon *polygon, const struct triangulation *out,
	const char *what)
{
	const struct flat_point *at = polygon->flat;

	fprintf(stderr, "%s; outcome %d, %s\n", what, (int)out->outcome,
		out->reason ? out->reason : "whole");
	for (size_t i = 0; i < polygon->ring_count; i++) {
		for (uint32_t j = 0; j < polygon->rings[i]; j++, at++)
			fprintf(stderr, "%g,%g ", at->x, at->y);
		fprintf(stderr, "\n");
	}
	abort();
}

static void
check_cover(const struct polygon *polygon, const struct triangulation *out)
{
	uint32_t state = 12345;

	for (int i = 0; i < SAMPLES; i++) {
		struct flat_point at;
		int inside, covered;

		state = state * 1664525u + 1013904223u;
		at.x = (state >> 8) % 60000 / 4000.0;
		state = state * 1664525u + 1013904223u;
		at.y = (state >> 8) % 60000 / 4000.0;
		inside = parity(polygon, at);
		covered = inside < 0 ? -1 : cover(polygon, out, at);
		if (covered >= 0 && covered != inside)
			fail(polygon, out, "covered wrongly");
	}
}

static struct tcs_point
position(const struct polygon *polygon, const struct triangulation *out,
	uint32_t corner)
{
	if (corner < polygon->vertex_count)
		return polygon->vertices[corner];
	return out->extra[corner - polygon->vertex_count];
}

/* The corners exist, and the areas add up. */
static void
check_triangles(const struct polygon *polygon, const struct triangulation *out)
{
	size_t corners = polygon->vertex_count + out->extra_count;
	double sum = 0, extent = 0;

	for (size_t i = 0; i < out->triangle_count; i++) {
		const uint32_t *corner = out->triangles[i].corner;
		struct tcs_point p[3], u, v, cross;

		for (int j = 0; j < 3; j++) {
			if (corner[j] >= corners)
				fail(polygon, out, "no such corner");
			p[j] = position(polygon, out, corner[j]);
		}
		u = (struct tcs_point){
			p[1].x - p[0].x, p[1].y - p[0].y, p[1].z - p[0].z};
		v = (struct tcs_point){
			p[2].x - p[0].x, p[2].y - p[0].y, p[2].z - p[0].z};
		cross = (struct tcs_point){u.y * v.z - u.z * v.y,
			u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
		sum += dot(cross, out->normal) / 2;
		extent = fmax(extent, dot(u, u) + dot(v, v));
	}
	if (polygon->placement->bend == 0 &&
		fabs(sum - out->area) > 1e-6 * extent)
		fail(polygon, out, "area not that of the triangles");
	if ((out->outcome == TRIANGULATION_EMPTY) != (out->area == 0))
		fail(polygon, out, "area disagrees with the outcome");
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length);

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length)
{
	static struct triangulator *triangulator;
	struct polygon polygon;
	struct triangulation out;
	struct tcs_fault fault;

	if (!triangulator)
		triangulator = triangulator_new();
	polygon_read(&polygon, bytes, length);
	if (!triangulator ||
		triangulate(triangulator, polygon.vertices, polygon.rings,
			polygon.ring_count, &out, &fault))
		abort();
	check_triangles(&polygon, &out);
	/* Without an outer ring what the holes do does not matter. */
	if (out.outcome == TRIANGULATION_EMPTY && polygon.ring_count &&
		strstr(out.reason, "outer ring"))
		polygon.ring_count = 1;
	if (polygon.placement->bend == 0)
		check_cover(&polygon, &out);
	return 0;
}
