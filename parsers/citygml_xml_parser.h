/*
 * The XML parser's inside: what citygml_xml.c, which hears libxml2's events,
 * shares with citygml_xml_feed.c, which hands it the bytes, and with
 * citygml_xml_plain.c, which finds most events itself.
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

/* A name that was met, to be found again by its bytes. */
struct known_name {
	const char *spelled; /* interned by libxml2; NULL: none yet */
	size_t length;
};

enum { KNOWN_NAMES = 512 }; /* a power of 2 */

/* A whole element that is read without libxml2. */
struct plain_element {
	const char *first; /* NULL: there is none */
	const char *at; /* where the parser stands */
	const char *tag; /* the start tag it is in */
	const char *counted; /* the line is that of this byte */
	uint32_t line;
	TCS_ARRAY(struct known_name) open; /* elements */
	struct known_name known[KNOWN_NAMES]; /* the last in each slot */
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
	struct plain_element plain;
};

/* What libxml2 calls. */
xmlSAXHandler xml_callbacks(void);

/* The parser fails, and hears nothing more. */
void xml_stop(struct xml_parser *parser, enum tcs_status status);

/*
 * The events, whoever finds them. A start tag: xml_enter, then, if that is true,
 * one xml_take_attribute for each attribute and xml_open. Names are as libxml2
 * interns them, and `value` is terminated where the name declares a namespace.
 */
bool xml_enter(struct xml_parser *parser);
enum tcs_status xml_take_attribute(struct xml_parser *parser,
	const struct spelling *spelling, const char *value,
	size_t length) TCS_CHECKED;
void xml_open(struct xml_parser *parser, const char *spelled);
void xml_close(struct xml_parser *parser);
void xml_characters(
	struct xml_parser *parser, const char *bytes, size_t length);

/* Whether text is of any use. */
static inline bool
xml_listens(const struct xml_parser *parser)
{
	const struct xml_handler *handler = parser->handler;

	return !parser->skipped &&
		(!handler->listens || handler->listens(handler->context));
}

/* Whether all names are few enough to be kept. */
enum tcs_status xml_check_names(struct xml_parser *parser) TCS_CHECKED;

/*
 * Read the bytes of one element, behind which a byte may be written. *whole is
 * false where they are something else, or more than tags and text: then some of
 * it may have been reported. *plain is false where that was seen at once, and
 * nothing has.
 */
enum tcs_status xml_read_plain(struct xml_parser *parser, char *bytes,
	size_t length, bool *plain, bool *whole) TCS_CHECKED;

/* The end of a failed parse: libxml2's text of the error. */
enum tcs_status xml_malformed(
	struct xml_parser *parser, const xmlError *error) TCS_CHECKED;

#endif
