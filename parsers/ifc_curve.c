#include "ifc_curve.h"

#include <math.h>
#include <string.h>

#include "ifc_alignment.h"
#include "ifc_offset.h"
#include "ifc_point_list.h"
#include "ifc_spline.h"

enum { LINE_POINT, LINE_VECTOR };

enum { VECTOR_DIRECTION, VECTOR_LENGTH };

enum { SEGMENT_SENSE = 1, SEGMENT_CURVE = 2 };

enum { TRIM_BASIS = 0 };

static const double PI = 3.14159265358979323846;

static void
points_reverse(struct ifc_points *points, size_t first)
{
	for (size_t low = first, high = points->count; low + 1 < high; low++) {
		struct tcs_point swap = points->at[low];

		points->at[low] = points->at[--high];
		points->at[high] = swap;
	}
}

static struct tcs_point
between(struct tcs_point a, struct tcs_point b, double part)
{
	return (struct tcs_point){a.x + (b.x - a.x) * part,
		a.y + (b.y - a.y) * part, a.z + (b.z - a.z) * part};
}

/* Take out the point at `base` when it is the one before it. */
static void
joint_close(
	const struct ifc_shaper *shaper, struct ifc_points *out, size_t base)
{
	if (out->count <= base ||
		!ifc_same_point(shaper, out->at[base - 1], out->at[base]))
		return;
	out->count--;
	memmove(out->at + base, out->at + base + 1,
		(out->count - base) * sizeof *out->at);
}

/* ---- polylines ----------------------------------------------------------- */

static enum ifc_outcome
polyline_points(
	struct ifc_shaper *shaper, uint32_t polyline, struct ifc_points *out)
{
	struct step_value list = ifc_value(shaper->file, polyline, 0), item;
	enum ifc_outcome outcome = IFC_SHAPED;

	if (list.kind != STEP_LIST)
		return ifc_refuse(shaper, polyline, "a polyline has no points");
	while (!outcome && step_next(&list.list, &item) > STEP_END) {
		struct tcs_point point;

		if (!ifc_triple(shaper->file,
			    step_target(shaper->file->step, &item), &point))
			return ifc_refuse(
				shaper, polyline, "a point is missing or bad");
		outcome = ifc_point_add(shaper, out, point);
	}
	return outcome;
}

/*
 * Keep of the points from `first` on what lies between two positions, the
 * n-th point being n.
 */
static enum ifc_outcome
points_cut(struct ifc_shaper *shaper, struct ifc_points *out, size_t first,
	double from, double to)
{
	struct tcs_point *points, begin, end;
	size_t last, low, high;

	if (out->count < first + 2)
		return ifc_refuse(shaper, STEP_NONE, "a curve has no length");
	points = out->at + first;
	last = out->count - first - 1;
	from = fmin(fmax(from, 0), (double)last);
	to = fmin(fmax(to, from), (double)last);
	low = from >= (double)last ? last - 1 : (size_t)from;
	high = (size_t)ceil(to);
	if (high <= low)
		high = low + 1;
	begin = between(points[low], points[low + 1], from - (double)low);
	end = between(points[high - 1], points[high], to - (double)(high - 1));
	points[low] = begin;
	points[high] = end;
	memmove(points, points + low, (high - low + 1) * sizeof *points);
	out->count = first + high - low + 1;
	return IFC_SHAPED;
}

/* ---- indexed curves ------------------------------------------------------ */

/* The indices of one segment, from 0; false for any that is none. */
static bool
indices_read(struct step_value *segment, size_t count, size_t *out, size_t room,
	size_t *got)
{
	struct step_value value;
	int64_t index;

	*got = 0;
	while (*got < room && step_next(&segment->list, &value) > STEP_END) {
		if (!step_integer(&value, &index) || index < 1 ||
			(uint64_t)index > count)
			return false;
		out[(*got)++] = (size_t)index - 1;
	}
	return segment->list.state != STEP_BROKEN;
}

static enum ifc_outcome
line_segment(struct ifc_shaper *shaper, uint32_t curve,
	const struct ifc_points *points, struct step_value *indices,
	struct ifc_points *out)
{
	size_t index, got;

	for (;;) {
		enum ifc_outcome outcome;

		if (!indices_read(indices, points->count, &index, 1, &got))
			return ifc_refuse(shaper, curve, "an index is bad");
		if (!got)
			return IFC_SHAPED;
		outcome = ifc_point_add(shaper, out, points->at[index]);
		if (outcome)
			return outcome;
	}
}

static enum ifc_outcome
indexed_segment(struct ifc_shaper *shaper, uint32_t curve,
	const struct ifc_points *points, const struct step_value *segment,
	struct ifc_points *out)
{
	struct step_value indices = step_untyped(segment);
	size_t at[4], got;

	if (segment->kind != STEP_TYPED || indices.kind != STEP_LIST)
		return ifc_refuse(shaper, curve, "a segment is bad");
	if (step_is(segment, "IFCLINEINDEX"))
		return line_segment(shaper, curve, points, &indices, out);
	if (!step_is(segment, "IFCARCINDEX") ||
		!indices_read(&indices, points->count, at, 4, &got) || got != 3)
		return ifc_refuse(shaper, curve, "an arc is bad");
	return ifc_arc_through(shaper, points->at[at[0]], points->at[at[1]],
		points->at[at[2]], out);
}

static enum ifc_outcome
indexed_points(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_points *out)
{
	struct step_value segments = ifc_value(shaper->file, curve, 1), segment;
	uint32_t list = ifc_target(shaper->file, curve, 0);
	struct ifc_points points = {.count = 0};
	size_t first = out->count;
	enum ifc_outcome outcome;

	if (segments.kind != STEP_LIST)
		return ifc_point_list_read(shaper, list, out);
	outcome = ifc_point_list_read(shaper, list, &points);
	while (!outcome && step_next(&segments.list, &segment) > STEP_END) {
		size_t base = out->count;

		outcome =
			indexed_segment(shaper, curve, &points, &segment, out);
		if (!outcome && base > first)
			joint_close(shaper, out, base);
	}
	array_release(&points);
	return outcome;
}

/* ---- composite curves ---------------------------------------------------- */

/* One segment, between parameters that count from its own start. */
static enum ifc_outcome
segment_between(struct ifc_shaper *shaper, uint32_t segment, double from,
	double to, struct ifc_points *out)
{
	uint32_t parent = ifc_target(shaper->file, segment, SEGMENT_CURVE);
	struct step_value sense =
		ifc_value(shaper->file, segment, SEGMENT_SENSE);
	enum ifc_outcome outcome;
	double low, high;

	outcome = ifc_curve_range(shaper, parent, &low, &high);
	if (outcome)
		return outcome;
	if (from <= 0 && to >= high - low) {
		size_t base = out->count;

		outcome = ifc_curve_points(shaper, parent, out);
		if (!outcome && step_is(&sense, "F"))
			points_reverse(out, base);
		return outcome;
	}
	if (step_is(&sense, "F"))
		return ifc_curve_between(
			shaper, parent, high - from, high - to, out);
	return ifc_curve_between(shaper, parent, low + from, low + to, out);
}

static enum ifc_outcome
segment_range(struct ifc_shaper *shaper, uint32_t segment, double *length)
{
	uint32_t parent = ifc_target(shaper->file, segment, SEGMENT_CURVE);
	enum ifc_outcome outcome;
	double low, high;

	*length = 0;
	if (!ifc_is_kind(shaper->file, segment, IFC_COMPOSITECURVESEGMENT))
		return ifc_refuse(
			shaper, segment, "a segment of this kind is not known");
	outcome = ifc_curve_range(shaper, parent, &low, &high);
	*length = high - low;
	return outcome;
}

/* The segments, each a step of its own range; `out` NULL only adds those up. */
static enum ifc_outcome
composite_walk(struct ifc_shaper *shaper, uint32_t curve, double from,
	double to, struct ifc_points *out, double *range)
{
	struct step_value list = ifc_value(shaper->file, curve, 0), item;
	size_t first = out ? out->count : 0;
	enum ifc_outcome outcome = IFC_SHAPED;

	*range = 0;
	if (list.kind != STEP_LIST)
		return ifc_refuse(shaper, curve, "a curve has no segments");
	while (!outcome && step_next(&list.list, &item) > STEP_END) {
		uint32_t segment = step_target(shaper->file->step, &item);
		size_t base = out ? out->count : 0;
		double length, begin = *range;

		outcome = segment_range(shaper, segment, &length);
		*range += length;
		if (outcome || !out || *range <= from || begin >= to)
			continue;
		outcome = segment_between(
			shaper, segment, from - begin, to - begin, out);
		if (!outcome && base > first)
			joint_close(shaper, out, base);
	}
	return outcome;
}

/* ---- all of them --------------------------------------------------------- */

static enum ifc_outcome
conic_between(struct ifc_shaper *shaper, uint32_t conic, double from, double to,
	struct ifc_points *out)
{
	struct ifc_conic read;
	enum ifc_outcome outcome = ifc_conic_read(shaper, conic, &read);

	return outcome ? outcome
		       : ifc_arc_points(shaper, &read, from * shaper->angle,
				 to * shaper->angle, out);
}

static enum ifc_outcome
line_between(struct ifc_shaper *shaper, uint32_t line, double from, double to,
	struct ifc_points *out)
{
	struct tcs_point point, along;
	enum ifc_outcome outcome;

	if (!ifc_line_read(shaper->file, line, &point, &along))
		return ifc_refuse(shaper, line, "a line is bad");
	outcome = ifc_point_add(shaper, out,
		(struct tcs_point){point.x + from * along.x,
			point.y + from * along.y, point.z + from * along.z});
	return outcome ? outcome
		       : ifc_point_add(shaper, out,
				 (struct tcs_point){point.x + to * along.x,
					 point.y + to * along.y,
					 point.z + to * along.z});
}

bool
ifc_line_read(const struct ifc_file *file, uint32_t line,
	struct tcs_point *point, struct tcs_point *along)
{
	uint32_t vector = ifc_target(file, line, LINE_VECTOR);
	struct step_value value = ifc_value(file, vector, VECTOR_LENGTH);
	double length, factor;

	if (ifc_entity_of(file, vector) != IFC_VECTOR ||
		!step_number(&value, &factor) ||
		!ifc_triple(file, ifc_target(file, line, LINE_POINT), point) ||
		!ifc_triple(file, ifc_target(file, vector, VECTOR_DIRECTION),
			along))
		return false;
	length = sqrt(along->x * along->x + along->y * along->y +
		along->z * along->z);
	if (!(length > 0) || !isfinite(factor / length))
		return false;
	factor /= length;
	*along = (struct tcs_point){
		along->x * factor, along->y * factor, along->z * factor};
	return true;
}

/* The range of a curve whose instance was entered. */
static enum ifc_outcome
range_inside(
	struct ifc_shaper *shaper, uint32_t curve, double *from, double *to)
{
	enum ifc_outcome outcome;
	struct ifc_points points = {.count = 0};

	switch (ifc_entity_of(shaper->file, curve)) {
	case IFC_LINE:
		return IFC_SHAPED;
	case IFC_CIRCLE:
	case IFC_ELLIPSE:
		*to = 2 * PI / shaper->angle;
		return IFC_SHAPED;
	case IFC_TRIMMEDCURVE:
		outcome = ifc_trim_range(shaper, curve, from, to);
		*to = fabs(*to - *from);
		*from = 0;
		return outcome;
	case IFC_POLYLINE:
	case IFC_INDEXEDPOLYCURVE:
		outcome = ifc_curve_points(shaper, curve, &points);
		*to = points.count ? (double)(points.count - 1) : 0;
		array_release(&points);
		return outcome;
	case IFC_COMPOSITECURVE:
	case IFC_COMPOSITECURVEONSURFACE:
	case IFC_BOUNDARYCURVE:
	case IFC_OUTERBOUNDARYCURVE:
		return composite_walk(
			shaper, curve, -HUGE_VAL, HUGE_VAL, NULL, to);
	case IFC_BEZIERCURVE:
	case IFC_RATIONALBEZIERCURVE:
	case IFC_BSPLINECURVEWITHKNOTS:
	case IFC_RATIONALBSPLINECURVEWITHKNOTS:
		return ifc_spline_range(shaper, curve, from, to);
	case IFC_OFFSETCURVE2D:
	case IFC_OFFSETCURVE3D:
		return ifc_curve_range(
			shaper, ifc_target(shaper->file, curve, 0), from, to);
	case IFC_SURFACECURVE:
	case IFC_INTERSECTIONCURVE:
	case IFC_SEAMCURVE:
		return ifc_curve_range(
			shaper, ifc_target(shaper->file, curve, 0), from, to);
	default:
		return ifc_refuse(
			shaper, curve, "a curve of this kind is not known");
	}
}

enum ifc_outcome
ifc_curve_range(
	struct ifc_shaper *shaper, uint32_t curve, double *from, double *to)
{
	enum ifc_outcome outcome = ifc_enter(shaper, curve);

	*from = *to = 0;
	if (outcome)
		return outcome;
	outcome = range_inside(shaper, curve, from, to);
	ifc_leave(shaper);
	return outcome;
}

static enum ifc_outcome
trimmed_between(struct ifc_shaper *shaper, uint32_t curve, double from,
	double to, struct ifc_points *out)
{
	double begin, end, direction;
	enum ifc_outcome outcome = ifc_trim_range(shaper, curve, &begin, &end);

	if (outcome)
		return outcome;
	direction = end < begin ? -1 : 1;
	from = fmin(fmax(from, 0), fabs(end - begin));
	to = fmin(fmax(to, 0), fabs(end - begin));
	return ifc_curve_between(shaper,
		ifc_target(shaper->file, curve, TRIM_BASIS),
		begin + direction * from, begin + direction * to, out);
}

/* Forwards, of a curve whose instance was entered. */
static enum ifc_outcome
between_inside(struct ifc_shaper *shaper, uint32_t curve, double from,
	double to, struct ifc_points *out)
{
	size_t first = out->count;
	enum ifc_outcome outcome;
	double range;

	switch (ifc_entity_of(shaper->file, curve)) {
	case IFC_LINE:
		return line_between(shaper, curve, from, to, out);
	case IFC_CIRCLE:
	case IFC_ELLIPSE:
		return conic_between(shaper, curve, from, to, out);
	case IFC_TRIMMEDCURVE:
		return trimmed_between(shaper, curve, from, to, out);
	case IFC_POLYLINE:
	case IFC_INDEXEDPOLYCURVE:
		outcome = ifc_curve_points(shaper, curve, out);
		return outcome ? outcome
			       : points_cut(shaper, out, first, from, to);
	case IFC_COMPOSITECURVE:
	case IFC_COMPOSITECURVEONSURFACE:
	case IFC_BOUNDARYCURVE:
	case IFC_OUTERBOUNDARYCURVE:
		return composite_walk(shaper, curve, from, to, out, &range);
	case IFC_BEZIERCURVE:
	case IFC_RATIONALBEZIERCURVE:
	case IFC_BSPLINECURVEWITHKNOTS:
	case IFC_RATIONALBSPLINECURVEWITHKNOTS:
		return ifc_spline_between(shaper, curve, from, to, out);
	case IFC_OFFSETCURVE2D:
	case IFC_OFFSETCURVE3D:
		return ifc_offset_between(shaper, curve, from, to, out);
	case IFC_SURFACECURVE:
	case IFC_INTERSECTIONCURVE:
	case IFC_SEAMCURVE:
		return ifc_curve_between(shaper,
			ifc_target(shaper->file, curve, 0), from, to, out);
	default:
		return ifc_refuse(
			shaper, curve, "a curve of this kind is not known");
	}
}

enum ifc_outcome
ifc_curve_between(struct ifc_shaper *shaper, uint32_t curve, double from,
	double to, struct ifc_points *out)
{
	size_t first = out->count;
	enum ifc_outcome outcome = ifc_enter(shaper, curve);

	if (outcome)
		return outcome;
	outcome = between_inside(
		shaper, curve, fmin(from, to), fmax(from, to), out);
	ifc_leave(shaper);
	if (!outcome && from > to)
		points_reverse(out, first);
	return outcome;
}

static enum ifc_outcome
offset_points(struct ifc_shaper *shaper, uint32_t curve, struct ifc_points *out)
{
	enum ifc_outcome outcome;
	double from, to;

	outcome = ifc_curve_range(
		shaper, ifc_target(shaper->file, curve, 0), &from, &to);
	return outcome ? outcome
		       : ifc_offset_between(shaper, curve, from, to, out);
}

/* All of a curve whose instance was entered. */
static enum ifc_outcome
points_inside(struct ifc_shaper *shaper, uint32_t curve, struct ifc_points *out)
{
	double range;

	if (ifc_is_alignment(shaper->file, curve))
		return ifc_alignment_points(shaper, curve, out);
	switch (ifc_entity_of(shaper->file, curve)) {
	case IFC_POLYLINE:
		return polyline_points(shaper, curve, out);
	case IFC_INDEXEDPOLYCURVE:
		return indexed_points(shaper, curve, out);
	case IFC_CIRCLE:
	case IFC_ELLIPSE:
		return conic_between(
			shaper, curve, 0, 2 * PI / shaper->angle, out);
	case IFC_TRIMMEDCURVE:
		return trimmed_between(shaper, curve, 0, HUGE_VAL, out);
	case IFC_COMPOSITECURVE:
	case IFC_COMPOSITECURVEONSURFACE:
	case IFC_BOUNDARYCURVE:
	case IFC_OUTERBOUNDARYCURVE:
		return composite_walk(
			shaper, curve, -HUGE_VAL, HUGE_VAL, out, &range);
	case IFC_LINE:
		return ifc_refuse(shaper, curve, "a line has no ends");
	case IFC_BEZIERCURVE:
	case IFC_RATIONALBEZIERCURVE:
	case IFC_BSPLINECURVEWITHKNOTS:
	case IFC_RATIONALBSPLINECURVEWITHKNOTS:
		return ifc_spline_between(
			shaper, curve, -HUGE_VAL, HUGE_VAL, out);
	case IFC_OFFSETCURVE2D:
	case IFC_OFFSETCURVE3D:
		return offset_points(shaper, curve, out);
	case IFC_SURFACECURVE:
	case IFC_INTERSECTIONCURVE:
	case IFC_SEAMCURVE:
		return ifc_curve_points(
			shaper, ifc_target(shaper->file, curve, 0), out);
	default:
		return ifc_refuse(
			shaper, curve, "a curve of this kind is not known");
	}
}

enum ifc_outcome
ifc_curve_points(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_points *out)
{
	enum ifc_outcome outcome = ifc_enter(shaper, curve);

	if (outcome)
		return outcome;
	outcome = points_inside(shaper, curve, out);
	ifc_leave(shaper);
	return outcome;
}

enum ifc_outcome
ifc_curve_ring(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_points *out)
{
	size_t first = out->count, kept = first;
	enum ifc_outcome outcome = ifc_curve_points(shaper, curve, out);

	if (outcome)
		return outcome;
	for (size_t i = first; i < out->count; i++)
		if (kept == first ||
			!ifc_same_point(shaper, out->at[kept - 1], out->at[i]))
			out->at[kept++] = out->at[i];
	while (kept > first + 1 &&
		ifc_same_point(shaper, out->at[kept - 1], out->at[first]))
		kept--;
	out->count = kept;
	return IFC_SHAPED;
}
