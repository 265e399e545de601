/*
 * Facets joined to faces: those in one plane of one origin become polygons with
 * holes, and corners within straight edges go.
 */
#ifndef TESSERA_SOLID_OUTLINE_H
#define TESSERA_SOLID_OUTLINE_H

#include "solid_carve.h"
#include "solid_weld.h"

/* A facet of the result. */
struct solid_fragment {
	uint32_t facet, plane;
	uint32_t origin, face, label; /* as in struct solid_face */
	bool up; /* it looks where the plane's normal points to */
	bool named; /* origin, face and label are known */
};

TCS_ARRAY_TYPE(solid_fragments, struct solid_fragment);

/* An edge of the result, as one face sees it. */
struct solid_rim {
	uint32_t from, to; /* points */
	uint32_t planes[2]; /* whose line it lies on, the lower first */
	uint32_t next; /* another edge of the face from the same point, + 1 */
	uint32_t face, loop;
	bool used;
};

TCS_ARRAY_TYPE(solid_rims, struct solid_rim);

/* A point of the result, and what edges meet there. */
struct solid_joint {
	uint32_t neighbours[2];
	uint32_t planes[2]; /* of the line to the first neighbour */
	uint32_t count; /* of neighbours, up to 3 */
	uint32_t rim; /* the first from it of the face at hand, + 1 */
	uint32_t place; /* in the path, + 1; 0: not on it */
	bool straight; /* the two edges there lie on one line */
};

/* A closed run of edges. */
struct solid_loop {
	uint32_t first, count; /* in loop_points */
	double area; /* negative: a hole */
	uint32_t owner; /* of a hole: the loop around it */
};

/* What is known of a loop when those of all faces are looked at. */
struct solid_span {
	double area, length, longest;
	uint32_t rim; /* the longest */
	uint32_t face;
	uint32_t parent; /* the loop that it is joined to; itself: to none */
	uint32_t wish; /* one that it may be joined to, or UINT32_MAX */
	double off; /* how far it reaches from that one's plane */
};

/* All zero is empty. */
struct solid_outline {
	struct solid_weld weld;
	struct solid_fragments fragments;
	struct solid_numbers numbers; /* of each corner: its point, or
	                                 UINT32_MAX */
	struct solid_rims rims; /* face by face */
	struct solid_rims face_rims; /* before they cancel out */
	struct solid_rims sorted;
	TCS_ARRAY(struct solid_span) spans; /* of all faces */
	struct solid_numbers rim_ends; /* of each face */
	struct solid_numbers face_fragments; /* one of each face */
	TCS_ARRAY(struct solid_joint) joints; /* of each point */
	TCS_ARRAY(struct solid_loop) loops; /* of the face at hand */
	struct solid_numbers loop_points;
	struct solid_numbers path; /* rims walked that are in no loop yet */
	struct solid_point_list face_points;
	struct solid_numbers face_rings;
};

/*
 * Append the faces of outline->fragments, which are sorted, to `out`. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status solid_outline_write(struct solid_outline *outline,
	const struct solid_carver *carver, struct tcs_point origin,
	struct solid *out, struct tcs_fault *fault) TCS_CHECKED;

/* Append to outline->rims those of one face that none the other way round
 * cancels out. `rims` becomes sorted. Fails with TCS_NO_MEMORY. */
enum tcs_status solid_outline_cancel(struct solid_outline *outline,
	struct solid_rim *rims, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

void solid_outline_release(struct solid_outline *outline);

#endif
