/*
 * Growable arrays.
 *
 * TCS_ARRAY(type) declares the array of one type as an anonymous struct:
 *
 *     TCS_ARRAY(double) heights;
 *     if (array_grow(&heights, 1))
 *             return fault_memory(fault);
 *     heights.at[heights.count++] = 2.5;
 *
 * All zero is the empty array. An array with `at` set and `room` zero is
 * *lent*: it points into storage of somebody else, is never freed through the
 * array, and is copied on the first growth.
 */
#ifndef TESSERA_ARRAY_H
#define TESSERA_ARRAY_H

#include <stddef.h>

#include "fault.h"

#define TCS_ARRAY(type) \
	struct { \
		type *at; \
		size_t count; /* elements in use */ \
		size_t room; /* elements allocated; 0: lent */ \
	}

/* The same as a named struct, for arrays that functions pass on. */
#define TCS_ARRAY_TYPE(name, type) \
	struct name { \
		type *at; \
		size_t count; \
		size_t room; \
	}

/* The untyped view that every TCS_ARRAY shares. */
struct tcs_array {
	void *at;
	size_t count;
	size_t room;
};

/*
 * Make room for `more` elements behind the `count` there are. The room at
 * least doubles when it grows. Returns 0, or -1 when memory is out or the
 * size overflows, with the array as it was. `more` is evaluated more than once.
 */
#define array_grow(array, more) \
	((more) <= (array)->room && (array)->count <= (array)->room - (more) \
			? 0 \
			: array_grow_bytes( \
				  (array), sizeof *(array)->at, (more)))

/* Free what the array owns and make it the empty array. */
#define array_release(array) array_release_bytes((array))

/* Forget the elements, keep the room. A lent array becomes empty. */
#define array_clear(array) \
	((array)->count = 0, \
		(array)->room ? (void)0 : (void)((array)->at = NULL))

/*
 * Forget the elements, and give back the memory where it is more than 1 MB: for
 * scratch that one large item has grown.
 */
#define array_trim(array) \
	((array)->room && (array)->room <= ARRAY_KEPT / sizeof *(array)->at \
			? (void)((array)->count = 0) \
			: array_release_bytes((array)))

enum { ARRAY_KEPT = 1 << 20 }; /* bytes */

int array_grow_bytes(void *array, size_t size, size_t more) TCS_CHECKED;
void array_release_bytes(void *array);

#endif
