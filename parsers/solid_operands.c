#include <math.h>

#include "solid_cutter.h"

/* ---- boxes ------------------------------------------------------------------- */

static bool
is_apart(const struct solid_box *a, const struct solid_box *b, double tolerance)
{
	return a->lower.x > b->upper.x + tolerance ||
		b->lower.x > a->upper.x + tolerance ||
		a->lower.y > b->upper.y + tolerance ||
		b->lower.y > a->upper.y + tolerance ||
		a->lower.z > b->upper.z + tolerance ||
		b->lower.z > a->upper.z + tolerance;
}

static void
box_add(struct solid_box *all, const struct solid_box *one)
{
	all->lower.x = fmin(all->lower.x, one->lower.x);
	all->lower.y = fmin(all->lower.y, one->lower.y);
	all->lower.z = fmin(all->lower.z, one->lower.z);
	all->upper.x = fmax(all->upper.x, one->upper.x);
	all->upper.y = fmax(all->upper.y, one->upper.y);
	all->upper.z = fmax(all->upper.z, one->upper.z);
}

static double
box_extent(const struct solid_box *box)
{
	return fmax(
		fmax(box->upper.x - box->lower.x, box->upper.y - box->lower.y),
		box->upper.z - box->lower.z);
}

/*
 * Near coordinates keep their origin. Far ones get one so near them that taking
 * it away and adding it again changes nothing.
 */
static double
origin_along(double lower, double upper, double extent)
{
	double middle = lower + (upper - lower) / 2;

	return fabs(middle) < 16 * extent ? 0 : nearbyint(middle);
}

enum { SIDES = 6 };

/* Lower x, upper x, lower y, … of a box. */
static double
side_get(const struct solid_box *box, unsigned side)
{
	const struct tcs_point *at = side % 2 ? &box->upper : &box->lower;

	return side / 2 == 0 ? at->x : side / 2 == 1 ? at->y : at->z;
}

static void
side_move(struct solid_box *box, unsigned side, double by)
{
	struct tcs_point *at = side % 2 ? &box->upper : &box->lower;
	double *coordinate = side / 2 == 0 ? &at->x
		: side / 2 == 1		   ? &at->y
					   : &at->z;

	*coordinate += side % 2 ? by : -by;
}

/* Find the sides of the box that a face lies in, unless it is flat there. */
static void
sides_find(const struct solid *solid, const struct solid_box *box,
	double tolerance, bool flush[SIDES])
{
	for (size_t i = 0; i < solid->faces.count; i++) {
		const struct solid_face *face = &solid->faces.at[i];
		struct solid_box own = {{INFINITY, INFINITY, INFINITY},
			{-INFINITY, -INFINITY, -INFINITY}};

		for (size_t j = 0; j < face->ring_count; j++) {
			size_t count;
			const struct tcs_point *ring =
				solid_ring(solid, face->first_ring + j, &count);

			for (size_t k = 0; k < count; k++)
				box_add(&own,
					&(struct solid_box){ring[k], ring[k]});
		}
		for (unsigned j = 0; j < SIDES; j++)
			flush[j] |=
				fabs(side_get(box, j ^ 1) - side_get(box, j)) >
					64 * tolerance &&
				fabs(side_get(&own, j ^ 1) -
					side_get(box, j)) <= tolerance;
	}
}

/* A side that no face of a closed host lies in is moved away from it. */
struct solid_box
solid_cutter_box(struct solid_cutter *cutter)
{
	struct solid_box box = {cutter->host.lower, cutter->host.upper};
	bool flush[SIDES] = {false};
	double extent;

	for (size_t i = 0; i < cutter->tools.count; i++)
		if (cutter->tools.at[i].used &&
			cutter->task->operation == SOLID_UNION)
			box_add(&box, &cutter->tools.at[i].box);
	if (cutter->host.closed)
		sides_find(
			cutter->task->host, &box, cutter->tolerance / 8, flush);
	extent = box_extent(&box);
	cutter->origin = (struct tcs_point){
		origin_along(box.lower.x, box.upper.x, extent),
		origin_along(box.lower.y, box.upper.y, extent),
		origin_along(box.lower.z, box.upper.z, extent)};
	box.lower = point_minus(box.lower, cutter->origin);
	box.upper = point_minus(box.upper, cutter->origin);
	for (unsigned i = 0; i < SIDES; i++)
		side_move(&box, i, flush[i] ? 0 : 64 * cutter->tolerance);
	return box;
}

/* ---- operands ---------------------------------------------------------------- */

/* Whether the host's faces, all in the box, bound what they wind around. */
static bool
faces_bound(const struct solid_cutter *cutter)
{
	const struct solid_inside *inside = &cutter->inside;
	const struct solid_cells *cells = &cutter->carver.cells;
	double width = 4 * cutter->tolerance, wrong = 0, area = 0;

	for (size_t i = 0; i < inside->panes.count; i++) {
		const struct solid_pane *pane = &inside->panes.at[i];
		const uint32_t *sides = cells->facets.at[pane->facet].cells;
		int step = 0;

		if (sides[0] != SOLID_OUTSIDE)
			step -= inside->windings.at[sides[0]].times[HOST];
		if (sides[1] != SOLID_OUTSIDE)
			step += inside->windings.at[sides[1]].times[HOST];
		if (step)
			area += pane->area;
		if (pane->width > width &&
			step != inside->covers.at[i].step[HOST])
			wrong += pane->area;
	}
	return wrong <= 1e-6 * area &&
		fabs(area - cutter->host.area) <= 1e-3 * cutter->host.area;
}

/* Cut a solid by nothing but its own faces, and look whether they fit. */
static enum tcs_status
solid_try(struct solid_cutter *cutter, const struct solid *solid,
	const struct solid_measure *measure, bool *closed,
	struct tcs_fault *fault)
{
	const struct solid_task *task = cutter->task, alone = {.host = solid};
	struct solid_measure host = cutter->host;
	struct solid_carver *carver = &cutter->carver;
	struct solid_box box;
	enum tcs_status status;

	cutter->task = &alone;
	cutter->host = *measure;
	box = solid_cutter_box(cutter);
	status = solid_carve_begin(
		carver, box.lower, box.upper, cutter->tolerance, fault);
	if (!status)
		status = solid_pieces_add(&carver->pieces, &carver->planes,
			solid, cutter->origin, 0, measure->volume < 0, fault);
	if (!status)
		status = solid_carve_fill(carver, fault);
	if (!status)
		status = solid_carve(carver, fault);
	if (!status && !carver->too_many)
		status = solid_inside_find(&cutter->inside, carver, fault);
	*closed = !status && !carver->too_many && faces_bound(cutter);
	cutter->task = task;
	cutter->host = host;
	return status;
}

/* Measure; faces that do not meet edge to edge may still be closed. */
static enum tcs_status
operand_measure(struct solid_cutter *cutter, const struct solid *solid,
	struct solid_measure *measure, struct tcs_fault *fault)
{
	enum tcs_status status = solid_measure(solid, measure, fault);

	if (status || measure->closed || !solid->faces.count)
		return status;
	return solid_try(cutter, solid, measure, &measure->closed, fault);
}

static enum tcs_status
tool_measure(struct solid_cutter *cutter, size_t number,
	enum solid_tool_fault *found, struct tcs_fault *fault)
{
	struct solid_measure measure;
	enum tcs_status status = operand_measure(
		cutter, cutter->task->tools[number], &measure, fault);

	*found = SOLID_TOOL_SOUND;
	if (status)
		return status;
	if (!measure.closed)
		*found = SOLID_TOOL_OPEN;
	else if (!(fabs(measure.volume) > measure.area / 2 * cutter->tolerance))
		*found = SOLID_TOOL_FLAT;
	cutter->tools.at[cutter->tools.count++] = (struct solid_tool_state){
		.box = {measure.lower, measure.upper},
		.volume = fabs(measure.volume),
		.turned = measure.volume < 0,
		.used = *found == SOLID_TOOL_SOUND,
	};
	return TCS_OK;
}

static enum tcs_status
tools_measure(struct solid_cutter *cutter, struct solid_report *report,
	enum solid_tool_fault *tool_faults, struct tcs_fault *fault)
{
	const struct solid_task *task = cutter->task;
	enum tcs_status status = TCS_OK;

	if (array_grow(&cutter->tools, task->tool_count))
		return fault_memory(fault);
	for (size_t i = 0; !status && i < task->tool_count; i++) {
		enum solid_tool_fault found;

		status = tool_measure(cutter, i, &found, fault);
		if (tool_faults)
			tool_faults[i] = found;
		report->tools_left_out += found != SOLID_TOOL_SOUND;
		report->tools_turned +=
			cutter->tools.at[i].used && cutter->tools.at[i].turned;
	}
	return status;
}

/* Leave tools out that cannot reach the host. */
static void
tools_thin(struct solid_cutter *cutter)
{
	struct solid_box host = {cutter->host.lower, cutter->host.upper};

	cutter->tool_volume = 0;
	for (size_t i = 0; i < cutter->tools.count; i++) {
		struct solid_tool_state *tool = &cutter->tools.at[i];

		if (cutter->task->operation != SOLID_UNION &&
			is_apart(&tool->box, &host, 0))
			tool->used = false;
		if (tool->used)
			cutter->tool_volume += tool->volume;
	}
}

enum tcs_status
solid_operands_measure(struct solid_cutter *cutter, struct solid_report *report,
	enum solid_tool_fault *tool_faults, struct tcs_fault *fault)
{
	struct solid_measure host;
	enum tcs_status status;

	array_clear(&cutter->tools);
	status = operand_measure(cutter, cutter->task->host, &host, fault);

	if (!status)
		status = tools_measure(cutter, report, tool_faults, fault);
	cutter->host = host;
	if (!status)
		tools_thin(cutter);
	return status;
}
