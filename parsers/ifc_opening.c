#include "ifc_opening.h"

#include <math.h>
#include <stdlib.h>

/* ---- which --------------------------------------------------------------- */

static int
opening_order(const void *left, const void *right)
{
	const struct ifc_opening *a = left, *b = right;

	if (a->host != b->host)
		return a->host < b->host ? -1 : 1;
	return a->opening < b->opening ? -1 : a->opening > b->opening;
}

enum tcs_status
ifc_openings_list(const struct ifc_tree *tree, struct ifc_openings *out,
	struct tcs_fault *fault)
{
	for (uint32_t i = 0; i < tree->count; i++) {
		enum ifc_link link = tree->at[i].link;

		if (link != IFC_LINK_VOID && link != IFC_LINK_ADDITION)
			continue;
		if (array_grow(out, 1))
			return fault_memory(fault);
		out->at[out->count++] = (struct ifc_opening){
			tree->at[i].parent, i, link == IFC_LINK_ADDITION};
	}
	if (out->count)
		qsort(out->at, out->count, sizeof *out->at, opening_order);
	return TCS_OK;
}

const struct ifc_opening *
ifc_openings_find(
	const struct ifc_openings *openings, uint32_t host, size_t *count)
{
	size_t low = 0, high = openings->count, first;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (openings->at[middle].host < host)
			low = middle + 1;
		else
			high = middle;
	}
	for (first = low;
		low < openings->count && openings->at[low].host == host;)
		low++;
	*count = low - first;
	return *count ? openings->at + first : NULL;
}

/* ---- cutting ------------------------------------------------------------- */

struct box {
	struct tcs_point lower, upper;
};

static struct box
faces_box(const struct ifc_faces *faces, size_t first, size_t end)
{
	struct box box = {{HUGE_VAL, HUGE_VAL, HUGE_VAL},
		{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
	size_t at, stop;

	if (first == end)
		return box;
	at = faces->faces.at[first].first_point;
	stop = faces->faces.at[end - 1].first_point +
		ifc_face_points(faces, faces->faces.at + end - 1);
	for (; at < stop; at++) {
		struct tcs_point p = faces->points.at[at];

		box.lower.x = fmin(box.lower.x, p.x);
		box.lower.y = fmin(box.lower.y, p.y);
		box.lower.z = fmin(box.lower.z, p.z);
		box.upper.x = fmax(box.upper.x, p.x);
		box.upper.y = fmax(box.upper.y, p.y);
		box.upper.z = fmax(box.upper.z, p.z);
	}
	return box;
}

static bool
boxes_meet(const struct box *a, const struct box *b)
{
	return a->lower.x < b->upper.x && b->lower.x < a->upper.x &&
		a->lower.y < b->upper.y && b->lower.y < a->upper.y &&
		a->lower.z < b->upper.z && b->lower.z < a->upper.z;
}

/* Where the faces of the parts before `end` end. */
static size_t
parts_faces_end(const struct ifc_body *body, size_t end)
{
	return ifc_part_end(body, end - 1);
}

/* The tools that reach the faces of the host. */
static enum ifc_outcome
tools_take(struct ifc_cut *cut, const struct ifc_body *tools,
	const struct box *host)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < tools->parts.count && !outcome;) {
		size_t end = ifc_solid_end(tools, i);
		size_t first = tools->parts.at[i].first_face;
		size_t last = parts_faces_end(tools, end);
		struct box box = faces_box(&tools->faces, first, last);
		struct solid *tool;

		i = end;
		if (!boxes_meet(&box, host))
			continue;
		tool = ifc_cut_tool(cut);
		outcome = tool ? ifc_solid_add(tool, &tools->faces, first, last)
			       : IFC_NO_MEMORY;
	}
	return outcome;
}

/* Append parts as they are. */
static enum ifc_outcome
parts_copy(struct ifc_shaper *shaper, const struct ifc_body *from, size_t part,
	size_t end, struct ifc_body *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (; part < end && !outcome; part++) {
		outcome = ifc_part_begin(out, from->parts.at[part].kind,
			from->parts.at[part].item);
		if (!outcome)
			outcome = ifc_faces_append_some(shaper, &out->faces,
				&from->faces, from->parts.at[part].first_face,
				ifc_part_end(from, part));
	}
	return outcome;
}

/* One solid with its voids, or one surface, less what reaches it. */
static enum ifc_outcome
part_open(struct ifc_shaper *shaper, uint32_t product,
	const struct ifc_body *tools, const struct ifc_body *from, size_t part,
	size_t end, struct ifc_body *out)
{
	size_t first = from->parts.at[part].first_face;
	size_t last = parts_faces_end(from, end);
	struct box box = faces_box(&from->faces, first, last);
	struct ifc_cut cut = {.operation = SOLID_DIFFERENCE};
	enum ifc_outcome outcome = tools_take(&cut, tools, &box);
	bool open;

	if (!outcome && !cut.tools.count) {
		ifc_cut_release(&cut);
		return parts_copy(shaper, from, part, end, out);
	}
	if (!outcome)
		outcome = ifc_solid_add(&cut.host, &from->faces, first, last);
	if (!outcome)
		outcome = ifc_cut_run(shaper, product, &cut, &open);
	if (!outcome && !cut.host.faces.count)
		outcome = ifc_remark(shaper, product, REPORT_NOTE,
			"nothing is left of a part beside its openings");
	else if (!outcome)
		outcome = ifc_part_begin(out,
			open ? IFC_PART_SURFACE : from->parts.at[part].kind,
			from->parts.at[part].item);
	if (!outcome)
		outcome = ifc_solid_faces(shaper, &cut.host, &out->faces);
	ifc_cut_release(&cut);
	return outcome;
}

/* What became of a body takes its place, unless that failed. */
static enum ifc_outcome
body_replace(
	struct ifc_body *body, struct ifc_body *out, enum ifc_outcome outcome)
{
	ifc_body_release(outcome ? out : body);
	if (!outcome)
		*body = *out;
	return outcome;
}

enum ifc_outcome
ifc_body_open(struct ifc_shaper *shaper, uint32_t product,
	const struct ifc_body *tools, struct ifc_body *body)
{
	struct ifc_body out = {.faces = {.points = {.count = 0}}};
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t part = 0; part < body->parts.count && !outcome;) {
		size_t end = ifc_solid_end(body, part);

		outcome = part_open(
			shaper, product, tools, body, part, end, &out);
		part = end;
	}
	return body_replace(body, &out, outcome);
}

/* ---- joining ------------------------------------------------------------- */

/* The first solid of a body that a box touches, or how many parts there are. */
static size_t
part_touched(const struct ifc_shaper *shaper, const struct ifc_body *body,
	struct box box)
{
	double reach = SOLID_TOLERANCE / shaper->unit;
	size_t part = 0;

	box.lower = (struct tcs_point){
		box.lower.x - reach, box.lower.y - reach, box.lower.z - reach};
	box.upper = (struct tcs_point){
		box.upper.x + reach, box.upper.y + reach, box.upper.z + reach};
	while (part < body->parts.count) {
		size_t end = ifc_solid_end(body, part);
		struct box own =
			faces_box(&body->faces, body->parts.at[part].first_face,
				parts_faces_end(body, end));

		if (body->parts.at[part].kind == IFC_PART_SOLID &&
			boxes_meet(&own, &box))
			return part;
		part = end;
	}
	return part;
}

/*
 * The tools whose part this is: as tools of the cut, or where there is none
 * copied to `out`.
 */
static enum ifc_outcome
tools_choose(struct ifc_shaper *shaper, const struct ifc_body *tools,
	const struct ifc_body *body, size_t part, struct ifc_cut *cut,
	struct ifc_body *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0, end; i < tools->parts.count && !outcome; i = end) {
		size_t first = tools->parts.at[i].first_face, last;
		struct solid *tool;

		end = ifc_solid_end(tools, i);
		last = parts_faces_end(tools, end);
		if (part_touched(shaper, body,
			    faces_box(&tools->faces, first, last)) != part)
			continue;
		if (!cut) {
			outcome = parts_copy(shaper, tools, i, end, out);
			continue;
		}
		tool = ifc_cut_tool(cut);
		outcome = tool ? ifc_solid_add(tool, &tools->faces, first, last)
			       : IFC_NO_MEMORY;
	}
	return outcome;
}

/* One solid and its tools; beside each other where they cannot be joined. */
static enum ifc_outcome
part_join(struct ifc_shaper *shaper, uint32_t product,
	const struct ifc_body *tools, const struct ifc_body *from, size_t part,
	size_t end, struct ifc_body *out)
{
	struct ifc_cut cut = {.operation = SOLID_UNION};
	size_t remarks = shaper->scratch->remarks.count;
	enum ifc_outcome outcome =
		tools_choose(shaper, tools, from, part, &cut, NULL);
	bool open, joined = cut.tools.count > 0;

	if (!outcome && joined)
		outcome = ifc_solid_add(&cut.host, &from->faces,
			from->parts.at[part].first_face,
			parts_faces_end(from, end));
	if (!outcome && joined)
		outcome = ifc_cut_run(shaper, product, &cut, &open);
	if (!outcome && joined && remarks == shaper->scratch->remarks.count) {
		outcome = ifc_part_begin(out,
			open ? IFC_PART_SURFACE : from->parts.at[part].kind,
			from->parts.at[part].item);
		if (!outcome)
			outcome =
				ifc_solid_faces(shaper, &cut.host, &out->faces);
	} else if (!outcome) {
		outcome = parts_copy(shaper, from, part, end, out);
		if (!outcome)
			outcome = tools_choose(
				shaper, tools, from, part, NULL, out);
	}
	ifc_cut_release(&cut);
	return outcome;
}

enum ifc_outcome
ifc_body_join(struct ifc_shaper *shaper, uint32_t product,
	const struct ifc_body *tools, struct ifc_body *body)
{
	struct ifc_body out = {.faces = {.points = {.count = 0}}};
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t part = 0; part < body->parts.count && !outcome;) {
		size_t end = ifc_solid_end(body, part);

		outcome = part_join(
			shaper, product, tools, body, part, end, &out);
		part = end;
	}
	if (!outcome)
		outcome = tools_choose(
			shaper, tools, body, body->parts.count, NULL, &out);
	return body_replace(body, &out, outcome);
}
