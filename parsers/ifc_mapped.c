#include "ifc_item.h"

enum { SOURCE, TARGET };

enum { ORIGIN, REPRESENTATION };

enum { ITEMS = 3 };

enum ifc_outcome
ifc_mapped_read(struct ifc_shaper *shaper, uint32_t item,
	uint32_t *representation, struct ifc_matrix *matrix)
{
	const struct ifc_file *file = shaper->file;
	uint32_t map = ifc_target(file, item, SOURCE);
	struct step_value origin = ifc_value(file, map, ORIGIN);
	struct ifc_matrix target, from = ifc_identity;

	if (ifc_entity_of(file, item) != IFC_MAPPEDITEM ||
		ifc_entity_of(file, map) != IFC_REPRESENTATIONMAP)
		return ifc_refuse(shaper, item, "a mapping has no source");
	if (!ifc_operator(file, ifc_target(file, item, TARGET), &target) ||
		(origin.kind == STEP_REFERENCE &&
			!ifc_axes(
				file, step_target(file->step, &origin), &from)))
		return ifc_refuse(shaper, item, "a mapping has no target");
	*matrix = ifc_multiply(&target, &from);
	*representation = ifc_target(file, map, REPRESENTATION);
	return IFC_SHAPED;
}

enum ifc_outcome
ifc_mapped(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	const struct ifc_file *file = shaper->file;
	size_t first = out->faces.faces.count;
	struct step_value list, member;
	struct ifc_matrix matrix;
	enum ifc_outcome outcome;
	uint32_t representation;

	outcome = ifc_mapped_read(shaper, item, &representation, &matrix);
	if (outcome)
		return outcome;
	list = ifc_value(file, representation, ITEMS);
	if (list.kind != STEP_LIST)
		return ifc_refuse(shaper, item, "a mapping maps nothing");
	while (!outcome && step_next(&list.list, &member) > STEP_END)
		outcome = ifc_item_body(
			shaper, step_target(file->step, &member), out);
	if (!outcome)
		ifc_faces_transform(&out->faces, first, &matrix);
	return outcome;
}
