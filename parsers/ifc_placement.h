/*
 * Where things stand: axis placements and transformation operators as
 * matrices, and the chains of object placements multiplied out.
 *
 * Matrices are 4 by 4, row by row, for column vectors; their last row is
 * 0 0 0 1. Translations are in the file's length unit: nothing is scaled here,
 * so that coordinates far from the origin keep every digit until the caller
 * subtracts an origin and multiplies by ifc_units.length.
 *
 * source: IfcAxis2Placement3D (IfcBuildAxes, IfcFirstProjAxis),
 * IfcCartesianTransformationOperator (IfcBaseAxis), IfcLocalPlacement.
 */
#ifndef TESSERA_IFC_PLACEMENT_H
#define TESSERA_IFC_PLACEMENT_H

#include "ifc_file.h"
#include "report.h"
#include "tcs.h"

struct ifc_matrix {
	double at[16];
};

extern const struct ifc_matrix ifc_identity;

/* The product: first `inner`, then `outer`. */
struct ifc_matrix ifc_multiply(
	const struct ifc_matrix *outer, const struct ifc_matrix *inner);

/* Of the turning and scaling part: negative for one that mirrors. */
double ifc_determinant(const struct ifc_matrix *matrix);

struct tcs_point ifc_transform(
	const struct ifc_matrix *matrix, struct tcs_point point);

/*
 * The coordinates of an IfcCartesianPoint or the ratios of an IfcDirection,
 * two or three; a third that is missing is 0. False for any other instance and
 * for what is not finite.
 */
bool ifc_triple(
	const struct ifc_file *file, uint32_t instance, struct tcs_point *out);

/*
 * The matrix of an IfcAxis2Placement2D or 3D, or IfcAxis1Placement: right-
 * handed and orthonormal. Directions that are missing, or of no length, or
 * along one line, are those the schema takes when none are given. False for
 * anything else and when there is no location.
 */
bool ifc_axes(
	const struct ifc_file *file, uint32_t instance, struct ifc_matrix *out);

/*
 * The matrix of an IfcCartesianTransformationOperator2D or 3D, uniform or not:
 * orthogonal axes, which may mirror, times scales. Directions as with ifc_axes.
 * False for anything else, and for a scale of 0.
 */
bool ifc_operator(
	const struct ifc_file *file, uint32_t instance, struct ifc_matrix *out);

/* One IfcObjectPlacement, multiplied out to the world of the file. */
struct ifc_placement {
	uint32_t instance;
	uint32_t parent; /* its index among the placements; STEP_NONE: none */
	struct ifc_matrix world; /* identity unless `known` */
	bool known;
};

TCS_ARRAY_TYPE(ifc_placements, struct ifc_placement);

/*
 * All object placements of the file, in its order, each multiplied out once,
 * without recursion. A linear placement is taken by its CartesianPosition where it
 * has one, one on a grid is relative to the grid. One that is part of a cycle, malformed, or
 * relative to such a one is not known; each of these is reported as skipped, with the reason. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status ifc_placements_read(const struct ifc_file *file,
	struct ifc_placements *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* The placement that is the instance; NULL for none. */
const struct ifc_placement *ifc_placement_find(
	const struct ifc_placements *placements, uint32_t instance);

#endif
