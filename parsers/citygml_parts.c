#include "citygml_parts.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "input.h"

enum { LOG_WORDS = 64 * 1024 }; /* that stay in memory */

/* A feature in the log; its hashes follow. */
struct place_entry {
	struct raw_place place;
	uint64_t count;
};

enum { ENTRY_WORDS = sizeof(struct place_entry) / sizeof(uint64_t) };

void
parts_release(struct document_parts *parts)
{
	array_release(&parts->places);
	*parts = (struct document_parts){0};
}

void
places_release(struct place_log *log)
{
	if (log->file)
		fclose(log->file);
	array_release(&log->words);
	*log = (struct place_log){0};
}

/* ---- writing ---------------------------------------------------------------- */

static enum tcs_status
words_flush(struct place_log *log, struct tcs_fault *fault)
{
	int fd = log->file ? -1 : input_nameless();

	if (fd >= 0)
		log->file = fdopen(fd, "w+b");
	if (fd >= 0 && !log->file)
		close(fd);
	if (!log->file)
		return fault_system(fault, "cannot create", "a temporary file");
	if (fwrite(log->words.at, sizeof *log->words.at, log->words.count,
		    log->file) != log->words.count)
		return fault_system(fault, "cannot write", "a temporary file");
	log->words.count = 0;
	return TCS_OK;
}

enum tcs_status
places_add(struct place_log *log, const struct raw_place *place,
	const uint64_t *hashes, size_t count, struct tcs_fault *fault)
{
	struct place_entry entry = {*place, count};

	log->unknown |= !place->end;
	if (log->unknown)
		return TCS_OK;
	if (array_grow(&log->words, ENTRY_WORDS + count))
		return fault_memory(fault);
	memcpy(log->words.at + log->words.count, &entry, sizeof entry);
	log->words.count += ENTRY_WORDS;
	if (count)
		memcpy(log->words.at + log->words.count, hashes,
			count * sizeof *hashes);
	log->words.count += count;
	return log->words.count < LOG_WORDS ? TCS_OK : words_flush(log, fault);
}

/* ---- reading ---------------------------------------------------------------- */

static enum tcs_status
reading_begin(struct place_log *log, struct tcs_fault *fault)
{
	enum tcs_status status;

	log->next = 0;
	if (!log->file)
		return TCS_OK;
	status = words_flush(log, fault);
	if (!status && fseek(log->file, 0, SEEK_SET))
		status = fault_system(fault, "cannot read", "a temporary file");
	return status;
}

/* *got stays false at the end. */
static enum tcs_status
words_take(struct place_log *log, void *to, size_t count, bool *got,
	struct tcs_fault *fault)
{
	*got = true;
	if (!log->file) {
		*got = log->words.count - log->next >= count;
		if (*got && count)
			memcpy(to, log->words.at + log->next,
				count * sizeof(uint64_t));
		log->next += *got ? count : 0;
		return TCS_OK;
	}
	if (fread(to, sizeof(uint64_t), count, log->file) == count)
		return TCS_OK;
	*got = false;
	return ferror(log->file)
		? fault_system(fault, "cannot read", "a temporary file")
		: TCS_OK;
}

static int
compare_words(const void *a, const void *b)
{
	uint64_t one, two;

	memcpy(&one, a, sizeof one);
	memcpy(&two, b, sizeof two);
	return one < two ? -1 : one > two;
}

static bool
is_among(uint64_t word, const uint64_t *words, size_t count)
{
	return count &&
		bsearch(&word, words, count, sizeof *words, compare_words);
}

/* Read the hashes of one feature; whether any of them is asked for. */
static enum tcs_status
hashes_match(struct place_log *log, const struct place_query *query,
	uint64_t count, bool *match, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	*match = false;
	for (uint64_t i = 0; !status && i < count; i++) {
		uint64_t hash = 0;
		bool got;

		status = words_take(log, &hash, 1, &got, fault);
		*match |= is_among(hash, query->hashes, query->hash_count);
	}
	return status;
}

static enum tcs_status
part_add(struct document_parts *parts, const struct raw_place *place,
	struct tcs_fault *fault)
{
	if (array_grow(&parts->places, 1))
		return fault_memory(fault);
	parts->places.at[parts->places.count++] = *place;
	return TCS_OK;
}

enum tcs_status
places_select(struct place_log *log, const struct place_query *query,
	struct document_parts *with_id, struct document_parts *with_number,
	struct tcs_fault *fault)
{
	enum tcs_status status = reading_begin(log, fault);

	while (!status) {
		struct place_entry entry;
		bool got, match;

		status = words_take(log, &entry, ENTRY_WORDS, &got, fault);
		if (status || !got)
			break;
		status = hashes_match(log, query, entry.count, &match, fault);
		if (!status && match)
			status = part_add(with_id, &entry.place, fault);
		if (!status &&
			is_among(entry.place.number, query->numbers,
				query->number_count))
			status = part_add(with_number, &entry.place, fault);
	}
	return status;
}
