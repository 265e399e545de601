/*
 * Hashes for tables of what inputs say: under a key that whoever wrote an input
 * could not know, so that none can be made of strings that all meet in one
 * slot. Nothing written may depend on them.
 *
 * source: the folded products of W. Yi et al., wyhash, 2019.
 */
#ifndef TESSERA_KEYED_HASH_H
#define TESSERA_KEYED_HASH_H

#include <stddef.h>
#include <stdint.h>

/* All zero is a key too, one that everybody knows. */
struct hash_key {
	uint64_t words[2];
};

/* Another one for each call: of the time, and of where things lie in memory. */
struct hash_key hash_key_new(void);

uint64_t keyed_hash(
	const struct hash_key *key, const void *bytes, size_t length);

#endif
