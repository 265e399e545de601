#include "arena.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct arena_block {
	struct arena_block *next;
	size_t size;
	max_align_t bytes[];
};

enum { FIRST_BLOCK = 16 * 1024 };

/*
 * Every block is at least twice as large as the one before it, so the newest
 * is the largest, and keeping that one settles at what an object needs.
 */
static struct arena_block *
block_new(const struct arena_block *before, size_t size)
{
	size_t room = FIRST_BLOCK;
	struct arena_block *block;

	if (before && before->size <= PTRDIFF_MAX / 4)
		room = before->size * 2;
	if (room < size)
		room = size;
	if (room > PTRDIFF_MAX - sizeof *block)
		return NULL;
	block = malloc(sizeof *block + room);
	if (block)
		block->size = room;
	return block;
}

void *
arena_get(struct arena *arena, size_t size)
{
	const size_t align = _Alignof(max_align_t);
	struct arena_block *block = arena->blocks;
	char *bytes;

	if (size > PTRDIFF_MAX - align)
		return NULL;
	size = (size + align - 1) / align * align;
	if (!block || size > block->size - arena->used) {
		block = block_new(arena->blocks, size);
		if (!block)
			return NULL;
		block->next = arena->blocks;
		arena->blocks = block;
		arena->used = 0;
	}
	bytes = (char *)block->bytes + arena->used;
	arena->used += size;
	return bytes;
}

char *
arena_copy(struct arena *arena, const char *bytes, size_t length)
{
	char *copy;

	if (length == SIZE_MAX)
		return NULL;
	copy = arena_get(arena, length + 1);
	if (!copy)
		return NULL;
	if (length)
		memcpy(copy, bytes, length);
	copy[length] = '\0';
	return copy;
}

static void
blocks_free(struct arena_block *block)
{
	while (block) {
		struct arena_block *next = block->next;

		free(block);
		block = next;
	}
}

void
arena_reset(struct arena *arena)
{
	arena->used = 0;
	if (!arena->blocks)
		return;
	blocks_free(arena->blocks->next);
	arena->blocks->next = NULL;
}

void
arena_release(struct arena *arena)
{
	blocks_free(arena->blocks);
	arena->blocks = NULL;
	arena->used = 0;
}
