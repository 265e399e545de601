#include "ifc_spline.h"

#include <math.h>

enum { DEGREE, POLES, KNOT_MULTIPLICITIES = 5, KNOTS, WEIGHTS = 8 };

enum { BEZIER_WEIGHTS = 5 };

/* Bisections of one span of knots: the fewest, the most. */
enum { FEWEST_HALVES = 2, MOST_HALVES = 12 };

/* Samples of a span from which the nearest point is sought. */
enum { SAMPLES = 8, STEPS = 40 };

/* ---- reading ------------------------------------------------------------- */

enum ifc_outcome
ifc_degree_read(
	struct ifc_shaper *shaper, uint32_t item, int position, unsigned *out)
{
	struct step_value value = ifc_value(shaper->file, item, position);
	int64_t degree;

	if (!step_integer(&value, &degree) || degree < 1 ||
		degree > IFC_MOST_DEGREE)
		return ifc_refuse(shaper, item, "a spline's degree is bad");
	*out = (unsigned)degree;
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_poles_read(struct ifc_shaper *shaper, uint32_t item,
	struct step_value *list, struct ifc_poles *out)
{
	struct step_value value;

	if (list->kind != STEP_LIST)
		return ifc_refuse(shaper, item, "a spline has no points");
	while (step_next(&list->list, &value) > STEP_END) {
		struct tcs_point point;

		if (!ifc_triple(shaper->file,
			    step_target(shaper->file->step, &value), &point))
			return ifc_refuse(
				shaper, item, "a point is missing or bad");
		if (array_grow(out, 1))
			return IFC_NO_MEMORY;
		out->at[out->count++] =
			(struct ifc_pole){point.x, point.y, point.z, 1};
	}
	return IFC_SHAPED;
}

/* Knots from their list, each as often as the other list says. */
static bool
knots_fetch(struct step_value *knots, struct step_value *multiplicities,
	unsigned degree, size_t wanted, struct ifc_knots *out)
{
	struct step_value value, times;
	double knot;
	int64_t count;

	if (knots->kind != STEP_LIST || multiplicities->kind != STEP_LIST)
		return false;
	while (step_next(&knots->list, &value) > STEP_END) {
		if (step_next(&multiplicities->list, &times) <= STEP_END ||
			!step_number(&value, &knot) ||
			!step_integer(&times, &count) || count < 1 ||
			count > (int64_t)degree + 1 ||
			out->count + (size_t)count > wanted ||
			(out->count && !(knot > out->at[out->count - 1])))
			return false;
		while (count--)
			out->at[out->count++] = knot;
	}
	return out->count == wanted;
}

enum ifc_outcome
ifc_knots_read(struct ifc_shaper *shaper, uint32_t item, int knots,
	int multiplicities, unsigned degree, size_t poles,
	struct ifc_knots *out)
{
	struct step_value list = ifc_value(shaper->file, item, knots);
	struct step_value times = ifc_value(shaper->file, item, multiplicities);
	size_t wanted = poles + degree + 1;

	array_clear(out);
	if (poles <= degree)
		return ifc_refuse(shaper, item, "a spline has too few points");
	if (array_grow(out, wanted))
		return IFC_NO_MEMORY;
	if (!knots_fetch(&list, &times, degree, wanted, out) ||
		!(out->at[degree] < out->at[poles]))
		return ifc_refuse(shaper, item, "a spline's knots are bad");
	for (size_t i = degree + 1; i + degree < poles; i++)
		if (out->at[i] == out->at[i + degree])
			return ifc_refuse(
				shaper, item, "a spline's knots tear it apart");
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_weights_read(struct ifc_shaper *shaper, uint32_t item,
	struct step_value *list, struct ifc_pole *poles, size_t count)
{
	struct step_value value;
	double weight;

	for (size_t i = 0; i < count; i++) {
		if (list->kind != STEP_LIST ||
			step_next(&list->list, &value) <= STEP_END ||
			!step_number(&value, &weight) || !(weight > 0))
			return ifc_refuse(
				shaper, item, "a spline's weights are bad");
		poles[i].x *= weight;
		poles[i].y *= weight;
		poles[i].z *= weight;
		poles[i].w = weight;
	}
	return IFC_SHAPED;
}

/* The knots of Bézier curves in a row: 0, 1, 2, … */
static enum ifc_outcome
bezier_knots(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_spline *spline)
{
	size_t poles = spline->poles.count, degree = spline->degree;

	if (poles <= degree || (poles - 1) % degree)
		return ifc_refuse(shaper, curve, "a spline has too few points");
	if (array_grow(&spline->knots, poles + degree + 1))
		return IFC_NO_MEMORY;
	for (size_t i = 0; i < poles + degree + 1; i++)
		spline->knots.at[spline->knots.count++] =
			fmin(i ? (double)((i - 1) / degree) : 0,
				(double)((poles - 1) / degree));
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_spline_read(
	struct ifc_shaper *shaper, uint32_t curve, struct ifc_spline *out)
{
	const struct ifc_file *file = shaper->file;
	enum ifc_entity entity = ifc_entity_of(file, curve);
	struct step_value list = ifc_value(file, curve, POLES);
	bool bezier = ifc_is(file->version, entity, IFC_BEZIERCURVE);
	enum ifc_outcome outcome;

	array_clear(&out->poles);
	array_clear(&out->knots);
	outcome = ifc_degree_read(shaper, curve, DEGREE, &out->degree);
	if (!outcome)
		outcome = ifc_poles_read(shaper, curve, &list, &out->poles);
	if (!outcome && bezier)
		outcome = bezier_knots(shaper, curve, out);
	else if (!outcome)
		outcome = ifc_knots_read(shaper, curve, KNOTS,
			KNOT_MULTIPLICITIES, out->degree, out->poles.count,
			&out->knots);
	if (outcome ||
		(entity != IFC_RATIONALBSPLINECURVEWITHKNOTS &&
			entity != IFC_RATIONALBEZIERCURVE))
		return outcome;
	list = ifc_value(file, curve, bezier ? BEZIER_WEIGHTS : WEIGHTS);
	return ifc_weights_read(
		shaper, curve, &list, out->poles.at, out->poles.count);
}

void
ifc_spline_release(struct ifc_spline *spline)
{
	array_release(&spline->poles);
	array_release(&spline->knots);
}

/* ---- evaluating ---------------------------------------------------------- */

size_t
ifc_knot_span(const struct ifc_knots *knots, unsigned degree, double parameter)
{
	size_t low = degree, high = knots->count - degree - 1;

	while (high - low > 1) {
		size_t middle = low + (high - low) / 2;

		if (knots->at[middle] <= parameter)
			low = middle;
		else
			high = middle;
	}
	/* At the end of the range, the last span that is one. */
	while (low > degree && knots->at[low] == knots->at[low + 1])
		low--;
	return low;
}

struct ifc_pole
ifc_pole_at(const struct ifc_knots *knots, unsigned degree, size_t span,
	double parameter, const struct ifc_pole *poles)
{
	struct ifc_pole row[IFC_MOST_DEGREE + 1];

	for (size_t i = 0; i <= degree; i++)
		row[i] = poles[i];
	for (size_t level = 1; level <= degree; level++) {
		for (size_t i = degree; i >= level; i--) {
			size_t at = span - degree + i;
			double low = knots->at[at];
			double high = knots->at[at + degree + 1 - level];
			double part = (parameter - low) / (high - low);

			row[i].x =
				row[i - 1].x + part * (row[i].x - row[i - 1].x);
			row[i].y =
				row[i - 1].y + part * (row[i].y - row[i - 1].y);
			row[i].z =
				row[i - 1].z + part * (row[i].z - row[i - 1].z);
			row[i].w =
				row[i - 1].w + part * (row[i].w - row[i - 1].w);
		}
	}
	return row[degree];
}

double
ifc_spline_from(const struct ifc_spline *spline)
{
	return spline->knots.at[spline->degree];
}

double
ifc_spline_to(const struct ifc_spline *spline)
{
	return spline->knots.at[spline->poles.count];
}

struct tcs_point
ifc_spline_at(const struct ifc_spline *spline, double parameter)
{
	struct ifc_pole pole;
	size_t span;

	parameter = fmin(fmax(parameter, ifc_spline_from(spline)),
		ifc_spline_to(spline));
	span = ifc_knot_span(&spline->knots, spline->degree, parameter);
	pole = ifc_pole_at(&spline->knots, spline->degree, span, parameter,
		spline->poles.at + span - spline->degree);
	return (struct tcs_point){
		pole.x / pole.w, pole.y / pole.w, pole.z / pole.w};
}

/* ---- as a polyline ------------------------------------------------------- */

struct piece {
	double from, to;
	struct tcs_point begin, end;
	unsigned halves;
};

static struct tcs_point
minus(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* How far a point is from a line between two others. */
static double
off_chord(struct tcs_point a, struct tcs_point b, struct tcs_point point)
{
	struct tcs_point along = minus(b, a), to = minus(point, a);
	double square = dot(along, along), part;

	part = square > 0 ? fmin(fmax(dot(to, along) / square, 0), 1) : 0;
	to.x -= part * along.x;
	to.y -= part * along.y;
	to.z -= part * along.z;
	return sqrt(dot(to, to));
}

/* What lies `reach` outside of an arc is off its chord in proportion. */
static bool
is_flat(const struct ifc_shaper *shaper, const struct ifc_spline *spline,
	const struct piece *piece)
{
	struct tcs_point chord = minus(piece->end, piece->begin);
	double square = dot(chord, chord), off = 0;

	for (int i = 1; i < 4; i++)
		off = fmax(off,
			off_chord(piece->begin, piece->end,
				ifc_spline_at(spline,
					piece->from +
						(piece->to - piece->from) * i /
							4)));
	if (square > 0)
		off += 8 * off * off * shaper->reach / square;
	return off <= shaper->deflection;
}

/* The points of one piece, but for its first one. */
static enum ifc_outcome
piece_points(struct ifc_shaper *shaper, const struct ifc_spline *spline,
	struct piece whole, struct ifc_points *out)
{
	struct piece stack[MOST_HALVES + 2];
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t count = 0;

	stack[count++] = whole;
	while (count && !outcome) {
		struct piece piece = stack[--count], half = piece;

		if (piece.halves == MOST_HALVES ||
			(piece.halves >= FEWEST_HALVES &&
				is_flat(shaper, spline, &piece))) {
			outcome = ifc_point_add(shaper, out, piece.end);
			continue;
		}
		half.halves++;
		half.from += (piece.to - piece.from) / 2;
		half.begin = ifc_spline_at(spline, half.from);
		stack[count++] = half;
		half.to = half.from;
		half.end = half.begin;
		half.from = piece.from;
		half.begin = piece.begin;
		stack[count++] = half;
	}
	return outcome;
}

/* Between two parameters of the range, span by span. */
static enum ifc_outcome
spline_points(struct ifc_shaper *shaper, const struct ifc_spline *spline,
	double from, double to, struct ifc_points *out)
{
	struct piece piece = {
		.from = from, .begin = ifc_spline_at(spline, from)};
	enum ifc_outcome outcome = ifc_point_add(shaper, out, piece.begin);

	for (size_t i = spline->degree; i < spline->poles.count && !outcome;
		i++) {
		piece.to = fmin(spline->knots.at[i + 1], to);
		if (!(piece.to > piece.from))
			continue;
		piece.end = ifc_spline_at(spline, piece.to);
		piece.halves = spline->degree == 1 ? MOST_HALVES : 0;
		outcome = piece_points(shaper, spline, piece, out);
		piece.from = piece.to;
		piece.begin = piece.end;
	}
	return outcome;
}

enum ifc_outcome
ifc_spline_between(struct ifc_shaper *shaper, uint32_t curve, double from,
	double to, struct ifc_points *out)
{
	struct ifc_spline spline = {.degree = 0};
	enum ifc_outcome outcome = ifc_spline_read(shaper, curve, &spline);

	if (!outcome)
		outcome = spline_points(shaper, &spline,
			fmax(from, ifc_spline_from(&spline)),
			fmin(to, ifc_spline_to(&spline)), out);
	ifc_spline_release(&spline);
	return outcome;
}

enum ifc_outcome
ifc_spline_range(
	struct ifc_shaper *shaper, uint32_t curve, double *from, double *to)
{
	struct ifc_spline spline = {.degree = 0};
	enum ifc_outcome outcome = ifc_spline_read(shaper, curve, &spline);

	if (!outcome) {
		*from = ifc_spline_from(&spline);
		*to = ifc_spline_to(&spline);
	}
	ifc_spline_release(&spline);
	return outcome;
}

/* ---- the nearest point --------------------------------------------------- */

static double
square_to(const struct ifc_spline *spline, double parameter,
	struct tcs_point point)
{
	struct tcs_point off = minus(ifc_spline_at(spline, parameter), point);

	return dot(off, off);
}

/* By golden section, between two parameters around a minimum. */
static double
nearest_between(const struct ifc_spline *spline, double low, double high,
	struct tcs_point point)
{
	const double golden = 0.6180339887498949;

	for (int i = 0; i < STEPS; i++) {
		double a = high - golden * (high - low);
		double b = low + golden * (high - low);

		if (square_to(spline, a, point) < square_to(spline, b, point))
			high = b;
		else
			low = a;
	}
	return low + (high - low) / 2;
}

static double
spline_nearest(const struct ifc_spline *spline, struct tcs_point point)
{
	double best = HUGE_VAL, at = ifc_spline_from(spline), step = 0;
	double from = at, to = ifc_spline_to(spline), refined;

	for (size_t i = spline->degree; i < spline->poles.count; i++) {
		double low = spline->knots.at[i];
		double part = (spline->knots.at[i + 1] - low) / SAMPLES;

		for (int k = 0; k <= SAMPLES && part > 0; k++) {
			double square =
				square_to(spline, low + k * part, point);

			if (square < best) {
				best = square;
				at = low + k * part;
			}
			step = fmax(step, part);
		}
	}
	refined = nearest_between(
		spline, fmax(at - step, from), fmin(at + step, to), point);
	return square_to(spline, refined, point) < best ? refined : at;
}

enum ifc_outcome
ifc_spline_nearest(struct ifc_shaper *shaper, uint32_t curve,
	struct tcs_point point, double *out)
{
	struct ifc_spline spline = {.degree = 0};
	enum ifc_outcome outcome = ifc_spline_read(shaper, curve, &spline);

	if (!outcome)
		*out = spline_nearest(&spline, point);
	ifc_spline_release(&spline);
	return outcome;
}
