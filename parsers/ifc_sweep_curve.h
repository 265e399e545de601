/*
 * Solids swept along curves, tapered ones, and primitives, as closed faces in
 * the item's coordinates that look outwards.
 *
 * A section of several faces makes as many solids, which may touch.
 *
 * source: ISO 16739-1 8.8.3 (IfcSweptAreaSolid, IfcSweptDiskSolid,
 * IfcCsgPrimitive3D and their subtypes).
 */
#ifndef TESSERA_IFC_SWEEP_CURVE_H
#define TESSERA_IFC_SWEEP_CURVE_H

#include "ifc_loft.h"
#include "ifc_path.h"

/* Place faces as the axes at a position of the item say, where it has any. */
enum ifc_outcome ifc_faces_place(struct ifc_shaper *shaper, uint32_t item,
	int position, struct ifc_faces *faces, size_t first_face) TCS_CHECKED;

/* ---- ifc_sweep_disk.c ---------------------------------------------------- */

/*
 * IfcSweptDiskSolid, polygonal or not: a disk, or a ring, along a curve. Sharp
 * corners of the curve become mitres, unless a fillet's radius is given.
 */
enum ifc_outcome ifc_swept_disk(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_faces *out) TCS_CHECKED;

/* ---- ifc_sweep_curve.c --------------------------------------------------- */

/* Append the solids between copies of a section at the stations of a path. */
enum ifc_outcome ifc_sweep_along(struct ifc_shaper *shaper,
	const struct ifc_faces *section, const struct ifc_path *path,
	struct ifc_faces *out) TCS_CHECKED;

/*
 * IfcFixedReferenceSweptAreaSolid, IfcDirectrixDerivedReferenceSweptAreaSolid
 * and IfcSurfaceCurveSweptAreaSolid: the section's x axis keeps to a direction,
 * or to the normal of the surface.
 */
enum ifc_outcome ifc_swept_area(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_faces *out) TCS_CHECKED;

/* ---- ifc_sweep_taper.c --------------------------------------------------- */

/* IfcExtrudedAreaSolidTapered and IfcRevolvedAreaSolidTapered. */
enum ifc_outcome ifc_tapered(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_faces *out) TCS_CHECKED;

/* ---- ifc_sectioned.c ----------------------------------------------------- */

/*
 * IfcSectionedSolidHorizontal and IfcSectionedSpine: straight between sections
 * with the same rings. Along an alignment, what a section is off it goes evenly
 * to what the next one is.
 */
enum ifc_outcome ifc_sectioned(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_faces *out) TCS_CHECKED;

/* ---- ifc_primitive.c ----------------------------------------------------- */

/* IfcBlock, IfcRectangularPyramid, IfcSphere, IfcRightCircularCone, -Cylinder. */
enum ifc_outcome ifc_primitive(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_faces *out) TCS_CHECKED;

#endif
