#include "keyed_hash.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "check.h"

enum { SLOTS = 1 << 16, STRINGS = SLOTS };

/* How many of the strings "prefix0", "prefix1", … meet others in a slot. */
static int
meetings(const struct hash_key *key, const char *prefix)
{
	static bool taken[SLOTS];
	int meet = 0;

	memset(taken, 0, sizeof taken);
	for (int i = 0; i < STRINGS; i++) {
		char text[64];
		int length = snprintf(text, sizeof text, "%s%d", prefix, i);
		size_t slot = keyed_hash(key, text, (size_t)length) % SLOTS;

		meet += taken[slot];
		taken[slot] = true;
	}
	return meet;
}

/* By chance, 1/e of them would: 24109, give or take 130. */
static void
similar_strings_spread_like_any_others(void)
{
	static const char *const prefixes[] = {
		"", "wall_", "GML_7b1a5a6f-ddad-4c3d-a507-3eb9ee0a8e68_"};

	for (size_t i = 0; i < 3; i++) {
		struct hash_key keys[] = {{{0, 0}}, hash_key_new()};

		for (size_t j = 0; j < 2; j++) {
			int meet = meetings(&keys[j], prefixes[i]);

			CHECK(meet > 23000 && meet < 25200);
		}
	}
}

static void
every_byte_and_the_length_count(void)
{
	static const char text[] = "0123456789abcdef0123456789abcdef";
	struct hash_key key = hash_key_new();
	char changed[sizeof text];

	for (size_t length = 0; length < sizeof text; length++) {
		uint64_t hash = keyed_hash(&key, text, length);

		CHECK(hash == keyed_hash(&key, text, length));
		CHECK(hash != keyed_hash(&key, text, length + 1));
		for (size_t i = 0; i < length; i++) {
			memcpy(changed, text, sizeof text);
			changed[i] ^= 1;
			CHECK(hash != keyed_hash(&key, changed, length));
		}
	}
}

static void
every_key_is_another(void)
{
	struct hash_key one = hash_key_new(), two = hash_key_new();

	CHECK(one.words[0] != two.words[0] && one.words[1] != two.words[1]);
	CHECK(one.words[0] != one.words[1]);
	CHECK(keyed_hash(&one, "wall", 4) != keyed_hash(&two, "wall", 4));
}

static const struct check_test tests[] = {
	CHECK_TEST(similar_strings_spread_like_any_others),
	CHECK_TEST(every_byte_and_the_length_count),
	CHECK_TEST(every_key_is_another),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
