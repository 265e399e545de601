#include "solid_outline.h"

#include <stdlib.h>

#include "solid_loops.h"
#include "solid_slivers.h"

void
solid_outline_release(struct solid_outline *outline)
{
	solid_weld_release(&outline->weld);
	array_release(&outline->fragments);
	array_release(&outline->numbers);
	array_release(&outline->rims);
	array_release(&outline->face_rims);
	array_release(&outline->sorted);
	array_release(&outline->spans);
	array_release(&outline->rim_ends);
	array_release(&outline->face_fragments);
	array_release(&outline->joints);
	array_release(&outline->loops);
	array_release(&outline->loop_points);
	array_release(&outline->path);
	array_release(&outline->face_points);
	array_release(&outline->face_rings);
}

/* ---- edges ------------------------------------------------------------------- */

/* The input's points first, so that others become them. */
static enum tcs_status
points_begin(struct solid_outline *outline, const struct solid_carver *carver,
	struct tcs_fault *fault)
{
	const struct solid_point_list *points = &carver->pieces.points;
	size_t corners = carver->cells.corners.count;
	enum tcs_status status = solid_weld_begin(
		&outline->weld, carver->planes.tolerance, points->count, fault);

	array_clear(&outline->numbers);
	if (!status && array_grow(&outline->numbers, corners))
		status = fault_memory(fault);
	for (size_t i = 0; !status && i < points->count; i++) {
		uint32_t number;

		status = solid_weld_add(
			&outline->weld, points->at[i], &number, fault);
	}
	for (size_t i = 0; !status && i < corners; i++)
		outline->numbers.at[i] = UINT32_MAX;
	return status;
}

static enum tcs_status
corner_point(struct solid_outline *outline, const struct solid_cells *cells,
	uint32_t corner, uint32_t *point, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (outline->numbers.at[corner] == UINT32_MAX)
		status = solid_weld_add(&outline->weld,
			cells->corners.at[corner].at,
			&outline->numbers.at[corner], fault);
	*point = outline->numbers.at[corner];
	return status;
}

static enum tcs_status
fragment_rims(struct solid_outline *outline, const struct solid_cells *cells,
	const struct solid_fragment *fragment, struct tcs_fault *fault)
{
	const struct solid_facet *facet = &cells->facets.at[fragment->facet];

	if (array_grow(&outline->face_rims, facet->count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < facet->count; i++) {
		uint32_t entry = cells->loops.at[facet->first + i];
		const uint32_t *line = cells->edges.at[entry >> 1].planes;
		struct solid_rim rim = {.planes = {line[line[0] > line[1]],
						line[line[0] < line[1]]}};
		enum tcs_status status;

		entry ^= !fragment->up;
		status = corner_point(outline, cells,
			solid_loop_corner(cells, entry), &rim.from, fault);
		if (!status)
			status = corner_point(outline, cells,
				solid_loop_corner(cells, entry ^ 1), &rim.to,
				fault);
		if (status)
			return status;
		if (rim.from != rim.to)
			outline->face_rims.at[outline->face_rims.count++] = rim;
	}
	return TCS_OK;
}

static int
rim_order(const void *left, const void *right)
{
	const struct solid_rim *a = left, *b = right;
	uint32_t a_low = a->from < a->to ? a->from : a->to;
	uint32_t b_low = b->from < b->to ? b->from : b->to;
	uint32_t a_high = a->from ^ a->to ^ a_low;
	uint32_t b_high = b->from ^ b->to ^ b_low;

	if (a_low != b_low)
		return a_low < b_low ? -1 : 1;
	return (a_high > b_high) - (a_high < b_high);
}

enum tcs_status
solid_outline_cancel(struct solid_outline *outline, struct solid_rim *rims,
	size_t count, struct tcs_fault *fault)
{
	size_t end;

	if (!count)
		return TCS_OK;
	qsort(rims, count, sizeof *rims, rim_order);
	if (array_grow(&outline->rims, count))
		return fault_memory(fault);
	for (size_t first = 0; first < count; first = end) {
		struct solid_rim rim = rims[first];
		long balance = 0;

		for (end = first;
			end < count && !rim_order(&rims[first], &rims[end]);
			end++)
			balance += rims[end].from == rim.from ? 1 : -1;
		if (balance < 0) {
			rim.from = rims[first].to;
			rim.to = rims[first].from;
		}
		for (balance = labs(balance); balance; balance--)
			outline->rims.at[outline->rims.count++] = rim;
	}
	return TCS_OK;
}

static bool
same_face(const struct solid_fragment *a, const struct solid_fragment *b)
{
	return a->plane == b->plane && a->up == b->up &&
		a->origin == b->origin && a->face == b->face;
}

/* The edges of every face. */
static enum tcs_status
rims_collect(struct solid_outline *outline, const struct solid_cells *cells,
	struct tcs_fault *fault)
{
	const struct solid_fragment *fragments = outline->fragments.at;
	size_t count = outline->fragments.count, end;
	enum tcs_status status = TCS_OK;

	array_clear(&outline->rims);
	array_clear(&outline->rim_ends);
	array_clear(&outline->face_fragments);
	for (size_t first = 0; !status && first < count; first = end) {
		array_clear(&outline->face_rims);
		for (end = first; !status && end < count &&
			same_face(&fragments[first], &fragments[end]);
			end++)
			status = fragment_rims(
				outline, cells, &fragments[end], fault);
		if (!status)
			status = solid_outline_cancel(outline,
				outline->face_rims.at, outline->face_rims.count,
				fault);
		if (status)
			break;
		if (array_grow(&outline->rim_ends, 1) ||
			array_grow(&outline->face_fragments, 1))
			return fault_memory(fault);
		outline->rim_ends.at[outline->rim_ends.count++] =
			(uint32_t)outline->rims.count;
		outline->face_fragments.at[outline->face_fragments.count++] =
			(uint32_t)first;
	}
	return status;
}

/* ---- points within straight edges -------------------------------------------- */

static void
joint_meet(
	struct solid_joint *joint, uint32_t neighbour, const uint32_t planes[2])
{
	if ((joint->count > 0 && joint->neighbours[0] == neighbour) ||
		(joint->count > 1 && joint->neighbours[1] == neighbour))
		return;
	if (joint->count == 0) {
		joint->planes[0] = planes[0];
		joint->planes[1] = planes[1];
	}
	if (joint->count < 2)
		joint->neighbours[joint->count] = neighbour;
	if (joint->count == 1)
		joint->straight = joint->planes[0] == planes[0] &&
			joint->planes[1] == planes[1];
	if (joint->count == 2)
		joint->straight = false;
	joint->count += joint->count < 3;
}

static enum tcs_status
joints_begin(struct solid_outline *outline, struct tcs_fault *fault)
{
	size_t count = outline->weld.points.count;

	array_clear(&outline->joints);
	if (array_grow(&outline->joints, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		outline->joints.at[outline->joints.count++] =
			(struct solid_joint){.count = 0};
	return TCS_OK;
}

static void
joints_find(struct solid_outline *outline)
{
	for (size_t i = 0; i < outline->rims.count; i++) {
		const struct solid_rim *rim = &outline->rims.at[i];

		joint_meet(
			&outline->joints.at[rim->from], rim->to, rim->planes);
		joint_meet(
			&outline->joints.at[rim->to], rim->from, rim->planes);
	}
}

/* ---- faces ------------------------------------------------------------------- */

static enum tcs_status
ring_write(struct solid_outline *outline, const struct solid_loop *loop,
	struct tcs_point origin, struct tcs_fault *fault)
{
	if (array_grow(&outline->face_points, loop->count) ||
		array_grow(&outline->face_rings, 1))
		return fault_memory(fault);
	for (uint32_t i = 0; i < loop->count; i++) {
		uint32_t point = outline->loop_points.at[loop->first + i];

		outline->face_points.at[outline->face_points.count++] =
			point_plus(outline->weld.points.at[point], origin);
	}
	outline->face_rings.at[outline->face_rings.count++] = loop->count;
	return TCS_OK;
}

/* A loop with its holes as a face. */
static enum tcs_status
loop_write(struct solid_outline *outline, uint32_t number,
	const struct solid_fragment *like, struct tcs_point origin,
	struct solid *out, struct tcs_fault *fault)
{
	const struct solid_loop *loops = outline->loops.at;
	struct solid_face *face;
	enum tcs_status status;

	array_clear(&outline->face_points);
	array_clear(&outline->face_rings);
	status = ring_write(outline, &loops[number], origin, fault);
	for (size_t i = 0; !status && i < outline->loops.count; i++)
		if (loops[i].owner == number)
			status = ring_write(outline, &loops[i], origin, fault);
	if (!status)
		status = solid_add_face(out, outline->face_points.at,
			outline->face_rings.at, outline->face_rings.count,
			like->label, fault);
	if (status)
		return status;
	face = &out->faces.at[out->faces.count - 1];
	face->origin = like->origin;
	face->face = like->face;
	return TCS_OK;
}

static enum tcs_status
face_write(struct solid_outline *outline, const struct solid_carver *carver,
	size_t number, struct tcs_point origin, struct solid *out,
	struct tcs_fault *fault)
{
	const struct solid_fragment *like =
		&outline->fragments.at[outline->face_fragments.at[number]];
	size_t first = number ? outline->rim_ends.at[number - 1] : 0;
	struct solid_view view =
		solid_view_of(&carver->planes.list.at[like->plane], like->up);
	enum tcs_status status = solid_loops_walk(
		outline, view, first, outline->rim_ends.at[number], fault);

	for (uint32_t i = 0; !status && i < outline->loops.count; i++)
		if (outline->loops.at[i].owner == UINT32_MAX)
			status = loop_write(
				outline, i, like, origin, out, fault);
	return status;
}

enum tcs_status
solid_outline_write(struct solid_outline *outline,
	const struct solid_carver *carver, struct tcs_point origin,
	struct solid *out, struct tcs_fault *fault)
{
	enum tcs_status status = points_begin(outline, carver, fault);

	if (!status)
		status = rims_collect(outline, &carver->cells, fault);
	if (!status)
		status = joints_begin(outline, fault);
	if (!status)
		status = solid_slivers_join(outline, carver, fault);
	if (!status)
		joints_find(outline);
	for (size_t i = 0; !status && i < outline->rim_ends.count; i++)
		status = face_write(outline, carver, i, origin, out, fault);
	return status;
}
