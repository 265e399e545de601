#include "solid_choose.h"

#include <math.h>

enum {
	SAMPLES = 6, /* planes of items that are tried */
	MANY = 24, /* items from which on an axis is tried */
	BINS = 16,
	CUT_COST = 2, /* of an item that is cut, in items left together */
};

/* Items by the side of a plane. */
struct parts {
	size_t below, above, cut;
};

static double
cost_of(struct parts parts)
{
	size_t more = parts.below > parts.above ? parts.below : parts.above;

	return (double)(more + CUT_COST * parts.cut);
}

static struct parts
parts_of(const struct solid_pieces *pieces, uint32_t number,
	const struct solid_plane *plane, double tolerance,
	const struct solid_item *items, size_t count,
	const struct tcs_point *points)
{
	struct parts parts = {0, 0, 0};

	for (size_t i = 0; i < count; points += items[i++].count) {
		struct solid_range range;

		if (pieces->list.at[items[i].piece].plane == number)
			continue;
		range = solid_range_of(plane, points, items[i].count);
		if (range.high <= tolerance)
			parts.below++;
		else if (range.low >= -tolerance)
			parts.above++;
		else
			parts.cut++;
	}
	return parts;
}

/* ---- axes -------------------------------------------------------------------- */

/* Boxes along the axes, counted by where they start and end. */
struct bins {
	double low[3], high[3];
	uint32_t starts[3][BINS], ends[3][BINS];
};

static double
along(struct tcs_point at, unsigned axis)
{
	return axis == 0 ? at.x : axis == 1 ? at.y : at.z;
}

static struct solid_range
range_along(const struct tcs_point *points, size_t count, unsigned axis)
{
	struct solid_range range = {INFINITY, -INFINITY};

	for (size_t i = 0; i < count; i++) {
		double at = along(points[i], axis);

		range.low = at < range.low ? at : range.low;
		range.high = at > range.high ? at : range.high;
	}
	return range;
}

static unsigned
bin_of(const struct bins *bins, unsigned axis, double at)
{
	double width = bins->high[axis] - bins->low[axis];
	double bin = width > 0 ? (at - bins->low[axis]) / width * BINS : 0;

	return bin >= BINS ? BINS - 1 : bin > 0 ? (unsigned)bin : 0;
}

static void
bins_fill(struct bins *bins, const struct solid_item *items, size_t count,
	const struct tcs_point *points, unsigned axis)
{
	for (size_t i = 0; i < count; points += items[i++].count) {
		struct solid_range range =
			range_along(points, items[i].count, axis);

		bins->starts[axis][bin_of(bins, axis, range.low)]++;
		bins->ends[axis][bin_of(bins, axis, range.high)]++;
	}
}

/* The best place between two bins. */
static void
axis_try(const struct bins *bins, unsigned axis, size_t count, double *best,
	int *best_axis, double *at)
{
	size_t started = 0, ended = 0;

	for (unsigned i = 0; i + 1 < BINS; i++) {
		struct parts parts;

		started += bins->starts[axis][i];
		ended += bins->ends[axis][i];
		parts = (struct parts){ended, count - started, started - ended};
		if (!ended || started == count || cost_of(parts) >= *best)
			continue;
		*best = cost_of(parts);
		*best_axis = (int)axis;
		*at = bins->low[axis] +
			(bins->high[axis] - bins->low[axis]) * (i + 1) / BINS;
	}
}

/*
 * The bins begin a little before the items, by a part that is not round, so
 * that what lies between two bins is not the corners of a regular pattern.
 */
static double
axes_try(const struct solid_item *items, size_t count, size_t point_count,
	const struct tcs_point *points, int *axis, double *at)
{
	double best = 0.8 * (double)count;
	struct bins bins = {.low = {0}};

	for (unsigned i = 0; i < 3; i++) {
		struct solid_range range = range_along(points, point_count, i);

		bins.low[i] = range.low - 0.0137 * (range.high - range.low);
		bins.high[i] = range.high + 0.0071 * (range.high - range.low);
		bins_fill(&bins, items, count, points, i);
		axis_try(&bins, i, count, &best, axis, at);
	}
	return best;
}

uint32_t
solid_choose(const struct solid_pieces *pieces,
	const struct solid_plane *planes, double tolerance,
	const struct solid_item *items, size_t count,
	const struct tcs_point *points, int *axis, double *at)
{
	size_t samples = count < SAMPLES ? count : SAMPLES, point_count = 0;
	uint32_t best_plane = UINT32_MAX;
	double best = INFINITY;

	*axis = -1;
	for (size_t i = 0; i < samples; i++) {
		const struct solid_item *item = &items[i * count / samples];
		uint32_t plane = pieces->list.at[item->piece].plane;
		double cost;

		if (plane == best_plane)
			continue;
		cost = cost_of(parts_of(pieces, plane, &planes[plane],
			tolerance, items, count, points));
		if (cost < best) {
			best = cost;
			best_plane = plane;
		}
	}
	if (count <= MANY)
		return best_plane;
	for (size_t i = 0; i < count; i++)
		point_count += items[i].count;
	if (axes_try(items, count, point_count, points, axis, at) >= best)
		*axis = -1;
	return best_plane;
}
