#include "byte_index.h"

#include <string.h>

static size_t
byte_index_start(const struct byte_index *index, size_t number)
{
	return number ? index->ends.at[number - 1] : 0;
}

/* The slot of a string, or the free one where it would go. */
static size_t
byte_index_slot(
	const struct byte_index *index, const void *bytes, size_t length)
{
	size_t mask = index->slots.count - 1;
	size_t slot = (size_t)keyed_hash(&index->key, bytes, length) & mask;

	for (; index->slots.at[slot]; slot = (slot + 1) & mask) {
		size_t number = index->slots.at[slot] - 1;
		size_t start = byte_index_start(index, number);

		if (index->ends.at[number] - start == length &&
			(!length ||
				!memcmp(index->heap.at + start, bytes, length)))
			break;
	}
	return slot;
}

uint32_t
byte_index_find(
	const struct byte_index *index, const void *bytes, size_t length)
{
	size_t slot;

	if (!index->slots.count)
		return INDEX_NONE;
	slot = byte_index_slot(index, bytes, length);
	return index->slots.at[slot] ? index->slots.at[slot] - 1 : INDEX_NONE;
}

/* Keep the table a power of two and at most half full. */
static int
byte_index_widen(struct byte_index *index)
{
	size_t count = index->slots.count ? index->slots.count : 16;

	if (index->slots.count && index->ends.count * 2 < count)
		return 0;
	if (index->slots.count)
		count *= 2;
	else
		index->key = hash_key_new();
	array_clear(&index->slots);
	if (array_grow(&index->slots, count)) {
		byte_index_clear(index);
		return -1;
	}
	index->slots.count = count;
	memset(index->slots.at, 0, count * sizeof *index->slots.at);
	for (size_t number = 0; number < index->ends.count; number++) {
		size_t start = byte_index_start(index, number);
		size_t slot = byte_index_slot(index, index->heap.at + start,
			index->ends.at[number] - start);

		index->slots.at[slot] = (uint32_t)number + 1;
	}
	return 0;
}

enum tcs_status
byte_index_add(struct byte_index *index, const void *bytes, size_t length,
	uint32_t *number, bool *added, struct tcs_fault *fault)
{
	size_t slot;

	*added = false;
	if (byte_index_widen(index))
		return fault_memory(fault);
	slot = byte_index_slot(index, bytes, length);
	if (index->slots.at[slot]) {
		*number = index->slots.at[slot] - 1;
		return TCS_OK;
	}
	if (index->ends.count >= INDEX_NONE - 1 ||
		array_grow(&index->heap, length) || array_grow(&index->ends, 1))
		return fault_memory(fault);
	if (length)
		memcpy(index->heap.at + index->heap.count, bytes, length);
	index->heap.count += length;
	*number = (uint32_t)index->ends.count;
	index->ends.at[index->ends.count++] = index->heap.count;
	index->slots.at[slot] = *number + 1;
	*added = true;
	return TCS_OK;
}

void
byte_index_clear(struct byte_index *index)
{
	array_clear(&index->heap);
	array_clear(&index->ends);
	if (index->slots.count)
		memset(index->slots.at, 0,
			index->slots.count * sizeof *index->slots.at);
}

void
byte_index_release(struct byte_index *index)
{
	array_release(&index->heap);
	array_release(&index->ends);
	array_release(&index->slots);
}
