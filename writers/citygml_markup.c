#include "citygml_markup.h"

#include <stdio.h>
#include <string.h>

#include "number.h"

enum { MAX_TABS = 64 };

void
markup_release(struct markup *markup)
{
	array_release(&markup->bytes);
}

void
markup_clear(struct markup *markup, unsigned depth)
{
	array_clear(&markup->bytes);
	markup->depth = depth;
	markup->in_tag = false;
	markup->after_text = false;
	markup->failed = false;
	markup->replaced = false;
}

enum tcs_status
markup_check(const struct markup *markup, struct tcs_fault *fault)
{
	return markup->failed ? fault_memory(fault) : TCS_OK;
}

/* Where `length` more bytes go; NULL without memory. */
static char *
room_for(struct markup *markup, size_t length)
{
	if (markup->bytes.room - markup->bytes.count < length &&
		(markup->failed || array_grow(&markup->bytes, length))) {
		markup->failed = true;
		return NULL;
	}
	return markup->bytes.at + markup->bytes.count;
}

void
markup_raw(struct markup *markup, const char *bytes, size_t length)
{
	char *at = room_for(markup, length);

	if (!at)
		return;
	memcpy(at, bytes, length);
	markup->bytes.count += length;
}

#define LITERAL(markup, text) markup_raw((markup), (text), sizeof(text) - 1)

static void
put(struct markup *markup, const char *text)
{
	markup_raw(markup, text, strlen(text));
}

/* Deep nesting must not make the text grow by its square. */
static void
new_line(struct markup *markup)
{
	size_t tabs = markup->depth < MAX_TABS ? markup->depth : MAX_TABS;
	char *at = room_for(markup, tabs + 1);

	if (!at)
		return;
	*at = '\n';
	memset(at + 1, '\t', tabs);
	markup->bytes.count += tabs + 1;
}

static void
put_name(struct markup *markup, const char *module, const char *name)
{
	size_t prefix = strlen(module), length = strlen(name);
	char *at = room_for(markup, prefix + length + 1);

	if (!at)
		return;
	memcpy(at, module, prefix);
	at[prefix] = ':';
	memcpy(at + prefix + 1, name, length);
	markup->bytes.count += prefix + length + 1;
}

static void
close_tag(struct markup *markup)
{
	if (!markup->in_tag)
		return;
	LITERAL(markup, ">");
	markup->in_tag = false;
	markup->depth++;
}

void
markup_start(struct markup *markup, const char *module, const char *name)
{
	close_tag(markup);
	new_line(markup);
	LITERAL(markup, "<");
	put_name(markup, module, name);
	markup->in_tag = true;
	markup->after_text = false;
}

static const char *
escape_of(unsigned char c)
{
	switch (c) {
	case '&':
		return "&amp;";
	case '<':
		return "&lt;";
	case '>':
		return "&gt;";
	case '"':
		return "&quot;";
	case '\t':
		return "&#9;";
	case '\n':
		return "&#10;";
	case '\r':
		return "&#13;";
	default:
		return c < 0x20 ? "\xef\xbf\xbd" : NULL;
	}
}

/* U+FFFE and U+FFFF are no characters of XML either. */
static bool
is_noncharacter(const char *at)
{
	return !strncmp(at, "\xef\xbf\xbe", 3) ||
		!strncmp(at, "\xef\xbf\xbf", 3);
}

static void
put_escaped(struct markup *markup, const char *text)
{
	const char *from = text;

	for (; *text; text++) {
		const char *escape = escape_of((unsigned char)*text);
		size_t length = 1;

		if (!escape && *text == '\xef' && is_noncharacter(text)) {
			escape = "\xef\xbf\xbd";
			length = 3;
		}
		if (!escape)
			continue;
		markup->replaced |= *escape != '&';
		markup_raw(markup, from, (size_t)(text - from));
		put(markup, escape);
		text += length - 1;
		from = text + 1;
	}
	markup_raw(markup, from, (size_t)(text - from));
}

void
markup_attribute(struct markup *markup, const char *name, const char *value)
{
	LITERAL(markup, " ");
	put(markup, name);
	LITERAL(markup, "=\"");
	put_escaped(markup, value);
	LITERAL(markup, "\"");
}

void
markup_link(struct markup *markup, const char *name, const char *id)
{
	LITERAL(markup, " ");
	put(markup, name);
	LITERAL(markup, "=\"#");
	put_escaped(markup, id);
	LITERAL(markup, "\"");
}

void
markup_begin_text(struct markup *markup)
{
	close_tag(markup);
	markup->after_text = true;
}

void
markup_text(struct markup *markup, const char *text)
{
	markup_begin_text(markup);
	put_escaped(markup, text);
}

void
markup_number(struct markup *markup, double number)
{
	char *at;

	markup_begin_text(markup);
	at = room_for(markup, NUMBER_LENGTH + 1);
	if (!at)
		return;
	if (at[-1] != '>') {
		*at++ = ' ';
		markup->bytes.count++;
	}
	markup->bytes.count += number_print(at, number);
}

void
markup_count(struct markup *markup, uint64_t number)
{
	char text[24];

	snprintf(text, sizeof text, "%llu", (unsigned long long)number);
	markup_text(markup, text);
}

void
markup_end(struct markup *markup, const char *module, const char *name)
{
	if (markup->in_tag) {
		LITERAL(markup, "/>");
		markup->in_tag = false;
		markup->after_text = false;
		return;
	}
	markup->depth--;
	if (!markup->after_text)
		new_line(markup);
	markup->after_text = false;
	LITERAL(markup, "</");
	put_name(markup, module, name);
	LITERAL(markup, ">");
}

void
markup_leaf(struct markup *markup, const char *module, const char *name,
	const char *text)
{
	markup_start(markup, module, name);
	if (*text)
		markup_text(markup, text);
	markup_end(markup, module, name);
}
