/*
 * Collapses that are done only if nothing cheaper is left.
 *
 * The source compares the normal of each face around a collapse, and the area
 * of all of them, before and after: past a threshold it adds a penalty of 200
 * and forbids the collapse. Both cannot be meant. Here the cost is multiplied
 * by 200 past the thresholds below, which it does not tell, and what
 * collapse_check.c says is forbidden.
 *
 * source: L, validation (Liu, Li, Zhao, Liu, Texture feature preserving
 * simplification).
 */
#include "collapses.h"

#define MOST_GROWTH 4.0 /* of the area of all, either way */

/* Twice the area of the faces around a vertex, as they are. */
static enum tcs_status
area_around(struct collapses *work, uint32_t vertex, double *area,
	struct tcs_fault *fault)
{
	struct triangle_shape shape;
	size_t count;
	enum tcs_status status = spokes_of(work, vertex, &count, fault);

	shape.corner[0] = work->positions.at[node_of(work, vertex)];
	for (size_t i = 0; !status && i < count; i++) {
		const struct spoke *spoke = &work->spokes.at[i];
		const struct spoke *next =
			&work->spokes.at[i + 1 < count ? i + 1 : 0];

		if (spoke->face == HALF_EDGE_NONE)
			continue;
		shape.corner[1] = work->positions.at[node_of(work, spoke->to)];
		shape.corner[2] = work->positions.at[node_of(work, next->to)];
		*area += vector_length(triangle_normal(&shape));
	}
	return status;
}

enum tcs_status
collapse_is_strained(struct collapses *work, uint32_t node, bool *strained,
	struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	double before = 0, after = 0;
	enum tcs_status status = TCS_OK;

	*strained = false;
	for (size_t i = 0; !*strained && i < work->ring.count; i++) {
		struct triangle_shape shape = work->ring.at[i].shape;
		struct tcs_point normal = triangle_normal(&shape);

		shape.corner[0] = work->positions.at[node];
		*strained = vector_dot(triangle_normal(&shape), normal) < 0;
		after += vector_length(normal);
	}
	for (uint32_t v = fans[0].first_vertex;
		!status && !*strained && v < fans[1].first_vertex; v++)
		status = area_around(work, v, &before, fault);
	if (!*strained)
		*strained = after > MOST_GROWTH * before ||
			before > MOST_GROWTH * after;
	return status;
}
