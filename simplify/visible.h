/*
 * Which triangles of a mesh are seen from outside, and how much of each.
 *
 * The mesh is drawn, opaque from both sides, along parallel rays from many
 * directions, evenly spread; a pixel counts for the triangle that it shows.
 * Of a triangle that no pixel shows, being too small or too thin, a ray looks
 * out from the middle, along every direction in which nothing that was drawn
 * stands clearly before it. So what only shows through a gap narrower than a
 * pixel may be missed, but nothing that lies open is.
 *
 *     static const struct visible_views views = VISIBLE_ALL_ROUND;
 *
 *     if (visible_find(points, point_count, triangles, triangle_count,
 *                 &views, areas, &fault))
 *             …
 *     if (areas[i] > 0) …triangle i is seen…
 *
 * The result is the same for any number of jobs.
 *
 * source: the item buffer of H. Weghorst, G. Hooper and D. P. Greenberg,
 * Improved computational methods for ray tracing, 1984; directions on the
 * spherical Fibonacci lattice of R. Swinbank and R. J. Purser, 2006.
 */
#ifndef TESSERA_VISIBLE_H
#define TESSERA_VISIBLE_H

#include "tcs.h"

enum { VISIBLE_MOST_DIRECTIONS = 64 };

struct visible_views {
	unsigned directions; /* 1 to VISIBLE_MOST_DIRECTIONS */
	double lowest; /* sine of the lowest direction's height: -1 looks also
	                  from straight below, 0 from the horizon upwards */
	unsigned size; /* of a picture, pixels wide and high, at least 1 */
	unsigned jobs; /* threads; 0 is 1 */
	/* The group of each triangle, and how many there are; NULL: each is one.
	   Of a group that some pixel shows, no ray looks for the rest. */
	const uint32_t *groups;
	size_t group_count;
	/* 1 for each triangle of a closed surface that looks out of it, and so
	   hides its own inner side; -1 for one that looks in; 0 for any other.
	   NULL: none is closed. */
	const signed char *fronts;
};

/* From everywhere, below included. */
#define VISIBLE_ALL_ROUND \
	{ \
		.directions = 62, .lowest = -1, .size = 1024 \
	}

/* From the air and the street, where one looks up at what stands out. */
#define VISIBLE_FROM_STREETS \
	{ \
		.directions = 40, .lowest = -0.35, .size = 1024 \
	}

/* The way from which direction `number` looks, towards the mesh; unit. */
struct tcs_point visible_direction(
	const struct visible_views *views, unsigned number);

/*
 * areas[i] is the mean over all directions of the area that is seen of
 * triangle i, as projected, in square units; 0 for one that is not seen, and
 * for one without an area. Coordinates should be local, as for raster.h.
 * Takes n log n steps for n triangles, and directions · (n + size²). Fails
 * with TCS_NO_MEMORY, TCS_SYSTEM.
 */
enum tcs_status visible_find(const struct tcs_point *points, size_t point_count,
	const struct tcs_triangle *triangles, size_t triangle_count,
	const struct visible_views *views, double *areas,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
