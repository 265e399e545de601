#include "citygml_digests.h"

#include <string.h>

void
digests_release(struct digest_table *table)
{
	array_release(&table->slots);
	*table = (struct digest_table){0};
}

/* Where it stands, or may. */
static struct digest *
slot_of(const struct digest_table *table, const struct digest *digest)
{
	size_t mask = table->slots.count - 1;
	size_t i = (size_t)digest->words[0] & mask;

	while (table->slots.at[i].number &&
		memcmp(table->slots.at[i].words, digest->words,
			sizeof digest->words) != 0)
		i = (i + 1) & mask;
	return &table->slots.at[i];
}

static int
slots_grow(struct digest_table *table)
{
	struct digest_table old = *table;
	size_t room = old.slots.count ? old.slots.count * 2 : 64;

	memset(&table->slots, 0, sizeof table->slots);
	if (array_grow(&table->slots, room)) {
		table->slots = old.slots;
		return -1;
	}
	memset(table->slots.at, 0, room * sizeof *table->slots.at);
	table->slots.count = room;
	for (size_t i = 0; i < old.slots.count; i++)
		if (old.slots.at[i].number)
			*slot_of(table, &old.slots.at[i]) = old.slots.at[i];
	array_release(&old.slots);
	return 0;
}

enum tcs_status
digests_add(struct digest_table *table, const void *bytes, size_t length,
	uint32_t *number, bool *added, struct tcs_fault *fault)
{
	struct digest digest = {.number = table->count + 1};
	struct digest *slot;

	if (!table->slots.count)
		for (int i = 0; i < 2; i++)
			table->keys[i] = hash_key_new();
	if ((size_t)table->count * 3 >= table->slots.count * 2 &&
		slots_grow(table))
		return fault_memory(fault);
	for (int i = 0; i < 2; i++)
		digest.words[i] = keyed_hash(&table->keys[i], bytes, length);
	slot = slot_of(table, &digest);
	*added = !slot->number;
	if (*added) {
		*slot = digest;
		table->count++;
	}
	*number = slot->number - 1;
	return TCS_OK;
}
