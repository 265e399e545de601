/*
 * The bytes as a STEP file, or as a zip archive of one: indexed, every value of
 * every instance walked and decoded.
 */
#include "parsers/step_file.h"

#include <stdlib.h>
#include <string.h>

#include "parsers/step_string.h"
#include "parsers/step_zip.h"
#include "utf8.h"

enum { MOST_UNPACKED = 1 << 20 };

static void
string_check(const struct step_value *value, struct step_text *text)
{
	struct tcs_fault fault;
	unsigned trouble = 0;

	array_clear(text);
	if (step_decode(text, value->text, value->length, &trouble, &fault))
		abort();
	if (strlen(text->at) != text->count ||
		!utf8_valid(text->at, text->count))
		abort();
}

/* Bounded: each list is entered once, however deep. */
static void
list_walk(const struct step_file *file, struct step_cursor cursor,
	struct step_text *text)
{
	struct step_cursor around[STEP_MAX_NESTING + 2];
	struct step_value value;
	size_t depth = 0;
	double number;

	around[0] = cursor;
	for (;;) {
		if (step_next(around + depth, &value) <= STEP_END) {
			if (step_next(around + depth, &value) > STEP_END)
				abort();
			if (!depth--)
				return;
			continue;
		}
		step_number(&value, &number);
		step_target(file, &value);
		if (value.kind == STEP_STRING)
			string_check(&value, text);
		if (value.kind < STEP_LIST)
			continue;
		if (depth++ > STEP_MAX_NESTING)
			abort();
		around[depth] = value.list;
	}
}

static void
ids_check(const struct step_file *file)
{
	size_t named = 0;

	for (uint32_t i = 0; i < file->instances.count; i++) {
		uint32_t found = step_find(file, file->instances.at[i].id);

		if (found > i ||
			file->instances.at[found].id !=
				file->instances.at[i].id)
			abort();
	}
	for (uint16_t i = 0; i < file->names.list.count; i++) {
		struct step_list list = step_instances(file, i);

		for (size_t k = 0; k < list.count; k++, named++)
			if (step_name_of(file, list.at[k]) != i)
				abort();
	}
	if (named != file->instances.count)
		abort();
}

static void
text_check(const char *bytes, size_t length)
{
	struct step_file file = {.text = NULL};
	struct report report = {.counts = {0}};
	struct step_text text = {.count = 0};
	struct step_cursor cursor;
	struct tcs_fault fault;

	if (!step_index(&file, bytes, length, &report, &fault)) {
		ids_check(&file);
		for (int i = 0; i < STEP_HEADERS; i++)
			list_walk(&file,
				step_header_parameters(
					&file, (enum step_header)i),
				&text);
		for (uint32_t i = 0; i < file.instances.count; i++) {
			list_walk(&file, step_parameters(&file, i), &text);
			if (step_part(&file, i, "B", &cursor))
				list_walk(&file, cursor, &text);
		}
	}
	step_release(&file);
	report_release(&report);
	array_release(&text);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	struct step_bytes unpacked = {.count = 0};
	struct tcs_fault fault;

	if (!zip_is((const char *)bytes, size))
		text_check((const char *)bytes, size);
	else if (!zip_member((const char *)bytes, size, MOST_UNPACKED,
			 &unpacked, &fault))
		text_check(unpacked.at, unpacked.count);
	array_release(&unpacked);
	return 0;
}
