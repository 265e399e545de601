#include "ifc_unrolled.h"

#include <math.h>

enum { MOST_SEAM = 4096 }; /* points of a seam */

/* ---- loops --------------------------------------------------------------- */

static enum ifc_outcome
point_add(struct ifc_unrolled *out, struct tcs_point at, struct ifc_uv uv)
{
	if (array_grow(&out->points, 1))
		return IFC_NO_MEMORY;
	out->points.at[out->points.count++] =
		(struct ifc_unrolled_point){at, uv};
	return IFC_SHAPED;
}

/* The first point that is not in a pinch; `count` when all are. */
static size_t
first_located(const struct ifc_surface *surface, const struct tcs_point *points,
	size_t count, struct ifc_uv *uv)
{
	size_t i = 0;

	while (i < count && !ifc_surface_locate(surface, points[i], NULL, uv))
		i++;
	return i;
}

static int
turns_of(double from, double to, double period)
{
	double turns = period > 0 ? nearbyint((to - from) / period) : 0;

	return turns > 0 ? 1 : turns < 0 ? -1 : 0;
}

/*
 * A point in a pinch stands twice: as its neighbours before and behind it see
 * it.
 */
enum ifc_outcome
ifc_unroll(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	const struct tcs_point *points, size_t count, struct ifc_unrolled *out)
{
	size_t before = out->points.count, first;
	struct ifc_uv start, last, here;
	struct ifc_unrolled_ring ring = {0};
	enum ifc_outcome outcome;
	bool pinched = false;

	first = first_located(surface, points, count, &start);
	if (count < 3 || first == count)
		return IFC_SHAPED;
	if (array_grow(&out->rings, 1))
		return IFC_NO_MEMORY;
	outcome = point_add(out, points[first], start);
	last = start;
	for (size_t i = 1; i <= count && !outcome; i++) {
		size_t at = (first + i) % count;
		bool open =
			!ifc_surface_locate(surface, points[at], &last, &here);

		if (pinched && !open) {
			struct ifc_unrolled_point twin =
				out->points.at[out->points.count - 1];

			for (int k = 0; k < 2; k++)
				if (!surface->pinched[k][0] &&
					!surface->pinched[k][1])
					twin.uv.at[k] = here.at[k];
			outcome = point_add(out, twin.at, twin.uv);
		}
		if (!outcome && i < count)
			outcome = point_add(out, points[at], here);
		pinched = open;
		last = here;
	}
	if (outcome)
		return outcome;
	for (int k = 0; k < 2; k++)
		ring.turns[k] =
			turns_of(start.at[k], last.at[k], surface->period[k]);
	if (shaper->points + out->points.count > IFC_MOST_POINTS)
		return ifc_refuse(shaper, STEP_NONE, "too many points");
	ring.count = (uint32_t)(out->points.count - before);
	out->rings.at[out->rings.count++] = ring;
	return IFC_SHAPED;
}

/* ---- seams --------------------------------------------------------------- */

/* How many chords a straight way in the parameters takes. */
static size_t
chords_between(
	const struct ifc_surface *surface, struct ifc_uv from, struct ifc_uv to)
{
	double most = 1;

	for (int i = 0; i < 2; i++)
		if (surface->step[i] > 0)
			most = fmax(most,
				ceil(fabs(to.at[i] - from.at[i]) /
						surface->step[i] -
					1e-9));
	return most > MOST_SEAM ? MOST_SEAM : (size_t)most;
}

static struct ifc_uv
between(struct ifc_uv a, struct ifc_uv b, double part)
{
	return (struct ifc_uv){{a.at[0] + part * (b.at[0] - a.at[0]),
		a.at[1] + part * (b.at[1] - a.at[1])}};
}

static struct ifc_uv
shifted(struct ifc_uv uv, int axis, double by)
{
	uv.at[axis] += by;
	return uv;
}

/*
 * The points within a way, without its ends; on the way back the same ones,
 * `by` further along the axis.
 */
static enum ifc_outcome
seam_add(const struct ifc_surface *surface, struct ifc_uv from,
	struct ifc_uv to, bool back, int axis, double by,
	struct ifc_unrolled *out)
{
	size_t count = chords_between(surface, from, to);
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 1; i < count && !outcome; i++) {
		double part = (double)(back ? count - i : i) / (double)count;
		struct ifc_uv uv = between(from, to, part);

		outcome = point_add(out, ifc_surface_at(surface, uv),
			shifted(uv, axis, by));
	}
	return outcome;
}

/* A ring that goes round, from one of its points on, as a part of a polygon. */
struct round {
	const struct ifc_unrolled_point *points;
	size_t count, first;
	double by; /* what to add along the axis */
};

static enum ifc_outcome
round_add(const struct round *round, int axis, double turn,
	struct ifc_unrolled *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i <= round->count && !outcome; i++) {
		size_t at = round->first + i;
		const struct ifc_unrolled_point *point =
			round->points + at % round->count;

		outcome = point_add(out, point->at,
			shifted(point->uv, axis,
				round->by + (at >= round->count ? turn : 0)));
	}
	return outcome;
}

/*
 * Two rings that go round, the one forwards and the other back, as one: along
 * the seam from the end of the first to the start of the second, and back.
 */
static enum ifc_outcome
rounds_join(const struct ifc_surface *surface, struct round a, struct round b,
	int axis, double turn, struct ifc_unrolled *out)
{
	double best = HUGE_VAL, end = a.points[0].uv.at[axis] + turn;
	struct ifc_uv from, to;
	enum ifc_outcome outcome;

	for (size_t i = 0; i < b.count; i++) {
		double off =
			remainder(b.points[i].uv.at[axis] - end, fabs(turn));

		if (fabs(off) < best) {
			best = fabs(off);
			b.first = i;
			b.by = end + off - b.points[i].uv.at[axis];
		}
	}
	from = shifted(a.points[0].uv, axis, turn);
	to = shifted(b.points[b.first].uv, axis, b.by);
	outcome = round_add(&a, axis, turn, out);
	if (!outcome)
		outcome = seam_add(surface, from, to, false, axis, 0, out);
	if (!outcome)
		outcome = round_add(&b, axis, -turn, out);
	return outcome ? outcome
		       : seam_add(surface, from, to, true, axis, -turn, out);
}

/* ---- polygons ------------------------------------------------------------ */

static double
area2(const struct ifc_unrolled_point *points, size_t count)
{
	double area = 0;

	for (size_t i = 2; i < count; i++)
		area += (points[i - 1].uv.at[0] - points[0].uv.at[0]) *
				(points[i].uv.at[1] - points[0].uv.at[1]) -
			(points[i].uv.at[0] - points[0].uv.at[0]) *
				(points[i - 1].uv.at[1] - points[0].uv.at[1]);
	return area;
}

/* Add a ring that goes round nothing, moved by periods towards a place. */
static enum ifc_outcome
hole_add(const struct ifc_surface *surface,
	const struct ifc_unrolled_point *points, uint32_t count,
	struct ifc_uv middle, struct ifc_unrolled *out)
{
	struct ifc_unrolled_ring ring = {.count = count};
	enum ifc_outcome outcome = IFC_SHAPED;
	double by[2] = {0, 0};

	for (int k = 0; k < 2; k++)
		if (surface->period[k] > 0)
			by[k] = surface->period[k] *
				nearbyint((middle.at[k] - points[0].uv.at[k]) /
					surface->period[k]);
	for (uint32_t i = 0; i < count && !outcome; i++) {
		struct ifc_uv uv = points[i].uv;

		uv.at[0] += by[0];
		uv.at[1] += by[1];
		outcome = point_add(out, points[i].at, uv);
	}
	if (outcome)
		return outcome;
	if (array_grow(&out->rings, 1))
		return IFC_NO_MEMORY;
	out->rings.at[out->rings.count++] = ring;
	return IFC_SHAPED;
}

/* The middle of the box of a ring. */
static struct ifc_uv
middle_of(const struct ifc_unrolled_point *points, size_t count)
{
	struct ifc_uv low = points[0].uv, high = low;

	for (size_t i = 1; i < count; i++)
		for (int k = 0; k < 2; k++) {
			low.at[k] = fmin(low.at[k], points[i].uv.at[k]);
			high.at[k] = fmax(high.at[k], points[i].uv.at[k]);
		}
	return between(low, high, 0.5);
}

/* What the rings of a face are. */
struct roles {
	size_t outer; /* the largest ring that goes round nothing */
	size_t round[2]; /* those that go round, forwards and back */
	int axis; /* … in this direction */
	size_t more; /* those that go round beside these */
};

static struct roles
roles_of(const struct ifc_unrolled *rings)
{
	struct roles out = {SIZE_MAX, {SIZE_MAX, SIZE_MAX}, 0, 0};
	const struct ifc_unrolled_point *points = rings->points.at;
	double largest = -1;

	for (size_t i = 0; i < rings->rings.count; i++) {
		const struct ifc_unrolled_ring *ring = rings->rings.at + i;
		int axis = ring->turns[0] ? 0 : 1, turn = ring->turns[axis];
		double area = fabs(area2(points, ring->count));

		points += ring->count;
		if (turn && out.round[turn < 0] == SIZE_MAX) {
			out.round[turn < 0] = i;
			out.axis = axis;
		} else if (turn) {
			out.more++;
		} else if (area > largest) {
			largest = area;
			out.outer = i;
		}
	}
	return out;
}

static struct round
round_of(const struct ifc_unrolled *rings, size_t index)
{
	struct round out = {
		rings->points.at, rings->rings.at[index].count, 0, 0};

	for (size_t i = 0; i < index; i++)
		out.points += rings->rings.at[i].count;
	return out;
}

/* A ring alone, joined to the pinch on one of its sides. */
static enum ifc_outcome
pinch_join(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	const struct round *ring, int axis, double turn, bool left,
	struct ifc_unrolled *out)
{
	int other = 1 - axis;
	/* To the left of +u is +v, to the left of +v is -u. */
	bool high = ((turn > 0) == left) == (axis == 0);
	struct ifc_unrolled_point tip = ring->points[0];

	if (!surface->pinched[other][high])
		high = !high;
	if (!surface->pinched[other][high])
		return ifc_refuse(shaper, STEP_NONE,
			"a face goes round its surface with one bound");
	tip.uv.at[other] = high ? surface->high[other] : surface->low[other];
	tip.at = ifc_surface_at(surface, tip.uv);
	return rounds_join(surface, *ring,
		(struct round){.points = &tip, .count = 1}, axis, turn, out);
}

/* All of a surface that closes: its low and its high end, along a seam. */
static enum ifc_outcome
whole_add(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	struct ifc_unrolled *out)
{
	struct ifc_unrolled ends[2] = {
		{.points = {.count = 0}}, {.points = {.count = 0}}};
	double turn = surface->period[0];
	size_t count =
		chords_between(surface, (struct ifc_uv){{surface->low[0], 0}},
			(struct ifc_uv){{surface->high[0], 0}});
	enum ifc_outcome outcome = IFC_SHAPED;

	if (!(turn > 0) ||
		!(surface->period[1] > 0 ||
			(surface->pinched[1][0] && surface->pinched[1][1])))
		return ifc_refuse(shaper, STEP_NONE, "a face has no bounds");
	for (size_t i = 0; i < count && !outcome; i++) {
		struct ifc_uv low = {
			{surface->low[0] + turn * (double)i / (double)count,
				surface->low[1]}};
		struct ifc_uv high = {{low.at[0], surface->high[1]}};

		if (surface->pinched[1][0] && i > 0)
			break;
		outcome = point_add(ends, ifc_surface_at(surface, low), low);
		/* Where it closes, both ends are the same points. */
		if (!outcome)
			outcome = point_add(ends + 1,
				ifc_surface_at(surface,
					surface->period[1] > 0 ? low : high),
				high);
	}
	for (size_t i = 0, k = ends[1].points.count; i + 1 < k; i++) {
		struct ifc_unrolled_point swap = ends[1].points.at[i];

		ends[1].points.at[i] = ends[1].points.at[--k];
		ends[1].points.at[k] = swap;
	}
	if (!outcome)
		outcome = rounds_join(surface,
			(struct round){.points = ends[0].points.at,
				.count = ends[0].points.count},
			(struct round){.points = ends[1].points.at,
				.count = ends[1].points.count},
			0, turn, out);
	ifc_unrolled_release(ends);
	ifc_unrolled_release(ends + 1);
	return outcome;
}

/* The outer ring of the polygon that the rings make. */
static enum ifc_outcome
outer_add(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	const struct ifc_unrolled *rings, const struct roles *roles,
	bool forwards, struct ifc_unrolled *out)
{
	bool on = roles->round[0] != SIZE_MAX;
	bool back = roles->round[1] != SIZE_MAX;
	double turn = surface->period[roles->axis];
	struct round ring;

	if (roles->more)
		return ifc_refuse(shaper, STEP_NONE,
			"a face goes round its surface too often");
	if (on && back)
		return rounds_join(surface, round_of(rings, roles->round[0]),
			round_of(rings, roles->round[1]), roles->axis, turn,
			out);
	if (!on && !back)
		return whole_add(shaper, surface, out);
	ring = round_of(rings, roles->round[back]);
	return pinch_join(shaper, surface, &ring, roles->axis,
		back ? -turn : turn, forwards, out);
}

static enum ifc_outcome
polygon_make(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	bool forwards, const struct ifc_unrolled *rings,
	struct ifc_unrolled *out)
{
	struct roles roles = roles_of(rings);
	bool goes_round = roles.round[0] != SIZE_MAX ||
		roles.round[1] != SIZE_MAX || roles.outer == SIZE_MAX;
	const struct ifc_unrolled_point *points = rings->points.at;
	enum ifc_outcome outcome = IFC_SHAPED;
	struct round ring;

	if (goes_round)
		outcome = outer_add(
			shaper, surface, rings, &roles, forwards, out);
	if (!outcome && goes_round) {
		if (array_grow(&out->rings, 1))
			return IFC_NO_MEMORY;
		out->rings.at[out->rings.count++] = (struct ifc_unrolled_ring){
			.count = (uint32_t)out->points.count};
	} else if (!outcome) {
		ring = round_of(rings, roles.outer);
		outcome = hole_add(surface, ring.points, (uint32_t)ring.count,
			ring.points[0].uv, out);
	}
	for (size_t i = 0; i < rings->rings.count && !outcome; i++) {
		const struct ifc_unrolled_ring *at = rings->rings.at + i;

		if (!at->turns[0] && !at->turns[1] &&
			(goes_round || i != roles.outer))
			outcome = hole_add(surface, points, at->count,
				middle_of(
					out->points.at, out->rings.at[0].count),
				out);
		points += at->count;
	}
	return outcome;
}

enum ifc_outcome
ifc_unrolled_close(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	bool forwards, struct ifc_unrolled *rings)
{
	struct ifc_unrolled out = {.points = {.count = 0}}, swap;
	enum ifc_outcome outcome =
		polygon_make(shaper, surface, forwards, rings, &out);

	if (!outcome) {
		swap = *rings;
		*rings = out;
		out = swap;
	}
	ifc_unrolled_release(&out);
	return outcome;
}

void
ifc_unrolled_release(struct ifc_unrolled *rings)
{
	array_release(&rings->points);
	array_release(&rings->rings);
}
