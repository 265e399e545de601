/*
 * A hash table from bytes to the order in which they came, that keeps of them
 * 128 bits of hash under a key of the run: a city's materials take next to no
 * memory. That two of a million have the same hash has a chance below 10^-26,
 * and nobody can make two that do.
 */
#ifndef TESSERA_CITYGML_DIGESTS_H
#define TESSERA_CITYGML_DIGESTS_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "keyed_hash.h"

struct digest {
	uint64_t words[2];
	uint32_t number; /* + 1; 0: free */
};

/* All zero is empty. */
struct digest_table {
	TCS_ARRAY(struct digest) slots; /* the count is a power of 2 */
	uint32_t count;
	struct hash_key keys[2]; /* once there are slots */
};

/* The number of the bytes, added if new, which *added then says. */
enum tcs_status digests_add(struct digest_table *table, const void *bytes,
	size_t length, uint32_t *number, bool *added,
	struct tcs_fault *fault) TCS_CHECKED;

void digests_release(struct digest_table *table);

#endif
