#include "tcs_codec.h"

#include <string.h>

#include "tcs_pool.h"
#include "utf8.h"

/* ---- sections -------------------------------------------------------- */

enum tcs_status
sections_begin(struct section_walk *walk, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	uint32_t head[2];
	size_t length = record->bytes.count;

	if (length < sizeof head || length % 8)
		return fault_set(fault, TCS_BAD_INPUT, record->at,
			"a record of %zu bytes has no section directory",
			length);
	memcpy(head, record->bytes.at, sizeof head);
	if (head[1] || head[0] > (length - sizeof head) / DIRECTORY_ENTRY)
		return fault_set(fault, TCS_BAD_INPUT, record->at,
			"a record's section directory does not fit it");
	*walk = (struct section_walk){
		.bytes = record->bytes.at,
		.length = length,
		.where = record->at,
		.entry = DIRECTORY_HEAD,
		.entry_end = DIRECTORY_HEAD + DIRECTORY_ENTRY * (size_t)head[0],
	};
	walk->at = walk->entry_end;
	return TCS_OK;
}

enum tcs_status
sections_next(struct section_walk *walk, struct section *out, bool *done,
	struct tcs_fault *fault)
{
	const unsigned char *entry = walk->bytes + walk->entry;

	*done = walk->entry == walk->entry_end;
	if (*done && walk->at != walk->length)
		return fault_set(fault, TCS_BAD_INPUT, walk->where,
			"a record has bytes behind its last section");
	if (*done)
		return TCS_OK;
	memcpy(&out->tag, entry, 4);
	memcpy(&out->size, entry + 4, 4);
	memcpy(&out->count, entry + 8, 8);
	if (!out->size || out->count > (walk->length - walk->at) / out->size)
		return fault_set(fault, TCS_BAD_INPUT, walk->where,
			"section %.4s of a record does not fit it", entry);
	out->at = walk->at;
	walk->at += section_padded(out->count * out->size);
	walk->entry += DIRECTORY_ENTRY;
	return TCS_OK;
}

/* ---- decoding -------------------------------------------------------- */

static void
empty_all(void *kind, const struct tcs_layout *layout)
{
	for (size_t i = 0; i < layout->count; i++)
		array_release_bytes((char *)kind + layout->columns[i].array);
}

static enum tcs_status
lend_sections(void *out, const struct tcs_layout *layout,
	const struct tcs_record *record, struct tcs_fault *fault)
{
	struct section_walk walk;
	struct section section;
	bool done;
	enum tcs_status status = sections_begin(&walk, record, fault);

	while (!status) {
		const struct tcs_column *column;
		struct tcs_array view;

		status = sections_next(&walk, &section, &done, fault);
		if (status || done)
			break;
		column = layout_column(layout, section.tag);
		if (!column || !section.count)
			continue;
		view = layout_array(column, out);
		if (section.size != column->size || view.count)
			return fault_set(fault, TCS_BAD_INPUT, record->at,
				"section %.4s of the %s is there twice or has "
				"elements of %u bytes, not %u",
				(const char *)&section.tag, layout->name,
				section.size, column->size);
		view.at = record->bytes.at + section.at;
		view.count = (size_t)section.count;
		memcpy((char *)out + column->array, &view, sizeof view);
	}
	return status;
}

enum tcs_status
record_paints(struct tcs_record *record, struct tcs_paint **paints,
	size_t *count, struct tcs_fault *fault)
{
	struct section_walk walk;
	struct section section = {0};
	bool done = false;
	enum tcs_status status = sections_begin(&walk, record, fault);

	*paints = NULL;
	*count = 0;
	while (!status && !done && section.tag != TCS_PAINT_TAG)
		status = sections_next(&walk, &section, &done, fault);
	if (status || done)
		return status;
	*paints = (void *)(record->bytes.at + section.at);
	*count = (size_t)section.count;
	return TCS_OK;
}

static enum tcs_status
check_text(
	const struct tcs_array *text, uint64_t where, struct tcs_fault *fault)
{
	const char *at = text->at;

	if (!text->count)
		return TCS_OK;
	if (text->count > UINT32_MAX)
		return fault_set(fault, TCS_BAD_INPUT, where,
			"the text of one record exceeds 4 GiB");
	if (at[0] || at[text->count - 1])
		return fault_set(fault, TCS_BAD_INPUT, where,
			"a record's text does not begin and end with NUL");
	if (!utf8_valid(at, text->count))
		return fault_set(fault, TCS_BAD_INPUT, where,
			"a record's text is not UTF-8");
	return TCS_OK;
}

/* A string begins behind a NUL, and only offset 0 names the empty one. */
static bool
text_begins_at(const struct tcs_array *text, tcs_text offset)
{
	const char *at = text->at;

	return !offset ||
		(offset < text->count && !at[offset - 1] && at[offset]);
}

static enum tcs_status
check_column_text(const struct tcs_column *column, const struct tcs_array *view,
	const struct tcs_array *text, uint64_t where, struct tcs_fault *fault)
{
	const char *element = view->at;

	for (size_t i = 0; i < view->count; i++, element += column->size)
		for (size_t k = 0; k < column->text_count; k++)
			if (!text_begins_at(text,
				    layout_text(element, column->texts[k])))
				return fault_set(fault, TCS_BAD_INPUT, where,
					"element %zu of section %.4s names no "
					"string",
					i, (const char *)&column->tag);
	return TCS_OK;
}

enum tcs_status
layout_check_text(const struct tcs_layout *layout, const void *kind,
	uint64_t where, struct tcs_fault *fault)
{
	const struct tcs_column *text_column =
		layout_column(layout, TCS_TEXT_TAG);
	struct tcs_array text = {0};
	enum tcs_status status = TCS_OK;

	if (text_column)
		text = layout_array(text_column, kind);
	status = check_text(&text, where, fault);
	for (size_t i = 0; !status && i < layout->count; i++) {
		const struct tcs_column *column = &layout->columns[i];
		struct tcs_array view = layout_array(column, kind);

		if (column->text_count)
			status = check_column_text(
				column, &view, &text, where, fault);
	}
	return status;
}

enum tcs_status
record_decode(void *out, const struct tcs_layout *layout,
	const struct tcs_record *record, struct tcs_fault *fault)
{
	enum tcs_status status;

	empty_all(out, layout);
	status = lend_sections(out, layout, record, fault);
	if (!status)
		status = layout_check_text(layout, out, record->at, fault);
	if (status)
		empty_all(out, layout);
	return status;
}

/* ---- encoding -------------------------------------------------------- */

/* Copy one section behind the bytes there are, padded with zeros. */
static void
append_section(struct byte_array *bytes, const struct tcs_column *column,
	const struct tcs_array *view)
{
	size_t length = view->count * column->size;
	size_t padded = (size_t)section_padded(length);

	memcpy(bytes->at + bytes->count, view->at, length);
	memset(bytes->at + bytes->count + length, 0, padded - length);
	bytes->count += padded;
}

static void
set_entry(unsigned char *entry, const struct tcs_column *column, uint64_t count)
{
	memcpy(entry, &column->tag, 4);
	memcpy(entry + 4, &column->size, 4);
	memcpy(entry + 8, &count, 8);
}

static bool
is_written(const struct tcs_column *column, const struct tcs_array *view)
{
	return column->tag == TCS_TEXT_TAG || view->count;
}

/* The directory and all sections but the text, which is the last. */
static enum tcs_status
append_sections(struct byte_array *bytes, const void *kind,
	const struct tcs_layout *layout, struct tcs_fault *fault)
{
	size_t total = DIRECTORY_HEAD, entry = DIRECTORY_HEAD;
	uint32_t head[2] = {0, 0};

	for (size_t i = 0; i < layout->count; i++) {
		const struct tcs_column *column = &layout->columns[i];
		struct tcs_array view = layout_array(column, kind);

		if (!is_written(column, &view))
			continue;
		head[0]++;
		total += (size_t)section_padded(view.count * column->size);
	}
	total += head[0] * (size_t)DIRECTORY_ENTRY + 8;
	bytes->count = 0;
	if (array_grow(bytes, total))
		return fault_memory(fault);
	memcpy(bytes->at, head, sizeof head);
	bytes->count = DIRECTORY_HEAD + head[0] * (size_t)DIRECTORY_ENTRY;
	for (size_t i = 0; i < layout->count; i++) {
		const struct tcs_column *column = &layout->columns[i];
		struct tcs_array view = layout_array(column, kind);

		if (!is_written(column, &view))
			continue;
		set_entry(bytes->at + entry, column, view.count);
		entry += DIRECTORY_ENTRY;
		if (column->tag != TCS_TEXT_TAG)
			append_section(bytes, column, &view);
	}
	return TCS_OK;
}

/*
 * Move the strings that one section names to the pool, and rename them in the
 * section's copy at `at`. Neighbours often name the same string (a theme, an
 * attribute's name), which spares the search.
 */
static enum tcs_status
move_text(struct text_pool *pool, const struct tcs_column *column, size_t at,
	size_t count, const char *text, struct tcs_fault *fault)
{
	tcs_text last[TCS_MAX_TEXTS] = {0}, renamed[TCS_MAX_TEXTS] = {0};

	for (size_t i = 0; i < count; i++, at += column->size) {
		for (size_t k = 0; k < column->text_count; k++) {
			size_t field = at + column->texts[k];
			tcs_text old = layout_text(pool->bytes->at, field);
			enum tcs_status status = TCS_OK;

			if (!old)
				continue;
			if (old != last[k])
				status = pool_intern(
					pool, text + old, &renamed[k], fault);
			if (status)
				return status;
			last[k] = old;
			memcpy(pool->bytes->at + field, &renamed[k],
				sizeof old);
		}
	}
	return TCS_OK;
}

/* Append the text that the sections name, and say in the directory how much. */
static enum tcs_status
append_text(struct byte_array *bytes, const void *kind,
	const struct tcs_layout *layout, struct tcs_fault *fault)
{
	const struct tcs_column *last = &layout->columns[layout->count - 1];
	struct tcs_array text = layout_array(last, kind);
	struct text_pool pool = {0};
	size_t at, entry = DIRECTORY_HEAD, padded;
	uint32_t entries;
	enum tcs_status status = pool_begin(&pool, bytes, fault);

	if (status)
		return status;
	memcpy(&entries, bytes->at, sizeof entries);
	at = DIRECTORY_HEAD + entries * (size_t)DIRECTORY_ENTRY;
	for (size_t i = 0; !status && i + 1 < layout->count; i++) {
		const struct tcs_column *column = &layout->columns[i];
		struct tcs_array view = layout_array(column, kind);

		if (!view.count)
			continue;
		if (column->text_count)
			status = move_text(
				&pool, column, at, view.count, text.at, fault);
		at += (size_t)section_padded(view.count * column->size);
		entry += DIRECTORY_ENTRY;
	}
	pool_release(&pool);
	if (status)
		return status;
	set_entry(bytes->at + entry, last, bytes->count - at);
	padded = (size_t)section_padded(bytes->count) - bytes->count;
	if (array_grow(bytes, padded))
		return fault_memory(fault);
	memset(bytes->at + bytes->count, 0, padded);
	bytes->count += padded;
	return TCS_OK;
}

/* Whether some array of the struct points into the record's bytes. */
static bool
is_lent_by(const void *kind, const struct tcs_layout *layout,
	const struct tcs_record *record)
{
	uintptr_t from = (uintptr_t)record->bytes.at;
	uintptr_t to = from + record->bytes.room;

	for (size_t i = 0; i < layout->count; i++) {
		struct tcs_array view = layout_array(&layout->columns[i], kind);
		uintptr_t at = (uintptr_t)view.at;

		if (view.count && at >= from && at < to)
			return true;
	}
	return false;
}

static void
swap_bytes(struct tcs_record *record)
{
	struct tcs_array bytes;

	memcpy(&bytes, &record->bytes, sizeof bytes);
	memcpy(&record->bytes, &record->spare, sizeof bytes);
	memcpy(&record->spare, &bytes, sizeof bytes);
}

enum tcs_status
record_encode(const void *kind, const struct tcs_layout *layout,
	struct tcs_record *record, struct tcs_fault *fault)
{
	const struct tcs_column *last = &layout->columns[layout->count - 1];
	bool lent = is_lent_by(kind, layout, record);
	struct byte_array bytes;
	enum tcs_status status;

	if (lent)
		swap_bytes(record);
	memcpy(&bytes, &record->bytes, sizeof bytes);
	status = append_sections(&bytes, kind, layout, fault);
	if (!status && last->tag == TCS_TEXT_TAG)
		status = append_text(&bytes, kind, layout, fault);
	memcpy(&record->bytes, &bytes, sizeof bytes);
	if (status && lent)
		swap_bytes(record);
	return status;
}

/* ---- counting -------------------------------------------------------- */

/* The count that a section adds to; NULL for none. */
static uint64_t *
tally_of(struct tcs_tally *tally, uint32_t type, uint32_t tag)
{
	bool palette = type == TCS_PALETTE;

	switch (tag) {
	case TCS_TAG('F', 'E', 'A', 'T'):
		return palette ? NULL : &tally->features;
	case TCS_TAG('P', 'O', 'L', 'Y'):
		return palette ? NULL : &tally->polygons;
	case TCS_TAG('T', 'R', 'I', 'A'):
		return palette ? NULL : &tally->triangles;
	case TCS_TAG('I', 'N', 'S', 'T'):
		return palette ? NULL : &tally->instances;
	case TCS_TAG('I', 'M', 'A', 'G'):
		return palette ? &tally->images : NULL;
	case TCS_TAG('M', 'A', 'T', 'L'):
		return palette ? &tally->materials : NULL;
	default:
		return NULL;
	}
}

enum tcs_status
tally_add(struct tcs_tally *tally, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	struct section_walk walk;
	struct section section;
	enum tcs_status status;
	bool done;

	if (record->type != TCS_OBJECT && record->type != TCS_PROTOTYPE &&
		record->type != TCS_PALETTE)
		return TCS_OK;
	status = sections_begin(&walk, record, fault);
	while (!status) {
		uint64_t *count;

		status = sections_next(&walk, &section, &done, fault);
		if (status || done)
			break;
		count = tally_of(tally, record->type, section.tag);
		if (count)
			*count += section.count;
	}
	if (status)
		return status;
	tally->objects += record->type == TCS_OBJECT;
	tally->prototypes += record->type == TCS_PROTOTYPE;
	return TCS_OK;
}
