/*
 * Curves as polylines.
 *
 * A curve in a plane has z = 0. Arcs become chords that are nowhere further
 * off than the shaper's deflection, never fewer than 24 for a full turn,
 * and as many in each quarter of it, so that the box of a circle is its own.
 *
 * source: ISO 10303-42 4.4 (parametrisations), ISO 16739-1 8.9.3 (curves).
 */
#ifndef TESSERA_IFC_CURVE_H
#define TESSERA_IFC_CURVE_H

#include "ifc_shape.h"

/*
 * Append the points of a bounded curve, or of a whole conic, from its start to
 * its end. A closed curve ends near its first point, which is repeated. A line
 * without ends is refused.
 */
enum ifc_outcome ifc_curve_points(struct ifc_shaper *shaper, uint32_t curve,
	struct ifc_points *out) TCS_CHECKED;

/*
 * The part of a curve between two of its parameters, in its own
 * parametrisation; angles are in the file's unit. From a larger parameter to a
 * smaller one, the curve is run backwards. Parameters beyond the ends of a
 * bounded curve are taken as its ends.
 */
enum ifc_outcome ifc_curve_between(struct ifc_shaper *shaper, uint32_t curve,
	double from, double to, struct ifc_points *out) TCS_CHECKED;

/* The parameters of a curve's ends: 0 and 0 for a line. */
enum ifc_outcome ifc_curve_range(struct ifc_shaper *shaper, uint32_t curve,
	double *from, double *to) TCS_CHECKED;

/*
 * Append the points of a closed curve as a ring: without the first repeated,
 * and without points that are the same as the one before.
 */
enum ifc_outcome ifc_curve_ring(struct ifc_shaper *shaper, uint32_t curve,
	struct ifc_points *out) TCS_CHECKED;

/* A point of a line and its vector, which a step of its parameter adds. */
bool ifc_line_read(const struct ifc_file *file, uint32_t line,
	struct tcs_point *point, struct tcs_point *along);

/* ---- ifc_conic.c --------------------------------------------------------- */

/* An ellipse or circle: centre and axes as a matrix, and half its diameters. */
struct ifc_conic {
	struct ifc_matrix at;
	double a, b;
};

/* How many chords an arc takes; `sweep` in radians, of either sign. */
size_t ifc_arc_chords(
	const struct ifc_shaper *shaper, double radius, double sweep);

enum ifc_outcome ifc_conic_read(struct ifc_shaper *shaper, uint32_t conic,
	struct ifc_conic *out) TCS_CHECKED;

/*
 * Append an arc from one angle to another, in radians, both ends included;
 * clockwise when `to` is smaller.
 */
enum ifc_outcome ifc_arc_points(struct ifc_shaper *shaper,
	const struct ifc_conic *conic, double from, double to,
	struct ifc_points *out) TCS_CHECKED;

/* Append the arc through three points; a line when they are on one. */
enum ifc_outcome ifc_arc_through(struct ifc_shaper *shaper, struct tcs_point a,
	struct tcs_point b, struct tcs_point c,
	struct ifc_points *out) TCS_CHECKED;

/* ---- ifc_trim.c ---------------------------------------------------------- */

/* The ends of an IfcTrimmedCurve as parameters of its basis, in its sense. */
enum ifc_outcome ifc_trim_range(struct ifc_shaper *shaper, uint32_t trimmed,
	double *from, double *to) TCS_CHECKED;

/*
 * The parameter of the place on a line, a conic, a polyline, a spline or a part
 * of these that is nearest to a point, or all but that for one far off an
 * ellipse.
 */
enum ifc_outcome ifc_curve_locate(struct ifc_shaper *shaper, uint32_t curve,
	struct tcs_point point, double *out) TCS_CHECKED;

#endif
