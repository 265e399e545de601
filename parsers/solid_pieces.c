#include "solid_pieces.h"

#include <math.h>
#include <string.h>

void
solid_pieces_clear(struct solid_pieces *pieces)
{
	array_clear(&pieces->list);
	array_clear(&pieces->points);
}

void
solid_pieces_release(struct solid_pieces *pieces)
{
	array_release(&pieces->list);
	array_release(&pieces->points);
	array_release(&pieces->ring_points);
	array_release(&pieces->ring_counts);
	triangulator_free(pieces->triangulator);
	pieces->triangulator = NULL;
}

/* ---- one face ---------------------------------------------------------------- */

static bool
same(struct tcs_point a, struct tcs_point b)
{
	return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* Append a ring without repeated points. Returns its length. */
static uint32_t
ring_read(struct solid_point_list *to, const struct tcs_point *ring,
	size_t count, struct tcs_point origin, bool turned)
{
	size_t first = to->count;

	for (size_t i = 0; i < count; i++) {
		struct tcs_point at =
			point_minus(ring[turned ? count - 1 - i : i], origin);

		if (to->count > first && same(to->at[to->count - 1], at))
			continue;
		to->at[to->count++] = at;
	}
	while (to->count > first + 1 &&
		same(to->at[to->count - 1], to->at[first]))
		to->count--;
	return (uint32_t)(to->count - first);
}

/* Read the face's rings, those with an area to be. */
static enum tcs_status
face_read(struct solid_pieces *pieces, const struct solid *solid,
	const struct solid_face *face, struct tcs_point origin, bool turned,
	struct tcs_fault *fault)
{
	array_clear(&pieces->ring_points);
	array_clear(&pieces->ring_counts);
	if (array_grow(&pieces->ring_counts, face->ring_count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < face->ring_count; i++) {
		size_t count;
		const struct tcs_point *ring =
			solid_ring(solid, face->first_ring + i, &count);
		uint32_t length;

		if (array_grow(&pieces->ring_points, count))
			return fault_memory(fault);
		length = ring_read(
			&pieces->ring_points, ring, count, origin, turned);
		if (length >= 3)
			pieces->ring_counts.at[pieces->ring_counts.count++] =
				length;
		else if (i == 0)
			return TCS_OK;
		else
			pieces->ring_points.count -= length;
	}
	return TCS_OK;
}

/*
 * Whether the ring turns once and always the same way around the normal,
 * `side` times it, or hardly at all.
 */
static bool
is_convex(const struct tcs_point *ring, size_t count,
	const struct solid_plane *plane, int side)
{
	struct tcs_point last = point_minus(ring[0], ring[count - 1]);
	struct tcs_point axis = last;
	unsigned crossings = 0;
	bool ahead = true;

	for (size_t i = 0; i < count; i++) {
		struct tcs_point here =
			point_minus(ring[(i + 1) % count], ring[i]);
		struct tcs_point turn = point_cross(last, here);
		bool forward = point_dot(here, axis) > 0;

		if (!(point_dot(turn, plane->normal) * side > 0))
			return false;
		crossings += forward != ahead;
		ahead = forward;
		last = here;
	}
	return crossings <= 2;
}

enum tcs_status
solid_piece_add(struct solid_pieces *pieces, const struct solid_piece *like,
	const struct tcs_point *points, uint32_t count, struct tcs_fault *fault)
{
	struct solid_piece piece = *like;

	if (count > UINT32_MAX / 4 - pieces->points.count ||
		pieces->list.count >= UINT32_MAX / 4 ||
		array_grow(&pieces->points, count) ||
		array_grow(&pieces->list, 1))
		return fault_memory(fault);
	piece.first = (uint32_t)pieces->points.count;
	piece.count = count;
	memcpy(pieces->points.at + piece.first, points, count * sizeof *points);
	pieces->points.count += count;
	pieces->list.at[pieces->list.count++] = piece;
	return TCS_OK;
}

static struct tcs_point
corner_of(const struct solid_pieces *pieces, const struct triangulation *all,
	uint32_t corner)
{
	size_t own = pieces->ring_points.count;

	return corner < own ? pieces->ring_points.at[corner]
			    : all->extra[corner - own];
}

/* A triangle in the face's plane, or, where that has none, in its own. */
static enum tcs_status
triangle_add(struct solid_pieces *pieces, struct solid_planes *planes,
	const struct solid_piece *like, const struct tcs_point corners[3],
	struct tcs_fault *fault)
{
	struct solid_piece piece = *like;
	enum tcs_status status = TCS_OK;
	int side = piece.side;

	if (!side)
		status = solid_planes_find(
			planes, corners, 3, 3, &piece.plane, &side, fault);
	piece.side = (signed char)side;
	return status || !side
		? status
		: solid_piece_add(pieces, &piece, corners, 3, fault);
}

static enum tcs_status
face_triangulate(struct solid_pieces *pieces, struct solid_planes *planes,
	const struct solid_piece *like, struct tcs_fault *fault)
{
	struct triangulation all;
	enum tcs_status status;

	if (!pieces->triangulator)
		pieces->triangulator = triangulator_new();
	if (!pieces->triangulator)
		return fault_memory(fault);
	status = triangulate(pieces->triangulator, pieces->ring_points.at,
		pieces->ring_counts.at, pieces->ring_counts.count, &all, fault);
	for (size_t i = 0; !status && i < all.triangle_count; i++) {
		const uint32_t *corner = all.triangles[i].corner;
		struct tcs_point corners[3] = {
			corner_of(pieces, &all, corner[0]),
			corner_of(pieces, &all, corner[1]),
			corner_of(pieces, &all, corner[2])};

		status = triangle_add(pieces, planes, like, corners, fault);
	}
	return status;
}

static enum tcs_status
face_add(struct solid_pieces *pieces, struct solid_planes *planes,
	struct solid_piece *like, struct tcs_fault *fault)
{
	const struct solid_point_list *points = &pieces->ring_points;
	uint32_t outer = pieces->ring_counts.at[0];
	int side;
	enum tcs_status status = solid_planes_find(planes, points->at, outer,
		points->count, &like->plane, &side, fault);

	if (status)
		return status;
	like->side = (signed char)side;
	if (side && pieces->ring_counts.count == 1 &&
		is_convex(
			points->at, outer, &planes->list.at[like->plane], side))
		return solid_piece_add(pieces, like, points->at, outer, fault);
	return face_triangulate(pieces, planes, like, fault);
}

enum tcs_status
solid_pieces_add(struct solid_pieces *pieces, struct solid_planes *planes,
	const struct solid *solid, struct tcs_point origin, uint32_t number,
	bool turned, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < solid->faces.count; i++) {
		struct solid_piece like = {.origin = number,
			.face = (uint32_t)i,
			.label = solid->faces.at[i].label};

		status = face_read(pieces, solid, &solid->faces.at[i], origin,
			turned, fault);
		if (!status && pieces->ring_counts.count)
			status = face_add(pieces, planes, &like, fault);
	}
	return status;
}

/* ---- pieces in cells --------------------------------------------------------- */

void
solid_items_release(struct solid_items *items)
{
	array_release(&items->list);
	array_release(&items->points);
}

struct solid_range
solid_range_of(const struct solid_plane *plane, const struct tcs_point *points,
	size_t count)
{
	struct solid_range range = {INFINITY, -INFINITY};

	for (size_t i = 0; i < count; i++) {
		double at = solid_plane_distance(plane, points[i]);

		range.low = at < range.low ? at : range.low;
		range.high = at > range.high ? at : range.high;
	}
	return range;
}

enum tcs_status
solid_items_add(struct solid_items *items, uint32_t piece,
	const struct tcs_point *points, size_t count, struct tcs_fault *fault)
{
	if (array_grow(&items->list, 1) || array_grow(&items->points, count))
		return fault_memory(fault);
	memcpy(items->points.at + items->points.count, points,
		count * sizeof *points);
	items->points.count += count;
	items->list.at[items->list.count++] =
		(struct solid_item){piece, (uint32_t)count};
	return TCS_OK;
}

static struct tcs_point
between(struct tcs_point a, struct tcs_point b, double part)
{
	return (struct tcs_point){a.x + part * (b.x - a.x),
		a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)};
}

enum tcs_status
solid_items_clip(struct solid_items *items, uint32_t piece,
	const struct tcs_point *points, size_t count,
	const struct solid_plane *plane, int side, struct tcs_fault *fault)
{
	struct tcs_point last = points[count - 1], *to;
	double from = side * solid_plane_distance(plane, last);
	size_t first = items->points.count, kept;

	if (array_grow(&items->list, 1) ||
		array_grow(&items->points, 2 * count))
		return fault_memory(fault);
	to = items->points.at + first;
	for (size_t i = 0; i < count; i++) {
		double at = side * solid_plane_distance(plane, points[i]);

		if ((at > 0 && from < 0) || (at < 0 && from > 0))
			*to++ = between(last, points[i], from / (from - at));
		if (at >= 0)
			*to++ = points[i];
		last = points[i];
		from = at;
	}
	kept = (size_t)(to - items->points.at) - first;
	if (kept < 3)
		return TCS_OK;
	items->points.count += kept;
	items->list.at[items->list.count++] =
		(struct solid_item){piece, (uint32_t)kept};
	return TCS_OK;
}
