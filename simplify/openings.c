#include "openings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "lod_home.h"

/* The level at which walls have no openings. */
#define WALLS_ONLY 2

/* Metres: that something is an opening weighs as much as a shape that is off
   by so much over the same area. */
#define MEANT_DEPTH 0.5

static int
by_area(const void *left, const void *right)
{
	const struct opening *a = left, *b = right;

	if (a->area < b->area || b->area < a->area)
		return a->area < b->area ? -1 : 1;
	return (a->feature > b->feature) - (a->feature < b->feature);
}

/*
 * Forget the area of what shares no component with its wall: a window that is
 * a solid of its own is no part of another.
 */
static enum tcs_status
forget_separate(const struct component_set *set, const uint32_t *homes,
	size_t features, double *areas, struct tcs_fault *fault)
{
	uint32_t *last = malloc((features + 1) * sizeof *last);
	bool *joined = calloc(features + 1, sizeof *joined);

	if (!last || !joined) {
		free(last);
		free(joined);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < features; i++)
		last[i] = TCS_NONE;
	for (uint32_t c = 0; c < set->components.count; c++) {
		const struct component *component = &set->components.at[c];
		const uint32_t *order = set->order.at + component->first;

		for (uint32_t i = 0; i < component->count; i++)
			last[set->features.at[order[i]]] = c;
		for (uint32_t i = 0; i < component->count; i++) {
			uint32_t feature = set->features.at[order[i]];

			joined[feature] |= last[homes[feature]] == c;
		}
	}
	for (size_t i = 0; i < features; i++)
		if (!joined[i])
			areas[i] = 0;
	free(last);
	free(joined);
	return TCS_OK;
}

static enum tcs_status
list(struct openings *openings, const struct tcs_object *object,
	const struct component_set *set, double *areas, struct tcs_fault *fault)
{
	size_t count = object->features.count;
	enum tcs_status status;

	if (array_grow(&openings->by_area, count) ||
		array_grow(&openings->homes, count) ||
		array_grow(&openings->are, count))
		return fault_memory(fault);
	openings->homes.count = openings->are.count = count;
	lod_homes_find(object, WALLS_ONLY, openings->homes.at);
	status = forget_separate(set, openings->homes.at, count, areas, fault);
	if (status)
		return status;
	for (uint32_t i = 0; i < count; i++) {
		uint32_t wall = openings->homes.at[i];

		openings->are.at[i] = wall != i;
		if (wall != i && areas[i] > 0)
			openings->by_area.at[openings->by_area.count++] =
				(struct opening){areas[i], i, wall};
	}
	for (uint32_t i = 0; i < count; i++)
		openings->homes.at[i] = i;
	if (openings->by_area.count > 0)
		qsort(openings->by_area.at, openings->by_area.count,
			sizeof *openings->by_area.at, by_area);
	return TCS_OK;
}

enum tcs_status
openings_find(struct openings *openings, const struct tcs_object *object,
	const struct component_set *set, struct tcs_fault *fault)
{
	double *areas = calloc(object->features.count + 1, sizeof *areas);
	enum tcs_status status;

	array_clear(&openings->by_area);
	array_clear(&openings->homes);
	array_clear(&openings->are);
	openings->dissolved = 0;
	if (!areas)
		return fault_memory(fault);
	for (size_t i = 0; i < set->triangles.count; i++) {
		struct triangle_shape shape = component_set_shape(set, i);

		areas[set->features.at[i]] += triangle_area(&shape);
	}
	status = list(openings, object, set, areas, fault);
	free(areas);
	return status;
}

double
openings_next_cost(const struct openings *openings)
{
	if (openings->dissolved == openings->by_area.count)
		return INFINITY;
	return openings->by_area.at[openings->dissolved].area * MEANT_DEPTH *
		MEANT_DEPTH;
}

bool
openings_dissolve(struct openings *openings, size_t count)
{
	if (openings->dissolved == openings->by_area.count)
		return false;
	for (; count > 0 && openings->dissolved < openings->by_area.count;
		count--) {
		const struct opening *next =
			&openings->by_area.at[openings->dissolved++];

		openings->homes.at[next->feature] = next->wall;
	}
	return true;
}

void
openings_release(struct openings *openings)
{
	array_release(&openings->by_area);
	array_release(&openings->homes);
	array_release(&openings->are);
}
