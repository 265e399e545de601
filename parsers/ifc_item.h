/*
 * Representation items as faces: the one entry for all of them, and the files
 * that each know a kind.
 *
 * source: ISO 16739-1 8.8 (geometric models), 8.9 (geometry), 8.17 (topology).
 */
#ifndef TESSERA_IFC_ITEM_H
#define TESSERA_IFC_ITEM_H

#include "ifc_shape.h"

enum ifc_part_kind {
	IFC_PART_SOLID, /* faces that enclose a solid, looking outwards */
	IFC_PART_VOID, /* … a void of the solid before, looking into it */
	IFC_PART_SURFACE, /* faces that need not enclose anything */
};

/* The faces from here to the next part's. */
struct ifc_part {
	uint32_t first_face;
	enum ifc_part_kind kind;
	uint32_t item; /* the instance */
};

/* What a representation becomes; all zero is empty. */
struct ifc_body {
	struct ifc_faces faces;
	TCS_ARRAY(struct ifc_part) parts;
};

/* What is to be said about a product that was shaped all the same. */
struct ifc_remark {
	uint32_t instance;
	enum report_severity severity;
	const char *reason; /* static text */
};

struct solid_cutter;

/* One shaper's memory for steps in between, reused. */
struct ifc_scratch {
	struct ifc_faces profile;
	struct ifc_points points;
	struct solid_cutter *cutter; /* NULL until something is cut */
	TCS_ARRAY(struct ifc_remark) remarks; /* about this product */
};

enum tcs_status ifc_scratch_new(
	struct ifc_scratch **out, struct tcs_fault *fault) TCS_CHECKED;
void ifc_scratch_free(struct ifc_scratch *scratch);

void ifc_body_clear(struct ifc_body *body);
void ifc_body_release(struct ifc_body *body);

/* Take back the parts from `first_part` on, with their faces. */
void ifc_body_cut(struct ifc_body *body, size_t first_part);

/* Where the faces of a part end. */
size_t ifc_part_end(const struct ifc_body *body, size_t part);

/* The part behind a solid's voids, which belong to it, or behind any other. */
size_t ifc_solid_end(const struct ifc_body *body, size_t part);

/* Begin a part behind the faces there are. */
enum ifc_outcome ifc_part_begin(struct ifc_body *body, enum ifc_part_kind kind,
	uint32_t item) TCS_CHECKED;

/*
 * Append the parts of a representation item, painted with its style and those
 * of the items within it. Curves and points, which have no faces, append
 * nothing; so a GeometricSet gives its surfaces only.
 */
enum ifc_outcome ifc_item_body(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* ---- ifc_sweep.c --------------------------------------------------------- */

/* IfcExtrudedAreaSolid. */
enum ifc_outcome ifc_extrusion(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* IfcRevolvedAreaSolid. */
enum ifc_outcome ifc_revolution(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* ---- ifc_brep.c ---------------------------------------------------------- */

/* IfcFacetedBrep and IfcAdvancedBrep, with voids or not. */
enum ifc_outcome ifc_brep(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* IfcFaceBasedSurfaceModel and IfcShellBasedSurfaceModel. */
enum ifc_outcome ifc_surface_model(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* An IfcFace that is an item by itself, as in a topology representation. */
enum ifc_outcome ifc_lone_face(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* ---- ifc_faceset.c ------------------------------------------------------- */

/* IfcPolygonalFaceSet and IfcTriangulatedFaceSet. */
enum ifc_outcome ifc_faceset(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* ---- ifc_boolean.c ------------------------------------------------------- */

/*
 * IfcBooleanResult: one part, which is a surface where the first operand is no
 * closed solid; none where nothing is left.
 */
enum ifc_outcome ifc_boolean(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

/* ---- ifc_mapped.c -------------------------------------------------------- */

/*
 * What an IfcMappedItem maps: the representation, and the matrix from its
 * coordinates to the item's.
 */
enum ifc_outcome ifc_mapped_read(struct ifc_shaper *shaper, uint32_t item,
	uint32_t *representation, struct ifc_matrix *matrix) TCS_CHECKED;

/* IfcMappedItem, baked. */
enum ifc_outcome ifc_mapped(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_body *out) TCS_CHECKED;

#endif
