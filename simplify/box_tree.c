#include "box_tree.h"

#include <assert.h>
#include <math.h>

enum {
	LEAF_ITEMS = 4,
	BINS = 16,
	SAH_DEPTH = 48, /* below, nodes are split in the middle */
};

/* ---- boxes --------------------------------------------------------------- */

void
box_add(struct box *box, const struct box *other)
{
	for (int i = 0; i < 3; i++) {
		if (other->low[i] < box->low[i])
			box->low[i] = other->low[i];
		if (other->high[i] > box->high[i])
			box->high[i] = other->high[i];
	}
}

double
box_gap_squared(const struct box *a, const struct box *b)
{
	double sum = 0;

	for (int i = 0; i < 3; i++) {
		double gap = a->low[i] > b->high[i] ? a->low[i] - b->high[i]
			: b->low[i] > a->high[i]    ? b->low[i] - a->high[i]
						    : 0;

		sum += gap * gap;
	}
	return sum;
}

double
box_diagonal(const struct box *box)
{
	double sum = 0;

	for (int i = 0; i < 3; i++) {
		double size = box->high[i] - box->low[i];

		if (!(size >= 0))
			return 0;
		sum += size * size;
	}
	return sqrt(sum);
}

static double
half_area(const struct box *box)
{
	double x = box->high[0] - box->low[0];
	double y = box->high[1] - box->low[1];
	double z = box->high[2] - box->low[2];

	return x * y + y * z + z * x;
}

/* ---- building ------------------------------------------------------------ */

struct builder {
	const struct box *boxes;
	uint32_t *items;
};

/* A node to be split: its run of items. */
struct task {
	uint32_t node, begin, end, depth;
};

struct bin {
	struct box box;
	uint32_t count;
};

/* Where the centres of a run of items lie along its longest axis. */
struct spread {
	int axis;
	double low, size; /* of the doubled centres */
};

static double
doubled_centre(const struct box *box, int axis)
{
	return box->low[axis] + box->high[axis];
}

static struct spread
spread_of(const struct builder *builder, const struct task *task)
{
	struct box centres = BOX_EMPTY;
	struct spread spread = {0};

	for (uint32_t i = task->begin; i < task->end; i++) {
		const struct box *box = &builder->boxes[builder->items[i]];

		box_add_point(&centres,
			(struct tcs_point){doubled_centre(box, 0),
				doubled_centre(box, 1),
				doubled_centre(box, 2)});
	}
	for (int i = 0; i < 3; i++) {
		double size = centres.high[i] - centres.low[i];

		if (size > spread.size)
			spread = (struct spread){i, centres.low[i], size};
	}
	return spread;
}

static int
bin_of(const struct spread *spread, const struct box *box)
{
	double at = (doubled_centre(box, spread->axis) - spread->low) /
		spread->size * BINS;

	return at < BINS - 1 ? (int)at : BINS - 1;
}

/* The bin behind which the two sides cost least. Both have items: the first
   and the last bin are never empty. */
static int
best_border(const struct bin bins[BINS])
{
	double cost_behind[BINS], least = INFINITY;
	struct box box = BOX_EMPTY;
	uint32_t count = 0;
	int best = 0;

	for (int i = BINS - 1; i > 0; i--) {
		box_add(&box, &bins[i].box);
		count += bins[i].count;
		cost_behind[i] = half_area(&box) * count;
	}
	box = BOX_EMPTY;
	count = 0;
	for (int i = 0; i < BINS - 1; i++) {
		double cost;

		box_add(&box, &bins[i].box);
		count += bins[i].count;
		cost = half_area(&box) * count + cost_behind[i + 1];
		if (cost < least) {
			least = cost;
			best = i;
		}
	}
	return best;
}

/* Reorder the run of items and return where its second half begins. */
static uint32_t
split_items(const struct builder *builder, const struct task *task)
{
	struct spread spread = spread_of(builder, task);
	uint32_t begin = task->begin, end = task->end;
	struct bin bins[BINS];
	int border;

	if (!(spread.size > 0) || !isfinite(spread.size) ||
		task->depth >= SAH_DEPTH)
		return begin + (end - begin) / 2;
	for (int i = 0; i < BINS; i++)
		bins[i] = (struct bin){BOX_EMPTY, 0};
	for (uint32_t i = begin; i < end; i++) {
		const struct box *box = &builder->boxes[builder->items[i]];
		struct bin *bin = &bins[bin_of(&spread, box)];

		box_add(&bin->box, box);
		bin->count++;
	}
	border = best_border(bins);
	while (begin < end) {
		uint32_t item = builder->items[begin];

		if (bin_of(&spread, &builder->boxes[item]) <= border) {
			begin++;
			continue;
		}
		builder->items[begin] = builder->items[--end];
		builder->items[end] = item;
	}
	return begin;
}

static struct box
bounds_of(const struct builder *builder, const struct task *task)
{
	struct box box = BOX_EMPTY;

	for (uint32_t i = task->begin; i < task->end; i++)
		box_add(&box, &builder->boxes[builder->items[i]]);
	return box;
}

/* Split nodes until all are leaves. There is room for all of them. */
static void
grow(struct box_tree *tree, const struct builder *builder, struct task first)
{
	struct task stack[BOX_TREE_STACK];
	size_t height = 0;

	stack[height++] = first;
	while (height > 0) {
		struct task task = stack[--height];
		struct box_node *node = &tree->nodes.at[task.node];
		uint32_t middle, child = (uint32_t)tree->nodes.count;

		node->box = bounds_of(builder, &task);
		node->first = task.begin;
		node->count = task.end - task.begin;
		if (node->count <= LEAF_ITEMS)
			continue;
		middle = split_items(builder, &task);
		node->first = child;
		node->count = 0;
		tree->nodes.count += 2;
		assert(height + 2 <= BOX_TREE_STACK);
		stack[height++] = (struct task){
			child + 1, middle, task.end, task.depth + 1};
		stack[height++] = (struct task){
			child, task.begin, middle, task.depth + 1};
	}
}

enum tcs_status
box_tree_add(struct box_tree *tree, const struct box *boxes,
	const uint32_t *items, size_t count, uint32_t *root,
	struct tcs_fault *fault)
{
	struct builder builder = {.boxes = boxes};
	size_t begin = tree->items.count;

	assert(count > 0);
	if (count >= UINT32_MAX / 4 - tree->nodes.count / 2)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"too many triangles for one tree");
	if (array_grow(&tree->items, count) ||
		array_grow(&tree->nodes, 2 * count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		tree->items.at[begin + i] = items[i];
	builder.items = tree->items.at;
	tree->items.count += count;
	*root = (uint32_t)tree->nodes.count++;
	grow(tree, &builder,
		(struct task){
			*root, (uint32_t)begin, (uint32_t)(begin + count), 0});
	return TCS_OK;
}

/* ---- enlarging ----------------------------------------------------------- */

static bool
holds(const struct box *box, const struct box *other)
{
	for (int i = 0; i < 3; i++)
		if (!(box->low[i] <= other->low[i] &&
			    box->high[i] >= other->high[i]))
			return false;
	return true;
}

static bool
leaf_has(
	const struct box_tree *tree, const struct box_node *leaf, uint32_t item)
{
	for (uint32_t i = 0; i < leaf->count; i++)
		if (tree->items.at[leaf->first + i] == item)
			return true;
	return false;
}

/* A node that is to be looked at, and how deep it lies. */
struct visit {
	uint32_t node;
	size_t depth;
};

void
box_tree_enlarge(struct box_tree *tree, uint32_t root, uint32_t item,
	const struct box *had, const struct box *has)
{
	struct visit stack[BOX_TREE_STACK];
	uint32_t path[BOX_TREE_DEPTH + 2];
	size_t height = 0;

	stack[height++] = (struct visit){root, 0};
	while (height > 0) {
		struct visit visit = stack[--height];
		const struct box_node *node = &tree->nodes.at[visit.node];

		path[visit.depth] = visit.node;
		if (!holds(&node->box, had))
			continue;
		if (!node->count) {
			assert(height + 2 <= BOX_TREE_STACK &&
				visit.depth < BOX_TREE_DEPTH);
			stack[height++] = (struct visit){
				node->first + 1, visit.depth + 1};
			stack[height++] =
				(struct visit){node->first, visit.depth + 1};
		} else if (leaf_has(tree, node, item)) {
			for (size_t i = 0; i <= visit.depth; i++)
				box_add(&tree->nodes.at[path[i]].box, has);
			return;
		}
	}
}

void
box_tree_release(struct box_tree *tree)
{
	array_release(&tree->nodes);
	array_release(&tree->items);
}

/* ---- what is near a box -------------------------------------------------- */

void
box_tree_near(const struct box_tree *tree, uint32_t root, const struct box *box,
	double reach, box_visit *visit, void *context)
{
	uint32_t stack[BOX_TREE_STACK];
	size_t height = 0;

	stack[height++] = root;
	while (height > 0) {
		const struct box_node *node = &tree->nodes.at[stack[--height]];

		if (box_gap_squared(&node->box, box) > reach * reach)
			continue;
		if (!node->count) {
			assert(height + 2 <= BOX_TREE_STACK);
			stack[height++] = node->first + 1;
			stack[height++] = node->first;
		}
		for (uint32_t i = 0; i < node->count; i++)
			if (!visit(context, node->first + i))
				return;
	}
}

/* ---- pairs --------------------------------------------------------------- */

struct node_pair {
	uint32_t a, b;
};

struct pair_walk {
	struct node_pair stack[BOX_PAIR_STACK];
	size_t height;
};

static void
push_pair(struct pair_walk *walk, uint32_t a, uint32_t b)
{
	assert(walk->height < BOX_PAIR_STACK);
	walk->stack[walk->height++] = (struct node_pair){a, b};
}

static bool
visit_leaves(const struct box_tree *tree, struct node_pair pair,
	box_pair_visit *visit, void *context)
{
	const struct box_node *a = &tree->nodes.at[pair.a];
	const struct box_node *b = &tree->nodes.at[pair.b];

	for (uint32_t i = 0; i < a->count; i++)
		for (uint32_t k = pair.a == pair.b ? i + 1 : 0; k < b->count;
			k++)
			if (!visit(context, a->first + i, b->first + k))
				return false;
	return true;
}

/* Go one step down in the larger of the two nodes, or in both alike. */
static void
descend(const struct box_tree *tree, struct pair_walk *walk,
	struct node_pair pair)
{
	const struct box_node *a = &tree->nodes.at[pair.a];
	const struct box_node *b = &tree->nodes.at[pair.b];

	if (pair.a == pair.b) {
		push_pair(walk, a->first, a->first + 1);
		push_pair(walk, a->first + 1, a->first + 1);
		push_pair(walk, a->first, a->first);
	} else if (b->count ||
		(!a->count && half_area(&a->box) >= half_area(&b->box))) {
		push_pair(walk, a->first + 1, pair.b);
		push_pair(walk, a->first, pair.b);
	} else {
		push_pair(walk, pair.a, b->first + 1);
		push_pair(walk, pair.a, b->first);
	}
}

void
box_tree_pairs(const struct box_tree *tree, uint32_t a, uint32_t b,
	double reach, box_pair_visit *visit, void *context)
{
	struct pair_walk walk = {.height = 0};

	push_pair(&walk, a, b);
	while (walk.height > 0) {
		struct node_pair pair = walk.stack[--walk.height];
		const struct box_node *m = &tree->nodes.at[pair.a];
		const struct box_node *n = &tree->nodes.at[pair.b];

		if (pair.a != pair.b &&
			box_gap_squared(&m->box, &n->box) > reach * reach)
			continue;
		if (!m->count || !n->count)
			descend(tree, &walk, pair);
		else if (!visit_leaves(tree, pair, visit, context))
			return;
	}
}
