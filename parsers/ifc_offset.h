/*
 * Curves beside curves: offsets of polylines, with corners as mitres.
 *
 * source: ISO 10303-42 4.4.50 and 4.4.51 (offset curves).
 */
#ifndef TESSERA_IFC_OFFSET_H
#define TESSERA_IFC_OFFSET_H

#include "ifc_shape.h"

/*
 * Append the points beside a polyline, or a ring that does not repeat its
 * first point: `distance` along `up` times the direction of travel, to the left
 * where `up` is z. Corners sharper than a right mitre eight times as long as
 * the distance are cut off there. Points that are the same as the one before
 * them are passed over; where there are not two others, nothing is appended.
 */
enum ifc_outcome ifc_offset_points(struct ifc_shaper *shaper,
	const struct tcs_point *points, size_t count, bool closed,
	double distance, struct tcs_point up,
	struct ifc_points *out) TCS_CHECKED;

/*
 * The part of an IfcOffsetCurve2D or 3D between two parameters of its basis,
 * `from` the smaller one.
 */
enum ifc_outcome ifc_offset_between(struct ifc_shaper *shaper, uint32_t curve,
	double from, double to, struct ifc_points *out) TCS_CHECKED;

#endif
