/*
 * The components of an object as manifold sheets, ready for half-edges.
 *
 * An edge joins its faces where exactly two use it, against each other. Where
 * more do, as between solids that share an edge, faces are paired around it so
 * that each pair has the material between them; what finds no partner is open.
 * Corners that are connected through joined edges are one *vertex*. A *node*
 * is what its component has at one point: one vertex as a rule, and several
 * where sheets meet without being joined. These are twins: they move together
 * or not at all, so that no crack opens.
 *
 * source: W, segmentation (Wang et al. 2021, ISPRS IJGI 10, 422); A. Guéziec
 * et al., Cutting and stitching: converting sets of polygons to manifold
 * surfaces, 2001.
 */
#ifndef TESSERA_SHEETS_H
#define TESSERA_SHEETS_H

#include "component_set.h"
#include "half_edges.h"

struct sheet_node {
	uint32_t point; /* of the component set */
	uint32_t component;
	uint32_t first_vertex; /* up to that of the next node */
};

/* All zero is empty; reused from object to object. */
struct sheets {
	TCS_ARRAY(struct sheet_node) nodes; /* and one more behind the last */
	TCS_ARRAY(uint32_t) vertex_nodes; /* per vertex */
	TCS_ARRAY(uint32_t) face_triangles; /* per face: of the set */
	TCS_ARRAY(uint32_t) triangle_faces; /* back; TCS_NONE: collapsed */
	TCS_ARRAY(uint32_t) corners; /* three vertices per face */
	TCS_ARRAY(uint32_t) opposites; /* as half_edges_new takes them */
	TCS_ARRAY(struct tcs_point) normals; /* per face: of length 1, or 0 */
	size_t node_count;
};

/*
 * Split the components of a built set. Faces are its triangles, component by
 * component, without the collapsed ones. Takes n log n steps. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status sheets_build(struct sheets *sheets,
	const struct component_set *set, struct tcs_fault *fault) TCS_CHECKED;

void sheets_release(struct sheets *sheets);

#endif
