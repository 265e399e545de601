#include "citygml_ids.h"

#include <stdlib.h>
#include <string.h>

#include "utf8.h"

/* ---- sets ------------------------------------------------------------------ */

void
id_set_release(struct id_set *set)
{
	free(set->slots);
	*set = (struct id_set){0};
}

void
id_set_clear(struct id_set *set)
{
	if (set->room > 64 && set->count < set->room / 16)
		id_set_release(set);
	if (set->count)
		memset(set->slots, 0, set->room * sizeof *set->slots);
	set->count = 0;
}

/* The slot of a hash, or the free one where it belongs. */
static uint64_t *
slot_of(const struct id_set *set, uint64_t hash)
{
	size_t at = (size_t)hash & (set->room - 1);

	while (set->slots[at] && set->slots[at] != hash)
		at = (at + 1) & (set->room - 1);
	return &set->slots[at];
}

bool
id_set_has(const struct id_set *set, uint64_t hash)
{
	return set->room && *slot_of(set, hash);
}

static enum tcs_status
grow(struct id_set *set, struct tcs_fault *fault)
{
	struct id_set bigger = {.room = set->room ? set->room * 2 : 64};

	bigger.slots = calloc(bigger.room, sizeof *bigger.slots);
	if (!bigger.slots)
		return fault_memory(fault);
	for (size_t i = 0; i < set->room; i++)
		if (set->slots[i])
			*slot_of(&bigger, set->slots[i]) = set->slots[i];
	bigger.count = set->count;
	free(set->slots);
	*set = bigger;
	return TCS_OK;
}

enum tcs_status
id_set_add(
	struct id_set *set, uint64_t hash, bool *added, struct tcs_fault *fault)
{
	uint64_t *slot;

	if (set->count + 1 > set->room / 4 * 3) {
		enum tcs_status status = grow(set, fault);

		if (status)
			return status;
	}
	slot = slot_of(set, hash);
	*added = !*slot;
	if (*added) {
		*slot = hash;
		set->count++;
	}
	return TCS_OK;
}

/* ---- numbers ---------------------------------------------------------------- */

void
id_numbers_release(struct id_numbers *numbers)
{
	free(numbers->slots);
	*numbers = (struct id_numbers){0};
}

void
id_numbers_clear(struct id_numbers *numbers)
{
	if (numbers->count)
		id_numbers_release(numbers);
}

static struct id_number *
number_of(const struct id_numbers *numbers, uint64_t hash)
{
	size_t at = (size_t)hash & (numbers->room - 1);

	while (numbers->slots[at].hash && numbers->slots[at].hash != hash)
		at = (at + 1) & (numbers->room - 1);
	return &numbers->slots[at];
}

static bool
grow_numbers(struct id_numbers *numbers)
{
	struct id_numbers bigger = {
		.room = numbers->room ? numbers->room * 2 : 64};

	bigger.slots = calloc(bigger.room, sizeof *bigger.slots);
	if (!bigger.slots)
		return false;
	for (size_t i = 0; i < numbers->room; i++)
		if (numbers->slots[i].hash)
			*number_of(&bigger, numbers->slots[i].hash) =
				numbers->slots[i];
	bigger.count = numbers->count;
	free(numbers->slots);
	*numbers = bigger;
	return true;
}

uint64_t *
id_numbers_at(struct id_numbers *numbers, uint64_t hash)
{
	struct id_number *number;

	if (numbers->count + 1 > numbers->room / 4 * 3 &&
		!grow_numbers(numbers))
		return NULL;
	number = number_of(numbers, hash);
	if (!number->hash) {
		number->hash = hash;
		numbers->count++;
	}
	return &number->last;
}

/* ---- hashes ----------------------------------------------------------------- */

uint64_t
id_hash(const struct hash_key *key, const char *id)
{
	uint64_t hash = keyed_hash(key, id, strlen(id));

	return hash ? hash : 1;
}

/* ---- names ----------------------------------------------------------------- */

/* XML 1.0 2.3, NameStartChar without ':'; above ASCII. */
static const uint32_t letters[][2] = {{0xc0, 0xd6}, {0xd8, 0xf6}, {0xf8, 0x2ff},
	{0x370, 0x37d}, {0x37f, 0x1fff}, {0x200c, 0x200d}, {0x2070, 0x218f},
	{0x2c00, 0x2fef}, {0x3001, 0xd7ff}, {0xf900, 0xfdcf}, {0xfdf0, 0xfffd},
	{0x10000, 0xeffff}};

static bool
is_letter(uint32_t c)
{
	if (c < 0x80)
		return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
			c == '_';
	for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
		if (c >= letters[i][0] && c <= letters[i][1])
			return true;
	return false;
}

static bool
is_later(uint32_t c)
{
	return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
		c == 0xb7 || (c >= 0x300 && c <= 0x36f) ||
		(c >= 0x203f && c <= 0x2040);
}

static uint32_t
character_at(const char *at, size_t length)
{
	static const unsigned char masks[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
	uint32_t c = (unsigned char)*at & masks[length];

	for (size_t i = 1; i < length; i++)
		c = c << 6 | ((unsigned char)at[i] & 0x3fu);
	return c;
}

bool
id_is_legal(const char *id)
{
	size_t left = strlen(id), length;

	for (size_t i = 0; left > 0; i++, id += length, left -= length) {
		uint32_t c;

		length = utf8_length(id, left);
		if (!length)
			return false;
		c = character_at(id, length);
		if (!(i ? is_later(c) : is_letter(c)))
			return false;
	}
	return true;
}

const char *
id_legal(const char *id, struct arena *arena)
{
	size_t left = strlen(id);
	char *legal, *to;

	if (id_is_legal(id))
		return id;
	legal = to = arena_get(arena, left + 2);
	if (!legal)
		return NULL;
	while (left > 0) {
		size_t length = utf8_length(id, left);
		uint32_t c = length ? character_at(id, length) : 0;

		if (to == legal && !is_letter(c))
			*to++ = '_';
		if (is_later(c)) {
			memcpy(to, id, length);
			to += length;
		} else if (to != legal + 1 || *legal != '_') {
			*to++ = '_';
		}
		length = length ? length : 1;
		id += length;
		left -= length;
	}
	*to = '\0';
	return legal;
}
