#include <stdlib.h>

#include "solid_cutter.h"

static bool
belongs(const struct solid_cutter *cutter, uint32_t cell)
{
	const struct solid_winding *winding = &cutter->inside.windings.at[cell];
	bool host = winding->times[HOST] > 0, tools = winding->times[TOOLS] > 0;

	if (cutter->task->operation == SOLID_DIFFERENCE)
		return host && !tools;
	if (cutter->task->operation == SOLID_INTERSECTION)
		return host && tools;
	return host || tools;
}

/*
 * The piece that a facet of the result comes from: of the host's rather than of
 * a tool's, and one that looks the right way rather than one that does not.
 */
static uint32_t
piece_of(const struct solid_cutter *cutter, const struct solid_cover *cover,
	bool up)
{
	bool over = cutter->task->operation == SOLID_DIFFERENCE ? !up : up;
	const uint32_t choice[4] = {cover->pieces[HOST][!up],
		cover->pieces[TOOLS][!over], cover->pieces[HOST][up],
		cover->pieces[TOOLS][over]};

	for (unsigned i = 0; i < 4; i++)
		if (choice[i] != SOLID_NO_FACE)
			return choice[i];
	return SOLID_NO_FACE;
}

static void
fragment_name(const struct solid_cutter *cutter, size_t pane,
	struct solid_fragment *fragment)
{
	const struct solid_task *task = cutter->task;
	uint32_t number =
		piece_of(cutter, &cutter->inside.covers.at[pane], fragment->up);

	fragment->face = SOLID_NO_FACE;
	if (number != SOLID_NO_FACE) {
		const struct solid_piece *piece =
			&cutter->carver.pieces.list.at[number];

		fragment->origin = piece->origin;
		fragment->face = piece->face;
		fragment->label = piece->label;
		fragment->named = true;
		return;
	}
	for (size_t i = 0; i < task->half_space_count; i++) {
		if (cutter->half_spaces.at[2 * i] != fragment->plane)
			continue;
		fragment->origin = (uint32_t)(1 + task->tool_count + i);
		fragment->label = task->half_spaces[i].label;
		fragment->named = true;
		return;
	}
}

static enum tcs_status
fragment_add(struct solid_cutter *cutter, size_t pane, bool up,
	struct tcs_fault *fault)
{
	struct solid_fragments *fragments = &cutter->outline.fragments;
	uint32_t facet = cutter->inside.panes.at[pane].facet;
	struct solid_fragment fragment = {.facet = facet,
		.plane = cutter->carver.cells.facets.at[facet].plane,
		.up = up};

	if (array_grow(fragments, 1))
		return fault_memory(fault);
	fragment_name(cutter, pane, &fragment);
	fragments->at[fragments->count++] = fragment;
	return TCS_OK;
}

static int
fragment_order(const void *left, const void *right)
{
	const struct solid_fragment *a = left, *b = right;

	if (a->origin != b->origin)
		return a->origin < b->origin ? -1 : 1;
	if (a->face != b->face)
		return a->face < b->face ? -1 : 1;
	if (a->plane != b->plane)
		return a->plane < b->plane ? -1 : 1;
	if (a->up != b->up)
		return a->up ? 1 : -1;
	return (a->facet > b->facet) - (a->facet < b->facet);
}

/* The cells below and above. */
static const uint32_t *
pane_sides(const struct solid_cutter *cutter, size_t pane)
{
	uint32_t facet = cutter->inside.panes.at[pane].facet;

	return cutter->carver.cells.facets.at[facet].cells;
}

/* The border of the result. */
static enum tcs_status
border_collect(struct solid_cutter *cutter, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < cutter->inside.panes.count; i++) {
		const uint32_t *sides = pane_sides(cutter, i);
		bool below =
			sides[0] != SOLID_OUTSIDE && belongs(cutter, sides[0]);
		bool above =
			sides[1] != SOLID_OUTSIDE && belongs(cutter, sides[1]);

		if (below != above)
			status = fragment_add(cutter, i, below, fault);
	}
	return status;
}

/* A face of an open host stays where what is behind it does. */
static bool
is_left(const struct solid_cutter *cutter, size_t pane, bool up)
{
	uint32_t behind = pane_sides(cutter, pane)[!up];
	bool wanted = cutter->task->operation != SOLID_DIFFERENCE;

	return cutter->inside.covers.at[pane].pieces[HOST][!up] !=
		SOLID_NO_FACE &&
		behind != SOLID_OUTSIDE &&
		(cutter->inside.windings.at[behind].times[TOOLS] > 0) == wanted;
}

/* What is left of an open host's faces. */
static enum tcs_status
faces_collect(struct solid_cutter *cutter, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < cutter->inside.panes.count; i++) {
		if (is_left(cutter, i, true))
			status = fragment_add(cutter, i, true, fault);
		if (!status && is_left(cutter, i, false))
			status = fragment_add(cutter, i, false, fault);
	}
	return status;
}

enum tcs_status
solid_result_write(
	struct solid_cutter *cutter, struct solid *out, struct tcs_fault *fault)
{
	struct solid_fragments *fragments = &cutter->outline.fragments;
	enum tcs_status status;

	array_clear(fragments);
	status = cutter->host.closed ? border_collect(cutter, fault)
				     : faces_collect(cutter, fault);
	if (status || !fragments->count)
		return status;
	qsort(fragments->at, fragments->count, sizeof *fragments->at,
		fragment_order);
	return solid_outline_write(
		&cutter->outline, &cutter->carver, cutter->origin, out, fault);
}
