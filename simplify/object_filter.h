/*
 * Taking polygons out of an object, and with them what is nothing without:
 * geometries, and features that had geometry, themselves or in what is below
 * them, and have none left.
 */
#ifndef TESSERA_OBJECT_FILTER_H
#define TESSERA_OBJECT_FILTER_H

#include "tcs.h"

/*
 * Keep the polygons for which keep[i] is set. A solid that loses some of its
 * polygons, not all, leaves them as a multi-surface; one that loses none stays
 * a solid. Relations to features that go, go with them. The object's arrays
 * are changed where they are and keep the rules of object_check. Fails with
 * TCS_NO_MEMORY; then the object is good for nothing but its release.
 */
enum tcs_status object_keep_polygons(struct tcs_object *object,
	const bool *keep, struct tcs_fault *fault) TCS_CHECKED;

#endif
