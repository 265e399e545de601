#include <math.h>

#include "ifc_surface.h"
#include "solid_points.h"

/* Samples of a span of knots in each direction, where a search begins. */
enum { SAMPLES = 4, MOST_SAMPLES = 32 };

enum { STEPS = 32, HALVES = 6 }; /* of a search */

/* A part of a radius below which an angle is open. */
static const double OPEN = 1e-9;

/* ---- periods ------------------------------------------------------------- */

static double
nearest_turn(double parameter, double period, double near)
{
	return period > 0
		? parameter + period * nearbyint((near - parameter) / period)
		: parameter;
}

static void
turn_near(const struct ifc_surface *surface, const struct ifc_uv *near,
	struct ifc_uv *uv)
{
	for (int i = 0; near && i < 2; i++)
		uv->at[i] = nearest_turn(
			uv->at[i], surface->period[i], near->at[i]);
}

/* ---- elementary surfaces ------------------------------------------------- */

static struct tcs_point
into(const struct ifc_matrix *at, struct tcs_point point)
{
	const double *m = at->at;
	double x = point.x - m[3], y = point.y - m[7], z = point.z - m[11];

	return (struct tcs_point){m[0] * x + m[4] * y + m[8] * z,
		m[1] * x + m[5] * y + m[9] * z,
		m[2] * x + m[6] * y + m[10] * z};
}

static bool
elementary_locate(const struct ifc_surface *surface, struct tcs_point point,
	struct ifc_uv *out)
{
	struct tcs_point p = into(&surface->at, point);
	double off = hypot(p.x, p.y);

	out->at[0] = atan2(p.y, p.x);
	switch (surface->kind) {
	case IFC_SURFACE_PLANE:
		*out = (struct ifc_uv){{p.x, p.y}};
		return true;
	case IFC_SURFACE_SPHERE:
		out->at[1] = atan2(p.z, off);
		return off > OPEN * surface->radius;
	case IFC_SURFACE_TORUS:
		out->at[1] = atan2(p.z, off - surface->radius);
		return true;
	default:
		out->at[1] = p.z;
		return true;
	}
}

/* ---- swept surfaces ------------------------------------------------------ */

/* A point as a sweep sees it: alike for all that it sweeps into each other. */
static struct tcs_point
flattened(const struct ifc_surface *surface, struct tcs_point point)
{
	struct tcs_point p;
	double high;

	if (surface->kind == IFC_SURFACE_EXTRUSION) {
		high = point_dot(point, surface->along);
		return (struct tcs_point){point.x - high * surface->along.x,
			point.y - high * surface->along.y,
			point.z - high * surface->along.z};
	}
	p = into(&surface->at, point);
	return (struct tcs_point){hypot(p.x, p.y), 0, p.z};
}

/*
 * The length of the swept curve where it comes nearest; of places as near, the
 * one nearest to `near`.
 */
static double
curve_locate(const struct ifc_surface *surface, struct tcs_point point,
	const double *near, struct tcs_point *found)
{
	const struct tcs_point *curve = surface->curve.at;
	struct tcs_point to = flattened(surface, point);
	double best = HUGE_VAL, out = 0;

	for (size_t i = 0; i + 1 < surface->curve.count; i++) {
		struct tcs_point a = flattened(surface, curve[i]);
		struct tcs_point edge =
			point_minus(flattened(surface, curve[i + 1]), a);
		double square = point_dot(edge, edge), part, length, distance;
		struct tcs_point off = point_minus(to, a);

		part = square > 0 ? point_dot(off, edge) / square : 0;
		part = fmin(fmax(part, 0), 1);
		off = (struct tcs_point){off.x - part * edge.x,
			off.y - part * edge.y, off.z - part * edge.z};
		length = surface->lengths.at[i] +
			part *
				(surface->lengths.at[i + 1] -
					surface->lengths.at[i]);
		distance = point_dot(off, off);
		if (near)
			distance += 1e-18 * (length - *near) * (length - *near);
		if (distance >= best)
			continue;
		best = distance;
		out = length;
		*found = (struct tcs_point){
			curve[i].x + part * (curve[i + 1].x - curve[i].x),
			curve[i].y + part * (curve[i + 1].y - curve[i].y),
			curve[i].z + part * (curve[i + 1].z - curve[i].z)};
	}
	return out;
}

static bool
swept_locate(const struct ifc_surface *surface, struct tcs_point point,
	const struct ifc_uv *near, struct ifc_uv *out)
{
	bool extruded = surface->kind == IFC_SURFACE_EXTRUSION;
	struct tcs_point found = {0, 0, 0}, from, to;
	double length = curve_locate(surface, point,
		near ? near->at + (extruded ? 0 : 1) : NULL, &found);

	if (extruded) {
		*out = (struct ifc_uv){{length,
			point_dot(point_minus(point, found), surface->along)}};
		return true;
	}
	from = into(&surface->at, found);
	to = into(&surface->at, point);
	*out = (struct ifc_uv){
		{atan2(to.y, to.x) - atan2(from.y, from.x), length}};
	return hypot(to.x, to.y) > OPEN * (hypot(to.x, to.y) + fabs(to.z)) &&
		hypot(from.x, from.y) >
		OPEN * (surface->high[1] - surface->low[1]);
}

/* ---- splines ------------------------------------------------------------- */

static double
square_off(const struct ifc_surface *surface, struct ifc_uv uv,
	struct tcs_point point)
{
	struct tcs_point off = point_minus(ifc_surface_at(surface, uv), point);

	return point_dot(off, off);
}

static struct ifc_uv
best_sample(const struct ifc_surface *surface, struct tcs_point point)
{
	size_t steps[2];
	struct ifc_uv best = {{surface->low[0], surface->low[1]}};
	double square = square_off(surface, best, point);

	for (int i = 0; i < 2; i++)
		steps[i] = SAMPLES *
			(size_t)nearbyint((surface->high[i] - surface->low[i]) /
				surface->step[i]);
	for (size_t i = 0; i <= steps[0]; i++)
		for (size_t k = 0; k <= steps[1]; k++) {
			struct ifc_uv uv = {{surface->low[0] +
					(surface->high[0] - surface->low[0]) *
						(double)i / (double)steps[0],
				surface->low[1] +
					(surface->high[1] - surface->low[1]) *
						(double)k / (double)steps[1]}};
			double here = square_off(surface, uv, point);

			if (here < square) {
				square = here;
				best = uv;
			}
		}
	return best;
}

static struct ifc_uv
kept_in(const struct ifc_surface *surface, struct ifc_uv uv)
{
	for (int i = 0; i < 2; i++)
		if (!(surface->period[i] > 0))
			uv.at[i] = fmin(fmax(uv.at[i], surface->low[i]),
				surface->high[i]);
	return uv;
}

/* One step of Gauss and Newton; false when there is none. */
static bool
newton_step(const struct ifc_surface *surface, struct tcs_point point,
	struct ifc_uv uv, struct ifc_uv *out)
{
	struct tcs_point here = ifc_surface_at(surface, uv), side[2];
	struct tcs_point off = point_minus(point, here);
	double a, b, c, d, e, determinant;

	for (int i = 0; i < 2; i++) {
		double step = surface->step[i] * 1e-5;
		struct ifc_uv low = uv, high = uv;

		low.at[i] -= step;
		high.at[i] += step;
		low = kept_in(surface, low);
		high = kept_in(surface, high);
		side[i] = point_minus(ifc_surface_at(surface, high),
			ifc_surface_at(surface, low));
		step = high.at[i] - low.at[i];
		side[i] = (struct tcs_point){
			side[i].x / step, side[i].y / step, side[i].z / step};
	}
	a = point_dot(side[0], side[0]);
	b = point_dot(side[0], side[1]);
	c = point_dot(side[1], side[1]);
	d = point_dot(side[0], off);
	e = point_dot(side[1], off);
	determinant = a * c - b * b;
	*out = uv;
	if (determinant > 1e-12 * a * c) {
		out->at[0] += (d * c - e * b) / determinant;
		out->at[1] += (e * a - d * b) / determinant;
	} else if (a > 0 && a >= c) {
		out->at[0] += d / a;
	} else if (c > 0) {
		out->at[1] += e / c;
	} else {
		return false;
	}
	*out = kept_in(surface, *out);
	return true;
}

/* The best place from a start, and how far off that is, squared. */
static double
newton(const struct ifc_surface *surface, struct tcs_point point,
	struct ifc_uv *uv)
{
	double square = square_off(surface, *uv, point);

	for (int i = 0; i < STEPS && square > 0; i++) {
		struct ifc_uv next;
		double here;

		if (!newton_step(surface, point, *uv, &next))
			break;
		here = square_off(surface, next, point);
		for (int k = 0; k < HALVES && here > square; k++) {
			next.at[0] = (next.at[0] + uv->at[0]) / 2;
			next.at[1] = (next.at[1] + uv->at[1]) / 2;
			here = square_off(surface, next, point);
		}
		if (here >= square)
			break;
		*uv = next;
		square = here;
	}
	return square;
}

/* Whether a place is in a side that is one point. */
static bool
is_pinched(const struct ifc_surface *surface, struct ifc_uv uv)
{
	for (int i = 0; i < 2; i++) {
		double range = surface->high[i] - surface->low[i];

		if ((surface->pinched[i][0] &&
			    uv.at[i] - surface->low[i] < 1e-6 * range) ||
			(surface->pinched[i][1] &&
				surface->high[i] - uv.at[i] < 1e-6 * range))
			return true;
	}
	return false;
}

static bool
spline_locate(const struct ifc_surface *surface, struct tcs_point point,
	const struct ifc_uv *near, struct ifc_uv *out)
{
	double square = HUGE_VAL;
	struct ifc_uv sample;

	/* What is near enough, and does not jump, is meant. */
	if (near) {
		*out = kept_in(surface, *near);
		square = newton(surface, point, out);
	}
	if (square > surface->tolerance * surface->tolerance) {
		sample = best_sample(surface, point);
		if (newton(surface, point, &sample) < square)
			*out = sample;
	}
	return !is_pinched(surface, *out);
}

/* Ends and seams are straight where points are all but on them. */
static void
snap(const struct ifc_surface *surface, struct ifc_uv *uv)
{
	for (int i = 0; i < 2; i++) {
		double low = surface->low[i], high = surface->high[i];
		double range = high - low, turns;

		if (!isfinite(range))
			continue;
		turns = surface->period[i] > 0
			? nearbyint((uv->at[i] - low) / surface->period[i])
			: uv->at[i] - low > range / 2;
		if (fabs(uv->at[i] - low - turns * range) < 1e-9 * range)
			uv->at[i] = turns == 1 ? high : low + turns * range;
	}
}

bool
ifc_surface_locate(const struct ifc_surface *surface, struct tcs_point point,
	const struct ifc_uv *near, struct ifc_uv *out)
{
	bool found;

	switch (surface->kind) {
	case IFC_SURFACE_EXTRUSION:
	case IFC_SURFACE_REVOLUTION:
		found = swept_locate(surface, point, near, out);
		break;
	case IFC_SURFACE_SPLINE:
		found = spline_locate(surface, point, near, out);
		break;
	default:
		found = elementary_locate(surface, point, out);
	}
	turn_near(surface, near, out);
	snap(surface, out);
	if (!found && near) {
		/* Only in a spline can v be the one that is open. */
		int open = surface->kind == IFC_SURFACE_SPLINE &&
			(surface->pinched[0][0] || surface->pinched[0][1]);

		out->at[open] = near->at[open];
	}
	return found;
}
