#include "citygml_keys.h"

#include <stdlib.h>
#include <string.h>

#include "tcs.h"

static uint32_t *
slot_of(const struct key_table *table, const char *key)
{
	size_t mask = table->slots.count - 1;
	size_t i = (size_t)keyed_hash(&table->key, key, strlen(key)) & mask;

	while (table->slots.at[i] &&
		strcmp(table->keys.at[table->slots.at[i] - 1], key))
		i = (i + 1) & mask;
	return &table->slots.at[i];
}

uint32_t
keys_find(const struct key_table *table, const char *key)
{
	/* A free slot holds 0, and 0 - 1 is TCS_NONE. */
	return table->slots.count ? *slot_of(table, key) - 1 : TCS_NONE;
}

static int
slots_grow(struct key_table *table)
{
	size_t room = table->slots.count ? table->slots.count * 2 : 64;

	if (!table->slots.count)
		table->key = hash_key_new();
	array_clear(&table->slots);
	if (array_grow(&table->slots, room))
		return -1;
	table->slots.count = room;
	memset(table->slots.at, 0, room * sizeof *table->slots.at);
	for (size_t i = 0; i < table->keys.count; i++)
		*slot_of(table, table->keys.at[i]) = (uint32_t)i + 1;
	return 0;
}

enum tcs_status
keys_add(struct key_table *table, const char *key, uint32_t *number,
	bool *added, struct tcs_fault *fault)
{
	char *copy;

	*number = keys_find(table, key);
	*added = *number == TCS_NONE;
	if (!*added)
		return TCS_OK;
	if (table->keys.count * 2 >= table->slots.count && slots_grow(table))
		return fault_memory(fault);
	copy = strdup(key);
	if (!copy || array_grow(&table->keys, 1)) {
		free(copy);
		return fault_memory(fault);
	}
	*number = (uint32_t)table->keys.count;
	table->keys.at[table->keys.count++] = copy;
	*slot_of(table, key) = *number + 1;
	return TCS_OK;
}

void
keys_release(struct key_table *table)
{
	for (size_t i = 0; i < table->keys.count; i++)
		free(table->keys.at[i]);
	array_release(&table->keys);
	array_release(&table->slots);
}
