/*
 * Triangulation of one polygon in space: an outer ring and its holes.
 *
 * The polygon is projected along the axis nearest its normal (Newell's), the
 * arithmetic is local to its first vertex, and what comes out is verified:
 * every triangle winds as the outer ring does, and the areas add up to outer
 * minus holes. An ordinary polygon (simple rings, holes inside) uses its own
 * vertices and all of its area, whatever its plane and the winding of its
 * holes. So does one whose rings only touch, or run out and back along one
 * line. A polygon that breaks the rules (rings that cross themselves or each
 * other, holes outside) is repaired by the odd–even rule, which may add
 * vertices, or is empty, with a reason.
 *
 * Whole polygons take n log n steps. A repair is slower and refused beyond
 * 20,000 vertices or where edges cross too often, so that none takes longer
 * than a few seconds.
 */
#ifndef TESSERA_TRIANGULATE_H
#define TESSERA_TRIANGULATE_H

#include <stddef.h>
#include <stdint.h>

#include "fault.h"
#include "tcs.h"

struct triangulator; /* scratch memory; one per thread, reused */

enum triangulation_outcome {
	TRIANGULATION_WHOLE, /* own vertices, outer minus holes */
	TRIANGULATION_REPAIRED, /* by the odd–even rule; see `reason` */
	TRIANGULATION_EMPTY, /* no area is left; see `reason` */
};

/* Lent by the triangulator until its next call. */
struct triangulation {
	const struct tcs_triangle *triangles; /* corners: the vertices as
	                                         given, then the extra ones */
	size_t triangle_count;
	const struct tcs_point *extra;
	size_t extra_count;
	enum triangulation_outcome outcome;
	const char *reason; /* static text; NULL when whole */
	double area; /* of the triangles, in squared units, in their plane */
	struct tcs_point normal; /* unit, of the outer ring; 0 when empty */
	double flatness; /* the largest distance of a vertex from the plane */
};

struct triangulator *triangulator_new(void); /* NULL without memory */
void triangulator_free(struct triangulator *triangulator);

/*
 * `vertices` are those of all rings in order, the outer ring first, no ring
 * repeating its first vertex; `rings` counts the vertices of each. All finite.
 * Fails with TCS_NO_MEMORY only.
 */
enum tcs_status triangulate(struct triangulator *triangulator,
	const struct tcs_point *vertices, const uint32_t *rings,
	size_t ring_count, struct triangulation *out,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
