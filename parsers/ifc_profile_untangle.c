#include <math.h>

#include "ifc_cut.h"
#include "ifc_profile.h"
#include "planar_repair.h"
#include "triangulate.h"

/* What may be repaired, so that none takes longer than a moment. */
enum { MOST_POINTS = 20000, MOST_PAIRS = 10000000, MOST_CROSSINGS = 100000 };

struct tangle {
	struct planar polygon;
	struct point_list extra; /* where edges cross */
	struct planar_rings rings;
};

static void
tangle_release(struct tangle *tangle)
{
	planar_release(&tangle->polygon);
	array_release(&tangle->extra);
	planar_rings_release(&tangle->rings);
}

/* ---- rings --------------------------------------------------------------- */

static size_t
ring_first(const struct tangle *tangle, size_t ring)
{
	return ring ? tangle->rings.ends.at[ring - 1] : 0;
}

static struct planar_point
point_of(const struct tangle *tangle, size_t at)
{
	return tangle->polygon.points.at[tangle->rings.vertices.at[at]];
}

static double
ring_area2(const struct tangle *tangle, size_t ring)
{
	size_t first = ring_first(tangle, ring);
	struct planar_point origin = point_of(tangle, first);
	double area = 0;

	for (size_t i = first + 2; i < tangle->rings.ends.at[ring]; i++)
		area += planar_orient(
			origin, point_of(tangle, i - 1), point_of(tangle, i));
	return area;
}

/* Whether a ring runs round the middle of another one's first edge. */
static bool
ring_surrounds(const struct tangle *tangle, size_t ring, size_t hole)
{
	size_t end = tangle->rings.ends.at[ring], last = end - 1;
	struct planar_point a = point_of(tangle, ring_first(tangle, hole));
	struct planar_point b = point_of(tangle, ring_first(tangle, hole) + 1);
	struct planar_point at = {(a.x + b.x) / 2, (a.y + b.y) / 2};
	bool inside = false;

	for (size_t i = ring_first(tangle, ring); i < end; last = i++) {
		a = point_of(tangle, last);
		b = point_of(tangle, i);
		if ((a.y > at.y) != (b.y > at.y) &&
			at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y))
			inside = !inside;
	}
	return inside;
}

/* The smallest ring round a hole; the count of rings where there is none. */
static size_t
hole_home(const struct tangle *tangle, size_t hole)
{
	size_t best = tangle->rings.ends.count;
	double least = HUGE_VAL;

	for (size_t i = 0; i < tangle->rings.ends.count; i++) {
		double area = ring_area2(tangle, i);

		if (!(area > 0 && area < least) ||
			!ring_surrounds(tangle, i, hole))
			continue;
		least = area;
		best = i;
	}
	return best;
}

static enum ifc_outcome
ring_copy(struct ifc_shaper *shaper, const struct tangle *tangle, size_t ring,
	struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = ring_first(tangle, ring);
		i < tangle->rings.ends.at[ring] && !outcome; i++) {
		struct planar_point at = point_of(tangle, i);

		outcome = ifc_point_add(shaper, &out->points,
			(struct tcs_point){at.x, at.y, 0});
	}
	return outcome ? outcome : ifc_ring_end(shaper, out, NULL);
}

/* A face for each ring that is no hole, with the holes it is round. */
static enum ifc_outcome
faces_copy(struct ifc_shaper *shaper, const struct tangle *tangle,
	struct ifc_faces *out)
{
	size_t count = tangle->rings.ends.count;
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < count && !outcome; i++) {
		if (!(ring_area2(tangle, i) > 0))
			continue;
		outcome = ring_copy(shaper, tangle, i, out);
		for (size_t k = 0; k < count && !outcome; k++)
			if (ring_area2(tangle, k) < 0 &&
				hole_home(tangle, k) == i)
				outcome = ring_copy(shaper, tangle, k, out);
		if (!outcome)
			outcome = ifc_face_end(shaper, out);
	}
	return outcome;
}

/* ---- the whole ----------------------------------------------------------- */

/* Whether the rings of a face break no rule. */
static enum ifc_outcome
face_judge(
	const struct ifc_faces *faces, const struct ifc_face *face, bool *whole)
{
	struct triangulator *triangulator = triangulator_new();
	enum tcs_status status = TCS_NO_MEMORY;
	struct triangulation found = {.outcome = TRIANGULATION_EMPTY};
	struct tcs_fault fault;

	if (triangulator)
		status = triangulate(triangulator,
			faces->points.at + face->first_point,
			faces->rings.at + face->first_ring, face->ring_count,
			&found, &fault);
	*whole = !status && found.outcome == TRIANGULATION_WHOLE;
	triangulator_free(triangulator);
	return status ? IFC_NO_MEMORY : IFC_SHAPED;
}

/*
 * The outlines of a face, in the plane that is known: the areas of its rings
 * may cancel out. None where it is too tangled.
 */
static enum ifc_outcome
outlines_find(struct tangle *tangle, const struct ifc_faces *faces,
	const struct ifc_face *face)
{
	const struct tcs_point *points = faces->points.at + face->first_point;
	size_t count = ifc_face_points(faces, face);
	bool tangled = false, sound = false;
	enum tcs_status status;
	struct tcs_fault fault;

	tangle->polygon.plane = (struct planar_plane){
		.normal = {0, 0, 1}, .axes = {0, 1, 2}, .cosine = 1};
	if (count > MOST_POINTS ||
		planar_lay(&tangle->polygon, points,
			faces->rings.at + face->first_ring, face->ring_count,
			count, &status))
		return IFC_SHAPED;
	if (!status)
		status = planar_tangle(&tangle->polygon, MOST_PAIRS,
			MOST_CROSSINGS, &tangled, &fault);
	if (!status && !tangled)
		status = planar_outline(&tangle->polygon, points, 0,
			&tangle->rings, &tangle->extra, &sound, &fault);
	if (!sound)
		tangle->rings.ends.count = 0;
	return status ? IFC_NO_MEMORY : IFC_SHAPED;
}

enum ifc_outcome
ifc_profile_untangle(
	struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *faces)
{
	const struct ifc_face *face = faces->faces.at + faces->faces.count - 1;
	struct ifc_faces found = {.points = {.count = 0}};
	struct tangle tangle = {.polygon = {.area = 0}};
	bool whole = false;
	enum ifc_outcome outcome = face_judge(faces, face, &whole);

	if (!outcome && !whole)
		outcome = outlines_find(&tangle, faces, face);
	if (!outcome)
		outcome = faces_copy(shaper, &tangle, &found);
	if (!outcome && found.faces.count) {
		ifc_faces_cut(faces, faces->faces.count - 1);
		outcome = ifc_faces_append(shaper, faces, &found, 0);
		if (!outcome)
			outcome = ifc_remark(shaper, profile, REPORT_REPAIRED,
				"crosses itself: by the odd-even rule");
	}
	ifc_faces_release(&found);
	tangle_release(&tangle);
	return outcome;
}
