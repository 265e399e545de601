#include <stdlib.h>
#include <string.h>

#include "citygml_xml_parser.h"
#include "newlines.h"

void
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
xml_find_version(struct xml_parser *parser, const struct spelling *root)
{
	const struct namespaces *namespaces = &parser->namespaces;
	const char *uri = namespace_find(namespaces, root->prefix);
	const char *version = names_version(uri);

	parser->began = true;
	if (uri && !version && !strcmp(root->local, "CityModel"))
		parser->names->adopted = uri;
	for (size_t i = 0; !version && i < namespaces->bindings.count; i++)
		version = names_version(namespaces->bindings.at[i].uri);
	if (!version)
		return;
	parser->names->spelled = version;
	parser->names->version = *version == '3' ? 3 : 2;
}

static enum tcs_status
xml_declare(struct xml_parser *parser, const struct spelling *spelling,
	const char *value)
{
	enum tcs_status status = namespace_declare(&parser->namespaces,
		spelling, value, parser->depth, &parser->fault);

	if (status != TCS_LIMIT)
		return status;
	return fault_set(&parser->fault, TCS_LIMIT, TCS_NOWHERE,
		"line %u: more than %d namespaces are in force",
		xml_line(parser), MAX_BINDINGS);
}

enum tcs_status
xml_take_attribute(struct xml_parser *parser, const struct spelling *spelling,
	const char *value, size_t length)
{
	if (spelling->declares)
		return xml_declare(parser, spelling, value);
	if (array_grow(&parser->attributes, 1))
		return fault_memory(&parser->fault);
	parser->attributes.at[parser->attributes.count++] =
		(struct xml_attribute){
			.local = spelling->local,
			.prefix = spelling->prefix,
			.value = value,
			.length = length,
		};
	return TCS_OK;
}

/* Names and values by turns, and NULL in the end. */
static enum tcs_status
xml_take_attributes(struct xml_parser *parser, const xmlChar **given)
{
	enum tcs_status status = TCS_OK;

	for (; !status && given && *given; given += 2) {
		const struct spelling *spelling =
			spelling_find(&parser->namespaces, plain(given[0]));
		const char *value = plain(given[1]);

		if (!spelling)
			return fault_memory(&parser->fault);
		status = xml_take_attribute(
			parser, spelling, value, strlen(value));
	}
	return status;
}

static enum tcs_status
xml_take_name(
	struct xml_parser *parser, const char *spelled, struct name **name)
{
	struct spelling *spelling = spelling_find(&parser->namespaces, spelled);

	if (!spelling)
		return fault_memory(&parser->fault);
	if (!parser->began)
		xml_find_version(parser, spelling);
	*name = spelling_mean(&parser->namespaces, parser->names, spelling);
	return *name ? TCS_OK : fault_memory(&parser->fault);
}

static enum tcs_status
xml_too_deep(struct xml_parser *parser)
{
	return fault_set(&parser->fault, TCS_LIMIT, TCS_NOWHERE,
		"line %u: elements nest deeper than %u%s", xml_line(parser),
		parser->limits->depth,
		parser->limits->fixed ? "" : " (--max-depth)");
}

bool
xml_enter(struct xml_parser *parser)
{
	if (parser->status)
		return false;
	if (++parser->depth > parser->limits->depth) {
		xml_stop(parser, xml_too_deep(parser));
		return false;
	}
	parser->skipped += parser->skipped > 0;
	parser->attributes.count = 0;
	return !parser->skipped;
}

void
xml_open(struct xml_parser *parser, const char *spelled)
{
	struct name *name;
	bool skip = false;
	enum tcs_status status = xml_take_name(parser, spelled, &name);

	if (!status)
		status = parser->handler->start(parser->handler->context, name,
			parser->attributes.at, parser->attributes.count, &skip,
			&parser->fault);
	parser->skipped = skip;
	if (status)
		xml_stop(parser, status);
}

static void
xml_start(void *user, const xmlChar *spelled, const xmlChar **attributes)
{
	struct xml_parser *parser = user;
	enum tcs_status status;

	if (!xml_enter(parser))
		return;
	status = xml_take_attributes(parser, attributes);
	if (status)
		xml_stop(parser, status);
	else
		xml_open(parser, plain(spelled));
}

void
xml_close(struct xml_parser *parser)
{
	enum tcs_status status;

	if (parser->status)
		return;
	namespaces_leave(&parser->namespaces, parser->depth);
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
xml_end(void *user, const xmlChar *spelled)
{
	(void)spelled;
	xml_close(user);
}

void
xml_characters(struct xml_parser *parser, const char *bytes, size_t length)
{
	enum tcs_status status;

	if (parser->status || parser->skipped)
		return;
	status = parser->handler->text(
		parser->handler->context, bytes, length, &parser->fault);
	if (status)
		xml_stop(parser, status);
}

static void
xml_text(void *user, const xmlChar *bytes, int length)
{
	xml_characters(user, plain(bytes), (size_t)length);
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

	/* libxml2 does not say here on which line the element began. */
	if (error && error->code == XML_ERR_TAG_NAME_MISMATCH && error->str1 &&
		error->str2)
		return fault_set(&parser->fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"line %d: not well-formed XML: %.60s ends as %.60s",
			line, error->str1, error->str2);
	return fault_set(&parser->fault, TCS_BAD_INPUT, TCS_NOWHERE,
		"line %d: not well-formed XML: %.*s", line,
		(int)strcspn(text, "\n"), text);
}

/*
 * Errors are collected by libxml2 and read from its context, but for the first
 * of a piece; that a piece ends within an element is none.
 */
static void
xml_error(void *user, const char *format, ...)
{
	struct xml_parser *parser = user;
	const xmlError *error = xmlCtxtGetLastError(parser->context);

	(void)format;
	if (!error || !parser->in_piece || parser->malformed ||
		parser->status || error->level < XML_ERR_FATAL ||
		error->code == XML_ERR_TAG_NOT_FINISHED)
		return;
	parser->malformed = xml_malformed(parser, error) != TCS_OK;
}

/*
 * The first version of libxml2's events, with names as they are spelled: then
 * it looks one name up for each element, not two.
 */
xmlSAXHandler
xml_callbacks(void)
{
	return (xmlSAXHandler){
		.initialized = 1,
		.startElement = xml_start,
		.endElement = xml_end,
		.characters = xml_text,
		.ignorableWhitespace = xml_text,
		.cdataBlock = xml_text,
		.getEntity = xml_entity,
		.entityDecl = xml_entity_declared,
		.attributeDecl = xml_attribute_declared,
		.error = xml_error,
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
	namespaces_release(&parser->namespaces);
	array_release(&parser->held);
	array_release(&parser->plain.open);
	free(parser);
}

uint32_t
xml_line(struct xml_parser *parser)
{
	struct plain_element *plain = &parser->plain;

	if (!parser->context || !parser->context->input)
		return 1;
	if (!plain->first)
		return (uint32_t)parser->context->input->line;
	plain->line += (uint32_t)newlines_count(
		plain->counted, (size_t)(plain->at - plain->counted));
	plain->counted = plain->at;
	return plain->line;
}
