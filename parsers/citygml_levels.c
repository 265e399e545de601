/* Levels of detail: that of each geometry, and which of them are wanted. */
#include <string.h>

#include "citygml_uses.h"
#include "lod_select.h"

static void
groups_find(struct link_work *work, const struct raw_object *raw)
{
	for (uint32_t i = 0; i < raw->tree.features.count; i++) {
		uint32_t parent = raw->tree.features.at[i].parent;

		work->groups.at[i] =
			parent != TCS_NONE && feature_is_thematic(raw, i)
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
		if (use_shape(&work->uses.at[i]) == RAW_AREA)
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
		work->left_out += !use->linked && use_shape(use) == RAW_AREA;
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

void
levels_choose(struct link_work *work, const struct raw_object *raw,
	const struct lod_choice *choice)
{
	groups_find(work, raw);
	lods_find(work, raw);
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
