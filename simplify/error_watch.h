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
	TCS_ARRAY(uint32_t) faces; /* per face: its first point; TCS_NONE */
	TCS_ARRAY(uint32_t) next; /* per point: of the same face; TCS_NONE */
	struct triangle_tree tree; /* over the original, by component */
	TCS_ARRAY(uint32_t) roots; /* per component: in the tree */
};

/* Watch nothing, or a mesh that has not changed yet. Takes n log n steps. Fails
   with TCS_NO_MEMORY, TCS_LIMIT. */
enum tcs_status error_watch_begin(struct error_watch *watch, double limit,
	const struct component_set *set, const struct sheets *sheets,
	struct tcs_fault *fault) TCS_CHECKED;

/* Whether a vertex, whose `count` spokes are in work->spokes, may move to the
   node `target`. */
bool error_watch_allows(const struct collapses *work, uint32_t vertex,
	size_t count, uint32_t target);

/* It is about to. */
void error_watch_follow(
	struct collapses *work, uint32_t vertex, size_t count, uint32_t target);

void error_watch_release(struct error_watch *watch);

#endif
