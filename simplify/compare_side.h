/*
 * One of the two sides of a comparison: an object's triangles at the chosen
 * level of detail, in metres, as components, and by feature.
 */
#ifndef TESSERA_COMPARE_SIDE_H
#define TESSERA_COMPARE_SIDE_H

#include "byte_index.h"
#include "component_set.h"
#include "contacts.h"
#include "frame.h"
#include "lod_select.h"

#define NO_TREE UINT32_MAX

/* All zero is an empty side, reused from object to object. */
struct compare_side {
	struct component_set set;
	struct contact_list contacts;
	struct triangle_tree surfaces; /* one tree of all, one per feature */
	uint32_t whole; /* the root of all; NO_TREE without triangles */
	TCS_ARRAY(uint32_t) roots; /* per feature, NO_TREE for none */
	TCS_ARRAY(uint32_t)
	twins; /* per feature: that of the other side with
	                              the same id, TCS_NONE for none */
	struct byte_index ids;
	TCS_ARRAY(uint32_t) named; /* per string of ids: the feature */
	struct selection selection; /* scratch */
	struct byte_index drawn; /* scratch: polygons taken */
};

/*
 * Take the triangles of an object at a level (see lod_select.h), each polygon
 * once, and those of the prototypes it places: placed[i] is that of instance i;
 * NULL instead of the array leaves them out. They belong to the features that
 * place them. NULL for an object gives an empty side. Fails with TCS_NO_MEMORY,
 * TCS_LIMIT.
 */
enum tcs_status side_load(struct compare_side *side,
	const struct tcs_object *object, const struct tcs_object *const *placed,
	int lod, const struct frame *frame,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Fill the twins of both: features with the same id, or without one at the
 * same place in the tree. Fails with TCS_NO_MEMORY.
 */
enum tcs_status side_match_features(struct compare_side *before,
	const struct tcs_object *object, struct compare_side *after,
	const struct tcs_object *other, struct tcs_fault *fault) TCS_CHECKED;

void side_release(struct compare_side *side);

#endif
