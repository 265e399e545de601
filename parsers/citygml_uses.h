/*
 * The steps of links_resolve: which polygons each geometry uses, and at which
 * levels of detail they are wanted. Between its files only.
 */
#ifndef TESSERA_CITYGML_USES_H
#define TESSERA_CITYGML_USES_H

#include "citygml_links.h"
#include "labels.h"

/* A boundary surface or an opening. */
static inline bool
feature_is_thematic(const struct raw_object *raw, uint32_t feature)
{
	enum label_kind kind =
		label_of(raw->tree.features.at[feature].class)->kind;

	return kind == LABEL_SURFACE || kind == LABEL_OPENING;
}

static inline enum raw_shape
use_shape(const struct raw_use *use)
{
	return use->home->polygons.at[use->polygon].shape;
}

/*
 * Follow the links of every geometry that is no template, or of the one
 * template named: work->uses in their order, work->first_use of each geometry.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status uses_collect(struct link_work *work,
	const struct raw_object *raw, const struct raw_library *library,
	uint32_t template, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* Keys for the uses of the library's polygons. Fails with TCS_NO_MEMORY. */
enum tcs_status uses_assign_keys(struct link_work *work,
	const struct raw_object *raw, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The level of each geometry into work->lods; what is of a level that is not
 * wanted is marked so. work->heads has room for each feature.
 */
void levels_choose(struct link_work *work, const struct raw_object *raw,
	const struct lod_choice *choice);

#endif
