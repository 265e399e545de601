/* Following links: which polygons each geometry uses. */
#include <string.h>

#include "citygml_uses.h"

bool
link_is_foreign(const char *href)
{
	return strchr(href, '#') || strstr(href, "://") || strchr(href, '/');
}

struct use_context {
	struct link_work *work;
	const struct raw_object *raw;
	const struct raw_library *library;
	uint32_t geometry;
	struct report *report;
};

/* Until a boundary surface claims it: where it stands, if that is one. */
static uint32_t
surface_of(const struct raw_object *raw, uint32_t polygon, uint32_t feature)
{
	uint32_t inside =
		raw->geometries.at[raw->polygons.at[polygon].geometry].feature;

	return feature_is_thematic(raw, inside) &&
			!feature_is_thematic(raw, feature)
		? inside
		: feature;
}

static enum tcs_status
use_add(const struct use_context *to, const struct raw_object *home,
	uint32_t polygon, bool reversed, uint32_t shell, bool linked,
	struct tcs_fault *fault)
{
	uint32_t feature = to->raw->geometries.at[to->geometry].feature;

	if (array_grow(&to->work->uses, 1))
		return fault_memory(fault);
	if (home == to->raw)
		feature = surface_of(to->raw, polygon, feature);
	else if (array_grow(&to->work->foreign, 1))
		return fault_memory(fault);
	else
		to->work->foreign.at[to->work->foreign.count++] =
			(uint32_t)to->work->uses.count;
	to->work->uses.at[to->work->uses.count++] = (struct raw_use){
		.home = home,
		.polygon = polygon,
		.key = polygon,
		.geometry = to->geometry,
		.shell = shell,
		.surface = feature,
		.next = TCS_NONE,
		.reversed = reversed,
		.linked = linked,
	};
	return TCS_OK;
}

/* A link that leaves the object: to the library, or nowhere. */
static enum tcs_status
use_outside(const struct use_context *to, const struct raw_member *member,
	bool reversed, uint32_t shell, struct tcs_fault *fault)
{
	const char *id = object_text(&to->raw->tree, member->href);
	const struct raw_object *store =
		to->library ? to->library->store : NULL;
	const struct raw_target *target =
		store ? index_find(&to->library->index, store, id) : NULL;
	enum tcs_status status = TCS_OK;

	if (link_is_foreign(id))
		return report_item(to->report, REPORT_SKIPPED, "link",
			"to another document, not followed", id, TCS_NOWHERE,
			fault);
	if (!target) {
		if (array_grow(&to->work->missing, 1))
			return fault_memory(fault);
		to->work->missing.at[to->work->missing.count++] = member->href;
		return TCS_OK;
	}
	for (uint32_t i = target->first_member;
		!status && i < target->member_end; i++)
		status = use_add(to, store, store->members.at[i].polygon,
			reversed != store->members.at[i].reversed, shell, true,
			fault);
	return status;
}

static enum tcs_status
use_member(void *context, const struct raw_member *member, bool reversed,
	uint32_t shell, bool linked, struct tcs_fault *fault)
{
	const struct use_context *to = context;

	if (member->polygon == TCS_NONE)
		return use_outside(to, member, reversed, shell, fault);
	return use_add(
		to, to->raw, member->polygon, reversed, shell, linked, fault);
}

/* The uses of one geometry, appended. */
static enum tcs_status
uses_of_geometry(
	struct member_walk *walk, uint32_t index, struct tcs_fault *fault)
{
	struct use_context *to = walk->context;
	const struct raw_geometry *geometry = &walk->raw->geometries.at[index];

	to->geometry = index;
	return members_walk(walk, geometry->first_member,
		geometry->first_member + geometry->member_count, false,
		TCS_NONE, false, fault);
}

enum tcs_status
uses_collect(struct link_work *work, const struct raw_object *raw,
	const struct raw_library *library, uint32_t template,
	struct report *report, struct tcs_fault *fault)
{
	struct use_context context = {work, raw, library, 0, report};
	struct member_walk walk = {
		.raw = raw,
		.index = raw->has_links ? &work->targets : NULL,
		.context = &context,
		.take = use_member,
		.budget = 1024 + 64 * (uint64_t)raw->members.count,
	};
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < raw->geometries.count; i++) {
		work->first_use.at[i] = (uint32_t)work->uses.count;
		if (template == TCS_NONE ? !raw->geometries.at[i].is_template
					 : i == template)
			status = uses_of_geometry(&walk, i, fault);
	}
	work->first_use.at[raw->geometries.count] = (uint32_t)work->uses.count;
	if (!status && walk.exceeded)
		status = report_item(report, REPORT_SKIPPED, "link",
			"in a circle, or multiplying beyond reason",
			object_text(&raw->tree, raw->tree.features.at[0].id),
			TCS_NOWHERE, fault);
	return status;
}

/*
 * Keys of the library's polygons follow those of the object's own, in the order
 * of first use; an open hash table finds them again.
 */
enum tcs_status
uses_assign_keys(struct link_work *work, const struct raw_object *raw,
	struct tcs_fault *fault)
{
	size_t room = 16;

	work->keys = (uint32_t)raw->polygons.count;
	if (!work->foreign.count)
		return TCS_OK;
	while (room < work->foreign.count * 2)
		room *= 2;
	array_clear(&work->heads);
	if (array_grow(&work->heads, room))
		return fault_memory(fault);
	memset(work->heads.at, 0xff, room * sizeof *work->heads.at);
	for (size_t i = 0; i < work->foreign.count; i++) {
		struct raw_use *use = &work->uses.at[work->foreign.at[i]];
		size_t slot = (use->polygon * 2654435761u) & (room - 1);

		while (work->heads.at[slot] != TCS_NONE &&
			work->uses.at[work->heads.at[slot]].polygon !=
				use->polygon)
			slot = (slot + 1) & (room - 1);
		if (work->heads.at[slot] == TCS_NONE) {
			work->heads.at[slot] = work->foreign.at[i];
			use->key = work->keys++;
		} else {
			use->key = work->uses.at[work->heads.at[slot]].key;
		}
	}
	return TCS_OK;
}
