#include "ifc_shape.h"

#include <math.h>
#include <string.h>

enum ifc_outcome
ifc_refuse(struct ifc_shaper *shaper, uint32_t instance, const char *reason)
{
	shaper->culprit = instance;
	shaper->reason = reason;
	return IFC_REFUSED;
}

/* ---- limits -------------------------------------------------------------- */

enum ifc_outcome
ifc_enter(struct ifc_shaper *shaper, uint32_t instance)
{
	if (instance == STEP_NONE)
		return ifc_refuse(shaper, instance, "a part is missing");
	if (shaper->depth == IFC_MOST_DEPTH)
		return ifc_refuse(
			shaper, instance, "nested too deep, or in itself");
	if (shaper->points >= IFC_MOST_POINTS)
		return ifc_refuse(shaper, instance, "too many points");
	shaper->depth++;
	shaper->points++;
	return IFC_SHAPED;
}

void
ifc_leave(struct ifc_shaper *shaper)
{
	shaper->depth--;
}

enum ifc_outcome
ifc_points_room(
	struct ifc_shaper *shaper, struct ifc_points *points, size_t more)
{
	if (more > IFC_MOST_POINTS || shaper->points + more > IFC_MOST_POINTS ||
		points->count + more > UINT32_MAX / 2)
		return ifc_refuse(shaper, STEP_NONE, "too many points");
	shaper->points += more;
	return array_grow(points, more) ? IFC_NO_MEMORY : IFC_SHAPED;
}

enum ifc_outcome
ifc_point_add(struct ifc_shaper *shaper, struct ifc_points *points,
	struct tcs_point point)
{
	enum ifc_outcome outcome = ifc_points_room(shaper, points, 1);

	if (!outcome)
		points->at[points->count++] = point;
	return outcome;
}

bool
ifc_same_point(
	const struct ifc_shaper *shaper, struct tcs_point a, struct tcs_point b)
{
	return fabs(a.x - b.x) <= shaper->precision &&
		fabs(a.y - b.y) <= shaper->precision &&
		fabs(a.z - b.z) <= shaper->precision;
}

static struct tcs_point
minus(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* The vector area, twice, of a ring (Newell's). */
static struct tcs_point
ring_normal2(const struct tcs_point *points, size_t count)
{
	struct tcs_point sum = {0, 0, 0};

	for (size_t i = 2; i < count; i++) {
		struct tcs_point a = minus(points[i - 1], points[0]);
		struct tcs_point b = minus(points[i], points[0]);

		sum.x += a.y * b.z - a.z * b.y;
		sum.y += a.z * b.x - a.x * b.z;
		sum.z += a.x * b.y - a.y * b.x;
	}
	return sum;
}

/* ---- building faces ------------------------------------------------------ */

static size_t
rings_points(const struct ifc_faces *faces, size_t first, size_t count)
{
	size_t points = 0;

	for (size_t i = first; i < first + count; i++)
		points += faces->rings.at[i];
	return points;
}

/* The rings and points that faces have taken. */
static void
faces_taken(const struct ifc_faces *faces, size_t *points, size_t *rings)
{
	const struct ifc_face *last = faces->faces.at;

	*points = *rings = 0;
	if (!faces->faces.count)
		return;
	last += faces->faces.count - 1;
	*rings = last->first_ring + last->ring_count;
	*points = last->first_point + ifc_face_points(faces, last);
}

size_t
ifc_faces_loose(const struct ifc_faces *faces)
{
	size_t points, rings;

	faces_taken(faces, &points, &rings);
	points += rings_points(faces, rings, faces->rings.count - rings);
	return faces->points.count - points;
}

enum ifc_outcome
ifc_ring_end(struct ifc_shaper *shaper, struct ifc_faces *faces, bool *kept)
{
	size_t loose = ifc_faces_loose(faces);

	(void)shaper;
	if (kept)
		*kept = loose >= 3;
	if (loose < 3) {
		faces->points.count -= loose;
		return IFC_SHAPED;
	}
	if (array_grow(&faces->rings, 1))
		return IFC_NO_MEMORY;
	faces->rings.at[faces->rings.count++] = (uint32_t)loose;
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_face_end(struct ifc_shaper *shaper, struct ifc_faces *faces)
{
	size_t points, rings;

	(void)shaper;
	faces_taken(faces, &points, &rings);
	if (rings == faces->rings.count)
		return IFC_SHAPED;
	if (array_grow(&faces->faces, 1))
		return IFC_NO_MEMORY;
	faces->faces.at[faces->faces.count++] =
		(struct ifc_face){(uint32_t)points, (uint32_t)rings,
			(uint32_t)(faces->rings.count - rings), 0};
	return IFC_SHAPED;
}

static void
holes_wind(struct ifc_faces *faces, const struct ifc_face *face)
{
	struct tcs_point *points = faces->points.at + face->first_point;
	struct tcs_point outer, hole;

	outer = ring_normal2(points, faces->rings.at[face->first_ring]);
	for (uint32_t i = 1; i < face->ring_count; i++) {
		size_t count = faces->rings.at[face->first_ring + i];

		points += faces->rings.at[face->first_ring + i - 1];
		hole = ring_normal2(points, count);
		if (outer.x * hole.x + outer.y * hole.y + outer.z * hole.z > 0)
			ifc_ring_reverse(points, count);
	}
}

enum ifc_outcome
ifc_face_end_wound(struct ifc_shaper *shaper, struct ifc_faces *faces)
{
	size_t before = faces->faces.count;
	enum ifc_outcome outcome = ifc_face_end(shaper, faces);

	if (!outcome && faces->faces.count > before &&
		faces->faces.at[before].ring_count > 1)
		holes_wind(faces, faces->faces.at + before);
	return outcome;
}

void
ifc_faces_clear(struct ifc_faces *faces)
{
	array_clear(&faces->points);
	array_clear(&faces->rings);
	array_clear(&faces->faces);
}

void
ifc_faces_release(struct ifc_faces *faces)
{
	array_release(&faces->points);
	array_release(&faces->rings);
	array_release(&faces->faces);
}

void
ifc_faces_cut(struct ifc_faces *faces, size_t first_face)
{
	size_t points, rings;

	if (first_face < faces->faces.count)
		faces->faces.count = first_face;
	faces_taken(faces, &points, &rings);
	faces->points.count = points;
	faces->rings.count = rings;
}

size_t
ifc_face_points(const struct ifc_faces *faces, const struct ifc_face *face)
{
	return rings_points(faces, face->first_ring, face->ring_count);
}

enum ifc_outcome
ifc_faces_append_some(struct ifc_shaper *shaper, struct ifc_faces *out,
	const struct ifc_faces *from, size_t first, size_t end)
{
	const struct ifc_face *begin, *last;
	size_t points, rings;
	enum ifc_outcome outcome;

	if (first >= end)
		return IFC_SHAPED;
	begin = from->faces.at + first;
	last = from->faces.at + end - 1;
	points = last->first_point + ifc_face_points(from, last) -
		begin->first_point;
	rings = last->first_ring + last->ring_count - begin->first_ring;
	outcome = ifc_points_room(shaper, &out->points, points);
	if (outcome)
		return outcome;
	if (array_grow(&out->rings, rings) ||
		array_grow(&out->faces, end - first))
		return IFC_NO_MEMORY;
	for (size_t i = first; i < end; i++) {
		struct ifc_face face = from->faces.at[i];

		face.first_point +=
			(uint32_t)(out->points.count - begin->first_point);
		face.first_ring +=
			(uint32_t)(out->rings.count - begin->first_ring);
		out->faces.at[out->faces.count + i - first] = face;
	}
	memcpy(out->points.at + out->points.count,
		from->points.at + begin->first_point,
		points * sizeof *out->points.at);
	memcpy(out->rings.at + out->rings.count,
		from->rings.at + begin->first_ring,
		rings * sizeof *out->rings.at);
	out->points.count += points;
	out->rings.count += rings;
	out->faces.count += end - first;
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_faces_append(struct ifc_shaper *shaper, struct ifc_faces *out,
	const struct ifc_faces *from, size_t first_face)
{
	return ifc_faces_append_some(
		shaper, out, from, first_face, from->faces.count);
}

/* ---- changing faces ------------------------------------------------------ */

void
ifc_ring_reverse(struct tcs_point *points, size_t count)
{
	for (size_t i = 1; i < (count + 1) / 2; i++) {
		struct tcs_point swap = points[i];

		points[i] = points[count - i];
		points[count - i] = swap;
	}
}

void
ifc_faces_reverse(struct ifc_faces *faces, size_t first_face)
{
	struct tcs_point *points;

	if (first_face >= faces->faces.count)
		return;
	points = faces->points.at + faces->faces.at[first_face].first_point;
	for (size_t i = faces->faces.at[first_face].first_ring;
		i < faces->rings.count; i++) {
		ifc_ring_reverse(points, faces->rings.at[i]);
		points += faces->rings.at[i];
	}
}

void
ifc_faces_transform(struct ifc_faces *faces, size_t first_face,
	const struct ifc_matrix *matrix)
{
	if (first_face >= faces->faces.count)
		return;
	for (size_t i = faces->faces.at[first_face].first_point;
		i < faces->points.count; i++)
		faces->points.at[i] =
			ifc_transform(matrix, faces->points.at[i]);
	if (ifc_determinant(matrix) < 0)
		ifc_faces_reverse(faces, first_face);
}

static double
triple_product(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
		a.z * (b.x * c.y - b.y * c.x);
}

double
ifc_faces_volume6(const struct ifc_faces *faces, size_t first_face)
{
	const struct tcs_point *points;
	struct tcs_point origin;
	double volume = 0;

	if (first_face >= faces->faces.count)
		return 0;
	points = faces->points.at + faces->faces.at[first_face].first_point;
	origin = points[0];
	for (size_t i = faces->faces.at[first_face].first_ring;
		i < faces->rings.count; i++) {
		size_t count = faces->rings.at[i];
		struct tcs_point first = minus(points[0], origin);

		for (size_t k = 2; k < count; k++)
			volume += triple_product(first,
				minus(points[k - 1], origin),
				minus(points[k], origin));
		points += count;
	}
	return volume;
}
