/*
 * Any bytes as one element: where it is read as a whole, by itself, its events
 * and their places are those of a parser that gets it piece by piece. The first
 * byte says how large the pieces are.
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "parsers/citygml_xml.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* What was heard, and where. */
struct heard {
	struct names names;
	struct xml_parser *parser;
	TCS_ARRAY(char) bytes;
	bool in_text;
};

static void
note(struct heard *heard, const void *bytes, size_t length)
{
	if (array_grow(&heard->bytes, length))
		abort();
	if (length)
		memcpy(heard->bytes.at + heard->bytes.count, bytes, length);
	heard->bytes.count += length;
}

static void
note_text(struct heard *heard, const char *text)
{
	note(heard, text ? text : "(none)", text ? strlen(text) + 1 : 7);
}

static enum tcs_status
hear_start(void *context, struct name *name,
	const struct xml_attribute *attributes, size_t count, bool *skip,
	struct tcs_fault *fault)
{
	struct heard *heard = context;
	uint32_t line = xml_line(heard->parser);
	struct xml_stretch tag;

	(void)fault;
	xml_place_tag(heard->parser, &tag);
	note(heard, "\nstart ", 7);
	note(heard, &line, sizeof line);
	note(heard, &tag.at, sizeof tag.at);
	note(heard, &tag.end, sizeof tag.end);
	note(heard, &tag.line, sizeof tag.line);
	note_text(heard, name->prefix);
	note_text(heard, name->local);
	note_text(heard, name->uri);
	for (size_t i = 0; i < count; i++) {
		note_text(heard, attributes[i].prefix);
		note_text(heard, attributes[i].local);
		note(heard, attributes[i].value, attributes[i].length);
		note(heard, "", 1);
	}
	heard->in_text = false;
	*skip = !strcmp(name->local, "skip");
	return TCS_OK;
}

static enum tcs_status
hear_end(void *context, struct tcs_fault *fault)
{
	struct heard *heard = context;
	uint64_t end;

	(void)fault;
	xml_place_end(heard->parser, &end);
	note(heard, "\nend ", 5);
	note(heard, &end, sizeof end);
	heard->in_text = false;
	return TCS_OK;
}

static enum tcs_status
hear_text(void *context, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	struct heard *heard = context;

	(void)fault;
	if (length && !heard->in_text)
		note(heard, "\ntext ", 6);
	heard->in_text |= length > 0;
	note(heard, bytes, length);
	return TCS_OK;
}

static void
hear(struct heard *heard, const struct xml_handler *handler,
	const struct xml_limits *limits)
{
	static const char head[] = "<root xmlns:g=\"g\" xmlns=\"h\">";
	struct tcs_fault fault;

	heard->parser = xml_new(handler, limits, &heard->names);
	if (!heard->parser ||
		xml_feed(heard->parser, head, sizeof head - 1, &fault) ||
		xml_settle(heard->parser, &fault))
		abort();
}

static void
heard_release(struct heard *heard)
{
	xml_free(heard->parser);
	array_release(&heard->bytes);
}

static enum tcs_status
feed_pieces(struct xml_parser *parser, const char *bytes, size_t size,
	size_t piece, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	while (!status && size) {
		size_t length = size < piece ? size : piece;

		status = xml_feed(parser, bytes, length, fault);
		bytes += length;
		size -= length;
	}
	return status;
}

static void
feed_end(struct xml_parser *parser)
{
	struct tcs_fault fault;

	if (xml_feed(parser, "</root>", 7, &fault) ||
		xml_feed(parser, NULL, 0, &fault))
		abort();
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	const struct xml_limits limits = {.depth = 64, .tag = 1 << 20};
	struct heard one = {.names.version = 2}, two = {.names.version = 2};
	const struct xml_handler first = {
		&one, hear_start, hear_end, hear_text, NULL};
	const struct xml_handler second = {
		&two, hear_start, hear_end, hear_text, NULL};
	struct tcs_fault fault;
	bool whole = false;
	char *bytes;

	/* What becomes of a return in CDATA depends on the pieces. */
	if (size < 2 || (memchr(data, '\r', size) && memchr(data, '!', size)))
		return 0;
	bytes = malloc(size);
	if (!bytes)
		return 0;
	memcpy(bytes, data + 1, size - 1);
	hear(&one, &first, &limits);
	if (!xml_is_between(one.parser))
		abort();
	if (xml_feed_element(one.parser, bytes, size - 1, &whole, &fault))
		whole = false;
	if (whole) {
		hear(&two, &second, &limits);
		if (feed_pieces(
			    two.parser, bytes, size - 1, data[0] + 1u, &fault))
			abort();
		feed_end(one.parser);
		feed_end(two.parser);
		if (memcmp(bytes, data + 1, size - 1) != 0 ||
			one.bytes.count != two.bytes.count ||
			memcmp(one.bytes.at, two.bytes.at, one.bytes.count))
			abort();
	}
	heard_release(&one);
	heard_release(&two);
	free(bytes);
	return 0;
}
