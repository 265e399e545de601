/*
 * What hangs on a flat face of a part, inside of its outline, and what it costs
 * to do without: a hole that goes through a wall, a recess, something that
 * stands out. No collapse can take it away, for it is part of the topology or
 * of the outline; but once its faces are gone, flat triangles over their rims
 * close the part again, and what is left of the rims collapses for nothing.
 *
 * A handle costs what its faces and those over its rims are off, times their
 * area; whatever stood in a hole does not come apart from what encloses it now.
 * It comes forward and is seen as before (panels.h); what cannot, costs a share
 * of what a contact does.
 *
 * source: J. El-Sana, A. Varshney, Topology simplification for polygonal
 * virtual environments, 1998, for the operation; finding it by inner outlines
 * of flat faces and the cost are ours.
 */
#ifndef TESSERA_HANDLES_H
#define TESSERA_HANDLES_H

#include "panels.h"

struct handle {
	uint32_t first, count; /* of `faces`: as the mesh came */
	uint32_t part;
};

/* All zero is empty; reused from object to object. */
struct handles {
	TCS_ARRAY(struct handle) at;
	TCS_ARRAY(uint32_t) faces; /* handle by handle */
	/* Per face: its handle, or TCS_NONE; empty where there is none. */
	TCS_ARRAY(uint32_t) owners;
	struct node_queue queue; /* of handles, by their price */
	struct rims rims; /* scratch */
	struct component_set *set; /* borrowed: boxes grow */
	struct collapses *work; /* borrowed */
	struct removals *removals; /* borrowed */
	TCS_ARRAY(uint32_t) hidden; /* scratch: parts */
	TCS_ARRAY(uint32_t) left; /* scratch: those that stay parts */
	struct panels panels; /* scratch */
	TCS_ARRAY(uint32_t) held; /* scratch: contacts, one per point held */
	size_t closed; /* since it was set to 0 */
};

/*
 * List the handles of a mesh nothing of which is collapsed, and whose removals
 * have begun. The set is that of `work`. Takes n log n steps. Fails with TCS_NO_MEMORY.
 */
enum tcs_status handles_find(struct handles *handles, struct component_set *set,
	struct collapses *work, struct removals *removals,
	struct tcs_fault *fault) TCS_CHECKED;

/* What the next one costs per collapse that it saves, at least; INFINITY when
   none is left. */
double handles_next_cost(const struct handles *handles);

/*
 * Look closer at the next one: close it if it costs what it seemed to; else it
 * is dearer from then on. Fails with TCS_NO_MEMORY, TCS_SYSTEM.
 */
enum tcs_status handles_try(
	struct handles *handles, struct tcs_fault *fault) TCS_CHECKED;

void handles_release(struct handles *handles);

#endif
