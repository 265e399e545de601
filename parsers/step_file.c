#include "step_file.h"

#include <stdlib.h>
#include <string.h>

#include "step_lex.h"
#include "step_tables.h"

enum section { OUTSIDE, HEADER, DATA, OTHER, CLOSED };

struct indexing {
	struct step_file *file;
	struct report *report;
	const char *at, *end;
	const char *section_at; /* where the section begins */
	enum section section;
};

static uint64_t
offset_of(const struct indexing *index, const char *at)
{
	return (uint64_t)(at - index->file->text);
}

/* ---- statements ---------------------------------------------------------- */

static enum tcs_status
statement_end(struct indexing *index, const char *begin, const char *at,
	struct tcs_fault *fault)
{
	at = step_statement_end(at, index->end);
	if (!at)
		return fault_set(fault, TCS_TRUNCATED, offset_of(index, begin),
			"a statement does not end");
	index->at = at + 1;
	return TCS_OK;
}

static enum tcs_status
statement_skip(struct indexing *index, const char *begin, const char *at,
	const char *item, struct tcs_fault *fault)
{
	enum tcs_status status = statement_end(index, begin, at, fault);

	if (status)
		return status;
	return report_item(index->report, REPORT_SKIPPED, item,
		"it is malformed", NULL, offset_of(index, begin), fault);
}

static enum tcs_status
instance_add(struct indexing *index, uint64_t id, uint16_t name,
	const char *place, struct tcs_fault *fault)
{
	struct step_file *file = index->file;

	if (file->instances.count >= STEP_NONE - 1)
		return fault_set(fault, TCS_LIMIT, offset_of(index, place),
			"more than 4,294,967,294 instances");
	if (array_grow(&file->instances, 1))
		return fault_memory(fault);
	file->instances.at[file->instances.count++] = (struct step_instance){
		id, offset_of(index, place) << 16 | name};
	return TCS_OK;
}

/* Behind the id; NULL for none, or one beyond 64 bits. */
static const char *
id_read(const char *at, const char *end, uint64_t *out)
{
	const char *begin = at;
	uint64_t id = 0;

	for (; at < end && *at >= '0' && *at <= '9'; at++) {
		if (at - begin >= 19)
			return NULL;
		id = id * 10 + (unsigned)(*at - '0');
	}
	*out = id;
	return at == begin ? NULL : at;
}

static enum tcs_status
instance_index(struct indexing *index, struct tcs_fault *fault)
{
	const char *begin = index->at, *end = index->end, *at, *name;
	enum tcs_status status;
	uint16_t number = STEP_COMPLEX;
	uint64_t id;

	at = id_read(begin + 1, end, &id);
	if (!at)
		return statement_skip(
			index, begin, begin + 1, "instance", fault);
	at = step_blank(at, end);
	if (at == end || *at != '=')
		return statement_skip(index, begin, at, "instance", fault);
	name = step_blank(at + 1, end);
	at = step_keyword_end(name, end);
	if (at - name > STEP_MAX_NAME)
		return statement_skip(index, begin, at, "instance", fault);
	if (at > name) {
		status = step_names_intern(&index->file->names, name,
			(size_t)(at - name), &number, fault);
		if (status)
			return status;
	}
	at = step_blank(at, end);
	if (at == end || *at != '(')
		return statement_skip(index, begin, at, "instance", fault);
	status = statement_end(index, begin, at + 1, fault);
	if (status)
		return status;
	return instance_add(index, id, number, at + 1, fault);
}

/* ---- sections ------------------------------------------------------------ */

static const char *const header_names[STEP_HEADERS] = {
	[STEP_DESCRIPTION] = "FILE_DESCRIPTION",
	[STEP_FILE_NAME] = "FILE_NAME",
	[STEP_SCHEMA] = "FILE_SCHEMA",
};

static bool
word_is(const char *at, size_t length, const char *word)
{
	if (strlen(word) != length)
		return false;
	for (size_t i = 0; i < length; i++) {
		char byte = at[i];

		if (byte >= 'a' && byte <= 'z')
			byte = (char)(byte - 'a' + 'A');
		if (byte != word[i])
			return false;
	}
	return true;
}

static void
header_note(struct indexing *index, const char *word, size_t length)
{
	const char *at = step_blank(word + length, index->end);

	if (at == index->end || *at != '(')
		return;
	for (size_t i = 0; i < STEP_HEADERS; i++)
		if (word_is(word, length, header_names[i]) &&
			!index->file->header[i])
			index->file->header[i] = offset_of(index, at + 1);
}

static const char *
word_end(const char *at, const char *end)
{
	const char *last;

	do {
		last = at;
		at = step_keyword_end(at, end);
		if (at < end && *at == '-')
			at++;
	} while (at > last);
	return at;
}

/* The section that a keyword begins or ends; -1 for any other word. */
static int
section_of(const char *word, size_t length)
{
	static const struct {
		const char *word;
		enum section section;
	} words[] = {{"HEADER", HEADER}, {"DATA", DATA}, {"ENDSEC", OUTSIDE},
		{"ANCHOR", OTHER}, {"REFERENCE", OTHER},
		{"END-ISO-10303-21", CLOSED}};

	for (size_t i = 0; i < sizeof words / sizeof *words; i++)
		if (word_is(word, length, words[i].word))
			return (int)words[i].section;
	return -1;
}

static enum tcs_status
keyword_index(struct indexing *index, struct tcs_fault *fault)
{
	const char *word = index->at, *at = word_end(word, index->end);
	size_t length = (size_t)(at - word);
	int section = section_of(word, length);
	enum tcs_status status;

	if (section < 0 && (index->section == DATA || !length))
		return statement_skip(index, word, at, "statement", fault);
	status = statement_end(index, word, at, fault);
	if (status)
		return status;
	if (index->section == HEADER)
		header_note(index, word, length);
	if (section >= 0) {
		index->section = (enum section)section;
		index->section_at = word;
	}
	return TCS_OK;
}

static enum tcs_status
statements_index(struct indexing *index, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	while (!status && index->section != CLOSED) {
		index->at = step_blank(index->at, index->end);
		if (index->at == index->end)
			break;
		if (index->section == DATA && *index->at == '#')
			status = instance_index(index, fault);
		else if (index->section == OTHER && *index->at != 'E')
			status = statement_end(
				index, index->at, index->at, fault);
		else
			status = keyword_index(index, fault);
	}
	return status;
}

static enum tcs_status
file_begin(struct indexing *index, struct tcs_fault *fault)
{
	static const char byte_order_mark[] = "\xef\xbb\xbf";
	const char *at = index->at, *behind;

	if (index->end - at >= 3 && !memcmp(at, byte_order_mark, 3))
		at += 3;
	at = step_blank(at, index->end);
	behind = word_end(at, index->end);
	if (!word_is(at, (size_t)(behind - at), "ISO-10303-21"))
		return fault_set(fault, TCS_BAD_INPUT, 0,
			"not a STEP file: it does not begin with "
			"ISO-10303-21");
	return statement_end(index, at, behind, fault);
}

static enum tcs_status
file_end(struct indexing *index, struct tcs_fault *fault)
{
	if (index->section == CLOSED)
		return TCS_OK;
	if (index->section != OUTSIDE)
		return fault_set(fault, TCS_TRUNCATED,
			offset_of(index, index->section_at),
			"a section does not end");
	if (!index->file->instances.count)
		return fault_set(fault, TCS_TRUNCATED, index->file->length,
			"the file ends before its data");
	return report_item(index->report, REPORT_NOTE, "file",
		"END-ISO-10303-21 is missing", NULL, index->file->length,
		fault);
}

/* ---- the contract -------------------------------------------------------- */

enum tcs_status
step_index(struct step_file *file, const char *text, size_t length,
	struct report *report, struct tcs_fault *fault)
{
	struct indexing index = {.file = file,
		.report = report,
		.at = text,
		.end = text + length,
		.section_at = text};
	enum tcs_status status;

	file->text = text;
	file->length = length;
	if (length >> 48)
		return fault_set(fault, TCS_LIMIT, 0, "the file is too large");
	status = step_names_begin(&file->names, fault);
	if (!status)
		status = file_begin(&index, fault);
	if (!status)
		status = statements_index(&index, fault);
	if (!status)
		status = file_end(&index, fault);
	if (!status)
		status = step_tabulate_ids(file, report, fault);
	if (!status)
		status = step_tabulate_names(file, fault);
	return status;
}

void
step_release(struct step_file *file)
{
	array_release(&file->instances);
	step_names_release(&file->names);
	free(file->by_id);
	free(file->keys);
	free(file->by_name);
	free(file->name_begins);
	*file = (struct step_file){.text = NULL};
}

static struct step_cursor
cursor_at(const struct step_file *file, uint64_t place)
{
	return (struct step_cursor){.at = file->text + place,
		.end = file->text + file->length,
		.depth = 1};
}

struct step_cursor
step_parameters(const struct step_file *file, uint32_t instance)
{
	struct step_cursor cursor = cursor_at(file, step_place(file, instance));

	if (step_name_of(file, instance) == STEP_COMPLEX)
		cursor.state = STEP_BROKEN;
	return cursor;
}

bool
step_part(const struct step_file *file, uint32_t instance, const char *name,
	struct step_cursor *out)
{
	struct step_cursor cursor = cursor_at(file, step_place(file, instance));
	const char *at = cursor.at, *end = cursor.end;

	*out = cursor;
	if (step_name_of(file, instance) != STEP_COMPLEX)
		return !strcmp(step_name_text(file, instance), name);
	while (at) {
		const char *word = step_blank(at, end);
		const char *behind = step_keyword_end(word, end);

		out->at = step_blank(behind, end);
		if (behind == word || out->at == end || *out->at++ != '(')
			return false;
		if (word_is(word, (size_t)(behind - word), name))
			return true;
		at = step_list_end(out->at, end);
	}
	return false;
}

struct step_cursor
step_header_parameters(const struct step_file *file, enum step_header header)
{
	struct step_cursor cursor = cursor_at(file, file->header[header]);

	if (!file->header[header])
		cursor.state = STEP_OVER;
	return cursor;
}
