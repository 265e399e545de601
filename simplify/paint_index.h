/* The paints of an object by polygon. */
#ifndef TESSERA_PAINT_INDEX_H
#define TESSERA_PAINT_INDEX_H

#include "tcs.h"

/* All zero is empty; reused from object to object. */
struct paint_index {
	TCS_ARRAY(uint32_t) paints; /* polygon by polygon, else in order */
	TCS_ARRAY(uint32_t) first; /* per polygon, and one more */
};

/* Fails with TCS_NO_MEMORY. */
enum tcs_status paint_index_build(struct paint_index *index,
	const struct tcs_object *object, struct tcs_fault *fault) TCS_CHECKED;

/* Coordinate of a vertex of the polygon that a textured paint is of. */
static inline struct tcs_texcoord
paint_coordinate(const struct tcs_object *object, const struct tcs_paint *paint,
	uint32_t vertex)
{
	return object->texcoords.at[paint->first_texcoord + vertex -
		object->polygons.at[paint->polygon].first_vertex];
}

void paint_index_release(struct paint_index *index);

#endif
