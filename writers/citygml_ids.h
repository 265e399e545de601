/*
 * Ids: legal, and unique in the file.
 *
 * An id is an NCName (XML Namespaces 1.0, 3). Sets keep 64-bit hashes, so a
 * file's ids cost 11 to 22 bytes each; two ids of one hash, which is not to be
 * expected below a billion ids, only give the second one another name.
 */
#ifndef TESSERA_CITYGML_IDS_H
#define TESSERA_CITYGML_IDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "arena.h"
#include "fault.h"
#include "keyed_hash.h"

struct id_set {
	uint64_t *slots; /* 0: free */
	size_t room; /* a power of two, or 0 */
	size_t count;
};

/* How many ids were made of a base, by its hash. */
struct id_numbers {
	struct id_number {
		uint64_t hash; /* 0: free */
		uint64_t last;
	} * slots;
	size_t room; /* a power of two, or 0 */
	size_t count;
};

void id_set_release(struct id_set *set);
/* Takes no longer than what was put in, on average: room that is far too large
 * is given back. */
void id_set_clear(struct id_set *set);
bool id_set_has(const struct id_set *set, uint64_t hash);

/* *added says whether it is new. Fails with TCS_NO_MEMORY. */
enum tcs_status id_set_add(struct id_set *set, uint64_t hash, bool *added,
	struct tcs_fault *fault) TCS_CHECKED;

void id_numbers_release(struct id_numbers *numbers);
void id_numbers_clear(struct id_numbers *numbers);

/* The number of a base, 0 at first; valid until the next call. NULL without
 * memory. */
uint64_t *id_numbers_at(struct id_numbers *numbers, uint64_t hash);

/* Of the text, under the key of the run; never 0. */
uint64_t id_hash(const struct hash_key *key, const char *id);

bool id_is_legal(const char *id);

/*
 * The id with what no NCName may have replaced by '_'; the same pointer when
 * nothing needs to be. NULL without memory.
 */
const char *id_legal(const char *id, struct arena *arena);

#endif
