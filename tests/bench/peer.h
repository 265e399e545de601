/*
 * Simplifiers of others, and two plain ones of our own, that tcs-simplify is
 * measured beside. They take one building at a time: its components, which
 * share no vertex, and one number of triangles for all of them together.
 */
#ifndef TESSERA_PEER_H
#define TESSERA_PEER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
/* As in tcs.h, which is no C++: it names a field `class`. */
struct tcs_point {
	double x, y, z;
};
struct tcs_triangle {
	uint32_t corner[3];
};
#else
#include "tcs.h"
#endif

/* A mesh in local metres. As input borrowed; as output it has room for as many
   triangles as the input, and three points for each. */
struct peer_mesh {
	struct tcs_point *points;
	size_t point_count;
	struct tcs_triangle *triangles;
	size_t triangle_count;
	uint32_t *components; /* from 0: per point of the input, and per
	                         triangle of the output */
};

/*
 * Simplify to about `target` triangles, or to as few as the method reaches.
 * Returns 0, or -1 without memory.
 */
typedef int peer_run(
	const struct peer_mesh *in, size_t target, struct peer_mesh *out);

/* Quadric error metric, half-edge collapse: Garland & Heckbert 1997, with
   their check against turned normals, and nothing else. */
peer_run peer_qem;
/* One vertex, the mean, for each cell of a grid: Rossignac & Borrel 1993. */
peer_run peer_clustering;
/* meshopt_simplify without a limit on the error. */
peer_run peer_meshoptimizer;
/* OpenMesh's Decimater with its quadric module, open rims locked. */
peer_run peer_openmesh;
/* CGAL's edge collapse with its default policies: Lindstrom & Turk 1998. */
peer_run peer_cgal;

/* Append a triangle of the input's points, and the component that has them. */
static inline void
peer_put(const struct peer_mesh *in, const struct tcs_triangle *triangle,
	struct peer_mesh *out)
{
	out->components[out->triangle_count] =
		in->components[triangle->corner[0]];
	out->triangles[out->triangle_count++] = *triangle;
}

#ifdef __cplusplus
}

/* Which corners of a triangle to split off until a half-edge mesh takes it:
   none, one, two, all. */
const unsigned peer_splits[] = {0, 1, 2, 4, 3, 5, 6, 7};
#endif

#endif
