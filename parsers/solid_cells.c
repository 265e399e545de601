#include "solid_cells.h"

#include <string.h>

void
solid_cells_release(struct solid_cells *cells)
{
	array_release(&cells->corners);
	array_release(&cells->edges);
	array_release(&cells->facets);
	array_release(&cells->cells);
	array_release(&cells->loops);
	array_release(&cells->shells);
	array_release(&cells->sides);
	array_release(&cells->marks);
	array_release(&cells->links);
	array_release(&cells->stack);
	array_release(&cells->shell);
	array_release(&cells->below);
	array_release(&cells->above);
}

/* ---- adding ------------------------------------------------------------------ */

/* Indices are 32 bits and loops hold them doubled. */
static bool
is_full(size_t count)
{
	return count >= UINT32_MAX / 4;
}

static enum tcs_status
corner_add(struct solid_cells *cells, uint32_t a, uint32_t b, uint32_t c,
	uint32_t *corner, struct tcs_fault *fault)
{
	if (is_full(cells->corners.count) || array_grow(&cells->corners, 1) ||
		array_grow(&cells->sides, 1) || array_grow(&cells->marks, 1) ||
		array_grow(&cells->links, 1))
		return fault_memory(fault);
	*corner = (uint32_t)cells->corners.count;
	cells->corners.at[cells->corners.count++] =
		solid_corner_of(cells->planes->at, a, b, c);
	cells->sides.at[cells->sides.count++] = 0;
	cells->marks.at[cells->marks.count++] = 0;
	cells->links.at[cells->links.count++] = 0;
	return TCS_OK;
}

static enum tcs_status
edge_add(struct solid_cells *cells, uint32_t from, uint32_t to, uint32_t a,
	uint32_t b, struct tcs_fault *fault)
{
	if (is_full(cells->edges.count) || array_grow(&cells->edges, 1))
		return fault_memory(fault);
	cells->edges.at[cells->edges.count++] =
		(struct solid_edge){from, to, {a, b}, 0};
	return TCS_OK;
}

static enum tcs_status
number_push(
	struct solid_numbers *numbers, uint32_t number, struct tcs_fault *fault)
{
	if (is_full(numbers->count) || array_grow(numbers, 1))
		return fault_memory(fault);
	numbers->at[numbers->count++] = number;
	return TCS_OK;
}

static enum tcs_status
facet_add(struct solid_cells *cells, const struct solid_facet *facet,
	struct tcs_fault *fault)
{
	if (is_full(cells->facets.count) || array_grow(&cells->facets, 1))
		return fault_memory(fault);
	cells->facets.at[cells->facets.count++] = *facet;
	return TCS_OK;
}

/* ---- the box ----------------------------------------------------------------- */

/* Corners by bits: 1 upper x, 2 upper y, 4 upper z. */
static const unsigned char box_edges[12][2] = {{0, 1}, {2, 3}, {4, 5}, {6, 7},
	{0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

/* Of lower x, upper x, …: entries of the loop, counterclockwise from above. */
static const unsigned char box_loops[6][4] = {
	{8, 20, 13, 17},
	{10, 22, 15, 19},
	{16, 4, 19, 1},
	{20, 6, 23, 3},
	{0, 10, 3, 9},
	{4, 14, 7, 13},
};

/* The planes of a corner of the box: one of each axis. */
static uint32_t
box_plane(const uint32_t box[6], unsigned corner, unsigned axis)
{
	return box[2 * axis + (corner >> axis & 1)];
}

static enum tcs_status
box_corners(struct solid_cells *cells, const uint32_t box[6],
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (unsigned i = 0; !status && i < 8; i++) {
		uint32_t corner;

		status = corner_add(cells, box_plane(box, i, 0),
			box_plane(box, i, 1), box_plane(box, i, 2), &corner,
			fault);
	}
	return status;
}

static enum tcs_status
box_lines(struct solid_cells *cells, const uint32_t box[6],
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (unsigned i = 0; !status && i < 12; i++) {
		unsigned axis = i / 4, from = box_edges[i][0];

		status = edge_add(cells, from, box_edges[i][1],
			box_plane(box, from, (axis + 1) % 3),
			box_plane(box, from, (axis + 2) % 3), fault);
	}
	return status;
}

static enum tcs_status
box_facets(struct solid_cells *cells, const uint32_t box[6],
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < 6; i++) {
		struct solid_facet facet = {.plane = box[i],
			.cells = {i % 2 ? 0 : SOLID_OUTSIDE,
				i % 2 ? SOLID_OUTSIDE : 0},
			.first = 4 * i,
			.count = 4};

		for (unsigned j = 0; !status && j < 4; j++)
			status = number_push(
				&cells->loops, box_loops[i][j], fault);
		if (!status)
			status = number_push(&cells->shells, i, fault);
		if (!status)
			status = facet_add(cells, &facet, fault);
	}
	return status;
}

enum tcs_status
solid_cells_begin(struct solid_cells *cells, struct solid_plane_list *planes,
	const uint32_t box[6], struct tcs_fault *fault)
{
	enum tcs_status status;

	cells->planes = planes;
	cells->mark = 0;
	array_clear(&cells->corners);
	array_clear(&cells->edges);
	array_clear(&cells->facets);
	array_clear(&cells->cells);
	array_clear(&cells->loops);
	array_clear(&cells->shells);
	array_clear(&cells->sides);
	array_clear(&cells->marks);
	array_clear(&cells->links);
	if (array_grow(&cells->cells, 1))
		return fault_memory(fault);
	cells->cells.at[cells->cells.count++] = (struct solid_cell){0, 6};
	status = box_corners(cells, box, fault);
	if (!status)
		status = box_lines(cells, box, fault);
	if (!status)
		status = box_facets(cells, box, fault);
	return status;
}

/* ---- reading what may be cut ------------------------------------------------- */

/* Replace an entry on top of the stack by its halves until it is whole. */
static enum tcs_status
entry_expand(struct solid_cells *cells, uint32_t entry, struct tcs_fault *fault)
{
	size_t bottom = cells->stack.count;
	enum tcs_status status = number_push(&cells->stack, entry, fault);

	while (!status && cells->stack.count > bottom) {
		uint32_t half;

		entry = cells->stack.at[--cells->stack.count];
		half = cells->edges.at[entry >> 1].half;
		if (!half) {
			status = number_push(&cells->loops, entry, fault);
			continue;
		}
		half = 2 * half + (entry & 1);
		status = number_push(
			&cells->stack, entry & 1 ? half : half + 2, fault);
		if (!status)
			status = number_push(&cells->stack,
				entry & 1 ? half + 2 : half, fault);
	}
	return status;
}

enum tcs_status
solid_cells_loop(
	struct solid_cells *cells, uint32_t number, struct tcs_fault *fault)
{
	struct solid_facet *facet = &cells->facets.at[number];
	size_t first = cells->loops.count;
	enum tcs_status status = TCS_OK;
	bool whole = true;

	for (size_t i = 0; i < facet->count; i++) {
		uint32_t entry = cells->loops.at[facet->first + i];

		whole = whole && !cells->edges.at[entry >> 1].half;
	}
	if (whole)
		return TCS_OK;
	for (size_t i = 0; !status && i < facet->count; i++)
		status = entry_expand(
			cells, cells->loops.at[facet->first + i], fault);
	facet->first = (uint32_t)first;
	facet->count = (uint32_t)(cells->loops.count - first);
	return status;
}

/* The cell's facets that are whole, with their loops up to date. */
static enum tcs_status
shell_read(struct solid_cells *cells, uint32_t cell, struct tcs_fault *fault)
{
	const struct solid_cell *of = &cells->cells.at[cell];
	enum tcs_status status = TCS_OK;

	array_clear(&cells->shell);
	array_clear(&cells->stack);
	if (array_grow(&cells->stack, of->count))
		return fault_memory(fault);
	for (uint32_t i = of->count; i; i--)
		cells->stack.at[cells->stack.count++] =
			cells->shells.at[of->first + i - 1];
	while (!status && cells->stack.count) {
		uint32_t facet = cells->stack.at[--cells->stack.count];
		uint32_t half = cells->facets.at[facet].half;

		if (!half) {
			status = number_push(&cells->shell, facet, fault);
			continue;
		}
		status = number_push(&cells->stack, half + 1, fault);
		if (!status)
			status = number_push(&cells->stack, half, fault);
	}
	for (size_t i = 0; !status && i < cells->shell.count; i++)
		status = solid_cells_loop(cells, cells->shell.at[i], fault);
	return status;
}

/* ---- cutting ----------------------------------------------------------------- */

enum { BELOW = 1, ABOVE = 2 };

static unsigned
side_bit(signed char side)
{
	return side < 0 ? BELOW : side > 0 ? ABOVE : 0;
}

/* On which sides of the plane the shell has corners. */
static unsigned
corners_part(struct solid_cells *cells, uint32_t plane)
{
	unsigned found = 0;

	cells->mark++;
	for (size_t i = 0; i < cells->shell.count; i++) {
		const struct solid_facet *facet =
			&cells->facets.at[cells->shell.at[i]];

		for (size_t j = 0; j < facet->count; j++) {
			uint32_t corner = solid_loop_corner(
				cells, cells->loops.at[facet->first + j]);

			if (cells->marks.at[corner] == cells->mark)
				continue;
			cells->marks.at[corner] = cells->mark;
			cells->sides.at[corner] =
				(signed char)solid_corner_side(
					cells->planes->at,
					&cells->corners.at[corner], plane);
			found |= side_bit(cells->sides.at[corner]);
		}
	}
	return found;
}

static enum tcs_status
edge_cut(struct solid_cells *cells, uint32_t number, uint32_t plane,
	struct tcs_fault *fault)
{
	struct solid_edge edge = cells->edges.at[number];
	uint32_t corner, half = (uint32_t)cells->edges.count;
	enum tcs_status status = corner_add(
		cells, edge.planes[0], edge.planes[1], plane, &corner, fault);

	if (status)
		return status;
	cells->marks.at[corner] = cells->mark;
	status = edge_add(cells, edge.from, corner, edge.planes[0],
		edge.planes[1], fault);
	if (!status)
		status = edge_add(cells, corner, edge.to, edge.planes[0],
			edge.planes[1], fault);
	if (!status)
		cells->edges.at[number].half = half;
	return status;
}

static enum tcs_status
edges_cut(struct solid_cells *cells, const struct solid_facet *facet,
	uint32_t plane, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint32_t first = facet->first, count = facet->count;

	for (uint32_t j = 0; !status && j < count; j++) {
		uint32_t number = cells->loops.at[first + j] >> 1;
		const struct solid_edge *edge = &cells->edges.at[number];

		if (!edge->half &&
			cells->sides.at[edge->from] *
					cells->sides.at[edge->to] <
				0)
			status = edge_cut(cells, number, plane, fault);
	}
	return status;
}

/* BELOW or ABOVE, as one end of the entry's edge says. */
static unsigned
entry_side(const struct solid_cells *cells, uint32_t entry)
{
	const struct solid_edge *edge = &cells->edges.at[entry >> 1];

	return side_bit(cells->sides.at[edge->from]) |
		side_bit(cells->sides.at[edge->to]);
}

static unsigned
facet_side(const struct solid_cells *cells, uint32_t number)
{
	const struct solid_facet *facet = &cells->facets.at[number];
	unsigned found = 0;

	for (uint32_t j = 0; j < facet->count; j++)
		found |= entry_side(cells, cells->loops.at[facet->first + j]);
	return found;
}

/* Append the run of entries on one side as the start of its half's loop. */
static enum tcs_status
half_loop(struct solid_cells *cells, const struct solid_facet *whole,
	unsigned side, uint32_t start, struct solid_facet *half,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	half->first = (uint32_t)cells->loops.count;
	for (uint32_t i = 0; !status && i < whole->count; i++) {
		uint32_t entry =
			cells->loops
				.at[whole->first + (start + i) % whole->count];

		if (entry_side(cells, entry) == side)
			status = number_push(&cells->loops, entry, fault);
	}
	half->count = (uint32_t)(cells->loops.count - half->first);
	return status;
}

/* Where the run of entries below the plane starts. */
static uint32_t
run_start(const struct solid_cells *cells, const struct solid_facet *facet)
{
	uint32_t last = facet->count - 1;

	for (uint32_t i = 0; i < facet->count; last = i++) {
		uint32_t before = cells->loops.at[facet->first + last];
		uint32_t entry = cells->loops.at[facet->first + i];

		if (entry_side(cells, entry) == BELOW &&
			entry_side(cells, before) != BELOW)
			return i;
	}
	return 0;
}

static enum tcs_status
facet_cut(struct solid_cells *cells, uint32_t number, uint32_t plane,
	struct tcs_fault *fault)
{
	struct solid_facet whole = cells->facets.at[number];
	struct solid_facet below = whole, above = whole;
	uint32_t edge = (uint32_t)cells->edges.count;
	uint32_t half = (uint32_t)cells->facets.count;
	uint32_t start = run_start(cells, &whole), from, to;
	enum tcs_status status =
		half_loop(cells, &whole, BELOW, start, &below, fault);

	if (!status)
		status = number_push(&cells->loops, 2 * edge, fault);
	if (!status)
		status = half_loop(cells, &whole, ABOVE, start + below.count,
			&above, fault);
	if (!status)
		status = number_push(&cells->loops, 2 * edge + 1, fault);
	if (status)
		return status;
	to = solid_loop_corner(cells, cells->loops.at[below.first]);
	from = solid_loop_corner(cells, cells->loops.at[above.first]);
	below.count++;
	above.count++;
	status = edge_add(cells, from, to, whole.plane, plane, fault);
	if (!status)
		status = facet_add(cells, &below, fault);
	if (!status)
		status = facet_add(cells, &above, fault);
	if (!status)
		cells->facets.at[number].half = half;
	return status;
}

/* Cut what is to be cut of the shell and sort it into `below` and `above`. */
static enum tcs_status
shell_part(struct solid_cells *cells, uint32_t plane, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	array_clear(&cells->below);
	array_clear(&cells->above);
	for (size_t i = 0; !status && i < cells->shell.count; i++) {
		uint32_t facet = cells->shell.at[i], half;
		unsigned side = facet_side(cells, facet);

		if (side != (BELOW | ABOVE)) {
			status = number_push(
				side == BELOW ? &cells->below : &cells->above,
				facet, fault);
			continue;
		}
		status = edges_cut(
			cells, &cells->facets.at[facet], plane, fault);
		if (!status)
			status = solid_cells_loop(cells, facet, fault);
		if (!status)
			status = facet_cut(cells, facet, plane, fault);
		half = cells->facets.at[facet].half;
		if (!status)
			status = number_push(&cells->below, half, fault);
		if (!status)
			status = number_push(&cells->above, half + 1, fault);
	}
	return status;
}

/*
 * Link the edges of the facets below that lie in the plane to a cycle, as it
 * runs around the new facet. Returns one of them and counts them.
 */
static uint32_t
cycle_link(struct solid_cells *cells, uint32_t cell, size_t *count)
{
	uint32_t any = 0;

	*count = 0;
	for (size_t i = 0; i < cells->below.count; i++) {
		const struct solid_facet *facet =
			&cells->facets.at[cells->below.at[i]];
		uint32_t turn = facet->cells[0] == cell;

		for (size_t j = 0; j < facet->count; j++) {
			uint32_t entry = cells->loops.at[facet->first + j];

			if (entry_side(cells, entry))
				continue;
			any = entry ^ turn;
			cells->links.at[solid_loop_corner(cells, any)] = any;
			++*count;
		}
	}
	return any;
}

static enum tcs_status
cap_add(struct solid_cells *cells, uint32_t cell, uint32_t plane,
	struct tcs_fault *fault)
{
	size_t count;
	uint32_t entry = cycle_link(cells, cell, &count);
	struct solid_facet cap = {.plane = plane,
		.cells = {cell, (uint32_t)cells->cells.count},
		.first = (uint32_t)cells->loops.count,
		.count = (uint32_t)count};
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < count; i++) {
		status = number_push(&cells->loops, entry, fault);
		entry = cells->links.at[solid_loop_corner(cells, entry ^ 1)];
	}
	return status ? status : facet_add(cells, &cap, fault);
}

static enum tcs_status
shell_write(struct solid_cells *cells, const struct solid_numbers *facets,
	struct solid_cell *cell, struct tcs_fault *fault)
{
	uint32_t cap = (uint32_t)cells->facets.count - 1;

	cell->first = (uint32_t)cells->shells.count;
	cell->count = (uint32_t)facets->count + 1;
	if (is_full(cells->shells.count + facets->count) ||
		array_grow(&cells->shells, facets->count + 1))
		return fault_memory(fault);
	memcpy(cells->shells.at + cells->shells.count, facets->at,
		facets->count * sizeof *facets->at);
	cells->shells.count += facets->count;
	cells->shells.at[cells->shells.count++] = cap;
	return TCS_OK;
}

static enum tcs_status
cell_part(struct solid_cells *cells, uint32_t cell, struct tcs_fault *fault)
{
	uint32_t fresh = (uint32_t)cells->cells.count;
	enum tcs_status status;

	if (is_full(fresh) || array_grow(&cells->cells, 1))
		return fault_memory(fault);
	cells->cells.count++;
	for (size_t i = 0; i < cells->above.count; i++) {
		struct solid_facet *facet =
			&cells->facets.at[cells->above.at[i]];

		facet->cells[facet->cells[0] != cell] = fresh;
	}
	status = shell_write(
		cells, &cells->below, &cells->cells.at[cell], fault);
	if (!status)
		status = shell_write(
			cells, &cells->above, &cells->cells.at[fresh], fault);
	return status;
}

enum tcs_status
solid_cells_cut(struct solid_cells *cells, uint32_t cell, uint32_t plane,
	int *side, struct tcs_fault *fault)
{
	enum tcs_status status = shell_read(cells, cell, fault);
	unsigned found;

	if (status)
		return status;
	found = corners_part(cells, plane);
	*side = found == BELOW ? -1 : found == ABOVE ? 1 : 0;
	if (*side)
		return TCS_OK;
	status = shell_part(cells, plane, fault);
	if (!status)
		status = cap_add(cells, cell, plane, fault);
	if (!status)
		status = cell_part(cells, cell, fault);
	return status;
}
