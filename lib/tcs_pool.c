#include "tcs_pool.h"

#include <stdlib.h>
#include <string.h>

enum tcs_status
pool_begin(struct text_pool *pool, struct byte_array *bytes,
	struct tcs_fault *fault)
{
	*pool = (struct text_pool){
		.bytes = bytes, .base = bytes->count, .key = hash_key_new()};
	if (array_grow(bytes, 1))
		return fault_memory(fault);
	bytes->at[bytes->count++] = '\0';
	return TCS_OK;
}

void
pool_release(struct text_pool *pool)
{
	free(pool->slots);
	*pool = (struct text_pool){0};
}

/* The slot of a string, or the free slot where it belongs. */
static struct pool_slot *
pool_find(const struct text_pool *pool, const char *string, size_t length,
	uint32_t hash)
{
	const unsigned char *text = pool->bytes->at + pool->base;
	size_t mask = pool->slot_count - 1;
	size_t at = hash & mask;

	for (;; at = (at + 1) & mask) {
		struct pool_slot *slot = &pool->slots[at];

		if (!slot->text)
			return slot;
		/* with the terminator: a prefix is another string */
		if (slot->hash == hash &&
			!strncmp((const char *)text + slot->text, string,
				length + 1))
			return slot;
	}
}

static int
pool_widen(struct text_pool *pool)
{
	size_t count = pool->slot_count ? pool->slot_count * 2 : 128;
	struct pool_slot *slots = calloc(count, sizeof *slots);

	if (!slots)
		return -1;
	for (size_t i = 0; i < pool->slot_count; i++) {
		size_t at = pool->slots[i].hash & (count - 1);

		if (!pool->slots[i].text)
			continue;
		while (slots[at].text)
			at = (at + 1) & (count - 1);
		slots[at] = pool->slots[i];
	}
	free(pool->slots);
	pool->slots = slots;
	pool->slot_count = count;
	return 0;
}

enum tcs_status
pool_intern(struct text_pool *pool, const char *string, tcs_text *out,
	struct tcs_fault *fault)
{
	size_t length = strlen(string);
	size_t start = pool->bytes->count - pool->base;
	uint32_t hash = (uint32_t)keyed_hash(&pool->key, string, length);
	struct pool_slot *slot;

	if (pool->used * 2 >= pool->slot_count && pool_widen(pool))
		return fault_memory(fault);
	slot = pool_find(pool, string, length, hash);
	if (slot->text) {
		*out = slot->text;
		return TCS_OK;
	}
	if (length >= UINT32_MAX || start > UINT32_MAX - length - 1)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"the text of one record exceeds 4 GiB");
	if (array_grow(pool->bytes, length + 1))
		return fault_memory(fault);
	memcpy(pool->bytes->at + pool->bytes->count, string, length + 1);
	pool->bytes->count += length + 1;
	*slot = (struct pool_slot){(tcs_text)start, hash};
	pool->used++;
	*out = slot->text;
	return TCS_OK;
}
