/*
 * Cutting a box into cells until no piece of a face lies within any of them.
 */
#ifndef TESSERA_SOLID_CARVE_H
#define TESSERA_SOLID_CARVE_H

#include "solid_cells.h"
#include "solid_pieces.h"

enum { SOLID_MOST_CELLS = 1 << 19 };

/* A cell to be cut, and where its items start; they end where those of the next
 * one start. */
struct solid_job {
	uint32_t cell;
	size_t first_item, first_point;
};

/* All zero is empty. */
struct solid_carver {
	struct solid_planes planes;
	struct solid_cells cells;
	struct solid_pieces pieces;
	struct solid_numbers covers; /* pieces in the plane of a facet that may
	                                cover it, by its first_cover */
	TCS_ARRAY(struct solid_job) jobs;
	struct solid_items items, below, above;
	bool too_many; /* cells: given up */
};

/*
 * Forget everything and make a box: from now on lengths are relative to an
 * origin that is near it, which coordinates of like size survive. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status solid_carve_begin(struct solid_carver *carver,
	struct tcs_point lower, struct tcs_point upper, double tolerance,
	struct tcs_fault *fault) TCS_CHECKED;

/* Give the box all pieces that reach into it or lie in its sides. Fails with
 * TCS_NO_MEMORY. */
enum tcs_status solid_carve_fill(
	struct solid_carver *carver, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Cut the box, which is whole or what earlier calls left of it, by a plane and
 * give what lies on one side of it (1 or -1) to the outside. *empty: nothing is
 * left. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_carve_drop(struct solid_carver *carver, uint32_t plane,
	int side, bool *empty, struct tcs_fault *fault) TCS_CHECKED;

/* Cut until nothing is to be cut, or there are too many cells. Fails with
 * TCS_NO_MEMORY. */
enum tcs_status solid_carve(
	struct solid_carver *carver, struct tcs_fault *fault) TCS_CHECKED;

void solid_carver_release(struct solid_carver *carver);

#endif
