/*
 * Bodies as geometries of an object: placed, scaled to metres, triangulated.
 */
#ifndef TESSERA_IFC_POLYGONS_H
#define TESSERA_IFC_POLYGONS_H

#include "ifc_item.h"
#include "report.h"
#include "triangulate.h"

/* Where a body goes. */
struct ifc_target_feature {
	const struct ifc_matrix *matrix; /* into the stream's coordinates */
	uint32_t feature;
	uint8_t lod;
	const char *id; /* for the report */
};

/*
 * Append the geometries of a body: one of its solids, one of its surfaces. A
 * face without area is left out, and counted. Fails with TCS_NO_MEMORY.
 */
enum tcs_status ifc_polygons_add(struct triangulator *triangulator,
	const struct ifc_body *body, const struct ifc_target_feature *target,
	struct tcs_object *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
