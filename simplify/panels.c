#include "panels.h"

#include <math.h>
#include <stdlib.h>

/* Metres by which a panel stands out, and one more than another. */
#define STEP 0.01

/* Metres: what differs by less stands out by as much. */
#define SAME_LEVEL 1e-3

/* Panels stand out by so many steps at most. */
enum { MOST_STEPS = 4 };

/* Rims are this parallel to each other. */
#define SAME_WAY 0.999

/* What the rims enclose, along the way; below it may be open. */
struct hole {
	double bottom, top;
	bool has_bottom;
};

/* ---- the hole ------------------------------------------------------------ */

/* false if the rims do not face each other. */
static bool
measure_hole(struct hole *hole, const struct rims *rims,
	const struct collapses *work, struct tcs_point way)
{
	*hole = (struct hole){INFINITY, -INFINITY, false};
	for (size_t i = 0; i < rims->loops.count; i++) {
		const struct rim_loop *loop = &rims->loops.at[i];
		double along = vector_dot(loop->normal, way);

		if (fabs(along) < SAME_WAY)
			return false;
		for (uint32_t k = 0; k < loop->count; k++) {
			uint32_t vertex = rims->edges.at[loop->first + k].from;
			double height = vector_dot(
				way, work->positions.at[node_of(work, vertex)]);

			if (along > 0)
				hole->top = fmax(hole->top, height);
			else
				hole->bottom = fmin(hole->bottom, height);
		}
		hole->has_bottom |= along < 0;
	}
	return true;
}

/* ---- whose parts --------------------------------------------------------- */

static uint32_t
feature_of(
	const struct collapses *work, const struct parts *parts, uint32_t part)
{
	return work->features.at[parts->faces.at[parts->at.at[part].first]];
}

/* Put the parts in the order of their features: they are few. */
static enum tcs_status
sort_parts(struct panels *panels, const struct collapses *work,
	const struct parts *parts, const uint32_t *numbers, size_t count,
	struct tcs_fault *fault)
{
	uint32_t *at;

	panels->parts.count = 0;
	if (array_grow(&panels->parts, count))
		return fault_memory(fault);
	at = panels->parts.at;
	for (size_t i = 0; i < count; i++) {
		uint32_t feature = feature_of(work, parts, numbers[i]);
		size_t place = panels->parts.count++;

		for (; place > 0 &&
			feature_of(work, parts, at[place - 1]) > feature;
			place--)
			at[place] = at[place - 1];
		at[place] = numbers[i];
	}
	return TCS_OK;
}

static bool
is_seen(const struct panels *panels, const struct removals *removals,
	uint32_t first, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++)
		if (removals->visible.at[panels->parts.at[first + i]] > 0)
			return true;
	return false;
}

static enum tcs_status
list_panels(struct panels *panels, const struct collapses *work,
	const struct removals *removals, struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	const uint32_t *at = panels->parts.at;
	uint32_t count = (uint32_t)panels->parts.count, run;

	panels->at.count = 0;
	if (array_grow(&panels->at, count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < count; i += run) {
		uint32_t feature = feature_of(work, parts, at[i]);

		for (run = 1; i + run < count &&
			feature_of(work, parts, at[i + run]) == feature;)
			run++;
		if (is_seen(panels, removals, i, run))
			panels->at.at[panels->at.count++] =
				(struct panel){.first = i, .count = run};
	}
	return TCS_OK;
}

/* ---- how far they come --------------------------------------------------- */

struct extent {
	double low, high;
};

/* From where to where a part reached as it came. */
static struct extent
extent_of(const struct panels *panels, const struct collapses *work,
	const struct parts *parts, uint32_t part)
{
	const struct part *own = &parts->at.at[part];
	struct extent extent = {INFINITY, -INFINITY};

	for (uint32_t i = 0; i < own->count; i++) {
		struct triangle_shape shape = component_set_shape(work->set,
			work->sheets->face_triangles
				.at[parts->faces.at[own->first + i]]);

		for (int k = 0; k < 3; k++) {
			double height =
				vector_dot(panels->way, shape.corner[k]);

			extent.low = fmin(extent.low, height);
			extent.high = fmax(extent.high, height);
		}
	}
	return extent;
}

static void
measure_panels(struct panels *panels, const struct collapses *work,
	const struct parts *parts)
{
	for (size_t i = 0; i < panels->at.count; i++) {
		struct panel *own = &panels->at.at[i];

		own->low = INFINITY;
		own->high = -INFINITY;
		for (uint32_t k = 0; k < own->count; k++) {
			struct extent extent = extent_of(panels, work, parts,
				panels->parts.at[own->first + k]);

			own->low = fmin(own->low, extent.low);
			own->high = fmax(own->high, extent.high);
		}
	}
}

static int
ascending(const void *left, const void *right)
{
	double a = *(const double *)left, b = *(const double *)right;

	return (a > b) - (a < b);
}

/* The sides of all panels that look one way, as heights that rise outwards. */
static enum tcs_status
list_levels(struct panels *panels, double sign, struct tcs_fault *fault)
{
	panels->levels.count = 0;
	if (array_grow(&panels->levels, panels->at.count))
		return fault_memory(fault);
	for (size_t i = 0; i < panels->at.count; i++)
		panels->levels.at[panels->levels.count++] = sign > 0
			? panels->at.at[i].high
			: -panels->at.at[i].low;
	if (panels->levels.count > 1)
		qsort(panels->levels.at, panels->levels.count,
			sizeof *panels->levels.at, ascending);
	return TCS_OK;
}

/* By how much a side stands out that is at a level. */
static double
stands_out(const struct panels *panels, double level)
{
	double last = panels->levels.at[0];
	int steps = 1;

	for (size_t i = 1; steps < MOST_STEPS && i < panels->levels.count &&
		panels->levels.at[i] <= level;
		i++) {
		steps += panels->levels.at[i] > last + SAME_LEVEL;
		last = panels->levels.at[i];
	}
	return steps * STEP;
}

static enum tcs_status
draw_out(
	struct panels *panels, const struct hole *hole, struct tcs_fault *fault)
{
	enum tcs_status status = list_levels(panels, 1, fault);

	for (size_t i = 0; !status && i < panels->at.count; i++) {
		struct panel *own = &panels->at.at[i];

		own->to_low = own->low;
		own->to_high = fmax(
			own->high, hole->top + stands_out(panels, own->high));
	}
	if (status || !hole->has_bottom)
		return status;
	status = list_levels(panels, -1, fault);
	for (size_t i = 0; !status && i < panels->at.count; i++) {
		struct panel *own = &panels->at.at[i];

		own->to_low = fmin(
			own->low, hole->bottom - stands_out(panels, -own->low));
	}
	return status;
}

/* ---- the panels ---------------------------------------------------------- */

static enum tcs_status
plan_panel(struct panels *panels, const struct panel *panel,
	struct collapses *work, const struct removals *removals, bool *fine,
	struct tcs_fault *fault)
{
	return merge_plan_panel(&panels->plan, work, removals,
		panels->parts.at + panel->first, panel->count, panels->way,
		panel->to_low, panel->to_high, fine, fault);
}

/* What is seen of its parts, times how far it comes forward, squared. */
static double
cost_of(const struct panels *panels, const struct panel *panel,
	const struct collapses *work, const struct removals *removals)
{
	double cost = 0;

	for (uint32_t i = 0; i < panel->count; i++) {
		uint32_t part = panels->parts.at[panel->first + i];
		struct extent extent =
			extent_of(panels, work, &removals->parts, part);

		cost += removals->visible.at[part] *
			removals_steep(removals,
				fmax(panel->to_high - extent.high,
					extent.low - panel->to_low));
	}
	return cost;
}

enum tcs_status
panels_plan(struct panels *panels, struct collapses *work,
	const struct removals *removals, const struct rims *rims,
	const uint32_t *numbers, size_t count, struct tcs_fault *fault)
{
	const struct merge_plan *plan = &panels->plan;
	enum tcs_status status = sort_parts(
		panels, work, &removals->parts, numbers, count, fault);
	struct hole hole;
	bool faced;

	if (!status)
		status = list_panels(panels, work, removals, fault);
	if (status || panels->at.count == 0)
		return status;
	panels->way = rims->loops.at[0].normal;
	faced = measure_hole(&hole, rims, work, panels->way);
	measure_panels(panels, work, &removals->parts);
	if (faced)
		status = draw_out(panels, &hole, fault);
	for (size_t i = 0; !status && faced && i < panels->at.count; i++) {
		struct panel *own = &panels->at.at[i];

		status = plan_panel(
			panels, own, work, removals, &own->fine, fault);
		if (status || !own->fine)
			continue;
		own->cost = cost_of(panels, own, work, removals);
		own->faces = (double)PRISM_TRIANGLES_OF(plan->prism.sides) -
			(double)plan->faces.count;
	}
	return status;
}

enum tcs_status
panels_build(struct panels *panels, struct component_set *set,
	struct collapses *work, struct removals *removals,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < panels->at.count; i++) {
		const struct panel *own = &panels->at.at[i];
		struct part *host;
		bool fine = own->fine;

		if (fine)
			status = plan_panel(
				panels, own, work, removals, &fine, fault);
		for (uint32_t k = 0; !status && !fine && k < own->count; k++)
			status = removals_hide(removals,
				panels->parts.at[own->first + k], fault);
		if (status || !fine)
			continue;
		status = merge_build(&panels->builder, &panels->plan, set, work,
			removals, fault);
		if (status)
			continue;
		host = &removals->parts.at.at[panels->plan.host];
		host->drawn_out = true;
		panels->made++;
		volume_watch_panel(&work->volume, host->component,
			panels->plan.prism.volume);
	}
	return status;
}

void
panels_release(struct panels *panels)
{
	array_release(&panels->at);
	array_release(&panels->parts);
	array_release(&panels->levels);
	merge_plan_release(&panels->plan);
	merge_builder_release(&panels->builder);
}
