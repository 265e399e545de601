/*
 * The ways that the faces of something look, opposite ones taken as one, with
 * the area of each: the axes that it was drawn along.
 */
#ifndef TESSERA_FACE_DIRECTIONS_H
#define TESSERA_FACE_DIRECTIONS_H

#include "vector.h"

enum { MOST_DIRECTIONS = 16 };

struct face_direction {
	struct tcs_point way; /* of length 1 */
	double area;
};

/* All zero is empty. */
struct face_directions {
	struct face_direction at[MOST_DIRECTIONS];
	unsigned count;
};

/* A face with a normal of length 1, or 0: that counts for nothing. Ways beyond
   the first MOST_DIRECTIONS do not either. */
void face_directions_add(struct face_directions *directions,
	struct tcs_point normal, double area);

/* The largest first. */
void face_directions_sort(struct face_directions *directions);

#endif
