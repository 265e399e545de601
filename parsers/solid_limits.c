#include <stdlib.h>

#include "solid_cutter.h"

/* An edge of a piece. */
struct piece_edge {
	uint32_t low, high; /* points by number */
	int forward; /* 1: from low to high; -1 */
	uint32_t piece, from, to; /* points of the piece */
};

TCS_ARRAY_TYPE(piece_edges, struct piece_edge);

static int
edge_order(const void *left, const void *right)
{
	const struct piece_edge *a = left, *b = right;

	if (a->low != b->low)
		return a->low < b->low ? -1 : 1;
	return (a->high > b->high) - (a->high < b->high);
}

static void
edges_collect(const struct solid_pieces *pieces, const uint32_t *numbers,
	struct piece_edges *edges)
{
	for (uint32_t i = 0; i < pieces->list.count; i++) {
		const struct solid_piece *piece = &pieces->list.at[i];

		for (uint32_t j = 0; j < piece->count; j++) {
			uint32_t from = piece->first + j;
			uint32_t to = piece->first + (j + 1) % piece->count;
			uint32_t a = numbers[from], b = numbers[to];

			edges->at[edges->count++] = (struct piece_edge){
				a < b ? a : b, a < b ? b : a, a < b ? 1 : -1, i,
				from, to};
		}
	}
}

/* A narrow rectangle upright on the piece's edge. */
static enum tcs_status
limit_add(struct solid_cutter *cutter, const struct piece_edge *edge,
	struct tcs_fault *fault)
{
	struct solid_pieces *pieces = &cutter->carver.pieces;
	struct solid_planes *planes = &cutter->carver.planes;
	struct tcs_point up =
		planes->list.at[pieces->list.at[edge->piece].plane].normal;
	struct tcs_point a = pieces->points.at[edge->from];
	struct tcs_point b = pieces->points.at[edge->to];
	double height = 16 * cutter->tolerance;
	struct solid_piece limit = {.face = SOLID_NO_FACE};
	struct tcs_point square[4];
	int side;
	enum tcs_status status;

	up = (struct tcs_point){up.x * height, up.y * height, up.z * height};
	square[0] = point_minus(a, up);
	square[1] = point_minus(b, up);
	square[2] = point_plus(b, up);
	square[3] = point_plus(a, up);
	status = solid_planes_find(
		planes, square, 4, 4, &limit.plane, &side, fault);
	return status || !side
		? status
		: solid_piece_add(pieces, &limit, square, 4, fault);
}

static enum tcs_status
limits_add(struct solid_cutter *cutter, const struct piece_edges *edges,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	size_t end;

	for (size_t i = 0; !status && i < edges->count; i = end) {
		long balance = 0;

		for (end = i; end < edges->count &&
			!edge_order(&edges->at[i], &edges->at[end]);
			end++)
			balance += edges->at[end].forward;
		if (balance)
			status = limit_add(cutter, &edges->at[i], fault);
	}
	return status;
}

enum tcs_status
solid_limits_add(struct solid_cutter *cutter, struct tcs_fault *fault)
{
	const struct solid_pieces *pieces = &cutter->carver.pieces;
	struct piece_edges edges = {0};
	enum tcs_status status = solid_points_number(&cutter->edge_points,
		pieces->points.at, pieces->points.count, fault);

	if (!status && array_grow(&edges, pieces->points.count))
		status = fault_memory(fault);
	if (!status && pieces->points.count) {
		edges_collect(pieces, cutter->edge_points.numbers.at, &edges);
		qsort(edges.at, edges.count, sizeof *edges.at, edge_order);
		status = limits_add(cutter, &edges, fault);
	}
	array_release(&edges);
	return status;
}
