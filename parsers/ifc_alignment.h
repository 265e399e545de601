/*
 * Alignments: curves of segments that are placed one by one, in plan, in
 * elevation, and with cant.
 *
 * An alignment is a list of marks, in order. Between two marks it is a cubic
 * with their tangents; where it has a corner, there are two marks at the same
 * distance. Distances are measured in plan.
 *
 * source: IfcCurveSegment, IfcGradientCurve, IfcSegmentedReferenceCurve,
 * IfcSpiral, IfcOffsetCurveByDistances (ISO 16739-1:2024 8.9.3);
 * IfcAlignmentCurve, IfcCurveSegment2D, IfcAlignment2DVertical (IFC4.1 of
 * buildingSMART).
 */
#ifndef TESSERA_IFC_ALIGNMENT_H
#define TESSERA_IFC_ALIGNMENT_H

#include "ifc_shape.h"

struct ifc_mark {
	double along; /* the distance from the start */
	struct tcs_point at;
	double x, y, slope; /* the tangent: steps per distance */
	double roll; /* radians, about the tangent; positive lowers the left */
};

TCS_ARRAY_TYPE(ifc_alignment, struct ifc_mark);

/* The curves that are read here. */
bool ifc_is_alignment(const struct ifc_file *file, uint32_t curve);

/*
 * Read an alignment, or any other curve as one. Its chords are no further off
 * than the shaper's deflection. Cant goes evenly from one segment to the next.
 */
enum ifc_outcome ifc_alignment_read(struct ifc_shaper *shaper, uint32_t curve,
	struct ifc_alignment *out) TCS_CHECKED;

/* The place at a distance; beyond the ends, straight on. */
struct ifc_mark ifc_alignment_at(
	const struct ifc_alignment *alignment, double along);

/* Append the points of an alignment curve. */
enum ifc_outcome ifc_alignment_points(struct ifc_shaper *shaper, uint32_t curve,
	struct ifc_points *out) TCS_CHECKED;

/* The axes at a mark: x along it, y to its left, z up. */
struct ifc_matrix ifc_mark_axes(const struct ifc_mark *mark);

/* ---- ifc_alignment_piece.c ----------------------------------------------- */

/*
 * Append the marks of an IfcCurveSegment, or an
 * IfcAlignment2DHorizontalSegment, in its plane, from a distance on: `along`
 * counts them, and z and slope are 0.
 */
enum ifc_outcome ifc_piece_marks(struct ifc_shaper *shaper, uint32_t segment,
	double along, struct ifc_alignment *out) TCS_CHECKED;

/* ---- ifc_alignment_rise.c ------------------------------------------------ */

/*
 * Append the marks of an IfcAlignment2DVertical: heights and slopes at
 * distances in plan.
 */
enum ifc_outcome ifc_rise_marks(struct ifc_shaper *shaper, uint32_t vertical,
	struct ifc_alignment *out) TCS_CHECKED;

/* ---- ifc_alignment_place.c ----------------------------------------------- */

/* A distance: a length, or a number taken as one. */
bool ifc_distance_read(const struct step_value *value, double *out);

/*
 * The alignment read last: things are placed along the same one by thousands.
 * All zero is none; release `marks`.
 */
struct ifc_alignment_kept {
	uint32_t curve;
	struct ifc_alignment marks; /* none: nothing is kept */
};

/*
 * The axes of a curve, as ifc_mark_axes, at a point given by its distance and
 * offsets: an IfcPointByDistanceExpression, or the IfcDistanceExpression of
 * IFC4X1. `upright` takes neither the slope nor the roll of the curve. `kept`
 * is as below.
 */
enum ifc_outcome ifc_distance_axes(struct ifc_shaper *shaper, uint32_t point,
	uint32_t curve, bool upright, struct ifc_alignment_kept *kept,
	struct ifc_matrix *out) TCS_CHECKED;

/*
 * The matrix of an IfcAxis2PlacementLinear in the coordinates of its curve.
 * Directions that are not given are those of the curve. `kept` belongs to one
 * file, and to a shaper that does not change.
 */
enum ifc_outcome ifc_linear_axes(struct ifc_shaper *shaper, uint32_t placement,
	struct ifc_alignment_kept *kept, struct ifc_matrix *out) TCS_CHECKED;

#endif
