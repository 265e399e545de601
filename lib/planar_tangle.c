#include <stdlib.h>

#include "planar.h"

struct box {
	double low, high; /* of x */
	uint32_t edge;
};

TCS_ARRAY_TYPE(box_list, struct box);

static int
compare(const void *a, const void *b)
{
	const struct box *left = a, *right = b;

	if (left->low != right->low)
		return left->low < right->low ? -1 : 1;
	return (left->edge > right->edge) - (left->edge < right->edge);
}

static bool
edges_meet(const struct planar *polygon, uint32_t a, uint32_t b)
{
	const struct planar_point *points = polygon->points.at;
	struct planar_point a0 = points[a], a1 = points[polygon->next.at[a]];
	struct planar_point b0 = points[b], b1 = points[polygon->next.at[b]];

	if (fmax(a0.y, a1.y) < fmin(b0.y, b1.y) ||
		fmax(b0.y, b1.y) < fmin(a0.y, a1.y))
		return false;
	if (polygon->next.at[a] == b || polygon->next.at[b] == a)
		return false;
	return planar_orient(a0, a1, b0) * planar_orient(a0, a1, b1) <= 0 &&
		planar_orient(b0, b1, a0) * planar_orient(b0, b1, a1) <= 0;
}

static enum tcs_status
boxes_sort(const struct planar *polygon, struct box_list *boxes,
	struct tcs_fault *fault)
{
	if (array_grow(boxes, polygon->kept.count))
		return fault_memory(fault);
	for (size_t i = 0; i < polygon->kept.count; i++) {
		uint32_t edge = polygon->kept.at[i];
		double from = polygon->points.at[edge].x;
		double to = polygon->points.at[polygon->next.at[edge]].x;

		boxes->at[boxes->count++] =
			(struct box){fmin(from, to), fmax(from, to), edge};
	}
	qsort(boxes->at, boxes->count, sizeof *boxes->at, compare);
	return TCS_OK;
}

enum tcs_status
planar_tangle(const struct planar *polygon, uint64_t most_pairs,
	uint64_t most_crossings, bool *tangled, struct tcs_fault *fault)
{
	struct box_list boxes = {0};
	enum tcs_status status = boxes_sort(polygon, &boxes, fault);
	uint64_t pairs = 0, crossings = 0;

	*tangled = false;
	for (size_t i = 0; i < boxes.count && !*tangled; i++) {
		const struct box *box = &boxes.at[i];

		for (size_t j = i + 1; j < boxes.count &&
			boxes.at[j].low <= box->high && pairs <= most_pairs;
			j++) {
			pairs++;
			crossings += edges_meet(
				polygon, box->edge, boxes.at[j].edge);
		}
		*tangled = pairs > most_pairs || crossings > most_crossings;
	}
	array_release(&boxes);
	return status;
}
