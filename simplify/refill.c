/*
 * Triangles that take the place of other faces of the mesh: what that means
 * for seams, surfaces and costs.
 */
#include "collapses.h"

#include <stdlib.h>

#include "number_sort.h"

static enum tcs_status
know_sources(struct collapses *work, struct tcs_fault *fault)
{
	const struct sheets *sheets = work->sheets;
	size_t faces = sheets->face_triangles.count;

	if (work->sources.count > 0)
		return TCS_OK;
	if (array_grow(&work->sources, faces))
		return fault_memory(fault);
	for (size_t i = 0; i < faces; i++)
		work->sources.at[i] = sheets->face_triangles.at[i];
	work->sources.count = faces;
	return TCS_OK;
}

static enum tcs_status
list_nodes(struct collapses *work, const struct refill *refill,
	struct tcs_fault *fault)
{
	work->touched.count = 0;
	if (array_grow(
		    &work->touched, 3 * (refill->face_count + refill->count)))
		return fault_memory(fault);
	for (size_t i = 0; i < 3 * refill->count; i++)
		work->touched.at[work->touched.count++] =
			node_of(work, refill->corners[i]);
	for (size_t i = 0; i < refill->face_count; i++) {
		uint32_t *nodes = work->touched.at + work->touched.count;

		if (collapses_face(work, refill->faces[i], nodes))
			work->touched.count += 3;
	}
	return TCS_OK;
}

/* ---- surfaces ------------------------------------------------------------ */

/* What a triangle has of the face that it continues. */
struct inherited {
	uint32_t feature, source;
};

/* All of them are asked before any changes: a model may be one that goes. */
static enum tcs_status
inherit(struct collapses *work, const struct refill *refill,
	struct tcs_fault *fault)
{
	struct inherited *from =
		malloc((refill->count + 1) * sizeof(struct inherited));

	if (!from)
		return fault_memory(fault);
	for (size_t i = 0; i < refill->count; i++) {
		uint32_t model = refill->models[i];

		from[i] = (struct inherited){work->features.at[model],
			collapses_source(work, model)};
	}
	for (size_t i = 0; i < refill->face_count; i++)
		work->surfaces.at[work->features.at[refill->faces[i]]]--;
	for (size_t i = 0; i < refill->count; i++) {
		work->features.at[refill->numbers[i]] = from[i].feature;
		work->sources.at[refill->numbers[i]] = from[i].source;
		work->surfaces.at[from[i].feature]++;
	}
	work->face_count -= refill->face_count - refill->count;
	free(from);
	return TCS_OK;
}

static struct triangle_shape
shape_of(const struct collapses *work, const struct refill *refill,
	size_t triangle)
{
	struct triangle_shape shape;

	for (int k = 0; k < 3; k++)
		shape.corner[k] = refill_place(work, refill, triangle, k);
	return shape;
}

/* The nodes that are elsewhere now have left what they met. */
static void
move_nodes(struct collapses *work, const struct refill *refill)
{
	for (size_t i = 0; refill->places && i < 3 * refill->count; i++) {
		uint32_t node = node_of(work, refill->corners[i]);

		work->positions.at[node] = refill->places[i];
		work->seams->nodes.at[node] = TCS_NONE;
		if (work->settings.optimal)
			work->fixed.at[node] = true;
	}
}

/* What is known of the faces that change their place. */
static void
move_faces(struct collapses *work, const struct refill *refill)
{
	for (size_t i = 0; i < refill->face_count; i++)
		crossing_watch_drop(work, refill->faces[i]);
	for (size_t i = 0; i < refill->count; i++) {
		struct triangle_shape shape = shape_of(work, refill, i);
		struct tcs_point normal = triangle_normal(&shape);
		double length = vector_length(normal);

		if (length > 0)
			work->sheets->normals.at[refill->numbers[i]] =
				vector_scaled(normal, 1 / length);
		for (int k = 0; k < 3; k++)
			crossing_watch_follow(
				work, refill->numbers[i], shape.corner[k]);
	}
}

/* ---- seams --------------------------------------------------------------- */

/* The triangle that is nearest to the point of a hold. */
static struct seam_move
nearest(const struct collapses *work, const struct refill *refill,
	uint32_t hold)
{
	struct tcs_point point = work->seams->points.at[hold / 2].at;
	struct seam_move best = {hold, TCS_NONE, INFINITY};

	for (size_t i = 0; i < refill->count; i++) {
		struct triangle_shape shape = shape_of(work, refill, i);
		double off = vector_length(vector_difference(
			triangle_nearest(&shape, point), point));

		if (off < best.off)
			best = (struct seam_move){
				hold, refill->numbers[i], off};
	}
	return best;
}

static enum tcs_status
move_seams(struct collapses *work, const struct refill *refill,
	struct tcs_fault *fault)
{
	struct seams *seams = work->seams;

	work->moves.count = 0;
	for (size_t i = 0; i < refill->face_count; i++)
		for (uint32_t hold = seams->faces.at[refill->faces[i]];
			hold != TCS_NONE; hold = seams->holds.at[hold].next) {
			if (array_grow(&work->moves, 1))
				return fault_memory(fault);
			work->moves.at[work->moves.count++] =
				nearest(work, refill, hold);
		}
	for (size_t i = 0; i < work->moves.count; i++) {
		const struct seam_move *move = &work->moves.at[i];
		uint32_t point = move->hold / 2;
		double other = (double)seams->holds.at[move->hold ^ 1].off;

		/* Its other side was a face that went, too. */
		if (seams->holds.at[move->hold].face == TCS_NONE)
			continue;
		if (move->off + other <= (double)seams->points.at[point].limit)
			seams_move_hold(
				seams, move->hold, move->face, move->off);
		else if (refill->adds)
			seams_forget(seams, point);
		else
			seams_open(seams, point);
	}
	return TCS_OK;
}

/* ---- all of it ----------------------------------------------------------- */

/* The nodes of the faces, and those next to them. */
static enum tcs_status
judge_touched(struct collapses *work, struct tcs_fault *fault)
{
	uint32_t *nodes = work->touched.at;
	size_t own = work->touched.count, count;
	enum tcs_status status = TCS_OK;

	number_sort(nodes, own);
	for (size_t i = 0; !status && i < own; i++)
		if (i == 0 || nodes[i] != nodes[i - 1])
			status = collapses_weigh_node(work, nodes[i], fault);
	for (size_t i = 0; !status && i < own; i++) {
		uint32_t vertex;

		if (i > 0 && work->touched.at[i] == work->touched.at[i - 1])
			continue;
		vertex = work->sheets->nodes.at[work->touched.at[i]]
				 .first_vertex;
		status = collapses_judge(work, work->touched.at[i], fault);
		if (!status)
			status = spokes_of(work, vertex, &count, fault);
		if (status || array_grow(&work->touched, count))
			return status ? status : fault_memory(fault);
		for (size_t k = 0; k < count; k++)
			work->touched.at[work->touched.count++] =
				node_of(work, work->spokes.at[k].to);
	}
	for (size_t i = own; !status && i < work->touched.count; i++)
		status = collapses_judge(work, work->touched.at[i], fault);
	return status;
}

enum tcs_status
collapses_refill(struct collapses *work, const struct refill *refill,
	struct tcs_fault *fault)
{
	enum tcs_status status = know_sources(work, fault);

	if (!status)
		status = list_nodes(work, refill, fault);
	if (!status)
		status = move_seams(work, refill, fault);
	if (!status)
		volume_watch_refill(work, refill);
	if (!status)
		status = half_edges_refill(work->mesh, refill->faces,
			refill->face_count, refill->numbers, refill->corners,
			refill->count, fault);
	if (!status)
		status = inherit(work, refill, fault);
	if (status)
		return status;
	move_nodes(work, refill);
	move_faces(work, refill);
	return judge_touched(work, fault);
}
