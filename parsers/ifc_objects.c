#include "ifc_objects.h"

#include <stdlib.h>
#include <string.h>

#include "ifc_representation.h"
#include "ifc_storeys.h"

/* The tree turned round: by node, in the order of the file. */
struct forest {
	const struct ifc_file *file;
	const struct ifc_tree *tree;
	bool *is_member;
	uint32_t *above; /* the nearest member above; STEP_NONE: stands alone */
	uint32_t *first_child, *next_sibling;
	uint32_t *place; /* member number within its object */
	uint32_t *stack;
};

/* Kinds that are never shown, and kinds that are only with a body. */
static const enum ifc_entity never[] = {IFC_FEATUREELEMENTSUBTRACTION, IFC_PORT,
	IFC_ANNOTATION, IFC_GRID, IFC_STRUCTURALACTIVITY, IFC_LINEARELEMENT};
static const enum ifc_entity if_shown[] = {
	IFC_POSITIONINGELEMENT, IFC_STRUCTURALITEM};

/* Spaces, storeys and so on are kept whatever is listed. */
static bool
is_listed(const struct ifc_file *file, uint32_t instance,
	const struct ifc_keep *keep)
{
	if (!keep->type_count ||
		ifc_is_kind(file, instance, IFC_SPATIALSTRUCTUREELEMENT))
		return true;
	for (size_t i = 0; i < keep->type_count; i++)
		if (ifc_is_kind(file, instance, keep->types[i]))
			return true;
	return false;
}

static bool
is_member(const struct ifc_file *file, uint32_t instance,
	const struct ifc_keep *keep)
{
	if (!ifc_is_kind(file, instance, IFC_PRODUCT))
		return false;
	if (keep->no_spaces && ifc_is_kind(file, instance, IFC_SPACE))
		return false;
	if (!is_listed(file, instance, keep))
		return false;
	for (size_t i = 0; i < sizeof never / sizeof *never; i++)
		if (ifc_is_kind(file, instance, never[i]))
			return false;
	for (size_t i = 0; i < sizeof if_shown / sizeof *if_shown; i++)
		if (ifc_is_kind(file, instance, if_shown[i]))
			return ifc_body_of(file, instance) != STEP_NONE;
	return true;
}

/* The nearest member above; a site stands alone and holds nothing. */
static uint32_t
member_above(const struct forest *forest, uint32_t node)
{
	const struct ifc_node *nodes = forest->tree->at;
	uint32_t at = nodes[node].parent;

	if (ifc_is_kind(forest->file, nodes[node].instance, IFC_SITE))
		return STEP_NONE;
	while (at != STEP_NONE && !forest->is_member[at])
		at = nodes[at].parent;
	if (at == STEP_NONE ||
		ifc_is_kind(forest->file, nodes[at].instance, IFC_SITE))
		return STEP_NONE;
	return at;
}

static enum tcs_status
forest_begin(struct forest *forest, struct tcs_fault *fault)
{
	size_t count = forest->tree->count + 1;

	forest->is_member = calloc(count, sizeof *forest->is_member);
	forest->above = malloc(count * sizeof *forest->above);
	forest->first_child = malloc(count * sizeof *forest->first_child);
	forest->next_sibling = malloc(count * sizeof *forest->next_sibling);
	forest->place = malloc(count * sizeof *forest->place);
	forest->stack = malloc(count * sizeof *forest->stack);
	if (!forest->is_member || !forest->above || !forest->first_child ||
		!forest->next_sibling || !forest->place || !forest->stack)
		return fault_memory(fault);
	return TCS_OK;
}

static void
forest_end(struct forest *forest)
{
	free(forest->is_member);
	free(forest->above);
	free(forest->first_child);
	free(forest->next_sibling);
	free(forest->place);
	free(forest->stack);
}

static enum tcs_status
members_choose(struct forest *forest, const struct ifc_keep *keep,
	struct tcs_fault *fault)
{
	for (uint32_t i = 0; i < forest->tree->count; i++)
		forest->is_member[i] = true;
	if (keep->storey_count) {
		enum tcs_status status = ifc_storeys_choose(forest->file,
			forest->tree, keep, forest->is_member, fault);

		if (status)
			return status;
	}
	for (uint32_t i = 0; i < forest->tree->count; i++)
		forest->is_member[i] &= is_member(
			forest->file, forest->tree->at[i].instance, keep);
	return TCS_OK;
}

static void
forest_link(struct forest *forest)
{
	uint32_t count = (uint32_t)forest->tree->count;

	for (uint32_t i = 0; i < count; i++)
		forest->first_child[i] = STEP_NONE;
	/* From behind, so that children stand in the order of the file. */
	for (uint32_t i = count; i-- > 0;) {
		uint32_t above;

		if (!forest->is_member[i])
			continue;
		above = member_above(forest, i);
		forest->above[i] = above;
		if (above == STEP_NONE)
			continue;
		forest->next_sibling[i] = forest->first_child[above];
		forest->first_child[above] = i;
	}
}

/* The members below `root`, in depth-first order. */
static enum tcs_status
object_add(struct forest *forest, uint32_t root, struct ifc_objects *out,
	struct tcs_fault *fault)
{
	struct ifc_object object = {(uint32_t)out->members.count, 0};
	size_t depth = 0;

	forest->stack[depth++] = root;
	while (depth) {
		uint32_t node = forest->stack[--depth];
		uint32_t child = forest->first_child[node];
		uint32_t above = forest->above[node];
		size_t base = depth;

		if (array_grow(&out->members, 1))
			return fault_memory(fault);
		forest->place[node] = object.member_count++;
		out->members.at[out->members.count++] = (struct ifc_member){
			node, node == root ? STEP_NONE : forest->place[above]};
		for (; child != STEP_NONE; child = forest->next_sibling[child])
			forest->stack[depth++] = child;
		for (size_t low = base, high = depth; low + 1 < high; low++) {
			uint32_t swap = forest->stack[low];

			forest->stack[low] = forest->stack[--high];
			forest->stack[high] = swap;
		}
	}
	if (array_grow(&out->objects, 1))
		return fault_memory(fault);
	out->objects.at[out->objects.count++] = object;
	return TCS_OK;
}

enum tcs_status
ifc_objects_list(const struct ifc_file *file, const struct ifc_tree *tree,
	const struct ifc_keep *keep, struct ifc_objects *out,
	struct tcs_fault *fault)
{
	struct forest forest = {.file = file, .tree = tree};
	enum tcs_status status = forest_begin(&forest, fault);

	if (!status)
		status = members_choose(&forest, keep, fault);
	if (!status)
		forest_link(&forest);
	for (uint32_t i = 0; i < tree->count && !status; i++)
		if (forest.is_member[i] && forest.above[i] == STEP_NONE)
			status = object_add(&forest, i, out, fault);
	forest_end(&forest);
	return status;
}

void
ifc_objects_release(struct ifc_objects *objects)
{
	array_release(&objects->objects);
	array_release(&objects->members);
}
