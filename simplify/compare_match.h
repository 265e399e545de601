/*
 * Which components of one side became which of the other: by feature first,
 * by the nearest surface then.
 */
#ifndef TESSERA_COMPARE_MATCH_H
#define TESSERA_COMPARE_MATCH_H

#include "compare_side.h"

/*
 * Triangles of one component after that come from one component before: all of
 * the component, or a region of it where several were merged into one.
 */
struct match_piece {
	uint32_t parent; /* component before; TCS_NONE: there are none */
	uint32_t component; /* after */
	uint32_t root; /* of its triangles, in the tree of the set after */
	double area; /* square metres */
	bool region; /* not all of its component */
};

/*
 * A triangle after comes from a component before: that which alone has the
 * triangle's feature; else, of those that are nearest to a corner or to the
 * centre, among the triangles of the same feature where there are any, the one
 * that these four points are nearest to in sum, half an eps added where what is
 * nearest to the centre faces away.
 *
 * Where no triangle comes from a component so, it is asked for the triangles
 * within eps of its box: they come from it if it is less in that sum.
 *
 * A component after comes from what most of its triangles come from. Those of
 * them that come from another one are a region of that, if one of them has a
 * feature that it alone had, or if no component comes from it and they have a
 * tenth of its area. One before that nothing comes from was swallowed if the
 * surfaces of its own features after pass within eps of the corners and centres
 * of all its triangles, or the closed component of them that is nearest to the
 * first corner encloses those that they do not: its images are the
 * pieces of the component that its first corner went to.
 *
 * All zero is empty; reused from object to object.
 */
struct compare_match {
	TCS_ARRAY(struct match_piece) pieces; /* by component after */
	TCS_ARRAY(uint32_t) numbers; /* per triangle after: its piece */
	TCS_ARRAY(uint32_t) first; /* per component before, and one more: */
	TCS_ARRAY(uint32_t) images; /* its run of pieces */
	TCS_ARRAY(bool) swallowed; /* per component before */
};

/* Trees of regions are added to that of the set after. Fails with
   TCS_NO_MEMORY, TCS_SYSTEM. */
enum tcs_status match_components(struct compare_match *match,
	const struct compare_side *before, struct compare_side *after,
	double eps, struct tcs_fault *fault) TCS_CHECKED;

/* Pieces that a component before became. */
struct images {
	const uint32_t *at;
	size_t count; /* may be 0 */
};

struct images match_images(
	const struct compare_match *match, uint32_t component);

void match_release(struct compare_match *match);

#endif
