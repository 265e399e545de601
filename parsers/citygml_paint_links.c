/*
 * What appearances share: themes that show the materials and textures of
 * other themes, and targets that a texture covers as it covers another one.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_build.h"

/* Something of the object by an id, to be sorted. */
struct named {
	const char *id; /* in the object's text, which must not grow */
	size_t number;
};

TCS_ARRAY_TYPE(named_list, struct named);

static int
compare_named(const void *a, const void *b)
{
	const struct named *one = a, *two = b;
	int order = strcmp(one->id, two->id);

	if (order)
		return order;
	return one->number < two->number ? -1 : one->number > two->number;
}

static size_t
first_named(const struct named_list *list, const char *id)
{
	size_t low = 0, high = list->count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (strcmp(list->at[middle].id, id) < 0)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

/* ---- themes ------------------------------------------------------------------ */

/* Whether the object has it for anything. */
static enum tcs_status
share_paint(struct raw_object *raw, const struct named_list *aliases,
	size_t index, bool *used, struct tcs_fault *fault)
{
	struct raw_paint paint = raw->paints.at[index];
	const char *source = object_text(&raw->tree, paint.source);
	size_t first = first_named(aliases, source);

	for (size_t i = first; *source && i < aliases->count &&
		!strcmp(aliases->at[i].id, source);
		i++) {
		size_t alias = aliases->at[i].number;

		used[alias] = i - first < MOST_THEMES;
		if (!used[alias])
			break;
		if (array_grow(&raw->paints, 1))
			return fault_memory(fault);
		paint.theme = raw->aliases.at[alias].theme;
		raw->paints.at[raw->paints.count++] = paint;
	}
	return TCS_OK;
}

static enum tcs_status
report_unused(const struct raw_object *raw, const bool *used,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < raw->aliases.count; i++)
		if (!used[i])
			status = report_item(report, REPORT_SKIPPED,
				"appearance",
				"no material or texture of the feature has "
				"the id it links to, or 64 themes share it",
				object_text(
					&raw->tree, raw->aliases.at[i].source),
				TCS_NOWHERE, fault);
	return status;
}

static enum tcs_status
themes_share(struct raw_object *raw, struct tcs_fault *fault)
{
	size_t own = raw->paints.count;
	struct named_list aliases = {0};
	enum tcs_status status = TCS_OK;
	bool *used;

	if (!raw->aliases.count)
		return TCS_OK;
	used = calloc(raw->aliases.count, sizeof *used);
	if (!used || array_grow(&aliases, raw->aliases.count)) {
		free(used);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < raw->aliases.count; i++)
		aliases.at[aliases.count++] = (struct named){
			object_text(&raw->tree, raw->aliases.at[i].source), i};
	qsort(aliases.at, aliases.count, sizeof *aliases.at, compare_named);
	for (size_t i = 0; !status && i < own; i++)
		status = share_paint(raw, &aliases, i, used, fault);
	if (!status)
		status = report_unused(raw, used, &raw->report, fault);
	array_release(&aliases);
	free(used);
	return status;
}

/* ---- mappings ---------------------------------------------------------------- */

static bool
paint_links(const struct raw_paint *paint)
{
	return paint->link && paint->mapping == MAPPING_NONE;
}

static bool
has_links(const struct raw_object *raw)
{
	for (size_t i = 0; i < raw->paints.count; i++)
		if (paint_links(&raw->paints.at[i]))
			return true;
	return false;
}

/* From the object's own paints. */
static enum tcs_status
mappings_find_here(struct raw_object *raw, struct tcs_fault *fault)
{
	struct named_list list = {0};

	if (array_grow(&list, raw->paints.count))
		return fault_memory(fault);
	for (size_t i = 0; i < raw->paints.count; i++)
		if (raw->paints.at[i].mapping_id)
			list.at[list.count++] = (struct named){
				object_text(&raw->tree,
					raw->paints.at[i].mapping_id),
				i};
	if (list.count)
		qsort(list.at, list.count, sizeof *list.at, compare_named);
	for (size_t i = 0; i < raw->paints.count; i++) {
		struct raw_paint *paint = &raw->paints.at[i];
		const char *link = object_text(&raw->tree, paint->link);
		const struct raw_paint *from;
		size_t found;

		if (!paint_links(paint))
			continue;
		found = first_named(&list, link);
		if (found == list.count || strcmp(list.at[found].id, link) != 0)
			continue;
		from = &raw->paints.at[list.at[found].number];
		paint->mapping = from->mapping;
		paint->first_ring = from->first_ring;
		paint->ring_count = from->ring_count;
		paint->matrix = from->matrix;
	}
	array_release(&list);
	return TCS_OK;
}

static enum tcs_status
mapping_find_there(const struct build_plan *plan, struct raw_object *raw,
	size_t index, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	bool found = false;

	if (plan->store)
		status = store_fetch_mapping(
			plan->store, raw, index, &found, fault);
	if (status || found)
		return status;
	return report_item(&raw->report, REPORT_SKIPPED, "texture",
		"the coordinates it links to are not in the document",
		object_text(&raw->tree, raw->paints.at[index].link),
		TCS_NOWHERE, fault);
}

static enum tcs_status
mappings_link(const struct build_plan *plan, struct raw_object *raw,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	if (!has_links(raw))
		return TCS_OK;
	status = mappings_find_here(raw, fault);
	for (size_t i = 0; !status && i < raw->paints.count; i++) {
		if (paint_links(&raw->paints.at[i]))
			status = mapping_find_there(plan, raw, i, fault);
		if (!status && paint_links(&raw->paints.at[i]))
			raw->paints.at[i].image = TCS_NONE;
	}
	return status;
}

enum tcs_status
paints_fetch(const struct build_plan *plan, struct raw_object *raw,
	struct tcs_fault *fault)
{
	enum tcs_status status = themes_share(raw, fault);
	size_t targets = plan->store && plan->store->places.count
		? raw->targets.count
		: 0;

	for (size_t i = 0; !status && i < targets; i++)
		status = store_fetch(
			plan->store, raw, raw->targets.at[i].id, fault);
	return status ? status : mappings_link(plan, raw, fault);
}
