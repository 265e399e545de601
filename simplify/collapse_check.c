/*
 * What a collapse may not do to the mesh, its surfaces and its seams.
 *
 * A face is compared with the normal it began with, so that small turns do not
 * add up to a large one, and may turn by 90 degrees. Faces that all but vanish
 * are found by their height: a ratio of areas also meets large faces that become
 * half as large, which harms nothing. What is allowed, but dear, is in
 * collapse_strain.c.
 *
 * source: L, validation (Liu, Li, Zhao, Liu, Texture feature preserving
 * simplification).
 */
#include "collapses.h"

#include <math.h>

#include "number_sort.h"

/* Metres: no face may become thinner than this, or than it was. */
#define LEAST_HEIGHT 1e-4

/* Square metres: a face this near to a point is not beaten by another. */
#define NEAR_ENOUGH 1e-14

/* Contacts that a surface is worth. */
#define SURFACE_WORTH 4

/* ---- the ring ------------------------------------------------------------ */

/* The nodes of ring face i that stay where they are; false for the faces at
   the edge, which go. */
static inline bool
staying_corners(const struct collapses *work, size_t count, size_t i,
	uint32_t target, uint32_t nodes[2])
{
	const struct spoke *spokes = work->spokes.at;

	if (spokes[i].face == HALF_EDGE_NONE)
		return false;
	nodes[0] = node_of(work, spokes[i].to);
	nodes[1] = node_of(work, spokes[i + 1 < count ? i + 1 : 0].to);
	return nodes[0] != target && nodes[1] != target;
}

static bool
ring_face_at(const struct collapses *work, size_t count, size_t i,
	uint32_t target, struct ring_face *out)
{
	if (!staying_corners(work, count, i, target, out->nodes + 1))
		return false;
	out->face = work->spokes.at[i].face;
	out->nodes[0] = target;
	for (int k = 0; k < 3; k++)
		out->shape.corner[k] = work->positions.at[out->nodes[k]];
	out->normal = triangle_normal(&out->shape);
	return true;
}

/* Height over the longest edge, squared; `normal` is twice the area. */
static inline double
square_height(const struct triangle_shape *shape, struct tcs_point normal)
{
	const struct tcs_point *p = shape->corner;
	struct tcs_point ab = vector_difference(p[1], p[0]);
	struct tcs_point ac = vector_difference(p[2], p[0]);
	struct tcs_point bc = vector_difference(p[2], p[1]);
	double longest = vector_dot(ab, ab);

	if (vector_dot(ac, ac) > longest)
		longest = vector_dot(ac, ac);
	if (vector_dot(bc, bc) > longest)
		longest = vector_dot(bc, bc);
	return longest > 0 ? vector_dot(normal, normal) / longest : 0;
}

static bool
is_sound(const struct collapses *work, const struct ring_face *after,
	struct tcs_point from)
{
	double height = square_height(&after->shape, after->normal);
	struct triangle_shape before = after->shape;

	/* It never turns over, however many steps that takes. */
	if (vector_dot(after->normal, work->sheets->normals.at[after->face]) <
		0)
		return false;
	if (height >= LEAST_HEIGHT * LEAST_HEIGHT)
		return true;
	before.corner[0] = from;
	return height >= square_height(&before, triangle_normal(&before));
}

/* Append the faces of the ring that stay, once changed; *sound when all may
   be. */
static enum tcs_status
change_ring(struct collapses *work, size_t count, uint32_t node,
	uint32_t target, bool *sound, struct tcs_fault *fault)
{
	struct tcs_point from = work->positions.at[node];

	*sound = true;
	work->fan = work->ring.count;
	if (array_grow(&work->ring, count))
		return fault_memory(fault);
	for (size_t i = 0; *sound && i < count; i++) {
		struct ring_face *after = &work->ring.at[work->ring.count];

		work->ring_is_open |= work->spokes.at[i].face == HALF_EDGE_NONE;
		if (!ring_face_at(work, count, i, target, after))
			continue;
		*sound = is_sound(work, after, from);
		work->ring.count++;
	}
	return TCS_OK;
}

/* ---- seams --------------------------------------------------------------- */

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

/* A face of the ring that would hold a point of a seam, and where it is
   nearest to it. */
struct holder {
	const struct ring_face *face; /* NULL: none */
	struct tcs_point at;
	double square; /* of the distance */
};

static struct holder
next_holder(const struct collapses *work, struct tcs_point point)
{
	struct holder best = {.square = INFINITY};

	for (size_t i = work->fan;
		i < work->ring.count && best.square > NEAR_ENOUGH; i++) {
		const struct ring_face *face = &work->ring.at[i];
		double height = vector_dot(face->normal,
			vector_difference(point, face->shape.corner[0]));
		struct tcs_point at;
		double square;

		/* Its plane is farther already. */
		if (height * height >
			best.square * vector_dot(face->normal, face->normal))
			continue;
		at = triangle_nearest_along(&face->shape, face->normal, point);
		square = square_distance(at, point);
		if (square < best.square)
			best = (struct holder){face, at, square};
	}
	return best;
}

/* Whether from where either side is nearest to the point the other side is
   not farther than the limit. */
static bool
is_held(const struct collapses *work, const struct seam_point *point,
	const struct holder *own, const struct seam_hold *hold)
{
	double limit = (double)point->limit * (double)point->limit;
	struct triangle_shape other;
	struct tcs_point there;

	if (sqrt(own->square) + (double)hold->off <= (double)point->limit)
		return true;
	other = face_shape(work, hold->face);
	if (square_distance(own->at, triangle_nearest(&other, own->at)) <=
		limit)
		return true;
	there = triangle_nearest(&other, point->at);
	return square_distance(there,
		       triangle_nearest(&own->face->shape, there)) <= limit;
}

static struct seam_move
move_after(const struct collapses *work, uint32_t hold)
{
	const struct seams *seams = work->seams;
	const struct seam_point *point = &seams->points.at[hold / 2];
	struct holder own = next_holder(work, point->at);

	if (!own.face ||
		!is_held(work, point, &own, &seams->holds.at[hold ^ 1]))
		return (struct seam_move){hold, TCS_NONE, INFINITY};
	return (struct seam_move){hold, own.face->face, sqrt(own.square)};
}

/* List who holds the points that faces of the ring hold, and the contacts of
   those that nobody does. */
static enum tcs_status
list_moves(struct collapses *work, size_t count, struct tcs_fault *fault)
{
	const struct seams *seams = work->seams;

	for (size_t i = 0; i < count; i++) {
		uint32_t face = work->spokes.at[i].face, hold;

		if (face == HALF_EDGE_NONE)
			continue;
		for (hold = seams->faces.at[face]; hold != TCS_NONE;
			hold = seams->holds.at[hold].next) {
			struct seam_move move = move_after(work, hold);

			if (array_grow(&work->moves, 1) ||
				array_grow(&work->opened, 1))
				return fault_memory(fault);
			work->moves.at[work->moves.count++] = move;
			if (move.face == TCS_NONE)
				work->opened.at[work->opened.count++] =
					seams->points.at[hold / 2].contact;
		}
	}
	return TCS_OK;
}

/* How often the contact of entry i is listed; 0 unless it is the first time. */
static uint32_t
times_listed(const uint32_t *list, size_t count, size_t i)
{
	uint32_t times = 0;

	for (size_t k = 0; k < i; k++)
		if (list[k] == list[i])
			return 0;
	for (size_t k = i; k < count; k++)
		times += list[k] == list[i];
	return times;
}

/* Add up what the points listed break, each contact by its worth; false where
   one comes wholly apart. */
static bool
count_broken(struct collapses *work)
{
	for (size_t i = 0; i < work->opened.count; i++) {
		uint32_t contact = work->opened.at[i];
		const struct seam_count *count =
			&work->seams->counts.at[contact];
		uint32_t times =
			times_listed(work->opened.at, work->opened.count, i);
		double broken;

		if (times > 0 && cover_watch_loses(&work->covers, contact))
			continue;
		if (times > 0 && count->open + times >= count->points)
			return false;
		if (times == 0)
			continue;
		broken = seam_broken(count, count->open + times) -
			seam_broken(count, count->open);
		work->breaks_contact |= broken > 0;
		work->broken += broken *
			(work->worths.count > 0
					? (double)work->worths.at[contact]
					: 1);
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

/* Add the surfaces that keep no face. */
static void
count_vanishing(struct collapses *work)
{
	for (size_t i = 0; i < work->leaving.count; i++) {
		uint32_t times =
			times_listed(work->leaving.at, work->leaving.count, i);

		if (times > 0 &&
			times >= work->surfaces.at[work->leaving.at[i]])
			work->broken += SURFACE_WORTH;
	}
}

/* ---- one vertex ---------------------------------------------------------- */

/* List the nodes around the vertex; *half_edge is its only edge to the target,
   HALF_EDGE_NONE if there are none or several. */
static enum tcs_status
look_around(struct collapses *work, uint32_t vertex, uint32_t target,
	size_t *count, uint32_t *half_edge, struct tcs_fault *fault)
{
	enum tcs_status status = spokes_of(work, vertex, count, fault);
	size_t edges = 0;

	*half_edge = HALF_EDGE_NONE;
	if (status)
		return status;
	if (array_grow(&work->touched, *count))
		return fault_memory(fault);
	for (size_t i = 0; i < *count; i++) {
		uint32_t node = node_of(work, work->spokes.at[i].to);

		work->touched.at[work->touched.count++] = node;
		if (node != target)
			continue;
		*half_edge = work->spokes.at[i].half_edge;
		edges++;
	}
	if (edges != 1)
		*half_edge = HALF_EDGE_NONE;
	return TCS_OK;
}

/* Twins that share a neighbour beside the target would be pinched there. */
static enum tcs_status
collect_neighbours(struct collapses *work, size_t count, uint32_t target,
	struct tcs_fault *fault)
{
	if (array_grow(&work->apart, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		if (node_of(work, work->spokes.at[i].to) != target)
			work->apart.at[work->apart.count++] =
				work->spokes.at[i].to;
	return TCS_OK;
}

static bool
is_pinched(struct collapses *work)
{
	number_sort(work->apart.at, work->apart.count);
	for (size_t i = 1; i < work->apart.count; i++)
		if (work->apart.at[i] == work->apart.at[i - 1])
			return true;
	return false;
}

static enum tcs_status
check_vertex(struct collapses *work, uint32_t vertex, uint32_t target,
	bool twins, bool *fine, struct tcs_fault *fault)
{
	struct watch_ring ring;
	uint32_t half_edge;
	size_t count;
	enum tcs_status status =
		look_around(work, vertex, target, &count, &half_edge, fault);

	if (!status && count == 0)
		return TCS_OK; /* it went with its part */
	*fine = !status && half_edge != HALF_EDGE_NONE &&
		half_edges_may_collapse(work->mesh, half_edge);
	if (*fine)
		status = change_ring(work, count, node_of(work, vertex), target,
			fine, fault);
	ring = (struct watch_ring){vertex, work->spokes.at, count, target};
	if (!status && *fine)
		*fine = error_watch_allows(
			work, &ring, 1, work->positions.at[target]);
	if (!status && *fine && !work->watch.paused)
		volume_watch_look(work, &ring, work->positions.at[target]);
	if (!status && *fine)
		status = list_moves(work, count, fault);
	if (!status && *fine)
		status = list_leaving(work, count, target, fault);
	if (!status && *fine && twins)
		status = collect_neighbours(work, count, target, fault);
	return status;
}

/* ---- the node -------------------------------------------------------- */

static bool
has_twins(const struct collapses *work, uint32_t node)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];

	return fans[1].first_vertex - fans[0].first_vertex > 1;
}

/* Whether a face with these two nodes and the target is in the ring. */
static bool
is_in_ring(const struct collapses *work, uint32_t a, uint32_t b)
{
	for (size_t i = 0; i < work->ring.count; i++) {
		const uint32_t *nodes = work->ring.at[i].nodes;

		if ((nodes[1] == a && nodes[2] == b) ||
			(nodes[1] == b && nodes[2] == a))
			return true;
	}
	return false;
}

/* Whether no face of the ring gets the corners of one at the target: of
   another sheet, for within one the link condition forbids it. */
static enum tcs_status
check_doubles(struct collapses *work, uint32_t node, uint32_t target,
	bool *fine, struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[target];
	enum tcs_status status = TCS_OK;
	size_t count;

	if (!has_twins(work, target))
		return TCS_OK;
	for (uint32_t v = fans[0].first_vertex;
		!status && *fine && v < fans[1].first_vertex; v++) {
		status = spokes_of(work, v, &count, fault);
		for (size_t i = 0; !status && *fine && i < count; i++) {
			uint32_t nodes[2];

			*fine = !staying_corners(work, count, i, node, nodes) ||
				!is_in_ring(work, nodes[0], nodes[1]);
		}
	}
	return status;
}

/* What breaks beside contacts: surfaces, and components crushed or uncovered. */
static enum tcs_status
count_harm(struct collapses *work, uint32_t node, struct tcs_fault *fault)
{
	double uncovered;
	enum tcs_status status =
		cover_watch_look(work, node, &uncovered, fault);

	if (status)
		return status;
	count_vanishing(work);
	work->broken += volume_watch_worth(work, node) + uncovered;
	work->breaks_contact |= uncovered > 0;
	return TCS_OK;
}

enum tcs_status
collapse_check(struct collapses *work, uint32_t node, uint32_t target,
	bool *fine, struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	bool twins = has_twins(work, node);
	enum tcs_status status = TCS_OK;

	*fine = true;
	work->touched.count = work->moves.count = work->opened.count = 0;
	work->broken = 0;
	work->breaks_contact = false;
	work->volume.change = 0;
	work->leaving.count = work->apart.count = work->ring.count = 0;
	work->ring_is_open = false;
	for (uint32_t v = fans[0].first_vertex;
		!status && *fine && v < fans[1].first_vertex; v++)
		status = check_vertex(work, v, target, twins, fine, fault);
	if (!status && *fine)
		status = count_harm(work, node, fault);
	*fine = !status && *fine && count_broken(work) &&
		(work->settings.contact_cost < INFINITY ||
			!(work->broken > 0)) &&
		!is_pinched(work);
	if (*fine)
		status = check_doubles(work, node, target, fine, fault);
	if (!status && *fine)
		status = crossing_watch_allows(work, node, target, fine, fault);
	if (!status && *fine)
		status = collapse_is_strained(
			work, node, &work->is_strained, fault);
	return status;
}

/* ---- doing it ------------------------------------------------------------ */

static void
move_holds(struct collapses *work)
{
	for (size_t i = 0; i < work->moves.count; i++) {
		const struct seam_move *move = &work->moves.at[i];

		if (move->face == TCS_NONE)
			seams_open(work->seams, move->hold / 2);
		else
			seams_move_hold(
				work->seams, move->hold, move->face, move->off);
	}
}

static enum tcs_status
collapse_vertex(struct collapses *work, uint32_t vertex, uint32_t target,
	struct tcs_fault *fault)
{
	uint32_t half_edge = HALF_EDGE_NONE, gone[2], nodes[2];
	struct watch_ring ring;
	size_t count, faces;
	enum tcs_status status = spokes_of(work, vertex, &count, fault);

	for (size_t i = 0; !status && i < count; i++)
		if (node_of(work, work->spokes.at[i].to) == target)
			half_edge = work->spokes.at[i].half_edge;
	if (status || half_edge == HALF_EDGE_NONE)
		return status;
	ring = (struct watch_ring){vertex, work->spokes.at, count, target};
	error_watch_follow(work, &ring, 1, work->positions.at[target]);
	for (size_t i = 0; i < count; i++)
		if (staying_corners(work, count, i, target, nodes))
			crossing_watch_follow(work, work->spokes.at[i].face,
				work->positions.at[target]);
	faces = half_edges_collapse(work->mesh, half_edge, gone);
	work->face_count -= faces;
	for (size_t i = 0; i < faces; i++) {
		work->surfaces.at[work->features.at[gone[i]]]--;
		crossing_watch_drop(work, gone[i]);
	}
	return TCS_OK;
}

static void
join_borders(struct collapses *work, uint32_t node, uint32_t target)
{
	const struct quadric *from = borders_of(work, node);
	struct quadric *to = borders_of(work, target);

	if (from && to)
		quadric_add(to, from);
	else if (from)
		work->border_places.at[target] = work->border_places.at[node];
}

enum tcs_status
collapse_do(struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	enum tcs_status status = TCS_OK;

	move_holds(work);
	volume_watch_follow(work, node);
	cover_watch_follow(work);
	for (uint32_t v = fans[0].first_vertex;
		!status && v < fans[1].first_vertex; v++)
		status = collapse_vertex(work, v, target, fault);
	if (status)
		return status;
	quadric_add(&work->quadrics.at[target], &work->quadrics.at[node]);
	join_borders(work, node, target);
	work->areas.at[target] += work->areas.at[node];
	return TCS_OK;
}
