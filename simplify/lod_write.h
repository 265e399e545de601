/*
 * Putting what a simplifier left into an object: geometries are copied as they
 * are, or written anew from the faces that are left of them.
 *
 * A face becomes a polygon of one triangle without rings. It keeps the paints
 * of the polygon it comes from; texture coordinates are those of its chart at
 * the new corners, or those of its old triangle's plane where the chart does not
 * reach or a corner is where none was. What has become part of another surface
 * is painted as the first triangle of that one. Where the polygon has an id,
 * the new one's derives from it.
 */
#ifndef TESSERA_LOD_WRITE_H
#define TESSERA_LOD_WRITE_H

#include "lod_faces.h"
#include "paint_charts.h"

/* A geometry of `from`, and the feature that has it at a level. */
struct home_use {
	uint32_t home, geometry;
};

/* All zero is empty; reused from object to object. */
struct lod_writer {
	const struct tcs_object *from; /* borrowed */
	struct tcs_object to; /* features, attributes, relations, instances
	                         and text are lent by `from` */
	const struct paint_charts *charts; /* borrowed: of `from` */
	struct lod_faces faces; /* taken before a level is written */
	const uint32_t *homes; /* as lod_write_level got them */
	TCS_ARRAY(uint32_t)
	solids; /* per feature: its geometry written as a
	                               solid; TCS_NONE */
	TCS_ARRAY(struct home_use) uses; /* scratch */
	TCS_ARRAY(char) id; /* scratch */
};

/* Begin: `to` is `from` without geometries. */
void lod_write_begin(struct lod_writer *writer, const struct tcs_object *from,
	const struct paint_charts *charts);

/* Append a geometry of `from` as it is. Fails with TCS_NO_MEMORY. */
enum tcs_status lod_write_copy(struct lod_writer *writer, uint32_t geometry,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append a level: of the geometries that are simplified, what the faces taken
 * last leave, gathered with the features that have it now, homes[i] for what
 * feature i had: the first solid of each as a solid, the rest as surfaces, each
 * polygon once. LOD_IN_PLACE keeps the level that each geometry had. Fails
 * with TCS_NO_MEMORY, TCS_LIMIT.
 */
#define LOD_IN_PLACE (-1)
enum tcs_status lod_write_level(struct lod_writer *writer,
	const struct lod_source *source, const uint32_t *homes, int lod,
	struct tcs_fault *fault) TCS_CHECKED;

void lod_write_release(struct lod_writer *writer);

#endif
