/*
 * The bounds of a face, unrolled on its surface to rings in its parameters.
 */
#ifndef TESSERA_IFC_UNROLLED_H
#define TESSERA_IFC_UNROLLED_H

#include "ifc_surface.h"

struct ifc_unrolled_point {
	struct tcs_point at;
	struct ifc_uv uv;
};

TCS_ARRAY_TYPE(ifc_unrolled_points, struct ifc_unrolled_point);

/* The points of a ring follow those of the one before. */
struct ifc_unrolled_ring {
	uint32_t count;
	int turns[2]; /* how often it goes round: 1 or -1 by one period */
};

/* All zero is empty. */
struct ifc_unrolled {
	struct ifc_unrolled_points points;
	TCS_ARRAY(struct ifc_unrolled_ring) rings;
};

/*
 * Add a loop, given by its points. One that lies in a pinch as a whole is
 * passed over.
 */
enum ifc_outcome ifc_unroll(struct ifc_shaper *shaper,
	const struct ifc_surface *surface, const struct tcs_point *points,
	size_t count, struct ifc_unrolled *out) TCS_CHECKED;

/*
 * Make polygons of the rings: two that go round in opposite directions become
 * one, along a seam; one alone is joined to where the surface is pinched, on
 * its left when `forwards`, else on its right; without any, the polygon is the
 * whole surface. The polygon comes first, and the holes are moved into it by
 * periods. Refused where that cannot be.
 */
enum ifc_outcome ifc_unrolled_close(struct ifc_shaper *shaper,
	const struct ifc_surface *surface, bool forwards,
	struct ifc_unrolled *rings) TCS_CHECKED;

void ifc_unrolled_release(struct ifc_unrolled *rings);

#endif
