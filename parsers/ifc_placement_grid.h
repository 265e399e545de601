/*
 * Placements on the axes of a grid.
 *
 * source: IfcGridPlacement, IfcVirtualGridIntersection, IfcGridAxis (ISO
 * 16739-1 5.4.3, 8.7).
 */
#ifndef TESSERA_IFC_PLACEMENT_GRID_H
#define TESSERA_IFC_PLACEMENT_GRID_H

#include "ifc_shape.h"

/*
 * The matrix of an IfcGridPlacement within its grid: where two axes meet, moved
 * by the offsets. The x axis leads to another such place, or is the direction
 * given, or that of the first axis; z is the grid's. NULL, or why there is
 * none.
 */
const char *ifc_grid_matrix(
	struct ifc_shaper *shaper, uint32_t placement, struct ifc_matrix *out);

/* The object placement of the grid that a grid placement is on; STEP_NONE. */
uint32_t ifc_grid_placement_of(const struct ifc_file *file, uint32_t placement);

#endif
