/*
 * That what was made one stays covered by what took its place.
 *
 * A prism was put around parts, or a hole was closed over its pane (merges.h,
 * handles.h), and their own faces are gone. Where one of them comes out of what
 * is there instead it is lost, with all of its contacts, and so it has their
 * price.
 */
#ifndef TESSERA_COVER_WATCH_H
#define TESSERA_COVER_WATCH_H

#include "contacts.h"

/* Metres that what is in another may stand out of it, at most. */
#define STANDS_OUT 0.01

struct collapses;
struct refill;

/* A component in a prism. */
struct covered {
	uint32_t component;
	uint32_t first_point, point_count; /* of `points`: its own, each once */
	bool bare; /* it has come out */
};

/* A face of a cover as it will be. */
struct cover_face {
	struct triangle_shape shape;
	struct tcs_point normal; /* twice the area long */
};

/* A solid and what is in it. */
struct cover {
	uint32_t first_face, face_count; /* of `faces` */
	uint32_t first, count; /* of `covered` */
};

/* All zero is empty, as for a mesh in which nothing is covered. */
struct cover_watch {
	const struct contact_list
		*list; /* borrowed; NULL: nothing is covered */
	double reach; /* metres: what stands out less does not */
	TCS_ARRAY(struct cover) at;
	TCS_ARRAY(uint32_t) faces;
	TCS_ARRAY(struct covered) covered;
	TCS_ARRAY(uint32_t) points; /* of the set */
	TCS_ARRAY(uint32_t) numbers; /* per face: its cover; TCS_NONE */
	TCS_ARRAY(uint32_t) first; /* per component, and one more: */
	TCS_ARRAY(uint32_t) contacts; /* its run of contacts */
	TCS_ARRAY(bool) lost; /* per contact: it was paid for */
	TCS_ARRAY(struct cover_face) shapes; /* scratch: one cover */
	TCS_ARRAY(uint32_t) coming; /* scratch: which of `covered` come out */
	TCS_ARRAY(uint32_t) losing; /* scratch: contacts, or components */
};

/* Forget everything; the room is kept. */
void cover_watch_clear(struct cover_watch *watch);

/*
 * Begin a cover: what these faces have covered so far will be in it. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status cover_watch_open(struct collapses *work,
	const struct contact_list *contacts, const uint32_t *faces,
	size_t count, struct tcs_fault *fault) TCS_CHECKED;

/* A component that is in the cover that was begun. Fails with TCS_NO_MEMORY. */
enum tcs_status cover_watch_put(struct collapses *work, uint32_t component,
	struct tcs_fault *fault) TCS_CHECKED;

/* These faces are the cover that was begun, those that are left of them. What is
   open covers nothing. Fails with TCS_NO_MEMORY. */
enum tcs_status cover_watch_close(struct collapses *work, const uint32_t *faces,
	size_t count, struct tcs_fault *fault) TCS_CHECKED;

/* What comes out if the node moves, work->ring has the faces that stay: in
   contacts, by their worth. Fails with TCS_NO_MEMORY. */
enum tcs_status cover_watch_look(struct collapses *work, uint32_t node,
	double *worth, struct tcs_fault *fault) TCS_CHECKED;

/* Whether a contact is among those, or was lost so before: it has been paid
   for. */
bool cover_watch_loses(const struct cover_watch *watch, uint32_t contact);

/* What all that these faces cover is worth: its contacts no point of which is
   left to watch. Fails with TCS_NO_MEMORY. */
enum tcs_status cover_watch_worth(struct collapses *work, const uint32_t *faces,
	size_t count, double *worth, struct tcs_fault *fault) TCS_CHECKED;

/* What was looked at is done. */
void cover_watch_follow(struct collapses *work);

void cover_watch_release(struct cover_watch *watch);

#endif
