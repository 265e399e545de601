#include "ifc_links.h"

#include <stdlib.h>

static const struct {
	enum ifc_entity relation;
	const char *objects, *target;
	enum ifc_link_kind kind;
} kinds[] = {
	{IFC_RELDEFINESBYPROPERTIES, "RelatedObjects",
		"RelatingPropertyDefinition", IFC_SAYS_PROPERTIES},
	{IFC_RELDEFINESBYTYPE, "RelatedObjects", "RelatingType", IFC_SAYS_TYPE},
	{IFC_RELASSOCIATESMATERIAL, "RelatedObjects", "RelatingMaterial",
		IFC_SAYS_MATERIAL},
	{IFC_RELASSOCIATESCLASSIFICATION, "RelatedObjects",
		"RelatingClassification", IFC_SAYS_CLASS},
};

static enum tcs_status
link_add(struct ifc_links *out, uint32_t object, uint32_t target,
	enum ifc_link_kind kind, struct tcs_fault *fault)
{
	if (object == STEP_NONE || target == STEP_NONE)
		return TCS_OK;
	if (array_grow(out, 1))
		return fault_memory(fault);
	out->at[out->count++] = (struct ifc_said){object, target, kind};
	return TCS_OK;
}

/* Each object of the list with the target: one, or in IFC4 a set of them. */
static enum tcs_status
relation_read(const struct ifc_file *file, struct step_value objects,
	const struct step_value *target, enum ifc_link_kind kind,
	struct ifc_links *out, struct tcs_fault *fault)
{
	struct step_value several = step_untyped(target), object, one;
	enum tcs_status status = TCS_OK;

	while (!status && objects.kind == STEP_LIST &&
		step_next(&objects.list, &object) > STEP_END) {
		uint32_t instance = step_target(file->step, &object);
		struct step_cursor walk;

		if (several.kind != STEP_LIST) {
			status = link_add(out, instance,
				step_target(file->step, target), kind, fault);
			continue;
		}
		walk = several.list;
		while (!status && step_next(&walk, &one) > STEP_END)
			status = link_add(out, instance,
				step_target(file->step, &one), kind, fault);
	}
	return status;
}

static int
said_order(const void *left, const void *right)
{
	const struct ifc_said *a = left, *b = right;

	if (a->object != b->object)
		return a->object < b->object ? -1 : 1;
	if (a->kind != b->kind)
		return a->kind < b->kind ? -1 : 1;
	return a->target < b->target ? -1 : a->target > b->target;
}

enum tcs_status
ifc_links_read(const struct ifc_file *file, struct ifc_links *out,
	struct tcs_fault *fault)
{
	struct ifc_instances found = {.count = 0};
	enum tcs_status status = TCS_OK;

	for (size_t k = 0; k < sizeof kinds / sizeof *kinds && !status; k++) {
		array_clear(&found);
		status = ifc_collect(file, kinds[k].relation, &found, fault);
		for (size_t i = 0; i < found.count && !status; i++) {
			enum ifc_entity entity =
				ifc_entity_of(file, found.at[i]);
			struct step_value target = ifc_value(file, found.at[i],
				ifc_attribute(file->version, entity,
					kinds[k].target));

			status = relation_read(file,
				ifc_value(file, found.at[i],
					ifc_attribute(file->version, entity,
						kinds[k].objects)),
				&target, kinds[k].kind, out, fault);
		}
	}
	array_release(&found);
	if (!status && out->count)
		qsort(out->at, out->count, sizeof *out->at, said_order);
	return status;
}

const struct ifc_said *
ifc_links_find(const struct ifc_links *links, uint32_t object,
	enum ifc_link_kind kind, size_t *count)
{
	struct ifc_said wanted = {object, 0, kind};
	size_t low = 0, high = links->count, first;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (said_order(links->at + middle, &wanted) < 0)
			low = middle + 1;
		else
			high = middle;
	}
	for (first = low; low < links->count &&
		links->at[low].object == object && links->at[low].kind == kind;)
		low++;
	*count = low - first;
	return *count ? links->at + first : NULL;
}
