/*
 * Which components of one side became which of the other: by feature first,
 * by the nearest surface then.
 */
#ifndef TESSERA_COMPARE_MATCH_H
#define TESSERA_COMPARE_MATCH_H

#include "compare_side.h"

/*
 * A component after comes from the one before that lies nearest to most of its
 * triangles' centres, among the triangles of the same feature where there are
 * any. One before that nothing comes from still has an image if the surfaces
 * of its own features after cover all its corners within eps: it was merged.
 * All zero is empty; reused from object to object.
 */
struct compare_match {
	TCS_ARRAY(uint32_t) parents; /* per component after; TCS_NONE */
	TCS_ARRAY(uint32_t) first; /* per component before, and one more: */
	TCS_ARRAY(uint32_t) images; /* its run of components after */
	TCS_ARRAY(bool) merged; /* per component before */
};

/* Fails with TCS_NO_MEMORY. */
enum tcs_status match_components(struct compare_match *match,
	const struct compare_side *before, const struct compare_side *after,
	double eps, struct tcs_fault *fault) TCS_CHECKED;

/* The components after that a component before became; *count may be 0. */
const uint32_t *match_images(
	const struct compare_match *match, uint32_t component, size_t *count);

void match_release(struct compare_match *match);

#endif
