#include "citygml_xml.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include <libxml/parser.h>
#include <libxml/parserInternals.h>

#include "array.h"

/* A start tag that is too long for one piece, seen from outside. */
struct tag_scan {
	bool open; /* it has begun, and not ended */
	char quote; /* that ends the value; 0 between values */
	unsigned values;
};

struct xml_parser {
	const struct xml_handler *handler;
	const struct xml_limits *limits;
	struct names *names;
	xmlParserCtxtPtr context; /* made with the first bytes */
	TCS_ARRAY(struct xml_attribute) attributes;
	struct tcs_fault fault; /* the first failure */
	enum tcs_status status;
	bool began; /* the root element has been seen */
	unsigned depth; /* open elements */
	unsigned skipped; /* of these, in a subtree that is skipped */
	TCS_ARRAY(char) held; /* to be parsed together with more */
	struct tag_scan scan;
	uint64_t fed; /* where the bytes end that libxml2 has got */
};

static void
xml_stop(struct xml_parser *parser, enum tcs_status status)
{
	parser->status = status;
	xmlStopParser(parser->context);
}

static const char *
plain(const xmlChar *text)
{
	return (const char *)text;
}

/* Which CityGML the root or its namespace declarations speak of. */
static void
xml_find_version(struct xml_parser *parser, const xmlChar *local,
	const xmlChar *uri, int count, const xmlChar **namespaces)
{
	const char *version = names_version(plain(uri));

	parser->began = true;
	if (uri && !version && !strcmp(plain(local), "CityModel"))
		parser->names->adopted = plain(uri);
	for (int i = 0; !version && i < count; i++)
		version = names_version(plain(namespaces[2 * i + 1]));
	if (!version)
		return;
	parser->names->spelled = version;
	parser->names->version = *version == '3' ? 3 : 2;
}

static enum tcs_status
xml_take_attributes(
	struct xml_parser *parser, int count, const xmlChar **attributes)
{
	parser->attributes.count = 0;
	if (array_grow(&parser->attributes, (size_t)count))
		return fault_memory(&parser->fault);
	for (int i = 0; i < count; i++) {
		const xmlChar **five = attributes + (size_t)i * 5;

		parser->attributes.at[i] = (struct xml_attribute){
			.local = plain(five[0]),
			.prefix = plain(five[1]),
			.uri = plain(five[2]),
			.value = plain(five[3]),
			.length = (size_t)(five[4] - five[3]),
		};
	}
	parser->attributes.count = (size_t)count;
	return TCS_OK;
}

static enum tcs_status
xml_too_deep(struct xml_parser *parser)
{
	return fault_set(&parser->fault, TCS_LIMIT, TCS_NOWHERE,
		"line %u: elements nest deeper than %u (--max-depth)",
		xml_line(parser), parser->limits->depth);
}

static void
xml_start(void *user, const xmlChar *local, const xmlChar *prefix,
	const xmlChar *uri, int namespace_count, const xmlChar **namespaces,
	int attribute_count, int defaulted, const xmlChar **attributes)
{
	struct xml_parser *parser = user;
	enum tcs_status status;
	struct name *name;
	bool skip = false;

	(void)defaulted;
	if (parser->status)
		return;
	if (++parser->depth > parser->limits->depth) {
		xml_stop(parser, xml_too_deep(parser));
		return;
	}
	if (parser->skipped) {
		parser->skipped++;
		return;
	}
	if (!parser->began)
		xml_find_version(
			parser, local, uri, namespace_count, namespaces);
	name = names_find(
		parser->names, plain(local), plain(prefix), plain(uri));
	status = name ? xml_take_attributes(parser, attribute_count, attributes)
		      : fault_memory(&parser->fault);
	if (!status)
		status = parser->handler->start(parser->handler->context, name,
			parser->attributes.at, parser->attributes.count, &skip,
			&parser->fault);
	parser->skipped = skip;
	if (status)
		xml_stop(parser, status);
}

static void
xml_end(void *user, const xmlChar *local, const xmlChar *prefix,
	const xmlChar *uri)
{
	struct xml_parser *parser = user;
	enum tcs_status status;

	(void)local;
	(void)prefix;
	(void)uri;
	if (parser->status)
		return;
	parser->depth--;
	if (parser->skipped) {
		parser->skipped--;
		return;
	}
	status = parser->handler->end(parser->handler->context, &parser->fault);
	if (status)
		xml_stop(parser, status);
}

static void
xml_text(void *user, const xmlChar *bytes, int length)
{
	struct xml_parser *parser = user;
	enum tcs_status status;

	if (parser->status || parser->skipped)
		return;
	status = parser->handler->text(parser->handler->context, plain(bytes),
		(size_t)length, &parser->fault);
	if (status)
		xml_stop(parser, status);
}

static void
xml_entity_declared(void *user, const xmlChar *name, int type,
	const xmlChar *public_id, const xmlChar *system_id, xmlChar *content)
{
	struct xml_parser *parser = user;

	(void)type;
	(void)public_id;
	(void)system_id;
	(void)content;
	if (!parser->status)
		xml_stop(parser,
			fault_set(&parser->fault, TCS_BAD_INPUT, TCS_NOWHERE,
				"line %u: entity declarations are refused: "
				"%.60s",
				xml_line(parser), plain(name)));
}

static void
xml_attribute_declared(void *user, const xmlChar *element, const xmlChar *name,
	int type, int kind, const xmlChar *value, xmlEnumerationPtr choices)
{
	struct xml_parser *parser = user;

	(void)name;
	(void)type;
	(void)kind;
	(void)value;
	xmlFreeEnumeration(choices);
	if (!parser->status)
		xml_stop(parser,
			fault_set(&parser->fault, TCS_BAD_INPUT, TCS_NOWHERE,
				"line %u: attribute declarations are refused: "
				"%.60s",
				xml_line(parser), plain(element)));
}

/* Errors are collected by libxml2 and read from its context. */
static void
xml_quiet(void *user, xmlErrorPtr error)
{
	(void)user;
	(void)error;
}

static xmlSAXHandler
xml_callbacks(void)
{
	return (xmlSAXHandler){
		.initialized = XML_SAX2_MAGIC,
		.startElementNs = xml_start,
		.endElementNs = xml_end,
		.characters = xml_text,
		.ignorableWhitespace = xml_text,
		.cdataBlock = xml_text,
		.entityDecl = xml_entity_declared,
		.attributeDecl = xml_attribute_declared,
		.serror = xml_quiet,
	};
}

struct xml_parser *
xml_new(const struct xml_handler *handler, const struct xml_limits *limits,
	struct names *names)
{
	struct xml_parser *parser = calloc(1, sizeof *parser);

	if (!parser)
		return NULL;
	parser->handler = handler;
	parser->limits = limits;
	parser->names = names;
	return parser;
}

void
xml_free(struct xml_parser *parser)
{
	if (!parser)
		return;
	names_release(parser->names);
	if (parser->context) {
		if (parser->context->myDoc)
			xmlFreeDoc(parser->context->myDoc);
		xmlFreeParserCtxt(parser->context);
	}
	array_release(&parser->attributes);
	array_release(&parser->held);
	free(parser);
}

uint32_t
xml_line(const struct xml_parser *parser)
{
	if (!parser->context || !parser->context->input)
		return 1;
	return (uint32_t)parser->context->input->line;
}

/* ---- places ---------------------------------------------------------------- */

/* The input of a context that takes bytes as they come; else NULL. */
static const xmlParserInput *
xml_input_as_fed(const struct xml_parser *parser)
{
	const xmlParserInput *input =
		parser->context ? parser->context->input : NULL;

	return input && input->buf && !input->buf->encoder ? input : NULL;
}

bool
xml_place_end(const struct xml_parser *parser, uint64_t *end)
{
	const xmlParserInput *input = xml_input_as_fed(parser);

	*end = input ? parser->fed - (uint64_t)(input->end - input->cur) : 0;
	return input;
}

/* The parser stands before the end of the tag; no value of it has a '<'. */
bool
xml_place_tag(const struct xml_parser *parser, struct xml_stretch *tag)
{
	const xmlParserInput *input = xml_input_as_fed(parser);
	const xmlChar *first;

	*tag = (struct xml_stretch){0};
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

static enum tcs_status
xml_malformed(struct xml_parser *parser)
{
	const xmlError *error = xmlCtxtGetLastError(parser->context);
	const char *text =
		error && error->message ? error->message : "not well-formed";
	int line = error ? error->line : 1;

	return fault_set(&parser->fault, TCS_BAD_INPUT, TCS_NOWHERE,
		"line %d: not well-formed XML: %.*s", line,
		(int)strcspn(text, "\n"), text);
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

/* Values of attributes on one tag, which libxml2 compares each with each. */
#define MAX_VALUES 20000

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
	at = plain(parser->context->input->cur);
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

static enum tcs_status
xml_check_names(struct xml_parser *parser)
{
	if (xmlDictSize(parser->context->dict) <= MAX_NAMES)
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
			parser->status = xml_malformed(parser);
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
	if (!parser->status && (length || last))
		parser->status = xml_push(parser, bytes, length, last);
	if (parser->status)
		*fault = parser->fault;
	return parser->status;
}
