#include <string.h>

#include "ifc_curved_face.h"
#include "ifc_cut.h"
#include "ifc_edge.h"
#include "ifc_item.h"
#include "ifc_orient.h"

enum {
	FACES = 0,
	BOUNDS = 0,
	SURFACE = 1,
	LOOP = 0,
	ORIENTATION = 1,
	POLYGON = 0
};

enum { OUTER = 0, VOIDS = 1 };

/* ---- faces --------------------------------------------------------------- */

/* The corners of a loop, none twice in a row. */
static enum ifc_outcome
loop_points(struct ifc_shaper *shaper, uint32_t loop, struct ifc_faces *out)
{
	struct step_value list = ifc_value(shaper->file, loop, POLYGON), item;
	struct ifc_points *points = &out->points;
	size_t first = points->count;
	enum ifc_outcome outcome = IFC_SHAPED;

	if (ifc_entity_of(shaper->file, loop) == IFC_EDGELOOP)
		return ifc_loop_points(shaper, loop, points);
	if (ifc_entity_of(shaper->file, loop) != IFC_POLYLOOP ||
		list.kind != STEP_LIST)
		return ifc_refuse(shaper, loop, "a loop is no polygon");
	while (!outcome && step_next(&list.list, &item) > STEP_END) {
		struct tcs_point point;

		if (!ifc_triple(shaper->file,
			    step_target(shaper->file->step, &item), &point))
			return ifc_refuse(
				shaper, loop, "a point is missing or bad");
		if (points->count > first &&
			!memcmp(&points->at[points->count - 1], &point,
				sizeof point))
			continue;
		outcome = ifc_point_add(shaper, points, point);
	}
	if (points->count > first + 1 &&
		!memcmp(&points->at[points->count - 1], &points->at[first],
			sizeof *points->at))
		points->count--;
	return outcome;
}

static enum ifc_outcome
bound_ring(struct ifc_shaper *shaper, uint32_t bound, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_cursor cursor = step_parameters(file->step, bound);
	struct step_value values[2] = {{.kind = STEP_END}, {.kind = STEP_END}};
	size_t first = out->points.count;
	enum ifc_outcome outcome;

	step_fetch(&cursor, values, 2);
	outcome = loop_points(
		shaper, step_target(file->step, &values[LOOP]), out);
	if (outcome)
		return outcome;
	if (step_is(&values[ORIENTATION], "F"))
		ifc_ring_reverse(
			out->points.at + first, out->points.count - first);
	return ifc_ring_end(shaper, out, NULL);
}

/* The bound called outer; the first where none is. */
static uint32_t
outer_bound(const struct ifc_file *file, const struct step_value *bounds)
{
	struct step_cursor cursor = bounds->list;
	uint32_t first = STEP_NONE;
	struct step_value item;

	while (step_next(&cursor, &item) > STEP_END) {
		uint32_t bound = step_target(file->step, &item);

		if (ifc_entity_of(file, bound) == IFC_FACEOUTERBOUND)
			return bound;
		if (first == STEP_NONE)
			first = bound;
	}
	return first;
}

static enum ifc_outcome
face_rings(struct ifc_shaper *shaper, uint32_t face, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value bounds = ifc_value(file, face, BOUNDS), item;
	enum ifc_outcome outcome;
	uint32_t outer;

	if (!ifc_is_kind(file, face, IFC_FACE) || bounds.kind != STEP_LIST)
		return ifc_refuse(shaper, face, "a face has no bounds");
	outer = outer_bound(file, &bounds);
	if (outer == STEP_NONE)
		return ifc_refuse(shaper, face, "a face has no bounds");
	outcome = bound_ring(shaper, outer, out);
	while (!outcome && step_next(&bounds.list, &item) > STEP_END) {
		uint32_t bound = step_target(file->step, &item);

		if (bound != outer)
			outcome = bound_ring(shaper, bound, out);
	}
	return outcome;
}

static bool
is_curved(const struct ifc_file *file, uint32_t face)
{
	return ifc_is_kind(file, face, IFC_FACESURFACE) &&
		ifc_entity_of(file, ifc_target(file, face, SURFACE)) !=
		IFC_PLANE;
}

/* One face, plane or curved; true in *curved for the latter. */
static enum ifc_outcome
face_read(struct ifc_shaper *shaper, uint32_t face, bool *curved,
	struct ifc_faces *out)
{
	enum ifc_outcome outcome;

	if (is_curved(shaper->file, face)) {
		*curved = true;
		return ifc_curved_face(shaper, face, out);
	}
	outcome = face_rings(shaper, face, out);
	return outcome ? outcome : ifc_face_end_wound(shaper, out);
}

/* A face that is bad is left out, with a remark; a shell of such is refused. */
static enum ifc_outcome
face_take(struct ifc_shaper *shaper, uint32_t face, bool *curved,
	struct ifc_faces *out)
{
	size_t before = out->faces.count;
	unsigned depth = shaper->depth;
	enum ifc_outcome outcome = face_read(shaper, face, curved, out);

	if (outcome != IFC_REFUSED)
		return outcome;
	ifc_faces_cut(out, before);
	shaper->depth = depth;
	return ifc_remark(
		shaper, shaper->culprit, REPORT_SKIPPED, shaper->reason);
}

static enum ifc_outcome
face_set(struct ifc_shaper *shaper, uint32_t set, struct ifc_faces *out)
{
	struct step_value list = ifc_value(shaper->file, set, FACES), item;
	TCS_ARRAY(uint32_t) groups = {.count = 0};
	size_t first = out->faces.count;
	enum ifc_outcome outcome = IFC_SHAPED;
	bool curved = false;

	if (!ifc_is_kind(shaper->file, set, IFC_CONNECTEDFACESET) ||
		list.kind != STEP_LIST)
		return ifc_refuse(shaper, set, "a shell has no faces");
	while (!outcome && step_next(&list.list, &item) > STEP_END) {
		if (array_grow(&groups, 1)) {
			outcome = IFC_NO_MEMORY;
			break;
		}
		groups.at[groups.count++] = (uint32_t)out->faces.count;
		outcome = face_take(shaper,
			step_target(shaper->file->step, &item), &curved, out);
	}
	/* Many programs disagree with themselves on senses of curved faces. */
	if (!outcome && curved)
		outcome = ifc_groups_orient(groups.at, groups.count, out);
	array_release(&groups);
	if (!outcome && out->faces.count == first)
		return ifc_refuse(shaper, set, "a shell has no faces");
	return outcome;
}

/* ---- models -------------------------------------------------------------- */

/* A closed shell, its faces turned so that they look out of the material. */
static enum ifc_outcome
shell(struct ifc_shaper *shaper, uint32_t shell, enum ifc_part_kind kind,
	uint32_t item, struct ifc_body *out)
{
	size_t first = out->faces.faces.count;
	enum ifc_outcome outcome = ifc_part_begin(out, kind, item);

	if (!outcome)
		outcome = face_set(shaper, shell, &out->faces);
	if (!outcome &&
		(ifc_faces_volume6(&out->faces, first) < 0) ==
			(kind == IFC_PART_SOLID))
		ifc_faces_reverse(&out->faces, first);
	return outcome;
}

enum ifc_outcome
ifc_brep(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	const struct ifc_file *file = shaper->file;
	enum ifc_outcome outcome = shell(shaper, ifc_target(file, item, OUTER),
		IFC_PART_SOLID, item, out);
	struct step_value voids, inner;

	if (outcome ||
		(ifc_entity_of(file, item) != IFC_FACETEDBREPWITHVOIDS &&
			ifc_entity_of(file, item) != IFC_ADVANCEDBREPWITHVOIDS))
		return outcome;
	voids = ifc_value(file, item, VOIDS);
	while (!outcome && voids.kind == STEP_LIST &&
		step_next(&voids.list, &inner) > STEP_END)
		outcome = shell(shaper, step_target(file->step, &inner),
			IFC_PART_VOID, item, out);
	return outcome;
}

enum ifc_outcome
ifc_surface_model(
	struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	struct step_value list = ifc_value(shaper->file, item, 0), set;
	enum ifc_outcome outcome;

	if (list.kind != STEP_LIST)
		return ifc_refuse(shaper, item, "a surface model has no faces");
	outcome = ifc_part_begin(out, IFC_PART_SURFACE, item);
	while (!outcome && step_next(&list.list, &set) > STEP_END)
		outcome = face_set(shaper,
			step_target(shaper->file->step, &set), &out->faces);
	return outcome;
}

enum ifc_outcome
ifc_lone_face(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	enum ifc_outcome outcome = ifc_part_begin(out, IFC_PART_SURFACE, item);
	bool curved;

	return outcome ? outcome
		       : face_read(shaper, item, &curved, &out->faces);
}
