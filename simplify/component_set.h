/*
 * One object as its components: a welded mesh in local metres, with a tree
 * over the triangles of each component and one over the components' boxes.
 */
#ifndef TESSERA_COMPONENT_SET_H
#define TESSERA_COMPONENT_SET_H

#include "edge_table.h"
#include "triangle_tree.h"
#include "weld.h"

struct component {
	uint32_t first, count; /* of `order` */
	uint32_t root; /* in `tree` */
	struct box box;
	double area; /* square metres */
	double volume; /* cubic metres if closed, negative inside out; else 0 */
	bool closed; /* every edge is used as often one way as the other */
};

/* All zero is empty; component_set_clear keeps the room. */
struct component_set {
	unsigned jobs; /* threads to use for it; 0 is 1 */
	TCS_ARRAY(struct tcs_point) points; /* distinct */
	struct weld weld; /* of the points, while triangles are put */
	TCS_ARRAY(struct tcs_triangle) triangles;
	TCS_ARRAY(uint32_t) features; /* of each triangle */
	/* Of each triangle, while they are put; components.h. */
	TCS_ARRAY(uint32_t) bodies;
	TCS_ARRAY(uint32_t) hosts; /* of each feature: what it bounds, or it */
	TCS_ARRAY(uint32_t) numbers; /* the component of each triangle */
	TCS_ARRAY(uint32_t) order; /* triangles, component by component */
	TCS_ARRAY(struct component) components;
	struct edge_table edges;
	struct triangle_tree tree;
	struct box_tree boxes;
	uint32_t box_root; /* in `boxes`, when there are components */
	struct box bounds;
};

/*
 * Before the triangles of an object: what its boundary surfaces bound. Without,
 * every feature bounds itself. Fails with TCS_NO_MEMORY.
 */
enum tcs_status component_set_begin(struct component_set *set,
	const struct tcs_object *object, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Put one triangle behind those there are: three points, its feature, and the
 * number of its shell or TCS_NONE. Fails with TCS_NO_MEMORY, or TCS_LIMIT beyond
 * 2²⁹ triangles.
 */
enum tcs_status component_set_add(struct component_set *set,
	const struct tcs_point corners[3], uint32_t feature, uint32_t shell,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Once all are there: find the components, grow the trees. Takes n log n steps.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status component_set_build(
	struct component_set *set, struct tcs_fault *fault) TCS_CHECKED;

/* The same without trees over the triangles: `tree` and the components' roots
   are not set. */
enum tcs_status component_set_join(
	struct component_set *set, struct tcs_fault *fault) TCS_CHECKED;

/* A component will have a corner there. */
void component_set_enlarge(
	struct component_set *set, uint32_t component, struct tcs_point place);

void component_set_clear(struct component_set *set);
void component_set_release(struct component_set *set);

static inline struct triangle_shape
component_set_shape(const struct component_set *set, size_t triangle)
{
	const uint32_t *corner = set->triangles.at[triangle].corner;

	return (struct triangle_shape){{set->points.at[corner[0]],
		set->points.at[corner[1]], set->points.at[corner[2]]}};
}

#endif
