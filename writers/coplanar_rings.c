/* The boundary of a region, as rings. */
#include "coplanar.h"

#include <math.h>

struct border {
	const struct tcs_triangle *triangles;
	struct tcs_point normal; /* of the region, unit */
};

/* Whether the region ends at this half-edge of one of its triangles. */
static bool
is_border(const struct coplanar *coplanar, uint32_t half)
{
	uint32_t twin = coplanar->twins.at[half];

	return twin == TCS_NONE ||
		coplanar->regions.at[twin / 3] !=
		coplanar->regions.at[half / 3];
}

/* The border's next half-edge: round the end of this one, on the inside. */
static uint32_t
next_border(const struct coplanar *coplanar, uint32_t half)
{
	uint32_t at = coplanar_next_half(half);

	while (!is_border(coplanar, at))
		at = coplanar_next_half(coplanar->twins.at[at]);
	return at;
}

static uint32_t
vertex_of(const struct border *border, uint32_t half)
{
	return border->triangles[half / 3].corner[half % 3];
}

/* Doubled, as seen along the normal. */
static double
area_of(const struct coplanar *coplanar, const struct border *border,
	const uint32_t *halves, size_t count)
{
	const struct tcs_point *positions = coplanar->positions.at;
	const uint32_t *places = coplanar->places.at;
	struct tcs_point origin = positions[places[halves[0]]];
	double area = 0;

	for (size_t i = 1; i + 1 < count; i++)
		area += coplanar_dot(border->normal,
			coplanar_cross(coplanar_between(origin,
					       positions[places[halves[i]]]),
				coplanar_between(origin,
					positions[places[halves[i + 1]]])));
	return area;
}

/* A ring of these half-edges, from its lowest vertex on; its corners are
 * half-edges until all rings are known. Two that run out and back on one edge are none. */
static enum tcs_status
add_ring(struct coplanar *coplanar, const struct border *border,
	const uint32_t *halves, size_t count, struct tcs_fault *fault)
{
	size_t start = 0;

	if (count < 3)
		return TCS_OK;
	if (array_grow(&coplanar->rings, 1) ||
		array_grow(&coplanar->corners, count))
		return fault_memory(fault);
	for (size_t i = 1; i < count; i++)
		if (vertex_of(border, halves[i]) <
			vertex_of(border, halves[start]))
			start = i;
	coplanar->rings.at[coplanar->rings.count++] = (struct coplanar_ring){
		.first = (uint32_t)coplanar->corners.count,
		.count = (uint32_t)count,
		.area = area_of(coplanar, border, halves, count)};
	for (size_t i = 0; i < count; i++)
		coplanar->corners.at[coplanar->corners.count++] =
			halves[(start + i) % count];
	return TCS_OK;
}

/* Cut the path at a place it has been to before. */
static enum tcs_status
cut(struct coplanar *coplanar, const struct border *border, size_t from,
	struct tcs_fault *fault)
{
	const uint32_t *path = coplanar->path.at;
	enum tcs_status status = add_ring(coplanar, border, path + from,
		coplanar->path.count - from, fault);

	for (size_t i = from; i < coplanar->path.count; i++)
		coplanar->visits.at[coplanar->places.at[path[i]]] = TCS_NONE;
	coplanar->path.count = from;
	return status;
}

/* Follow the border from a half-edge until it is back there. */
static enum tcs_status
follow(struct coplanar *coplanar, const struct border *border, uint32_t start,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint32_t half = start;

	do {
		uint32_t *visit =
			&coplanar->visits.at[coplanar->places.at[half]];

		if (*visit != TCS_NONE)
			status = cut(coplanar, border, *visit, fault);
		*visit = (uint32_t)coplanar->path.count;
		coplanar->path.at[coplanar->path.count++] = half;
		coplanar->traced.at[half] = true;
		half = next_border(coplanar, half);
	} while (half != start && !status);
	return status ? status : cut(coplanar, border, 0, fault);
}

/* Move the only ring that is no hole to the front. False for none or more. */
static bool
put_outer_first(struct coplanar *coplanar, size_t first)
{
	struct coplanar_ring *rings = coplanar->rings.at;
	size_t outer = first, found = 0;

	for (size_t i = first; i < coplanar->rings.count; i++)
		if (rings[i].area > 0) {
			outer = i;
			found++;
		}
	if (found == 1) {
		struct coplanar_ring ring = rings[outer];

		rings[outer] = rings[first];
		rings[first] = ring;
	}
	return found == 1;
}

static struct tcs_point
position_of(const struct coplanar *coplanar, size_t corner)
{
	uint32_t half = coplanar->corners.at[corner];

	return coplanar->positions.at[coplanar->places.at[half]];
}

/* The plane of a ring: Newell's normal, and the centre of its corners. */
static void
find_plane(const struct coplanar *coplanar, const struct coplanar_ring *ring,
	struct coplanar_plane *plane)
{
	struct tcs_point first = position_of(coplanar, ring->first);
	struct tcs_point last = first, *centre = &plane->centre;

	*plane = (struct coplanar_plane){.weight = ring->count};
	for (uint32_t i = 0; i < ring->count; i++) {
		struct tcs_point at = position_of(coplanar, ring->first + i);
		struct tcs_point area =
			coplanar_cross(coplanar_between(first, last),
				coplanar_between(first, at));

		plane->normal.x += area.x;
		plane->normal.y += area.y;
		plane->normal.z += area.z;
		centre->x += at.x / plane->weight;
		centre->y += at.y / plane->weight;
		centre->z += at.z / plane->weight;
		last = at;
	}
}

/* Whether all corners from the first of the outer ring on are in its plane. */
static bool
is_flat(const struct coplanar *coplanar, size_t outer, size_t corner)
{
	struct coplanar_plane plane;
	double length;

	find_plane(coplanar, &coplanar->rings.at[outer], &plane);
	length = sqrt(coplanar_dot(plane.normal, plane.normal));
	for (size_t i = corner; i < coplanar->corners.count; i++) {
		struct tcs_point out = coplanar_between(
			plane.centre, position_of(coplanar, i));

		if (!(fabs(coplanar_dot(out, plane.normal)) <=
			    COPLANAR_TOLERANCE * length))
			return false;
	}
	return true;
}

/* Make a face of the rings and corners from these on. */
static enum tcs_status
add_face(struct coplanar *coplanar, const struct border *border,
	size_t first_ring, size_t first_corner, uint32_t first_triangle,
	struct tcs_fault *fault)
{
	if (array_grow(&coplanar->faces, 1))
		return fault_memory(fault);
	for (size_t i = first_corner; i < coplanar->corners.count; i++)
		coplanar->corners.at[i] =
			vertex_of(border, coplanar->corners.at[i]);
	coplanar->faces.at[coplanar->faces.count++] = (struct coplanar_face){
		.first_ring = (uint32_t)first_ring,
		.ring_count = (uint32_t)(coplanar->rings.count - first_ring),
		.first_triangle = first_triangle,
	};
	return TCS_OK;
}

enum tcs_status
coplanar_keep(struct coplanar *coplanar, const struct tcs_triangle *triangles,
	const uint32_t *members, size_t count, struct tcs_fault *fault)
{
	struct border border = {.triangles = triangles};
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < count && !status; i++) {
		size_t ring = coplanar->rings.count;
		size_t corner = coplanar->corners.count;
		uint32_t half = 3 * members[i];
		const uint32_t halves[] = {half, half + 1, half + 2};

		status = add_ring(coplanar, &border, halves, 3, fault);
		if (!status)
			status = add_face(coplanar, &border, ring, corner,
				members[i], fault);
	}
	return status;
}

static struct tcs_point
normal_of(
	const struct coplanar *coplanar, const uint32_t *members, size_t count)
{
	struct tcs_point sum = {0, 0, 0};
	double length;

	for (size_t i = 0; i < count; i++) {
		const struct tcs_point *normal =
			&coplanar->normals.at[members[i]];

		sum.x += normal->x;
		sum.y += normal->y;
		sum.z += normal->z;
	}
	length = sqrt(coplanar_dot(sum, sum));
	if (length > 0) {
		sum.x /= length;
		sum.y /= length;
		sum.z /= length;
	}
	return sum;
}

enum tcs_status
coplanar_trace(struct coplanar *coplanar, const struct tcs_triangle *triangles,
	const uint32_t *members, size_t count, bool *flat,
	struct tcs_fault *fault)
{
	struct border border = {triangles, normal_of(coplanar, members, count)};
	size_t ring = coplanar->rings.count, corner = coplanar->corners.count;
	uint32_t lowest = members[0];
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < 3 * count && !status; i++) {
		uint32_t half = 3 * members[i / 3] + (uint32_t)(i % 3);

		lowest = members[i / 3] < lowest ? members[i / 3] : lowest;
		if (!coplanar->traced.at[half] && is_border(coplanar, half))
			status = follow(coplanar, &border, half, fault);
	}
	if (status)
		return status;
	*flat = put_outer_first(coplanar, ring) &&
		is_flat(coplanar, ring, corner);
	if (*flat)
		return add_face(coplanar, &border, ring, corner, lowest, fault);
	coplanar->rings.count = ring;
	coplanar->corners.count = corner;
	return TCS_OK;
}
