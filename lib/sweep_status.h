/*
 * The status of a plane sweep over a polygon: the intervals inside it that a
 * line parallel to the y axis meets, from below upwards.
 *
 * A splay tree with the neighbours linked: any run of n operations takes
 * n log n steps.
 *
 * source: D. D. Sleator and R. E. Tarjan, Self-adjusting binary search trees,
 * 1985.
 */
#ifndef TESSERA_SWEEP_STATUS_H
#define TESSERA_SWEEP_STATUS_H

#include <stdint.h>

#include "planar.h"

/* Intervals are numbers from 1; 0 is none. */
struct sweep_interval {
	uint32_t lower, upper; /* edges of the polygon */
	uint32_t head, tail, latest; /* the sweep's chain of vertices */
	uint32_t below, above; /* neighbours */
	uint32_t left, right, parent; /* of the tree */
};

struct sweep_status {
	TCS_ARRAY(struct sweep_interval) intervals;
	uint32_t root;
};

/* Where a point lies. */
struct sweep_place {
	uint32_t in; /* the interval around it */
	uint32_t below, above; /* else its neighbours */
	bool on_edge; /* it touches an edge; the rest is void */
};

/* Empty the status and make room for so many intervals over its life. */
enum tcs_status status_begin(struct sweep_status *status, size_t most,
	struct tcs_fault *fault) TCS_CHECKED;

struct sweep_place status_find(struct sweep_status *status,
	const struct planar *polygon, struct planar_point at);

/* A new interval above `below`, of which `above` is the neighbour. */
uint32_t status_insert(
	struct sweep_status *status, uint32_t below, uint32_t above);

void status_remove(struct sweep_status *status, uint32_t interval);

void status_release(struct sweep_status *status);

#endif
