#include "solid_inside.h"

#include <math.h>
#include <stdlib.h>

#include "solid_winding.h"

void
solid_inside_release(struct solid_inside *inside)
{
	array_release(&inside->panes);
	array_release(&inside->order);
	array_release(&inside->covers);
	array_release(&inside->windings);
	array_release(&inside->parents);
	array_release(&inside->depths);
}

/* ---- facets ------------------------------------------------------------------ */

static struct tcs_point
entry_point(const struct solid_cells *cells, uint32_t entry)
{
	return cells->corners.at[solid_loop_corner(cells, entry)].at;
}

static struct solid_pane
pane_of(const struct solid_cells *cells, uint32_t number)
{
	const struct solid_facet *facet = &cells->facets.at[number];
	const uint32_t *loop = cells->loops.at + facet->first;
	struct tcs_point first = entry_point(cells, loop[0]);
	struct tcs_point last = {0, 0, 0}, normal = last, sum = last;
	double around = 0, part;
	struct solid_pane pane = {.facet = number};

	for (uint32_t i = 1; i < facet->count; i++) {
		struct tcs_point here =
			point_minus(entry_point(cells, loop[i]), first);
		struct tcs_point edge = point_minus(here, last);

		normal = point_plus(normal, point_cross(last, here));
		around += sqrt(point_dot(edge, edge));
		sum = point_plus(sum, here);
		last = here;
	}
	around += sqrt(point_dot(last, last));
	part = 1.0 / facet->count;
	pane.centre = (struct tcs_point){first.x + sum.x * part,
		first.y + sum.y * part, first.z + sum.z * part};
	pane.area = sqrt(point_dot(normal, normal)) / 2;
	pane.width = around > 0 ? pane.area / around : 0;
	return pane;
}

enum { WIDTHS = 128 };

/* Each a factor of 2, from 2⁴⁰ on downwards. */
static unsigned
width_class(double width)
{
	int exponent;

	if (!(width > 0))
		return WIDTHS - 1;
	frexp(width, &exponent);
	exponent = 41 - exponent;
	return exponent < 0		 ? 0
		: exponent >= WIDTHS - 1 ? WIDTHS - 1
					 : (unsigned)exponent;
}

/* By the class of their width, then as they are. */
static enum tcs_status
panes_order(struct solid_inside *inside, struct tcs_fault *fault)
{
	uint32_t starts[WIDTHS + 1] = {0};

	array_clear(&inside->order);
	if (array_grow(&inside->order, inside->panes.count))
		return fault_memory(fault);
	inside->order.count = inside->panes.count;
	for (size_t i = 0; i < inside->panes.count; i++)
		starts[width_class(inside->panes.at[i].width) + 1]++;
	for (unsigned i = 0; i < WIDTHS; i++)
		starts[i + 1] += starts[i];
	for (uint32_t i = 0; i < inside->panes.count; i++) {
		unsigned class = width_class(inside->panes.at[i].width);

		inside->order.at[starts[class]++] = i;
	}
	return TCS_OK;
}

static enum tcs_status
panes_collect(struct solid_inside *inside, struct solid_cells *cells,
	struct tcs_fault *fault)
{
	size_t count = cells->facets.count;
	enum tcs_status status = TCS_OK;

	array_clear(&inside->panes);
	if (array_grow(&inside->panes, count))
		return fault_memory(fault);
	for (uint32_t i = 0; !status && i < count; i++) {
		const struct solid_facet *facet = &cells->facets.at[i];

		if (facet->half ||
			(facet->cells[0] == SOLID_OUTSIDE &&
				facet->cells[1] == SOLID_OUTSIDE))
			continue;
		status = solid_cells_loop(cells, i, fault);
		inside->panes.at[inside->panes.count++] = pane_of(cells, i);
	}
	return status ? status : panes_order(inside, fault);
}

/* ---- what covers them -------------------------------------------------------- */

static struct solid_cover
cover_of(const struct solid_carver *carver, const struct solid_pane *pane)
{
	const struct solid_facet *facet = &carver->cells.facets.at[pane->facet];
	struct solid_cover cover = {{{SOLID_NO_FACE, SOLID_NO_FACE},
					    {SOLID_NO_FACE, SOLID_NO_FACE}},
		{0, 0}};

	for (uint32_t i = 0; i < facet->cover_count; i++) {
		uint32_t number = carver->covers.at[facet->first_cover + i];
		const struct solid_piece *piece =
			&carver->pieces.list.at[number];
		unsigned who = piece->origin > 0 ? TOOLS : HOST;
		uint32_t *first = &cover.pieces[who][piece->side < 0];

		if (!solid_piece_holds(&carver->pieces, piece,
			    &carver->planes.list.at[facet->plane],
			    pane->centre))
			continue;
		cover.step[who] -= piece->side;
		if (piece->side && *first == SOLID_NO_FACE)
			*first = number;
	}
	return cover;
}

static enum tcs_status
covers_find(struct solid_inside *inside, const struct solid_carver *carver,
	struct tcs_fault *fault)
{
	array_clear(&inside->covers);
	if (array_grow(&inside->covers, inside->panes.count))
		return fault_memory(fault);
	for (size_t i = 0; i < inside->panes.count; i++)
		inside->covers.at[inside->covers.count++] =
			cover_of(carver, &inside->panes.at[i]);
	return TCS_OK;
}

/* ---- cells, joined by facets ------------------------------------------------- */

/*
 * The cell that stands for those joined to it. The windings of the others are
 * relative to their parents'; they become relative to it.
 */
static uint32_t
root_find(struct solid_inside *inside, uint32_t cell)
{
	uint32_t *parents = inside->parents.at, root = cell;
	struct solid_winding *windings = inside->windings.at, sum = {{0, 0}};

	for (; parents[root] != root; root = parents[root])
		for (unsigned who = 0; who < 2; who++)
			sum.times[who] += windings[root].times[who];
	while (parents[cell] != root && cell != root) {
		uint32_t parent = parents[cell];
		struct solid_winding own = windings[cell];

		windings[cell] = sum;
		parents[cell] = root;
		for (unsigned who = 0; who < 2; who++)
			sum.times[who] -= own.times[who];
		cell = parent;
	}
	return root;
}

static void
cells_join(struct solid_inside *inside, uint32_t below, uint32_t above,
	const int step[2])
{
	uint32_t from = root_find(inside, below), to = root_find(inside, above);
	struct solid_winding *windings = inside->windings.at;

	if (from == to)
		return;
	/* to + windings[above] = from + windings[below] + step */
	for (unsigned who = 0; who < 2; who++) {
		int under = below == from ? 0 : windings[below].times[who];
		int over = above == to ? 0 : windings[above].times[who];

		windings[to].times[who] = under + step[who] - over;
	}
	inside->parents.at[to] = from;
}

static enum tcs_status
cells_begin(struct solid_inside *inside, size_t count, struct tcs_fault *fault)
{
	array_clear(&inside->windings);
	array_clear(&inside->parents);
	array_clear(&inside->depths);
	if (array_grow(&inside->windings, count) ||
		array_grow(&inside->parents, count) ||
		array_grow(&inside->depths, count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < count; i++) {
		inside->windings.at[i] = (struct solid_winding){{0, 0}};
		inside->parents.at[i] = i;
		inside->depths.at[i] = 0;
	}
	inside->windings.count = inside->parents.count = count;
	inside->depths.count = count;
	return TCS_OK;
}

static const struct solid_facet *
pane_facet(const struct solid_inside *inside, const struct solid_cells *cells,
	size_t pane)
{
	return &cells->facets.at[inside->panes.at[pane].facet];
}

/* ---- one cell whose windings are known --------------------------------------- */

/* The mean of the centres of a cell's facets lies well within it. */
struct middle {
	struct tcs_point sum;
	uint32_t count;
};

static struct tcs_point
middle_of(const struct middle *middle)
{
	double part = 1.0 / middle->count;

	return (struct tcs_point){middle->sum.x * part, middle->sum.y * part,
		middle->sum.z * part};
}

static void
middles_sum(const struct solid_inside *inside, const struct solid_cells *cells,
	struct middle *middles)
{
	for (size_t i = 0; i < inside->panes.count; i++) {
		const struct solid_facet *facet = pane_facet(inside, cells, i);
		struct tcs_point centre = inside->panes.at[i].centre;

		for (unsigned j = 0; j < 2; j++) {
			struct middle *middle = &middles[facet->cells[j]];

			if (facet->cells[j] == SOLID_OUTSIDE)
				continue;
			middle->sum = point_plus(middle->sum, centre);
			middle->count++;
		}
	}
}

/* The cell whose middle is the furthest from its sides. */
static uint32_t
deepest_find(struct solid_inside *inside, const struct solid_carver *carver,
	const struct middle *middles)
{
	const struct solid_cells *cells = &carver->cells;
	double *depths = inside->depths.at;
	uint32_t deepest = 0;

	for (size_t i = 0; i < inside->depths.count; i++)
		depths[i] = middles[i].count ? INFINITY : -1;
	for (size_t i = 0; i < inside->panes.count; i++) {
		const struct solid_facet *facet = pane_facet(inside, cells, i);
		const struct solid_plane *plane =
			&carver->planes.list.at[facet->plane];

		for (unsigned j = 0; j < 2; j++) {
			uint32_t cell = facet->cells[j];

			if (cell != SOLID_OUTSIDE)
				depths[cell] = fmin(depths[cell],
					fabs(solid_plane_distance(plane,
						middle_of(&middles[cell]))));
		}
	}
	for (uint32_t i = 0; i < inside->depths.count; i++)
		if (depths[i] > depths[deepest])
			deepest = i;
	return deepest;
}

/* Make the windings absolute. */
static void
windings_fix(struct solid_inside *inside, const struct solid_carver *carver,
	const struct middle *middles)
{
	size_t count = inside->windings.count;
	uint32_t deepest = deepest_find(inside, carver, middles);
	uint32_t root = root_find(inside, deepest);
	struct solid_winding at =
		solid_winding_at(&carver->pieces, middle_of(&middles[deepest]));

	for (unsigned who = 0; who < 2 && deepest != root; who++)
		at.times[who] -= inside->windings.at[deepest].times[who];
	for (uint32_t i = 0; i < count; i++)
		root_find(inside, i);
	inside->windings.at[root] = (struct solid_winding){{0, 0}};
	for (uint32_t i = 0; i < count; i++)
		for (unsigned who = 0; who < 2; who++)
			inside->windings.at[i].times[who] += at.times[who];
}

/* Whether no facet to speak of says something else than the cells beside it. */
static bool
windings_agree(
	const struct solid_inside *inside, const struct solid_carver *carver)
{
	for (size_t i = 0; i < inside->panes.count; i++) {
		const uint32_t *cells =
			pane_facet(inside, &carver->cells, i)->cells;

		if (cells[0] == SOLID_OUTSIDE || cells[1] == SOLID_OUTSIDE ||
			inside->panes.at[i].width <=
				4 * carver->planes.tolerance)
			continue;
		for (unsigned who = 0; who < 2; who++)
			if (inside->windings.at[cells[1]].times[who] -
					inside->windings.at[cells[0]]
						.times[who] !=
				inside->covers.at[i].step[who])
				return false;
	}
	return true;
}

#define MOST_ANGLES 5e7 /* of pieces as seen from cells: some seconds */

/* Ask around every cell, where facets contradict each other. */
static void
windings_ask(struct solid_inside *inside, const struct solid_carver *carver,
	const struct middle *middles)
{
	size_t count = inside->windings.count;

	if ((double)count * (double)carver->pieces.list.count > MOST_ANGLES)
		return;
	for (size_t i = 0; i < count; i++)
		if (middles[i].count)
			inside->windings.at[i] = solid_winding_at(
				&carver->pieces, middle_of(&middles[i]));
}

static enum tcs_status
windings_find(struct solid_inside *inside, const struct solid_carver *carver,
	struct tcs_fault *fault)
{
	struct middle *middles =
		calloc(inside->windings.count, sizeof *middles);

	if (!middles)
		return fault_memory(fault);
	middles_sum(inside, &carver->cells, middles);
	windings_fix(inside, carver, middles);
	if (!windings_agree(inside, carver))
		windings_ask(inside, carver, middles);
	free(middles);
	return TCS_OK;
}

enum tcs_status
solid_inside_find(struct solid_inside *inside, struct solid_carver *carver,
	struct tcs_fault *fault)
{
	const struct solid_cells *cells = &carver->cells;
	enum tcs_status status = panes_collect(inside, &carver->cells, fault);

	if (!status)
		status = covers_find(inside, carver, fault);
	if (!status)
		status = cells_begin(inside, cells->cells.count, fault);
	if (status)
		return status;
	for (size_t i = 0; i < inside->order.count; i++) {
		uint32_t pane = inside->order.at[i];
		const struct solid_facet *facet =
			pane_facet(inside, cells, pane);

		if (facet->cells[0] != SOLID_OUTSIDE &&
			facet->cells[1] != SOLID_OUTSIDE)
			cells_join(inside, facet->cells[0], facet->cells[1],
				inside->covers.at[pane].step);
	}
	return windings_find(inside, carver, fault);
}
