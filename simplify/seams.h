/*
 * Where components touch, as the simplifier watches it: points along the seam
 * of every contact, each held by a face of either side, and the planes that
 * tell which way a vertex may move without leaving the other component.
 *
 * A point is held by the face of either side that is nearest to it, while from
 * where one of them is nearest the other is not farther than a limit: there the
 * contact does not gape, wherever the two have moved together.
 *
 * source: W, boundary vertices, collapse reference planes (Wang et al. 2021,
 * ISPRS IJGI 10, 422).
 */
#ifndef TESSERA_SEAMS_H
#define TESSERA_SEAMS_H

#include "touches.h"

/* How far the faces that hold a point may come apart where they touched:
   metres, and a multiple of what counts as touching where that is more. */
#define SEAM_LIMIT 0.018
#define SEAM_REACHES 1.8

struct seam_point {
	struct tcs_point at; /* as the points of the set */
	float limit; /* metres */
	uint32_t contact;
};

/* One side of a point; of point i those of sides a and b are 2 i, 2 i + 1. */
struct seam_hold {
	uint32_t face; /* TCS_NONE when open */
	uint32_t next; /* hold of the same face; TCS_NONE */
	float off; /* metres; the face is not farther from the point */
};

struct seam_count {
	uint32_t points, open;
};

/* Of the points of a seam less than one in so many may come open; that leaves
   what lies between them a margin to the quarter that counts as half open. */
#define SEAM_KEPT_TO_OPEN 6

/* What a contact is broken by that is half open. */
#define SEAM_HALF_OPEN 0.4

/* How far a contact is broken when so many points of it are open: not, in part
   when it is half open, or wholly. */
static inline double
seam_broken(const struct seam_count *count, uint32_t open)
{
	if (open >= count->points)
		return 1;
	return SEAM_KEPT_TO_OPEN * open >= count->points ? SEAM_HALF_OPEN : 0;
}

/* A boundary vertex and the face of another component that it meets. */
struct seam_plane {
	uint32_t next; /* plane of the same node; TCS_NONE */
	uint32_t component, face; /* the other */
};

/* All zero is empty; reused from object to object. */
struct seams {
	TCS_ARRAY(struct seam_point) points; /* by contact */
	TCS_ARRAY(struct seam_hold) holds;
	TCS_ARRAY(uint32_t) faces; /* per face: its first hold; TCS_NONE */
	TCS_ARRAY(struct seam_count) counts; /* per contact */
	TCS_ARRAY(struct seam_plane) planes;
	TCS_ARRAY(uint32_t) nodes; /* per node: its first plane; TCS_NONE */
	struct face_boxes boxes; /* by component; see crossing_watch.h */
};

/*
 * Find the contacts, as contacts_find does, and their seams. On set->jobs
 * threads, with the same result for any number of them. Takes n log n steps
 * for n triangles, and a few for every pair of components whose boxes meet and
 * for every vertex or edge and the faces near it. Fails with TCS_NO_MEMORY,
 * TCS_LIMIT.
 */
enum tcs_status seams_find(struct seams *seams, const struct component_set *set,
	const struct sheets *sheets, double reach,
	struct contact_list *contacts, struct tcs_fault *fault) TCS_CHECKED;

/* Let a face hold what it, another, or none has held, `off` metres from it. */
void seams_move_hold(
	struct seams *seams, uint32_t hold, uint32_t face, double off);

/* A point comes open: neither side holds it any more. */
void seams_open(struct seams *seams, uint32_t point);

/* A point is not asked after any more: it stands in what both sides are now. */
void seams_forget(struct seams *seams, uint32_t point);

void seams_release(struct seams *seams);

#endif
