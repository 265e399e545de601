/*
 * A box cut by planes into convex cells that share their facets, edges and
 * corners: where a cell is cut, what its neighbours share with it is cut as
 * well. So no corner ever lies within an edge or a facet.
 *
 * What is cut is kept and points to its two halves. A cell keeps its number for
 * the half below the plane, the side its normal does not point to.
 */
#ifndef TESSERA_SOLID_CELLS_H
#define TESSERA_SOLID_CELLS_H

#include "array.h"
#include "fault.h"
#include "solid_planes.h"

#define SOLID_OUTSIDE UINT32_MAX /* the cell around the box */

/* On the line of two planes. */
struct solid_edge {
	uint32_t from, to; /* corners */
	uint32_t planes[2];
	uint32_t half; /* the edge at `from`; the next is that at `to`; or 0 */
};

/* A convex polygon. */
struct solid_facet {
	uint32_t plane;
	uint32_t cells[2]; /* below the plane, above it */
	uint32_t half; /* the facet below what cut it, the next above; or 0 */
	uint32_t first, count; /* in loops, counterclockwise from above */
	uint32_t first_cover, cover_count; /* the caller's, inherited */
};

struct solid_cell {
	uint32_t first, count; /* in shells: facets, perhaps cut by now */
};

TCS_ARRAY_TYPE(solid_corners, struct solid_corner);

/* All zero is empty. */
struct solid_cells {
	struct solid_plane_list *planes; /* the caller's */
	struct solid_corners corners;
	TCS_ARRAY(struct solid_edge) edges;
	TCS_ARRAY(struct solid_facet) facets;
	TCS_ARRAY(struct solid_cell) cells;
	struct solid_numbers loops; /* of facets: 2 × edge, + 1 where it is run
	                               against its direction */
	struct solid_numbers shells; /* of cells: facets */
	/* Of the cut under way: */
	TCS_ARRAY(signed char) sides; /* of each corner */
	struct solid_numbers marks; /* the cut in which it was found */
	struct solid_numbers links; /* the edge from it around the new facet */
	struct solid_numbers stack, shell, below, above;
	uint32_t mark;
};

/* Make one cell, number 0, of six planes: lower x, upper x, lower y, …, whose
 * normals are the axes. Fails with TCS_NO_MEMORY. */
enum tcs_status solid_cells_begin(struct solid_cells *cells,
	struct solid_plane_list *planes, const uint32_t box[6],
	struct tcs_fault *fault) TCS_CHECKED;
void solid_cells_release(struct solid_cells *cells);

/*
 * Cut a cell by a plane. *side is 1 or -1 where the cell lies above or below
 * it as a whole; else it is 0, the half above is a new cell, the last, and the
 * facet between is the last facet. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_cells_cut(struct solid_cells *cells, uint32_t cell,
	uint32_t plane, int *side, struct tcs_fault *fault) TCS_CHECKED;

/* Bring a facet's loop up to date with the cuts of its edges. Fails with
 * TCS_NO_MEMORY. */
enum tcs_status solid_cells_loop(struct solid_cells *cells, uint32_t facet,
	struct tcs_fault *fault) TCS_CHECKED;

/* The corner that an entry of a loop starts from. */
static inline uint32_t
solid_loop_corner(const struct solid_cells *cells, uint32_t entry)
{
	const struct solid_edge *edge = &cells->edges.at[entry >> 1];

	return entry & 1 ? edge->to : edge->from;
}

#endif
