#include "solid_carve.h"

#include <math.h>
#include <string.h>

#include "solid_choose.h"

enum { SIDES = 6 }; /* of the box: facets 0 to 5 */

void
solid_carver_release(struct solid_carver *carver)
{
	solid_planes_release(&carver->planes);
	solid_cells_release(&carver->cells);
	solid_pieces_release(&carver->pieces);
	array_release(&carver->covers);
	array_release(&carver->jobs);
	solid_items_release(&carver->items);
	solid_items_release(&carver->below);
	solid_items_release(&carver->above);
}

/* ---- the box ----------------------------------------------------------------- */

static enum tcs_status
box_planes(struct solid_carver *carver, struct tcs_point lower,
	struct tcs_point upper, uint32_t box[6], struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (unsigned i = 0; !status && i < SIDES; i++) {
		struct tcs_point axis = {i < 2, i / 2 == 1, i / 2 == 2};
		int side;

		status = solid_planes_place(&carver->planes,
			i % 2 ? upper : lower, axis, &box[i], &side, fault);
	}
	return status;
}

enum tcs_status
solid_carve_begin(struct solid_carver *carver, struct tcs_point lower,
	struct tcs_point upper, double tolerance, struct tcs_fault *fault)
{
	double extent = fmax(fmax(fmax(fabs(lower.x), fabs(lower.y)),
				     fmax(fabs(lower.z), fabs(upper.x))),
		fmax(fabs(upper.y), fabs(upper.z)));
	uint32_t box[SIDES];
	enum tcs_status status;

	array_clear(&carver->covers);
	array_clear(&carver->jobs);
	array_clear(&carver->items.list);
	array_clear(&carver->items.points);
	solid_pieces_clear(&carver->pieces);
	carver->too_many = false;
	status = solid_planes_begin(&carver->planes, tolerance, extent, fault);
	if (!status)
		status = box_planes(carver, lower, upper, box, fault);
	if (!status)
		status = solid_cells_begin(
			&carver->cells, &carver->planes.list, box, fault);
	if (!status && array_grow(&carver->jobs, 1))
		status = fault_memory(fault);
	if (!status)
		carver->jobs.at[carver->jobs.count++] =
			(struct solid_job){0, 0, 0};
	return status;
}

/* Into the plane that stands for the piece's own. */
static void
points_flatten(struct solid_point_list *points, const struct solid_plane *plane)
{
	struct tcs_point n = plane->normal;

	for (size_t i = 0; i < points->count; i++) {
		double off = solid_plane_distance(plane, points->at[i]);

		points->at[i] = point_minus(points->at[i],
			(struct tcs_point){n.x * off, n.y * off, n.z * off});
	}
}

/* The piece cut to the box, one facet after the other, into `below`. */
static enum tcs_status
piece_fill(
	struct solid_carver *carver, uint32_t number, struct tcs_fault *fault)
{
	const struct solid_piece *piece = &carver->pieces.list.at[number];
	const struct tcs_point *points =
		carver->pieces.points.at + piece->first;
	struct solid_items *from = &carver->below, *to = &carver->above;
	enum tcs_status status;

	array_clear(&from->list);
	array_clear(&from->points);
	status = solid_items_add(from, number, points, piece->count, fault);
	if (!status)
		points_flatten(
			&from->points, &carver->planes.list.at[piece->plane]);
	for (uint32_t i = 0; !status && from->list.count && i < SIDES; i++) {
		const struct solid_facet *facet = &carver->cells.facets.at[i];
		struct solid_items *other = from;

		array_clear(&to->list);
		array_clear(&to->points);
		status = solid_items_clip(to, number, from->points.at,
			from->points.count,
			&carver->planes.list.at[facet->plane], i % 2 ? -1 : 1,
			fault);
		from = to;
		to = other;
	}
	if (!status && from->list.count)
		status = solid_items_add(&carver->items, number,
			from->points.at, from->points.count, fault);
	return status;
}

static enum tcs_status
cover_add(struct solid_carver *carver, struct solid_facet *facet,
	uint32_t piece, struct tcs_fault *fault)
{
	if (carver->covers.count >= UINT32_MAX ||
		array_grow(&carver->covers, 1))
		return fault_memory(fault);
	if (!facet->cover_count)
		facet->first_cover = (uint32_t)carver->covers.count;
	carver->covers.at[carver->covers.count++] = piece;
	facet->cover_count++;
	return TCS_OK;
}

/* The pieces in the plane of one side of the box. */
static enum tcs_status
side_fill(struct solid_carver *carver, uint32_t side, struct tcs_fault *fault)
{
	struct solid_facet *facet = &carver->cells.facets.at[side];
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < carver->pieces.list.count; i++)
		if (carver->pieces.list.at[i].plane == facet->plane)
			status = cover_add(carver, facet, i, fault);
	return status;
}

enum tcs_status
solid_carve_fill(struct solid_carver *carver, struct tcs_fault *fault)
{
	const struct solid_facet *facets = carver->cells.facets.at;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < SIDES; i++)
		status = side_fill(carver, i, fault);
	for (uint32_t i = 0; !status && i < carver->pieces.list.count; i++) {
		uint32_t plane = carver->pieces.list.at[i].plane, side = 0;

		while (side < SIDES && facets[side].plane != plane)
			side++;
		if (side == SIDES)
			status = piece_fill(carver, i, fault);
	}
	return status;
}

/* ---- one cut ----------------------------------------------------------------- */

/*
 * How far an item may reach through a plane and be left out there. Nothing of
 * one that is nearly parallel, which may be wide however near it is.
 */
static double
slack_of(const struct solid_carver *carver, const struct solid_plane *plane,
	const struct solid_item *item)
{
	uint32_t own = carver->pieces.list.at[item->piece].plane;
	double cosine =
		point_dot(carver->planes.list.at[own].normal, plane->normal);

	return fabs(cosine) > 0.9 ? 0 : carver->planes.tolerance / 32;
}

/* An item to the sides of the plane that it reaches into; to one at least. */
static enum tcs_status
item_part(struct solid_carver *carver, const struct solid_plane *plane,
	const struct solid_item *item, const struct tcs_point *points,
	struct tcs_fault *fault)
{
	double slack = slack_of(carver, plane, item);
	struct solid_range range = solid_range_of(plane, points, item->count);
	bool below = range.low<-slack, above = range.high> slack;
	enum tcs_status status;

	if (below && above) {
		status = solid_items_clip(&carver->below, item->piece, points,
			item->count, plane, -1, fault);
		return status ? status
			      : solid_items_clip(&carver->above, item->piece,
					points, item->count, plane, 1, fault);
	}
	if (!below && !above)
		above = range.high > -range.low;
	return solid_items_add(above ? &carver->above : &carver->below,
		item->piece, points, item->count, fault);
}

/* The items of the last job by the side of a plane; those in it cover the last
 * facet. */
static enum tcs_status
items_part(struct solid_carver *carver, const struct solid_job *job,
	uint32_t plane, struct tcs_fault *fault)
{
	struct solid_facet *facet =
		&carver->cells.facets.at[carver->cells.facets.count - 1];
	size_t first = job->first_point;
	enum tcs_status status = TCS_OK;

	array_clear(&carver->below.list);
	array_clear(&carver->below.points);
	array_clear(&carver->above.list);
	array_clear(&carver->above.points);
	for (size_t i = job->first_item;
		!status && i < carver->items.list.count; i++) {
		const struct solid_item *item = &carver->items.list.at[i];

		if (carver->pieces.list.at[item->piece].plane == plane)
			status = cover_add(carver, facet, item->piece, fault);
		else
			status = item_part(carver,
				&carver->planes.list.at[plane], item,
				carver->items.points.at + first, fault);
		first += item->count;
	}
	return status;
}

static enum tcs_status
job_push(struct solid_carver *carver, uint32_t cell,
	const struct solid_items *items, struct tcs_fault *fault)
{
	struct solid_items *to = &carver->items;

	if (array_grow(&carver->jobs, 1) ||
		array_grow(&to->list, items->list.count) ||
		array_grow(&to->points, items->points.count))
		return fault_memory(fault);
	carver->jobs.at[carver->jobs.count++] =
		(struct solid_job){cell, to->list.count, to->points.count};
	if (!items->list.count)
		return TCS_OK;
	memcpy(to->list.at + to->list.count, items->list.at,
		items->list.count * sizeof *items->list.at);
	memcpy(to->points.at + to->points.count, items->points.at,
		items->points.count * sizeof *items->points.at);
	to->list.count += items->list.count;
	to->points.count += items->points.count;
	return TCS_OK;
}

/* Forget the job's items in a plane that does not cut its cell. */
static bool
items_forget(struct solid_carver *carver, const struct solid_job *job,
	uint32_t plane)
{
	struct solid_items *items = &carver->items;
	size_t count = items->list.count, kept = job->first_item;
	const struct tcs_point *from = items->points.at + job->first_point;
	struct tcs_point *to = items->points.at + job->first_point;

	for (size_t i = job->first_item; i < count; i++) {
		struct solid_item item = items->list.at[i];

		if (carver->pieces.list.at[item.piece].plane != plane) {
			memmove(to, from, item.count * sizeof *to);
			to += item.count;
			items->list.at[kept++] = item;
		}
		from += item.count;
	}
	items->list.count = kept;
	items->points.count = (size_t)(to - items->points.at);
	return kept < count;
}

/* The cover of a facet that is half of one that was cut: what reaches it. */
static enum tcs_status
cover_part(struct solid_carver *carver, uint32_t number,
	const struct solid_plane *plane, int side, struct tcs_fault *fault)
{
	struct solid_facet *facet = &carver->cells.facets.at[number];
	const struct solid_pieces *pieces = &carver->pieces;
	uint32_t first = facet->first_cover, count = facet->cover_count;
	enum tcs_status status = TCS_OK;

	facet->cover_count = 0;
	for (uint32_t i = 0; !status && i < count; i++) {
		uint32_t piece = carver->covers.at[first + i];
		const struct solid_piece *of = &pieces->list.at[piece];
		struct solid_range range = solid_range_of(
			plane, pieces->points.at + of->first, of->count);

		if (side > 0 ? range.high > 0 : range.low < 0)
			status = cover_add(carver, facet, piece, fault);
	}
	return status;
}

enum { FEW_COVERS = 8 };

/* Facets from `first` on come in pairs, below the plane and above it; the last
 * one is that between. */
static enum tcs_status
covers_part(struct solid_carver *carver, size_t first, uint32_t plane,
	struct tcs_fault *fault)
{
	size_t last = carver->cells.facets.count - 1;
	enum tcs_status status = TCS_OK;

	for (size_t i = first; !status && i < last; i++)
		if (carver->cells.facets.at[i].cover_count > FEW_COVERS)
			status = cover_part(carver, (uint32_t)i,
				&carver->planes.list.at[plane],
				(i - first) % 2 ? 1 : -1, fault);
	return status;
}

/* The last job by a plane. *side as with solid_cells_cut; where it is 0, the
 * job has become two, the upper half's the last. */
static enum tcs_status
job_cut(struct solid_carver *carver, uint32_t plane, int *side,
	struct tcs_fault *fault)
{
	struct solid_job job = carver->jobs.at[carver->jobs.count - 1];
	size_t facets = carver->cells.facets.count;
	enum tcs_status status =
		solid_cells_cut(&carver->cells, job.cell, plane, side, fault);

	if (status || *side)
		return status;
	status = covers_part(carver, facets, plane, fault);
	if (!status)
		status = items_part(carver, &job, plane, fault);
	carver->jobs.count--;
	carver->items.list.count = job.first_item;
	carver->items.points.count = job.first_point;
	if (!status)
		status = job_push(carver, job.cell, &carver->below, fault);
	if (!status)
		status = job_push(carver,
			(uint32_t)carver->cells.cells.count - 1, &carver->above,
			fault);
	return status;
}

/* ---- all cuts ---------------------------------------------------------------- */

/* What a cell shares with its neighbours, they share with the outside. */
static void
cell_drop(struct solid_cells *cells, uint32_t cell)
{
	for (size_t i = 0; i < cells->facets.count; i++) {
		struct solid_facet *facet = &cells->facets.at[i];

		for (unsigned j = 0; j < 2; j++)
			if (facet->cells[j] == cell)
				facet->cells[j] = SOLID_OUTSIDE;
	}
}

enum tcs_status
solid_carve_drop(struct solid_carver *carver, uint32_t plane, int side,
	bool *empty, struct tcs_fault *fault)
{
	struct solid_job *jobs;
	int found;
	enum tcs_status status = job_cut(carver, plane, &found, fault);

	*empty = !status && found == side;
	if (status || found)
		return status;
	jobs = carver->jobs.at;
	if (side > 0) {
		cell_drop(&carver->cells, jobs[1].cell);
		carver->items.list.count = jobs[1].first_item;
		carver->items.points.count = jobs[1].first_point;
	} else {
		struct solid_job upper = jobs[1];

		cell_drop(&carver->cells, jobs[0].cell);
		carver->items.list.count = 0;
		carver->items.points.count = 0;
		carver->jobs.count = 0;
		return job_push(carver, upper.cell, &carver->above, fault);
	}
	carver->jobs.count = 1;
	return TCS_OK;
}

/* The plane to cut the last job by, at an axis unless that was in vain. */
static enum tcs_status
plane_choose(struct solid_carver *carver, bool *by_axis, uint32_t *plane,
	struct tcs_fault *fault)
{
	const struct solid_job *job = &carver->jobs.at[carver->jobs.count - 1];
	struct tcs_point at = {0, 0, 0}, normal = {0, 0, 0};
	int axis, side;
	double along;

	*plane = solid_choose(&carver->pieces, carver->planes.list.at,
		carver->planes.tolerance / 32,
		carver->items.list.at + job->first_item,
		carver->items.list.count - job->first_item,
		carver->items.points.at + job->first_point, &axis, &along);
	*by_axis = *by_axis && axis >= 0;
	if (!*by_axis)
		return TCS_OK;
	*(axis == 0 ? &at.x : axis == 1 ? &at.y : &at.z) = along;
	*(axis == 0 ? &normal.x : axis == 1 ? &normal.y : &normal.z) = 1;
	return solid_planes_place(
		&carver->planes, at, normal, plane, &side, fault);
}

static enum tcs_status
job_do(struct solid_carver *carver, struct tcs_fault *fault)
{
	size_t last = carver->jobs.count - 1;
	bool by_axis = true;

	while (carver->items.list.count > carver->jobs.at[last].first_item) {
		uint32_t plane;
		int side = 0;
		enum tcs_status status =
			plane_choose(carver, &by_axis, &plane, fault);

		if (!status)
			status = job_cut(carver, plane, &side, fault);
		if (status || !side)
			return status;
		by_axis = items_forget(carver, &carver->jobs.at[last], plane);
	}
	carver->jobs.count--;
	return TCS_OK;
}

enum tcs_status
solid_carve(struct solid_carver *carver, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	while (!status && carver->jobs.count && !carver->too_many) {
		status = job_do(carver, fault);
		carver->too_many = carver->cells.cells.count > SOLID_MOST_CELLS;
	}
	return status;
}
