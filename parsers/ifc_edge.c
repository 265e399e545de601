#include "ifc_edge.h"

#include <math.h>

#include "ifc_curve.h"
#include "solid_points.h"

enum { EDGE_START, EDGE_END, EDGE_CURVE, EDGE_SENSE };

enum { ORIENTED_ELEMENT = 2, ORIENTED_SENSE = 3 };

static const double PI = 3.14159265358979323846;

/* Angles nearer than this, in radians, make a full turn rather than nothing. */
static const double SAME_ANGLE = 1e-9;

static bool
vertex_read(const struct ifc_file *file, uint32_t vertex, struct tcs_point *out)
{
	return ifc_entity_of(file, vertex) == IFC_VERTEXPOINT &&
		ifc_triple(file, ifc_target(file, vertex, 0), out);
}

static void
points_reverse(struct ifc_points *points, size_t first)
{
	for (size_t low = first, high = points->count; low + 1 < high; low++) {
		struct tcs_point swap = points->at[low];

		points->at[low] = points->at[--high];
		points->at[high] = swap;
	}
}

/* ---- along curves -------------------------------------------------------- */

/* On to the end of a closed curve, and from its start. */
static enum ifc_outcome
round_points(struct ifc_shaper *shaper, uint32_t curve, double from, double to,
	struct ifc_points *out)
{
	double low, high;
	enum ifc_outcome outcome;

	outcome = ifc_curve_range(shaper, curve, &low, &high);
	if (!outcome)
		outcome = ifc_curve_between(shaper, curve, from, high, out);
	if (!outcome)
		outcome = ifc_curve_between(shaper, curve, low, to, out);
	return outcome;
}

static enum ifc_outcome
is_closed(struct ifc_shaper *shaper, uint32_t curve, bool *out)
{
	struct ifc_points points = {.count = 0};
	enum ifc_outcome outcome = ifc_curve_points(shaper, curve, &points);

	*out = !outcome && points.count > 2 &&
		ifc_same_point(
			shaper, points.at[0], points.at[points.count - 1]);
	array_release(&points);
	return outcome;
}

/* Between the vertices' places on a spline, round by its end if it is closed. */
static enum ifc_outcome
spline_points(struct ifc_shaper *shaper, uint32_t curve, double from, double to,
	struct ifc_points *out)
{
	enum ifc_outcome outcome;
	bool closed;

	if (from < to)
		return ifc_curve_between(shaper, curve, from, to, out);
	outcome = is_closed(shaper, curve, &closed);
	if (outcome)
		return outcome;
	return closed ? round_points(shaper, curve, from, to, out)
		      : ifc_curve_between(shaper, curve, from, to, out);
}

/* Along the curve, between the places of the vertices. */
static enum ifc_outcome
located_points(struct ifc_shaper *shaper, uint32_t curve,
	struct tcs_point start, struct tcs_point end, struct ifc_points *out)
{
	enum ifc_entity kind = ifc_entity_of(shaper->file, curve);
	double from, to, turn = 2 * PI / shaper->angle;
	enum ifc_outcome outcome;

	outcome = ifc_curve_locate(shaper, curve, start, &from);
	if (!outcome)
		outcome = ifc_curve_locate(shaper, curve, end, &to);
	if (outcome)
		return outcome;
	if (kind != IFC_CIRCLE && kind != IFC_ELLIPSE)
		return spline_points(shaper, curve, from, to, out);
	if (to <= from + SAME_ANGLE / (2 * PI) * turn)
		to += turn;
	return ifc_curve_between(shaper, curve, from, to, out);
}

static double
square_between(struct tcs_point a, struct tcs_point b)
{
	struct tcs_point d = point_minus(a, b);

	return point_dot(d, d);
}

/* All of a bounded curve, which may run the other way. */
static enum ifc_outcome
bounded_points(struct ifc_shaper *shaper, uint32_t curve,
	struct tcs_point start, struct tcs_point end, struct ifc_points *out)
{
	size_t first = out->count;
	enum ifc_outcome outcome = ifc_curve_points(shaper, curve, out);

	if (outcome || out->count < first + 2)
		return outcome;
	if (square_between(out->at[first], start) +
			square_between(out->at[out->count - 1], end) >
		square_between(out->at[first], end) +
			square_between(out->at[out->count - 1], start))
		points_reverse(out, first);
	return IFC_SHAPED;
}

/* The way of the curve from one vertex to the other. */
static enum ifc_outcome
curve_points(struct ifc_shaper *shaper, uint32_t curve, struct tcs_point start,
	struct tcs_point end, struct ifc_points *out)
{
	const struct ifc_file *file = shaper->file;

	if (ifc_is_kind(file, curve, IFC_SURFACECURVE))
		curve = ifc_target(file, curve, 0);
	switch (ifc_entity_of(file, curve)) {
	case IFC_LINE:
		return IFC_SHAPED;
	case IFC_CIRCLE:
	case IFC_ELLIPSE:
	case IFC_BEZIERCURVE:
	case IFC_RATIONALBEZIERCURVE:
	case IFC_BSPLINECURVEWITHKNOTS:
	case IFC_RATIONALBSPLINECURVEWITHKNOTS:
		return located_points(shaper, curve, start, end, out);
	default:
		return bounded_points(shaper, curve, start, end, out);
	}
}

/* ---- edges --------------------------------------------------------------- */

/* Take out, between the vertices, points that are the same as others. */
static void
edge_tidy(const struct ifc_shaper *shaper, struct ifc_points *points,
	size_t first)
{
	struct tcs_point end = points->at[points->count - 1];
	size_t kept = first + 1;

	for (size_t i = first + 1; i + 1 < points->count; i++)
		if (!ifc_same_point(
			    shaper, points->at[kept - 1], points->at[i]) &&
			!ifc_same_point(shaper, points->at[i], end))
			points->at[kept++] = points->at[i];
	points->at[kept++] = end;
	points->count = kept;
}

static enum ifc_outcome
edge_points(struct ifc_shaper *shaper, uint32_t edge, struct ifc_points *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value sense = ifc_value(file, edge, EDGE_SENSE);
	bool backwards = step_is(&sense, "F");
	enum ifc_outcome outcome = IFC_SHAPED;
	struct tcs_point start, end;
	size_t first = out->count;

	if (!vertex_read(file, ifc_target(file, edge, EDGE_START), &start) ||
		!vertex_read(file, ifc_target(file, edge, EDGE_END), &end))
		return ifc_refuse(shaper, edge, "an edge lacks a vertex");
	if (ifc_is_kind(file, edge, IFC_EDGECURVE))
		outcome = curve_points(shaper,
			ifc_target(file, edge, EDGE_CURVE),
			backwards ? end : start, backwards ? start : end, out);
	if (!outcome && out->count < first + 2) {
		out->count = first;
		outcome = ifc_points_room(shaper, out, 2);
		out->count += outcome ? 0 : 2;
	} else if (!outcome && backwards) {
		points_reverse(out, first);
	}
	if (outcome)
		return outcome;
	out->at[first] = start;
	out->at[out->count - 1] = end;
	edge_tidy(shaper, out, first);
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_edge_points(
	struct ifc_shaper *shaper, uint32_t edge, struct ifc_points *out)
{
	const struct ifc_file *file = shaper->file;
	size_t first = out->count;
	enum ifc_outcome outcome;
	struct step_value sense;

	if (!ifc_is_kind(file, edge, IFC_EDGE))
		return ifc_refuse(shaper, edge, "not an edge");
	if (ifc_entity_of(file, edge) != IFC_ORIENTEDEDGE)
		return edge_points(shaper, edge, out);
	sense = ifc_value(file, edge, ORIENTED_SENSE);
	edge = ifc_target(file, edge, ORIENTED_ELEMENT);
	if (!ifc_is_kind(file, edge, IFC_EDGE) ||
		ifc_entity_of(file, edge) == IFC_ORIENTEDEDGE)
		return ifc_refuse(shaper, edge, "not an edge");
	outcome = edge_points(shaper, edge, out);
	if (!outcome && step_is(&sense, "F"))
		points_reverse(out, first);
	return outcome;
}

/* ---- loops --------------------------------------------------------------- */

static bool
is_same(struct tcs_point a, struct tcs_point b)
{
	return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void
ring_tidy(struct ifc_points *points, size_t first)
{
	size_t kept = first;

	for (size_t i = first; i < points->count; i++)
		if (kept == first ||
			!is_same(points->at[kept - 1], points->at[i]))
			points->at[kept++] = points->at[i];
	while (kept > first + 1 &&
		is_same(points->at[kept - 1], points->at[first]))
		kept--;
	points->count = kept;
}

static enum ifc_outcome
polygon_point(struct ifc_shaper *shaper, uint32_t loop, uint32_t instance,
	struct ifc_points *out)
{
	struct tcs_point point;

	if (!ifc_triple(shaper->file, instance, &point))
		return ifc_refuse(shaper, loop, "a point is missing or bad");
	return ifc_point_add(shaper, out, point);
}

enum ifc_outcome
ifc_loop_points(
	struct ifc_shaper *shaper, uint32_t loop, struct ifc_points *out)
{
	const struct ifc_file *file = shaper->file;
	enum ifc_entity entity = ifc_entity_of(file, loop);
	struct step_value list = ifc_value(file, loop, 0), item;
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t first = out->count;

	if (entity == IFC_VERTEXLOOP)
		return IFC_SHAPED;
	if ((entity != IFC_EDGELOOP && entity != IFC_POLYLOOP) ||
		list.kind != STEP_LIST)
		return ifc_refuse(shaper, loop, "not a loop");
	while (!outcome && step_next(&list.list, &item) > STEP_END) {
		uint32_t part = step_target(file->step, &item);

		outcome = entity == IFC_EDGELOOP
			? ifc_edge_points(shaper, part, out)
			: polygon_point(shaper, loop, part, out);
	}
	if (!outcome)
		ring_tidy(out, first);
	return outcome;
}
