#include "citygml_links.h"

#include <string.h>

#include "citygml_uses.h"

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
	if (feature_is_thematic(raw, raw->geometries.at[geometry].feature))
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
		if (use_shape(use) != RAW_AREA)
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
		status = uses_assign_keys(work, raw, fault);
	if (status)
		return status;
	if (tables_prepare(work, raw))
		return fault_memory(fault);
	levels_choose(work, raw, choice);
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
