/*
 * The comparison of one object with another, at one level of detail each.
 */
#ifndef TESSERA_COMPARE_OBJECT_H
#define TESSERA_COMPARE_OBJECT_H

#include "compare_contacts.h"
#include "compare_crossings.h"
#include "compare_picture.h"

struct compare_settings {
	struct tcs_crs crs[2];
	int lods[2]; /* see lod_select.h */
	double eps; /* metres; 0: contact_reach */
	unsigned pixels; /* width and height of a picture; 0: none */
	bool pictures; /* draw the objects that differ */
	unsigned jobs; /* threads to use for one large object; 0 is 1 */
};

/* Scratch memory of one thread; all zero is empty. */
struct comparer {
	struct compare_side before, after;
	struct compare_match match;
	struct crossings crossings[2]; /* before, after */
	struct compare_pictures pictures;
};

/* What was found; all zero is empty, reused. */
struct compare_result {
	struct compare_metrics metrics;
	struct broken_list broken;
	TCS_ARRAY(uint32_t) features; /* two per broken contact: of before */
	TCS_ARRAY(uint32_t) lost; /* surfaces of before that vanished */
	struct object_pictures pictures; /* empty without difference */
};

/* An object and the prototypes of its instances; see side_load. */
struct compared_object {
	const struct tcs_object *object; /* NULL: is not there */
	const struct tcs_object *const *placed;
};

/*
 * Compare. One of both is there. Fails with TCS_NO_MEMORY, TCS_LIMIT,
 * TCS_SYSTEM.
 */
enum tcs_status compare_objects(struct comparer *comparer,
	const struct compare_settings *settings,
	const struct compared_object pair[2], struct compare_result *result,
	struct tcs_fault *fault) TCS_CHECKED;

void comparer_release(struct comparer *comparer);
void compare_result_release(struct compare_result *result);

#endif
