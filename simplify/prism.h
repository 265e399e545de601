/*
 * The simplest solid around some points: a convex outline of few sides, drawn
 * out along an axis from the first of the points to the last. A box is one, and
 * so is the ramp under the steps of a stair.
 */
#ifndef TESSERA_PRISM_H
#define TESSERA_PRISM_H

#include "planar.h"
#include "triangle_shape.h"

enum {
	PRISM_SIDES = 6,
	PRISM_CORNERS = 2 * PRISM_SIDES,
	PRISM_TRIANGLES = 4 * PRISM_SIDES - 4
};

struct prism {
	/* Those of the lower outline, counterclockwise as seen from where the
	   axis leads, and above each, `sides` further, that of the upper one. */
	struct tcs_point corners[PRISM_CORNERS];
	struct prism_plane {
		struct tcs_point normal; /* outwards, of length 1 */
		double height; /* of the plane along it */
	} planes[PRISM_SIDES + 2]; /* of the sides, the lower and the upper */
	struct tcs_point axis; /* of length 1 */
	unsigned sides; /* 3 to PRISM_SIDES */
	double volume; /* cubic metres */
};

/* How many corners and triangles a prism of so many sides has. */
#define PRISM_CORNERS_OF(sides) (2 * (sides))
#define PRISM_TRIANGLES_OF(sides) (4 * (sides)-4)

/* Scratch; all zero is empty. */
struct prism_outline {
	struct planar_points points, hull;
};

/*
 * The prism along an axis of length 1 that holds all points: its outline is
 * their convex hull, as long as that has few sides, or else what the fewest
 * sides add least to; at most `sides`, which is 4 or more. *fine is false where
 * the points lie in a plane or a line, or their hull has hundreds of sides. Takes n log n steps. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status prism_around(struct prism *prism, struct prism_outline *outline,
	const struct tcs_point *points, size_t count, struct tcs_point axis,
	unsigned sides, bool *fine, struct tcs_fault *fault) TCS_CHECKED;

/* The corners of a triangle, counterclockwise from outside: those of the two
   outlines come first, `sides - 2` each, then two for every side. */
void prism_triangle(
	const struct prism *prism, unsigned triangle, unsigned corners[3]);

struct triangle_shape prism_shape(const struct prism *prism, unsigned triangle);

/* How far a point stands out of the prism, at least; inside, how far it is from
   the surface, negative. Metres. */
double prism_height(const struct prism *prism, struct tcs_point from);

void prism_outline_release(struct prism_outline *outline);

#endif
