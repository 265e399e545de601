/*
 * What of an object is seen from outside, level by level; the rest goes.
 *
 * Spaces (rooms, storeys) are not drawn: one sees through them; their own
 * shapes go. Everything else hides what is behind it, panes of glass included.
 */
#ifndef TESSERA_EXTERIOR_H
#define TESSERA_EXTERIOR_H

#include "byte_index.h"
#include "report.h"
#include "tcs.h"
#include "visible.h"

struct exterior_settings {
	bool faces; /* single polygons go, else parts only: a solid, or all
	               that a feature has as a surface */
	double least; /* share of its area that must be seen, 0 to 1, as a
	                 mean over all directions; 1 is that of a box by itself */
	double pixel; /* metres; of the pictures, as far as memory allows */
	unsigned jobs; /* threads for one large object */
	struct tcs_crs crs;
};

/* Scratch, reused from object to object. All zero is empty. */
struct exterior {
	TCS_ARRAY(struct tcs_point) points; /* of the object, in metres */
	TCS_ARRAY(struct tcs_triangle) triangles; /* of one level */
	TCS_ARRAY(uint32_t) polygons; /* of each of these */
	TCS_ARRAY(double) areas; /* the same: seen */
	TCS_ARRAY(double) seen, whole; /* of each polygon of the object */
	TCS_ARRAY(uint32_t) homes; /* of each: itself, or the one it shares */
	TCS_ARRAY(bool) keep;
	struct byte_index ids;
	TCS_ARRAY(uint32_t) named; /* polygons with these ids */
};

/*
 * Take out of the object what is not seen. Instances are left as they are, and
 * hide nothing: expand them before (instances.h). Counts of what went are added
 * to the report. Fails with TCS_NO_MEMORY, TCS_SYSTEM; then the object is good
 * for nothing but its release.
 */
enum tcs_status exterior_keep(struct exterior *exterior,
	const struct exterior_settings *settings, struct tcs_object *object,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

void exterior_release(struct exterior *exterior);

#endif
