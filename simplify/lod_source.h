/*
 * The triangles of an object that are simplified: those of one level of
 * detail, each polygon once, as a component set that knows where every
 * triangle came from.
 */
#ifndef TESSERA_LOD_SOURCE_H
#define TESSERA_LOD_SOURCE_H

#include "byte_index.h"
#include "component_set.h"
#include "frame.h"
#include "lod_select.h"

/* All zero is empty; reused from object to object. */
struct lod_source {
	struct selection selection;
	struct frame frame; /* at the object's first vertex */
	struct component_set set; /* in that frame: metres */
	TCS_ARRAY(uint32_t) polygons; /* per triangle of the set */
	TCS_ARRAY(uint32_t) triangles; /* the same: that of the object */
	TCS_ARRAY(uint32_t)
	homes; /* per polygon: the one whose triangles it
	                              has, mostly itself; TCS_NONE: none */
	bool shared; /* some polygon is another one again */
	struct byte_index ids; /* scratch */
	TCS_ARRAY(uint32_t) named; /* scratch: per id its first polygon */
};

/*
 * Take an object at a level (see lod_select.h) and build the set. Fails with
 * TCS_NO_MEMORY, TCS_LIMIT.
 */
enum tcs_status lod_source_load(struct lod_source *source,
	const struct tcs_object *object, int lod, const struct tcs_crs *crs,
	struct tcs_fault *fault) TCS_CHECKED;

/* The vertices of the object that a triangle of the set has. */
static inline const uint32_t *
lod_source_vertices(const struct lod_source *source,
	const struct tcs_object *object, uint32_t triangle)
{
	return object->triangles.at[source->triangles.at[triangle]].corner;
}

void lod_source_release(struct lod_source *source);

#endif
