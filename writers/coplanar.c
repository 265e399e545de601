/* Which triangles belong together: points, neighbours, regions. */
#include "coplanar.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A triangle thinner than this has no side of its own, in metres. */
#define THIN 0.0001
/* Least cosine between the normals of a triangle and its region. */
#define SAME_SIDE 0.9

/*
 * How far a triangle may be off the plane that a region has so far, in metres.
 * Rounded coordinates put a corner further off the plane of a first triangle
 * than off the plane of all: regions are tried with the most, and taken apart
 * for the next where the whole is not flat in the end.
 */
static const double reach[] = {0.004, 0.002, 0.001, 0.0005, 0.0002};

enum { LEVELS = sizeof reach / sizeof *reach };

void
coplanar_clear(struct coplanar *coplanar)
{
	array_clear(&coplanar->faces);
	array_clear(&coplanar->rings);
	array_clear(&coplanar->corners);
}

void
coplanar_release(struct coplanar *coplanar)
{
	array_release(&coplanar->faces);
	array_release(&coplanar->rings);
	array_release(&coplanar->corners);
	array_release(&coplanar->points);
	array_release(&coplanar->places);
	array_release(&coplanar->twins);
	array_release(&coplanar->traced);
	array_release(&coplanar->positions);
	array_release(&coplanar->visits);
	array_release(&coplanar->normals);
	array_release(&coplanar->regions);
	array_release(&coplanar->levels);
	array_release(&coplanar->sorted);
	array_release(&coplanar->edges);
	array_release(&coplanar->sizes);
	array_release(&coplanar->members);
	array_release(&coplanar->path);
}

/* ---- points --------------------------------------------------------------- */

static int
compare_positions(const struct tcs_point *a, const struct tcs_point *b)
{
	if (a->x != b->x)
		return a->x < b->x ? -1 : 1;
	if (a->y != b->y)
		return a->y < b->y ? -1 : 1;
	if (a->z != b->z)
		return a->z < b->z ? -1 : 1;
	return 0;
}

static int
compare_corners(const void *left, const void *right)
{
	const struct coplanar_corner *a = left, *b = right;
	int order = compare_positions(&a->at, &b->at);

	if (order)
		return order;
	if (a->coat != b->coat)
		return a->coat < b->coat ? -1 : 1;
	return a->half < b->half ? -1 : a->half > b->half;
}

/* Number the positions, and their coats, of all corners. */
static void
unite(struct coplanar *coplanar, struct tcs_point metres)
{
	const struct coplanar_corner *sorted = coplanar->sorted.at;
	struct tcs_point origin = sorted[0].at;
	uint32_t point = 0, place = 0;

	for (size_t i = 0; i < coplanar->sorted.count; i++) {
		bool moved = i > 0 &&
			compare_positions(&sorted[i].at, &sorted[i - 1].at);

		point += i > 0 &&
			(moved || sorted[i].coat != sorted[i - 1].coat);
		place += moved;
		coplanar->points.at[sorted[i].half] = point;
		coplanar->places.at[sorted[i].half] = place;
		coplanar->visits.at[place] = TCS_NONE;
		coplanar->positions.at[place] = (struct tcs_point){
			(sorted[i].at.x - origin.x) * metres.x,
			(sorted[i].at.y - origin.y) * metres.y,
			(sorted[i].at.z - origin.z) * metres.z};
	}
}

static void
sort_corners(struct coplanar *coplanar, const struct tcs_point *vertices,
	const uint64_t *coats, const struct tcs_triangle *triangles,
	size_t count)
{
	for (size_t i = 0; i < count; i++)
		for (uint32_t k = 0; k < 3; k++) {
			uint32_t vertex = triangles[i].corner[k];

			coplanar->sorted.at[3 * i + k] =
				(struct coplanar_corner){vertices[vertex],
					coats ? coats[vertex] : 0,
					(uint32_t)(3 * i) + k};
		}
	coplanar->sorted.count = 3 * count;
	qsort(coplanar->sorted.at, 3 * count, sizeof *coplanar->sorted.at,
		compare_corners);
}

/* ---- neighbours ----------------------------------------------------------- */

static bool
has_three_places(const struct coplanar *coplanar, size_t triangle)
{
	const uint32_t *places = coplanar->places.at + 3 * triangle;

	return places[0] != places[1] && places[1] != places[2] &&
		places[2] != places[0];
}

static int
compare_edges(const void *left, const void *right)
{
	const struct coplanar_edge *a = left, *b = right;

	if (a->least != b->least)
		return a->least < b->least ? -1 : 1;
	if (a->most != b->most)
		return a->most < b->most ? -1 : 1;
	return a->half < b->half ? -1 : a->half > b->half;
}

static void
list_edges(struct coplanar *coplanar, size_t count)
{
	for (size_t i = 0; i < count; i++)
		for (uint32_t k = 0; k < 3; k++) {
			uint32_t half = (uint32_t)(3 * i) + k;
			uint32_t a = coplanar->points.at[half];
			uint32_t b =
				coplanar->points.at[coplanar_next_half(half)];

			coplanar->twins.at[half] = TCS_NONE;
			if (!has_three_places(coplanar, i))
				continue;
			coplanar->edges.at[coplanar->edges.count++] =
				(struct coplanar_edge){
					a < b ? a : b, a < b ? b : a, half};
		}
	if (coplanar->edges.count)
		qsort(coplanar->edges.at, coplanar->edges.count,
			sizeof *coplanar->edges.at, compare_edges);
}

/* Twins are the two halves of an edge that has no third, of opposite ways. */
static void
pair_edges(struct coplanar *coplanar)
{
	const struct coplanar_edge *edges = coplanar->edges.at;
	size_t count = coplanar->edges.count, run;

	for (size_t i = 0; i < count; i += run) {
		uint32_t a = edges[i].half, b;

		run = 1;
		while (i + run < count &&
			edges[i + run].least == edges[i].least &&
			edges[i + run].most == edges[i].most)
			run++;
		if (run != 2)
			continue;
		b = edges[i + 1].half;
		if (coplanar->points.at[a] == coplanar->points.at[b])
			continue;
		coplanar->twins.at[a] = b;
		coplanar->twins.at[b] = a;
	}
}

/* ---- regions -------------------------------------------------------------- */

static int
compare_sizes(const void *left, const void *right)
{
	const struct coplanar_size *a = left, *b = right;

	if (a->area != b->area)
		return a->area > b->area ? -1 : 1;
	return a->triangle < b->triangle ? -1 : a->triangle > b->triangle;
}

static const struct tcs_point *
corner_at(const struct coplanar *coplanar, uint32_t triangle, unsigned corner)
{
	return &coplanar->positions
			.at[coplanar->places.at[3 * triangle + corner]];
}

static void
measure(struct coplanar *coplanar, size_t count)
{
	for (uint32_t i = 0; i < count; i++) {
		const struct tcs_point *o = corner_at(coplanar, i, 0);
		struct tcs_point normal = coplanar_cross(
			coplanar_between(*o, *corner_at(coplanar, i, 1)),
			coplanar_between(*o, *corner_at(coplanar, i, 2)));

		if (!(coplanar_dot(normal, normal) < HUGE_VAL))
			normal = (struct tcs_point){0, 0, 0};
		coplanar->normals.at[i] = normal;
		coplanar->regions.at[i] = TCS_NONE;
		coplanar->levels.at[i] = 0;
		if (has_three_places(coplanar, i))
			coplanar->sizes.at[coplanar->sizes.count++] =
				(struct coplanar_size){
					coplanar_dot(normal, normal), i};
	}
	if (coplanar->sizes.count)
		qsort(coplanar->sizes.at, coplanar->sizes.count,
			sizeof *coplanar->sizes.at, compare_sizes);
}

static bool
is_thin(const struct coplanar *coplanar, uint32_t triangle)
{
	const struct tcs_point *normal = &coplanar->normals.at[triangle];
	double longest = 0;

	for (unsigned i = 0; i < 3; i++) {
		struct tcs_point edge =
			coplanar_between(*corner_at(coplanar, triangle, i),
				*corner_at(coplanar, triangle, (i + 1) % 3));
		double length = coplanar_dot(edge, edge);

		longest = length > longest ? length : longest;
	}
	return coplanar_dot(*normal, *normal) <= longest * THIN * THIN;
}

static void
widen(struct coplanar_plane *plane, const struct coplanar *coplanar,
	uint32_t triangle)
{
	const struct tcs_point *normal = &coplanar->normals.at[triangle];
	double weight = sqrt(coplanar_dot(*normal, *normal)) / 3;

	plane->normal.x += normal->x;
	plane->normal.y += normal->y;
	plane->normal.z += normal->z;
	for (unsigned i = 0; i < 3; i++) {
		const struct tcs_point *at = corner_at(coplanar, triangle, i);

		plane->centre.x += weight * at->x;
		plane->centre.y += weight * at->y;
		plane->centre.z += weight * at->z;
		plane->weight += weight;
	}
}

/* Whether all corners are so near the plane, which has an area. */
static bool
is_near(const struct coplanar *coplanar, const struct coplanar_plane *plane,
	uint32_t triangle, double distance)
{
	const struct tcs_point *normal = &plane->normal;
	double length = sqrt(coplanar_dot(*normal, *normal));
	struct tcs_point centre = {plane->centre.x / plane->weight,
		plane->centre.y / plane->weight,
		plane->centre.z / plane->weight};

	for (unsigned i = 0; i < 3; i++) {
		struct tcs_point out = coplanar_between(
			centre, *corner_at(coplanar, triangle, i));

		if (!(fabs(coplanar_dot(out, *normal)) <= distance * length))
			return false;
	}
	return true;
}

static bool
faces_along(const struct coplanar *coplanar, const struct coplanar_plane *plane,
	uint32_t triangle)
{
	const struct tcs_point *normal = &coplanar->normals.at[triangle];
	double lengths = coplanar_dot(*normal, *normal) *
		coplanar_dot(plane->normal, plane->normal);

	return coplanar_dot(*normal, plane->normal) >=
		SAME_SIDE * sqrt(lengths);
}

/* Spread from a triangle to neighbours of its level. */
static void
grow(struct coplanar *coplanar, uint32_t seed, unsigned level)
{
	struct coplanar_plane plane = {.weight = 0};

	coplanar->members.at[0] = seed;
	coplanar->members.count = 1;
	coplanar->regions.at[seed] = seed;
	widen(&plane, coplanar, seed);
	if (is_thin(coplanar, seed))
		return;
	for (size_t at = 0; at < coplanar->members.count; at++)
		for (uint32_t k = 0; k < 3; k++) {
			uint32_t half = 3 * coplanar->members.at[at] + k;
			uint32_t other = coplanar->twins.at[half] / 3;

			if (coplanar->twins.at[half] == TCS_NONE ||
				coplanar->regions.at[other] != TCS_NONE ||
				coplanar->levels.at[other] != level ||
				!is_near(coplanar, &plane, other,
					reach[level]) ||
				!(is_thin(coplanar, other) ||
					faces_along(coplanar, &plane, other)))
				continue;
			coplanar->regions.at[other] = seed;
			coplanar->members.at[coplanar->members.count++] = other;
			widen(&plane, coplanar, other);
		}
}

/* What has grown is for the next level. */
static void
take_apart(struct coplanar *coplanar)
{
	for (size_t i = 0; i < coplanar->members.count; i++) {
		uint32_t triangle = coplanar->members.at[i];

		coplanar->regions.at[triangle] = TCS_NONE;
		coplanar->levels.at[triangle]++;
		for (uint32_t k = 0; k < 3; k++)
			coplanar->traced.at[3 * triangle + k] = false;
	}
}

static enum tcs_status
add_region(struct coplanar *coplanar, const struct tcs_triangle *triangles,
	uint32_t seed, unsigned level, struct tcs_fault *fault)
{
	enum tcs_status status;
	bool flat;

	grow(coplanar, seed, level);
	status = coplanar_trace(coplanar, triangles, coplanar->members.at,
		coplanar->members.count, &flat, fault);
	if (status || flat)
		return status;
	if (level + 1 < LEVELS && coplanar->members.count > 1) {
		take_apart(coplanar);
		return TCS_OK;
	}
	return coplanar_keep(coplanar, triangles, coplanar->members.at,
		coplanar->members.count, fault);
}

static enum tcs_status
add_regions(struct coplanar *coplanar, const struct tcs_triangle *triangles,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (unsigned level = 0; level < LEVELS; level++)
		for (size_t i = 0; i < coplanar->sizes.count && !status; i++) {
			uint32_t seed = coplanar->sizes.at[i].triangle;

			if (coplanar->regions.at[seed] == TCS_NONE &&
				coplanar->levels.at[seed] == level)
				status = add_region(coplanar, triangles, seed,
					level, fault);
		}
	return status;
}

/* ---- all of it ------------------------------------------------------------ */

static enum tcs_status
make_room(struct coplanar *coplanar, size_t count, struct tcs_fault *fault)
{
	array_clear(&coplanar->points);
	array_clear(&coplanar->places);
	array_clear(&coplanar->twins);
	array_clear(&coplanar->traced);
	array_clear(&coplanar->positions);
	array_clear(&coplanar->visits);
	array_clear(&coplanar->normals);
	array_clear(&coplanar->regions);
	array_clear(&coplanar->levels);
	array_clear(&coplanar->sorted);
	array_clear(&coplanar->edges);
	array_clear(&coplanar->sizes);
	array_clear(&coplanar->members);
	array_clear(&coplanar->path);
	if (count >= TCS_NONE / 3)
		return fault_memory(fault);
	if (array_grow(&coplanar->points, 3 * count) ||
		array_grow(&coplanar->places, 3 * count) ||
		array_grow(&coplanar->twins, 3 * count) ||
		array_grow(&coplanar->traced, 3 * count) ||
		array_grow(&coplanar->positions, 3 * count) ||
		array_grow(&coplanar->visits, 3 * count) ||
		array_grow(&coplanar->normals, count) ||
		array_grow(&coplanar->regions, count) ||
		array_grow(&coplanar->levels, count) ||
		array_grow(&coplanar->sorted, 3 * count) ||
		array_grow(&coplanar->edges, 3 * count) ||
		array_grow(&coplanar->sizes, count) ||
		array_grow(&coplanar->members, count) ||
		array_grow(&coplanar->path, 3 * count))
		return fault_memory(fault);
	memset(coplanar->traced.at, 0, 3 * count * sizeof(bool));
	return TCS_OK;
}

static int
compare_faces(const void *left, const void *right)
{
	const struct coplanar_face *a = left, *b = right;

	return a->first_triangle < b->first_triangle
		? -1
		: a->first_triangle > b->first_triangle;
}

enum tcs_status
coplanar_join(struct coplanar *coplanar, const struct tcs_point *vertices,
	const uint64_t *coats, struct tcs_point metres,
	const struct tcs_triangle *triangles, size_t count,
	struct tcs_fault *fault)
{
	size_t first = coplanar->faces.count;
	enum tcs_status status;

	if (!count)
		return TCS_OK;
	status = make_room(coplanar, count, fault);
	if (status)
		return status;
	sort_corners(coplanar, vertices, coats, triangles, count);
	unite(coplanar, metres);
	list_edges(coplanar, count);
	pair_edges(coplanar);
	measure(coplanar, count);
	status = add_regions(coplanar, triangles, fault);
	if (!status && coplanar->faces.count > first)
		qsort(&coplanar->faces.at[first], coplanar->faces.count - first,
			sizeof *coplanar->faces.at, compare_faces);
	return status;
}
