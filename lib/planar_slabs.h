/*
 * A polygon cut into slabs at every height where an edge begins, ends or
 * crosses another: slow and plain, and right whatever the rings do. It checks
 * what others made of a polygon, and stands in where they fail.
 *
 * Time and memory grow with the square of the vertices and with the crossings
 * times the vertices.
 */
#ifndef TESSERA_PLANAR_SLABS_H
#define TESSERA_PLANAR_SLABS_H

#include "planar.h"

/*
 * The area inside by the odd–even rule, and the area that is inside but not
 * covered by an odd number of the triangles, or outside but is. Where the
 * triangles' own areas add up to the former and the latter is nothing, they
 * cover the inside once and nothing else. Fails with TCS_NO_MEMORY.
 */
enum tcs_status slabs_check(const struct planar *polygon,
	const struct triangle_list *triangles, double *area, double *wrong,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append triangles that cover it, with extra vertices where edges meet the
 * ends of slabs, as planar_repair does. Fails with TCS_NO_MEMORY.
 */
enum tcs_status slabs_fill(struct planar *polygon,
	const struct tcs_point *vertices, struct triangle_list *out,
	struct point_list *extra, struct tcs_fault *fault) TCS_CHECKED;

#endif
