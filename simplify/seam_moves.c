/*
 * Which faces hold the points of the seams once a node has moved.
 *
 * Most points are over or under one face of the ring, as it will be, and beside
 * the others. Planes through the edges, which are the same for all points, tell
 * which, and how far beside them a point is at least; few faces need a closer
 * look.
 */
#include "collapses.h"

#include <math.h>

/* Square metres: a face this near to a point is not beaten by another. */
#define NEAR_ENOUGH 1e-14

/* Metres: so far inside of its edges is inside of a face, whatever is lost to
   rounding. */
#define INSIDE 2e-7

/* Of a distance: what is not farther by more may be as near, but for rounding. */
#define ROUNDING 1.0001

/* ---- which face holds a point --------------------------------------------- */

static double
square_distance(struct tcs_point a, struct tcs_point b)
{
	struct tcs_point ab = vector_difference(b, a);

	return vector_dot(ab, ab);
}

/* From the moved corner to the next, to the last, and back. */
static struct ring_sides
sides_of(const struct ring_face *face)
{
	const struct tcs_point *p = face->shape.corner;
	struct tcs_point first = vector_difference(p[1], p[0]);
	const struct tcs_point edges[3] = {first, vector_difference(p[2], p[1]),
		vector_difference(p[0], p[2])};
	struct ring_sides sides;

	sides.square = vector_dot(face->normal, face->normal);
	for (int k = 0; k < 3; k++) {
		sides.inward[k] = vector_cross(face->normal, edges[k]);
		sides.lengths[k] =
			sqrt(sides.square * vector_dot(edges[k], edges[k]));
	}
	sides.far = vector_dot(sides.inward[1], first);
	return sides;
}

static enum tcs_status
find_sides(struct collapses *work, struct tcs_fault *fault)
{
	work->sides.count = work->fan;
	if (array_grow(&work->sides, work->ring.count - work->fan))
		return fault_memory(fault);
	for (size_t i = work->fan; i < work->ring.count; i++)
		work->sides.at[work->sides.count++] =
			sides_of(&work->ring.at[i]);
	return TCS_OK;
}

/* Whether a point, seen from the moved corner, is over or under the face. */
static inline bool
is_above(const struct ring_sides *sides, struct tcs_point point)
{
	const struct tcs_point *inward = sides->inward;

	return vector_dot(inward[0], point) > INSIDE * sides->lengths[0] &&
		vector_dot(inward[2], point) > INSIDE * sides->lengths[2] &&
		vector_dot(inward[1], point) - sides->far >
		INSIDE * sides->lengths[1];
}

/* Whether it is beside it, by more than so far. */
static inline bool
is_beside(const struct ring_sides *sides, struct tcs_point point, double reach)
{
	const struct tcs_point *inward = sides->inward;

	return vector_dot(inward[0], point) < -reach * sides->lengths[0] ||
		vector_dot(inward[2], point) < -reach * sides->lengths[2] ||
		vector_dot(inward[1], point) - sides->far <
		-reach * sides->lengths[1];
}

/* A face of the ring that would hold a point of a seam, and where it is
   nearest to it. */
struct holder {
	const struct ring_face *face; /* NULL: none */
	struct tcs_point at;
	double square; /* of the distance */
};

/* A face that the point is over or under, `guess` if that is one; else the
   count. */
static inline size_t
find_above(const struct collapses *work, struct tcs_point away, size_t guess)
{
	if (is_above(&work->sides.at[guess], away))
		return guess;
	for (size_t i = work->fan; i < work->ring.count; i++)
		if (is_above(&work->sides.at[i], away))
			return i;
	return work->ring.count;
}

/* Over or under a face. */
static inline struct tcs_point
foot_on(const struct collapses *work, size_t i, struct tcs_point point,
	struct tcs_point away)
{
	struct tcs_point normal = work->ring.at[i].normal;

	return vector_along(point, normal,
		-vector_dot(normal, away) / work->sides.at[i].square);
}

/* What is farther than a face at this distance, squared, need not be looked
   at. */
static inline double
reach_of(double square)
{
	return ROUNDING * sqrt(square > NEAR_ENOUGH ? square : NEAR_ENOUGH);
}

/* The first that is near enough, or the nearest. */
static struct holder
next_holder(const struct collapses *work, struct tcs_point point, size_t guess)
{
	struct holder best = {.square = INFINITY};
	struct tcs_point away, foot = point;
	double reach = INFINITY;
	size_t above;

	if (work->fan == work->ring.count)
		return best;
	away = vector_difference(
		point, work->ring.at[work->fan].shape.corner[0]);
	above = find_above(work, away, guess);
	if (above < work->ring.count) {
		foot = foot_on(work, above, point, away);
		reach = reach_of(square_distance(foot, point));
	}
	for (size_t i = work->fan;
		i < work->ring.count && best.square > NEAR_ENOUGH; i++) {
		const struct ring_face *face = &work->ring.at[i];
		const struct ring_sides *sides = &work->sides.at[i];
		double height = vector_dot(face->normal, away), square;
		struct tcs_point at;

		if (is_beside(sides, away, reach) ||
			height * height > best.square * sides->square)
			continue;
		at = i == above ? foot
				: triangle_nearest_along(
					  &face->shape, face->normal, point);
		square = square_distance(at, point);
		if (square < best.square) {
			best = (struct holder){face, at, square};
			if (i != above)
				reach = reach_of(square);
		}
	}
	return best;
}

/* Whether from where either side is nearest to the point the other side is
   not farther than the limit. */
static bool
is_held(const struct collapses *work, const struct seam_point *point,
	const struct holder *own, double off, const struct seam_hold *hold)
{
	double limit = (double)point->limit * (double)point->limit;
	struct triangle_shape other;
	struct tcs_point there;

	if (off + (double)hold->off <= (double)point->limit)
		return true;
	other = collapses_shape(work, hold->face);
	if (square_distance(own->at, triangle_nearest(&other, own->at)) <=
		limit)
		return true;
	there = triangle_nearest(&other, point->at);
	return square_distance(there,
		       triangle_nearest(&own->face->shape, there)) <= limit;
}

static struct seam_move
move_after(const struct collapses *work, uint32_t hold, size_t *guess)
{
	const struct seams *seams = work->seams;
	const struct seam_point *point = &seams->points.at[hold / 2];
	struct holder own = next_holder(work, point->at, *guess);
	double off = sqrt(own.square);

	if (own.face)
		*guess = (size_t)(own.face - work->ring.at);
	if (!own.face ||
		!is_held(work, point, &own, off, &seams->holds.at[hold ^ 1]))
		return (struct seam_move){hold, TCS_NONE, INFINITY};
	return (struct seam_move){hold, own.face->face, off};
}

/* ---- all of them ----------------------------------------------------------- */

static enum tcs_status
list_moves_of(struct collapses *work, uint32_t face, struct tcs_fault *fault)
{
	const struct seams *seams = work->seams;
	size_t guess = work->fan;

	for (uint32_t hold = seams->faces.at[face]; hold != TCS_NONE;
		hold = seams->holds.at[hold].next) {
		struct seam_move move = move_after(work, hold, &guess);

		if (array_grow(&work->moves, 1) || array_grow(&work->opened, 1))
			return fault_memory(fault);
		work->moves.at[work->moves.count++] = move;
		if (move.face == TCS_NONE)
			work->opened.at[work->opened.count++] =
				seams->points.at[hold / 2].contact;
	}
	return TCS_OK;
}

enum tcs_status
seam_moves_list(struct collapses *work, size_t count, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	bool knows_sides = false;

	for (size_t i = 0; !status && i < count; i++) {
		uint32_t face = work->spokes.at[i].face;

		if (face == HALF_EDGE_NONE ||
			work->seams->faces.at[face] == TCS_NONE)
			continue;
		if (!knows_sides)
			status = find_sides(work, fault);
		knows_sides = true;
		if (!status)
			status = list_moves_of(work, face, fault);
	}
	return status;
}

bool
seam_moves_break(struct collapses *work)
{
	for (size_t i = 0; i < work->opened.count; i++) {
		uint32_t contact = work->opened.at[i];
		const struct seam_count *count =
			&work->seams->counts.at[contact];
		uint32_t times =
			times_listed(work->opened.at, work->opened.count, i);
		double broken;

		if (times > 0 && cover_watch_loses(&work->covers, contact))
			continue;
		if (times > 0 && count->open + times >= count->points)
			return false;
		if (times == 0)
			continue;
		broken = seam_broken(count, count->open + times) -
			seam_broken(count, count->open);
		work->breaks_contact |= broken > 0;
		work->broken += broken *
			(work->worths.count > 0
					? (double)work->worths.at[contact]
					: 1);
	}
	return true;
}

void
seam_moves_do(struct collapses *work)
{
	for (size_t i = 0; i < work->moves.count; i++) {
		const struct seam_move *move = &work->moves.at[i];

		if (move->face == TCS_NONE)
			seams_open(work->seams, move->hold / 2);
		else
			seams_move_hold(
				work->seams, move->hold, move->face, move->off);
	}
}
