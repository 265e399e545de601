#include "step_names.h"

#include <stdlib.h>
#include <string.h>

/*
 * A name with the bit taken out in which small letters differ from capitals.
 * Of the characters that a name may have, no other two become the same.
 */
struct folded {
	uint64_t words[(STEP_MAX_NAME + 7) / 8];
	size_t count;
	uint32_t hash; /* once it is asked for */
};

#define FOLD UINT64_C(0xdfdfdfdfdfdfdfdf)

static void
name_fold(struct folded *out, const char *name, size_t length)
{
	out->count = (length + 7) / 8;
	out->words[out->count - 1] = 0;
	for (size_t i = 0; i < out->count; i++) {
		size_t left = length - i * 8;

		if (left >= 8)
			memcpy(out->words + i, name + i * 8, 8);
		else
			memcpy(out->words + i, name + i * 8, left);
		out->words[i] &= FOLD;
	}
}

static void
name_hash(const struct step_names *names, struct folded *folded)
{
	folded->hash = (uint32_t)keyed_hash(
		&names->key, folded->words, folded->count * 8);
}

/* `text` is what `folded` was made of; most are in capitals as they stand. */
static bool
name_is(const struct step_name *name, const struct folded *folded,
	const char *text, size_t length)
{
	struct folded own;

	if (name->hash != folded->hash || name->length != length)
		return false;
	if (!memcmp(name->text, text, length))
		return true;
	name_fold(&own, name->text, name->length);
	return !memcmp(own.words, folded->words, own.count * 8);
}

/* The slot of the name, or the free one where it belongs. */
static size_t
slot_find(const struct step_names *names, const struct folded *folded,
	const char *text, size_t length)
{
	size_t mask = names->slot_count - 1, at = folded->hash & mask;

	while (names->slots[at] &&
		!name_is(names->list.at + names->slots[at], folded, text,
			length))
		at = (at + 1) & mask;
	return at;
}

static enum tcs_status
slots_grow(struct step_names *names, struct tcs_fault *fault)
{
	size_t count = names->slot_count ? names->slot_count * 2 : 1024;
	uint16_t *slots = calloc(count, sizeof *slots);

	if (!slots)
		return fault_memory(fault);
	for (size_t i = 1; i < names->list.count; i++) {
		size_t at = names->list.at[i].hash & (count - 1);

		while (slots[at])
			at = (at + 1) & (count - 1);
		slots[at] = (uint16_t)i;
	}
	free(names->slots);
	names->slots = slots;
	names->slot_count = count;
	return TCS_OK;
}

static enum tcs_status
name_add(struct step_names *names, const char *name, size_t length,
	uint32_t hash, struct tcs_fault *fault)
{
	char *text;

	if (names->list.count > STEP_MAX_NAMES)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"more than %d entity names", STEP_MAX_NAMES);
	if (array_grow(&names->list, 1))
		return fault_memory(fault);
	text = arena_copy(&names->text, name, length);
	if (!text)
		return fault_memory(fault);
	for (size_t i = 0; i < length; i++)
		if (text[i] >= 'a' && text[i] <= 'z')
			text[i] = (char)(text[i] - 'a' + 'A');
	names->list.at[names->list.count++] = (struct step_name){
		.text = text, .length = (uint32_t)length, .hash = hash};
	return TCS_OK;
}

enum tcs_status
step_names_begin(struct step_names *names, struct tcs_fault *fault)
{
	enum tcs_status status = name_add(names, "", 0, 0, fault);

	names->key = hash_key_new();
	return status ? status : slots_grow(names, fault);
}

enum tcs_status
step_names_intern(struct step_names *names, const char *name, size_t length,
	uint16_t *out, struct tcs_fault *fault)
{
	struct folded folded;
	enum tcs_status status;
	size_t at;

	if (names->list.count * 2 >= names->slot_count) {
		status = slots_grow(names, fault);
		if (status)
			return status;
	}
	name_fold(&folded, name, length);
	name_hash(names, &folded);
	at = slot_find(names, &folded, name, length);
	if (!names->slots[at]) {
		status = name_add(names, name, length, folded.hash, fault);
		if (status)
			return status;
		names->slots[at] = (uint16_t)(names->list.count - 1);
	}
	*out = names->slots[at];
	return TCS_OK;
}

uint16_t
step_names_find(const struct step_names *names, const char *name)
{
	size_t length = strlen(name);
	struct folded folded;

	if (!names->slot_count || !length || length > STEP_MAX_NAME)
		return 0;
	name_fold(&folded, name, length);
	name_hash(names, &folded);
	return names->slots[slot_find(names, &folded, name, length)];
}

void
step_names_release(struct step_names *names)
{
	array_release(&names->list);
	free(names->slots);
	arena_release(&names->text);
	*names = (struct step_names){.slots = NULL};
}
