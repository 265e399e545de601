#include "collapses.h"

#include <stdlib.h>

/* Metres: no face may become thinner than this, or than it was. */
#define LEAST_HEIGHT 1e-4

/* One face of the ring that a collapse changes. */
struct change {
	const struct collapses *work;
	uint32_t face;
	struct tcs_point from, to; /* of the node */
	struct tcs_point b, c; /* the corners that stay */
};

static struct tcs_point
normal_at(const struct change *change, struct tcs_point a)
{
	return vector_cross(vector_difference(change->b, a),
		vector_difference(change->c, a));
}

/* Height over the longest edge, squared; `normal` is twice the area. */
static double
square_height(const struct change *change, struct tcs_point a,
	struct tcs_point normal)
{
	struct tcs_point ab = vector_difference(change->b, a);
	struct tcs_point ac = vector_difference(change->c, a);
	struct tcs_point bc = vector_difference(change->c, change->b);
	double longest = fmax(vector_dot(ab, ab),
		fmax(vector_dot(ac, ac), vector_dot(bc, bc)));

	return longest > 0 ? vector_dot(normal, normal) / longest : 0;
}

static bool
is_sound(const struct change *change)
{
	const struct collapses *work = change->work;
	struct tcs_point before = normal_at(change, change->from);
	struct tcs_point after = normal_at(change, change->to);
	struct tcs_point first = work->sheets->normals.at[change->face];
	double height = square_height(change, change->to, after);
	double least = LEAST_HEIGHT * LEAST_HEIGHT;

	if (height < least &&
		height < square_height(change, change->from, before))
		return false;
	/* It never turns over, however many steps that takes. */
	return vector_dot(after, first) >= 0;
}

/* ---- seams --------------------------------------------------------------- */

/* The corners of ring face i that stay where they are. */
static bool
staying_corners(const struct collapses *work, size_t count, size_t i,
	uint32_t target, uint32_t nodes[2])
{
	const struct spoke *spoke = &work->spokes.at[i];

	nodes[0] = node_of(work, spoke->to);
	nodes[1] = node_of(work, work->spokes.at[(i + 1) % count].to);
	return spoke->face != HALF_EDGE_NONE && nodes[0] != target &&
		nodes[1] != target;
}

bool
ring_shape(const struct collapses *work, size_t count, size_t i,
	uint32_t target, struct triangle_shape *shape)
{
	uint32_t nodes[2];

	if (!staying_corners(work, count, i, target, nodes))
		return false;
	*shape = (struct triangle_shape){{work->positions.at[target],
		work->positions.at[nodes[0]], work->positions.at[nodes[1]]}};
	return true;
}

static double
square_distance(struct tcs_point a, struct tcs_point b)
{
	struct tcs_point ab = vector_difference(b, a);

	return vector_dot(ab, ab);
}

static struct triangle_shape
face_shape(const struct collapses *work, uint32_t face)
{
	struct triangle_shape shape = {0};
	uint32_t nodes[3];

	if (collapses_face(work, face, nodes))
		for (int k = 0; k < 3; k++)
			shape.corner[k] = work->positions.at[nodes[k]];
	return shape;
}

/* A face that would hold a point of a seam, and where it is nearest to it. */
struct holder {
	uint32_t face;
	struct triangle_shape shape;
	struct tcs_point at;
};

/* The face of the ring, once changed, that is nearest to a point. */
static struct holder
next_holder(const struct collapses *work, size_t count, uint32_t target,
	struct tcs_point point)
{
	struct holder best = {.face = TCS_NONE};
	double least = INFINITY;

	for (size_t i = 0; i < count; i++) {
		struct holder holder = {.face = work->spokes.at[i].face};
		double square;

		if (!ring_shape(work, count, i, target, &holder.shape))
			continue;
		holder.at = triangle_nearest(&holder.shape, point);
		square = square_distance(holder.at, point);
		if (square < least) {
			least = square;
			best = holder;
		}
	}
	return best;
}

/*
 * Which face would hold a point of a seam; TCS_NONE when it would come open:
 * when from where either side is nearest to it the other side's holder is
 * farther than the limit.
 */
static uint32_t
holder_after(const struct collapses *work, size_t count, uint32_t target,
	uint32_t hold)
{
	const struct seam_point *point = &work->seams->points.at[hold / 2];
	struct holder own = next_holder(work, count, target, point->at);
	struct triangle_shape other;
	double limit = point->limit * point->limit;
	struct tcs_point there;

	if (own.face == TCS_NONE)
		return TCS_NONE;
	other = face_shape(work, work->seams->holds.at[hold ^ 1].face);
	if (square_distance(own.at, triangle_nearest(&other, own.at)) <= limit)
		return own.face;
	there = triangle_nearest(&other, point->at);
	if (square_distance(there, triangle_nearest(&own.shape, there)) <=
		limit)
		return own.face;
	return TCS_NONE;
}

/* Append the contacts of the points that the ring would no longer hold. */
static enum tcs_status
list_opened(struct collapses *work, size_t count, uint32_t target,
	struct tcs_fault *fault)
{
	const struct seams *seams = work->seams;

	for (size_t i = 0; i < count; i++) {
		uint32_t face = work->spokes.at[i].face, hold;

		if (face == HALF_EDGE_NONE)
			continue;
		for (hold = seams->faces.at[face]; hold != TCS_NONE;
			hold = seams->holds.at[hold].next) {
			if (holder_after(work, count, target, hold) != TCS_NONE)
				continue;
			if (array_grow(&work->opened, 1))
				return fault_memory(fault);
			work->opened.at[work->opened.count++] =
				seams->points.at[hold / 2].contact;
		}
	}
	return TCS_OK;
}

/* Whether every contact listed may lose as many points as it is listed. */
static bool
seams_hold(const struct collapses *work)
{
	for (size_t i = 0; i < work->opened.count; i++) {
		const struct seam_count *count =
			&work->seams->counts.at[work->opened.at[i]];
		uint32_t open = count->open;

		for (size_t k = 0; k < work->opened.count; k++)
			open += work->opened.at[k] == work->opened.at[i];
		if (work->settings.loose ? open >= count->points
					 : 4 * open >= count->points)
			return false;
	}
	return true;
}

/* ---- surfaces ------------------------------------------------------------ */

/* Append the surfaces of the faces at the edge to the target, which go. */
static enum tcs_status
list_leaving(struct collapses *work, size_t count, uint32_t target,
	struct tcs_fault *fault)
{
	for (size_t i = 0; i < count; i++) {
		uint32_t face = work->spokes.at[i].face, nodes[2];

		if (face == HALF_EDGE_NONE ||
			staying_corners(work, count, i, target, nodes))
			continue;
		if (array_grow(&work->leaving, 1))
			return fault_memory(fault);
		work->leaving.at[work->leaving.count++] =
			work->features.at[face];
	}
	return TCS_OK;
}

/* Whether every surface keeps a face. */
static bool
surfaces_stay(const struct collapses *work)
{
	for (size_t i = 0; i < work->leaving.count; i++) {
		uint32_t surface = work->leaving.at[i], faces = 0;

		for (size_t k = 0; k < work->leaving.count; k++)
			faces += work->leaving.at[k] == surface;
		if (faces >= work->surfaces.at[surface])
			return false;
	}
	return true;
}

/* ---- one vertex ---------------------------------------------------------- */

/* Whether the vertex has exactly one edge to the target, which may go. */
static bool
find_edge(const struct collapses *work, size_t count, uint32_t target,
	uint32_t *half_edge)
{
	size_t edges = 0;

	for (size_t i = 0; i < count; i++) {
		if (node_of(work, work->spokes.at[i].to) != target)
			continue;
		*half_edge = work->spokes.at[i].half_edge;
		edges++;
	}
	return edges == 1;
}

static bool
ring_is_sound(const struct collapses *work, size_t count, uint32_t node,
	uint32_t target)
{
	uint32_t nodes[2];

	for (size_t i = 0; i < count; i++) {
		struct change change;

		if (!staying_corners(work, count, i, target, nodes))
			continue;
		change = (struct change){
			work,
			work->spokes.at[i].face,
			work->positions.at[node],
			work->positions.at[target],
			work->positions.at[nodes[0]],
			work->positions.at[nodes[1]],
		};
		if (!is_sound(&change))
			return false;
	}
	return true;
}

/* Twins that share a neighbour beside the target would be pinched there. */
static enum tcs_status
collect_ring(struct collapses *work, size_t count, uint32_t target,
	struct tcs_fault *fault)
{
	if (array_grow(&work->ring, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		if (node_of(work, work->spokes.at[i].to) != target)
			work->ring.at[work->ring.count++] =
				work->spokes.at[i].to;
	return TCS_OK;
}

static int
by_number(const void *left, const void *right)
{
	const uint32_t *a = left, *b = right;

	return (*a > *b) - (*a < *b);
}

static bool
ring_is_pinched(struct collapses *work)
{
	qsort(work->ring.at, work->ring.count, sizeof *work->ring.at,
		by_number);
	for (size_t i = 1; i < work->ring.count; i++)
		if (work->ring.at[i] == work->ring.at[i - 1])
			return true;
	return false;
}

enum tcs_status
collapse_check(struct collapses *work, uint32_t node, uint32_t target,
	bool *fine, struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	bool twins = fans[1].first_vertex - fans[0].first_vertex > 1;
	enum tcs_status status;

	*fine = false;
	work->opened.count = work->ring.count = work->leaving.count = 0;
	for (uint32_t v = fans[0].first_vertex; v < fans[1].first_vertex; v++) {
		uint32_t half_edge;
		size_t count;

		status = spokes_of(work, v, &count, fault);
		if (status)
			return status;
		if (!find_edge(work, count, target, &half_edge) ||
			!half_edges_may_collapse(work->mesh, half_edge) ||
			!ring_is_sound(work, count, node, target) ||
			!error_watch_allows(work, v, count, target))
			return TCS_OK;
		status = list_opened(work, count, target, fault);
		if (!status && !work->settings.loose)
			status = list_leaving(work, count, target, fault);
		if (!status && twins)
			status = collect_ring(work, count, target, fault);
		if (status)
			return status;
	}
	*fine = seams_hold(work) && surfaces_stay(work) &&
		!(twins && ring_is_pinched(work));
	return TCS_OK;
}

/* ---- doing it ------------------------------------------------------------ */

/* Let the changed ring hold what it can of its seam points. */
static void
move_holds(struct collapses *work, size_t count, uint32_t target)
{
	struct seams *seams = work->seams;

	for (size_t i = 0; i < count; i++) {
		uint32_t face = work->spokes.at[i].face, hold, next;

		hold = face == HALF_EDGE_NONE ? TCS_NONE
					      : seams->faces.at[face];
		for (; hold != TCS_NONE; hold = next) {
			uint32_t holder =
				holder_after(work, count, target, hold);

			/* A later face of the ring may get it, and pass it
			   again. */
			next = seams->holds.at[hold].next;
			if (holder == TCS_NONE)
				seams_open(seams, hold / 2);
			else if (holder != face)
				seams_move_hold(seams, hold, holder);
		}
	}
}

enum tcs_status
collapse_do(struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	enum tcs_status status = TCS_OK;

	for (uint32_t v = fans[0].first_vertex; v < fans[1].first_vertex; v++) {
		uint32_t half_edge, gone[2];
		size_t count, faces;

		status = spokes_of(work, v, &count, fault);
		if (status || !find_edge(work, count, target, &half_edge))
			return status;
		move_holds(work, count, target);
		error_watch_follow(work, v, count, target);
		faces = half_edges_collapse(work->mesh, half_edge, gone);
		work->face_count -= faces;
		for (size_t i = 0; i < faces; i++)
			work->surfaces.at[work->features.at[gone[i]]]--;
	}
	quadric_add(&work->quadrics.at[target], &work->quadrics.at[node]);
	quadric_add(&work->borders.at[target], &work->borders.at[node]);
	work->areas.at[target] += work->areas.at[node];
	return TCS_OK;
}
