/*
 * Bytes to libxml2: where they stand, how much it gets at once, and how.
 */
#include <limits.h>
#include <string.h>

#include <libxml/parserInternals.h>

#include "citygml_xml_parser.h"
#include "newlines.h"

/* ---- places ---------------------------------------------------------------- */

/* The input of a context that takes bytes as they come; else NULL. */
static const xmlParserInput *
xml_input_as_fed(const struct xml_parser *parser)
{
	const xmlParserInput *input =
		parser->context ? parser->context->input : NULL;

	if (!input || parser->in_piece)
		return input;
	return input->buf && !input->buf->encoder ? input : NULL;
}

bool
xml_place_end(const struct xml_parser *parser, uint64_t *end)
{
	const xmlParserInput *input = xml_input_as_fed(parser);
	const struct plain_element *plain = &parser->plain;

	if (plain->first) {
		*end = parser->fed + (uint64_t)(plain->at - plain->first);
		return true;
	}
	*end = input ? parser->fed - (uint64_t)(input->end - input->cur) : 0;
	return input;
}

/* The line was counted up to the parser; the tag is behind. */
static void
plain_place_tag(struct xml_parser *parser, struct xml_stretch *tag)
{
	const struct plain_element *plain = &parser->plain;
	size_t length = (size_t)(plain->at - plain->tag);

	tag->line =
		xml_line(parser) - (uint32_t)newlines_count(plain->tag, length);
	tag->at = parser->fed + (uint64_t)(plain->tag - plain->first);
	tag->end = tag->at + length + 1;
}

/* The parser stands before the end of the tag; no value of it has a '<'. */
bool
xml_place_tag(struct xml_parser *parser, struct xml_stretch *tag)
{
	const xmlParserInput *input = xml_input_as_fed(parser);
	const xmlChar *first;

	*tag = (struct xml_stretch){0};
	if (parser->plain.first) {
		plain_place_tag(parser, tag);
		return true;
	}
	if (!input)
		return false;
	tag->line = xml_line(parser);
	for (first = input->cur; first > input->base && *first != '<'; first--)
		tag->line -= *first == '\n';
	tag->end = parser->fed - (uint64_t)(input->end - input->cur) + 1;
	tag->at = tag->end - 1 - (uint64_t)(input->cur - first);
	return true;
}

void
xml_move(struct xml_parser *parser, uint64_t at, uint32_t line)
{
	parser->fed = at;
	if (parser->context && parser->context->input)
		parser->context->input->line = (int)line;
}

/* ---- bytes ------------------------------------------------------------------ */

/* The context takes its first bytes at once, to see the encoding. */
static enum tcs_status
xml_begin(struct xml_parser *parser, const char *bytes, int length)
{
	xmlSAXHandler callbacks = xml_callbacks();

	parser->context = xmlCreatePushParserCtxt(
		&callbacks, parser, bytes, length, NULL);
	if (!parser->context)
		return fault_memory(&parser->fault);
	parser->fed += (uint64_t)length;
	xmlCtxtUseOptions(parser->context,
		XML_PARSE_HUGE | XML_PARSE_NONET | XML_PARSE_NOENT);
	return TCS_OK;
}

/*
 * libxml2 looks at an unfinished tag or comment anew, from its first byte, each
 * time more of it comes. So more is held back until it is as long again, and
 * the whole takes time in proportion.
 */
static size_t
xml_pending(const struct xml_parser *parser)
{
	const xmlParserInput *input = parser->context->input;

	return input ? (size_t)(input->end - input->cur) : 0;
}

/* Attributes on one tag, whose names libxml2 compares each with each. */
#define MAX_VALUES 2000

static void
scan_bytes(struct tag_scan *scan, const char *at, size_t length)
{
	for (const char *end = at + length; scan->open && at < end; at++) {
		if (scan->quote) {
			if (*at == scan->quote)
				scan->quote = 0;
		} else if (*at == '"' || *at == '\'') {
			scan->quote = *at;
			scan->values++;
		} else if (*at == '>') {
			scan->open = false;
		}
	}
}

/* A tag that the parser waits for the end of; bytes that come are scanned. */
static void
scan_begin(struct xml_parser *parser, size_t pending)
{
	const char *at;

	parser->scan = (struct tag_scan){0};
	if (pending < 2)
		return;
	at = (const char *)parser->context->input->cur;
	parser->scan.open = at[0] == '<' && at[1] != '!' && at[1] != '?';
	scan_bytes(&parser->scan, at, pending);
}

static enum tcs_status
xml_check_tag(struct xml_parser *parser, size_t length)
{
	if (length > parser->limits->tag)
		return fault_set(&parser->fault, TCS_LIMIT, TCS_NOWHERE,
			"line %u: a tag or comment is longer than %llu bytes "
			"(--max-tag)",
			xml_line(parser),
			(unsigned long long)parser->limits->tag);
	if (parser->scan.values > MAX_VALUES)
		return fault_set(&parser->fault, TCS_LIMIT, TCS_NOWHERE,
			"line %u: an element has more than %d attributes",
			xml_line(parser), MAX_VALUES);
	return TCS_OK;
}

/* Different names of elements, attributes and namespaces, all kept. */
#define MAX_NAMES 50000

enum tcs_status
xml_check_names(struct xml_parser *parser)
{
	xmlDictPtr parts = parser->namespaces.parts;

	if (xmlDictSize(parser->context->dict) <= MAX_NAMES &&
		(!parts || xmlDictSize(parts) <= MAX_NAMES))
		return TCS_OK;
	return fault_set(&parser->fault, TCS_LIMIT, TCS_NOWHERE,
		"line %u: there are more than %d different names",
		xml_line(parser), MAX_NAMES);
}

/* A carriage return at the end of a chunk is kept back while it is parsed. */
static void
xml_parse_part(
	struct xml_parser *parser, const char *bytes, int length, bool end)
{
	bool kept = length && !end && bytes[length - 1] == '\r';

	parser->fed += (uint64_t)(length - kept);
	xmlParseChunk(parser->context, bytes, length, end);
	parser->fed += kept;
}

static enum tcs_status
xml_parse(
	struct xml_parser *parser, const char *bytes, size_t length, bool last)
{
	while (!parser->status && (length || last)) {
		int part = length > INT_MAX / 2 ? INT_MAX / 2 : (int)length;
		bool end = last && (size_t)part == length;

		xml_parse_part(parser, bytes, part, end);
		if (!parser->status && !parser->context->wellFormed)
			parser->status = xml_malformed(
				parser, xmlCtxtGetLastError(parser->context));
		if (!parser->status)
			parser->status = xml_check_names(parser);
		if (end)
			break;
		bytes += part;
		length -= (size_t)part;
	}
	parser->held.count = 0;
	if (!parser->status && !last)
		scan_begin(parser, xml_pending(parser));
	return parser->status;
}

/* Parse what was held back and the bytes, or hold them back too. */
static enum tcs_status
xml_push(struct xml_parser *parser, const char *bytes, size_t length, bool last)
{
	size_t pending = xml_pending(parser);
	size_t held = parser->held.count + length;

	if (length)
		scan_bytes(&parser->scan, bytes, length);
	parser->status = xml_check_tag(
		parser, pending > length ? pending + held : pending);
	if (parser->status || (!parser->held.count && length >= pending))
		return parser->status ? parser->status
				      : xml_parse(parser, bytes, length, last);
	if (array_grow(&parser->held, length))
		return fault_memory(&parser->fault);
	if (length)
		memcpy(parser->held.at + parser->held.count, bytes, length);
	parser->held.count = held;
	if (!last && held < pending)
		return TCS_OK;
	return xml_parse(parser, parser->held.at, held, last);
}

/* ---- pieces of content ------------------------------------------------------- */

/*
 * Pushing bytes costs libxml2 a search for the end of every tag before it
 * parses the tag. Its function for the content of an element, which reads on as
 * long as it gets something, does without; it gets a piece of the content of
 * elements that are open, from markup to markup. It returns early at the end
 * tag of an element that began in an earlier piece, which is pushed, and it
 * takes it for an error that elements of the piece go on: see xml_error.
 */
static bool
xml_takes_pieces(const struct xml_parser *parser)
{
	const xmlParserCtxt *context = parser->context;

	return context->instate == XML_PARSER_CONTENT &&
		context->inputNr == 1 && xml_input_as_fed(parser) &&
		!xml_pending(parser);
}

/* What the parser could wait for the end of, or what may hold a '<'. */
static bool
has_declaration(const char *at, const char *end, char mark)
{
	while ((at = memchr(at, mark, (size_t)(end - at)))) {
		if (at[-1] == '<')
			return true;
		at++;
	}
	return false;
}

/* The last '<', before which all is text and whole tags; NULL for none. */
static char *
piece_end(char *at, char *end)
{
	char *last = end - 1;

	while (last > at && *last != '<')
		last--;
	if (last <= at || has_declaration(at + 1, end, '!') ||
		has_declaration(at + 1, end, '?'))
		return NULL;
	return last;
}

/* That elements go on behind the piece is forgiven. */
static enum tcs_status
piece_check(struct xml_parser *parser)
{
	if (!parser->status && parser->malformed)
		parser->status = TCS_BAD_INPUT;
	if (parser->status)
		return parser->status;
	parser->context->wellFormed = 1;
	parser->context->disableSAX = 0;
	parser->context->errNo = XML_ERR_OK;
	parser->status = xml_check_names(parser);
	return parser->status;
}

/* Parse from *at to `end`, where a byte may be written; *at moves as far. */
static enum tcs_status
piece_parse(struct xml_parser *parser, char **at, char *end)
{
	xmlParserCtxtPtr context = parser->context;
	xmlParserInputPtr fed = context->input;
	xmlParserInputPtr piece = xmlNewInputStream(context);
	const char first = *end;

	if (!piece)
		return fault_memory(&parser->fault);
	inputPop(context);
	*end = '\0';
	piece->base = piece->cur = (const xmlChar *)*at;
	piece->end = (const xmlChar *)end;
	piece->line = fed->line;
	inputPush(context, piece);
	parser->fed += (uint64_t)(end - *at);
	parser->in_piece = true;
	xmlParseContent(context);
	parser->in_piece = false;
	*end = first;
	fed->line = piece->line;
	if (!parser->status) {
		parser->fed -= (uint64_t)(piece->end - piece->cur);
		*at = end - (piece->end - piece->cur);
	}
	inputPop(context);
	xmlFreeInputStream(piece);
	inputPush(context, fed);
	return piece_check(parser);
}

bool
xml_is_between(const struct xml_parser *parser)
{
	return !parser->status && parser->context && parser->depth == 1 &&
		!parser->skipped && !parser->held.count &&
		xml_takes_pieces(parser);
}

/* A tag that is not short has a stretch without '<', as long text has. */
#define STRETCH (32 * 1024)

static bool
has_stretch(const char *at, size_t length)
{
	for (; length > 2 * STRETCH; at += STRETCH, length -= STRETCH)
		if (!memchr(at, '<', STRETCH))
			return true;
	return false;
}

enum tcs_status
xml_feed_element(struct xml_parser *parser, char *bytes, size_t length,
	bool *whole, struct tcs_fault *fault)
{
	char *end = bytes + length;
	bool plain;

	*whole = false;
	if (parser->status || !xml_is_between(parser) ||
		has_stretch(bytes, length))
		return TCS_OK;
	if (!xml_read_plain(parser, bytes, length, &plain, whole) && !plain) {
		if (!piece_parse(parser, &bytes, end))
			*whole = bytes == end && xml_is_between(parser);
	}
	if (parser->status)
		*fault = parser->fault;
	return parser->status;
}

/* All up to `cut`, piece by piece and end tag by end tag. */
static enum tcs_status
pieces_parse(struct xml_parser *parser, char **at, char *cut)
{
	while (*at < cut && xml_takes_pieces(parser)) {
		enum tcs_status status = piece_parse(parser, at, cut);
		const char *tag_end;

		if (status || *at == cut)
			return status;
		tag_end = memchr(*at, '>', (size_t)(cut - *at));
		if (!tag_end || (*at)[0] != '<' || (*at)[1] != '/')
			return TCS_OK;
		status = xml_parse(
			parser, *at, (size_t)(tag_end + 1 - *at), false);
		if (status)
			return status;
		*at += tag_end + 1 - *at;
	}
	return TCS_OK;
}

/* Bytes kept for the next piece; an unfinished tag beyond that is pushed. */
#define KEPT_MAX 1024

static enum tcs_status
xml_feed_pieces(struct xml_parser *parser, const char *bytes, size_t length)
{
	char *at, *end, *cut;

	if (array_grow(&parser->held, length))
		return fault_memory(&parser->fault);
	memcpy(parser->held.at + parser->held.count, bytes, length);
	parser->held.count += length;
	at = parser->held.at;
	end = at + parser->held.count;
	cut = piece_end(at, end);
	if (cut && pieces_parse(parser, &at, cut))
		return parser->status;
	length = (size_t)(end - at);
	if (at != cut || length > KEPT_MAX)
		return xml_parse(parser, at, length, false);
	memmove(parser->held.at, at, length);
	parser->held.count = length;
	return TCS_OK;
}

/* What the parser waits for is pushed up to the next '>', if that is enough. */
static enum tcs_status
xml_feed_more(struct xml_parser *parser, const char *bytes, size_t length)
{
	const char *tag_end = memchr(bytes, '>', length);
	size_t waited = tag_end ? (size_t)(tag_end + 1 - bytes) : length;

	if (!xml_takes_pieces(parser)) {
		parser->status = xml_push(parser, bytes, waited, false);
		bytes += waited;
		length -= waited;
	}
	if (parser->status || !length)
		return parser->status;
	return xml_takes_pieces(parser)
		? xml_feed_pieces(parser, bytes, length)
		: xml_push(parser, bytes, length, false);
}

enum tcs_status
xml_settle(struct xml_parser *parser, struct tcs_fault *fault)
{
	if (!parser->status && parser->held.count && xml_takes_pieces(parser))
		parser->status = xml_parse(
			parser, parser->held.at, parser->held.count, false);
	if (parser->status)
		*fault = parser->fault;
	return parser->status;
}

enum tcs_status
xml_feed(struct xml_parser *parser, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	bool last = length == 0;

	if (!parser->context && !parser->status) {
		int first = length < 4 ? (int)length : 4;

		parser->status = xml_begin(parser, bytes, first);
		bytes += first;
		length -= (size_t)first;
	}
	if (!parser->status && length)
		parser->status = xml_feed_more(parser, bytes, length);
	else if (!parser->status && last)
		parser->status = xml_push(parser, bytes, 0, true);
	if (parser->status)
		*fault = parser->fault;
	return parser->status;
}
