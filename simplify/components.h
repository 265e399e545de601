/*
 * The components of a mesh: triangles joined by a shared point inside one
 * feature, or across features by an edge that exactly two triangles use, of all
 * or of those of one body: the shell of a solid or, where there is none, the
 * building part, say, whose walls and roofs they are.
 *
 * Joining all that share a point, whatever their features, would make one
 * component of solids that merely touch at a corner or along an edge. Without
 * bodies, the two closures between adjoining parts would be components of their
 * own, as four triangles use their edges, and the parts would be open; so would
 * be walls below a roof that projects.
 */
#ifndef TESSERA_COMPONENTS_H
#define TESSERA_COMPONENTS_H

#include "edge_table.h"
#include "fault.h"
#include "tcs.h"

/*
 * components[i] is that of triangles[i], numbered from 0 in the order of their
 * first triangles; features[i] is the triangle's feature, bodies[i] its body.
 * `table` is that of the same triangles, whose corners are below `point_count`.
 * Takes n log n steps. Fails with TCS_NO_MEMORY.
 */
enum tcs_status components_find(const struct tcs_triangle *triangles,
	const uint32_t *features, const uint32_t *bodies, size_t count,
	size_t point_count, const struct edge_table *table,
	uint32_t *components, size_t *component_count,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
