/*
 * B-splines: curves as polylines, and what their surfaces share with them.
 *
 * Poles are homogeneous: x, y and z are multiplied by the weight. The knots are
 * written out, each as often as its multiplicity says, and there are as many as
 * poles plus the degree plus one. A Bézier curve is one whose inner knots, the
 * whole numbers, have its degree as their multiplicity.
 *
 * source: ISO 10303-42 4.4.33 to 4.4.40; L. Piegl and W. Tiller, The NURBS
 * Book, 1997, 2.2 and 4.2, for the algorithms.
 */
#ifndef TESSERA_IFC_SPLINE_H
#define TESSERA_IFC_SPLINE_H

#include "ifc_shape.h"

enum { IFC_MOST_DEGREE = 24 };

struct ifc_pole {
	double x, y, z, w;
};

TCS_ARRAY_TYPE(ifc_poles, struct ifc_pole);
TCS_ARRAY_TYPE(ifc_knots, double);

/* ---- what curves and surfaces share -------------------------------------- */

/* A degree from 1 to IFC_MOST_DEGREE with more poles than that. */
enum ifc_outcome ifc_degree_read(struct ifc_shaper *shaper, uint32_t item,
	int position, unsigned *out) TCS_CHECKED;

/* Append the points of a list as poles of weight 1. */
enum ifc_outcome ifc_poles_read(struct ifc_shaper *shaper, uint32_t item,
	struct step_value *list, struct ifc_poles *out) TCS_CHECKED;

/*
 * Read knots and their multiplicities for so many poles. They must ascend, and
 * no inner one may break the curve apart.
 */
enum ifc_outcome ifc_knots_read(struct ifc_shaper *shaper, uint32_t item,
	int knots, int multiplicities, unsigned degree, size_t poles,
	struct ifc_knots *out) TCS_CHECKED;

/* Read so many weights, all positive, onto poles of weight 1. */
enum ifc_outcome ifc_weights_read(struct ifc_shaper *shaper, uint32_t item,
	struct step_value *list, struct ifc_pole *poles,
	size_t count) TCS_CHECKED;

/*
 * The span of knots that holds a parameter of the range, and the pole that a
 * curve has there, of the degree plus one poles of its span: the first one is
 * the span's number less the degree.
 */
size_t ifc_knot_span(
	const struct ifc_knots *knots, unsigned degree, double parameter);
struct ifc_pole ifc_pole_at(const struct ifc_knots *knots, unsigned degree,
	size_t span, double parameter, const struct ifc_pole *poles);

/* ---- curves -------------------------------------------------------------- */

/* All zero is empty. */
struct ifc_spline {
	unsigned degree;
	struct ifc_poles poles;
	struct ifc_knots knots;
};

/* IfcBSplineCurve and its subtypes. */
enum ifc_outcome ifc_spline_read(struct ifc_shaper *shaper, uint32_t curve,
	struct ifc_spline *out) TCS_CHECKED;

void ifc_spline_release(struct ifc_spline *spline);

double ifc_spline_from(const struct ifc_spline *spline);
double ifc_spline_to(const struct ifc_spline *spline);

struct tcs_point ifc_spline_at(
	const struct ifc_spline *spline, double parameter);

/*
 * Append the points of a spline curve between two parameters, `from` the
 * smaller one, nowhere further off than the shaper's deflection; parameters
 * beyond its ends are its ends.
 */
enum ifc_outcome ifc_spline_between(struct ifc_shaper *shaper, uint32_t curve,
	double from, double to, struct ifc_points *out) TCS_CHECKED;

/* The parameters of a spline curve's ends. */
enum ifc_outcome ifc_spline_range(struct ifc_shaper *shaper, uint32_t curve,
	double *from, double *to) TCS_CHECKED;

/* The parameter of the point of a spline curve that is nearest. */
enum ifc_outcome ifc_spline_nearest(struct ifc_shaper *shaper, uint32_t curve,
	struct tcs_point point, double *out) TCS_CHECKED;

#endif
