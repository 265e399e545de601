/*
 * Who is next to whom in a triangle mesh, and half-edge collapse: a half-edge
 * structure over OpenMesh's array kernel. It knows no positions.
 *
 * Vertices and faces keep their numbers for life; a collapse removes one
 * vertex and the faces at its edge. Half-edges are numbers, too, valid until
 * the next change.
 *
 * This is the border to C++: no exception passes it, and running out of memory
 * is TCS_NO_MEMORY. One thread at a time.
 *
 * source: S. Campagna, L. Kobbelt, H.-P. Seidel, Directed edges, 1998; the
 * link condition: T. Dey et al., Topology preserving edge contraction, 1999.
 */
#ifndef TESSERA_HALF_EDGES_H
#define TESSERA_HALF_EDGES_H

#ifdef __cplusplus
extern "C" {
#define HALF_EDGES_NOEXCEPT noexcept
#else
#include <stdbool.h>
#define HALF_EDGES_NOEXCEPT
#endif

#include <stddef.h>
#include <stdint.h>

#include "fault.h"

struct half_edges; /* opaque */

#define HALF_EDGE_NONE UINT32_MAX

/*
 * Build the structure of `face_count` triangles over `vertex_count` vertices:
 * corners[3 f + k] is a vertex, and opposites[3 f + k] tells which corner's
 * edge, counted in the same way, is the same edge the other way round;
 * HALF_EDGE_NONE for an open one. Edge k of a face goes from its corner k to
 * the next. The corners of one vertex must form one fan, open or closed, and
 * every vertex must have a corner. Takes n steps. Fails with TCS_NO_MEMORY;
 * TCS_LIMIT beyond 2²⁹ faces.
 */
enum tcs_status half_edges_new(struct half_edges **out, const uint32_t *corners,
	const uint32_t *opposites, size_t face_count, size_t vertex_count,
	struct tcs_fault *fault) HALF_EDGES_NOEXCEPT TCS_CHECKED;

void half_edges_free(struct half_edges *mesh) HALF_EDGES_NOEXCEPT;

/* One edge as seen from one of its ends. */
struct spoke {
	uint32_t half_edge; /* outwards */
	uint32_t to; /* vertex */
	uint32_t face; /* left of it; HALF_EDGE_NONE: open */
};

/*
 * The edges of a vertex counterclockwise: the face of each lies between it and
 * the next. An open fan ends with the spoke that has no face. Writes up to
 * `room` and returns how many there are: 0 for a vertex that is gone.
 */
size_t half_edges_spokes(const struct half_edges *mesh, uint32_t vertex,
	struct spoke *out, size_t room) HALF_EDGES_NOEXCEPT;

/*
 * Whether the collapse of a half-edge, its tail into its head, leaves a
 * manifold of the same kind: the link condition, which also keeps holes from
 * closing and components from falling to two faces back to back.
 */
bool half_edges_may_collapse(
	struct half_edges *mesh, uint32_t half_edge) HALF_EDGES_NOEXCEPT;

/* Collapse; only after half_edges_may_collapse. Writes the faces that went,
   one or two, and returns their number. */
size_t half_edges_collapse(struct half_edges *mesh, uint32_t half_edge,
	uint32_t gone[2]) HALF_EDGES_NOEXCEPT;

/* Take a face away, and its vertices: for all faces of an edge-connected set,
   one after the other. One that is gone stays so. */
void half_edges_take_away(
	struct half_edges *mesh, uint32_t face) HALF_EDGES_NOEXCEPT;

/* The three vertices of a face; false when it is gone. */
bool half_edges_corners(const struct half_edges *mesh, uint32_t face,
	uint32_t corners[3]) HALF_EDGES_NOEXCEPT;

/* The faces beyond the edges of one that is there, edge k from its corner k to
   the next; HALF_EDGE_NONE: open. */
void half_edges_across(const struct half_edges *mesh, uint32_t face,
	uint32_t faces[3]) HALF_EDGES_NOEXCEPT;

/*
 * Put other triangles in the place of some faces. The edges at which the faces
 * meet others, their rim, form loops that pass no vertex twice, and nothing is
 * open there. The triangles, of three vertices each that are on the rim, only of
 * the faces, or gone, have every edge of the rim once, the same way round, and
 * every other of their edges twice, once each way; no such edge is in the mesh
 * beside the faces. They take the numbers told, of the faces or of such as are
 * gone; the other faces, and vertices that no triangle has, are gone. Fails with
 * TCS_NO_MEMORY; the mesh is then as it was.
 */
enum tcs_status half_edges_refill(struct half_edges *mesh,
	const uint32_t *faces, size_t face_count, const uint32_t *numbers,
	const uint32_t *corners, size_t triangle_count,
	struct tcs_fault *fault) HALF_EDGES_NOEXCEPT TCS_CHECKED;

#ifdef __cplusplus
}
#endif

#endif
