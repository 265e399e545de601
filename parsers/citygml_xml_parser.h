/*
 * The XML parser's inside: what citygml_xml.c, which hears libxml2's events,
 * shares with citygml_xml_feed.c, which hands it the bytes.
 */
#ifndef TESSERA_CITYGML_XML_PARSER_H
#define TESSERA_CITYGML_XML_PARSER_H

#include <libxml/parser.h>

#include "array.h"
#include "citygml_namespaces.h"
#include "citygml_xml.h"

#ifndef LIBXML_SAX1_ENABLED
#error "libxml2 must have its events of elements as they are spelled"
#endif

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
	struct namespaces namespaces;
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
	bool in_piece; /* it has a piece of content for its input */
	bool malformed; /* an error in the piece is in `fault` */
};

/* What libxml2 calls. */
xmlSAXHandler xml_callbacks(void);

/* The end of a failed parse: libxml2's text of the error. */
enum tcs_status xml_malformed(
	struct xml_parser *parser, const xmlError *error) TCS_CHECKED;

#endif
