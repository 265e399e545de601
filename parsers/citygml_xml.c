#include <stdlib.h>
#include <string.h>

#include "citygml_xml_parser.h"

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
		"line %u: elements nest deeper than %u%s", xml_line(parser),
		parser->limits->depth,
		parser->limits->fixed ? "" : " (--max-depth)");
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

/*
 * Asked for what is not predefined, and nothing else is declared. Where a
 * document type stands outside, libxml2 would pass over the reference.
 */
static xmlEntityPtr
xml_entity(void *user, const xmlChar *name)
{
	struct xml_parser *parser = user;

	if (!parser->status)
		xml_stop(parser,
			fault_set(&parser->fault, TCS_BAD_INPUT, TCS_NOWHERE,
				"line %u: not well-formed XML: Entity "
				"'%.60s' not defined",
				xml_line(parser), plain(name)));
	return NULL;
}

enum tcs_status
xml_malformed(struct xml_parser *parser, const xmlError *error)
{
	const char *text =
		error && error->message ? error->message : "not well-formed";
	int line = error ? error->line : 1;

	return fault_set(&parser->fault, TCS_BAD_INPUT, TCS_NOWHERE,
		"line %d: not well-formed XML: %.*s", line,
		(int)strcspn(text, "\n"), text);
}

/*
 * Errors are collected by libxml2 and read from its context, but for the first
 * of a piece; that a piece ends within an element is none.
 */
static void
xml_error(void *user, xmlErrorPtr error)
{
	struct xml_parser *parser = user;

	if (!parser->in_piece || parser->malformed || parser->status ||
		error->level < XML_ERR_FATAL ||
		error->code == XML_ERR_TAG_NOT_FINISHED)
		return;
	parser->malformed = xml_malformed(parser, error) != TCS_OK;
}

xmlSAXHandler
xml_callbacks(void)
{
	return (xmlSAXHandler){
		.initialized = XML_SAX2_MAGIC,
		.startElementNs = xml_start,
		.endElementNs = xml_end,
		.characters = xml_text,
		.ignorableWhitespace = xml_text,
		.cdataBlock = xml_text,
		.getEntity = xml_entity,
		.entityDecl = xml_entity_declared,
		.attributeDecl = xml_attribute_declared,
		.serror = xml_error,
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
