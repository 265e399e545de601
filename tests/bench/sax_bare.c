/*
 * libxml2's SAX2 parser with handlers that do nothing, over standard input in
 * pieces of 64 KB: what any reader of XML built on it costs at least.
 */
#include <stdio.h>

#include <libxml/parser.h>

static void
start(void *user, const xmlChar *local, const xmlChar *prefix,
	const xmlChar *uri, int namespace_count, const xmlChar **namespaces,
	int attribute_count, int defaulted, const xmlChar **attributes)
{
	(void)user;
	(void)local;
	(void)prefix;
	(void)uri;
	(void)namespace_count;
	(void)namespaces;
	(void)attribute_count;
	(void)defaulted;
	(void)attributes;
}

static void
end(void *user, const xmlChar *local, const xmlChar *prefix, const xmlChar *uri)
{
	(void)user;
	(void)local;
	(void)prefix;
	(void)uri;
}

static void
text(void *user, const xmlChar *bytes, int length)
{
	(void)user;
	(void)bytes;
	(void)length;
}

int
main(void)
{
	static char bytes[64 * 1024];
	xmlSAXHandler handlers = {
		.initialized = XML_SAX2_MAGIC,
		.startElementNs = start,
		.endElementNs = end,
		.characters = text,
		.ignorableWhitespace = text,
		.cdataBlock = text,
	};
	xmlParserCtxtPtr context =
		xmlCreatePushParserCtxt(&handlers, NULL, NULL, 0, NULL);
	size_t got;
	int error = 0;

	if (!context)
		return 1;
	xmlCtxtUseOptions(context, XML_PARSE_HUGE | XML_PARSE_NONET);
	while (!error && (got = fread(bytes, 1, sizeof bytes, stdin)))
		error = xmlParseChunk(context, bytes, (int)got, 0);
	if (!error)
		error = xmlParseChunk(context, NULL, 0, 1);
	xmlFreeParserCtxt(context);
	return error != 0;
}
