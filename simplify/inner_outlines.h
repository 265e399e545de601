/*
 * The inner outlines of the flat faces of a mesh, and what they cut off.
 *
 * Triangles that lie in one plane and are joined are a flat face; it has one
 * outer outline, and an inner one wherever something goes through it, recedes
 * behind it or stands out from it. Cut along all inner outlines a mesh falls
 * into pieces. What is left of a wall with a window cut out is one piece, and
 * the reveal of the window another.
 */
#ifndef TESSERA_INNER_OUTLINES_H
#define TESSERA_INNER_OUTLINES_H

#include "component_set.h"
#include "sheets.h"

struct inner_outlines {
	/* Per face: the piece that it is of, as its least face; none where
	   there is no inner outline. */
	TCS_ARRAY(uint32_t) pieces;
	/* The same, for a piece's least one: the piece with the flat faces
	   whose inner outlines bound it; TCS_NONE: there are none or several,
	   or it bounds others in this way itself. */
	TCS_ARRAY(uint32_t) hosts;
	TCS_ARRAY(uint32_t) flats; /* per face: the first of its flat face */
	TCS_ARRAY(uint32_t) outlines; /* corners: one of every inner outline */
	TCS_ARRAY(bool) cut; /* per corner: its edge is of an inner outline */
	TCS_ARRAY(uint32_t) stack; /* scratch */
};

/* Of a mesh as it came. Takes n steps, nearly. Fails with TCS_NO_MEMORY. */
enum tcs_status inner_outlines_find(struct inner_outlines *outlines,
	const struct component_set *set, const struct sheets *sheets,
	struct tcs_fault *fault) TCS_CHECKED;

void inner_outlines_release(struct inner_outlines *outlines);

#endif
