#include "town_building.h"

#include <math.h>
#include <string.h>

#define OVERHANG 0.5 /* of the eaves */
#define FASCIA 0.25 /* thickness of the roof at the eaves */

static struct local
local(double u, double v, double z)
{
	return (struct local){u, v, z};
}

/* Front and back wall of an extrusion or block from (u0, v0) to (u1, v1). */
static void
front_windows(struct shape *shape, const struct body *body, size_t front,
	size_t back, double v0, double v1)
{
	double u0 = body->u, u1 = body->u + body->width;

	shape_windows(shape, front, local(u0, v0, 0), local(u1, v0, 0),
		body->storeys, body->bays, body->door);
	shape_windows(shape, back, local(u1, v1, 0), local(u0, v1, 0),
		body->storeys, body->bays, false);
}

/*
 *            5
 *          ·   ·        profile in (v, z); the classes name the edges
 *       6·       ·4     from each point to the next
 *       7_8     2_3
 *         |     |
 *         0-----1
 */
void
raise_gabled(struct shape *shape, const struct body *body)
{
	static const enum face_class classes[] = {
		FACE_GROUND,
		FACE_WALL,
		FACE_EAVES,
		FACE_ROOF,
		FACE_ROOF,
		FACE_ROOF,
		FACE_ROOF,
		FACE_EAVES,
		FACE_WALL,
	};
	double d = body->depth, h = body->eaves;
	double fall = OVERHANG * body->rise / (d / 2);
	const double profile[][2] = {
		{0, 0},
		{d, 0},
		{d, h},
		{d + OVERHANG, h - fall},
		{d + OVERHANG, h - fall + FASCIA},
		{d / 2, h + body->rise + FASCIA},
		{-OVERHANG, h - fall + FASCIA},
		{-OVERHANG, h - fall},
		{0, h},
	};
	double u0 = body->u, u1 = body->u + body->width;
	size_t first = shape_extrude(shape, profile, classes, 9, u0, u1);

	shape->faces[first + 9].party = true;
	front_windows(shape, body, first + 8, first + 1, 0, d);
	if (body->rise > 3) {
		shape_opening(shape, first + 9, local(u0, d / 2 + 0.5, h + 0.5),
			local(u0, d / 2 - 0.5, h + 0.5), h + 1.7, false);
		shape_opening(shape, first + 10,
			local(u1, d / 2 - 0.5, h + 0.5),
			local(u1, d / 2 + 0.5, h + 0.5), h + 1.7, false);
	}
}

/* The walls and floor of a box without a lid; the front wall is the first. */
static size_t
open_box(struct shape *shape, const struct body *body)
{
	size_t first = shape->face_count;
	double u0 = body->u, u1 = u0 + body->width, d = body->depth;

	shape_box(shape, local(u0, 0, 0), local(u1, d, body->eaves));
	shape->face_count--; /* the lid */
	shape->ring_count--;
	shape->spot_count -= 4;
	return first;
}

/* A ring of eaves seen from below, and of fascias, around the walls. */
static void
eaves(struct shape *shape, const struct body *body)
{
	double u0 = body->u, u1 = u0 + body->width, d = body->depth;
	double o = OVERHANG, h = body->eaves;
	const double outer[][2] = {
		{u0 - o, -o},
		{u1 + o, -o},
		{u1 + o, d + o},
		{u0 - o, d + o},
	};
	const double inner[][2] = {{u0, 0}, {u1, 0}, {u1, d}, {u0, d}};

	shape_face(shape, FACE_EAVES);
	for (size_t i = 4; i-- > 0;)
		shape_point(shape, outer[i][0], outer[i][1], h);
	shape_hole(shape);
	for (size_t i = 0; i < 4; i++)
		shape_point(shape, inner[i][0], inner[i][1], h);
	for (size_t i = 0; i < 4; i++) {
		const double *a = outer[i], *b = outer[(i + 1) % 4];
		const struct local quad[] = {
			{a[0], a[1], h},
			{b[0], b[1], h},
			{b[0], b[1], h + FASCIA},
			{a[0], a[1], h + FASCIA},
		};

		shape_polygon(shape, FACE_ROOF, quad, 4);
	}
}

void
raise_hipped(struct shape *shape, const struct body *body)
{
	double u0 = body->u - OVERHANG, u1 = u0 + body->width + 2 * OVERHANG;
	double v0 = -OVERHANG, v1 = body->depth + OVERHANG;
	double z = body->eaves + FASCIA, top = z + body->rise;
	double half = (v1 - v0) / 2;
	struct local a = local(u0, v0, z), b = local(u1, v0, z);
	struct local c = local(u1, v1, z), d = local(u0, v1, z);
	struct local left = local(u0 + half, v0 + half, top);
	struct local right = local(u1 - half, v0 + half, top);
	bool pyramid = fabs(body->width - body->depth) < 1e-9;
	size_t first = open_box(shape, body);

	front_windows(shape, body, first + 1, first + 3, 0, body->depth);
	eaves(shape, body);
	shape_polygon(shape, FACE_ROOF, (struct local[]){a, b, right, left},
		pyramid ? 3 : 4);
	shape_polygon(shape, FACE_ROOF, (struct local[]){b, c, right}, 3);
	shape_polygon(shape, FACE_ROOF, (struct local[]){c, d, left, right},
		pyramid ? 3 : 4);
	shape_polygon(shape, FACE_ROOF, (struct local[]){d, a, left}, 3);
}

void
raise_flat(struct shape *shape, const struct body *body)
{
	double u0 = body->u, u1 = u0 + body->width, d = body->depth;
	double h = body->eaves, rim = 0.4, top = h + 0.6;
	const double inner[][2] = {
		{u0 + rim, rim},
		{u1 - rim, rim},
		{u1 - rim, d - rim},
		{u0 + rim, d - rim},
	};
	struct body high = *body;
	size_t first;

	high.eaves = top;
	first = open_box(shape, &high);
	front_windows(shape, body, first + 1, first + 3, 0, d);
	shape_polygon(shape, FACE_ROOF,
		(struct local[]){
			{u0, 0, top}, {u1, 0, top}, {u1, d, top}, {u0, d, top}},
		4);
	shape_hole(shape);
	for (size_t i = 4; i-- > 0;)
		shape_point(shape, inner[i][0], inner[i][1], top);
	for (size_t i = 0; i < 4; i++) {
		const double *a = inner[(i + 1) % 4], *b = inner[i];

		shape_polygon(shape, FACE_WALL,
			(struct local[]){{a[0], a[1], h}, {b[0], b[1], h},
				{b[0], b[1], top}, {a[0], a[1], top}},
			4);
	}
	shape_face(shape, FACE_ROOF);
	for (size_t i = 0; i < 4; i++)
		shape_point(shape, inner[i][0], inner[i][1], h);
}

/*
 *    5---4          two wings of width w, ridges meeting at the middle m of
 *    | · |          the corner, with a hip towards 0 and a valley towards 3
 *    | · 3-----2
 *    | m · · · |
 *    0---------1
 */
void
raise_ell(struct shape *shape, const struct body *body)
{
	double u = body->u, a = body->width, b = body->depth, w = 8.5;
	double h = body->eaves, top = h + body->rise;
	const double outline[][2] = {
		{u, 0},
		{u + a, 0},
		{u + a, w},
		{u + w, w},
		{u + w, b},
		{u, b},
	};
	struct local m = local(u + w / 2, w / 2, top);
	struct local east = local(u + a, w / 2, top);
	struct local north = local(u + w / 2, b, top);
	struct local p[6];
	size_t first = shape_face(shape, FACE_GROUND);

	for (size_t i = 6; i-- > 0;)
		shape_point(shape, outline[i][0], outline[i][1], 0);
	for (size_t i = 0; i < 6; i++)
		p[i] = local(outline[i][0], outline[i][1], h);
	for (size_t i = 0; i < 6; i++) {
		struct local q = p[(i + 1) % 6];

		shape_face(shape, FACE_WALL);
		shape_point(shape, p[i].u, p[i].v, 0);
		shape_point(shape, q.u, q.v, 0);
		shape_point(shape, q.u, q.v, h);
		if (i == 1)
			shape_point(shape, east.u, east.v, east.z);
		if (i == 4)
			shape_point(shape, north.u, north.v, north.z);
		shape_point(shape, p[i].u, p[i].v, h);
	}
	shape_polygon(
		shape, FACE_ROOF, (struct local[]){p[0], p[1], east, m}, 4);
	shape_polygon(
		shape, FACE_ROOF, (struct local[]){p[2], p[3], m, east}, 4);
	shape_polygon(
		shape, FACE_ROOF, (struct local[]){p[3], p[4], north, m}, 4);
	shape_polygon(
		shape, FACE_ROOF, (struct local[]){p[5], p[0], m, north}, 4);
	shape_windows(shape, first + 1, local(u, 0, 0), local(u + a, 0, 0),
		body->storeys, body->bays, body->door);
	shape_windows(shape, first + 6, local(u, b, 0), local(u, 0, 0),
		body->storeys, body->bays - 1, false);
}

/* The corners of nested rectangles: 0 the outer wall, 1 the ridge, 2 the yard.
 */
static struct local
court_corner(const struct body *body, size_t corner, double inset, double z)
{
	bool right = corner == 1 || corner == 2, far = corner >= 2;

	return local(right ? body->u + body->width - inset : body->u + inset,
		far ? body->depth - inset : inset, z);
}

static void
court_side(struct shape *shape, const struct body *body, size_t side)
{
	double w = 10, h = body->eaves, top = h + body->rise;
	size_t next = (side + 1) % 4;
	struct local a = court_corner(body, side, 0, 0);
	struct local b = court_corner(body, next, 0, 0);
	struct local c = court_corner(body, side, w, 0);
	struct local d = court_corner(body, next, w, 0);
	struct local ridge_a = court_corner(body, side, w / 2, top);
	struct local ridge_b = court_corner(body, next, w / 2, top);
	size_t face = shape_polygon(shape, FACE_WALL,
		(struct local[]){a, b, {b.u, b.v, h}, {a.u, a.v, h}}, 4);

	shape_windows(shape, face, a, b, body->storeys, body->bays,
		body->door && side % 2 == 0);
	face = shape_polygon(shape, FACE_WALL,
		(struct local[]){d, c, {c.u, c.v, h}, {d.u, d.v, h}}, 4);
	shape_windows(shape, face, d, c, body->storeys, body->bays / 2, false);
	a.z = b.z = c.z = d.z = h;
	shape_polygon(
		shape, FACE_ROOF, (struct local[]){a, b, ridge_b, ridge_a}, 4);
	shape_polygon(
		shape, FACE_ROOF, (struct local[]){d, c, ridge_a, ridge_b}, 4);
}

void
raise_court(struct shape *shape, const struct body *body)
{
	shape_face(shape, FACE_GROUND);
	for (size_t i = 4; i-- > 0;) {
		struct local p = court_corner(body, i, 0, 0);

		shape_point(shape, p.u, p.v, 0);
	}
	shape_hole(shape);
	for (size_t i = 0; i < 4; i++) {
		struct local p = court_corner(body, i, 10, 0);

		shape_point(shape, p.u, p.v, 0);
	}
	for (size_t side = 0; side < 4; side++)
		court_side(shape, body, side);
}

void
raise_round(struct shape *shape, const struct body *body)
{
	double r = body->width / 2, u = body->u + r, v = body->depth / 2;
	double outline[8][2], top = body->eaves + body->rise;

	for (size_t i = 0; i < 8; i++) {
		double angle = ((double)i + 0.5) * acos(-1) / 4;

		outline[i][0] = u + r * cos(angle);
		outline[i][1] = v + r * sin(angle);
	}
	shape_block(shape, (const double(*)[2])outline, 8, 0, body->eaves);
	shape->face_count--;
	shape->ring_count--;
	shape->spot_count -= 8;
	for (size_t i = 0; i < 8; i++) {
		const double *a = outline[i], *b = outline[(i + 1) % 8];

		shape_polygon(shape, FACE_ROOF,
			(struct local[]){{a[0], a[1], body->eaves},
				{b[0], b[1], body->eaves}, {u, v, top}},
			3);
	}
}
