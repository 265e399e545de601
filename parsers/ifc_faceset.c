#include "ifc_item.h"
#include "ifc_point_list.h"
#include "ifc_style.h"

enum { COORDINATES = 0, TRIANGLES = 3, FACES = 2 };

enum { OUTER_INDEX = 0, INNER_INDICES = 1 };

/* A face set being read: its points, and indices by way of PnIndex or not. */
struct indexing {
	uint32_t item;
	const struct ifc_points *points;
	TCS_ARRAY(uint32_t) through; /* PnIndex, from 0; empty: none */
};

static bool
index_find(const struct indexing *indexing, const struct step_value *value,
	size_t *out)
{
	int64_t index;

	if (!step_integer(value, &index) || index < 1)
		return false;
	if (indexing->through.count) {
		if ((uint64_t)index > indexing->through.count)
			return false;
		index = (int64_t)indexing->through.at[index - 1] + 1;
	}
	*out = (size_t)index - 1;
	return *out < indexing->points->count;
}

static enum ifc_outcome
ring_read(struct ifc_shaper *shaper, const struct indexing *indexing,
	struct step_value *list, struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;
	struct step_value value;
	size_t index;

	if (list->kind != STEP_LIST)
		return ifc_refuse(shaper, indexing->item, "a face is bad");
	while (!outcome && step_next(&list->list, &value) > STEP_END) {
		if (!index_find(indexing, &value, &index))
			return ifc_refuse(
				shaper, indexing->item, "an index is bad");
		outcome = ifc_point_add(
			shaper, &out->points, indexing->points->at[index]);
	}
	return outcome ? outcome : ifc_ring_end(shaper, out, NULL);
}

static enum ifc_outcome
polygon_read(struct ifc_shaper *shaper, const struct indexing *indexing,
	uint32_t polygon, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value list = ifc_value(file, polygon, OUTER_INDEX), inner;
	enum ifc_outcome outcome;

	if (!ifc_is_kind(file, polygon, IFC_INDEXEDPOLYGONALFACE))
		return ifc_refuse(shaper, indexing->item, "a face is missing");
	outcome = ring_read(shaper, indexing, &list, out);
	if (outcome ||
		ifc_entity_of(file, polygon) !=
			IFC_INDEXEDPOLYGONALFACEWITHVOIDS)
		return outcome;
	list = ifc_value(file, polygon, INNER_INDICES);
	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &inner) > STEP_END)
		outcome = ring_read(shaper, indexing, &inner, out);
	return outcome;
}

/* Each face of the set, with the colour that a map gives it. */
static enum ifc_outcome
faces_read(struct ifc_shaper *shaper, const struct indexing *indexing,
	bool triangles, struct ifc_faces *out)
{
	struct step_value list = ifc_value(
		shaper->file, indexing->item, triangles ? TRIANGLES : FACES);
	struct ifc_colour_walk colours;
	struct step_value item;
	enum ifc_outcome outcome = IFC_SHAPED;

	if (list.kind != STEP_LIST)
		return ifc_refuse(
			shaper, indexing->item, "a face set has no faces");
	ifc_colours_begin(shaper->styles, indexing->item, &colours);
	while (!outcome && step_next(&list.list, &item) > STEP_END) {
		uint32_t paint = ifc_colours_next(&colours);
		size_t before = out->faces.count;

		outcome = triangles
			? ring_read(shaper, indexing, &item, out)
			: polygon_read(shaper, indexing,
				  step_target(shaper->file->step, &item), out);
		if (!outcome)
			outcome = ifc_face_end_wound(shaper, out);
		if (out->faces.count > before)
			out->faces.at[before].paint = paint;
	}
	return outcome;
}

static enum ifc_outcome
through_read(
	struct ifc_shaper *shaper, bool triangles, struct indexing *indexing)
{
	struct step_value list =
		ifc_value(shaper->file, indexing->item, triangles ? 4 : 3);
	struct step_value value;
	int64_t index;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END) {
		if (!step_integer(&value, &index) || index < 1 ||
			index > UINT32_MAX)
			return ifc_refuse(
				shaper, indexing->item, "an index is bad");
		if (array_grow(&indexing->through, 1))
			return IFC_NO_MEMORY;
		indexing->through.at[indexing->through.count++] =
			(uint32_t)index - 1;
	}
	return IFC_SHAPED;
}

/* What `Closed` says. */
static enum ifc_part_kind
faceset_kind(const struct ifc_file *file, uint32_t item, bool triangles)
{
	struct step_value closed = ifc_value(file, item, triangles ? 2 : 1);

	return step_is(&closed, "T") ? IFC_PART_SOLID : IFC_PART_SURFACE;
}

enum ifc_outcome
ifc_faceset(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	bool triangles =
		ifc_is_kind(shaper->file, item, IFC_TRIANGULATEDFACESET);
	struct indexing indexing = {
		.item = item, .points = &shaper->scratch->points};
	size_t first = out->faces.faces.count;
	enum ifc_part_kind kind = faceset_kind(shaper->file, item, triangles);
	enum ifc_outcome outcome;

	array_clear(&shaper->scratch->points);
	outcome = ifc_point_list_read(shaper,
		ifc_target(shaper->file, item, COORDINATES),
		&shaper->scratch->points);
	if (!outcome)
		outcome = through_read(shaper, triangles, &indexing);
	if (!outcome)
		outcome = ifc_part_begin(out, kind, item);
	if (!outcome)
		outcome = faces_read(shaper, &indexing, triangles, &out->faces);
	if (!outcome && kind == IFC_PART_SOLID &&
		ifc_faces_volume6(&out->faces, first) < 0)
		ifc_faces_reverse(&out->faces, first);
	array_release(&indexing.through);
	return outcome;
}
