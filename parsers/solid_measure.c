#include <math.h>
#include <stdlib.h>

#include "solid.h"
#include "solid_points.h"

/* ---- volume and area --------------------------------------------------------- */

static void
box_measure(const struct solid *solid, struct solid_measure *out)
{
	if (!solid->points.count)
		return;
	out->lower = out->upper = solid->points.at[0];
	for (size_t i = 1; i < solid->points.count; i++) {
		struct tcs_point at = solid->points.at[i];

		out->lower.x = fmin(out->lower.x, at.x);
		out->lower.y = fmin(out->lower.y, at.y);
		out->lower.z = fmin(out->lower.z, at.z);
		out->upper.x = fmax(out->upper.x, at.x);
		out->upper.y = fmax(out->upper.y, at.y);
		out->upper.z = fmax(out->upper.z, at.z);
	}
}

/* Add a ring's area as a vector, doubled, and its cone's volume, six times. */
static double
ring_measure(const struct tcs_point *ring, size_t count,
	struct tcs_point centre, struct tcs_point *area)
{
	struct tcs_point sum = {0, 0, 0}, first, last;

	if (count < 3)
		return 0;
	first = ring[0];
	last = point_minus(ring[1], first);
	for (size_t i = 2; i < count; i++) {
		struct tcs_point here = point_minus(ring[i], first);

		sum = point_plus(sum, point_cross(last, here));
		last = here;
	}
	*area = point_plus(*area, sum);
	return point_dot(point_minus(first, centre), sum);
}

static void
faces_measure(const struct solid *solid, struct solid_measure *out)
{
	struct tcs_point centre = {
		out->lower.x + (out->upper.x - out->lower.x) / 2,
		out->lower.y + (out->upper.y - out->lower.y) / 2,
		out->lower.z + (out->upper.z - out->lower.z) / 2};

	for (size_t i = 0; i < solid->faces.count; i++) {
		const struct solid_face *face = &solid->faces.at[i];
		struct tcs_point area = {0, 0, 0};

		for (size_t j = 0; j < face->ring_count; j++) {
			size_t count;
			const struct tcs_point *ring =
				solid_ring(solid, face->first_ring + j, &count);

			out->volume += ring_measure(ring, count, centre, &area);
		}
		out->area += sqrt(point_dot(area, area)) / 2;
	}
	out->volume /= 6;
}

/* ---- edges ------------------------------------------------------------------- */

struct ring_edge {
	uint32_t low, high; /* points */
	int forward; /* 1: from low to high; -1 */
};

TCS_ARRAY_TYPE(ring_edges, struct ring_edge);

static int
edge_order(const void *left, const void *right)
{
	const struct ring_edge *a = left, *b = right;

	if (a->low != b->low)
		return a->low < b->low ? -1 : 1;
	return (a->high > b->high) - (a->high < b->high);
}

static void
edges_collect(const struct solid *solid, const uint32_t *numbers,
	struct ring_edges *edges)
{
	size_t at = 0;

	for (size_t i = 0; i < solid->ring_ends.count; i++) {
		size_t first = at, end = solid->ring_ends.at[i];

		for (; at < end; at++) {
			uint32_t a = numbers[at];
			uint32_t b = numbers[at + 1 < end ? at + 1 : first];

			if (a != b)
				edges->at[edges->count++] =
					(struct ring_edge){a < b ? a : b,
						a < b ? b : a, a < b ? 1 : -1};
		}
	}
}

static bool
edges_match(const struct ring_edges *edges)
{
	long balance = 0;

	for (size_t i = 0; i < edges->count; i++) {
		balance += edges->at[i].forward;
		if (i + 1 < edges->count &&
			!edge_order(&edges->at[i], &edges->at[i + 1]))
			continue;
		if (balance)
			return false;
	}
	return true;
}

static enum tcs_status
closed_measure(const struct solid *solid, bool *closed, struct tcs_fault *fault)
{
	struct solid_points points = {0};
	struct ring_edges edges = {0};
	enum tcs_status status = solid_points_number(
		&points, solid->points.at, solid->points.count, fault);

	if (!status && array_grow(&edges, solid->points.count))
		status = fault_memory(fault);
	if (!status && solid->points.count) {
		edges_collect(solid, points.numbers.at, &edges);
		qsort(edges.at, edges.count, sizeof *edges.at, edge_order);
		*closed = edges_match(&edges);
	}
	solid_points_release(&points);
	array_release(&edges);
	return status;
}

enum tcs_status
solid_measure(const struct solid *solid, struct solid_measure *out,
	struct tcs_fault *fault)
{
	*out = (struct solid_measure){.closed = true};
	box_measure(solid, out);
	faces_measure(solid, out);
	return closed_measure(solid, &out->closed, fault);
}
