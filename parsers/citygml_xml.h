/*
 * XML as events: libxml2's push parser behind three calls, and a faster way for
 * whole elements.
 *
 * No network, no DTD, no entities but the predefined ones: a declared entity
 * or default of an attribute ends the parse. Undeclared prefixes pass. Text is
 * UTF-8 whatever the file's encoding, and arrives in pieces.
 */
#ifndef TESSERA_CITYGML_XML_H
#define TESSERA_CITYGML_XML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "citygml_names.h"
#include "fault.h"

struct xml_attribute {
	const char *local; /* interned */
	const char *prefix; /* interned; NULL for none */
	const char *value; /* not terminated */
	size_t length;
};

struct xml_handler {
	void *context;
	/* `name` and `attributes` live until the call returns. With *skip set,
	   nothing below the element is reported, nor its end. */
	enum tcs_status (*start)(void *context, struct name *name,
		const struct xml_attribute *attributes, size_t count,
		bool *skip, struct tcs_fault *fault);
	enum tcs_status (*end)(void *context, struct tcs_fault *fault);
	enum tcs_status (*text)(void *context, const char *bytes, size_t length,
		struct tcs_fault *fault);
	/* Whether text that comes next is of any use: else it need not be
	   reported. NULL: it always is. */
	bool (*listens)(const void *context);
};

struct xml_limits {
	unsigned depth; /* open elements */
	uint64_t tag; /* bytes of a tag, a comment or an instruction */
	bool fixed; /* no option of the program sets them */
};

struct xml_parser;

/* NULL without memory. All three must outlive the parser; names are released
 * with it, since they point into its dictionary. */
struct xml_parser *xml_new(const struct xml_handler *handler,
	const struct xml_limits *limits, struct names *names);
void xml_free(struct xml_parser *parser);

/*
 * Parse the next bytes; length 0 ends the document. Fails with TCS_BAD_INPUT
 * and the line for what is not well-formed, with TCS_LIMIT, and with what a
 * handler returned.
 */
enum tcs_status xml_feed(struct xml_parser *parser, const char *bytes,
	size_t length, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Whether the parser stands directly below the root element, with nothing of
 * the bytes left, which it takes as they come.
 */
bool xml_is_between(const struct xml_parser *parser);

/* Parse what was kept back of the bytes for the sake of speed. */
enum tcs_status xml_settle(
	struct xml_parser *parser, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Where xml_is_between: the bytes of one whole element; the one behind them may
 * be written meanwhile. *whole is false where they are more or less than that,
 * or not parsed at all: then, and after a failure, the parser is beyond use.
 */
enum tcs_status xml_feed_element(struct xml_parser *parser, char *bytes,
	size_t length, bool *whole, struct tcs_fault *fault) TCS_CHECKED;

/* The line being parsed, from 1. */
uint32_t xml_line(struct xml_parser *parser);

/* A stretch of the document's bytes. */
struct xml_stretch {
	uint64_t at, end; /* its first byte, and behind its last */
	uint32_t line; /* of its first byte */
};

/*
 * Within `start`: where the tag stands. Within `end`: only the byte behind the
 * element. False, with zeros, where bytes are not taken as they come but
 * converted to UTF-8 first.
 */
bool xml_place_tag(struct xml_parser *parser, struct xml_stretch *tag);
bool xml_place_end(const struct xml_parser *parser, uint64_t *end);

/* The bytes fed from now on stand here in the document. */
void xml_move(struct xml_parser *parser, uint64_t at, uint32_t line);

#endif
