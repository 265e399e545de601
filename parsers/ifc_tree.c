#include "ifc_tree.h"

#include <stdlib.h>

/* One kind of relation; `whole` has `part`, one or a list of them. */
struct relation {
	enum ifc_entity entity;
	const char *whole, *part;
	enum ifc_link link;
};

/* In the order in which they count. */
static const struct relation relations[] = {
	{IFC_RELAGGREGATES, "RelatingObject", "RelatedObjects", IFC_LINK_PART},
	{IFC_RELNESTS, "RelatingObject", "RelatedObjects", IFC_LINK_PART},
	{IFC_RELVOIDSELEMENT, "RelatingBuildingElement",
		"RelatedOpeningElement", IFC_LINK_VOID},
	{IFC_RELPROJECTSELEMENT, "RelatingElement", "RelatedFeatureElement",
		IFC_LINK_ADDITION},
	{IFC_RELCONTAINEDINSPATIALSTRUCTURE, "RelatingStructure",
		"RelatedElements", IFC_LINK_CONTENT},
};

struct linking {
	const struct ifc_file *file;
	struct ifc_tree *tree;
	struct report *report;
};

uint32_t
ifc_tree_find(const struct ifc_tree *tree, uint32_t instance)
{
	size_t low = 0, high = tree->count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (tree->at[middle].instance < instance)
			low = middle + 1;
		else
			high = middle;
	}
	return low < tree->count && tree->at[low].instance == instance
		? (uint32_t)low
		: STEP_NONE;
}

uint32_t
ifc_tree_above(const struct ifc_file *file, const struct ifc_tree *tree,
	uint32_t node, enum ifc_entity kind)
{
	while (node != STEP_NONE &&
		!ifc_is_kind(file, tree->at[node].instance, kind))
		node = tree->at[node].parent;
	return node;
}

static enum tcs_status
note(struct linking *linking, enum report_severity severity, uint32_t instance,
	const char *what, struct tcs_fault *fault)
{
	char id[IFC_ID_LENGTH];

	ifc_id(linking->file, instance, id);
	return report_item(linking->report, severity, "relation", what, id,
		step_place(linking->file->step, instance), fault);
}

/* The node that a value refers to. */
static uint32_t
node_of(const struct linking *linking, const struct step_value *value)
{
	uint32_t instance = step_target(linking->file->step, value);

	return instance == STEP_NONE ? STEP_NONE
				     : ifc_tree_find(linking->tree, instance);
}

static enum tcs_status
part_link(struct linking *linking, uint32_t relation, enum ifc_link link,
	uint32_t whole, const struct step_value *value, struct tcs_fault *fault)
{
	uint32_t part = node_of(linking, value);
	struct ifc_node *node;

	if (part == STEP_NONE)
		return note(linking, REPORT_NOTE, relation,
			"a member is missing or no object", fault);
	node = linking->tree->at + part;
	if (node->parent == whole)
		return TCS_OK;
	if (node->link != IFC_LINK_NONE)
		return note(linking, REPORT_NOTE, relation,
			"a member already belongs to something else", fault);
	node->parent = whole;
	node->link = link;
	return TCS_OK;
}

static enum tcs_status
relation_read(struct linking *linking, const struct relation *kind,
	uint32_t relation, struct tcs_fault *fault)
{
	const struct ifc_file *file = linking->file;
	enum ifc_entity entity = ifc_entity_of(file, relation);
	struct step_value whole = ifc_value(file, relation,
		ifc_attribute(file->version, entity, kind->whole));
	struct step_value part = ifc_value(file, relation,
		ifc_attribute(file->version, entity, kind->part));
	uint32_t node = node_of(linking, &whole);
	enum tcs_status status = TCS_OK;
	struct step_value item;

	if (node == STEP_NONE)
		return note(linking, REPORT_SKIPPED, relation,
			"what it relates to is missing or no object", fault);
	if (part.kind != STEP_LIST)
		return part_link(
			linking, relation, kind->link, node, &part, fault);
	while (!status && step_next(&part.list, &item) > STEP_END)
		status = part_link(
			linking, relation, kind->link, node, &item, fault);
	return status;
}

static enum tcs_status
relations_read(struct linking *linking, const struct relation *kind,
	struct ifc_instances *found, struct tcs_fault *fault)
{
	enum tcs_status status;

	array_clear(found);
	status = ifc_collect(linking->file, kind->entity, found, fault);
	for (size_t i = 0; i < found->count && !status; i++)
		status = relation_read(linking, kind, found->at[i], fault);
	return status;
}

static enum tcs_status
fillings_read(struct linking *linking, struct ifc_instances *found,
	struct tcs_fault *fault)
{
	const struct ifc_file *file = linking->file;
	int opening_at = ifc_attribute(
		file->version, IFC_RELFILLSELEMENT, "RelatingOpeningElement");
	int filling_at = ifc_attribute(
		file->version, IFC_RELFILLSELEMENT, "RelatedBuildingElement");
	enum tcs_status status;

	array_clear(found);
	status = ifc_collect(file, IFC_RELFILLSELEMENT, found, fault);
	for (size_t i = 0; i < found->count && !status; i++) {
		uint32_t opening = ifc_tree_find(linking->tree,
			ifc_target(file, found->at[i], opening_at));
		uint32_t filling = ifc_tree_find(linking->tree,
			ifc_target(file, found->at[i], filling_at));

		if (opening == STEP_NONE || filling == STEP_NONE)
			status = note(linking, REPORT_NOTE, found->at[i],
				"a member is missing or no object", fault);
		else if (linking->tree->at[filling].fills == STEP_NONE)
			linking->tree->at[filling].fills = opening;
	}
	return status;
}

/* Cut each ring of parents once. Every node is passed at most twice. */
static enum tcs_status
rings_cut(struct linking *linking, struct tcs_fault *fault)
{
	struct ifc_tree *tree = linking->tree;
	uint32_t *seen_from = calloc(tree->count + 1, sizeof *seen_from);
	enum tcs_status status = TCS_OK;

	if (!seen_from)
		return fault_memory(fault);
	for (uint32_t start = 0; start < tree->count && !status; start++) {
		uint32_t at = start, last = start;

		while (at != STEP_NONE && !seen_from[at]) {
			seen_from[at] = start + 1;
			last = at;
			at = tree->at[at].parent;
		}
		if (at == STEP_NONE || seen_from[at] != start + 1)
			continue;
		tree->at[last].parent = STEP_NONE;
		tree->at[last].link = IFC_LINK_NONE;
		status = note(linking, REPORT_SKIPPED, tree->at[last].instance,
			"an object belongs to itself in a ring", fault);
	}
	free(seen_from);
	return status;
}

static enum tcs_status
nodes_list(struct linking *linking, struct ifc_instances *found,
	struct tcs_fault *fault)
{
	const struct ifc_file *file = linking->file;
	struct ifc_tree *tree = linking->tree;
	enum tcs_status status;

	status = ifc_collect(file, IFC_OBJECTDEFINITION, found, fault);
	if (status)
		return status;
	if (array_grow(tree, found->count + 1))
		return fault_memory(fault);
	for (size_t i = 0; i < found->count; i++)
		if (!ifc_is_kind(file, found->at[i], IFC_TYPEOBJECT))
			tree->at[tree->count++] =
				(struct ifc_node){.instance = found->at[i],
					.parent = STEP_NONE,
					.fills = STEP_NONE};
	return TCS_OK;
}

enum tcs_status
ifc_tree_read(const struct ifc_file *file, struct ifc_tree *out,
	struct report *report, struct tcs_fault *fault)
{
	struct linking linking = {file, out, report};
	struct ifc_instances found = {.count = 0};
	enum tcs_status status;

	array_clear(out);
	status = nodes_list(&linking, &found, fault);
	for (size_t i = 0; i < sizeof relations / sizeof *relations && !status;
		i++)
		status = relations_read(&linking, relations + i, &found, fault);
	if (!status)
		status = fillings_read(&linking, &found, fault);
	if (!status)
		status = rings_cut(&linking, fault);
	array_release(&found);
	return status;
}
