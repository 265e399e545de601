#include <math.h>

#include "ifc_alignment.h"

enum { PLACEMENT = 1, START, LENGTH, PARENT };

enum { POSITION, FIRST_TERM };

enum { POLYNOMIAL_X = 1, POLYNOMIAL_Y };

enum { MOST_TERMS = 8, MOST_STEPS = 1 << 14, SAMPLES = 16 };

static const double PI = 3.14159265358979323846;

/* The most that a curve may turn in a step, in radians. */
static const double MOST_TURN = 0.1;

/* The curvature of a curve by its length: terms[n] times its n-th power, … */
struct bend {
	double terms[MOST_TERMS];
	double cosine; /* … plus this much of half a wave over `wave`, */
	double sine; /* … plus this much of a whole one */
	double wave;
};

/* A segment: where it starts, and what part of its parent it is. */
struct piece {
	double x, y, direction;
	double start, length; /* of the parent; the length may be negative */
	struct bend bend;
};

/* ---- parents ------------------------------------------------------------- */

static double
number(const struct ifc_file *file, uint32_t instance, int position)
{
	struct step_value value = ifc_value(file, instance, position);
	double out;

	return step_number(&value, &out) ? out : 0;
}

/* What a term of a spiral says of a power of the length. */
static double
term_of(double constant, int power)
{
	return constant == 0
		? 0
		: copysign(pow(fabs(constant), -(power + 1)), constant);
}

static void
polynomial_bend(const struct ifc_file *file, uint32_t curve, int power,
	struct bend *out)
{
	for (int i = power; i >= 0; i--)
		out->terms[i] =
			term_of(number(file, curve, FIRST_TERM + power - i), i);
}

/* How a parent bends; false for a kind that is not known. */
static bool
bend_read(const struct ifc_file *file, uint32_t curve, double length,
	struct bend *out)
{
	double radius;

	*out = (struct bend){.wave = fabs(length)};
	switch (ifc_entity_of(file, curve)) {
	case IFC_LINE:
		return true;
	case IFC_CIRCLE:
		radius = number(file, curve, FIRST_TERM);
		out->terms[0] = radius > 0 ? 1 / radius : 0;
		return radius > 0;
	case IFC_CLOTHOID:
		out->terms[1] = term_of(number(file, curve, FIRST_TERM), 1);
		return true;
	case IFC_SECONDORDERPOLYNOMIALSPIRAL:
		polynomial_bend(file, curve, 2, out);
		return true;
	case IFC_THIRDORDERPOLYNOMIALSPIRAL:
		polynomial_bend(file, curve, 3, out);
		return true;
	case IFC_SEVENTHORDERPOLYNOMIALSPIRAL:
		polynomial_bend(file, curve, 7, out);
		return true;
	case IFC_COSINESPIRAL:
		out->cosine = term_of(number(file, curve, FIRST_TERM), 0);
		out->terms[0] = term_of(number(file, curve, FIRST_TERM + 1), 0);
		return true;
	case IFC_SINESPIRAL:
		out->sine = term_of(number(file, curve, FIRST_TERM), 0);
		out->terms[1] = term_of(number(file, curve, FIRST_TERM + 1), 1);
		out->terms[0] = term_of(number(file, curve, FIRST_TERM + 2), 0);
		return true;
	default:
		return false;
	}
}

static double
curvature(const struct bend *bend, double at)
{
	double out = 0;

	for (int i = MOST_TERMS; i-- > 0;)
		out = out * at + bend->terms[i];
	if (bend->wave > 0)
		out += bend->cosine * cos(PI * at / bend->wave) +
			bend->sine * sin(2 * PI * at / bend->wave);
	return out;
}

/* The integral of the curvature from 0. */
static double
turn(const struct bend *bend, double at)
{
	double out = 0, wave = bend->wave / PI;

	for (int i = MOST_TERMS; i-- > 0;)
		out = out * at + bend->terms[i] / (i + 1);
	out *= at;
	if (wave > 0)
		out += bend->cosine * wave * sin(at / wave) +
			bend->sine * wave / 2 * (1 - cos(2 * at / wave));
	return out;
}

/* ---- reading ------------------------------------------------------------- */

/* A length along a parent, or its parameter. */
static bool
measure_read(const struct ifc_shaper *shaper, uint32_t segment, int position,
	uint32_t parent, double *out)
{
	struct step_value value = ifc_value(shaper->file, segment, position);

	if (!step_number(&value, out))
		return false;
	if (step_is(&value, "IFCPARAMETERVALUE") &&
		ifc_entity_of(shaper->file, parent) == IFC_CIRCLE)
		*out *= shaper->angle *
			number(shaper->file, parent, FIRST_TERM);
	return isfinite(*out);
}

static enum ifc_outcome
piece_read(struct ifc_shaper *shaper, uint32_t segment, struct piece *out)
{
	const struct ifc_file *file = shaper->file;
	uint32_t parent = ifc_target(file, segment, PARENT);
	struct ifc_matrix at;

	if (ifc_entity_of(file, segment) != IFC_CURVESEGMENT ||
		!ifc_axes(file, ifc_target(file, segment, PLACEMENT), &at) ||
		!measure_read(shaper, segment, START, parent, &out->start) ||
		!measure_read(shaper, segment, LENGTH, parent, &out->length))
		return ifc_refuse(shaper, segment, "a segment is bad");
	if (!bend_read(file, parent, out->length, &out->bend))
		return ifc_refuse(
			shaper, parent, "a segment of this kind is not known");
	out->x = at.at[3];
	out->y = at.at[7];
	out->direction = atan2(at.at[4], at.at[0]);
	return IFC_SHAPED;
}

/* ---- segments of IFC4X1 -------------------------------------------------- */

enum { CURVE_GEOMETRY = 3 };

enum { START_POINT, START_DIRECTION, SEGMENT_LENGTH, FIRST_RADIUS };

enum { LAST_RADIUS = 4, FIRST_CCW, LAST_CCW, TRANSITION };

/* A curvature: that of the radius, or 0 where there is none. */
static double
curvature_of(const struct ifc_file *file, uint32_t curve, int radius, int ccw)
{
	double value = number(file, curve, radius);
	struct step_value left = ifc_value(file, curve, ccw);

	return value > 0 ? (step_is(&left, "T") ? 1 : -1) / value : 0;
}

/* From one curvature to another; false for a kind that is not known. */
static bool
transition_bend(const struct ifc_file *file, uint32_t curve, double length,
	struct bend *out)
{
	struct step_value kind = ifc_value(file, curve, TRANSITION);
	double from = curvature_of(file, curve, FIRST_RADIUS, FIRST_CCW);
	double by = curvature_of(file, curve, LAST_RADIUS, LAST_CCW) - from;

	out->terms[0] = from;
	if (step_is(&kind, "CLOTHOIDCURVE")) {
		out->terms[1] = by / length;
	} else if (step_is(&kind, "BLOSSCURVE")) {
		out->terms[2] = 3 * by / (length * length);
		out->terms[3] = -2 * by / (length * length * length);
	} else if (step_is(&kind, "COSINECURVE")) {
		out->terms[0] = from + by / 2;
		out->cosine = -by / 2;
	} else if (step_is(&kind, "SINECURVE")) {
		out->terms[1] = by / length;
		out->sine = -by / (2 * PI);
	} else {
		return false;
	}
	return true;
}

static enum ifc_outcome
piece_read_2d(struct ifc_shaper *shaper, uint32_t segment, struct piece *out)
{
	const struct ifc_file *file = shaper->file;
	uint32_t curve = ifc_target(file, segment, CURVE_GEOMETRY);
	struct step_value start =
		ifc_value(file, ifc_target(file, curve, START_POINT), 0);
	double at[2];

	*out = (struct piece){.length = number(file, curve, SEGMENT_LENGTH)};
	if (!(out->length > 0) || start.kind != STEP_LIST ||
		step_numbers(&start.list, at, 2) != 2)
		return ifc_refuse(shaper, segment, "a segment is bad");
	out->x = at[0];
	out->y = at[1];
	out->direction = shaper->angle * number(file, curve, START_DIRECTION);
	out->bend.wave = out->length;
	switch (ifc_entity_of(file, curve)) {
	case IFC_LINESEGMENT2D:
		return IFC_SHAPED;
	case IFC_CIRCULARARCSEGMENT2D:
		out->bend.terms[0] = curvature_of(
			file, curve, FIRST_RADIUS, FIRST_RADIUS + 1);
		return IFC_SHAPED;
	case IFC_TRANSITIONCURVESEGMENT2D:
		if (transition_bend(file, curve, out->length, &out->bend))
			return IFC_SHAPED;
		break;
	default:
		break;
	}
	return ifc_refuse(shaper, curve, "a segment of this kind is not known");
}

/* ---- marks --------------------------------------------------------------- */

/* So many steps that chords are near and no step turns far. */
static size_t
steps_of(const struct ifc_shaper *shaper, const struct piece *piece)
{
	double most = 0, length = fabs(piece->length), steps;

	for (int i = 0; i <= SAMPLES; i++)
		most = fmax(most,
			fabs(curvature(&piece->bend,
				piece->start + piece->length * i / SAMPLES)));
	if (!(most * length > 0) || !isfinite(most))
		return 1;
	steps = ceil(length *
		fmax(most / MOST_TURN, sqrt(most / (8 * shaper->deflection))));
	return (size_t)fmin(fmax(steps, 1), MOST_STEPS);
}

/* Where a step leads: the integral of the direction, by Gauss and Legendre. */
static void
step_on(const struct piece *piece, double from, double to, double *x, double *y)
{
	static const double nodes[] = {0, 0.5384693101056831,
		-0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
	static const double weights[] = {0.5688888888888889, 0.4786286704993665,
		0.4786286704993665, 0.2369268850561891, 0.2369268850561891};
	double middle = (from + to) / 2, half = (to - from) / 2;
	double origin = turn(&piece->bend, piece->start);

	for (int i = 0; i < 5; i++) {
		double angle = piece->direction +
			turn(&piece->bend, middle + half * nodes[i]) - origin;

		*x += fabs(half) * weights[i] * cos(angle);
		*y += fabs(half) * weights[i] * sin(angle);
	}
}

enum ifc_outcome
ifc_piece_marks(struct ifc_shaper *shaper, uint32_t segment, double along,
	struct ifc_alignment *out)
{
	struct piece piece;
	enum ifc_outcome outcome = ifc_entity_of(shaper->file, segment) ==
			IFC_ALIGNMENT2DHORIZONTALSEGMENT
		? piece_read_2d(shaper, segment, &piece)
		: piece_read(shaper, segment, &piece);
	double x, y, origin;
	size_t steps;

	if (outcome || piece.length == 0)
		return outcome;
	steps = steps_of(shaper, &piece);
	if (shaper->points + steps >= IFC_MOST_POINTS)
		return ifc_refuse(shaper, segment, "too many points");
	shaper->points += steps + 1;
	if (array_grow(out, steps + 1))
		return IFC_NO_MEMORY;
	x = piece.x;
	y = piece.y;
	origin = turn(&piece.bend, piece.start);
	for (size_t i = 0; i <= steps; i++) {
		double part = (double)i / (double)steps;
		double at = piece.start + piece.length * part;
		double angle = piece.direction + turn(&piece.bend, at) - origin;

		if (i)
			step_on(&piece,
				piece.start +
					piece.length * (double)(i - 1) /
						(double)steps,
				at, &x, &y);
		out->at[out->count++] = (struct ifc_mark){
			.along = along + part * fabs(piece.length),
			.at = {x, y, 0},
			.x = cos(angle),
			.y = sin(angle)};
	}
	return IFC_SHAPED;
}
