/*
 * Triangles that lie in one plane, joined to polygons with holes.
 *
 * Two triangles are neighbours where an edge is used by exactly these two, once
 * each way. Neighbours grow into regions, from the largest triangle down, that
 * lie within COPLANAR_TOLERANCE of one plane and face one side; triangles too
 * thin to have a side go along. The boundary of a region becomes rings that
 * visit no point twice: where it touches itself it is cut into rings that meet
 * there.
 *
 * No vertex of a boundary is ever left out, also where it runs straight on:
 * every edge of a ring is an edge of a triangle, so that what was closed is
 * closed, and no vertex of a neighbour comes to lie on an edge.
 *
 * n log n steps for n triangles, whatever they are.
 */
#ifndef TESSERA_COPLANAR_H
#define TESSERA_COPLANAR_H

#include "array.h"
#include "fault.h"
#include "tcs.h"

/* How far the corners of a polygon may be off its plane, in metres. */
#define COPLANAR_TOLERANCE 0.001

/* A ring; faces have one counterclockwise and then their holes clockwise, as
 * seen from the side that the triangles face. */
struct coplanar_ring {
	uint32_t first, count; /* of `corners` */
	double area; /* squared metres, doubled; negative: a hole */
};

struct coplanar_face {
	uint32_t first_ring, ring_count; /* the outer one first */
	uint32_t first_triangle; /* the lowest of those it was made of */
};

/* A region while it grows; coordinates are metres. */
struct coplanar_plane {
	struct tcs_point normal; /* sum of doubled area vectors */
	struct tcs_point centre; /* sum of corners, each by its area */
	double weight;
};

/* An edge of a triangle, to find its neighbour; `half` is 3 · triangle + the
 * number of the corner it begins at. */
struct coplanar_edge {
	uint32_t least, most;
	uint32_t half;
};

struct coplanar_corner {
	struct tcs_point at;
	uint64_t coat;
	uint32_t half; /* the half-edge that begins there */
};

struct coplanar_size {
	double area; /* squared */
	uint32_t triangle;
};

/* What comes of triangles, and scratch. All zero is empty; reused. */
struct coplanar {
	TCS_ARRAY(struct coplanar_face) faces; /* by their first triangle */
	TCS_ARRAY(struct coplanar_ring) rings;
	TCS_ARRAY(uint32_t) corners; /* vertices as the triangles name them */

	/* per half-edge */
	TCS_ARRAY(uint32_t) points; /* same position and coat: same number */
	TCS_ARRAY(uint32_t) places; /* same position: same number */
	TCS_ARRAY(uint32_t) twins; /* the neighbour's half of the edge */
	TCS_ARRAY(bool) traced;
	/* per place */
	TCS_ARRAY(struct tcs_point) positions; /* metres, near 0 */
	TCS_ARRAY(uint32_t) visits; /* where on the path */
	/* per triangle */
	TCS_ARRAY(struct tcs_point) normals; /* doubled area vectors */
	TCS_ARRAY(uint32_t) regions;
	TCS_ARRAY(uint8_t) levels; /* of strictness it has come to */

	TCS_ARRAY(struct coplanar_corner) sorted;
	TCS_ARRAY(struct coplanar_edge) edges;
	TCS_ARRAY(struct coplanar_size) sizes; /* the largest first */
	TCS_ARRAY(uint32_t) members; /* triangles of the region that grows */
	TCS_ARRAY(uint32_t) path; /* half-edges of a ring in the making */
};

/* Forget faces, rings and corners. */
void coplanar_clear(struct coplanar *coplanar);
void coplanar_release(struct coplanar *coplanar);

/*
 * Join triangles and append their faces, rings and corners to those there are.
 * `coats`, where not NULL, has a number per vertex: vertices of one position
 * whose numbers differ are different, and no face reaches across an edge that
 * ends in them (a seam in a texture). `metres` is the length of a unit along
 * each axis. Triangles without three different positions vanish; nothing else
 * does. Fails with TCS_NO_MEMORY.
 */
enum tcs_status coplanar_join(struct coplanar *coplanar,
	const struct tcs_point *vertices, const uint64_t *coats,
	struct tcs_point metres, const struct tcs_triangle *triangles,
	size_t count, struct tcs_fault *fault) TCS_CHECKED;

/* ---- between coplanar.c and coplanar_rings.c ------------------------------ */

/*
 * Append the face of a region if its border is that of a flat polygon: one
 * outer ring, and no vertex further off its plane (Newell's normal, through
 * the centre of its vertices) than the tolerance. Sets *flat to whether it is.
 */
enum tcs_status coplanar_trace(struct coplanar *coplanar,
	const struct tcs_triangle *triangles, const uint32_t *members,
	size_t count, bool *flat, struct tcs_fault *fault) TCS_CHECKED;

/* Append a face for each of these triangles. */
enum tcs_status coplanar_keep(struct coplanar *coplanar,
	const struct tcs_triangle *triangles, const uint32_t *members,
	size_t count, struct tcs_fault *fault) TCS_CHECKED;

static inline uint32_t
coplanar_next_half(uint32_t half)
{
	return half % 3 == 2 ? half - 2 : half + 1;
}

static inline struct tcs_point
coplanar_between(struct tcs_point from, struct tcs_point to)
{
	return (struct tcs_point){to.x - from.x, to.y - from.y, to.z - from.z};
}

static inline struct tcs_point
coplanar_cross(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
		a.x * b.y - a.y * b.x};
}

static inline double
coplanar_dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

#endif
