/* A hash table from strings to the order in which they came. */
#ifndef TESSERA_CITYGML_KEYS_H
#define TESSERA_CITYGML_KEYS_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "keyed_hash.h"

/* All zero is empty. */
struct key_table {
	TCS_ARRAY(char *) keys; /* owned; key n came as the n-th */
	TCS_ARRAY(uint32_t) slots; /* key number + 1; 0: free */
	struct hash_key key; /* of the slots, once there are any */
};

/* The number of a key; TCS_NONE when it is not there. */
uint32_t keys_find(const struct key_table *table, const char *key);

/* The number of a key, added if new, which *added then says. */
enum tcs_status keys_add(struct key_table *table, const char *key,
	uint32_t *number, bool *added, struct tcs_fault *fault) TCS_CHECKED;

void keys_release(struct key_table *table);

#endif
