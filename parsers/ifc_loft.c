#include "ifc_loft.h"

#include <math.h>

#include "solid_points.h"

/* ---- faces --------------------------------------------------------------- */

static bool
is_same(struct tcs_point a, struct tcs_point b)
{
	return a.x == b.x && a.y == b.y && a.z == b.z;
}

static enum ifc_outcome
polygon(struct ifc_shaper *shaper, const struct tcs_point *corners,
	size_t count, struct ifc_faces *out)
{
	enum ifc_outcome outcome = ifc_points_room(shaper, &out->points, count);

	if (outcome)
		return outcome;
	for (size_t i = 0; i < count; i++)
		out->points.at[out->points.count++] = corners[i];
	outcome = ifc_ring_end(shaper, out, NULL);
	return outcome ? outcome : ifc_face_end(shaper, out);
}

/* Whether four points are in one plane, as the file's precision has it. */
static bool
is_plane(const struct ifc_shaper *shaper, const struct tcs_point *corners)
{
	struct tcs_point normal =
		point_cross(point_minus(corners[2], corners[0]),
			point_minus(corners[3], corners[1]));
	double length = sqrt(point_dot(normal, normal));
	double off = point_dot(normal, point_minus(corners[1], corners[0]));

	return fabs(off) <= shaper->precision * length;
}

/* Between the edge from a to b of one station and that of the next one. */
static enum ifc_outcome
wall(struct ifc_shaper *shaper, const struct tcs_point *here,
	const struct tcs_point *there, size_t a, size_t b,
	struct ifc_faces *out)
{
	const struct tcs_point all[4] = {here[a], here[b], there[b], there[a]};
	struct tcs_point corners[4];
	enum ifc_outcome outcome;
	size_t count = 0;

	for (size_t i = 0; i < 4; i++)
		if (!is_same(all[i], all[(i + 1) % 4]))
			corners[count++] = all[i];
	if (count < 3)
		return IFC_SHAPED;
	if (count == 3 || is_plane(shaper, corners))
		return polygon(shaper, corners, count, out);
	outcome = polygon(shaper, corners, 3, out);
	corners[1] = corners[2];
	corners[2] = corners[3];
	return outcome ? outcome : polygon(shaper, corners, 3, out);
}

static enum ifc_outcome
walls(struct ifc_shaper *shaper, const struct ifc_loft *loft,
	const struct tcs_point *here, const struct tcs_point *there,
	struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t first = 0;

	for (size_t i = 0; i < loft->ring_count; i++) {
		size_t count = loft->rings[i];

		for (size_t k = 0; k < count && !outcome; k++)
			outcome = wall(shaper, here, there, first + k,
				first + (k + 1) % count, out);
		first += count;
	}
	return outcome;
}

/* The first or last section; none where it has shrunk to a point. */
static enum ifc_outcome
section(struct ifc_shaper *shaper, const struct ifc_loft *loft,
	const struct tcs_point *points, struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t same = 1;

	while (same < loft->rings[0] && is_same(points[0], points[same]))
		same++;
	if (same == loft->rings[0])
		return IFC_SHAPED;
	for (size_t i = 0; i < loft->ring_count && !outcome; i++) {
		size_t count = loft->rings[i];

		outcome = ifc_points_room(shaper, &out->points, count);
		for (size_t k = 0; k < count && !outcome; k++)
			out->points.at[out->points.count++] = *points++;
		if (!outcome)
			outcome = ifc_ring_end(shaper, out, NULL);
	}
	return outcome ? outcome : ifc_face_end(shaper, out);
}

static size_t
section_size(const struct ifc_loft *loft)
{
	size_t size = 0;

	for (size_t i = 0; i < loft->ring_count; i++)
		size += loft->rings[i];
	return size;
}

enum ifc_outcome
ifc_loft_faces(struct ifc_shaper *shaper, const struct ifc_loft *loft,
	struct ifc_faces *out)
{
	size_t size = section_size(loft), first = out->faces.count;
	size_t stations = size ? loft->points.count / size : 0;
	const struct tcs_point *points = loft->points.at;
	enum ifc_outcome outcome = IFC_SHAPED;
	double volume;

	if (stations < 2)
		return ifc_refuse(shaper, STEP_NONE, "a sweep has no length");
	if (!loft->closed)
		outcome = section(shaper, loft, points, out);
	if (!outcome)
		ifc_faces_reverse(out, first);
	if (!outcome && !loft->closed)
		outcome = section(
			shaper, loft, points + (stations - 1) * size, out);
	for (size_t i = 0; i + !loft->closed < stations && !outcome; i++)
		outcome = walls(shaper, loft, points + i * size,
			points + (i + 1) % stations * size, out);
	if (outcome)
		return outcome;
	volume = ifc_faces_volume6(out, first);
	if (volume == 0 || !isfinite(volume))
		return ifc_refuse(shaper, STEP_NONE, "a sweep has no volume");
	if (volume < 0)
		ifc_faces_reverse(out, first);
	return IFC_SHAPED;
}

/* ---- matching rings ------------------------------------------------------ */

static double
distance(struct tcs_point a, struct tcs_point b)
{
	struct tcs_point d = point_minus(a, b);

	return sqrt(point_dot(d, d));
}

static double
ring_length(const struct tcs_point *ring, size_t count)
{
	double length = 0;

	for (size_t i = 0; i < count; i++)
		length += distance(ring[i], ring[(i + 1) % count]);
	return length;
}

/* A walk round a ring: an edge, and the part of the length where it ends. */
struct walk {
	const struct tcs_point *ring;
	size_t count, edge;
	double length, begin, end;
};

static void
walk_enter(struct walk *walk)
{
	size_t next = (walk->edge + 1) % walk->count;

	walk->begin = walk->end;
	walk->end += distance(walk->ring[walk->edge], walk->ring[next]) /
		walk->length;
	if (walk->edge + 1 >= walk->count)
		walk->end = 1;
}

static struct walk
walk_start(const struct tcs_point *ring, size_t count)
{
	struct walk walk = {.ring = ring,
		.count = count,
		.length = ring_length(ring, count)};

	walk_enter(&walk);
	return walk;
}

static struct tcs_point
walk_at(const struct walk *walk, double part)
{
	struct tcs_point a = walk->ring[walk->edge];
	struct tcs_point b = walk->ring[(walk->edge + 1) % walk->count];
	double span = walk->end - walk->begin;
	double along = span > 0 ? (part - walk->begin) / span : 0;

	return (struct tcs_point){a.x + along * (b.x - a.x),
		a.y + along * (b.y - a.y), a.z + along * (b.z - a.z)};
}

/* Both rings with a point wherever one has one. */
static enum ifc_outcome
rings_merge(struct ifc_shaper *shaper, struct walk a, struct walk b,
	struct ifc_faces *out_a, struct ifc_faces *out_b)
{
	const double same = 1e-9;
	enum ifc_outcome outcome = IFC_SHAPED;
	double part = 0;

	while (!outcome && a.edge < a.count && b.edge < b.count) {
		double next = fmin(a.end, b.end);

		outcome = ifc_point_add(
			shaper, &out_a->points, walk_at(&a, part));
		if (!outcome)
			outcome = ifc_point_add(
				shaper, &out_b->points, walk_at(&b, part));
		part = next;
		if (a.end <= next + same && ++a.edge < a.count)
			walk_enter(&a);
		if (b.end <= next + same && ++b.edge < b.count)
			walk_enter(&b);
	}
	if (!outcome)
		outcome = ifc_ring_end(shaper, out_a, NULL);
	return outcome ? outcome : ifc_ring_end(shaper, out_b, NULL);
}

static bool
is_matched(const struct ifc_faces *a, const struct ifc_faces *b)
{
	for (size_t i = 0; i < a->rings.count; i++)
		if (a->rings.at[i] != b->rings.at[i])
			return false;
	return true;
}

static enum ifc_outcome
faces_merge(struct ifc_shaper *shaper, const struct ifc_faces *a,
	const struct ifc_faces *b, struct ifc_faces *out_a,
	struct ifc_faces *out_b)
{
	const struct tcs_point *at_a = a->points.at, *at_b = b->points.at;
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t ring = 0;

	for (size_t i = 0; i < a->faces.count && !outcome; i++) {
		for (uint32_t k = 0; k < a->faces.at[i].ring_count && !outcome;
			k++, ring++) {
			size_t count_a = a->rings.at[ring];
			size_t count_b = b->rings.at[ring];

			outcome = rings_merge(shaper, walk_start(at_a, count_a),
				walk_start(at_b, count_b), out_a, out_b);
			at_a += count_a;
			at_b += count_b;
		}
		if (!outcome)
			outcome = ifc_face_end(shaper, out_a);
		if (!outcome)
			outcome = ifc_face_end(shaper, out_b);
	}
	return outcome;
}

enum ifc_outcome
ifc_loft_match(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *a,
	struct ifc_faces *b)
{
	struct ifc_faces out_a = {.points = {.count = 0}};
	struct ifc_faces out_b = {.points = {.count = 0}};
	enum ifc_outcome outcome;
	bool alike = a->faces.count == b->faces.count &&
		a->rings.count == b->rings.count;

	for (size_t i = 0; alike && i < a->faces.count; i++)
		alike = a->faces.at[i].ring_count == b->faces.at[i].ring_count;
	if (!alike)
		return ifc_refuse(
			shaper, item, "sections of different topology");
	if (is_matched(a, b))
		return IFC_SHAPED;
	outcome = faces_merge(shaper, a, b, &out_a, &out_b);
	if (!outcome) {
		struct ifc_faces swap = *a;

		*a = out_a;
		out_a = swap;
		swap = *b;
		*b = out_b;
		out_b = swap;
	}
	ifc_faces_release(&out_a);
	ifc_faces_release(&out_b);
	return outcome;
}
