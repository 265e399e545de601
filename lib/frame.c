#include "frame.h"

#include <math.h>

/* GRS 80: semi-major axis in metres, eccentricity squared. */
#define AXIS 6378137.0
#define ECCENTRICITY2 0.00669438002290
#define RADIANS (3.14159265358979323846 / 180)

/* ---- the ellipsoid ------------------------------------------------------------ */

/* Metres along the meridian from the equator, Snyder 3-21. */
static double
meridian_arc(double latitude)
{
	double e2 = ECCENTRICITY2, e4 = e2 * e2, e6 = e4 * e2;

	return AXIS *
		((1 - e2 / 4 - 3 * e4 / 64 - 5 * e6 / 256) * latitude -
			(3 * e2 / 8 + 3 * e4 / 32 + 45 * e6 / 1024) *
				sin(2 * latitude) +
			(15 * e4 / 256 + 45 * e6 / 1024) * sin(4 * latitude) -
			35 * e6 / 3072 * sin(6 * latitude));
}

/* The radius of curvature across the meridian, metres. */
static double
normal_radius(double latitude)
{
	double s = sin(latitude);

	return AXIS / sqrt(1 - ECCENTRICITY2 * s * s);
}

/* The radius of curvature along it, metres. */
static double
meridian_radius(double latitude)
{
	double n = normal_radius(latitude);

	return n * n * n * (1 - ECCENTRICITY2) / (AXIS * AXIS);
}

/* ---- transverse Mercator ------------------------------------------------------- */

struct easting_northing {
	double east, north;
};

/* Snyder 8-9 to 8-15 with a scale of 1; `away` from the central meridian. */
static struct easting_northing
mercator(double latitude, double away, double meridian)
{
	double c = cos(latitude), t = tan(latitude);
	double t2 = t * t, e2 = ECCENTRICITY2 / (1 - ECCENTRICITY2);
	double n = normal_radius(latitude), g = e2 * c * c;
	double a = away * c, a2 = a * a, a4 = a2 * a2;
	double north = meridian_arc(latitude) - meridian;

	if (fabs(c) < 1e-9)
		return (struct easting_northing){0, north};
	return (struct easting_northing){n * a *
			(1 + (1 - t2 + g) * a2 / 6 +
				(5 - 18 * t2 + t2 * t2 + 72 * g - 58 * e2) *
					a4 / 120),
		north +
			n * t *
				(a2 / 2 +
					(5 - t2 + 9 * g + 4 * g * g) * a4 / 24 +
					(61 - 58 * t2 + t2 * t2 + 600 * g -
						330 * e2) *
						a4 * a2 / 720)};
}

static double
clamped(double value, double most)
{
	return fmax(-most, fmin(most, value));
}

enum { MOST_STEPS = 20 };

/* The latitude and longitude that project there, by correcting a guess. */
static void
mercator_invert(const struct frame *frame, struct tcs_point local,
	double *latitude, double *away)
{
	double phi = frame->origin.y * RADIANS, lambda = 0;

	for (int i = 0; i < MOST_STEPS; i++) {
		struct easting_northing at =
			mercator(phi, lambda, frame->meridian);
		double up = (local.y - at.north) / meridian_radius(phi);
		double c = fmax(fabs(cos(phi)), 1e-9);
		double aside = (local.x - at.east) / (normal_radius(phi) * c);

		phi = clamped(phi + up, 90 * RADIANS);
		lambda = clamped(lambda + aside, 180 * RADIANS);
		if (fabs(up) < 1e-16 && fabs(aside) < 1e-16)
			break;
	}
	*latitude = phi;
	*away = lambda;
}

/* ---- east, north, up at a point of the ellipsoid --------------------------------- */

enum { LATITUDE_STEPS = 10 };

static void
turn_set(struct frame *frame)
{
	struct tcs_point o = frame->origin;
	double scale = frame->scale[0];
	double x = o.x * scale, y = o.y * scale, z = o.z * scale;
	double across = hypot(x, y), longitude = atan2(y, x);
	double latitude = atan2(z, across * (1 - ECCENTRICITY2));
	double s, c, sl = sin(longitude), cl = cos(longitude);

	for (int i = 0; i < LATITUDE_STEPS; i++)
		latitude = atan2(z +
				ECCENTRICITY2 * normal_radius(latitude) *
					sin(latitude),
			across);
	s = sin(latitude);
	c = cos(latitude);
	frame->turn[0] = -sl;
	frame->turn[1] = cl;
	frame->turn[2] = 0;
	frame->turn[3] = -s * cl;
	frame->turn[4] = -s * sl;
	frame->turn[5] = c;
	frame->turn[6] = c * cl;
	frame->turn[7] = c * sl;
	frame->turn[8] = s;
}

/* ---- the frame ------------------------------------------------------------------- */

void
frame_init(struct frame *frame, const struct tcs_crs *crs,
	const struct tcs_point *origin)
{
	*frame = (struct frame){.origin = origin ? *origin : crs->origin,
		.scale = {crs->metres_per_unit, crs->metres_per_unit,
			crs->metres_per_unit_up},
		.kind = (enum tcs_crs_kind)crs->kind};
	if (frame->kind == TCS_CRS_GEOCENTRIC) {
		frame->scale[2] = crs->metres_per_unit;
		turn_set(frame);
	}
	if (frame->kind == TCS_CRS_GEOGRAPHIC)
		frame->meridian = meridian_arc(frame->origin.y * RADIANS);
}

struct tcs_point
frame_to_local(const struct frame *frame, struct tcs_point point)
{
	const double *m = frame->turn;
	struct tcs_point at = {(point.x - frame->origin.x) * frame->scale[0],
		(point.y - frame->origin.y) * frame->scale[1],
		(point.z - frame->origin.z) * frame->scale[2]};
	struct easting_northing on;

	if (frame->kind == TCS_CRS_GEOCENTRIC)
		return (struct tcs_point){
			m[0] * at.x + m[1] * at.y + m[2] * at.z,
			m[3] * at.x + m[4] * at.y + m[5] * at.z,
			m[6] * at.x + m[7] * at.y + m[8] * at.z};
	if (frame->kind != TCS_CRS_GEOGRAPHIC)
		return at;
	on = mercator(point.y * RADIANS, (point.x - frame->origin.x) * RADIANS,
		frame->meridian);
	return (struct tcs_point){on.east, on.north, at.z};
}

struct tcs_point
frame_from_local(const struct frame *frame, struct tcs_point point)
{
	const double *m = frame->turn;
	const struct tcs_point *o = &frame->origin;
	struct tcs_point at = point;

	if (frame->kind == TCS_CRS_GEOCENTRIC)
		at = (struct tcs_point){
			m[0] * point.x + m[3] * point.y + m[6] * point.z,
			m[1] * point.x + m[4] * point.y + m[7] * point.z,
			m[2] * point.x + m[5] * point.y + m[8] * point.z};
	if (frame->kind == TCS_CRS_GEOGRAPHIC) {
		double latitude, away;

		mercator_invert(frame, point, &latitude, &away);
		return (struct tcs_point){o->x + away / RADIANS,
			latitude / RADIANS, o->z + point.z / frame->scale[2]};
	}
	return (struct tcs_point){o->x + at.x / frame->scale[0],
		o->y + at.y / frame->scale[1], o->z + at.z / frame->scale[2]};
}
