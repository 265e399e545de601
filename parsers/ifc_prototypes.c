#include "ifc_prototypes.h"

#include <stdlib.h>

#include "ifc_attributes.h"
#include "ifc_representation.h"

enum { MAPPING_SOURCE = 0 };

/* Whether openings cut the node, its own or those of what it is a part of. */
static bool
is_cut(const struct ifc_model *model, uint32_t node)
{
	for (;;) {
		const struct ifc_node *at = model->tree.at + node;
		size_t count;

		if (ifc_openings_find(&model->openings, node, &count))
			return true;
		if (at->link != IFC_LINK_PART)
			return false;
		node = at->parent;
	}
}

bool
ifc_is_instance(const struct ifc_model *model, uint32_t node)
{
	const struct ifc_file *file = &model->file;
	uint32_t body = ifc_body_of(file, model->tree.at[node].instance);
	struct step_value list = ifc_items_of(file, body), value;
	size_t count = 0;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END) {
		uint32_t item = step_target(file->step, &value);

		if (ifc_entity_of(file, item) != IFC_MAPPEDITEM ||
			ifc_style_paint(&model->styles, item))
			return false;
		count++;
	}
	return count && !is_cut(model, node);
}

static int
prototype_order(const void *left, const void *right)
{
	const struct ifc_prototype *a = left, *b = right;

	if (a->map != b->map)
		return a->map < b->map ? -1 : 1;
	if (a->paint != b->paint)
		return a->paint < b->paint ? -1 : 1;
	return a->item < b->item ? -1 : a->item > b->item;
}

static enum tcs_status
uses_add(const struct ifc_model *model, uint32_t node,
	struct ifc_prototypes *out, struct tcs_fault *fault)
{
	const struct ifc_file *file = &model->file;
	uint32_t product = model->tree.at[node].instance;
	uint32_t paint = ifc_material_paint(model, product);
	struct step_value list = ifc_items_of(file, ifc_body_of(file, product));
	struct step_value value;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END) {
		uint32_t item = step_target(file->step, &value);

		if (array_grow(out, 1))
			return fault_memory(fault);
		out->at[out->count++] = (struct ifc_prototype){
			ifc_target(file, item, MAPPING_SOURCE), paint, item,
			TCS_NONE};
	}
	return TCS_OK;
}

/* Sort, and keep one of each that is there more than once. */
static void
uses_count(struct ifc_prototypes *uses)
{
	size_t kept = 0;

	if (uses->count)
		qsort(uses->at, uses->count, sizeof *uses->at, prototype_order);
	for (size_t i = 0, end; i < uses->count; i = end) {
		struct ifc_prototype one = uses->at[i];

		for (end = i + 1; end < uses->count &&
			uses->at[end].map == one.map &&
			uses->at[end].paint == one.paint;)
			end++;
		if (end - i > 1)
			uses->at[kept++] = one;
	}
	uses->count = kept;
}

enum tcs_status
ifc_prototypes_list(const struct ifc_model *model, struct ifc_prototypes *out,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < model->objects.members.count && !status; i++) {
		uint32_t node = model->objects.members.at[i].node;

		if (ifc_is_instance(model, node))
			status = uses_add(model, node, out, fault);
	}
	uses_count(out);
	return status;
}

const struct ifc_prototype *
ifc_prototype_find(const struct ifc_model *model,
	const struct ifc_prototypes *prototypes, uint32_t item, uint32_t paint)
{
	struct ifc_prototype wanted = {
		.map = ifc_target(&model->file, item, MAPPING_SOURCE),
		.paint = paint};
	size_t low = 0, high = prototypes->count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (prototype_order(prototypes->at + middle, &wanted) < 0)
			low = middle + 1;
		else
			high = middle;
	}
	if (low == prototypes->count || prototypes->at[low].map != wanted.map ||
		prototypes->at[low].paint != paint ||
		prototypes->at[low].number == TCS_NONE)
		return NULL;
	return prototypes->at + low;
}
