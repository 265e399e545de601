/*
 * Triangulation and outlines of rings that break the rules, by the odd–even
 * rule, through GLU's tessellator.
 */
#ifndef TESSERA_PLANAR_REPAIR_H
#define TESSERA_PLANAR_REPAIR_H

#include "planar.h"

/*
 * Append the triangles, all counterclockwise and of positive area. Where edges
 * cross, vertices are added behind those of the polygon: `extra` in space,
 * interpolated from `vertices`, and polygon->points in the plane.
 *
 * The tessellator is not robust against edges that lie on each other but for
 * rounding. A grid, a power of two, snaps what it gets to see; 0 does not.
 *
 * *sound is false where the tessellator gave up. Fails with TCS_NO_MEMORY.
 */
enum tcs_status planar_repair(struct planar *polygon,
	const struct tcs_point *vertices, double grid,
	struct triangle_list *out, struct point_list *extra, bool *sound,
	struct tcs_fault *fault) TCS_CHECKED;

/* Rings as vertices of a polygon, ring by ring. */
struct planar_rings {
	TCS_ARRAY(uint32_t) vertices;
	TCS_ARRAY(uint32_t) ends; /* in vertices, of each ring */
};

void planar_rings_release(struct planar_rings *rings);

/*
 * The same, but the outlines of what is inside: counterclockwise, and of holes
 * clockwise. Each piece that hangs together by more than a point has a ring of
 * its own.
 */
enum tcs_status planar_outline(struct planar *polygon,
	const struct tcs_point *vertices, double grid, struct planar_rings *out,
	struct point_list *extra, bool *sound,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
