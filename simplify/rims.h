/*
 * A set of faces of the mesh as it is now, the loops at which it meets the
 * rest, and the flat triangles that close the part without it.
 */
#ifndef TESSERA_RIMS_H
#define TESSERA_RIMS_H

#include "collapses.h"
#include "triangulate.h"

/* An edge at which a face of the set meets another. */
struct rim_edge {
	uint32_t from, to; /* vertices, as the face of the set has them */
	uint32_t beyond; /* face */
};

struct rim_loop {
	uint32_t first, count; /* of `edges`, one after the other */
	struct tcs_point normal; /* of the cap; of length 1 */
};

/* All zero is empty; reused from set to set. */
struct rims {
	struct triangulator *triangulator;
	TCS_ARRAY(uint32_t) faces; /* those that are there */
	TCS_ARRAY(struct rim_edge) edges; /* loop by loop */
	TCS_ARRAY(struct rim_loop) loops;
	TCS_ARRAY(uint32_t) corners; /* of the caps: vertices */
	TCS_ARRAY(uint32_t) beyond; /* per triangle of them: a face beyond */
	TCS_ARRAY(struct tcs_point) points; /* scratch */
	TCS_ARRAY(struct rim_edge) sorted; /* scratch */
};

/*
 * Look at the faces of a list, all of one number in `owners`. *fine if they can
 * be replaced: something is left, nothing is open, the loops pass no vertex
 * twice and are flat, and no edge of the caps is there already. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status rims_find(struct rims *rims, struct collapses *work,
	const uint32_t *faces, size_t count, const uint32_t *owners, bool *fine,
	struct tcs_fault *fault) TCS_CHECKED;

void rims_release(struct rims *rims);

#endif
