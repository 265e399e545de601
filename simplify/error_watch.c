#include "error_watch.h"

#include <math.h>

#include "collapses.h"

/*
 * Points are numbered: first the vertices, then four for every face, which are
 * its centre and the middles of its edges.
 */
enum { POINTS_OF_FACE = 4 };

static void
hold(struct error_watch *watch, uint32_t face, uint32_t point)
{
	watch->next.at[point] = watch->faces.at[face];
	watch->faces.at[face] = point;
}

/* A face holds its centre, and one of two the middle of their edge. */
static void
hold_own(struct error_watch *watch, const struct sheets *sheets, uint32_t face)
{
	uint32_t first =
		(uint32_t)sheets->vertex_nodes.count + POINTS_OF_FACE * face;

	hold(watch, face, first);
	for (uint32_t k = 0; k < 3; k++) {
		uint32_t back = sheets->opposites.at[3 * face + k];

		if (back == HALF_EDGE_NONE || back > 3 * face + k)
			hold(watch, face, first + 1 + k);
	}
}

static enum tcs_status
grow_trees(struct error_watch *watch, const struct component_set *set,
	struct tcs_fault *fault)
{
	size_t count = set->components.count;
	enum tcs_status status = TCS_OK;

	array_clear(&watch->tree.boxes.nodes);
	array_clear(&watch->tree.boxes.items);
	array_clear(&watch->tree.shapes);
	array_clear(&watch->roots);
	if (array_grow(&watch->roots, count))
		return fault_memory(fault);
	watch->roots.count = count;
	for (size_t i = 0; !status && i < count; i++) {
		const struct component *component = &set->components.at[i];

		status = triangle_tree_add(&watch->tree, set->points.at,
			set->triangles.at, set->order.at + component->first,
			component->count, &watch->roots.at[i], fault);
	}
	return status;
}

enum tcs_status
error_watch_begin(struct error_watch *watch, double limit,
	const struct component_set *set, const struct sheets *sheets,
	struct tcs_fault *fault)
{
	size_t faces = sheets->face_triangles.count;
	size_t points = sheets->vertex_nodes.count + POINTS_OF_FACE * faces;

	watch->limit = limit;
	array_clear(&watch->faces);
	array_clear(&watch->next);
	if (!(limit < INFINITY))
		return TCS_OK;
	if (points >= TCS_NONE)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"too many triangles to watch their error");
	if (array_grow(&watch->faces, faces) ||
		array_grow(&watch->next, points))
		return fault_memory(fault);
	watch->faces.count = faces;
	watch->next.count = points;
	for (size_t i = 0; i < faces; i++)
		watch->faces.at[i] = TCS_NONE;
	for (uint32_t i = 0; i < faces; i++)
		hold_own(watch, sheets, i);
	return grow_trees(watch, set, fault);
}

/* Where a point is: on the original. */
static struct tcs_point
first_place(const struct collapses *work, uint32_t point)
{
	const struct sheets *sheets = work->sheets;
	const struct component_set *set = work->set;
	uint32_t vertices = (uint32_t)sheets->vertex_nodes.count;
	uint32_t kind = (point - vertices) % POINTS_OF_FACE;
	struct triangle_shape shape;

	if (point < vertices)
		return set->points
			.at[sheets->nodes.at[node_of(work, point)].point];
	shape = component_set_shape(set,
		sheets->face_triangles.at[(point - vertices) / POINTS_OF_FACE]);
	return kind
		? vector_middle(shape.corner[kind - 1], shape.corner[kind % 3])
		: triangle_centre(&shape);
}

/* ---- what is gone -------------------------------------------------------- */

/* The face of the changed ring that is nearest to a point, if it is within the
   limit; TCS_NONE. */
static uint32_t
nearest_face(const struct collapses *work, size_t count, uint32_t target,
	struct tcs_point point)
{
	double least = work->watch.limit * work->watch.limit;
	uint32_t best = TCS_NONE;

	for (size_t i = 0; i < count; i++) {
		struct triangle_shape shape;
		struct tcs_point away;
		double square;

		if (!ring_shape(work, count, i, target, &shape))
			continue;
		away = vector_difference(
			triangle_nearest(&shape, point), point);
		square = vector_dot(away, away);
		if (square <= least) {
			least = square;
			best = work->spokes.at[i].face;
		}
	}
	return best;
}

static bool
keeps_the_gone(const struct collapses *work, uint32_t vertex, size_t count,
	uint32_t target)
{
	const struct error_watch *watch = &work->watch;

	if (nearest_face(work, count, target, first_place(work, vertex)) ==
		TCS_NONE)
		return false;
	for (size_t i = 0; i < count; i++) {
		uint32_t face = work->spokes.at[i].face, gone;

		gone = face == HALF_EDGE_NONE ? TCS_NONE
					      : watch->faces.at[face];
		for (; gone != TCS_NONE; gone = watch->next.at[gone])
			if (nearest_face(work, count, target,
				    first_place(work, gone)) == TCS_NONE)
				return false;
	}
	return true;
}

/* ---- what takes its place ------------------------------------------------ */

static bool
is_near(const struct collapses *work, uint32_t face, struct tcs_point point)
{
	const struct error_watch *watch = &work->watch;
	uint32_t component =
		work->set->numbers.at[work->sheets->face_triangles.at[face]];

	return triangle_tree_nearest(&watch->tree, watch->roots.at[component],
		       point, watch->limit)
		       .distance <= watch->limit;
}

/* The first corner of `shape` is where the vertex moves. */
static bool
face_is_near(const struct collapses *work, uint32_t face,
	const struct triangle_shape *shape)
{
	const struct tcs_point *corner = shape->corner;

	for (int k = 1; k < 3; k++)
		for (int part = 1; part < 4; part++)
			if (!is_near(work, face,
				    vector_along(corner[0],
					    vector_difference(
						    corner[k], corner[0]),
					    part / 4.0)))
				return false;
	return is_near(work, face, triangle_centre(shape));
}

bool
error_watch_allows(const struct collapses *work, uint32_t vertex, size_t count,
	uint32_t target)
{
	if (!(work->watch.limit < INFINITY))
		return true;
	if (!keeps_the_gone(work, vertex, count, target))
		return false;
	for (size_t i = 0; i < count; i++) {
		struct triangle_shape shape;

		if (ring_shape(work, count, i, target, &shape) &&
			!face_is_near(work, work->spokes.at[i].face, &shape))
			return false;
	}
	return true;
}

void
error_watch_follow(
	struct collapses *work, uint32_t vertex, size_t count, uint32_t target)
{
	struct error_watch *watch = &work->watch;
	uint32_t gone = vertex, next;

	if (!(watch->limit < INFINITY))
		return;
	/* All that the ring held, as one list; then each to its new face. */
	watch->next.at[vertex] = TCS_NONE;
	for (size_t i = 0; i < count; i++) {
		uint32_t face = work->spokes.at[i].face, held;

		if (face == HALF_EDGE_NONE)
			continue;
		for (held = watch->faces.at[face]; held != TCS_NONE;
			held = next) {
			next = watch->next.at[held];
			watch->next.at[held] = gone;
			gone = held;
		}
		watch->faces.at[face] = TCS_NONE;
	}
	for (; gone != TCS_NONE; gone = next) {
		uint32_t face = nearest_face(
			work, count, target, first_place(work, gone));

		next = watch->next.at[gone];
		if (face != TCS_NONE)
			hold(watch, face, gone);
	}
}

void
error_watch_release(struct error_watch *watch)
{
	array_release(&watch->faces);
	array_release(&watch->next);
	triangle_tree_release(&watch->tree);
	array_release(&watch->roots);
}
