/*
 * Trees over axis-parallel boxes, to find what lies near what in n log n.
 *
 * One struct holds any number of trees in one pair of flat arrays; a tree is
 * known by the index of its root. Nodes are split by the surface area
 * heuristic over 16 bins, and in the middle where that goes too deep: no tree
 * over n boxes is deeper than BOX_TREE_DEPTH, and building one takes
 * n log n steps, whatever the boxes.
 *
 * source: I. Wald, On fast construction of SAH-based bounding volume
 * hierarchies, 2007.
 */
#ifndef TESSERA_BOX_TREE_H
#define TESSERA_BOX_TREE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "tcs.h"

struct box {
	double low[3], high[3];
};

/* Contains nothing; grows with what is added. */
#define BOX_EMPTY \
	((struct box){{INFINITY, INFINITY, INFINITY}, \
		{-INFINITY, -INFINITY, -INFINITY}})

static inline void
box_add_point(struct box *box, struct tcs_point point)
{
	const double at[3] = {point.x, point.y, point.z};

	for (int i = 0; i < 3; i++) {
		box->low[i] = at[i] < box->low[i] ? at[i] : box->low[i];
		box->high[i] = at[i] > box->high[i] ? at[i] : box->high[i];
	}
}

void box_add(struct box *box, const struct box *other);
/* The distance between two boxes, squared; 0 where they overlap. */
double box_gap_squared(const struct box *a, const struct box *b);
double box_diagonal(const struct box *box); /* 0 for an empty one */

/* The distance of a point from a box, squared; 0 inside. */
static inline double
box_distance_squared(const struct box *box, struct tcs_point point)
{
	const double at[3] = {point.x, point.y, point.z};
	double sum = 0;

	for (int i = 0; i < 3; i++) {
		double below = box->low[i] - at[i],
		       above = at[i] - box->high[i];
		double gap = below > above ? below : above;

		gap = gap > 0 ? gap : 0;
		sum += gap * gap;
	}
	return sum;
}

#define BOX_TREE_DEPTH 80
#define BOX_TREE_STACK (2 * BOX_TREE_DEPTH + 2) /* of a walk down one tree */
#define BOX_PAIR_STACK (4 * BOX_TREE_DEPTH + 4) /* down two at a time */

struct box_node {
	struct box box;
	uint32_t first; /* leaf: of `items`; else the first of two children */
	uint32_t count; /* leaf: of its items; else 0 */
};

/* All zero is empty. */
struct box_tree {
	TCS_ARRAY(struct box_node) nodes;
	TCS_ARRAY(uint32_t) items; /* leaf by leaf */
};

/*
 * Add a tree over `count` > 0 items; boxes[item] is the box of an item. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status box_tree_add(struct box_tree *tree, const struct box *boxes,
	const uint32_t *items, size_t count, uint32_t *root,
	struct tcs_fault *fault) TCS_CHECKED;
/* An item of a tree gets a larger box than it had: all boxes around it hold that,
   too. Takes log n steps, as a rule. */
void box_tree_enlarge(struct box_tree *tree, uint32_t root, uint32_t item,
	const struct box *had, const struct box *has);
void box_tree_release(struct box_tree *tree);

/* One item, as its position in `items`. False ends the walk. */
typedef bool box_visit(void *context, uint32_t position);

/* Visit every item whose leaf's box is not farther than `reach` from `box`. */
void box_tree_near(const struct box_tree *tree, uint32_t root,
	const struct box *box, double reach, box_visit *visit, void *context);

/* One pair, as positions in `items`. False ends the walk. */
typedef bool box_pair_visit(void *context, uint32_t a, uint32_t b);

/*
 * Visit every pair of items, one of each tree, whose leaves' boxes are not
 * farther apart than `reach`; the visitor judges the items themselves. With
 * a == b every pair of different items once.
 */
void box_tree_pairs(const struct box_tree *tree, uint32_t a, uint32_t b,
	double reach, box_pair_visit *visit, void *context);

#endif
