/*
 * Which cells lie inside of what: how often each is wound around by the host's
 * faces and by those of all tools together.
 *
 * Stepping through a facet changes that by what the faces that cover it say. The
 * largest facets are asked first and no more than it takes to reach every cell,
 * so that what input in error says around its edges is not asked. Where large
 * facets contradict each other all the same, as between planes that all but
 * coincide, the faces' solid angles from within each cell decide.
 */
#ifndef TESSERA_SOLID_INSIDE_H
#define TESSERA_SOLID_INSIDE_H

#include "solid_carve.h"

enum { HOST, TOOLS };

/* One of the host's and one of the tools' pieces that cover a facet, those that
 * look up before those that look down; SOLID_NO_FACE: none. */
struct solid_cover {
	uint32_t pieces[2][2]; /* host or tools; looking up or down */
	int step[2]; /* what going up adds */
};

struct solid_winding {
	int times[2]; /* around the cell: host, tools */
};

/* A facet that is whole. */
struct solid_pane {
	struct tcs_point centre; /* the mean of its corners */
	double area;
	double width; /* area to circumference */
	uint32_t facet;
};

/* All zero is empty. */
struct solid_inside {
	TCS_ARRAY(struct solid_pane) panes;
	struct solid_numbers order; /* panes, the widest first, or nearly so */
	TCS_ARRAY(struct solid_cover) covers; /* of each pane */
	TCS_ARRAY(struct solid_winding) windings; /* of each cell */
	struct solid_numbers parents; /* of each cell, while it is not known */
	TCS_ARRAY(double) depths; /* of each cell: how far from its sides */
};

/*
 * All cells of a carver that is done. Loops of facets become up to date. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status solid_inside_find(struct solid_inside *inside,
	struct solid_carver *carver, struct tcs_fault *fault) TCS_CHECKED;

void solid_inside_release(struct solid_inside *inside);

#endif
