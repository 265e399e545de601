/*
 * Charts: faces over whose edges the paint goes on. What ends at an edge, a
 * material, a texture, or the place in a texture, makes it a seam, and so a
 * feature that collapses keep.
 *
 * Texture coordinates of a corner that moved are those that its chart has where
 * it moved to, so that the chart's picture stays whole.
 *
 * source: L, features (Liu, Li, Zhao, Liu, Texture feature preserving
 * simplification); H. Hoppe, New quadric metric for simplifying meshes with
 * appearance attributes, 1999: wedges.
 */
#ifndef TESSERA_PAINT_CHARTS_H
#define TESSERA_PAINT_CHARTS_H

#include "lod_source.h"
#include "paint_index.h"
#include "sheets.h"

/* All zero is empty; reused from object to object. */
struct paint_charts {
	struct paint_index index;
	/* Per triangle of the source; none where nothing is painted. */
	TCS_ARRAY(uint32_t) numbers;
	/* Where there are textures, the corners of every node: 3 t + k for
	   corner k of triangle t of the source. */
	TCS_ARRAY(uint32_t) corners;
	TCS_ARRAY(uint32_t) first; /* per node, and one more */
};

/* Find the charts of an object that was split into sheets. Takes n log n
   steps. Fails with TCS_NO_MEMORY. */
enum tcs_status paint_charts_find(struct paint_charts *charts,
	const struct tcs_object *object, const struct lod_source *source,
	const struct sheets *sheets, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The coordinate that the chart of a triangle has at a node for a paint, the
 * `number`-th of the triangle's polygon: where it has several, that nearest to
 * a guess; where it has none, the guess.
 */
struct tcs_texcoord paint_charts_at(const struct paint_charts *charts,
	const struct tcs_object *object, const struct lod_source *source,
	uint32_t triangle, uint32_t node, uint32_t number,
	struct tcs_texcoord guess);

void paint_charts_release(struct paint_charts *charts);

#endif
