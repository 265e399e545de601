/*
 * Where two components touch: whether they do, the places along the seam, each
 * with the face of either side, and the boundary vertices with the faces they
 * meet.
 *
 * Every vertex is asked once which faces of the other component are within
 * reach of it, and every edge which ones it pierces, unless both of its ends
 * touch anyhow. Where neither tells, edges may still be near edges.
 *
 * source: W, boundary vertices, embedded edges, buffer, collapse reference
 * planes (Wang et al. 2021, ISPRS IJGI 10, 422).
 */
#ifndef TESSERA_TOUCHES_H
#define TESSERA_TOUCHES_H

#include "contacts.h"
#include "face_boxes.h"

enum {
	TOUCH_PLACES = 24, /* kept of a contact, at most */
};

/* A place along a seam. */
struct touch {
	struct tcs_point at; /* as the points of the set */
	double gap; /* metres, as far as it is from the side not asked */
	uint32_t faces[2]; /* of components a and b: the nearest */
	float offs[2]; /* metres; neither is farther from the place */
};

/* A boundary vertex and a face of another component that it meets. */
struct touch_plane {
	uint32_t node, component, face; /* the latter two of the other */
};

/* A face with all that is asked of it in one place. */
struct touch_face {
	struct triangle_shape shape;
	uint32_t nodes[3];
	/* Of each corner, TOUCH_VERTEX: its node is asked here; TOUCH_EDGE: its
	   edge is; each once, k bits up for corner k. */
	uint32_t asks;
};

enum { TOUCH_VERTEX = 1, TOUCH_EDGE = 8 };

/* What is looked at; all borrowed. */
struct touch_scene {
	const struct component_set *set;
	const struct sheets *sheets;
	const struct touch_face *faces; /* as those of the sheets */
	const struct face_boxes *boxes;
	double reach; /* metres */
};

/* Fill in the faces; there is room. Fails with TCS_NO_MEMORY. */
enum tcs_status touch_faces_fill(struct touch_face *faces,
	const struct component_set *set, const struct sheets *sheets,
	struct tcs_fault *fault) TCS_CHECKED;

/* All zero is empty. */
struct touches {
	struct contact_list contacts;
	TCS_ARRAY(uint32_t) ends; /* per contact: behind its last place */
	TCS_ARRAY(struct touch) places; /* by contact */
	TCS_ARRAY(struct touch_plane) planes;
	struct face_list near, there; /* scratch */
	struct face_extract extracts[2]; /* scratch: of a and b, those near the
	                                    other */
	TCS_ARRAY(uint32_t) met; /* scratch: a bit per node that touches */
};

/*
 * Append what two components have in common if they are in contact, as
 * contacts.h says: a < b. Fails with TCS_NO_MEMORY.
 */
enum tcs_status touches_add(struct touches *touches,
	const struct touch_scene *scene, uint32_t a, uint32_t b,
	struct tcs_fault *fault) TCS_CHECKED;

void touches_clear(struct touches *touches);
void touches_release(struct touches *touches);

#endif
