/*
 * XML text under construction: elements open, take attributes, text or
 * elements, and end; indentation follows, up to 64 levels. What goes wrong for want of memory
 * is remembered and told by markup_check, so that those who write need not ask.
 *
 * All zero is empty. Names are "module:name" in two pieces; text is escaped;
 * control characters that XML 1.0 does not allow become U+FFFD.
 */
#ifndef TESSERA_CITYGML_MARKUP_H
#define TESSERA_CITYGML_MARKUP_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"

/* What the text says about ids, for whoever joins the texts of objects. */
struct markup_id {
	uint64_t hash;
	size_t at; /* where in the text */
};

struct markup {
	TCS_ARRAY(char) bytes;
	unsigned depth; /* of indentation */
	bool in_tag; /* a start tag waits for its '>' */
	bool after_text; /* the end tag follows on the same line */
	bool replaced; /* a character that XML does not allow */
	bool failed;
};

void markup_release(struct markup *markup);
void markup_clear(struct markup *markup, unsigned depth);

/* Fails with TCS_NO_MEMORY when anything before did. */
enum tcs_status markup_check(
	const struct markup *markup, struct tcs_fault *fault) TCS_CHECKED;

void markup_start(struct markup *markup, const char *module, const char *name);
void markup_attribute(
	struct markup *markup, const char *name, const char *value);
/* xlink:href="#id", or a URI as it is. */
void markup_link(struct markup *markup, const char *name, const char *id);
void markup_text(struct markup *markup, const char *text);
/* A number behind a blank unless it is the first of its text. */
void markup_number(struct markup *markup, double number);
void markup_count(struct markup *markup, uint64_t number);
/* Close the start tag; what follows up to the end stands on one line. */
void markup_begin_text(struct markup *markup);
void markup_end(struct markup *markup, const char *module, const char *name);

/* An element of text only. */
void markup_leaf(struct markup *markup, const char *module, const char *name,
	const char *text);

/* As it is, without escapes. */
void markup_raw(struct markup *markup, const char *bytes, size_t length);

#endif
