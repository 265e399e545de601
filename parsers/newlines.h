/* Lines of a text, counted fast: this loop compiles to vector instructions. */
#ifndef TESSERA_NEWLINES_H
#define TESSERA_NEWLINES_H

#include <stddef.h>
#include <stdint.h>

static inline uint64_t
newlines_count(const char *at, size_t length)
{
	enum { BLOCK = 128, SMALL_BLOCK = 16 };
	uint64_t count = 0;

	for (; length >= BLOCK; at += BLOCK, length -= BLOCK) {
		unsigned char some = 0;

		for (int i = 0; i < BLOCK; i++)
			some = (unsigned char)(some + (at[i] == '\n'));
		count += some;
	}
	for (; length >= SMALL_BLOCK;
		at += SMALL_BLOCK, length -= SMALL_BLOCK) {
		unsigned char some = 0;

		for (int i = 0; i < SMALL_BLOCK; i++)
			some = (unsigned char)(some + (at[i] == '\n'));
		count += some;
	}
	for (; length; at++, length--)
		count += *at == '\n';
	return count;
}

#endif
