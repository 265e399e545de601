#include "ifc_storeys.h"

#include <stdio.h>
#include <string.h>

#include "step_string.h"

enum { GLOBAL_ID = 0, NAME = 2, LONGEST_LIST = 160 };

static bool
is_storey(
	const struct ifc_file *file, const struct ifc_tree *tree, uint32_t node)
{
	return ifc_is_kind(file, tree->at[node].instance, IFC_BUILDINGSTOREY);
}

/* Append an attribute of the storey to `text`, emptied before. */
static enum tcs_status
text_read(const struct ifc_file *file, uint32_t instance, int position,
	struct step_text *text, struct tcs_fault *fault)
{
	struct step_value value = ifc_value(file, instance, position);
	unsigned trouble = 0;

	text->count = 0;
	if (value.kind != STEP_STRING)
		return step_decode(text, "", 0, &trouble, fault);
	return step_decode(text, value.text, value.length, &trouble, fault);
}

/* Set *found[i] for each name that is this one. */
static bool
note_names(const struct ifc_keep *keep, const struct step_text *text,
	bool found[IFC_MOST_STOREYS])
{
	bool any = false;

	for (size_t i = 0; i < keep->storey_count; i++) {
		const struct ifc_storey_name *name = keep->storeys + i;

		if (name->length != text->count ||
			memcmp(name->text, text->at, text->count))
			continue;
		found[i] = true;
		any = true;
	}
	return any;
}

static enum tcs_status
storey_missing(const struct ifc_file *file, const struct ifc_tree *tree,
	const struct ifc_storey_name *name, struct step_text *text,
	struct tcs_fault *fault)
{
	char list[LONGEST_LIST] = "";
	size_t length = 0;

	for (uint32_t i = 0; i < tree->count; i++) {
		enum tcs_status status;

		if (!is_storey(file, tree, i))
			continue;
		status = text_read(
			file, tree->at[i].instance, NAME, text, fault);
		if (status)
			return status;
		if (length + text->count + 8 > sizeof list) {
			snprintf(list + length, sizeof list - length, ", ...");
			break;
		}
		length += (size_t)snprintf(list + length, sizeof list - length,
			"%s%s", length ? ", " : "", text->at);
	}
	return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
		"no storey is called %.*s; there are: %s",
		(int)(name->length < 60 ? name->length : 60), name->text,
		*list ? list : "none");
}

static enum tcs_status
storeys_find(const struct ifc_file *file, const struct ifc_tree *tree,
	const struct ifc_keep *keep, bool *chosen, struct step_text *text,
	struct tcs_fault *fault)
{
	bool found[IFC_MOST_STOREYS] = {false};
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; i < tree->count && !status; i++) {
		uint32_t instance = tree->at[i].instance;

		chosen[i] = false;
		if (!is_storey(file, tree, i))
			continue;
		status = text_read(file, instance, NAME, text, fault);
		if (!status)
			chosen[i] = note_names(keep, text, found);
		if (!status)
			status = text_read(
				file, instance, GLOBAL_ID, text, fault);
		if (!status)
			chosen[i] |= note_names(keep, text, found);
	}
	for (size_t i = 0; i < keep->storey_count && !status; i++)
		if (!found[i])
			status = storey_missing(
				file, tree, keep->storeys + i, text, fault);
	return status;
}

enum tcs_status
ifc_storeys_choose(const struct ifc_file *file, const struct ifc_tree *tree,
	const struct ifc_keep *keep, bool *chosen, struct tcs_fault *fault)
{
	struct step_text text = {.count = 0};
	enum tcs_status status =
		storeys_find(file, tree, keep, chosen, &text, fault);

	array_release(&text);
	for (uint32_t i = 0; i < tree->count && !status; i++) {
		uint32_t storey =
			ifc_tree_above(file, tree, i, IFC_BUILDINGSTOREY);

		if (storey == STEP_NONE)
			chosen[i] = ifc_is_kind(file, tree->at[i].instance,
				IFC_SPATIALSTRUCTUREELEMENT);
		else if (storey != i)
			chosen[i] = chosen[storey];
	}
	return status;
}
