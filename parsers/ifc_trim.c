#include <math.h>

#include "ifc_curve.h"
#include "ifc_spline.h"

enum { BASIS, FIRST, SECOND, SENSE, MASTER };

static const double PI = 3.14159265358979323846;

/* Angles nearer than this, in radians, make a full turn rather than nothing. */
static const double SAME_ANGLE = 1e-9;

/* One end as the file gives it: a parameter, a point, or both. */
struct trim {
	double parameter;
	struct tcs_point point;
	bool has_parameter, has_point;
};

static void
trim_read(const struct ifc_file *file, uint32_t trimmed, int position,
	struct trim *out)
{
	struct step_value list = ifc_value(file, trimmed, position), item;

	*out = (struct trim){.parameter = 0};
	while (list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		if (item.kind == STEP_REFERENCE)
			out->has_point = ifc_triple(file,
				step_target(file->step, &item), &out->point);
		else if (step_number(&item, &out->parameter))
			out->has_parameter = true;
	}
}

/* ---- from points to parameters ------------------------------------------- */

static double
along(struct tcs_point direction, struct tcs_point from, struct tcs_point to)
{
	return direction.x * (to.x - from.x) + direction.y * (to.y - from.y) +
		direction.z * (to.z - from.z);
}

static double
conic_parameter(const struct ifc_conic *conic, struct tcs_point point)
{
	const double *m = conic->at.at;
	struct tcs_point centre = {m[3], m[7], m[11]};
	struct tcs_point x = {m[0], m[4], m[8]}, y = {m[1], m[5], m[9]};

	return atan2(along(y, centre, point) / conic->b,
		along(x, centre, point) / conic->a);
}

/* The place on a polyline that is nearest, the n-th point being n. */
static double
nearest_place(const struct ifc_points *points, struct tcs_point point)
{
	double best = HUGE_VAL, place = 0;

	for (size_t i = 0; i + 1 < points->count; i++) {
		struct tcs_point a = points->at[i], b = points->at[i + 1];
		struct tcs_point d = {b.x - a.x, b.y - a.y, b.z - a.z}, at;
		double square = along(d, a, b), part = along(d, a, point);
		double distance;

		part = square > 0 ? fmin(fmax(part / square, 0), 1) : 0;
		at = (struct tcs_point){
			a.x + part * d.x, a.y + part * d.y, a.z + part * d.z};
		at = (struct tcs_point){
			point.x - at.x, point.y - at.y, point.z - at.z};
		distance = at.x * at.x + at.y * at.y + at.z * at.z;
		if (distance < best) {
			best = distance;
			place = (double)i + part;
		}
	}
	return place;
}

static enum ifc_outcome
polyline_parameter(struct ifc_shaper *shaper, uint32_t curve,
	struct tcs_point point, double *out)
{
	struct ifc_points points = {.count = 0};
	enum ifc_outcome outcome = ifc_curve_points(shaper, curve, &points);

	if (!outcome)
		*out = nearest_place(&points, point);
	array_release(&points);
	return outcome;
}

/* The same of a trimmed curve, which counts from its start. */
static enum ifc_outcome
trimmed_parameter(struct ifc_shaper *shaper, uint32_t trimmed,
	struct tcs_point point, double *out)
{
	uint32_t basis = ifc_target(shaper->file, trimmed, BASIS);
	enum ifc_entity kind = ifc_entity_of(shaper->file, basis);
	double from, to, turn = 2 * PI / shaper->angle;
	enum ifc_outcome outcome = ifc_enter(shaper, trimmed);

	if (outcome)
		return outcome;
	outcome = ifc_trim_range(shaper, trimmed, &from, &to);
	if (!outcome)
		outcome = ifc_curve_locate(shaper, basis, point, out);
	ifc_leave(shaper);
	if (outcome)
		return outcome;
	*out = to < from ? from - *out : *out - from;
	if (kind == IFC_CIRCLE || kind == IFC_ELLIPSE)
		*out -= turn * floor(*out / turn + SAME_ANGLE);
	*out = fmin(fmax(*out, 0), fabs(to - from));
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_curve_locate(struct ifc_shaper *shaper, uint32_t basis,
	struct tcs_point point, double *out)
{
	struct tcs_point start, direction;
	struct ifc_conic conic;
	enum ifc_outcome outcome;

	switch (ifc_entity_of(shaper->file, basis)) {
	case IFC_LINE:
		if (!ifc_line_read(shaper->file, basis, &start, &direction))
			return ifc_refuse(shaper, basis, "a line is bad");
		*out = along(direction, start, point) /
			along(direction, (struct tcs_point){0, 0, 0},
				direction);
		return IFC_SHAPED;
	case IFC_CIRCLE:
	case IFC_ELLIPSE:
		outcome = ifc_conic_read(shaper, basis, &conic);
		if (!outcome)
			*out = conic_parameter(&conic, point) / shaper->angle;
		return outcome;
	case IFC_POLYLINE:
	case IFC_INDEXEDPOLYCURVE:
		return polyline_parameter(shaper, basis, point, out);
	case IFC_TRIMMEDCURVE:
		return trimmed_parameter(shaper, basis, point, out);
	case IFC_BEZIERCURVE:
	case IFC_RATIONALBEZIERCURVE:
	case IFC_BSPLINECURVEWITHKNOTS:
	case IFC_RATIONALBSPLINECURVEWITHKNOTS:
		return ifc_spline_nearest(shaper, basis, point, out);
	default:
		return ifc_refuse(shaper, basis,
			"a curve of this kind is not trimmed by points");
	}
}

static enum ifc_outcome
trim_parameter(struct ifc_shaper *shaper, uint32_t trimmed,
	const struct trim *trim, bool by_point, double *out)
{
	if (trim->has_point && (by_point || !trim->has_parameter))
		return ifc_curve_locate(shaper,
			ifc_target(shaper->file, trimmed, BASIS), trim->point,
			out);
	*out = trim->parameter;
	if (!trim->has_parameter || !isfinite(*out))
		return ifc_refuse(shaper, trimmed, "a curve has no ends");
	return IFC_SHAPED;
}

/* ---- the range ----------------------------------------------------------- */

/* Bring `to` behind `from` by less than, or just, one turn. */
static void
turn_on(double full, bool forwards, double from, double *to)
{
	double turn = fmod(forwards ? *to - from : from - *to, full);

	if (turn < 0)
		turn += full;
	if (turn <= SAME_ANGLE / (2 * PI) * full)
		turn = full;
	*to = forwards ? from + turn : from - turn;
}

enum ifc_outcome
ifc_trim_range(
	struct ifc_shaper *shaper, uint32_t trimmed, double *from, double *to)
{
	const struct ifc_file *file = shaper->file;
	struct step_value sense = ifc_value(file, trimmed, SENSE);
	struct step_value master = ifc_value(file, trimmed, MASTER);
	enum ifc_entity basis =
		ifc_entity_of(file, ifc_target(file, trimmed, BASIS));
	bool by_point = step_is(&master, "CARTESIAN");
	struct trim first, second;
	enum ifc_outcome outcome = ifc_enter(shaper, trimmed);

	if (outcome)
		return outcome;
	trim_read(file, trimmed, FIRST, &first);
	trim_read(file, trimmed, SECOND, &second);
	outcome = trim_parameter(shaper, trimmed, &first, by_point, from);
	if (!outcome)
		outcome =
			trim_parameter(shaper, trimmed, &second, by_point, to);
	if (!outcome && (basis == IFC_CIRCLE || basis == IFC_ELLIPSE))
		turn_on(2 * PI / shaper->angle, !step_is(&sense, "F"), *from,
			to);
	ifc_leave(shaper);
	return outcome;
}
