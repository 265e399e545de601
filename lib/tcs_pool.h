/*
 * The text of a record under construction: each string once. Internal to the
 * stream.
 */
#ifndef TESSERA_TCS_POOL_H
#define TESSERA_TCS_POOL_H

#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "keyed_hash.h"
#include "tcs.h"

struct pool_slot {
	tcs_text text; /* 0: free */
	uint32_t hash;
};

TCS_ARRAY_TYPE(byte_array, unsigned char);

/* Strings are appended to `bytes`, whose text begins at `base`. */
struct text_pool {
	struct byte_array *bytes;
	size_t base;
	struct pool_slot *slots;
	size_t slot_count; /* a power of two, or 0 */
	size_t used;
	struct hash_key key;
};

/* Begin the text behind the bytes there are, with its leading NUL. */
enum tcs_status pool_begin(struct text_pool *pool, struct byte_array *bytes,
	struct tcs_fault *fault) TCS_CHECKED;

/* The offset of a string that is not empty, appended if it is new. */
enum tcs_status pool_intern(struct text_pool *pool, const char *string,
	tcs_text *out, struct tcs_fault *fault) TCS_CHECKED;

void pool_release(struct text_pool *pool);

#endif
