#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "solid_cutter.h"

struct solid_cutter *
solid_cutter_new(void)
{
	return calloc(1, sizeof(struct solid_cutter));
}

void
solid_cutter_free(struct solid_cutter *cutter)
{
	if (!cutter)
		return;
	solid_carver_release(&cutter->carver);
	solid_inside_release(&cutter->inside);
	solid_outline_release(&cutter->outline);
	solid_points_release(&cutter->edge_points);
	array_release(&cutter->tools);
	array_release(&cutter->half_spaces);
	free(cutter);
}

static bool
is_finite(const struct solid *solid)
{
	for (size_t i = 0; i < solid->points.count; i++) {
		struct tcs_point at = solid->points.at[i];

		if (!(fabs(at.x) < 1e12 && fabs(at.y) < 1e12 &&
			    fabs(at.z) < 1e12))
			return false;
	}
	return true;
}

/* ---- cells ------------------------------------------------------------------- */

/* The half-spaces' planes come first, so that faces near them lie in them. */
static enum tcs_status
half_spaces_add(struct solid_cutter *cutter, struct tcs_fault *fault)
{
	const struct solid_task *task = cutter->task;
	enum tcs_status status = TCS_OK;

	array_clear(&cutter->half_spaces);
	if (array_grow(&cutter->half_spaces, 2 * task->half_space_count))
		return fault_memory(fault);
	for (size_t i = 0; !status && i < task->half_space_count; i++) {
		struct tcs_point n = task->half_spaces[i].normal;
		double length = sqrt(point_dot(n, n));
		uint32_t plane;
		int side;

		status = solid_planes_place(&cutter->carver.planes,
			point_minus(task->half_spaces[i].point, cutter->origin),
			(struct tcs_point){
				n.x / length, n.y / length, n.z / length},
			&plane, &side, fault);
		if (status)
			break;
		cutter->half_spaces.at[cutter->half_spaces.count++] = plane;
		cutter->half_spaces.at[cutter->half_spaces.count++] = side > 0;
	}
	return status;
}

static enum tcs_status
pieces_add(struct solid_cutter *cutter, struct tcs_fault *fault)
{
	struct solid_carver *carver = &cutter->carver;
	const struct solid_task *task = cutter->task;
	enum tcs_status status =
		solid_pieces_add(&carver->pieces, &carver->planes, task->host,
			cutter->origin, 0, cutter->host.volume < 0, fault);

	if (!status && !cutter->host.closed)
		status = solid_limits_add(cutter, fault);
	for (size_t i = 0; !status && i < task->tool_count; i++)
		if (cutter->tools.at[i].used)
			status = solid_pieces_add(&carver->pieces,
				&carver->planes, task->tools[i], cutter->origin,
				(uint32_t)i + 1, cutter->tools.at[i].turned,
				fault);
	return status;
}

static enum tcs_status
half_spaces_drop(
	struct solid_cutter *cutter, bool *empty, struct tcs_fault *fault)
{
	const struct solid_numbers *planes = &cutter->half_spaces;
	enum tcs_status status = TCS_OK;

	*empty = false;
	for (size_t i = 0; !status && !*empty && i < planes->count; i += 2)
		status = solid_carve_drop(&cutter->carver, planes->at[i],
			planes->at[i + 1] ? 1 : -1, empty, fault);
	return status;
}

static enum tcs_status
cells_make(struct solid_cutter *cutter, bool *empty, struct tcs_fault *fault)
{
	struct solid_carver *carver = &cutter->carver;
	struct solid_box box = solid_cutter_box(cutter);
	enum tcs_status status = solid_carve_begin(
		carver, box.lower, box.upper, cutter->tolerance, fault);

	if (!status)
		status = half_spaces_add(cutter, fault);
	if (!status)
		status = pieces_add(cutter, fault);
	if (!status)
		status = solid_carve_fill(carver, fault);
	if (!status)
		status = half_spaces_drop(cutter, empty, fault);
	if (!status && !*empty)
		status = solid_carve(carver, fault);
	if (!status && !*empty && !carver->too_many)
		status = solid_inside_find(&cutter->inside, carver, fault);
	return status;
}

/* ---- the task ---------------------------------------------------------------- */

/* The host as it is. */
static enum tcs_status
host_copy(const struct solid *host, struct solid *out, struct tcs_fault *fault)
{
	solid_clear(out);
	if (array_grow(&out->points, host->points.count) ||
		array_grow(&out->ring_ends, host->ring_ends.count) ||
		array_grow(&out->faces, host->faces.count))
		return fault_memory(fault);
	for (size_t i = 0; i < host->points.count; i++)
		out->points.at[out->points.count++] = host->points.at[i];
	for (size_t i = 0; i < host->ring_ends.count; i++)
		out->ring_ends.at[out->ring_ends.count++] =
			host->ring_ends.at[i];
	for (size_t i = 0; i < host->faces.count; i++) {
		struct solid_face face = host->faces.at[i];

		face.origin = 0;
		face.face = (uint32_t)i;
		out->faces.at[out->faces.count++] = face;
	}
	return TCS_OK;
}

static enum tcs_status
refuse(const struct solid_task *task, const char *reason, struct solid *out,
	struct solid_report *report, struct tcs_fault *fault)
{
	report->outcome = SOLID_REFUSED;
	report->reason = reason;
	report->volume = report->host_volume;
	return host_copy(task->host, out, fault);
}

/* What is wrong with the task before anything is measured. */
static const char *
task_fault(const struct solid_task *task)
{
	if (!is_finite(task->host))
		return "a coordinate of the host is not a number or too large";
	for (size_t i = 0; i < task->tool_count; i++)
		if (!is_finite(task->tools[i]))
			return "a coordinate of a tool is not a number or too "
			       "large";
	for (size_t i = 0; i < task->half_space_count; i++) {
		const struct solid_half_space *half = &task->half_spaces[i];
		double length = point_dot(half->normal, half->normal);
		double size = point_dot(half->point, half->point);

		if (!(length > 1e-200 && length < 1e200 && size < 1e24))
			return "a half-space has no plane";
	}
	return NULL;
}

/* What is wrong with the measured host. */
static const char *
host_fault(const struct solid_cutter *cutter)
{
	const struct solid_measure *host = &cutter->host;

	if (cutter->task->operation == SOLID_UNION)
		return host->closed ? NULL : "the host is not closed";
	return !host->closed ||
			fabs(host->volume) > host->area / 2 * cutter->tolerance
		? NULL
		: "the host has no volume";
}

/* Whether cells that are not mere slivers are inside more than once, or less
 * than not at all. */
static bool
is_crossing(const struct solid_cutter *cutter)
{
	const struct solid_inside *inside = &cutter->inside;

	for (size_t i = 0; i < inside->windings.count; i++) {
		int times = inside->windings.at[i].times[HOST];

		if ((times < 0 || times > 1) &&
			inside->depths.at[i] > 4 * cutter->tolerance)
			return true;
	}
	return false;
}

/* What is wrong with the result, as the volumes tell. */
static const char *
result_fault(const struct solid_cutter *cutter,
	const struct solid_measure *result, bool crossing)
{
	const struct solid_task *task = cutter->task;
	double host = fabs(cutter->host.volume), tools = cutter->tool_volume;
	double slack =
		4 * cutter->tolerance * (cutter->host.area + result->area) +
		1e-9 * (host + tools);
	double least = 0, most = host;

	if (!result->closed)
		return "the result is not closed";
	if (task->operation == SOLID_DIFFERENCE)
		least = host - tools;
	if (task->operation == SOLID_INTERSECTION)
		most = fmin(host, tools);
	if (task->operation == SOLID_UNION) {
		least = host;
		most = host + tools;
	}
	if (task->half_space_count || crossing)
		least = 0;
	if (!(result->volume >= least - slack &&
		    result->volume <= most + slack))
		return "the volumes do not add up";
	return NULL;
}

/* Nothing can touch the host. */
static bool
is_untouched(const struct solid_cutter *cutter)
{
	if (cutter->task->half_space_count ||
		cutter->task->operation == SOLID_INTERSECTION)
		return false;
	for (size_t i = 0; i < cutter->tools.count; i++)
		if (cutter->tools.at[i].used)
			return false;
	return cutter->host.volume > 0 || !cutter->host.closed;
}

static enum tcs_status
task_do(struct solid_cutter *cutter, struct solid *out,
	struct solid_report *report, struct tcs_fault *fault)
{
	struct solid_measure result;
	const char *reason;
	bool empty = false;
	enum tcs_status status = cells_make(cutter, &empty, fault);

	if (!status && cutter->carver.too_many)
		return refuse(
			cutter->task, "too many cells", out, report, fault);
	if (!status && !empty)
		status = solid_result_write(cutter, out, fault);
	if (!status)
		status = solid_measure(out, &result, fault);
	if (status)
		return status;
	report->volume = result.volume;
	report->outcome = SOLID_OPEN;
	if (!cutter->host.closed)
		return TCS_OK;
	report->crossing = !empty && is_crossing(cutter);
	reason = result_fault(cutter, &result, report->crossing);
	report->outcome = out->faces.count ? SOLID_DONE : SOLID_EMPTY;
	return reason ? refuse(cutter->task, reason, out, report, fault)
		      : TCS_OK;
}

enum tcs_status
solid_cut(struct solid_cutter *cutter, const struct solid_task *task,
	struct solid *out, struct solid_report *report,
	enum solid_tool_fault *tool_faults, struct tcs_fault *fault)
{
	const char *reason = task_fault(task);
	enum tcs_status status;

	*report = (struct solid_report){.outcome = SOLID_DONE};
	solid_clear(out);
	for (size_t i = 0; tool_faults && i < task->tool_count; i++)
		tool_faults[i] = SOLID_TOOL_SOUND;
	if (reason)
		return refuse(task, reason, out, report, fault);
	if (!task->host->faces.count && task->operation != SOLID_UNION) {
		report->outcome = SOLID_EMPTY;
		return TCS_OK;
	}
	cutter->task = task;
	cutter->tolerance =
		task->tolerance > 0 ? task->tolerance : SOLID_TOLERANCE;
	status = solid_operands_measure(cutter, report, tool_faults, fault);
	if (status)
		return status;
	report->host_volume = fabs(cutter->host.volume);
	report->turned = cutter->host.closed && cutter->host.volume < 0;
	reason = host_fault(cutter);
	if (reason)
		return refuse(task, reason, out, report, fault);
	if (!is_untouched(cutter))
		return task_do(cutter, out, report, fault);
	report->outcome = cutter->host.closed ? SOLID_DONE : SOLID_OPEN;
	report->volume = report->host_volume;
	return host_copy(task->host, out, fault);
}
