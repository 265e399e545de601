#include "ifc_surface.h"

#include <math.h>

#include "ifc_curve.h"
#include "ifc_profile.h"
#include "solid_points.h"

enum { POSITION, FIRST, SECOND };

enum { SWEPT_CURVE, SWEPT_POSITION, SWEPT_AXIS };

enum { PROFILE_CURVE = 2 };

enum {
	U_DEGREE,
	V_DEGREE,
	POLES,
	U_MULTIPLICITIES = 7,
	V_MULTIPLICITIES,
	U_KNOTS,
	V_KNOTS,
	WEIGHTS = 12
};

static const double PI = 3.14159265358979323846;

/* ---- elementary surfaces ------------------------------------------------- */

static double
angle_step(const struct ifc_shaper *shaper, double radius)
{
	return 2 * PI / (double)ifc_arc_chords(shaper, radius, 2 * PI);
}

static enum ifc_outcome
elementary_read(
	struct ifc_shaper *shaper, uint32_t surface, struct ifc_surface *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value first = ifc_value(file, surface, FIRST);
	struct step_value second = ifc_value(file, surface, SECOND);

	for (int i = 0; i < 2; i++) {
		out->low[i] = -HUGE_VAL;
		out->high[i] = HUGE_VAL;
	}
	if (!ifc_axes(file, ifc_target(file, surface, POSITION), &out->at))
		return ifc_refuse(shaper, surface, "a surface has no position");
	if (out->kind == IFC_SURFACE_PLANE)
		return IFC_SHAPED;
	if (!step_number(&first, &out->radius) || !(out->radius > 0) ||
		(out->kind == IFC_SURFACE_TORUS &&
			(!step_number(&second, &out->minor) ||
				!(out->minor > 0))))
		return ifc_refuse(shaper, surface, "a radius is not positive");
	out->low[0] = 0;
	out->high[0] = out->period[0] = 2 * PI;
	out->step[0] = angle_step(shaper, out->radius + out->minor);
	if (out->kind == IFC_SURFACE_TORUS) {
		out->low[1] = 0;
		out->high[1] = out->period[1] = 2 * PI;
		out->step[1] = angle_step(shaper, out->minor);
	} else if (out->kind == IFC_SURFACE_SPHERE) {
		out->low[1] = -PI / 2;
		out->high[1] = PI / 2;
		out->step[1] = out->step[0];
		out->pinched[1][0] = out->pinched[1][1] = true;
	}
	return IFC_SHAPED;
}

/* ---- swept surfaces ------------------------------------------------------ */

/* The curve of an open or closed profile, or the outline of any other. */
static enum ifc_outcome
profile_points(
	struct ifc_shaper *shaper, uint32_t profile, struct ifc_points *out)
{
	const struct ifc_file *file = shaper->file;
	struct ifc_faces faces = {.points = {.count = 0}};
	enum ifc_outcome outcome;

	if (ifc_is_kind(file, profile, IFC_ARBITRARYOPENPROFILEDEF) ||
		ifc_is_kind(file, profile, IFC_ARBITRARYCLOSEDPROFILEDEF))
		return ifc_curve_points(
			shaper, ifc_target(file, profile, PROFILE_CURVE), out);
	outcome = ifc_profile_faces(shaper, profile, &faces);
	for (size_t i = 0;
		!outcome && faces.rings.count && i <= faces.rings.at[0]; i++)
		outcome = ifc_point_add(
			shaper, out, faces.points.at[i % faces.rings.at[0]]);
	ifc_faces_release(&faces);
	return outcome;
}

/* The curve, without points that are the same, and its lengths. */
static enum ifc_outcome
swept_read(struct ifc_shaper *shaper, uint32_t surface,
	const struct ifc_matrix *at, struct ifc_surface *out)
{
	struct ifc_points *curve = &out->curve;
	double length = 0;
	size_t kept = 0;
	enum ifc_outcome outcome;

	outcome = profile_points(
		shaper, ifc_target(shaper->file, surface, SWEPT_CURVE), curve);
	if (outcome)
		return outcome;
	if (array_grow(&out->lengths, curve->count + 1))
		return IFC_NO_MEMORY;
	for (size_t i = 0; i < curve->count; i++) {
		struct tcs_point here = ifc_transform(at, curve->at[i]), step;

		step = point_minus(here, curve->at[kept ? kept - 1 : 0]);
		if (kept && ifc_same_point(shaper, here, curve->at[kept - 1]))
			continue;
		if (kept)
			length += sqrt(point_dot(step, step));
		curve->at[kept++] = here;
		out->lengths.at[out->lengths.count++] = length;
	}
	curve->count = kept;
	if (kept < 2 || !isfinite(length))
		return ifc_refuse(
			shaper, surface, "a swept curve has no length");
	return IFC_SHAPED;
}

/* The parameter `i` is the length of the curve. */
static void
curve_range(const struct ifc_shaper *shaper, struct ifc_surface *surface, int i)
{
	const struct ifc_points *curve = &surface->curve;

	surface->low[i] = 0;
	surface->high[i] = surface->lengths.at[curve->count - 1];
	surface->step[i] = surface->high[i] / (double)(curve->count - 1);
	if (curve->count > 3 &&
		ifc_same_point(
			shaper, curve->at[0], curve->at[curve->count - 1]))
		surface->period[i] = surface->high[i];
}

static enum ifc_outcome
extrusion_read(struct ifc_shaper *shaper, uint32_t surface,
	const struct ifc_matrix *at, struct ifc_surface *out)
{
	struct tcs_point along;
	enum ifc_outcome outcome = swept_read(shaper, surface, at, out);
	double length;

	if (outcome)
		return outcome;
	if (!ifc_triple(shaper->file,
		    ifc_target(shaper->file, surface, SWEPT_AXIS), &along))
		return ifc_refuse(
			shaper, surface, "an extrusion's direction is bad");
	along = point_minus(ifc_transform(at, along),
		(struct tcs_point){at->at[3], at->at[7], at->at[11]});
	length = sqrt(point_dot(along, along));
	if (!(length > 0))
		return ifc_refuse(
			shaper, surface, "an extrusion's direction is bad");
	out->along = (struct tcs_point){
		along.x / length, along.y / length, along.z / length};
	curve_range(shaper, out, 0);
	out->low[1] = -HUGE_VAL;
	out->high[1] = HUGE_VAL;
	return IFC_SHAPED;
}

static double
off_axis(const struct ifc_surface *surface, struct tcs_point point)
{
	const double *m = surface->at.at;
	struct tcs_point off = point_cross(
		(struct tcs_point){m[2], m[6], m[10]},
		point_minus(point, (struct tcs_point){m[3], m[7], m[11]}));

	return sqrt(point_dot(off, off));
}

static enum ifc_outcome
revolution_read(struct ifc_shaper *shaper, uint32_t surface,
	const struct ifc_matrix *at, struct ifc_surface *out)
{
	const struct ifc_points *curve = &out->curve;
	enum ifc_outcome outcome = swept_read(shaper, surface, at, out);
	struct ifc_matrix axis;
	double radius = 0;

	if (outcome)
		return outcome;
	if (!ifc_axes(shaper->file,
		    ifc_target(shaper->file, surface, SWEPT_AXIS), &axis))
		return ifc_refuse(shaper, surface, "a revolution has no axis");
	out->at = ifc_multiply(at, &axis);
	for (size_t i = 0; i < curve->count; i++)
		radius = fmax(radius, off_axis(out, curve->at[i]));
	if (!(radius > shaper->precision))
		return ifc_refuse(
			shaper, surface, "a revolution has no radius");
	out->high[0] = out->period[0] = 2 * PI;
	out->step[0] = angle_step(shaper, radius);
	curve_range(shaper, out, 1);
	out->pinched[1][0] = off_axis(out, curve->at[0]) <= shaper->precision;
	out->pinched[1][1] =
		off_axis(out, curve->at[curve->count - 1]) <= shaper->precision;
	return IFC_SHAPED;
}

/* ---- splines ------------------------------------------------------------- */

/* A grid of points, row after row, each of them a list. */
static enum ifc_outcome
grid_read(struct ifc_shaper *shaper, uint32_t surface, struct ifc_surface *out)
{
	struct step_value list = ifc_value(shaper->file, surface, POLES), row;
	enum ifc_outcome outcome = IFC_SHAPED;

	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &row) > STEP_END) {
		size_t before = out->poles.count;

		outcome = ifc_poles_read(shaper, surface, &row, &out->poles);
		if (!outcome && out->count[0]++ &&
			out->poles.count - before != out->count[1])
			outcome = ifc_refuse(shaper, surface,
				"a spline's rows are of different length");
		out->count[1] = out->poles.count - before;
	}
	if (!outcome && !out->count[0])
		return ifc_refuse(shaper, surface, "a spline has no points");
	return outcome;
}

static enum ifc_outcome
grid_weights(
	struct ifc_shaper *shaper, uint32_t surface, struct ifc_surface *out)
{
	struct step_value list = ifc_value(shaper->file, surface, WEIGHTS);
	enum ifc_outcome outcome = IFC_SHAPED;
	struct step_value row;

	for (size_t i = 0; i < out->count[0] && !outcome; i++) {
		if (list.kind != STEP_LIST ||
			step_next(&list.list, &row) <= STEP_END)
			return ifc_refuse(
				shaper, surface, "a spline's weights are bad");
		outcome = ifc_weights_read(shaper, surface, &row,
			out->poles.at + i * out->count[1], out->count[1]);
	}
	return outcome;
}

/*
 * Whether a spline closes in a direction, and whether its low and high ends are
 * points: as far as samples along those ends tell.
 */
static void
ends_find(const struct ifc_shaper *shaper, struct ifc_surface *surface, int i)
{
	size_t count = 2 * surface->count[1 - i];
	double low = surface->low[1 - i], range = surface->high[1 - i] - low;
	bool round = true, pinched[2] = {true, true};
	struct tcs_point first[2];

	for (size_t k = 0; k <= count; k++) {
		struct tcs_point here[2];
		struct ifc_uv uv;

		uv.at[1 - i] = low + range * (double)k / (double)count;
		for (int end = 0; end < 2; end++) {
			uv.at[i] = end ? surface->high[i] : surface->low[i];
			here[end] = ifc_surface_at(surface, uv);
			if (k == 0)
				first[end] = here[end];
			pinched[end] = pinched[end] &&
				ifc_same_point(shaper, first[end], here[end]);
		}
		round = round && ifc_same_point(shaper, here[0], here[1]);
	}
	surface->pinched[i][0] = pinched[0];
	surface->pinched[i][1] = pinched[1];
	if (round)
		surface->period[i] = surface->high[i] - surface->low[i];
}

static enum ifc_outcome
spline_read(
	struct ifc_shaper *shaper, uint32_t surface, struct ifc_surface *out)
{
	enum ifc_outcome outcome;

	outcome = ifc_degree_read(shaper, surface, U_DEGREE, out->degree);
	if (!outcome)
		outcome = ifc_degree_read(
			shaper, surface, V_DEGREE, out->degree + 1);
	if (!outcome)
		outcome = grid_read(shaper, surface, out);
	for (int i = 0; i < 2 && !outcome; i++)
		outcome = ifc_knots_read(shaper, surface, U_KNOTS + i,
			U_MULTIPLICITIES + i, out->degree[i], out->count[i],
			out->knots + i);
	if (!outcome &&
		ifc_entity_of(shaper->file, surface) ==
			IFC_RATIONALBSPLINESURFACEWITHKNOTS)
		outcome = grid_weights(shaper, surface, out);
	if (outcome)
		return outcome;
	for (int i = 0; i < 2; i++) {
		size_t spans = out->count[i] - out->degree[i];

		out->low[i] = out->knots[i].at[out->degree[i]];
		out->high[i] = out->knots[i].at[out->count[i]];
		out->step[i] = (out->high[i] - out->low[i]) / (double)spans;
	}
	for (int i = 0; i < 2; i++)
		ends_find(shaper, out, i);
	return IFC_SHAPED;
}

/* ---- all of them --------------------------------------------------------- */

static enum ifc_outcome
swept_surface(struct ifc_shaper *shaper, uint32_t surface, bool placed,
	struct ifc_surface *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value position = ifc_value(file, surface, SWEPT_POSITION);
	struct ifc_matrix at = ifc_identity;

	if (placed && position.kind == STEP_REFERENCE &&
		!ifc_axes(file, step_target(file->step, &position), &at))
		return ifc_refuse(shaper, surface, "a position is bad");
	return out->kind == IFC_SURFACE_EXTRUSION
		? extrusion_read(shaper, surface, &at, out)
		: revolution_read(shaper, surface, &at, out);
}

static bool
kind_of(enum ifc_entity entity, enum ifc_surface_kind *out)
{
	static const struct {
		enum ifc_entity entity;
		enum ifc_surface_kind kind;
	} kinds[] = {
		{IFC_PLANE, IFC_SURFACE_PLANE},
		{IFC_CYLINDRICALSURFACE, IFC_SURFACE_CYLINDER},
		{IFC_SPHERICALSURFACE, IFC_SURFACE_SPHERE},
		{IFC_TOROIDALSURFACE, IFC_SURFACE_TORUS},
		{IFC_SURFACEOFLINEAREXTRUSION, IFC_SURFACE_EXTRUSION},
		{IFC_SURFACEOFREVOLUTION, IFC_SURFACE_REVOLUTION},
		{IFC_BSPLINESURFACEWITHKNOTS, IFC_SURFACE_SPLINE},
		{IFC_RATIONALBSPLINESURFACEWITHKNOTS, IFC_SURFACE_SPLINE},
	};

	for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
		if (kinds[i].entity == entity) {
			*out = kinds[i].kind;
			return true;
		}
	return false;
}

enum ifc_outcome
ifc_surface_read(struct ifc_shaper *shaper, uint32_t surface, bool placed,
	struct ifc_surface *out)
{
	*out = (struct ifc_surface){
		.at = ifc_identity, .tolerance = shaper->deflection};
	if (!kind_of(ifc_entity_of(shaper->file, surface), &out->kind))
		return ifc_refuse(
			shaper, surface, "a surface of this kind is not known");
	switch (out->kind) {
	case IFC_SURFACE_EXTRUSION:
	case IFC_SURFACE_REVOLUTION:
		return swept_surface(shaper, surface, placed, out);
	case IFC_SURFACE_SPLINE:
		return spline_read(shaper, surface, out);
	default:
		return elementary_read(shaper, surface, out);
	}
}

void
ifc_surface_release(struct ifc_surface *surface)
{
	array_release(&surface->curve);
	array_release(&surface->lengths);
	array_release(&surface->poles);
	array_release(surface->knots);
	array_release(surface->knots + 1);
}

/* ---- evaluating ---------------------------------------------------------- */

/* The parameter within its range, round by the period. */
static double
brought_in(const struct ifc_surface *surface, int i, double parameter)
{
	double low = surface->low[i], period = surface->period[i];

	if (period > 0 && (parameter < low || parameter > surface->high[i]))
		parameter -= period * floor((parameter - low) / period);
	return fmin(fmax(parameter, low), surface->high[i]);
}

static struct tcs_point
curve_at(const struct ifc_surface *surface, double length)
{
	const struct ifc_points *curve = &surface->curve;
	const double *lengths = surface->lengths.at;
	size_t low = 0, high = curve->count - 1;
	struct tcs_point a, b;
	double part;

	while (high - low > 1) {
		size_t middle = low + (high - low) / 2;

		if (lengths[middle] <= length)
			low = middle;
		else
			high = middle;
	}
	a = curve->at[low];
	b = curve->at[high];
	part = (length - lengths[low]) / (lengths[high] - lengths[low]);
	return (struct tcs_point){a.x + part * (b.x - a.x),
		a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)};
}

/* A point turned about the z axis of the surface's matrix. */
static struct tcs_point
turned(const struct ifc_surface *surface, struct tcs_point point, double angle)
{
	const double *m = surface->at.at;
	struct tcs_point origin = {m[3], m[7], m[11]};
	struct tcs_point axis = {m[2], m[6], m[10]};
	struct tcs_point off = point_minus(point, origin), side;
	double high = point_dot(off, axis), c = cos(angle), s = sin(angle);

	off = point_minus(off,
		(struct tcs_point){
			high * axis.x, high * axis.y, high * axis.z});
	side = point_cross(axis, off);
	return (struct tcs_point){
		origin.x + high * axis.x + c * off.x + s * side.x,
		origin.y + high * axis.y + c * off.y + s * side.y,
		origin.z + high * axis.z + c * off.z + s * side.z};
}

static struct tcs_point
spline_at(const struct ifc_surface *surface, double u, double v)
{
	struct ifc_pole row[IFC_MOST_DEGREE + 1], pole;
	size_t span_u = ifc_knot_span(surface->knots, surface->degree[0], u);
	size_t span_v =
		ifc_knot_span(surface->knots + 1, surface->degree[1], v);
	size_t first = span_u - surface->degree[0];

	for (size_t i = 0; i <= surface->degree[0]; i++)
		row[i] = ifc_pole_at(surface->knots + 1, surface->degree[1],
			span_v, v,
			surface->poles.at + (first + i) * surface->count[1] +
				span_v - surface->degree[1]);
	pole = ifc_pole_at(surface->knots, surface->degree[0], span_u, u, row);
	return (struct tcs_point){
		pole.x / pole.w, pole.y / pole.w, pole.z / pole.w};
}

struct tcs_point
ifc_surface_at(const struct ifc_surface *surface, struct ifc_uv uv)
{
	double u = brought_in(surface, 0, uv.at[0]);
	double v = brought_in(surface, 1, uv.at[1]), r = surface->radius;
	struct tcs_point point;

	switch (surface->kind) {
	case IFC_SURFACE_PLANE:
		point = (struct tcs_point){u, v, 0};
		break;
	case IFC_SURFACE_CYLINDER:
		point = (struct tcs_point){r * cos(u), r * sin(u), v};
		break;
	case IFC_SURFACE_SPHERE:
		point = (struct tcs_point){
			r * cos(v) * cos(u), r * cos(v) * sin(u), r * sin(v)};
		break;
	case IFC_SURFACE_TORUS:
		r += surface->minor * cos(v);
		point = (struct tcs_point){
			r * cos(u), r * sin(u), surface->minor * sin(v)};
		break;
	case IFC_SURFACE_EXTRUSION:
		point = curve_at(surface, u);
		return (struct tcs_point){point.x + v * surface->along.x,
			point.y + v * surface->along.y,
			point.z + v * surface->along.z};
	case IFC_SURFACE_REVOLUTION:
		return turned(surface, curve_at(surface, v), u);
	default:
		return spline_at(surface, u, v);
	}
	return ifc_transform(&surface->at, point);
}

/* A small step of a parameter, inwards at the end of the range. */
static double
small_step(const struct ifc_surface *surface, int i, double parameter)
{
	double step = surface->step[i] > 0 ? surface->step[i] * 1e-4 : 1e-4;

	return surface->period[i] == 0 && parameter + step > surface->high[i]
		? -step
		: step;
}

struct tcs_point
ifc_surface_normal(const struct ifc_surface *surface, struct ifc_uv uv)
{
	struct tcs_point here = ifc_surface_at(surface, uv), side[2], normal;
	double length;

	for (int i = 0; i < 2; i++) {
		double step = small_step(surface, i, uv.at[i]);
		struct ifc_uv there = uv;

		there.at[i] += step;
		side[i] = point_minus(ifc_surface_at(surface, there), here);
		if (step < 0)
			side[i] = point_minus(
				(struct tcs_point){0, 0, 0}, side[i]);
	}
	normal = point_cross(side[0], side[1]);
	length = sqrt(point_dot(normal, normal));
	if (!(length > 0))
		return (struct tcs_point){0, 0, 0};
	return (struct tcs_point){
		normal.x / length, normal.y / length, normal.z / length};
}
