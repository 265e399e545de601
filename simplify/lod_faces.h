/*
 * The faces that are left, as the polygons they come from have them.
 *
 * A vertex that was not moved has its original coordinates, bit for bit.
 */
#ifndef TESSERA_LOD_FACES_H
#define TESSERA_LOD_FACES_H

#include "collapses.h"
#include "lod_source.h"

struct lod_face {
	uint32_t polygon; /* of the object; that of the old triangle */
	uint32_t triangle; /* of the source: the old one */
	uint32_t face; /* of the mesh */
	uint32_t surface; /* feature */
	uint32_t nodes[3]; /* at the corners */
};

/* All zero is empty; reused from object to object. */
struct lod_faces {
	TCS_ARRAY(struct lod_face) faces; /* by polygon */
	TCS_ARRAY(uint32_t) first; /* per polygon, and one more */
	/* Per feature: the first triangle of the source that is its; TCS_NONE. */
	TCS_ARRAY(uint32_t) samples;
	TCS_ARRAY(struct tcs_point) places; /* per node: stream coordinates */
	TCS_ARRAY(bool) moved; /* per node */
};

/* Take them. Fails with TCS_NO_MEMORY. */
enum tcs_status lod_faces_take(struct lod_faces *faces,
	const struct tcs_object *from, const struct lod_source *source,
	const struct collapses *work, struct tcs_fault *fault) TCS_CHECKED;

void lod_faces_release(struct lod_faces *faces);

#endif
