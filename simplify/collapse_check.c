/*
 * What a collapse may not do to the mesh and its surfaces; what it does to seams
 * is in seam_moves.c.
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

/* Face i of the ring as it is, but for its first node; false where there is
   none. */
static inline bool
ring_face_at(const struct collapses *work, size_t count, size_t i,
	struct tcs_point from, struct ring_face *out)
{
	const struct spoke *spokes = work->spokes.at;

	out->face = spokes[i].face;
	if (out->face == HALF_EDGE_NONE)
		return false;
	out->nodes[1] = node_of(work, spokes[i].to);
	out->nodes[2] = node_of(work, spokes[i + 1 < count ? i + 1 : 0].to);
	out->shape.corner[0] = from;
	for (int k = 1; k < 3; k++)
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
is_sound(const struct collapses *work, const struct ring_face *before,
	const struct ring_face *after)
{
	double height;

	/* It never turns over, however many steps that takes. */
	if (vector_dot(after->normal, work->sheets->normals.at[after->face]) <
		0)
		return false;
	height = square_height(&after->shape, after->normal);
	return height >= LEAST_HEIGHT * LEAST_HEIGHT ||
		height >= square_height(&before->shape, before->normal);
}

/* Append face i of the ring once changed, if it stays, and the surface of one
   that goes; false if it may not be. */
static bool
change_face(struct collapses *work, size_t count, size_t i, uint32_t node,
	uint32_t target)
{
	struct ring_face before, *after;

	if (!ring_face_at(work, count, i, work->positions.at[node], &before)) {
		work->ring_is_open = true;
		return true;
	}
	work->strain.before += vector_length(before.normal);
	if (before.nodes[1] == target || before.nodes[2] == target) {
		work->leaving.at[work->leaving.count++] =
			work->features.at[before.face];
		return true;
	}
	after = &work->ring.at[work->ring.count++];
	after->face = before.face;
	after->shape = before.shape;
	after->shape.corner[0] = work->positions.at[target];
	after->normal = triangle_normal(&after->shape);
	after->nodes[0] = target;
	for (int k = 1; k < 3; k++)
		after->nodes[k] = before.nodes[k];
	work->strain.after += vector_length(after->normal);
	work->strain.turns |= vector_dot(before.normal, after->normal) < 0;
	return is_sound(work, &before, after);
}

/* All of them; *sound when all may be. */
static enum tcs_status
change_ring(struct collapses *work, size_t count, uint32_t node,
	uint32_t target, bool *sound, struct tcs_fault *fault)
{
	*sound = true;
	work->fan = work->ring.count;
	if (array_grow(&work->ring, count) || array_grow(&work->leaving, count))
		return fault_memory(fault);
	for (size_t i = 0; *sound && i < count; i++)
		*sound = change_face(work, count, i, node, target);
	return TCS_OK;
}

/* ---- surfaces ------------------------------------------------------------ */

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
		status = seam_moves_list(work, count, fault);
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
	work->strain = (struct strain){0};
	work->ring_is_open = false;
	for (uint32_t v = fans[0].first_vertex;
		!status && *fine && v < fans[1].first_vertex; v++)
		status = check_vertex(work, v, target, twins, fine, fault);
	if (!status && *fine)
		status = count_harm(work, node, fault);
	*fine = !status && *fine && seam_moves_break(work) &&
		(work->settings.contact_cost < INFINITY ||
			!(work->broken > 0)) &&
		!is_pinched(work);
	if (*fine)
		status = check_doubles(work, node, target, fine, fault);
	if (!status && *fine)
		status = crossing_watch_allows(work, node, target, fine, fault);
	work->is_strained = collapse_is_strained(&work->strain);
	return status;
}

/* ---- doing it ------------------------------------------------------------ */

/* The faces around a vertex that stay get their new corner. */
static void
stretch_faces(struct collapses *work, size_t count, uint32_t target)
{
	uint32_t component = work->sheets->nodes.at[target].component, nodes[2];
	struct float_box place = float_box_at(work->positions.at[target]);

	for (size_t i = 0; i < count; i++)
		if (staying_corners(work, count, i, target, nodes))
			crossing_watch_grow(work, component,
				work->spokes.at[i].face, &place);
}

static enum tcs_status
collapse_vertex(struct collapses *work, uint32_t vertex, uint32_t target,
	struct tcs_fault *fault)
{
	uint32_t half_edge = HALF_EDGE_NONE, gone[2];
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
	stretch_faces(work, count, target);
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

	seam_moves_do(work);
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
