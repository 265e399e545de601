#include <math.h>

#include "ifc_curve.h"

static const double PI = 3.14159265358979323846;

enum { FEWEST_IN_QUARTER = 6, MOST_IN_QUARTER = 256 };

enum { CONIC_POSITION, CONIC_FIRST, CONIC_SECOND };

size_t
ifc_arc_chords(const struct ifc_shaper *shaper, double radius, double sweep)
{
	double turn = fabs(sweep) / (PI / 2), quarter = FEWEST_IN_QUARTER;

	radius += shaper->reach;
	if (shaper->deflection < radius)
		quarter = ceil(
			PI / 4 / acos(1 - shaper->deflection / radius) - 1e-9);
	quarter = fmin(fmax(quarter, FEWEST_IN_QUARTER), MOST_IN_QUARTER);
	turn = ceil(turn * quarter - 1e-9);
	return turn < 1 ? 1 : (size_t)turn;
}

static bool
length_read(const struct ifc_file *file, uint32_t instance, int position,
	double *out)
{
	struct step_value value = ifc_value(file, instance, position);

	return step_number(&value, out) && *out > 0;
}

enum ifc_outcome
ifc_conic_read(struct ifc_shaper *shaper, uint32_t conic, struct ifc_conic *out)
{
	const struct ifc_file *file = shaper->file;
	uint32_t position = ifc_target(file, conic, CONIC_POSITION);

	if (!ifc_axes(file, position, &out->at))
		return ifc_refuse(shaper, conic, "a curve has no position");
	if (!length_read(file, conic, CONIC_FIRST, &out->a))
		return ifc_refuse(shaper, conic, "a radius is not positive");
	out->b = out->a;
	if (ifc_entity_of(file, conic) == IFC_ELLIPSE &&
		!length_read(file, conic, CONIC_SECOND, &out->b))
		return ifc_refuse(shaper, conic, "a radius is not positive");
	return IFC_SHAPED;
}

/* Exact at the ends of quarters. */
static struct tcs_point
conic_point(const struct ifc_conic *conic, double angle)
{
	double quarters = angle / (PI / 2), whole = nearbyint(quarters);
	double x = cos(angle), y = sin(angle);

	if (fabs(quarters - whole) < 1e-12 && fabs(whole) < 1e6) {
		x = (double[]){1, 0, -1, 0}[(int)whole & 3];
		y = (double[]){0, 1, 0, -1}[(int)whole & 3];
	}
	return ifc_transform(
		&conic->at, (struct tcs_point){conic->a * x, conic->b * y, 0});
}

enum ifc_outcome
ifc_arc_points(struct ifc_shaper *shaper, const struct ifc_conic *conic,
	double from, double to, struct ifc_points *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t count;

	if (!isfinite(from) || !isfinite(to))
		return ifc_refuse(shaper, STEP_NONE, "an angle is not finite");
	if (fabs(to - from) > 2 * PI)
		to = from + copysign(2 * PI, to - from);
	count = ifc_arc_chords(shaper, fmax(conic->a, conic->b), to - from);
	for (size_t i = 0; i <= count && !outcome; i++) {
		double part = (double)i / (double)count;

		outcome = ifc_point_add(shaper, out,
			conic_point(conic, from + (to - from) * part));
	}
	return outcome;
}

/* ---- through three points ------------------------------------------------ */

static struct tcs_point
minus(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static struct tcs_point
cross(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
		a.x * b.y - a.y * b.x};
}

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* The circle with `a` at angle 0 and, going counterclockwise, b before c. */
static bool
circle_through(struct tcs_point a, struct tcs_point b, struct tcs_point c,
	struct ifc_conic *out)
{
	struct tcs_point ab = minus(b, a), ac = minus(c, a), x, y, z, off;
	double square, lengths = dot(ab, ab) * dot(ac, ac);

	z = cross(ab, ac);
	square = dot(z, z);
	if (!(square > 1e-20 * lengths) || !isfinite(square))
		return false;
	x = cross(z, ab);
	y = cross(ac, z);
	off = (struct tcs_point){
		(dot(ac, ac) * x.x + dot(ab, ab) * y.x) / (2 * square),
		(dot(ac, ac) * x.y + dot(ab, ab) * y.y) / (2 * square),
		(dot(ac, ac) * x.z + dot(ab, ab) * y.z) / (2 * square)};
	out->a = out->b = sqrt(dot(off, off));
	x = (struct tcs_point){
		-off.x / out->a, -off.y / out->a, -off.z / out->a};
	z = (struct tcs_point){
		z.x / sqrt(square), z.y / sqrt(square), z.z / sqrt(square)};
	y = cross(z, x);
	out->at = (struct ifc_matrix){{x.x, y.x, z.x, a.x + off.x, x.y, y.y,
		z.y, a.y + off.y, x.z, y.z, z.z, a.z + off.z, 0, 0, 0, 1}};
	return isfinite(out->a) && out->a > 0;
}

enum ifc_outcome
ifc_arc_through(struct ifc_shaper *shaper, struct tcs_point a,
	struct tcs_point b, struct tcs_point c, struct ifc_points *out)
{
	struct ifc_conic circle;
	enum ifc_outcome outcome;
	struct tcs_point end;
	double sweep;
	size_t count;

	outcome = ifc_point_add(shaper, out, a);
	if (outcome)
		return outcome;
	if (!circle_through(a, b, c, &circle)) {
		outcome = ifc_point_add(shaper, out, b);
		return outcome ? outcome : ifc_point_add(shaper, out, c);
	}
	end = minus(c,
		(struct tcs_point){
			circle.at.at[3], circle.at.at[7], circle.at.at[11]});
	sweep = atan2(circle.at.at[1] * end.x + circle.at.at[5] * end.y +
			circle.at.at[9] * end.z,
		circle.at.at[0] * end.x + circle.at.at[4] * end.y +
			circle.at.at[8] * end.z);
	if (sweep <= 0)
		sweep += 2 * PI;
	count = ifc_arc_chords(shaper, circle.a, sweep);
	for (size_t i = 1; i < count && !outcome; i++)
		outcome = ifc_point_add(shaper, out,
			conic_point(
				&circle, sweep * (double)i / (double)count));
	return outcome ? outcome : ifc_point_add(shaper, out, c);
}
