/*
 * An arena: many small allocations, freed all at once.
 *
 * All zero is empty. arena_reset forgets the allocations and keeps the
 * memory for the next object, so a long run settles at the largest object.
 */
#ifndef TESSERA_ARENA_H
#define TESSERA_ARENA_H

#include <stddef.h>

struct arena_block;

struct arena {
	struct arena_block *blocks; /* the newest first */
	size_t used; /* bytes used of the newest */
};

/* `size` bytes, aligned for any type and not cleared; NULL without memory. */
void *arena_get(struct arena *arena, size_t size);

/* A terminated copy of `length` bytes; NULL without memory. */
char *arena_copy(struct arena *arena, const char *bytes, size_t length);

void arena_reset(struct arena *arena);
void arena_release(struct arena *arena);

#endif
