/*
 * An index of byte strings: each different one gets a number, from 0, in the
 * order of their first appearance. All zero is the empty index.
 */
#ifndef TESSERA_BYTE_INDEX_H
#define TESSERA_BYTE_INDEX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "keyed_hash.h"

struct byte_index {
	TCS_ARRAY(char) heap; /* the strings, end to end */
	TCS_ARRAY(size_t) ends; /* where each one ends in the heap */
	TCS_ARRAY(uint32_t) slots; /* hash table: number + 1, 0 is free */
	struct hash_key key; /* of the table, once there is one */
};

/* The number of a string; INDEX_NONE when it is not there. */
#define INDEX_NONE UINT32_MAX
uint32_t byte_index_find(
	const struct byte_index *index, const void *bytes, size_t length);

/* The same, adding it where it is new. Fails with TCS_NO_MEMORY. */
enum tcs_status byte_index_add(struct byte_index *index, const void *bytes,
	size_t length, uint32_t *number, bool *added,
	struct tcs_fault *fault) TCS_CHECKED;

/* Forget the strings, keep the room. */
void byte_index_clear(struct byte_index *index);
void byte_index_release(struct byte_index *index);

#endif
