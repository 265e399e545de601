#include "ifc_path.h"

#include <math.h>

#include "ifc_curve.h"
#include "solid_points.h"

/* Sharper bends than this, as the cosine of half the angle, are cut off. */
static const double SHARPEST = 0.2;

static double
length_of(struct tcs_point a)
{
	return sqrt(point_dot(a, a));
}

static struct tcs_point
scaled(struct tcs_point a, double by)
{
	return (struct tcs_point){a.x * by, a.y * by, a.z * by};
}

static struct tcs_point
direction(struct tcs_point from, struct tcs_point to)
{
	struct tcs_point d = point_minus(to, from);
	double length = length_of(d);

	return length > 0 ? scaled(d, 1 / length) : (struct tcs_point){0, 0, 0};
}

/* ---- stations ------------------------------------------------------------ */

static void
station_bend(
	struct ifc_station *station, struct tcs_point in, struct tcs_point on)
{
	struct tcs_point sum = point_plus(in, on);
	struct tcs_point bend = point_minus(on, in);
	double half = length_of(sum) / 2, side = length_of(bend);

	station->along = half > 1e-9 ? scaled(sum, 1 / (2 * half)) : in;
	station->bend = side > 1e-12 ? scaled(bend, 1 / side)
				     : (struct tcs_point){0, 0, 0};
	station->widen = 1 / fmax(half, SHARPEST);
}

static void
stations_bend(struct ifc_path *path)
{
	struct ifc_station *all = path->stations.at;
	size_t count = path->stations.count;

	for (size_t i = 0; i < count; i++) {
		size_t last = (i + count - 1) % count, next = (i + 1) % count;
		struct tcs_point in = direction(all[last].at, all[i].at);
		struct tcs_point on = direction(all[i].at, all[next].at);

		if (!path->closed && i == 0)
			in = on;
		if (!path->closed && next == 0)
			on = in;
		station_bend(all + i, in, on);
	}
}

enum ifc_outcome
ifc_path_along(struct ifc_shaper *shaper, const struct ifc_points *points,
	struct ifc_path *out)
{
	struct ifc_stations *stations = &out->stations;
	double place = 0;

	array_clear(stations);
	if (array_grow(stations, points->count + 1))
		return IFC_NO_MEMORY;
	for (size_t i = 0; i < points->count; i++) {
		struct tcs_point at = points->at[i], before = at;

		if (stations->count)
			before = stations->at[stations->count - 1].at;
		if (stations->count && ifc_same_point(shaper, before, at))
			continue;
		place += length_of(point_minus(at, before));
		stations->at[stations->count++] =
			(struct ifc_station){.at = at, .place = place};
	}
	out->closed = stations->count > 3 &&
		ifc_same_point(shaper, stations->at[0].at,
			stations->at[stations->count - 1].at);
	if (out->closed)
		stations->count--;
	if (stations->count < 2 || !isfinite(place))
		return ifc_refuse(shaper, STEP_NONE, "a path has no length");
	stations_bend(out);
	return IFC_SHAPED;
}

void
ifc_path_release(struct ifc_path *path)
{
	array_release(&path->stations);
}

/* ---- from curves --------------------------------------------------------- */

/* Whether a value is a length along the curve rather than a parameter. */
static bool
is_length(const struct step_value *value)
{
	return step_is(value, "IFCLENGTHMEASURE") ||
		step_is(value, "IFCNONNEGATIVELENGTHMEASURE") ||
		step_is(value, "IFCPOSITIVELENGTHMEASURE");
}

/* The position among points, the n-th being n, that far along them. */
static double
position_at(const struct ifc_points *points, double length)
{
	for (size_t i = 0; i + 1 < points->count; i++) {
		double step = length_of(
			point_minus(points->at[i + 1], points->at[i]));

		if (length <= step)
			return (double)i + (step > 0 ? length / step : 0);
		length -= step;
	}
	return (double)(points->count - 1);
}

static struct tcs_point
point_at(const struct ifc_points *points, double position)
{
	size_t i = (size_t)position;
	double part = position - (double)i;
	struct tcs_point a = points->at[i];

	return part > 0
		? point_plus(a, scaled(point_minus(points->at[i + 1], a), part))
		: a;
}

/* Keep what lies between two lengths. */
static enum ifc_outcome
cut_by_length(struct ifc_shaper *shaper, struct ifc_points *points,
	double start, double end)
{
	struct ifc_points out = {.count = 0};
	enum ifc_outcome outcome;
	double from, to;

	if (points->count < 2)
		return ifc_refuse(shaper, STEP_NONE, "a path has no length");
	from = position_at(points, fmax(start, 0));
	to = position_at(points, fmax(end, 0));
	outcome = ifc_point_add(shaper, &out, point_at(points, from));
	for (size_t i = (size_t)from + 1; (double)i < to && !outcome; i++)
		outcome = ifc_point_add(shaper, &out, points->at[i]);
	if (!outcome)
		outcome = ifc_point_add(shaper, &out, point_at(points, to));
	if (!outcome) {
		struct ifc_points swap = *points;

		*points = out;
		out = swap;
	}
	array_release(&out);
	return outcome;
}

/*
 * Whether parameters mean the ends of a curve as programs write them: 0 and 1
 * on a polyline, and on a trimmed curve those of its basis where it is cut.
 */
static enum ifc_outcome
are_ends(struct ifc_shaper *shaper, uint32_t curve, double from, double to,
	bool *out)
{
	enum ifc_outcome outcome;
	double first, last;

	*out = false;
	switch (ifc_entity_of(shaper->file, curve)) {
	case IFC_POLYLINE:
	case IFC_INDEXEDPOLYCURVE:
		*out = from == 0 && to == 1;
		return IFC_SHAPED;
	case IFC_TRIMMEDCURVE:
		outcome = ifc_trim_range(shaper, curve, &first, &last);
		*out = !outcome && from == first && to == last;
		return outcome;
	default:
		return IFC_SHAPED;
	}
}

static enum ifc_outcome
points_between(struct ifc_shaper *shaper, uint32_t curve,
	const struct step_value *start, const struct step_value *end,
	struct ifc_points *out)
{
	double from, to, low = -HUGE_VAL, high = HUGE_VAL;
	bool starts = step_number(start, &low), ends = step_number(end, &high);
	bool whole = !starts && !ends;
	enum ifc_outcome outcome = IFC_SHAPED;

	if (starts && ends)
		outcome = are_ends(shaper, curve, low, high, &whole);
	if (outcome)
		return outcome;
	if (whole || is_length(start) || is_length(end)) {
		outcome = ifc_curve_points(shaper, curve, out);
		return outcome || whole ? outcome
					: cut_by_length(shaper, out, low, high);
	}
	outcome = ifc_curve_range(shaper, curve, &from, &to);
	return outcome ? outcome
		       : ifc_curve_between(shaper, curve, starts ? low : from,
				 ends ? high : to, out);
}

enum ifc_outcome
ifc_path_read(struct ifc_shaper *shaper, uint32_t curve,
	const struct step_value *start, const struct step_value *end,
	double reach, struct ifc_path *out)
{
	struct ifc_points points = {.count = 0};
	double before = shaper->reach;
	enum ifc_outcome outcome;

	shaper->reach += reach;
	outcome = points_between(shaper, curve, start, end, &points);
	shaper->reach = before;
	if (!outcome)
		outcome = ifc_path_along(shaper, &points, out);
	array_release(&points);
	return outcome;
}

/* ---- frames -------------------------------------------------------------- */

bool
ifc_station_turn(struct ifc_station *station, struct tcs_point wish)
{
	struct tcs_point t = station->along;
	struct tcs_point x = point_minus(wish, scaled(t, point_dot(wish, t)));
	double length = length_of(x);

	if (!(length > 1e-9 * length_of(wish)) || !isfinite(length))
		return false;
	station->x = scaled(x, 1 / length);
	return true;
}

/* A vector square to `from` by the least rotation to be square to `to`. */
static struct tcs_point
rotated(struct tcs_point vector, struct tcs_point from, struct tcs_point to)
{
	double cosine = point_dot(from, to);

	return cosine > -0.999999
		? point_minus(vector,
			  scaled(point_plus(from, to),
				  point_dot(vector, to) / (1 + cosine)))
		: vector;
}

static struct tcs_point
any_across(struct tcs_point along)
{
	struct tcs_point axis = {0, 0, 1};

	if (fabs(along.z) > 0.9)
		axis = (struct tcs_point){1, 0, 0};
	return direction((struct tcs_point){0, 0, 0}, point_cross(along, axis));
}

/* From one station to the next, by way of what is between them. */
static struct tcs_point
carried(const struct ifc_station *from, const struct ifc_station *to)
{
	struct tcs_point between = direction(from->at, to->at);

	return rotated(
		rotated(from->x, from->along, between), between, to->along);
}

void
ifc_path_carry(struct ifc_path *path)
{
	struct ifc_station *all = path->stations.at;
	size_t count = path->stations.count;
	struct tcs_point back, y;
	double turn;

	all[0].x = any_across(all[0].along);
	for (size_t i = 1; i < count; i++)
		if (!ifc_station_turn(all + i, carried(all + i - 1, all + i)))
			all[i].x = any_across(all[i].along);
	if (!path->closed)
		return;
	/* What is missing to a whole turn is shared by all. */
	back = carried(all + count - 1, all);
	y = point_cross(all[0].along, all[0].x);
	turn = atan2(point_dot(back, y), point_dot(back, all[0].x));
	for (size_t i = 1; i < count; i++) {
		double angle = -turn * (double)i / (double)count;

		y = point_cross(all[i].along, all[i].x);
		all[i].x = point_plus(
			scaled(all[i].x, cos(angle)), scaled(y, sin(angle)));
	}
}

struct tcs_point
ifc_station_place(const struct ifc_station *station, double x, double y)
{
	struct tcs_point axis = point_cross(station->along, station->x);
	struct tcs_point off =
		point_plus(scaled(station->x, x), scaled(axis, y));
	double more = (station->widen - 1) * point_dot(off, station->bend);

	return point_plus(
		station->at, point_plus(off, scaled(station->bend, more)));
}
