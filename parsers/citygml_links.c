#include "citygml_links.h"

#include <stdlib.h>
#include <string.h>

#include "labels.h"
#include "lod_select.h"

void
link_work_release(struct link_work *work)
{
	array_release(&work->uses);
	array_release(&work->first_use);
	array_release(&work->lods);
	array_release(&work->groups);
	array_release(&work->foreign);
	array_release(&work->heads);
	array_release(&work->emitted);
	array_release(&work->missing);
	array_release(&work->unwanted);
	index_release(&work->targets);
}

bool
link_is_foreign(const char *href)
{
	return strchr(href, '#') || strstr(href, "://") || strchr(href, '/');
}

/* ---- features ---- */

static enum label_kind
kind_of_feature(const struct raw_object *raw, uint32_t feature)
{
	return label_of(raw->tree.features.at[feature].class)->kind;
}

static bool
is_thematic(const struct raw_object *raw, uint32_t feature)
{
	enum label_kind kind = kind_of_feature(raw, feature);

	return kind == LABEL_SURFACE || kind == LABEL_OPENING;
}

/* ---- following the links --------------------------------------------------- */

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

	return is_thematic(raw, inside) && !is_thematic(raw, feature) ? inside
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

/* Of every geometry that is no template, or of the one template named. */
static enum tcs_status
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
static enum tcs_status
keys_assign(struct link_work *work, const struct raw_object *raw,
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

/* Room for one entry of each table per key, and per feature. */
static int
tables_prepare(struct link_work *work, const struct raw_object *raw)
{
	size_t features = raw->tree.features.count;
	size_t heads = work->keys > features ? work->keys : features;

	array_clear(&work->heads);
	if (array_grow(&work->heads, heads + 1) ||
		array_grow(&work->emitted, work->keys + 1u))
		return -1;
	memset(work->emitted.at, 0, work->keys * sizeof *work->emitted.at);
	return 0;
}

/* ---- levels of detail --------------------------------------------------------- */

static void
groups_find(struct link_work *work, const struct raw_object *raw)
{
	for (uint32_t i = 0; i < raw->tree.features.count; i++) {
		uint32_t parent = raw->tree.features.at[i].parent;

		work->groups.at[i] = parent != TCS_NONE && is_thematic(raw, i)
			? work->groups.at[parent]
			: i;
	}
}

static bool
is_relief(unsigned class)
{
	return class == TCS_CLASS_TINRelief ||
		class == TCS_CLASS_MassPointRelief ||
		class == TCS_CLASS_BreaklineRelief;
}

/* A relief says its level in an attribute; heads serve as a table of them. */
static void
relief_lods_find(struct link_work *work, const struct raw_object *raw)
{
	const struct tcs_object *tree = &raw->tree;

	for (size_t i = 0; i < tree->features.count; i++)
		work->heads.at[i] = TCS_LOD_NONE;
	for (size_t i = 0; i < tree->attributes.count; i++) {
		const struct tcs_attribute *attribute = &tree->attributes.at[i];

		if (attribute->feature != TCS_NONE && attribute->number >= 0 &&
			attribute->number <= 4 &&
			!strcmp(object_text(tree, attribute->name), "lod"))
			work->heads.at[attribute->feature] =
				(uint32_t)attribute->number;
	}
}

static void
lods_find(struct link_work *work, const struct raw_object *raw)
{
	bool has_relief = false;

	for (size_t i = 0; i < raw->tree.features.count; i++)
		has_relief |= is_relief(raw->tree.features.at[i].class);
	if (has_relief)
		relief_lods_find(work, raw);
	for (size_t i = 0; i < raw->geometries.count; i++) {
		const struct raw_geometry *geometry = &raw->geometries.at[i];
		unsigned class = raw->tree.features.at[geometry->feature].class;

		work->lods.at[i] = geometry->lod;
		if (geometry->lod == TCS_LOD_NONE && is_relief(class))
			work->lods.at[i] =
				(uint8_t)work->heads.at[geometry->feature];
	}
}

static enum raw_shape
shape_of(const struct raw_use *use)
{
	return use->home->polygons.at[use->polygon].shape;
}

/* Lines and points count only where a feature has no areas at all. */
static int
rank_of(const struct link_work *work, uint32_t geometry)
{
	uint32_t first = work->first_use.at[geometry];
	uint32_t end = work->first_use.at[geometry + 1];
	int lod = work->lods.at[geometry];

	if (lod == TCS_LOD_NONE || first == end)
		return -1;
	for (uint32_t i = first; i < end; i++)
		if (shape_of(&work->uses.at[i]) == RAW_AREA)
			return lod + 8;
	return lod;
}

static void
mark_unwanted(struct link_work *work, uint32_t geometry)
{
	for (uint32_t i = work->first_use.at[geometry];
		i < work->first_use.at[geometry + 1]; i++) {
		struct raw_use *use = &work->uses.at[i];

		use->state = USE_UNWANTED;
		work->left_out += !use->linked && shape_of(use) == RAW_AREA;
	}
}

/* Per group, the highest rank plus one goes into heads. */
static void
ranks_find(struct link_work *work, const struct raw_object *raw)
{
	for (size_t i = 0; i < raw->tree.features.count; i++)
		work->heads.at[i] = 0;
	for (uint32_t i = 0; i < raw->geometries.count; i++) {
		uint32_t group = work->groups.at[raw->geometries.at[i].feature];
		uint32_t rank = (uint32_t)(rank_of(work, i) + 1);

		if (rank > work->heads.at[group])
			work->heads.at[group] = rank;
	}
	for (size_t i = 0; i < raw->instances.count; i++) {
		const struct raw_instance *instance = &raw->instances.at[i];
		uint32_t group = work->groups.at[instance->feature];
		uint32_t rank = instance->lod + 8u + 1;

		if (instance->lod != TCS_LOD_NONE &&
			rank > work->heads.at[group])
			work->heads.at[group] = rank;
	}
}

/* A host ranks no lower than its portions; children stand behind parents. */
static void
ranks_raise(struct link_work *work, const struct raw_object *raw)
{
	for (size_t i = raw->tree.features.count; i-- > 0;) {
		const struct tcs_feature *feature = &raw->tree.features.at[i];
		uint32_t group;

		if (feature->parent == TCS_NONE ||
			!class_is_portion(feature->class))
			continue;
		group = work->groups.at[feature->parent];
		if (work->heads.at[group] < work->heads.at[i])
			work->heads.at[group] = work->heads.at[i];
	}
}

static bool
lod_is_wanted(const struct link_work *work, const struct lod_choice *choice,
	uint32_t feature, uint8_t lod)
{
	uint32_t highest = (work->heads.at[work->groups.at[feature]] - 1) & 7;

	if (lod == TCS_LOD_NONE)
		return true;
	return choice->highest ? lod == highest : choice->lods[lod];
}

static void
lods_choose(struct link_work *work, const struct raw_object *raw,
	const struct lod_choice *choice)
{
	ranks_find(work, raw);
	ranks_raise(work, raw);
	for (uint32_t i = 0; i < raw->geometries.count; i++)
		if (!lod_is_wanted(work, choice, raw->geometries.at[i].feature,
			    work->lods.at[i]))
			mark_unwanted(work, i);
	for (size_t i = 0; i < raw->instances.count; i++)
		work->unwanted.at[i] = !lod_is_wanted(work, choice,
			raw->instances.at[i].feature, raw->instances.at[i].lod);
}

/* ---- giving every polygon to one geometry ---------------------------------------- */

enum claim { CLAIM_SOLID, CLAIM_THEMATIC, CLAIM_HOST };

static bool
is_solid(const struct link_work *work, const struct raw_object *raw,
	uint32_t geometry)
{
	uint8_t kind = raw->geometries.at[geometry].kind;
	uint32_t first = work->first_use.at[geometry];

	if (kind == RAW_KIND_UNKNOWN)
		return first < work->first_use.at[geometry + 1] &&
			work->uses.at[first].shell != TCS_NONE;
	return kind == TCS_SOLID || kind == TCS_MULTI_SOLID ||
		kind == TCS_COMPOSITE_SOLID;
}

static enum claim
claim_of(const struct link_work *work, const struct raw_object *raw,
	uint32_t geometry)
{
	if (is_solid(work, raw, geometry))
		return CLAIM_SOLID;
	if (is_thematic(raw, raw->geometries.at[geometry].feature))
		return CLAIM_THEMATIC;
	return CLAIM_HOST;
}

static bool
is_below(const struct raw_object *raw, uint32_t feature, uint32_t ancestor)
{
	while (feature != TCS_NONE && feature != ancestor)
		feature = raw->tree.features.at[feature].parent;
	return feature == ancestor;
}

/* The polygons' lists of uses at one level of detail; areas only. */
static void
lists_build(struct link_work *work, uint8_t lod)
{
	memset(work->heads.at, 0xff, work->keys * sizeof *work->heads.at);
	for (size_t i = work->uses.count; i-- > 0;) {
		struct raw_use *use = &work->uses.at[i];

		if (use->state == USE_UNWANTED ||
			work->lods.at[use->geometry] != lod)
			continue;
		use->next = work->heads.at[use->key];
		work->heads.at[use->key] = (uint32_t)i;
	}
}

static void
use_keep(struct link_work *work, const struct raw_object *raw,
	struct raw_use *use)
{
	use->state = USE_KEPT;
	use->shared = use->home != raw || work->emitted.at[use->key];
	work->emitted.at[use->key] = true;
}

#define MAX_CANDIDATES 1000 /* uses of one polygon that are looked at */

/* A boundary surface of the solid's feature comes before any other. */
static void
solid_take(struct link_work *work, const struct raw_object *raw,
	struct raw_use *use)
{
	uint32_t host = raw->geometries.at[use->geometry].feature;
	uint32_t best = TCS_NONE;
	int left = MAX_CANDIDATES;

	for (uint32_t i = work->heads.at[use->key]; i != TCS_NONE && left-- > 0;
		i = work->uses.at[i].next) {
		uint32_t feature =
			raw->geometries.at[work->uses.at[i].geometry].feature;

		if (claim_of(work, raw, work->uses.at[i].geometry) !=
			CLAIM_THEMATIC)
			continue;
		if (best == TCS_NONE)
			best = i;
		if (is_below(raw, feature, host)) {
			best = i;
			break;
		}
	}
	if (best != TCS_NONE) {
		use->surface = raw->geometries.at[work->uses.at[best].geometry]
				       .feature;
		work->uses.at[best].state = USE_ABSORBED;
	}
	use_keep(work, raw, use);
}

/* The use of this polygon that is kept at this level, if any. */
static const struct raw_use *
use_kept(const struct link_work *work, const struct raw_use *use)
{
	int left = MAX_CANDIDATES;

	for (uint32_t i = work->heads.at[use->key]; i != TCS_NONE && left-- > 0;
		i = work->uses.at[i].next)
		if (work->uses.at[i].state == USE_KEPT)
			return &work->uses.at[i];
	return NULL;
}

/*
 * A second surface with the same polygon is the same surface named twice,
 * unless it looks the other way: then it is the neighbour's side.
 */
static void
surface_take(struct link_work *work, const struct raw_object *raw,
	struct raw_use *use)
{
	const struct raw_use *kept = use_kept(work, use);

	if (kept && kept->reversed == use->reversed)
		use->state = USE_ABSORBED;
	else
		use_keep(work, raw, use);
}

static void
uses_claim(struct link_work *work, const struct raw_object *raw, uint8_t lod,
	enum claim claim)
{
	for (size_t i = 0; i < work->uses.count; i++) {
		struct raw_use *use = &work->uses.at[i];

		if (use->state != USE_OPEN ||
			work->lods.at[use->geometry] != lod ||
			claim_of(work, raw, use->geometry) != claim)
			continue;
		if (shape_of(use) != RAW_AREA)
			use_keep(work, raw, use);
		else if (claim == CLAIM_SOLID)
			solid_take(work, raw, use);
		else
			surface_take(work, raw, use);
	}
}

static bool
lod_is_used(
	const struct link_work *work, const struct raw_object *raw, uint8_t lod)
{
	for (size_t i = 0; i < raw->geometries.count; i++)
		if (work->lods.at[i] == lod)
			return true;
	return false;
}

/* ---- all of it -------------------------------------------------------------------- */

static int
work_prepare(struct link_work *work, const struct raw_object *raw)
{
	size_t features = raw->tree.features.count;

	array_clear(&work->uses);
	array_clear(&work->first_use);
	array_clear(&work->lods);
	array_clear(&work->groups);
	array_clear(&work->foreign);
	array_clear(&work->heads);
	array_clear(&work->emitted);
	array_clear(&work->missing);
	array_clear(&work->unwanted);
	work->left_out = 0;
	if (array_grow(&work->first_use, raw->geometries.count + 1) ||
		array_grow(&work->lods, raw->geometries.count) ||
		array_grow(&work->groups, features) ||
		array_grow(&work->unwanted, raw->instances.count))
		return -1;
	return 0;
}

enum tcs_status
links_resolve(struct link_work *work, const struct raw_object *raw,
	const struct raw_library *library, const struct lod_choice *choice,
	struct report *report, struct tcs_fault *fault)
{
	static const uint8_t levels[] = {0, 1, 2, 3, 4, TCS_LOD_NONE};
	enum tcs_status status = TCS_OK;

	if (work_prepare(work, raw))
		return fault_memory(fault);
	array_clear(&work->targets.slots);
	if (raw->has_links || raw->paints.count)
		status = index_build(&work->targets, raw, fault);
	if (!status)
		status = uses_collect(
			work, raw, library, TCS_NONE, report, fault);
	if (!status)
		status = keys_assign(work, raw, fault);
	if (status)
		return status;
	if (tables_prepare(work, raw))
		return fault_memory(fault);
	groups_find(work, raw);
	lods_find(work, raw);
	lods_choose(work, raw, choice);
	for (size_t i = 0; i < sizeof levels; i++) {
		if (!lod_is_used(work, raw, levels[i]))
			continue;
		lists_build(work, levels[i]);
		uses_claim(work, raw, levels[i], CLAIM_SOLID);
		uses_claim(work, raw, levels[i], CLAIM_THEMATIC);
		uses_claim(work, raw, levels[i], CLAIM_HOST);
	}
	return TCS_OK;
}

enum tcs_status
links_resolve_template(struct link_work *work, const struct raw_object *raw,
	const struct raw_library *library, uint32_t geometry,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (work_prepare(work, raw))
		return fault_memory(fault);
	array_clear(&work->targets.slots);
	if (raw->has_links || raw->paints.count)
		status = index_build(&work->targets, raw, fault);
	if (!status)
		status = uses_collect(
			work, raw, library, geometry, report, fault);
	for (size_t i = 0; !status && i < work->uses.count; i++)
		work->uses.at[i].state = USE_KEPT;
	if (!status)
		work->lods.at[geometry] = TCS_LOD_NONE;
	return status;
}
