/*
 * The store of global appearances: what they put on which id.
 *
 * A global appearance may name every polygon of a city, and stands where it
 * likes; so its paints are kept in a file without a name, and only where each
 * is to be found stays in memory, 16 bytes a target.
 */
#ifndef TESSERA_CITYGML_STORE_H
#define TESSERA_CITYGML_STORE_H

#include <stdint.h>
#include <stdio.h>

#include "array.h"
#include "citygml_raw.h"

struct store_place {
	uint64_t hash; /* of the target's id */
	uint64_t at; /* in the file */
};

/* All zero is the empty store. Filled by one thread, then read by many. */
struct paint_store {
	FILE *file; /* NULL while empty */
	uint64_t size; /* bytes written */
	TCS_ARRAY(struct store_place) places; /* sorted once closed */
	TCS_ARRAY(unsigned char) bytes; /* one paint on its way out */
};

void store_release(struct paint_store *store);

/* Keep one paint of `raw`, with its coordinates. Fails with TCS_SYSTEM. */
enum tcs_status store_add(struct paint_store *store,
	const struct raw_object *raw, const struct raw_paint *paint,
	struct tcs_fault *fault) TCS_CHECKED;

/* Nothing more is added; fetching may begin. */
enum tcs_status store_close(
	struct paint_store *store, struct tcs_fault *fault) TCS_CHECKED;

/* Append to `raw` the paints that are kept for this of its targets. */
enum tcs_status store_fetch(const struct paint_store *store,
	struct raw_object *raw, tcs_text target,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
