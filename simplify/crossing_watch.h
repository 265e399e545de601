/*
 * That no collapse lets triangles of a component go through each other that
 * did not, and what it costs when they go through another component.
 *
 * The faces around a node that moves are compared, as they will be, with all
 * that are near them: those of their own component, and of others. A component
 * that they cross then, and that the faces around the node did not cross
 * before, counts; see crossing.h for how. So what crossed from the beginning
 * may go on doing so where it did. A collapse within the planes of its faces
 * leaves the same surface and needs no look.
 *
 * The boxes by which near faces are found are those of the seams: they grow
 * with their faces, and go with them. A half-edge collapse puts no face
 * outside of its component's box, so those boxes stay as they were.
 */
#ifndef TESSERA_CROSSING_WATCH_H
#define TESSERA_CROSSING_WATCH_H

#include "face_boxes.h"

struct collapses;
struct refill;

/* All zero is empty; reused from object to object. */
struct crossing_watch {
	TCS_ARRAY(uint32_t) places; /* per face: in its run of the boxes */
	TCS_ARRAY(uint32_t) components; /* scratch: near the ring */
	struct face_list near; /* scratch: faces of one of them */
};

/* Watch a mesh that has not changed yet. Takes n steps. Fails with
   TCS_NO_MEMORY. */
enum tcs_status crossing_watch_begin(struct crossing_watch *watch,
	const struct collapses *work, struct tcs_fault *fault) TCS_CHECKED;

/* Whether the node may go where the target is: work->ring has the faces that
   stay. What they come to cross of other components is added to work->broken
   if contacts may break, and must not be if not. Fails with TCS_NO_MEMORY. */
enum tcs_status crossing_watch_allows(struct collapses *work, uint32_t node,
	uint32_t target, bool *fine, struct tcs_fault *fault) TCS_CHECKED;

/* Whether triangles may take the place of faces, which are in ascending order:
   they must not cross their own component where those did not. What they come
   to cross beside it is added up in work->broken. Fails with TCS_NO_MEMORY. */
enum tcs_status crossing_watch_admits(struct collapses *work,
	const struct refill *refill, bool *fine,
	struct tcs_fault *fault) TCS_CHECKED;

/* A face gets a corner there; nothing to a watch that is released, here and
   below. */
void crossing_watch_follow(
	struct collapses *work, uint32_t face, struct tcs_point place);

/* A face of a component gets corners that the box holds. */
void crossing_watch_grow(struct collapses *work, uint32_t component,
	uint32_t face, const struct float_box *by);

/* A face is gone. One that comes back is followed from nothing. */
void crossing_watch_drop(struct collapses *work, uint32_t face);

void crossing_watch_release(struct crossing_watch *watch);

#endif
