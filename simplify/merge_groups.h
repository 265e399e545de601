/*
 * Which parts may become one: those of one surface that touch, directly or
 * through others, nested. Each group joins two smaller ones, or two parts, that
 * leave the least room empty in a box around both.
 *
 * Only closed parts, all faces of which are of one surface, are in a group.
 */
#ifndef TESSERA_MERGE_GROUPS_H
#define TESSERA_MERGE_GROUPS_H

#include "collapses.h"
#include "parts.h"

/* More parts that touch are no group. */
enum { MERGE_MOST_PARTS = 1024 };

struct merge_group {
	uint32_t first, count; /* of `parts` */
	double empty; /* cubic metres, of a box around them, that none fills */
};

/* All zero is empty; reused from object to object. */
struct merge_groups {
	TCS_ARRAY(struct merge_group) at; /* the smaller ones first */
	TCS_ARRAY(uint32_t) parts; /* those of a group in turn */
	/* Per part: the first of all that it touches; TCS_NONE: it is in no
	   group. */
	TCS_ARRAY(uint32_t) families;
};

/*
 * Find them in a mesh nothing of which is collapsed. Takes n log n steps, and
 * as many for every set of parts that touch as it has links times parts. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status merge_groups_find(struct merge_groups *groups,
	const struct collapses *work, const struct parts *parts,
	struct tcs_fault *fault) TCS_CHECKED;

void merge_groups_release(struct merge_groups *groups);

#endif
