/*
 * Pictures of one object for people: before, after, and where it differs.
 */
#ifndef TESSERA_COMPARE_PICTURE_H
#define TESSERA_COMPARE_PICTURE_H

#include "compare_views.h"
#include "png_write.h"

enum {
	PICTURE_BEFORE,
	PICTURE_AFTER,
	PICTURE_ERROR,
	PICTURE_COUNT,
	PICTURE_SIZE = 320, /* pixels, width and height */
};

/* PNG files; all zero is empty. */
struct object_pictures {
	struct png_bytes png[PICTURE_COUNT];
};

/*
 * Draw from above. Surfaces have the colours of their classes; in the third
 * picture, those of `before` go from grey over yellow to red, which is `far`
 * metres or more from `after`, and what only `after` shows is blue. `before`
 * has triangles; `objects` are those that the sides were loaded from. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status object_pictures_draw(const struct compare_side *before,
	const struct compare_side *after, const struct tcs_object *objects[2],
	double far, struct object_pictures *out,
	struct tcs_fault *fault) TCS_CHECKED;

void object_pictures_release(struct object_pictures *pictures);

#endif
