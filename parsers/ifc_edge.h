/*
 * Edges and loops of faces as points.
 *
 * The same edge gives the same points, bit for bit, whichever face asks, in
 * either direction; they begin and end at the edge's vertices. So faces that
 * share edges meet without gaps.
 *
 * source: ISO 10303-42 5 (topology).
 */
#ifndef TESSERA_IFC_EDGE_H
#define TESSERA_IFC_EDGE_H

#include "ifc_shape.h"

/* Append the points of an edge, an edge curve or an oriented edge. */
enum ifc_outcome ifc_edge_points(struct ifc_shaper *shaper, uint32_t edge,
	struct ifc_points *out) TCS_CHECKED;

/*
 * Append the points of an IfcEdgeLoop or IfcPolyLoop as a ring, none the same,
 * bit for bit, as the one before it. An IfcVertexLoop has none.
 */
enum ifc_outcome ifc_loop_points(struct ifc_shaper *shaper, uint32_t loop,
	struct ifc_points *out) TCS_CHECKED;

#endif
