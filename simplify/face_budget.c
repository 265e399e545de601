#include "face_budget.h"

#include <math.h>
#include <stdlib.h>

/* Cosine beyond which two lines run straight on into each other. */
#define STRAIGHT 0.996 /* 5 degrees */

/* What meets in a node. */
struct meeting {
	struct tcs_point first; /* direction of the first line */
	uint32_t edges, lines;
	bool bends;
};

static bool
is_line(const struct collapses *work, uint32_t corner, uint32_t back)
{
	const struct sheets *sheets = work->sheets;
	uint32_t a = sheets->face_triangles.at[corner / 3];
	uint32_t b = sheets->face_triangles.at[back / 3];

	return edge_is_sharp(work, corner) ||
		work->set->features.at[a] != work->set->features.at[b];
}

static void
meet(struct meeting *at, struct tcs_point along, bool line)
{
	double length = vector_length(along);

	at->edges++;
	if (!line || !(length > 0))
		return;
	along = vector_scaled(along, 1 / length);
	if (!at->lines++)
		at->first = along;
	else
		at->bends |= vector_dot(at->first, along) > -STRAIGHT;
}

static void
count_edge(const struct collapses *work, uint32_t corner,
	struct structure_counts *out, struct meeting *meetings)
{
	const struct sheets *sheets = work->sheets;
	uint32_t back = sheets->opposites.at[corner];
	uint32_t next = corner % 3 == 2 ? corner - 2 : corner + 1;
	uint32_t from = node_of(work, sheets->corners.at[corner]);
	uint32_t to = node_of(work, sheets->corners.at[next]);
	struct tcs_point along = vector_difference(
		work->positions.at[to], work->positions.at[from]);
	bool open = back == HALF_EDGE_NONE, line;

	if (!open && back < corner)
		return;
	line = !open && is_line(work, corner, back);
	out->open_edges += open;
	out->lines += line;
	meet(&meetings[from], along, line);
	meet(&meetings[to], vector_scaled(along, -1), line);
}

enum tcs_status
structure_count(const struct collapses *work, struct structure_counts *out,
	struct tcs_fault *fault)
{
	size_t nodes = work->sheets->node_count;
	struct meeting *meetings = calloc(nodes + 1, sizeof *meetings);

	*out = (struct structure_counts){0};
	if (!meetings)
		return fault_memory(fault);
	for (uint32_t i = 0; i < work->sheets->corners.count; i++)
		count_edge(work, i, out, meetings);
	for (size_t i = 0; i < nodes; i++)
		out->corners += meetings[i].edges >= 3 && meetings[i].bends;
	free(meetings);
	return TCS_OK;
}

enum tcs_status
face_budget_find(const struct face_budget *budget, const struct collapses *work,
	size_t *faces, struct tcs_fault *fault)
{
	double all = (double)work->set->triangles.count, kept = budget->amount;
	struct structure_counts counts;
	enum tcs_status status = TCS_OK;

	if (budget->kind == BUDGET_RATE)
		kept = ceil(all * (1 - budget->amount));
	if (budget->kind == BUDGET_ERROR)
		kept = 0;
	if (budget->kind == BUDGET_STRUCTURE) {
		status = structure_count(work, &counts, fault);
		kept = floor(budget->amount *
			(double)(counts.open_edges + counts.lines +
				counts.corners));
	}
	*faces = (size_t)fmin(kept, all);
	return status;
}
