#include "triangulate.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "check.h"
#include "number.h"

enum { MOST_RINGS = 8, MOST_VERTICES = 64, ANY = -1 };

/*
 * A polygon as text, "x,y x,y … / hole / …", and what must become of it. The
 * areas are computed by hand.
 */
struct drawing {
	const char *rings;
	double area;
	enum triangulation_outcome outcome;
	int triangles, extra; /* ANY: of no matter */
};

struct polygon {
	struct tcs_point vertices[MOST_VERTICES];
	uint32_t rings[MOST_RINGS];
	size_t ring_count, vertex_count;
};

/* ---- drawing and placing ---------------------------------------------------- */

static void
polygon_draw(struct polygon *polygon, const char *text)
{
	const char *at = text, *end = text + strlen(text);

	memset(polygon, 0, sizeof *polygon);
	polygon->ring_count = 1;
	while (at < end) {
		struct tcs_point *point;

		if (*at == '/') {
			polygon->ring_count++;
			at += 2;
			continue;
		}
		point = &polygon->vertices[polygon->vertex_count++];
		polygon->rings[polygon->ring_count - 1]++;
		at = number_parse(at, end, &point->x);
		at = number_parse(at + 1, end, &point->y);
		at += at < end;
	}
}

/* Columns: where x, y and the plane's own normal point. */
static const struct placement {
	double turn[9];
	struct tcs_point origin;
} placements[] = {
	{{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}},
	{{0, 0, 1, 1, 0, 0, 0, 1, 0}, {0, 0, 0}},
	{{0, 1, 0, 0, 0, 1, 1, 0, 0}, {0, 0, 0}},
	{{-1, 0, 0, 0, 1, 0, 0, 0, -1}, {691051, 5333770, 512}},
	{{0.6, 0, 0.8, 0.8, 0, -0.6, 0, 1, 0}, {691051, 5333770, 512}},
	{{0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6}, {0, 5000000, -100}},
};
enum { PLACEMENTS = sizeof placements / sizeof *placements };

static struct tcs_point
turned(const struct placement *place, struct tcs_point at)
{
	const double *m = place->turn;

	return (struct tcs_point){m[0] * at.x + m[1] * at.y + m[2] * at.z,
		m[3] * at.x + m[4] * at.y + m[5] * at.z,
		m[6] * at.x + m[7] * at.y + m[8] * at.z};
}

static void
polygon_place(struct polygon *polygon, const struct placement *place)
{
	for (size_t i = 0; i < polygon->vertex_count; i++) {
		struct tcs_point at = turned(place, polygon->vertices[i]);

		polygon->vertices[i] =
			(struct tcs_point){at.x + place->origin.x,
				at.y + place->origin.y, at.z + place->origin.z};
	}
}

static void
ring_reverse(struct polygon *polygon, size_t ring)
{
	struct tcs_point *at = polygon->vertices, swap;
	uint32_t count = polygon->rings[ring];

	for (size_t i = 0; i < ring; i++)
		at += polygon->rings[i];
	for (uint32_t i = 0; i < count / 2; i++) {
		swap = at[i];
		at[i] = at[count - 1 - i];
		at[count - 1 - i] = swap;
	}
}

/* ---- verifying --------------------------------------------------------------- */

static struct tcs_point
corner_of(const struct polygon *polygon, const struct triangulation *out,
	uint32_t corner)
{
	if (corner < polygon->vertex_count)
		return polygon->vertices[corner];
	return out->extra[corner - polygon->vertex_count];
}

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* The area along the normal: positive for a triangle that winds with it. */
static double
triangle_area(const struct polygon *polygon, const struct triangulation *out,
	size_t i)
{
	const uint32_t *corner = out->triangles[i].corner;
	struct tcs_point a = corner_of(polygon, out, corner[0]);
	struct tcs_point b = corner_of(polygon, out, corner[1]);
	struct tcs_point c = corner_of(polygon, out, corner[2]);
	struct tcs_point u = {b.x - a.x, b.y - a.y, b.z - a.z};
	struct tcs_point v = {c.x - a.x, c.y - a.y, c.z - a.z};
	struct tcs_point cross = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z,
		u.x * v.y - u.y * v.x};

	return dot(cross, out->normal) / 2;
}

static bool
triangles_are_sound(
	const struct polygon *polygon, const struct triangulation *out)
{
	double sum = 0;

	for (size_t i = 0; i < out->triangle_count; i++) {
		const uint32_t *corner = out->triangles[i].corner;
		double area;

		for (int j = 0; j < 3; j++) {
			if (corner[j] >=
				polygon->vertex_count + out->extra_count)
				return false;
		}
		area = triangle_area(polygon, out, i);
		if (!(area > -1e-9))
			return false;
		sum += area;
	}
	return fabs(sum - out->area) <= 1e-7 * (1 + sum);
}

static bool
becomes(const struct drawing *drawing, const struct polygon *polygon,
	bool exact)
{
	struct triangulator *triangulator = triangulator_new();
	struct triangulation out;
	struct tcs_fault fault;
	bool fine;

	if (!triangulator ||
		triangulate(triangulator, polygon->vertices, polygon->rings,
			polygon->ring_count, &out, &fault))
		return false;
	fine = triangles_are_sound(polygon, &out) &&
		fabs(out.area - drawing->area) <= 1e-6 &&
		(out.outcome == TRIANGULATION_WHOLE) == !out.reason;
	if (exact)
		fine = fine && out.outcome == drawing->outcome &&
			(drawing->triangles == ANY ||
				(int)out.triangle_count ==
					drawing->triangles) &&
			(drawing->extra == ANY ||
				(int)out.extra_count == drawing->extra);
	if (!fine)
		fprintf(stderr, "%s: area %.9g, %zu triangles, %zu extra, %s\n",
			drawing->rings, out.area, out.triangle_count,
			out.extra_count, out.reason ? out.reason : "whole");
	triangulator_free(triangulator);
	return fine;
}

/* In every plane and both ways round. Rounding may turn touching into not. */
static void
check_drawings(const struct drawing *drawings)
{
	for (; drawings->rings; drawings++) {
		for (size_t i = 0; i < PLACEMENTS; i++) {
			struct polygon polygon;

			polygon_draw(&polygon, drawings->rings);
			polygon_place(&polygon, &placements[i]);
			CHECK(becomes(drawings, &polygon, i < 4));
			ring_reverse(&polygon, 0);
			CHECK(becomes(drawings, &polygon, i < 4));
			ring_reverse(&polygon, polygon.ring_count - 1);
			CHECK(becomes(drawings, &polygon, i < 4));
		}
	}
}

#define WHOLE TRIANGULATION_WHOLE
#define REPAIRED TRIANGULATION_REPAIRED
#define EMPTY TRIANGULATION_EMPTY

/* ---- ordinary polygons -------------------------------------------------------- */

static void
simple_rings_use_all_their_vertices(void)
{
	static const struct drawing drawings[] = {
		{"0,0 4,0 0,3", 6, WHOLE, 1, 0},
		{"0,0 4,0 4,3 0,3", 12, WHOLE, 2, 0},
		/* a dart: one diagonal only */
		{"0,0 4,4 0,2 -4,4", 8, WHOLE, 2, 0},
		/* a gable */
		{"0,0 4,0 4,3 2,5 0,3", 16, WHOLE, 3, 0},
		/* an L, a U and a plus */
		{"0,0 4,0 4,2 2,2 2,4 0,4", 12, WHOLE, 4, 0},
		{"0,0 5,0 5,4 4,4 4,1 1,1 1,4 0,4", 11, WHOLE, 6, 0},
		{"1,0 2,0 2,1 3,1 3,2 2,2 2,3 1,3 1,2 0,2 0,1 1,1", 5, WHOLE,
			10, 0},
		/* a comb with slanted teeth */
		{"0,0 9,0 9,3 8,1 7,3 6,1 5,3 4,1 3,3 2,1 1,3 0,1", 18, WHOLE,
			10, 0},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

static void
vertices_on_straight_edges_stay_corners(void)
{
	static const struct drawing drawings[] = {
		{"0,0 2,0 4,0 0,3", 6, WHOLE, 2, 0},
		{"0,0 4,0 4,3 2,3 0,3", 12, WHOLE, 3, 0},
		{"0,0 1,0 2,0 3,0 4,0 4,3 0,3", 12, WHOLE, 5, 0},
		{"0,0 1,0 4,0 4,1 4,3 3,3 0,3 0,2", 12, WHOLE, 6, 0},
		{"0,0 1,1 2,2 3,3 0,3", 4.5, WHOLE, 3, 0},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

static void
holes_are_left_out(void)
{
	static const struct drawing drawings[] = {
		{"0,0 4,0 4,4 0,4 / 1,1 3,1 3,3 1,3", 12, WHOLE, 8, 0},
		{"0,0 9,0 9,3 0,3 / 1,1 2,1 2,2 1,2 / 4,1 5,1 5,2 4,2 / "
		 "7,1 8,1 8,2 7,2",
			24, WHOLE, 20, 0},
		/* holes beside and above each other */
		{"0,0 5,0 5,5 0,5 / 1,1 2,1 2,2 1,2 / 3,1 4,1 4,2 3,2 / "
		 "1,3 2,3 2,4 1,4 / 3,3 4,3 4,4 3,4",
			21, WHOLE, 26, 0},
		/* a hole in the bay of a hole */
		{"0,0 7,0 7,7 0,7 / 1,1 6,1 6,6 5,6 5,2 2,2 2,6 1,6 / "
		 "3,3 4,3 4,4 3,4",
			49 - 13 - 1, WHOLE, 18, 0},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

/* ---- degenerate ones ----------------------------------------------------------- */

static void
repeated_points_change_nothing(void)
{
	static const struct drawing drawings[] = {
		{"0,0 0,0 4,0 4,3 4,3 4,3 0,3 0,0", 12, WHOLE, 2, 0},
		{"0,0 4,0 4,4 0,4 / 1,1 1,1 3,1 3,3 3,3 1,3", 12, WHOLE, 8, 0},
		{"0,0 4,0 4,3 0,3 / 1,1 1,1 1,1", 12, WHOLE, 2, 0},
		{"0,0 4,0 4,3 0,3 / 1,1 2,2", 12, WHOLE, 2, 0},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

static void
touching_holes_keep_their_area(void)
{
	static const struct drawing drawings[] = {
		/* at a vertex of the outer ring */
		{"0,0 4,0 4,4 0,4 / 0,0 2,1 1,2", 14.5, WHOLE, ANY, 0},
		/* with a vertex on its edge */
		{"0,0 4,0 4,4 0,4 / 2,0 3,2 1,2", 14, WHOLE, ANY, 0},
		/* along a part of its edge */
		{"0,0 4,0 4,4 0,4 / 1,0 3,0 3,2 1,2", 12, WHOLE, ANY, 0},
		/* along a whole edge */
		{"0,0 4,0 4,4 0,4 / 0,0 4,0 4,2 0,2", 8, WHOLE, ANY, 0},
		/* from edge to edge, so that two parts are left */
		{"0,0 4,0 4,4 0,4 / 1,0 2,0 2,4 1,4", 12, WHOLE, ANY, 0},
		/* each other, at a vertex and along an edge */
		{"0,0 6,0 6,6 0,6 / 1,1 3,1 3,3 1,3 / 3,3 5,3 5,5 3,5", 28,
			WHOLE, ANY, 0},
		{"0,0 6,0 6,6 0,6 / 1,1 3,1 3,3 1,3 / 3,1 5,1 5,3 3,3", 28,
			WHOLE, ANY, 0},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

static void
rings_that_touch_themselves_keep_their_area(void)
{
	static const struct drawing drawings[] = {
		/* a spike out, a spike in, a spike along an edge */
		{"0,0 4,0 4,2 6,2 4,2 4,4 0,4", 16, WHOLE, ANY, 0},
		{"0,0 4,0 4,2 2,2 4,2 4,4 0,4", 16, WHOLE, ANY, 0},
		{"0,0 6,0 4,0 4,4 0,4", 16, WHOLE, ANY, 0},
		/* two squares that meet in a vertex, wound alike */
		{"0,0 2,0 2,2 4,2 4,4 2,4 2,2 0,2", 8, WHOLE, ANY, 0},
		{"0,0 2,2 4,0 4,4 2,2 0,4", 8, WHOLE, ANY, 0},
		/* a vertex on a distant edge */
		{"0,0 4,0 4,4 2,0 0,4", 8, WHOLE, ANY, 0},
		/* a hole through a seam */
		{"0,0 6,0 6,6 0,6 0,0 2,2 2,4 4,4 4,2 2,2", 32, WHOLE, ANY, 0},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

static void
crossing_rings_follow_the_odd_even_rule(void)
{
	static const struct drawing drawings[] = {
		/* a bow-tie of two equal halves, and one of two unequal ones */
		{"0,0 4,4 4,0 0,4", 8, REPAIRED, ANY, 1},
		{"0,0 6,0 0,4 6,4", 12, REPAIRED, ANY, 1},
		{"0,0 6,3 6,0 0,6", 15, REPAIRED, ANY, 1},
		/* a figure of eight with its waist at a vertex */
		{"0,0 2,2 4,4 4,0 2,2 0,4", 8, REPAIRED, ANY, 0},
		/* a hole that crosses the outer ring */
		{"0,0 4,0 4,4 0,4 / 3,1 5,1 5,3 3,3", 16, REPAIRED, ANY, 2},
		/* two holes that overlap */
		{"0,0 8,0 8,4 0,4 / 1,1 4,1 4,3 1,3 / 3,1 6,1 6,3 3,3",
			32 - 4 - 4, REPAIRED, ANY, ANY},
		/* a hole outside, and one in a hole */
		{"0,0 4,0 4,4 0,4 / 5,0 6,0 6,1 5,1", 17, REPAIRED, ANY, 0},
		{"0,0 8,0 8,8 0,8 / 1,1 7,1 7,7 1,7 / 3,3 5,3 5,5 3,5",
			64 - 36 + 4, REPAIRED, ANY, 0},
		/* a square and a diamond that stick out of each other */
		{"0,0 4,0 4,4 0,4 / 2,-1 5,2 2,5 -1,2", 6, REPAIRED, ANY, 8},
		/* an arm that bulges into the other, from below and above */
		{"0,0 10,0 10,2 8,2 6,5 4,2 2,2 2,4 10,4 10,6 0,6",
			44 + 6 - 4.0 / 3, REPAIRED, ANY, 2},
		{"0,0 10,0 10,2 2,2 2,4 4,4 6,1 8,4 10,4 10,6 0,6",
			44 + 6 - 4.0 / 3, REPAIRED, ANY, 2},
		/* a strip that comes back over itself */
		{"0,0 4,0 4,3 1,3 1,-1 3,-1 3,4 0,4", 11, REPAIRED, ANY, 3},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

static void
without_area_nothing_is_left(void)
{
	static const struct drawing drawings[] = {
		{"0,0", 0, EMPTY, 0, 0},
		{"0,0 4,0", 0, EMPTY, 0, 0},
		{"1,1 1,1 1,1 1,1", 0, EMPTY, 0, 0},
		{"0,0 2,2 4,4", 0, EMPTY, 0, 0},
		{"0,0 3,1 6,2 9,3", 0, EMPTY, 0, 0},
		{"0,0 4,0 4,4 4,0", 0, EMPTY, 0, 0},
		{"0,0 4,0 4,4 0,4 / 0,0 4,0 4,4 0,4", 0, EMPTY, 0, 0},
		{"0,0 4,0 4,4 0,4 / 4,4 0,4 0,0 4,0", 0, EMPTY, 0, 0},
		{"0,0 4,0 4,4 0,4 0,0 4,0 4,4 0,4", 0, EMPTY, 0, 0},
		{NULL, 0, 0, 0, 0},
	};

	check_drawings(drawings);
}

/* ---- properties ----------------------------------------------------------------- */

struct trial {
	struct triangulator *triangulator;
	struct triangulation out;
	struct tcs_fault fault;
};

static void
trial_run(struct trial *trial, const struct tcs_point *vertices,
	const uint32_t *rings, size_t ring_count)
{
	trial->triangulator = triangulator_new();
	CHECK(trial->triangulator != NULL);
	CHECK(!triangulate(trial->triangulator, vertices, rings, ring_count,
		&trial->out, &trial->fault));
}

static void
a_quad_is_cut_along_its_shorter_diagonal(void)
{
	static const struct tcs_point wide[] = {
		{0, 0, 0}, {5, -1, 0}, {10, 0, 0}, {5, 1, 0}};
	static const struct tcs_point bent[] = {
		{0, 0, 0}, {2, 0, 1}, {2, 2, 0}, {0, 2, 1}};
	static const uint32_t rings[] = {4};
	struct trial trial;

	trial_run(&trial, wide, rings, 1);
	CHECK(trial.out.triangle_count == 2);
	for (int i = 0; i < 2; i++) {
		const uint32_t *corner = trial.out.triangles[i].corner;

		CHECK((corner[0] == 1) + (corner[1] == 1) + (corner[2] == 1) ==
			1);
		CHECK((corner[0] == 3) + (corner[1] == 3) + (corner[2] == 3) ==
			1);
	}
	triangulator_free(trial.triangulator);
	trial_run(&trial, bent, rings, 1);
	CHECK(trial.out.outcome == TRIANGULATION_WHOLE);
	CHECK(fabs(trial.out.flatness - 0.5) < 1e-12);
	CHECK(fabs(trial.out.area - 4) < 1e-12);
	CHECK(trial.out.triangles[0].corner[0] == 0);
	triangulator_free(trial.triangulator);
}

static void
the_normal_is_that_of_the_outer_ring(void)
{
	static const struct tcs_point roof[] = {{691051, 5333770, 500},
		{691055, 5333770, 503}, {691055, 5333780, 503},
		{691051, 5333780, 500}};
	static const uint32_t rings[] = {4};
	struct trial trial;

	trial_run(&trial, roof, rings, 1);
	CHECK(fabs(trial.out.normal.x + 0.6) < 1e-12);
	CHECK(fabs(trial.out.normal.y) < 1e-12);
	CHECK(fabs(trial.out.normal.z - 0.8) < 1e-12);
	CHECK(fabs(trial.out.area - 50) < 1e-9);
	CHECK(trial.out.flatness < 1e-9);
	triangulator_free(trial.triangulator);
}

/* A millimetre step at a northing of five million metres. */
static void
small_details_far_from_the_origin_survive(void)
{
	static const struct tcs_point step[] = {{691051, 5333770, 500},
		{691061, 5333770, 500}, {691061, 5333780, 500},
		{691056, 5333780, 500}, {691056, 5333779.999, 500},
		{691051, 5333779.999, 500}};
	static const uint32_t rings[] = {6};
	struct trial trial;

	trial_run(&trial, step, rings, 1);
	CHECK(trial.out.outcome == TRIANGULATION_WHOLE);
	CHECK(trial.out.triangle_count == 4);
	CHECK(fabs(trial.out.area - 99.995) < 1e-7);
	triangulator_free(trial.triangulator);
}

static void
where_edges_cross_the_extra_vertex_is_exact(void)
{
	static const struct tcs_point tie[] = {{691051, 5333770, 500},
		{691054, 5333774, 503}, {691054, 5333774, 500},
		{691051, 5333770, 506}};
	static const uint32_t rings[] = {4};
	struct trial trial;

	trial_run(&trial, tie, rings, 1);
	CHECK(trial.out.outcome == TRIANGULATION_REPAIRED);
	CHECK(trial.out.extra_count == 1);
	CHECK(fabs(trial.out.extra[0].x - 691053) < 1e-9);
	CHECK(fabs(trial.out.extra[0].y - (5333770 + 8.0 / 3)) < 1e-8);
	CHECK(fabs(trial.out.extra[0].z - 502) < 1e-9);
	triangulator_free(trial.triangulator);
}

/* In the plane: twice the signed area. */
static double
turn(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static bool
covers(const struct polygon *polygon, const struct triangulation *out,
	struct tcs_point at)
{
	for (size_t i = 0; i < out->triangle_count; i++) {
		const uint32_t *corner = out->triangles[i].corner;
		struct tcs_point a = corner_of(polygon, out, corner[0]);
		struct tcs_point b = corner_of(polygon, out, corner[1]);
		struct tcs_point c = corner_of(polygon, out, corner[2]);
		bool left = turn(a, b, at) > 0;

		if (turn(a, b, c) != 0 && (turn(b, c, at) > 0) == left &&
			(turn(c, a, at) > 0) == left)
			return true;
	}
	return false;
}

/*
 * Rings along the diagonal from 0,0 to 15,15, over and over: GLU loses where
 * they cross the second one's edge from 9,11 to 11,9, and fills the far side
 * of the diagonal, of the same area.
 */
static void
a_repair_fills_the_right_side(void)
{
	static const char rings[] =
		"2,12 3,12 13,15 14,0 0,0 0,0 15,15 3,3 9,1 2,3 0,0 15,15 "
		"15,15 15,15 15,15 15,5 0,2 0,0 12,12 / "
		"0,0 9,11 11,9 11,5 2,13 0,0 15,15 / 15,15 15,15 15,15 15,15 "
		"15,15 1,1 13,13 9,9 10,5 2,12 1,4 0,0 0,0 2,13 13,13";
	static const struct tcs_point inside = {-10.575e60, 9.4065e60, 0};
	static const struct tcs_point outside = {-9.364e60, 10.6135e60, 0};
	struct polygon polygon;
	struct trial trial;

	polygon_draw(&polygon, rings);
	for (size_t i = 0; i < polygon.vertex_count; i++) {
		polygon.vertices[i].x *= -1e60;
		polygon.vertices[i].y *= 1e60;
	}
	trial_run(&trial, polygon.vertices, polygon.rings, polygon.ring_count);
	CHECK(trial.out.outcome == TRIANGULATION_REPAIRED);
	CHECK(covers(&polygon, &trial.out, inside));
	CHECK(!covers(&polygon, &trial.out, outside));
	triangulator_free(trial.triangulator);
}

static void
extreme_coordinates_end_quietly(void)
{
	static const double sizes[] = {1e308, 1e200, 1e100, 1e-100, 1e-300};
	static const uint32_t rings[] = {4};

	for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
		double s = sizes[i];
		struct tcs_point square[] = {
			{-s, -s, 0}, {s, -s, 0}, {s, s, 0}, {-s, s, 0}};
		struct trial trial;

		trial_run(&trial, square, rings, 1);
		CHECK(trial.out.outcome == TRIANGULATION_EMPTY);
		CHECK(trial.out.reason != NULL);
		triangulator_free(trial.triangulator);
	}
}

static void
a_tangle_too_large_to_repair_is_refused(void)
{
	enum { COUNT = 3000 };
	struct tcs_point *star = calloc(COUNT, sizeof *star);
	uint32_t rings[] = {COUNT};
	struct trial trial;

	CHECK(star != NULL);
	for (int i = 0; star && i < COUNT; i++)
		star[i] = (struct tcs_point){
			cos(i * 2.4) * (1 + i), sin(i * 2.4) * (1 + i), 0};
	trial_run(&trial, star, rings, 1);
	CHECK(trial.out.outcome == TRIANGULATION_EMPTY);
	triangulator_free(trial.triangulator);
	free(star);
}

enum { TEETH = 50000, COMB = 2 * TEETH + 3 };

/*
 * A comb whose teeth the sweep line meets all at the same time, and a hole that
 * touches it between two teeth.
 */
static void
comb_draw(struct tcs_point comb[COMB + 3])
{
	for (int i = 0; i < TEETH; i++) {
		comb[2 * i] = (struct tcs_point){100, i, 0};
		comb[2 * i + 1] = (struct tcs_point){1, i + 0.5, 0};
	}
	comb[2 * TEETH] = (struct tcs_point){100, TEETH, 0};
	comb[2 * TEETH + 1] = (struct tcs_point){0, TEETH, 0};
	comb[2 * TEETH + 2] = (struct tcs_point){0, 0, 0};
	comb[COMB] = (struct tcs_point){1, 0.5, 0};
	comb[COMB + 1] = (struct tcs_point){0.5, 0.4, 0};
	comb[COMB + 2] = (struct tcs_point){0.5, 0.6, 0};
}

static void
a_ring_of_a_hundred_thousand_points_takes_no_time(void)
{
	struct tcs_point *comb = calloc(COMB + 3, sizeof *comb);
	uint32_t rings[] = {COMB, 3};
	clock_t begin = clock();
	struct trial trial;

	CHECK(comb != NULL);
	if (!comb)
		return;
	comb_draw(comb);
	trial_run(&trial, comb, rings, 1);
	CHECK(trial.out.outcome == TRIANGULATION_WHOLE);
	CHECK(trial.out.triangle_count == 2 * TEETH + 1);
	CHECK(fabs(trial.out.area - 50.5 * TEETH) < 1e-3);
	triangulator_free(trial.triangulator);
	trial_run(&trial, comb, rings, 2);
	CHECK(trial.out.outcome == TRIANGULATION_WHOLE);
	CHECK(fabs(trial.out.area - (50.5 * TEETH - 0.05)) < 1e-3);
	triangulator_free(trial.triangulator);
	CHECK((double)(clock() - begin) / CLOCKS_PER_SEC < 2);
	free(comb);
}

static const struct check_test tests[] = {
	CHECK_TEST(simple_rings_use_all_their_vertices),
	CHECK_TEST(vertices_on_straight_edges_stay_corners),
	CHECK_TEST(holes_are_left_out),
	CHECK_TEST(repeated_points_change_nothing),
	CHECK_TEST(touching_holes_keep_their_area),
	CHECK_TEST(rings_that_touch_themselves_keep_their_area),
	CHECK_TEST(crossing_rings_follow_the_odd_even_rule),
	CHECK_TEST(without_area_nothing_is_left),
	CHECK_TEST(a_quad_is_cut_along_its_shorter_diagonal),
	CHECK_TEST(the_normal_is_that_of_the_outer_ring),
	CHECK_TEST(small_details_far_from_the_origin_survive),
	CHECK_TEST(where_edges_cross_the_extra_vertex_is_exact),
	CHECK_TEST(a_repair_fills_the_right_side),
	CHECK_TEST(extreme_coordinates_end_quietly),
	CHECK_TEST(a_tangle_too_large_to_repair_is_refused),
	CHECK_TEST(a_ring_of_a_hundred_thousand_points_takes_no_time),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
