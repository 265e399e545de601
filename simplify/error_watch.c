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
	watch->paused = false;
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
	for (uint32_t i = 0; i < sheets->vertex_nodes.count; i++)
		watch->next.at[i] = i;
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

/* Rings, and where their vertices go. */
struct move {
	const struct collapses *work;
	const struct watch_ring *rings;
	size_t count;
	struct tcs_point place;
};

static bool
is_watched(const struct collapses *work)
{
	return work->watch.limit < INFINITY && !work->watch.paused;
}

/* Face i of a ring once its vertex has moved; false where none stays. */
static bool
moved_shape(const struct move *move, const struct watch_ring *ring, size_t i,
	struct triangle_shape *shape)
{
	const struct spoke *spoke = &ring->spokes[i];
	const struct spoke *next = &ring->spokes[(i + 1) % ring->count];
	const struct tcs_point *positions = move->work->positions.at;
	uint32_t a = node_of(move->work, spoke->to);
	uint32_t b = node_of(move->work, next->to);

	if (spoke->face == HALF_EDGE_NONE || a == ring->without ||
		b == ring->without)
		return false;
	*shape = (struct triangle_shape){
		{move->place, positions[a], positions[b]}};
	return true;
}

/* ---- what is gone -------------------------------------------------------- */

/* The moved face that is nearest to a point, if it is within the limit;
   TCS_NONE. */
static uint32_t
nearest_face(const struct move *move, struct tcs_point point)
{
	double least = move->work->watch.limit * move->work->watch.limit;
	uint32_t best = TCS_NONE;

	for (size_t r = 0; r < move->count; r++)
		for (size_t i = 0; i < move->rings[r].count; i++) {
			struct triangle_shape shape;
			struct tcs_point away;
			double square;

			if (!moved_shape(move, &move->rings[r], i, &shape))
				continue;
			away = vector_difference(
				triangle_nearest(&shape, point), point);
			square = vector_dot(away, away);
			if (square <= least) {
				least = square;
				best = move->rings[r].spokes[i].face;
			}
		}
	return best;
}

static bool
is_kept(const struct move *move, uint32_t point)
{
	return nearest_face(move, first_place(move->work, point)) != TCS_NONE;
}

static bool
ring_keeps_the_gone(const struct move *move, const struct watch_ring *ring)
{
	const struct error_watch *watch = &move->work->watch;

	if (!is_kept(move, ring->vertex))
		return false;
	for (size_t i = 0; i < ring->count; i++) {
		uint32_t face = ring->spokes[i].face, gone;

		gone = face == HALF_EDGE_NONE ? TCS_NONE
					      : watch->faces.at[face];
		for (; gone != TCS_NONE; gone = watch->next.at[gone])
			if (!is_kept(move, gone))
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
		for (int part = 0; part < 4; part++)
			if (!is_near(work, face,
				    vector_along(corner[0],
					    vector_difference(
						    corner[k], corner[0]),
					    part / 4.0)))
				return false;
	return is_near(work, face, triangle_centre(shape));
}

static bool
ring_is_near(const struct move *move, const struct watch_ring *ring)
{
	for (size_t i = 0; i < ring->count; i++) {
		struct triangle_shape shape;

		if (moved_shape(move, ring, i, &shape) &&
			!face_is_near(move->work, ring->spokes[i].face, &shape))
			return false;
	}
	return true;
}

bool
error_watch_allows(const struct collapses *work, const struct watch_ring *rings,
	size_t count, struct tcs_point place)
{
	const struct move move = {work, rings, count, place};

	if (!is_watched(work))
		return true;
	for (size_t i = 0; i < count; i++)
		if (!ring_keeps_the_gone(&move, &rings[i]))
			return false;
	for (size_t i = 0; i < count; i++)
		if (!ring_is_near(&move, &rings[i]))
			return false;
	return true;
}

/* ---- doing it ------------------------------------------------------------ */

/* Put all that a ring holds before `gone`, and its vertex, unless that was
   moved before and is held already. */
static uint32_t
let_go(struct error_watch *watch, const struct watch_ring *ring, uint32_t gone)
{
	uint32_t next;

	for (size_t i = 0; i < ring->count; i++) {
		uint32_t face = ring->spokes[i].face, held;

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
	if (watch->next.at[ring->vertex] != ring->vertex)
		return gone;
	watch->next.at[ring->vertex] = gone;
	return ring->vertex;
}

void
error_watch_follow(struct collapses *work, const struct watch_ring *rings,
	size_t count, struct tcs_point place)
{
	const struct move move = {work, rings, count, place};
	uint32_t gone = TCS_NONE, next;

	if (!is_watched(work))
		return;
	for (size_t i = 0; i < count; i++)
		gone = let_go(&work->watch, &rings[i], gone);
	for (; gone != TCS_NONE; gone = next) {
		uint32_t face = nearest_face(&move, first_place(work, gone));

		next = work->watch.next.at[gone];
		work->watch.next.at[gone] = TCS_NONE;
		if (face != TCS_NONE)
			hold(&work->watch, face, gone);
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
