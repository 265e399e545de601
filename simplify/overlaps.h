/*
 * Faces of different components that simplification laid into one plane.
 *
 * A pane before its wall flickers once both lie in the same plane, and is gone
 * once it lies behind. Two faces that look the same way, cover each other and
 * are at most a millimetre apart, or changed their order and are less than a
 * centimetre apart, are parted again: the one of the smaller component moves
 * along the normal until they are as far apart as they were, or two
 * millimetres. What lay in one plane from the beginning stays as it is.
 * Faces that cross each other at an angle are no concern of this: no offset
 * parts them.
 *
 * source: L, post-processing of overlapping triangles (Liu, Li, Zhao, Liu,
 * Texture feature preserving simplification).
 */
#ifndef TESSERA_OVERLAPS_H
#define TESSERA_OVERLAPS_H

#include "collapses.h"
#include "face_boxes.h"

/* A face that is left. */
struct overlap_face {
	uint32_t face;
	float normal[3]; /* of length 1 */
};

/* Faces are kept apart by the way they look: bins along each axis, an odd
   number so that those that are level or upright lie in the middle of one. */
enum {
	OVERLAP_BINS = 5,
	OVERLAP_WAYS = OVERLAP_BINS * OVERLAP_BINS * OVERLAP_BINS
};

/* All zero is empty; reused from object to object. */
struct overlaps {
	size_t parted; /* pairs of faces */
	TCS_ARRAY(struct overlap_face) faces;
	TCS_ARRAY(bool) changed; /* per face */
	struct face_boxes boxes; /* of places in `faces` */
	uint32_t runs[OVERLAP_WAYS]; /* of `boxes`; TCS_NONE */
	struct face_list near; /* scratch */
	TCS_ARRAY(struct tcs_point) shifts; /* per node */
	struct triangle_tree
		tree; /* over the original, where it is asked for */
	TCS_ARRAY(uint32_t) roots; /* per component: in the tree; TCS_NONE */
};

/*
 * Find and part them: positions of work change. Takes n log n steps for n faces
 * that are left, and a few for every pair whose boxes meet. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status overlaps_part(struct overlaps *overlaps, struct collapses *work,
	struct tcs_fault *fault) TCS_CHECKED;

void overlaps_release(struct overlaps *overlaps);

#endif
