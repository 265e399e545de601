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
#include "keyed_hash.h"

struct store_place {
	uint64_t hash; /* of the target's id */
	uint64_t at; /* in the file */
};

/* A theme that shows what another theme has, too. */
struct store_alias {
	char *source; /* gml:id of the material or texture; owned */
	char *theme; /* owned */
};

/* All zero is the empty store. Filled by one thread, then read by many. */
struct paint_store {
	FILE *file; /* NULL while empty */
	uint64_t size; /* bytes written */
	TCS_ARRAY(struct store_place) places; /* sorted once closed */
	TCS_ARRAY(struct store_place) mappings; /* the same by mapping_id */
	TCS_ARRAY(struct store_alias) aliases; /* sorted once closed */
	TCS_ARRAY(uint64_t) sources; /* hashes, sorted once closed */
	struct hash_key key; /* of all hashes, once there is a file */
	TCS_ARRAY(unsigned char) bytes; /* one paint on its way out */
};

void store_release(struct paint_store *store);

/* Keep one paint of `raw`, with its coordinates. Fails with TCS_SYSTEM. */
enum tcs_status store_add(struct paint_store *store,
	const struct raw_object *raw, const struct raw_paint *paint,
	struct tcs_fault *fault) TCS_CHECKED;

/* The theme shows all that is put on targets by this material or texture. */
enum tcs_status store_alias(struct paint_store *store, const char *theme,
	const char *source, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Nothing more is added; fetching may begin. Materials and textures that
 * themes link to and that do not exist are reported.
 */
enum tcs_status store_close(struct paint_store *store, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append to `raw` the paints that are kept for this of its targets, once for
 * each theme that shows them.
 */
enum tcs_status store_fetch(const struct paint_store *store,
	struct raw_object *raw, tcs_text target,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Give a paint of `raw` the mapping that is kept under the mapping_id it links
 * to. *found says whether there is one.
 */
enum tcs_status store_fetch_mapping(const struct paint_store *store,
	struct raw_object *raw, size_t paint, bool *found,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
