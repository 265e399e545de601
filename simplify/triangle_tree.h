/*
 * Trees over triangles: the nearest point, what a ray meets, and how far apart
 * two sets of triangles are. One struct holds any number of trees, as in
 * box_tree.h; exact up to the rounding of triangle_shape.h.
 */
#ifndef TESSERA_TRIANGLE_TREE_H
#define TESSERA_TRIANGLE_TREE_H

#include "box_tree.h"
#include "triangle_shape.h"

/* All zero is empty. */
struct triangle_tree {
	struct box_tree boxes;
	TCS_ARRAY(struct triangle_shape) shapes; /* as boxes.items */
};

/*
 * Add a tree over triangles[items[0]] and so on, `count` > 0 of them. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status triangle_tree_add(struct triangle_tree *tree,
	const struct tcs_point *points, const struct tcs_triangle *triangles,
	const uint32_t *items, size_t count, uint32_t *root,
	struct tcs_fault *fault) TCS_CHECKED;
void triangle_tree_release(struct triangle_tree *tree);

struct tree_hit {
	double distance; /* INFINITY: there is none */
	uint32_t item; /* the triangle */
	struct tcs_point point; /* on it */
};

/* The point of the triangles nearest to `from`, if not farther than `reach`. */
struct tree_hit triangle_tree_nearest(const struct triangle_tree *tree,
	uint32_t root, struct tcs_point from, double reach);

/* The same, but whatever is not farther than `enough` will do. */
struct tree_hit triangle_tree_near(const struct triangle_tree *tree,
	uint32_t root, struct tcs_point from, double reach, double enough);

/* The nearest among the triangles that face the same side as `facing`. */
struct tree_hit triangle_tree_nearest_facing(const struct triangle_tree *tree,
	uint32_t root, struct tcs_point from, struct tcs_point facing,
	double reach);

/*
 * The first triangle that origin + t · direction meets, 0 < t < reach, from
 * either side; the distance is t.
 */
struct tree_hit triangle_tree_ray(const struct triangle_tree *tree,
	uint32_t root, struct tcs_point origin, struct tcs_point direction,
	double reach);

/* One that it meets, not the first; quicker. Its distance says whether any. */
struct tree_hit triangle_tree_any(const struct triangle_tree *tree,
	uint32_t root, struct tcs_point origin, struct tcs_point direction,
	double reach);

/*
 * Whether a closed surface encloses the point: whether a ray from it meets an
 * odd number of triangles. A ray that comes too near to an edge is replaced.
 */
bool triangle_tree_encloses(const struct triangle_tree *tree, uint32_t root,
	struct tcs_point point);

struct tree_gap {
	double distance; /* INFINITY: more than the reach */
	struct tcs_point points[2]; /* where, the first on the first tree */
};

/* The distance between two trees' surfaces, if not farther than `reach`;
   0 where they intersect. Ends early when it is at most `enough`. */
struct tree_gap triangle_tree_gap(const struct triangle_tree *tree, uint32_t a,
	uint32_t b, double reach, double enough);

/* The distance of one triangle, points[0] on it, from a tree's surface. */
struct tree_gap triangle_tree_gap_from(const struct triangle_tree *tree,
	uint32_t root, const struct triangle_shape *from, double reach);

#endif
