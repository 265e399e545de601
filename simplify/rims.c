#include "rims.h"

#include <stdlib.h>

/* How far a rim may leave its plane, as a share of its width. */
#define FLATNESS 0.05

/* ---- the faces ----------------------------------------------------------- */

/* Append the edges at which a face meets others; false where it is open. */
static enum tcs_status
list_edges(struct rims *rims, const struct collapses *work, uint32_t face,
	const uint32_t *owners, bool *fine, struct tcs_fault *fault)
{
	uint32_t corners[3], across[3];

	if (!half_edges_corners(work->mesh, face, corners))
		return TCS_OK;
	half_edges_across(work->mesh, face, across);
	if (array_grow(&rims->faces, 1) || array_grow(&rims->sorted, 3))
		return fault_memory(fault);
	rims->faces.at[rims->faces.count++] = face;
	for (int k = 0; k < 3; k++) {
		if (across[k] == HALF_EDGE_NONE)
			*fine = false;
		else if (owners[across[k]] != owners[face])
			rims->sorted.at[rims->sorted.count++] =
				(struct rim_edge){corners[k],
					corners[(k + 1) % 3], across[k]};
	}
	return TCS_OK;
}

static int
by_from(const void *left, const void *right)
{
	const struct rim_edge *a = left, *b = right;

	return (a->from > b->from) - (a->from < b->from);
}

/* ---- the loops ----------------------------------------------------------- */

/* The edge that begins at a vertex, once they are sorted; NULL. */
static struct rim_edge *
edge_from(const struct rims *rims, uint32_t vertex)
{
	const struct rim_edge wanted = {.from = vertex};

	return bsearch(&wanted, rims->sorted.at, rims->sorted.count,
		sizeof *rims->sorted.at, by_from);
}

/* One loop, from an edge; what was taken has no face beyond it any more. */
static bool
walk(struct rims *rims, struct rim_edge *edge)
{
	struct rim_loop *loop = &rims->loops.at[rims->loops.count++];

	*loop = (struct rim_loop){.first = (uint32_t)rims->edges.count};
	while (edge && edge->beyond != HALF_EDGE_NONE) {
		rims->edges.at[rims->edges.count++] = *edge;
		edge->beyond = HALF_EDGE_NONE;
		loop->count++;
		edge = edge_from(rims, edge->to);
	}
	return edge && edge->from == rims->edges.at[loop->first].from &&
		loop->count >= 3;
}

static enum tcs_status
find_loops(struct rims *rims, bool *fine, struct tcs_fault *fault)
{
	size_t count = rims->sorted.count;

	if (array_grow(&rims->edges, count) || array_grow(&rims->loops, count))
		return fault_memory(fault);
	*fine = count > 0;
	if (*fine)
		qsort(rims->sorted.at, count, sizeof *rims->sorted.at, by_from);
	for (size_t i = 1; *fine && i < count; i++)
		*fine = rims->sorted.at[i].from != rims->sorted.at[i - 1].from;
	for (size_t i = 0; *fine && i < count; i++)
		if (rims->sorted.at[i].beyond != HALF_EDGE_NONE)
			*fine = walk(rims, &rims->sorted.at[i]);
	return TCS_OK;
}

/* ---- the caps ------------------------------------------------------------ */

/* Whether two vertices have an edge that is not between faces of the set. */
static enum tcs_status
are_joined(struct collapses *work, uint32_t a, uint32_t b,
	const uint32_t *owners, uint32_t owner, bool *joined,
	struct tcs_fault *fault)
{
	size_t count;
	enum tcs_status status = spokes_of(work, a, &count, fault);

	for (size_t i = 0; !status && i < count; i++) {
		uint32_t left = work->spokes.at[i].face;
		uint32_t right = work->spokes.at[i ? i - 1 : count - 1].face;

		if (work->spokes.at[i].to == b &&
			(left == HALF_EDGE_NONE || owners[left] != owner ||
				right == HALF_EDGE_NONE ||
				owners[right] != owner))
			*joined = true;
	}
	return status;
}

/* A cap's triangle: three corners of the loop, counted from its first. */
static enum tcs_status
add_triangle(struct rims *rims, struct collapses *work,
	const struct rim_loop *loop, const uint32_t own[3],
	const uint32_t *owners, bool *fine, struct tcs_fault *fault)
{
	const struct rim_edge *edges = rims->edges.at + loop->first;
	uint32_t owner = owners[rims->faces.at[0]];
	enum tcs_status status = TCS_OK;

	if (array_grow(&rims->corners, 3) || array_grow(&rims->beyond, 1))
		return fault_memory(fault);
	rims->beyond.at[rims->beyond.count++] = edges[0].beyond;
	for (int k = 0; k < 3; k++) {
		uint32_t to = own[(k + 1) % 3];
		bool joined = false;

		rims->corners.at[rims->corners.count++] = edges[own[k]].from;
		if (to == (own[k] + 1) % loop->count)
			continue;
		if (!status && *fine)
			status = are_joined(work, edges[own[k]].from,
				edges[to].from, owners, owner, &joined, fault);
		*fine = *fine && !joined;
	}
	return status;
}

/* Three edges with one face beyond them all: nothing would be left. */
static bool
is_last(const struct rim_edge *edges, uint32_t count)
{
	return count == 3 && edges[0].beyond == edges[1].beyond &&
		edges[0].beyond == edges[2].beyond;
}

static enum tcs_status
close_loop(struct rims *rims, struct collapses *work, struct rim_loop *loop,
	const uint32_t *owners, bool *fine, struct tcs_fault *fault)
{
	const struct rim_edge *edges = rims->edges.at + loop->first;
	struct triangulation flat;
	enum tcs_status status;

	rims->points.count = 0;
	if (array_grow(&rims->points, loop->count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < loop->count; i++)
		rims->points.at[rims->points.count++] =
			work->positions.at[node_of(work, edges[i].from)];
	status = triangulate(rims->triangulator, rims->points.at, &loop->count,
		1, &flat, fault);
	if (status)
		return status;
	*fine = flat.outcome == TRIANGULATION_WHOLE && flat.extra_count == 0 &&
		flat.triangle_count + 2 == loop->count &&
		flat.flatness <= FLATNESS * sqrt(flat.area) &&
		!is_last(edges, loop->count);
	loop->normal = flat.normal;
	for (size_t i = 0; !status && *fine && i < flat.triangle_count; i++)
		status = add_triangle(rims, work, loop,
			flat.triangles[i].corner, owners, fine, fault);
	return status;
}

static enum tcs_status
close_loops(struct rims *rims, struct collapses *work, const uint32_t *owners,
	bool *fine, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (!rims->triangulator)
		rims->triangulator = triangulator_new();
	if (!rims->triangulator)
		return fault_memory(fault);
	for (size_t i = 0; !status && *fine && i < rims->loops.count; i++)
		status = close_loop(
			rims, work, &rims->loops.at[i], owners, fine, fault);
	return status;
}

enum tcs_status
rims_find(struct rims *rims, struct collapses *work, const uint32_t *faces,
	size_t count, const uint32_t *owners, bool *fine,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	*fine = true;
	rims->faces.count = rims->edges.count = rims->loops.count = 0;
	rims->corners.count = rims->beyond.count = rims->sorted.count = 0;
	for (size_t i = 0; !status && *fine && i < count; i++)
		status = list_edges(rims, work, faces[i], owners, fine, fault);
	if (!status && *fine)
		status = find_loops(rims, fine, fault);
	if (!status && *fine)
		status = close_loops(rims, work, owners, fine, fault);
	return status;
}

void
rims_release(struct rims *rims)
{
	triangulator_free(rims->triangulator);
	rims->triangulator = NULL;
	array_release(&rims->faces);
	array_release(&rims->edges);
	array_release(&rims->loops);
	array_release(&rims->corners);
	array_release(&rims->beyond);
	array_release(&rims->points);
	array_release(&rims->sorted);
}
