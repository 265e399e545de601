#include "keyed_hash.h"

#include <string.h>
#include <time.h>

__extension__ typedef unsigned __int128 wide;

/* Both halves of a product. */
static inline uint64_t
folded(uint64_t a, uint64_t b)
{
	wide product = (wide)a * b;

	return (uint64_t)product ^ (uint64_t)(product >> 64);
}

static inline uint64_t
word_at(const unsigned char *bytes)
{
	uint64_t word;

	memcpy(&word, bytes, sizeof word);
	return word;
}

/* Up to eight bytes: no two texts of one length have the same word. */
static inline uint64_t
short_word(const unsigned char *bytes, size_t length)
{
	uint32_t first, last;

	if (length < 4)
		return length ? (uint64_t)bytes[0] << 16 |
				(uint64_t)bytes[length / 2] << 8 |
				bytes[length - 1]
			      : 0;
	memcpy(&first, bytes, sizeof first);
	memcpy(&last, bytes + length - 4, sizeof last);
	return (uint64_t)first << 32 | last;
}

uint64_t
keyed_hash(const struct hash_key *key, const void *bytes, size_t length)
{
	const unsigned char *at = bytes, *end = at + length;
	uint64_t hash = key->words[0] ^ 0x9e3779b97f4a7c15u;
	uint64_t veil = key->words[1] ^ 0xbf58476d1ce4e5b9u, last;

	if (length <= 8) {
		last = short_word(at, length);
	} else {
		for (; end - at > 8; at += 8)
			hash = folded(word_at(at) ^ veil, hash);
		last = word_at(end - 8);
	}
	hash = folded(last ^ veil, hash);
	return folded(hash ^ length, veil | 1);
}

struct hash_key
hash_key_new(void)
{
	struct hash_key key = {{0, 0}};
	struct timespec now = {0, 0};
	uint64_t seed[4];

	clock_gettime(CLOCK_REALTIME, &now);
	seed[0] = (uint64_t)now.tv_sec;
	seed[1] = (uint64_t)now.tv_nsec;
	seed[2] = (uint64_t)(uintptr_t)&key;
	seed[3] = (uint64_t)(uintptr_t)&hash_key_new;
	key.words[0] = keyed_hash(&key, seed, sizeof seed);
	key.words[1] = keyed_hash(&key, seed, sizeof seed);
	return key;
}
