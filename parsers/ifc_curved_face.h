/*
 * Faces on curved surfaces as triangles.
 *
 * The loops of a face are points that its neighbours have, too (ifc_edge.h).
 * They are found on the surface, unrolled where it closes, triangulated there
 * and refined within, so that a shell that is closed stays closed. A face may
 * go all around its surface, with or without a seam, or have no bounds on one
 * that is closed, and it may contain the points where a surface is pinched, the
 * poles of a sphere or the tip of a cone.
 *
 * source: IfcAdvancedFace, IfcFaceSurface (ISO 16739-1 8.17.3).
 */
#ifndef TESSERA_IFC_CURVED_FACE_H
#define TESSERA_IFC_CURVED_FACE_H

#include "ifc_shape.h"

/*
 * Append the triangles of a face on a surface that is not a plane, wound as
 * its loops are, or as the surface where it has none.
 */
enum ifc_outcome ifc_curved_face(struct ifc_shaper *shaper, uint32_t face,
	struct ifc_faces *out) TCS_CHECKED;

#endif
