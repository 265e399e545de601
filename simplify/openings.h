/*
 * Doors and windows that have become part of their walls, the smallest first.
 */
#ifndef TESSERA_OPENINGS_H
#define TESSERA_OPENINGS_H

#include "component_set.h"

struct opening {
	double area; /* square metres */
	uint32_t feature, wall;
};

/* All zero is empty; reused from object to object. */
struct openings {
	TCS_ARRAY(struct opening) by_area; /* those that have triangles */
	size_t dissolved; /* so many of them, from the first */
	TCS_ARRAY(uint32_t) homes; /* per feature: itself, or its wall */
	TCS_ARRAY(bool) are; /* per feature: whether it is one */
};

/*
 * List the openings of an object that have triangles in the set; none is
 * dissolved. Fails with TCS_NO_MEMORY.
 */
enum tcs_status openings_find(struct openings *openings,
	const struct tcs_object *object, const struct component_set *set,
	struct tcs_fault *fault) TCS_CHECKED;

/* What dissolving the next one costs, as collapses are measured; INFINITY
   when none is left. */
double openings_next_cost(const struct openings *openings);

/* Dissolve up to `count` more; false when there is none left. */
bool openings_dissolve(struct openings *openings, size_t count);

void openings_release(struct openings *openings);

#endif
