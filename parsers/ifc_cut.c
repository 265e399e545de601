#include "ifc_cut.h"

#include <stdlib.h>

void
ifc_cut_clear(struct ifc_cut *cut)
{
	for (size_t i = 0; i < cut->tools.count; i++)
		solid_release(cut->tools.at + i);
	array_clear(&cut->tools);
	array_clear(&cut->half_spaces);
}

void
ifc_cut_release(struct ifc_cut *cut)
{
	ifc_cut_clear(cut);
	array_release(&cut->tools);
	array_release(&cut->half_spaces);
	solid_release(&cut->host);
	solid_release(&cut->result);
}

struct solid *
ifc_cut_tool(struct ifc_cut *cut)
{
	if (array_grow(&cut->tools, 1))
		return NULL;
	cut->tools.at[cut->tools.count] = (struct solid){.faces = {0}};
	return cut->tools.at + cut->tools.count++;
}

enum ifc_outcome
ifc_remark(struct ifc_shaper *shaper, uint32_t instance,
	enum report_severity severity, const char *reason)
{
	struct ifc_scratch *scratch = shaper->scratch;

	if (array_grow(&scratch->remarks, 1))
		return IFC_NO_MEMORY;
	scratch->remarks.at[scratch->remarks.count++] =
		(struct ifc_remark){instance, severity, reason};
	return IFC_SHAPED;
}

/* ---- faces and solids ---------------------------------------------------- */

enum ifc_outcome
ifc_solid_add(struct solid *out, const struct ifc_faces *faces, size_t first,
	size_t end)
{
	struct tcs_fault fault;

	for (size_t i = first; i < end; i++) {
		const struct ifc_face *face = faces->faces.at + i;

		if (solid_add_face(out, faces->points.at + face->first_point,
			    faces->rings.at + face->first_ring,
			    face->ring_count, face->paint, &fault))
			return IFC_NO_MEMORY;
	}
	return IFC_SHAPED;
}

static enum ifc_outcome
face_back(struct ifc_shaper *shaper, const struct solid *solid,
	const struct solid_face *face, struct ifc_faces *out)
{
	size_t before = out->faces.count;
	enum ifc_outcome outcome = IFC_SHAPED;

	for (uint32_t i = 0; i < face->ring_count && !outcome; i++) {
		size_t count;
		const struct tcs_point *points =
			solid_ring(solid, face->first_ring + i, &count);

		outcome = ifc_points_room(shaper, &out->points, count);
		for (size_t k = 0; k < count && !outcome; k++)
			out->points.at[out->points.count++] = points[k];
		if (!outcome)
			outcome = ifc_ring_end(shaper, out, NULL);
	}
	if (!outcome)
		outcome = ifc_face_end(shaper, out);
	if (!outcome && out->faces.count > before)
		out->faces.at[before].paint = face->label;
	return outcome;
}

enum ifc_outcome
ifc_solid_faces(struct ifc_shaper *shaper, const struct solid *solid,
	struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < solid->faces.count && !outcome; i++)
		outcome = face_back(shaper, solid, solid->faces.at + i, out);
	return outcome;
}

/* ---- the cut ------------------------------------------------------------- */

static enum ifc_outcome
cut_judge(struct ifc_shaper *shaper, uint32_t item,
	const struct solid_report *report)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	if (report->outcome == SOLID_REFUSED)
		return ifc_remark(shaper, item, REPORT_SKIPPED, report->reason);
	if (report->tools_left_out)
		outcome = ifc_remark(shaper, item, REPORT_SKIPPED,
			"what should cut is not closed or has no volume");
	return outcome;
}

/* Carry out a task on the host, and let the host be what comes out. */
static enum ifc_outcome
task_run(struct ifc_shaper *shaper, struct ifc_cut *cut,
	struct solid_task *task, struct solid_report *report)
{
	struct tcs_fault fault;
	struct solid swap;

	if (!shaper->scratch->cutter)
		shaper->scratch->cutter = solid_cutter_new();
	if (!shaper->scratch->cutter)
		return IFC_NO_MEMORY;
	task->operation = cut->operation;
	task->host = &cut->host;
	task->tolerance = SOLID_TOLERANCE / shaper->unit;
	if (solid_cut(shaper->scratch->cutter, task, &cut->result, report, NULL,
		    &fault))
		return IFC_NO_MEMORY;
	swap = cut->host;
	cut->host = cut->result;
	cut->result = swap;
	return IFC_SHAPED;
}

/* One after the other, so that those cut that can be. */
static enum ifc_outcome
each_run(struct ifc_shaper *shaper, uint32_t item, struct ifc_cut *cut,
	bool *open)
{
	size_t tools = cut->tools.count;
	enum ifc_outcome outcome = IFC_SHAPED;

	*open = false;
	for (size_t i = 0; i < tools + cut->half_spaces.count && !outcome;
		i++) {
		const struct solid *tool = cut->tools.at + i;
		struct solid_task task = {.tools = &tool, .tool_count = 1};
		struct solid_report report;

		if (i >= tools)
			task = (struct solid_task){
				.half_spaces = cut->half_spaces.at + i - tools,
				.half_space_count = 1};
		outcome = task_run(shaper, cut, &task, &report);
		if (!outcome)
			outcome = cut_judge(shaper, item, &report);
		*open |= !outcome && report.outcome == SOLID_OPEN;
	}
	return outcome;
}

enum ifc_outcome
ifc_cut_run(struct ifc_shaper *shaper, uint32_t item, struct ifc_cut *cut,
	bool *open)
{
	struct solid_task task = {.tool_count = cut->tools.count,
		.half_spaces = cut->half_spaces.at,
		.half_space_count = cut->half_spaces.count};
	const struct solid **tools =
		malloc((cut->tools.count + 1) * sizeof *tools);
	struct solid_report report;
	enum ifc_outcome outcome;

	if (!tools)
		return IFC_NO_MEMORY;
	for (size_t i = 0; i < cut->tools.count; i++)
		tools[i] = cut->tools.at + i;
	task.tools = tools;
	outcome = task_run(shaper, cut, &task, &report);
	free(tools);
	if (outcome)
		return outcome;
	if (report.outcome == SOLID_REFUSED &&
		cut->operation != SOLID_INTERSECTION &&
		cut->tools.count + cut->half_spaces.count > 1)
		return each_run(shaper, item, cut, open);
	*open = report.outcome == SOLID_OPEN;
	return cut_judge(shaper, item, &report);
}
