#include "triangle_tree.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

#include "vector.h"

static struct triangle_shape
shape_of(const struct tcs_point *points, const struct tcs_triangle *triangle)
{
	return (struct triangle_shape){{points[triangle->corner[0]],
		points[triangle->corner[1]], points[triangle->corner[2]]}};
}

static struct box
box_of(const struct triangle_shape *shape)
{
	struct box box = BOX_EMPTY;

	for (int i = 0; i < 3; i++)
		box_add_point(&box, shape->corner[i]);
	return box;
}

static enum tcs_status
add_boxes(struct triangle_tree *tree, const struct tcs_point *points,
	const struct tcs_triangle *triangles, const uint32_t *items,
	size_t count, uint32_t *root, struct tcs_fault *fault)
{
	struct box *boxes = calloc(count, sizeof *boxes);
	uint32_t *order = calloc(count, sizeof *order);
	enum tcs_status status = TCS_OK;

	if (!boxes || !order)
		status = fault_memory(fault);
	for (size_t i = 0; !status && i < count; i++) {
		struct triangle_shape shape =
			shape_of(points, &triangles[items[i]]);

		boxes[i] = box_of(&shape);
		order[i] = (uint32_t)i;
	}
	if (!status)
		status = box_tree_add(
			&tree->boxes, boxes, order, count, root, fault);
	free(boxes);
	free(order);
	return status;
}

/* The boxes are gone when the shapes come: that is less at once. */
enum tcs_status
triangle_tree_add(struct triangle_tree *tree, const struct tcs_point *points,
	const struct tcs_triangle *triangles, const uint32_t *items,
	size_t count, uint32_t *root, struct tcs_fault *fault)
{
	size_t begin = tree->boxes.items.count;
	enum tcs_status status =
		add_boxes(tree, points, triangles, items, count, root, fault);

	if (!status && array_grow(&tree->shapes, count))
		status = fault_memory(fault);
	if (status)
		return status;
	for (size_t i = begin; i < begin + count; i++) {
		uint32_t item = items[tree->boxes.items.at[i]];

		tree->boxes.items.at[i] = item;
		tree->shapes.at[i] = shape_of(points, &triangles[item]);
	}
	tree->shapes.count += count;
	return TCS_OK;
}

void
triangle_tree_release(struct triangle_tree *tree)
{
	box_tree_release(&tree->boxes);
	array_release(&tree->shapes);
}

/* ---- the nearest point --------------------------------------------------- */

struct walk_step {
	uint32_t node;
	double distance; /* of its box, squared; or where the ray enters */
};

/* The stack is large: what has not been put there is never set. */
struct walk {
	struct walk_step stack[BOX_TREE_STACK];
	size_t height;
};

/* Both children, so that the nearer one is taken first. */
static void
push_children(struct walk *walk, uint32_t first, double left, double right)
{
	int nearer = right < left;

	assert(walk->height + 2 <= BOX_TREE_STACK);
	walk->stack[walk->height++] = (struct walk_step){
		first + (uint32_t)!nearer, nearer ? left : right};
	walk->stack[walk->height++] = (struct walk_step){
		first + (uint32_t)nearer, nearer ? right : left};
}

/* A search for the nearest point. */
struct nearest {
	struct tcs_point from;
	const struct tcs_point *facing; /* NULL: either side will do */
	struct tree_hit hit;
	double square; /* of its distance, or of the reach */
	double enough; /* of a distance at which it ends; 0: of none but that */
};

/* Whether the plane of a triangle is farther already, however it is rounded. */
static bool
is_beyond(const struct triangle_shape *shape, struct tcs_point normal,
	const struct nearest *search)
{
	double height = vector_dot(
		normal, vector_difference(search->from, shape->corner[0]));

	return height * height >
		1.000001 * search->square * vector_dot(normal, normal);
}

static void
nearest_in_leaf(const struct triangle_tree *tree, const struct box_node *node,
	struct nearest *search)
{
	for (uint32_t i = node->first; i < node->first + node->count; i++) {
		const struct triangle_shape *shape = &tree->shapes.at[i];
		struct tcs_point normal = triangle_normal(shape), at, way;
		double square;

		if (is_beyond(shape, normal, search))
			continue;
		at = triangle_nearest_along(shape, normal, search->from);
		way = vector_difference(at, search->from);
		square = vector_dot(way, way);
		if (square > search->square ||
			(square == search->square &&
				isfinite(search->hit.distance)))
			continue;
		if (search->facing &&
			!(vector_dot(normal, *search->facing) > 0))
			continue;
		search->square = square;
		search->hit = (struct tree_hit){
			sqrt(square), tree->boxes.items.at[i], at};
	}
}

static struct tree_hit
find_nearest(
	const struct triangle_tree *tree, uint32_t root, struct nearest *search)
{
	const struct box_node *nodes = tree->boxes.nodes.at;
	struct tcs_point from = search->from;
	struct walk walk;

	walk.height = 1;
	walk.stack[0] = (struct walk_step){
		root, box_distance_squared(&nodes[root].box, from)};
	while (walk.height > 0 && !(search->hit.distance <= search->enough)) {
		struct walk_step step = walk.stack[--walk.height];
		const struct box_node *node = &nodes[step.node];

		if (step.distance > search->square)
			continue;
		if (node->count)
			nearest_in_leaf(tree, node, search);
		else
			push_children(&walk, node->first,
				box_distance_squared(
					&nodes[node->first].box, from),
				box_distance_squared(
					&nodes[node->first + 1].box, from));
	}
	return search->hit;
}

struct tree_hit
triangle_tree_nearest(const struct triangle_tree *tree, uint32_t root,
	struct tcs_point from, double reach)
{
	return triangle_tree_near(tree, root, from, reach, 0);
}

struct tree_hit
triangle_tree_near(const struct triangle_tree *tree, uint32_t root,
	struct tcs_point from, double reach, double enough)
{
	struct nearest search = {
		from, NULL, {.distance = INFINITY}, reach * reach, enough};

	return find_nearest(tree, root, &search);
}

struct tree_hit
triangle_tree_nearest_facing(const struct triangle_tree *tree, uint32_t root,
	struct tcs_point from, struct tcs_point facing, double reach)
{
	struct nearest search = {
		from, &facing, {.distance = INFINITY}, reach * reach, 0};

	return find_nearest(tree, root, &search);
}

/* ---- rays ---------------------------------------------------------------- */

/* What a ray has met: the first hit, or all of them counted. */
struct ray {
	struct tcs_point origin, direction;
	double at[3], inverse[3]; /* the origin, and 1 / the direction */
	struct tree_hit first;
	double reach;
	bool count_all;
	bool any; /* one hit is enough */
	unsigned count;
	double margin; /* the smallest, over all hits */
};

static struct ray
ray_from(struct tcs_point origin, struct tcs_point direction, double reach)
{
	return (struct ray){.origin = origin,
		.direction = direction,
		.at = {origin.x, origin.y, origin.z},
		.inverse = {1 / direction.x, 1 / direction.y, 1 / direction.z},
		.first = {.distance = INFINITY},
		.reach = reach};
}

/*
 * Where the ray enters the box; INFINITY when it misses. Along an axis on which
 * it does not move it is between two infinities, or beyond both; on a side of
 * the box itself one is no number, which is neither more nor less.
 */
static double
box_entry(const struct box *box, const struct ray *ray)
{
	double enter = 0, leave = ray->reach;

	for (int i = 0; i < 3; i++) {
		bool ahead = ray->inverse[i] > 0;
		double low = (box->low[i] - ray->at[i]) * ray->inverse[i];
		double high = (box->high[i] - ray->at[i]) * ray->inverse[i];
		double near = ahead ? low : high, far = ahead ? high : low;

		enter = near > enter ? near : enter;
		leave = far < leave ? far : leave;
	}
	/* Rounding must not lose a flat box. */
	return enter <= leave * (1 + 1e-12) ? enter : INFINITY;
}

static void
ray_in_leaf(const struct triangle_tree *tree, const struct box_node *node,
	struct ray *ray)
{
	for (uint32_t i = node->first; i < node->first + node->count; i++) {
		double t, margin;

		if (!triangle_hit(&tree->shapes.at[i], ray->origin,
			    ray->direction, &t, &margin) ||
			!(t > 0) || t >= ray->reach)
			continue;
		ray->count++;
		ray->margin = fmin(ray->margin, margin);
		if (ray->count_all)
			continue;
		ray->reach = t;
		ray->first = (struct tree_hit){t, tree->boxes.items.at[i],
			vector_along(ray->origin, ray->direction, t)};
	}
}

static void
follow_ray(const struct triangle_tree *tree, uint32_t root, struct ray *ray)
{
	const struct box_node *nodes = tree->boxes.nodes.at;
	struct walk walk;

	walk.height = 1;
	walk.stack[0] = (struct walk_step){root, 0};
	while (walk.height > 0) {
		struct walk_step step = walk.stack[--walk.height];
		const struct box_node *node = &nodes[step.node];

		if (step.distance >= ray->reach)
			continue;
		if (ray->any && ray->count)
			return;
		if (node->count)
			ray_in_leaf(tree, node, ray);
		else
			push_children(&walk, node->first,
				box_entry(&nodes[node->first].box, ray),
				box_entry(&nodes[node->first + 1].box, ray));
	}
}

struct tree_hit
triangle_tree_ray(const struct triangle_tree *tree, uint32_t root,
	struct tcs_point origin, struct tcs_point direction, double reach)
{
	struct ray ray = ray_from(origin, direction, reach);

	follow_ray(tree, root, &ray);
	return ray.first;
}

struct tree_hit
triangle_tree_any(const struct triangle_tree *tree, uint32_t root,
	struct tcs_point origin, struct tcs_point direction, double reach)
{
	struct ray ray = ray_from(origin, direction, reach);

	ray.any = true;
	follow_ray(tree, root, &ray);
	return ray.first;
}

bool
triangle_tree_encloses(
	const struct triangle_tree *tree, uint32_t root, struct tcs_point point)
{
	static const struct tcs_point directions[] = {
		{0.267, 0.153, 0.951},
		{-0.341, 0.527, 0.778},
		{0.713, -0.619, 0.329},
		{-0.557, -0.401, -0.727},
		{0.829, 0.487, -0.275},
	};
	size_t count = sizeof directions / sizeof *directions;
	bool encloses = false;

	if (box_distance_squared(&tree->boxes.nodes.at[root].box, point) > 0)
		return false;
	for (size_t i = 0; i < count; i++) {
		struct ray ray = ray_from(point, directions[i], INFINITY);

		ray.count_all = true;
		ray.margin = 1;
		follow_ray(tree, root, &ray);
		encloses = ray.count % 2;
		if (ray.margin > 1e-9)
			break;
	}
	return encloses;
}

/* ---- the gap between two trees ------------------------------------------- */

struct gap_step {
	uint32_t a, b;
	double distance; /* of their boxes, squared */
};

struct best_gap {
	double square; /* of it, or of the reach */
	struct tree_gap gap;
};

struct gap_walk {
	struct gap_step stack[BOX_PAIR_STACK];
	size_t height;
	struct best_gap best;
};

static struct gap_step
gap_step_of(const struct triangle_tree *tree, uint32_t a, uint32_t b)
{
	const struct box_node *nodes = tree->boxes.nodes.at;

	return (struct gap_step){
		a, b, box_gap_squared(&nodes[a].box, &nodes[b].box)};
}

static void
push_steps(struct gap_walk *walk, struct gap_step p, struct gap_step q)
{
	bool nearer = q.distance < p.distance;

	assert(walk->height + 2 <= BOX_PAIR_STACK);
	walk->stack[walk->height++] = nearer ? p : q;
	walk->stack[walk->height++] = nearer ? q : p;
}

/* One triangle and a leaf; raises the best so far. */
static void
gap_of_leaf(const struct triangle_tree *tree, const struct box_node *node,
	const struct triangle_shape *from, const struct box *box,
	struct best_gap *best)
{
	for (uint32_t i = node->first; i < node->first + node->count; i++) {
		const struct triangle_shape *shape = &tree->shapes.at[i];
		struct box other = box_of(shape);
		struct tcs_point points[2];
		double distance;

		if (box_gap_squared(box, &other) > best->square)
			continue;
		distance = triangle_gap(from, shape, points);
		if (distance * distance > best->square ||
			distance >= best->gap.distance)
			continue;
		best->square = distance * distance;
		best->gap = (struct tree_gap){distance, {points[0], points[1]}};
	}
}

static void
gap_of_leaves(const struct triangle_tree *tree, const struct box_node *a,
	const struct box_node *b, struct best_gap *best)
{
	for (uint32_t i = a->first; i < a->first + a->count; i++) {
		struct box box = box_of(&tree->shapes.at[i]);

		gap_of_leaf(tree, b, &tree->shapes.at[i], &box, best);
	}
}

struct tree_gap
triangle_tree_gap(const struct triangle_tree *tree, uint32_t a, uint32_t b,
	double reach, double enough)
{
	const struct box_node *nodes = tree->boxes.nodes.at;
	struct gap_walk walk;

	walk.height = 1;
	walk.best = (struct best_gap){reach * reach, {.distance = INFINITY}};
	walk.stack[0] = gap_step_of(tree, a, b);
	while (walk.height > 0 && walk.best.gap.distance > enough) {
		struct gap_step step = walk.stack[--walk.height];
		const struct box_node *m = &nodes[step.a], *n = &nodes[step.b];

		if (step.distance > walk.best.square)
			continue;
		if (m->count && n->count)
			gap_of_leaves(tree, m, n, &walk.best);
		else if (n->count ||
			(!m->count &&
				box_diagonal(&m->box) >= box_diagonal(&n->box)))
			push_steps(&walk, gap_step_of(tree, m->first, step.b),
				gap_step_of(tree, m->first + 1, step.b));
		else
			push_steps(&walk, gap_step_of(tree, step.a, n->first),
				gap_step_of(tree, step.a, n->first + 1));
	}
	return walk.best.gap;
}

struct tree_gap
triangle_tree_gap_from(const struct triangle_tree *tree, uint32_t root,
	const struct triangle_shape *from, double reach)
{
	const struct box_node *nodes = tree->boxes.nodes.at;
	struct best_gap best = {
		.square = reach * reach, .gap = {.distance = INFINITY}};
	struct box box = box_of(from);
	struct walk walk;

	walk.height = 1;
	walk.stack[0] = (struct walk_step){
		root, box_gap_squared(&nodes[root].box, &box)};
	while (walk.height > 0 && best.gap.distance > 0) {
		struct walk_step step = walk.stack[--walk.height];
		const struct box_node *node = &nodes[step.node];

		if (step.distance > best.square)
			continue;
		if (node->count)
			gap_of_leaf(tree, node, from, &box, &best);
		else
			push_children(&walk, node->first,
				box_gap_squared(&nodes[node->first].box, &box),
				box_gap_squared(
					&nodes[node->first + 1].box, &box));
	}
	return best.gap;
}
