#include "triangulate.h"

#include <stdlib.h>

#include "planar.h"
#include "planar_repair.h"
#include "planar_slabs.h"
#include "sweep.h"

struct triangulator {
	struct planar polygon;
	struct planar_points nudged;
	struct sweep sweep;
	struct triangle_list triangles;
	struct point_list extra;
};

/* Areas that agree to this part of the polygon's square are the same. */
#define ROUNDING 1e-8

struct triangulator *
triangulator_new(void)
{
	return calloc(1, sizeof(struct triangulator));
}

void
triangulator_free(struct triangulator *triangulator)
{
	if (!triangulator)
		return;
	planar_release(&triangulator->polygon);
	array_release(&triangulator->nudged);
	sweep_release(&triangulator->sweep);
	array_release(&triangulator->triangles);
	array_release(&triangulator->extra);
	free(triangulator);
}

static enum tcs_status
end_empty(struct triangulation *out, const char *reason)
{
	*out = (struct triangulation){
		.outcome = TRIANGULATION_EMPTY, .reason = reason};
	return TCS_OK;
}

/* `area` is that of the projection, which left the third axis out. */
static enum tcs_status
end_full(const struct triangulator *t, double area, double flatness,
	struct triangulation *out)
{
	const struct planar_plane *plane = &t->polygon.plane;

	*out = (struct triangulation){.triangles = t->triangles.at,
		.triangle_count = t->triangles.count,
		.extra = t->extra.at,
		.extra_count = t->extra.count,
		.outcome = TRIANGULATION_WHOLE,
		.area = area / plane->cosine,
		.normal = plane->normal,
		.flatness = flatness};
	return TCS_OK;
}

static double
area_of(const struct triangulator *t)
{
	const struct planar_point *points = t->polygon.points.at;
	double sum = 0;

	for (size_t i = 0; i < t->triangles.count; i++) {
		const uint32_t *corner = t->triangles.at[i].corner;

		sum += planar_orient(points[corner[0]], points[corner[1]],
			points[corner[2]]);
	}
	return sum / 2;
}

static bool
same_area(const struct triangulator *t, double a, double b)
{
	double extent = t->polygon.extent;

	return fabs(a - b) <= ROUNDING * extent * extent;
}

/* Up to here slabs are cheap. */
enum { FEW_VERTICES = 256 };

/* Where that is cheap, ask whether the inside is covered, and it alone. */
static enum tcs_status
cover_check(const struct triangulator *t, double *area, bool *sound,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	double expected, wrong;

	*area = area_of(t);
	if (!*sound || t->polygon.kept.count > FEW_VERTICES)
		return TCS_OK;
	status = slabs_check(
		&t->polygon, &t->triangles, &expected, &wrong, fault);
	*sound = !status && same_area(t, *area, expected) &&
		same_area(t, wrong, 0);
	return status;
}

/* ---- rings that touch ------------------------------------------------------------ */

/* Keep the triangles that have an area; false if others are turned over. */
static bool
slivers_drop(struct triangulator *t)
{
	const struct planar_point *points = t->polygon.points.at;
	struct tcs_triangle *triangles = t->triangles.at;
	double over = 0;
	size_t kept = 0;

	for (size_t i = 0; i < t->triangles.count; i++) {
		const uint32_t *corner = triangles[i].corner;
		double one = planar_orient(points[corner[0]], points[corner[1]],
			points[corner[2]]);

		if (one > 0)
			triangles[kept++] = triangles[i];
		else
			over -= one / 2;
	}
	t->triangles.count = kept;
	return same_area(t, over, 0);
}

/*
 * Sweep over points moved a little, so that what touches is apart. With the
 * points where they were, the triangles between have no area.
 */
static enum tcs_status
touching_try(struct triangulator *t, double by, double *area, bool *fits,
	struct tcs_fault *fault)
{
	struct planar_points given = t->polygon.points;
	enum tcs_status status;

	t->triangles.count = 0;
	status = planar_nudge(&t->polygon, by, &t->nudged, fault);
	if (status)
		return status;
	t->polygon.points = t->nudged;
	status = sweep_run(&t->sweep, &t->polygon, &t->triangles, fits, fault);
	t->polygon.points = given;
	if (status || !*fits)
		return status;
	*fits = slivers_drop(t) && same_area(t, area_of(t), t->polygon.area);
	return cover_check(t, area, fits, fault);
}

/* ---- rings that cross ------------------------------------------------------------- */

/*
 * What a repair may cost: a few seconds of one core. GLU walks along a ring for
 * every edge that it adds, and down a list of edges for every vertex at which
 * the sweep meets new ones.
 */
enum { MOST_VERTICES = 20000, MOST_PAIRS = 100000000 };

static uint64_t
most_crossings(size_t vertices)
{
	uint64_t by_count = 1000 + 20 * (uint64_t)vertices;
	uint64_t by_time = 1000000000 / (uint64_t)vertices;

	return by_count < by_time ? by_count : by_time;
}

enum { TRIES = 4 };

/*
 * Without a grid first, then with ever coarser ones, up to 1e-8 of it all; in
 * the end by slabs, which cannot fail but leave many small triangles.
 */
static enum tcs_status
repair_try(struct triangulator *t, const struct tcs_point *vertices, int try,
	bool *sound, struct tcs_fault *fault)
{
	static const int fineness[TRIES] = {0, 40, 34, 28};
	double grid = 0;
	int size;

	*sound = try < TRIES || t->polygon.kept.count <= FEW_VERTICES;
	if (try == TRIES)
		return *sound ? slabs_fill(&t->polygon, vertices, &t->triangles,
					&t->extra, fault)
			      : TCS_OK;
	frexp(t->polygon.extent, &size);
	if (try > 0)
		grid = ldexp(1, size - fineness[try]);
	return planar_repair(&t->polygon, vertices, grid, &t->triangles,
		&t->extra, sound, fault);
}

static enum tcs_status
repair_tries(struct triangulator *t, const struct tcs_point *vertices,
	double *area, bool *sound, struct tcs_fault *fault)
{
	size_t given = t->polygon.points.count;
	enum tcs_status status = TCS_OK;

	*sound = false;
	for (int try = 0; try <= TRIES && !*sound && !status; try++) {
		t->polygon.points.count = given;
		t->triangles.count = 0;
		t->extra.count = 0;
		status = repair_try(t, vertices, try, sound, fault);
		if (!status)
			status = cover_check(t, area, sound, fault);
	}
	return status;
}

static enum tcs_status
repair(struct triangulator *t, const struct tcs_point *vertices, double *area,
	const char **reason, struct tcs_fault *fault)
{
	size_t count = t->polygon.kept.count;
	enum tcs_status status;
	bool tangled, sound;

	if (count > MOST_VERTICES) {
		*reason = "rings cross and are too long to repair";
		return TCS_OK;
	}
	status = planar_tangle(&t->polygon, MOST_PAIRS, most_crossings(count),
		&tangled, fault);
	if (status)
		return status;
	if (tangled) {
		*reason = "rings too tangled to repair";
		return TCS_OK;
	}
	status = repair_tries(t, vertices, area, &sound, fault);
	if (!status && !sound)
		*reason = "rings could not be repaired";
	return status;
}

/* What is not simple: it touches itself, or worse. */
static enum tcs_status
mend(struct triangulator *t, const struct tcs_point *vertices, double flatness,
	struct triangulation *out, struct tcs_fault *fault)
{
	double by = ldexp(t->polygon.extent, -32), area = 0;
	const char *reason = NULL;
	enum tcs_status status;
	bool fits;

	status = touching_try(t, by, &area, &fits, fault);
	if (!status && !fits)
		status = touching_try(t, -by, &area, &fits, fault);
	if (!status && !fits)
		status = repair(t, vertices, &area, &reason, fault);
	if (status)
		return status;
	if (!reason && area <= t->polygon.plane.noise)
		reason = "no area inside the rings";
	if (reason)
		return end_empty(out, reason);
	status = end_full(t, area, flatness, out);
	if (t->extra.count || !same_area(t, area, t->polygon.area)) {
		out->outcome = TRIANGULATION_REPAIRED;
		out->reason = t->extra.count ? "rings cross"
					     : "rings overlap or lie outside";
	}
	return status;
}

/* ---- the ordinary polygon -------------------------------------------------------- */

/* From here on scratch memory is worth giving back. */
enum { MANY_VERTICES = 10000 };

static size_t
vertices_count(const uint32_t *rings, size_t ring_count)
{
	size_t count = 0;

	for (size_t i = 0; i < ring_count; i++)
		count += rings[i];
	return count;
}

static double
distance2(struct tcs_point a, struct tcs_point b)
{
	double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;

	return x * x + y * y + z * z;
}

/*
 * A quad that a diagonal cuts into two counterclockwise triangles is simple;
 * the shorter one is taken, the first if both are as long.
 */
static bool
quad_cut(struct triangulator *t, const struct tcs_point *vertices, double *area)
{
	static const struct tcs_triangle cuts[2][2] = {
		{{{0, 1, 2}}, {{0, 2, 3}}}, {{{0, 1, 3}}, {{1, 2, 3}}}};
	const struct planar_plane *plane = &t->polygon.plane;
	struct planar_point p[4];
	double area2[2][2];
	bool fits[2];
	int cut;

	for (int i = 0; i < 4; i++)
		p[i] = planar_project(plane, vertices[i]);
	area2[0][0] = planar_orient(p[0], p[1], p[2]);
	area2[0][1] = planar_orient(p[0], p[2], p[3]);
	area2[1][0] = planar_orient(p[0], p[1], p[3]);
	area2[1][1] = planar_orient(p[1], p[2], p[3]);
	for (int i = 0; i < 2; i++)
		fits[i] = area2[i][0] > 0 && area2[i][1] > 0;
	if (!fits[0] && !fits[1])
		return false;
	cut = !fits[0] ||
		(fits[1] &&
			distance2(vertices[1], vertices[3]) <
				distance2(vertices[0], vertices[2]));
	t->triangles.at[0] = cuts[cut][0];
	t->triangles.at[1] = cuts[cut][1];
	t->triangles.count = 2;
	*area = (area2[cut][0] + area2[cut][1]) / 2;
	return true;
}

static bool
triangle_take(
	struct triangulator *t, const struct tcs_point *vertices, double *area)
{
	const struct planar_plane *plane = &t->polygon.plane;

	*area = planar_orient(planar_project(plane, vertices[0]),
			planar_project(plane, vertices[1]),
			planar_project(plane, vertices[2])) /
		2;
	t->triangles.at[0] = (struct tcs_triangle){{0, 1, 2}};
	t->triangles.count = 1;
	return *area > 0;
}

static enum tcs_status
triangulate_all(struct triangulator *t, const struct tcs_point *vertices,
	const uint32_t *rings, size_t ring_count, size_t count,
	struct triangulation *out, struct tcs_fault *fault)
{
	size_t outer = ring_count ? rings[0] : 0;
	double flatness, area;
	enum tcs_status status;
	const char *reason;
	bool simple;

	t->triangles.count = 0;
	t->extra.count = 0;
	if (planar_room(&t->triangles, 2))
		return fault_memory(fault);
	reason = planar_find(
		&t->polygon.plane, vertices, outer, count, &flatness);
	if (reason)
		return end_empty(out, reason);
	if (count == 3 && outer == 3 && triangle_take(t, vertices, &area))
		return end_full(t, area, flatness, out);
	if (count == 4 && outer == 4 && quad_cut(t, vertices, &area))
		return end_full(t, area, flatness, out);
	t->triangles.count = 0;
	reason = planar_lay(
		&t->polygon, vertices, rings, ring_count, count, &status);
	if (status)
		return fault_memory(fault);
	if (reason)
		return end_empty(out, reason);
	status = sweep_run(
		&t->sweep, &t->polygon, &t->triangles, &simple, fault);
	if (status)
		return status;
	if (simple && same_area(t, t->sweep.area / 2, t->polygon.area))
		return end_full(t, t->sweep.area / 2, flatness, out);
	return mend(t, vertices, flatness, out, fault);
}

/* What a large polygon took is not kept while its triangles are used. */
enum tcs_status
triangulate(struct triangulator *t, const struct tcs_point *vertices,
	const uint32_t *rings, size_t ring_count, struct triangulation *out,
	struct tcs_fault *fault)
{
	size_t count = vertices_count(rings, ring_count);
	enum tcs_status status = triangulate_all(
		t, vertices, rings, ring_count, count, out, fault);

	if (count > MANY_VERTICES) {
		planar_trim(&t->polygon);
		array_trim(&t->nudged);
		sweep_trim(&t->sweep);
	}
	return status;
}
