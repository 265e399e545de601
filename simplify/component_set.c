#include "component_set.h"

#include <math.h>
#include <stdlib.h>

#include "components.h"
#include "labels.h"
#include "vector.h"

enum { MANY_POINTS = 1 << 14 };

static bool
bounds_its_parent(
	const struct tcs_object *object, const struct tcs_feature *own)
{
	enum label_kind kind = label_of(own->class)->kind, above;

	if (own->parent == TCS_NONE || kind == LABEL_SURFACE)
		return own->parent != TCS_NONE;
	above = label_of(object->features.at[own->parent].class)->kind;
	return kind == LABEL_OPENING &&
		(above == LABEL_SURFACE || above == LABEL_OPENING);
}

enum tcs_status
component_set_begin(struct component_set *set, const struct tcs_object *object,
	struct tcs_fault *fault)
{
	size_t count = object->features.count;

	array_clear(&set->hosts);
	if (array_grow(&set->hosts, count))
		return fault_memory(fault);
	set->hosts.count = count;
	for (uint32_t i = 0; i < count; i++) {
		const struct tcs_feature *own = &object->features.at[i];

		/* Parents stand before their children. */
		set->hosts.at[i] = bounds_its_parent(object, own)
			? set->hosts.at[own->parent]
			: i;
	}
	return TCS_OK;
}

/* Triangles in a row share corners: the number of a point that the last one
   has; else TCS_NONE. */
static uint32_t
corner_of_last(const struct component_set *set, const struct tcs_point *point)
{
	size_t count = set->triangles.count;

	for (int k = 0; count > 0 && k < 3; k++) {
		uint32_t number = set->triangles.at[count - 1].corner[k];
		const struct tcs_point *own = &set->points.at[number];

		if (own->x == point->x && own->y == point->y &&
			own->z == point->z)
			return number;
	}
	return TCS_NONE;
}

/* There is room for it. */
static enum tcs_status
find_point(struct component_set *set, const struct tcs_point *point,
	uint32_t *number, struct tcs_fault *fault)
{
	enum tcs_status status;

	*number = corner_of_last(set, point);
	if (*number != TCS_NONE)
		return TCS_OK;
	status = weld_find(&set->weld, set->points.at, set->points.count, point,
		number, fault);
	if (!status && *number == set->points.count)
		set->points.at[set->points.count++] = *point;
	return status;
}

enum tcs_status
component_set_add(struct component_set *set, const struct tcs_point corners[3],
	uint32_t feature, uint32_t shell, struct tcs_fault *fault)
{
	const uint32_t *hosts = set->hosts.count ? set->hosts.at : NULL;
	struct tcs_triangle triangle;
	enum tcs_status status = TCS_OK;

	if (set->triangles.count >= (size_t)1 << 29)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"more than 2^29 triangles in one object");
	if (array_grow(&set->points, 3) || array_grow(&set->triangles, 1) ||
		array_grow(&set->features, 1) || array_grow(&set->bodies, 1))
		return fault_memory(fault);
	for (int i = 0; !status && i < 3; i++)
		status = find_point(
			set, &corners[i], &triangle.corner[i], fault);
	if (status)
		return status;
	set->triangles.at[set->triangles.count++] = triangle;
	set->features.at[set->features.count++] = feature;
	/* Shells count down from the top, where no features are. */
	set->bodies.at[set->bodies.count++] = shell != TCS_NONE
		? TCS_NONE - 1 - shell
		: hosts ? hosts[feature]
			: feature;
	return TCS_OK;
}

/* ---- building ------------------------------------------------------------ */

/* Give back the room that no point needs, where it is much. */
static void
keep_points(struct component_set *set)
{
	size_t count = set->points.count;
	struct tcs_point *fitting = NULL;

	if (count > MANY_POINTS)
		fitting =
			realloc(set->points.at, count * sizeof *set->points.at);
	if (!fitting)
		return;
	set->points.at = fitting;
	set->points.room = count;
}

static enum tcs_status
find_components(struct component_set *set, struct tcs_fault *fault)
{
	size_t count = set->triangles.count, found = 0;
	enum tcs_status status = edge_table_build(&set->edges,
		set->triangles.at, count, set->points.count, fault);

	if (!status && array_grow(&set->numbers, count))
		status = fault_memory(fault);
	if (!status)
		status = components_find(set->triangles.at, set->features.at,
			set->bodies.at, count, set->points.count, &set->edges,
			set->numbers.at, &found, fault);
	if (!status && array_grow(&set->components, found))
		status = fault_memory(fault);
	if (status)
		return status;
	set->numbers.count = count;
	for (size_t i = 0; i < found; i++)
		set->components.at[i] =
			(struct component){.box = BOX_EMPTY, .closed = true};
	set->components.count = found;
	return TCS_OK;
}

/* List the triangles component by component. */
static enum tcs_status
list_triangles(struct component_set *set, struct tcs_fault *fault)
{
	size_t count = set->triangles.count;
	uint32_t first = 0;

	if (array_grow(&set->order, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		set->components.at[set->numbers.at[i]].count++;
	for (size_t i = 0; i < set->components.count; i++) {
		set->components.at[i].first = first;
		first += set->components.at[i].count;
		set->components.at[i].count = 0;
	}
	for (size_t i = 0; i < count; i++) {
		struct component *component =
			&set->components.at[set->numbers.at[i]];

		set->order.at[component->first + component->count++] =
			(uint32_t)i;
	}
	set->order.count = count;
	return TCS_OK;
}

/* Six times the volume between the triangle and the point. */
static double
volume_below(const struct triangle_shape *shape, struct tcs_point point)
{
	return vector_dot(vector_difference(shape->corner[0], point),
		vector_cross(vector_difference(shape->corner[1], point),
			vector_difference(shape->corner[2], point)));
}

static void
measure(struct component_set *set, struct component *component)
{
	struct tcs_point origin = {0, 0, 0};
	double volume = 0;

	for (uint32_t i = 0; i < component->count; i++) {
		struct triangle_shape shape = component_set_shape(
			set, set->order.at[component->first + i]);

		if (i == 0)
			origin = shape.corner[0];
		for (int k = 0; k < 3; k++)
			box_add_point(&component->box, shape.corner[k]);
		component->area += triangle_area(&shape);
		volume += volume_below(&shape, origin);
	}
	component->volume = component->closed ? volume / 6 : 0;
	box_add(&set->bounds, &component->box);
}

/* Whether two uses of an edge are by one component, and cancel out. */
static bool
are_a_pair(const struct component_set *set, const struct edge_use *use)
{
	return use[0].forward != use[1].forward &&
		set->numbers.at[use[0].triangle] ==
		set->numbers.at[use[1].triangle];
}

/* Uses of one edge by one component must cancel out. */
static void
find_open(struct component_set *set)
{
	size_t run;

	for (size_t i = 0; i < set->edges.uses.count; i += run) {
		const struct edge_use *use = &set->edges.uses.at[i];

		run = edge_table_run(&set->edges, i);
		if (run == 2 && are_a_pair(set, use))
			continue;
		for (size_t k = 0; k < run; k++) {
			uint32_t number = set->numbers.at[use[k].triangle];
			int balance = 0;

			for (size_t m = 0; run < 64 && m < run; m++)
				if (set->numbers.at[use[m].triangle] == number)
					balance += use[m].forward ? 1 : -1;
			if (balance || run >= 64)
				set->components.at[number].closed = false;
		}
	}
}

static enum tcs_status
bound_components(struct component_set *set, struct tcs_fault *fault)
{
	size_t count = set->components.count;
	struct box *boxes = calloc(count + 1, sizeof *boxes);
	uint32_t *items = calloc(count + 1, sizeof *items);
	enum tcs_status status = TCS_OK;

	if (!boxes || !items)
		status = fault_memory(fault);
	for (size_t i = 0; !status && i < count; i++) {
		measure(set, &set->components.at[i]);
		boxes[i] = set->components.at[i].box;
		items[i] = (uint32_t)i;
	}
	if (!status && count > 0)
		status = box_tree_add(&set->boxes, boxes, items, count,
			&set->box_root, fault);
	free(boxes);
	free(items);
	return status;
}

enum tcs_status
component_set_join(struct component_set *set, struct tcs_fault *fault)
{
	enum tcs_status status;

	set->bounds = BOX_EMPTY;
	weld_clear(&set->weld);
	keep_points(set);
	status = find_components(set, fault);
	array_trim(&set->bodies);
	if (!status)
		status = list_triangles(set, fault);
	if (status)
		return status;
	find_open(set);
	return bound_components(set, fault);
}

enum tcs_status
component_set_build(struct component_set *set, struct tcs_fault *fault)
{
	enum tcs_status status = component_set_join(set, fault);

	for (size_t i = 0; !status && i < set->components.count; i++) {
		struct component *component = &set->components.at[i];

		status = triangle_tree_add(&set->tree, set->points.at,
			set->triangles.at, set->order.at + component->first,
			component->count, &component->root, fault);
	}
	return status;
}

void
component_set_enlarge(
	struct component_set *set, uint32_t component, struct tcs_point place)
{
	struct box *own = &set->components.at[component].box, had = *own;

	box_add_point(own, place);
	box_tree_enlarge(&set->boxes, set->box_root, component, &had, own);
}

void
component_set_clear(struct component_set *set)
{
	weld_clear(&set->weld);
	array_clear(&set->points);
	array_clear(&set->triangles);
	array_clear(&set->features);
	array_clear(&set->bodies);
	array_clear(&set->hosts);
	array_clear(&set->numbers);
	array_clear(&set->order);
	array_clear(&set->components);
	array_clear(&set->edges.uses);
	array_clear(&set->tree.boxes.nodes);
	array_clear(&set->tree.boxes.items);
	array_clear(&set->tree.shapes);
	array_clear(&set->boxes.nodes);
	array_clear(&set->boxes.items);
}

void
component_set_release(struct component_set *set)
{
	weld_release(&set->weld);
	array_release(&set->points);
	array_release(&set->triangles);
	array_release(&set->features);
	array_release(&set->bodies);
	array_release(&set->hosts);
	array_release(&set->numbers);
	array_release(&set->order);
	array_release(&set->components);
	edge_table_release(&set->edges);
	triangle_tree_release(&set->tree);
	box_tree_release(&set->boxes);
}
