/*
 * How far a simplified surface may be from what it was.
 *
 * Two distances are kept under the limit: that of the original's vertices, edge
 * middles and triangle centres from the faces that took their place, and that
 * of the faces a collapse changes, at the centre and along their new edges,
 * from the surface their component had. Both are from point to surface and to
 * the original, so nothing adds up over the steps. Between those points a face
 * may be off by more: twice the limit, or the limit and a centimetre, bounds
 * the distance of the two surfaces for what buildings are made of.
 */
#ifndef TESSERA_ERROR_WATCH_H
#define TESSERA_ERROR_WATCH_H

#include "sheets.h"

struct collapses;

/* All zero is empty; reused from object to object. */
struct error_watch {
	double limit; /* metres; INFINITY: nothing is watched */
	bool paused; /* for those who watch two rings as one */
	TCS_ARRAY(uint32_t) faces; /* per face: its first point; TCS_NONE */
	/* Per point: the next of the same face; TCS_NONE; a vertex that is still
	   there: itself. */
	TCS_ARRAY(uint32_t) next;
	struct triangle_tree tree; /* over the original, by component */
	TCS_ARRAY(uint32_t) roots; /* per component: in the tree */
};

/* Watch nothing, or a mesh that has not changed yet. Takes n log n steps. Fails
   with TCS_NO_MEMORY, TCS_LIMIT. */
enum tcs_status error_watch_begin(struct error_watch *watch, double limit,
	const struct component_set *set, const struct sheets *sheets,
	struct tcs_fault *fault) TCS_CHECKED;

/* The faces around a vertex. */
struct watch_ring {
	uint32_t vertex;
	const struct spoke *spokes;
	size_t count;
	uint32_t without; /* node: faces that have it, too, go */
};

/* Whether all faces of the rings that stay may have their vertices at `place`
   instead. */
bool error_watch_allows(const struct collapses *work,
	const struct watch_ring *rings, size_t count, struct tcs_point place);

/* They are about to. */
void error_watch_follow(struct collapses *work, const struct watch_ring *rings,
	size_t count, struct tcs_point place);

void error_watch_release(struct error_watch *watch);

#endif
