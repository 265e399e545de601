/*
 * Where the one vertex that is left of an edge goes.
 *
 * By half-edge collapse it is one of the two, and stays where it was. Optimal
 * placement puts it where the sum of both error quadrics is least, or, where
 * that is no single point or lies farther from the middle of the edge than the
 * edge is long, at the best of both ends and the middle. What touches another
 * component is never moved: vertices that lie on one, and those around faces
 * that one touches. Nor are vertices on a rim, and twins.
 *
 * source: L, cost and position (Liu, Li, Zhao, Liu, Texture feature preserving
 * simplification); M. Garland, P. Heckbert, 1997.
 */
#ifndef TESSERA_PLACEMENT_H
#define TESSERA_PLACEMENT_H

#include "collapses.h"

/* Per node: whether its place is fixed by the mesh. Fails with
   TCS_NO_MEMORY. */
enum tcs_status placement_begin(
	struct collapses *work, struct tcs_fault *fault) TCS_CHECKED;

/* As collapse_cost. */
double placement_cost(const struct collapses *work, uint32_t node,
	uint32_t target, double bound);

/* As collapse_cheapest. */
struct queue_entry placement_cheapest(
	const struct collapses *work, uint32_t node, size_t count);

/* As collapse_check and collapse_do. Fail with TCS_NO_MEMORY. */
enum tcs_status placement_check(struct collapses *work, uint32_t node,
	uint32_t target, bool *fine, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status placement_do(struct collapses *work, uint32_t node,
	uint32_t target, struct tcs_fault *fault) TCS_CHECKED;

#endif
