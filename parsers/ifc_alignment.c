#include "ifc_alignment.h"

#include <math.h>

#include "ifc_curve.h"

enum { SEGMENTS, BASE_CURVE = 2, END_POINT };

enum { HORIZONTAL, VERTICAL_RISE, PLAN_SEGMENTS = 1 };

enum { OFFSET_BASIS, OFFSET_VALUES };

enum { SEGMENT_PLACEMENT = 1 };

enum { DISTANCE, LATERAL, VERTICAL };

/* ---- between marks ------------------------------------------------------- */

static double
cubic(double a, double slope_a, double b, double slope_b, double span,
	double part)
{
	double rest = 1 - part;

	return a * rest * rest * (1 + 2 * part) +
		b * part * part * (1 + 2 * rest) +
		span * part * rest * (slope_a * rest - slope_b * part);
}

/* The derivative of the same, by the distance. */
static double
cubic_slope(double a, double slope_a, double b, double slope_b, double span,
	double part)
{
	double rest = 1 - part;

	return 6 * part * rest * (b - a) / span +
		slope_a * rest * (1 - 3 * part) +
		slope_b * part * (3 * part - 2);
}

static struct ifc_mark
between(const struct ifc_mark *a, const struct ifc_mark *b, double along)
{
	double span = b->along - a->along, part = (along - a->along) / span;
	struct ifc_mark out = {.along = along,
		.at = {cubic(a->at.x, a->x, b->at.x, b->x, span, part),
			cubic(a->at.y, a->y, b->at.y, b->y, span, part),
			cubic(a->at.z, a->slope, b->at.z, b->slope, span,
				part)},
		.x = cubic_slope(a->at.x, a->x, b->at.x, b->x, span, part),
		.y = cubic_slope(a->at.y, a->y, b->at.y, b->y, span, part),
		.slope = cubic_slope(
			a->at.z, a->slope, b->at.z, b->slope, span, part),
		.roll = a->roll + part * (b->roll - a->roll)};

	return out;
}

static struct ifc_mark
straight_on(const struct ifc_mark *mark, double along)
{
	struct ifc_mark out = *mark;
	double by = along - mark->along;

	out.along = along;
	out.at.x += by * mark->x;
	out.at.y += by * mark->y;
	out.at.z += by * mark->slope;
	return out;
}

/*
 * The last mark at or before a distance, or with `before` only before it; the
 * first one where there is none.
 */
static size_t
mark_find(const struct ifc_alignment *alignment, double along, bool before)
{
	size_t low = 0, high = alignment->count;

	while (high - low > 1) {
		size_t middle = low + (high - low) / 2;
		double here = alignment->at[middle].along;

		if (before ? here < along : here <= along)
			low = middle;
		else
			high = middle;
	}
	return low;
}

/* At a corner, what lies behind it, or with `before` what lies before it. */
static struct ifc_mark
mark_at(const struct ifc_alignment *alignment, double along, bool before)
{
	size_t i = mark_find(alignment, along, before);
	const struct ifc_mark *a = alignment->at + i;

	if (along < a->along || i + 1 == alignment->count ||
		!(a[1].along > a->along))
		return straight_on(a, along);
	return between(a, a + 1, along);
}

struct ifc_mark
ifc_alignment_at(const struct ifc_alignment *alignment, double along)
{
	return mark_at(alignment, along, false);
}

/* ---- in plan ------------------------------------------------------------- */

static enum ifc_outcome
mark_add(struct ifc_alignment *out, struct ifc_mark mark)
{
	if (array_grow(out, 1))
		return IFC_NO_MEMORY;
	out->at[out->count++] = mark;
	return IFC_SHAPED;
}

/* Two marks with a straight line between them. */
static enum ifc_outcome
chord_add(struct ifc_mark a, struct ifc_mark b, struct ifc_alignment *out)
{
	double span = b.along - a.along;
	enum ifc_outcome outcome;

	a.x = b.x = (b.at.x - a.at.x) / span;
	a.y = b.y = (b.at.y - a.at.y) / span;
	a.slope = b.slope = (b.at.z - a.at.z) / span;
	outcome = mark_add(out, a);
	return outcome ? outcome : mark_add(out, b);
}

/* Any other curve: two marks for each chord. */
static enum ifc_outcome
chords_read(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	struct ifc_points points = {.count = 0};
	enum ifc_outcome outcome = ifc_curve_points(shaper, curve, &points);
	double along = 0;

	for (size_t i = 0; i + 1 < points.count && !outcome; i++) {
		struct ifc_mark a = {.along = along, .at = points.at[i]}, b = a;

		b.at = points.at[i + 1];
		b.along = along += hypot(b.at.x - a.at.x, b.at.y - a.at.y);
		if (b.along > a.along)
			outcome = chord_add(a, b, out);
	}
	array_release(&points);
	return outcome;
}

/* Segments placed one by one, each in the plane. */
static enum ifc_outcome
segments_read(struct ifc_shaper *shaper, uint32_t curve, int position,
	struct ifc_alignment *out)
{
	struct step_value list = ifc_value(shaper->file, curve, position), item;
	enum ifc_outcome outcome = IFC_SHAPED;

	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END)
		outcome = ifc_piece_marks(shaper,
			step_target(shaper->file->step, &item),
			out->count ? out->at[out->count - 1].along : 0, out);
	return outcome;
}

/* ---- in elevation -------------------------------------------------------- */

/*
 * In the plane of elevation x is the distance, and y the height. A segment
 * begins where the one before it ends, which may not be told to the last digit.
 */
static void
marks_rise(const struct ifc_shaper *shaper, struct ifc_alignment *marks)
{
	for (size_t i = 0; i < marks->count; i++) {
		struct ifc_mark *mark = marks->at + i;

		if (i && mark->at.x < mark[-1].along + shaper->precision)
			mark->at.x = mark[-1].along;
		*mark = (struct ifc_mark){.along = mark->at.x,
			.at = {0, 0, mark->at.y},
			.slope = mark->x > 0 ? mark->y / mark->x : 0};
	}
}

/* The marks of both between the same distances, those of the base moved up. */
static enum ifc_outcome
alignments_merge(const struct ifc_alignment *base,
	const struct ifc_alignment *height, struct ifc_alignment *out)
{
	double at = base->at[0].along, last = base->at[base->count - 1].along;
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t i = 0, k = 0;

	while (at < last && !outcome) {
		double next = last;

		while (i < base->count && base->at[i].along <= at)
			i++;
		while (k < height->count && height->at[k].along <= at)
			k++;
		if (i < base->count)
			next = fmin(next, base->at[i].along);
		if (k < height->count)
			next = fmin(next, height->at[k].along);
		for (int end = 0; end < 2 && !outcome; end++) {
			double here = end ? next : at;
			struct ifc_mark mark = mark_at(base, here, end);
			struct ifc_mark up = mark_at(height, here, end);

			mark.at.z += up.at.z;
			mark.slope += up.slope;
			mark.roll += up.roll;
			outcome = mark_add(out, mark);
		}
		at = next;
	}
	return outcome;
}

/* Heights and rolls where segments with cant begin. */
static enum ifc_outcome
cant_read(struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value list = ifc_value(file, curve, SEGMENTS), item;
	enum ifc_outcome outcome = IFC_SHAPED;
	struct ifc_matrix at;

	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t segment = step_target(file->step, &item);
		struct ifc_mark *last =
			out->count ? out->at + out->count - 1 : NULL;

		if (!ifc_axes(file,
			    ifc_target(file, segment, SEGMENT_PLACEMENT), &at))
			return ifc_refuse(shaper, segment, "a segment is bad");
		if (last && at.at[3] > last->along)
			last->slope = (at.at[7] - last->at.z) /
				(at.at[3] - last->along);
		outcome = mark_add(out,
			(struct ifc_mark){.along = at.at[3],
				.at = {0, 0, at.at[7]},
				.roll = atan2(at.at[6], at.at[10])});
		if (!outcome && out->count > 1)
			out->at[out->count - 1].slope =
				out->at[out->count - 2].slope;
	}
	return outcome;
}

static enum ifc_outcome
raised_read(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	struct ifc_alignment base = {.count = 0}, height = {.count = 0};
	enum ifc_outcome outcome = ifc_alignment_read(
		shaper, ifc_target(shaper->file, curve, BASE_CURVE), &base);

	if (!outcome &&
		ifc_entity_of(shaper->file, curve) == IFC_GRADIENTCURVE) {
		outcome = segments_read(shaper, curve, SEGMENTS, &height);
		marks_rise(shaper, &height);
	} else if (!outcome) {
		outcome = cant_read(shaper, curve, &height);
	}
	if (!outcome && !height.count)
		outcome = ifc_refuse(shaper, curve, "a curve has no segments");
	if (!outcome)
		outcome = alignments_merge(&base, &height, out);
	array_release(&base);
	array_release(&height);
	return outcome;
}

/* An IfcAlignmentCurve: segments in plan, and where there are, in elevation. */
static enum ifc_outcome
aligned_read(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	uint32_t plan = ifc_target(shaper->file, curve, HORIZONTAL);
	uint32_t rise = ifc_target(shaper->file, curve, VERTICAL_RISE);
	struct ifc_alignment base = {.count = 0}, height = {.count = 0};
	enum ifc_outcome outcome;

	if (rise == STEP_NONE)
		return segments_read(shaper, plan, PLAN_SEGMENTS, out);
	outcome = segments_read(shaper, plan, PLAN_SEGMENTS, &base);
	if (!outcome)
		outcome = ifc_rise_marks(shaper, rise, &height);
	if (!outcome && (!base.count || !height.count))
		outcome = ifc_refuse(shaper, curve, "a curve has no segments");
	if (!outcome)
		outcome = alignments_merge(&base, &height, out);
	array_release(&base);
	array_release(&height);
	return outcome;
}

/* ---- with offsets -------------------------------------------------------- */

/* The offsets of a list, as an alignment whose y is lateral and z vertical. */
static enum ifc_outcome
offsets_read(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value list = ifc_value(file, curve, OFFSET_VALUES), item;
	enum ifc_outcome outcome = IFC_SHAPED;

	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t point = step_target(file->step, &item);
		struct step_value along = ifc_value(file, point, DISTANCE);
		struct step_value left = ifc_value(file, point, LATERAL);
		struct step_value up = ifc_value(file, point, VERTICAL);
		struct ifc_mark mark = {.along = 0};

		if ((ifc_entity_of(file, point) !=
				    IFC_POINTBYDISTANCEEXPRESSION &&
			    ifc_entity_of(file, point) !=
				    IFC_DISTANCEEXPRESSION) ||
			!ifc_distance_read(&along, &mark.along))
			return ifc_refuse(shaper, curve, "an offset is bad");
		if (out->count && !(mark.along > out->at[out->count - 1].along))
			return ifc_refuse(
				shaper, curve, "offsets are out of order");
		(void)step_number(&left, &mark.at.y);
		(void)step_number(&up, &mark.at.z);
		outcome = mark_add(out, mark);
	}
	return outcome;
}

/* What the offsets add at a distance, evenly from one to the next. */
static struct tcs_point
offset_at(const struct ifc_alignment *offsets, double along)
{
	const struct ifc_mark *a =
		offsets->at + mark_find(offsets, along, false);
	const struct ifc_mark *b = a;
	double part = 0;

	if (a + 1 < offsets->at + offsets->count && along > a->along) {
		b = a + 1;
		part = (along - a->along) / (b->along - a->along);
	}
	return (struct tcs_point){0, a->at.y + part * (b->at.y - a->at.y),
		a->at.z + part * (b->at.z - a->at.z)};
}

static struct ifc_mark
place_beside(const struct ifc_alignment *basis,
	const struct ifc_alignment *offsets, double along, bool before)
{
	struct ifc_mark mark = mark_at(basis, along, before);
	struct tcs_point by = offset_at(offsets, along);
	double length = hypot(mark.x, mark.y);

	mark.at.x -= by.y * mark.y / length;
	mark.at.y += by.y * mark.x / length;
	mark.at.z += by.z;
	return mark;
}

/* Chords between the places beside the marks of the basis and the offsets. */
static enum ifc_outcome
beside_read(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	struct ifc_alignment basis = {.count = 0}, offsets = {.count = 0};
	struct ifc_alignment both = {.count = 0};
	enum ifc_outcome outcome = ifc_alignment_read(
		shaper, ifc_target(shaper->file, curve, OFFSET_BASIS), &basis);

	if (!outcome)
		outcome = offsets_read(shaper, curve, &offsets);
	if (!outcome && (!offsets.count || !basis.count))
		outcome = ifc_refuse(shaper, curve, "an offset is bad");
	if (!outcome)
		outcome = alignments_merge(&basis, &offsets, &both);
	for (size_t i = 0; i + 1 < both.count && !outcome; i += 2)
		outcome = chord_add(
			place_beside(&basis, &offsets, both.at[i].along, false),
			place_beside(
				&basis, &offsets, both.at[i + 1].along, true),
			out);
	array_release(&basis);
	array_release(&offsets);
	array_release(&both);
	return outcome;
}

/* ---- all of them --------------------------------------------------------- */

bool
ifc_is_alignment(const struct ifc_file *file, uint32_t curve)
{
	struct step_value list, first;

	switch (ifc_entity_of(file, curve)) {
	case IFC_ALIGNMENTCURVE:
	case IFC_GRADIENTCURVE:
	case IFC_SEGMENTEDREFERENCECURVE:
	case IFC_OFFSETCURVEBYDISTANCES:
		return true;
	case IFC_COMPOSITECURVE:
		list = ifc_value(file, curve, SEGMENTS);
		return list.kind == STEP_LIST &&
			step_next(&list.list, &first) > STEP_END &&
			ifc_entity_of(file, step_target(file->step, &first)) ==
			IFC_CURVESEGMENT;
	default:
		return false;
	}
}

/* Of a curve whose instance was entered. */
static enum ifc_outcome
read_inside(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	if (!ifc_is_alignment(shaper->file, curve))
		return chords_read(shaper, curve, out);
	switch (ifc_entity_of(shaper->file, curve)) {
	case IFC_COMPOSITECURVE:
		return segments_read(shaper, curve, SEGMENTS, out);
	case IFC_ALIGNMENTCURVE:
		return aligned_read(shaper, curve, out);
	case IFC_OFFSETCURVEBYDISTANCES:
		return beside_read(shaper, curve, out);
	default:
		return raised_read(shaper, curve, out);
	}
}

enum ifc_outcome
ifc_alignment_read(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_alignment *out)
{
	enum ifc_outcome outcome = ifc_enter(shaper, curve);

	array_clear(out);
	if (outcome)
		return outcome;
	outcome = read_inside(shaper, curve, out);
	if (outcome)
		return outcome;
	ifc_leave(shaper);
	return out->count ? IFC_SHAPED
			  : ifc_refuse(shaper, curve, "a curve has no length");
}

enum ifc_outcome
ifc_alignment_points(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_points *out)
{
	struct ifc_alignment marks = {.count = 0};
	enum ifc_outcome outcome = ifc_alignment_read(shaper, curve, &marks);
	size_t first = out->count;

	for (size_t i = 0; i < marks.count && !outcome; i++)
		if (out->count == first ||
			!ifc_same_point(shaper, marks.at[i].at,
				out->at[out->count - 1]))
			outcome = ifc_point_add(shaper, out, marks.at[i].at);
	array_release(&marks);
	return outcome;
}

struct ifc_matrix
ifc_mark_axes(const struct ifc_mark *mark)
{
	double plan = hypot(mark->x, mark->y);
	double length = hypot(plan, mark->slope);
	double c = cos(mark->roll), s = sin(mark->roll);
	double x[3] = {
		mark->x / length, mark->y / length, mark->slope / length};
	double left[3] = {-mark->y / plan, mark->x / plan, 0};
	double up[3] = {x[1] * left[2] - x[2] * left[1],
		x[2] * left[0] - x[0] * left[2],
		x[0] * left[1] - x[1] * left[0]};
	const double at[3] = {mark->at.x, mark->at.y, mark->at.z};
	struct ifc_matrix out = ifc_identity;

	for (int i = 0; i < 3; i++) {
		out.at[4 * i] = x[i];
		out.at[4 * i + 1] = c * left[i] - s * up[i];
		out.at[4 * i + 2] = c * up[i] + s * left[i];
		out.at[4 * i + 3] = at[i];
	}
	return out;
}
