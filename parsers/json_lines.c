#include "json_lines.h"

#include <string.h>

#define CHUNK ((size_t)64 << 10)

void
lines_release(struct line_reader *reader)
{
	array_release(&reader->buffer);
}

/* Read the next chunk into the empty buffer. */
static enum tcs_status
fill(struct line_reader *reader, struct tcs_fault *fault)
{
	enum tcs_status status;
	size_t got;

	reader->at = 0;
	array_clear(&reader->buffer);
	if (array_grow(&reader->buffer, CHUNK))
		return fault_memory(fault);
	status = input_read(
		reader->input, reader->buffer.at, CHUNK, &got, fault);
	if (status)
		return status;
	reader->buffer.count = got;
	reader->ended = got == 0;
	return TCS_OK;
}

/* One line, blank or not; *whole unless the input ended before its first. */
static enum tcs_status
take_line(struct line_reader *reader, struct line_bytes *out, bool *whole,
	struct tcs_fault *fault)
{
	out->count = 0;
	*whole = false;
	for (;;) {
		size_t left = reader->buffer.count - reader->at;
		const char *from = left ? reader->buffer.at + reader->at : NULL;
		const char *end = left ? memchr(from, '\n', left) : NULL;
		size_t length = end ? (size_t)(end - from) : left;

		if (length > reader->max_line - out->count)
			return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
				"line %llu: more than %llu bytes",
				(unsigned long long)reader->line + 1,
				(unsigned long long)reader->max_line);
		if (array_grow(out, length))
			return fault_memory(fault);
		if (length)
			memcpy(out->at + out->count, from, length);
		out->count += length;
		reader->at += length + (end != NULL);
		if (end || (reader->ended && out->count)) {
			*whole = true;
			reader->line++;
			return TCS_OK;
		}
		if (reader->ended)
			return TCS_OK;
		if (fill(reader, fault))
			return fault->status;
	}
}

static bool
is_blank(const struct line_bytes *line)
{
	for (size_t i = 0; i < line->count; i++)
		if (!strchr(" \t\r", line->at[i]) || !line->at[i])
			return false;
	return true;
}

enum tcs_status
lines_next(struct line_reader *reader, struct line_bytes *out, bool *done,
	struct tcs_fault *fault)
{
	bool whole;

	do {
		enum tcs_status status = take_line(reader, out, &whole, fault);

		if (status)
			return status;
	} while (whole && is_blank(out));
	*done = !whole;
	return TCS_OK;
}
