/*
 * Elements of tags and text and little else, as nearly all of a city's are:
 * read without libxml2, which would take twice as long. What is not as plain,
 * or not well-formed, is left to it, so that nothing is judged here.
 *
 * source: Extensible Markup Language (XML) 1.0, fifth edition.
 */
#include <string.h>

#include "citygml_numbers.h"
#include "citygml_xml_parser.h"
#include "utf8.h"

/* ---- bytes ------------------------------------------------------------------ */

/* What the bytes of an element are, all together. */
struct byte_kinds {
	bool special; /* control characters, the end of CDATA */
	bool references;
	bool returns; /* carriage returns */
	bool foreign; /* beyond ASCII */
};

enum {
	KIND_SPECIAL = 1,
	KIND_RETURN = 2,
	KIND_REFERENCE = 4,
	KIND_FOREIGN = 0x80,
};

static inline unsigned char
kind_of(unsigned char byte)
{
	unsigned char special =
		(byte < ' ' && byte != '\n' && byte != '\t' && byte != '\r') ||
		byte == ']';

	return (unsigned char)(special * KIND_SPECIAL |
		(byte == '\r') * KIND_RETURN | (byte == '&') * KIND_REFERENCE |
		(byte & KIND_FOREIGN));
}

/* The inner loop compiles to vector instructions. */
static struct byte_kinds
kinds_of(const char *at, size_t length)
{
	enum { BLOCK = 128 };
	unsigned char all = 0;

	for (; length >= BLOCK; at += BLOCK, length -= BLOCK)
		for (int i = 0; i < BLOCK; i++)
			all |= kind_of((unsigned char)at[i]);
	for (; length; at++, length--)
		all |= kind_of((unsigned char)*at);
	return (struct byte_kinds){
		.special = all & KIND_SPECIAL,
		.references = all & KIND_REFERENCE,
		.returns = all & KIND_RETURN,
		.foreign = all & KIND_FOREIGN,
	};
}

/* UTF-8 of XML's characters: U+FFFE and U+FFFF are none. */
static bool
are_characters(const char *at, size_t length)
{
	const char *end = at + length;

	if (!utf8_valid(at, length))
		return false;
	for (; (at = memchr(at, 0xef, (size_t)(end - at))); at++)
		if (at[1] == '\xbf' && (unsigned char)at[2] >= 0xbe)
			return false;
	return true;
}

/* ---- bytes by eights ---------------------------------------------------------- */

#define EACH(byte) (0x0101010101010101u * (byte))

enum { WORD = 8 };

/* The first byte is the lowest. */
static inline uint64_t
word_of(const char *at)
{
	uint64_t word;

	memcpy(&word, at, WORD);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
	word = __builtin_bswap64(word);
#endif
	return word;
}

/*
 * The top bit of each byte that is below a limit of up to 128. Behind one that
 * is, others may be marked that are not: the first is what counts.
 */
static inline uint64_t
bytes_below(uint64_t word, unsigned char limit)
{
	return (word - EACH(limit)) & ~word & EACH(0x80);
}

static inline uint64_t
bytes_like(uint64_t word, char byte)
{
	return bytes_below(word ^ EACH((unsigned char)byte), 1);
}

/* The first byte that is marked; one is. */
static inline size_t
first_marked(uint64_t marks)
{
	return (size_t)__builtin_ctzll(marks) / 8;
}

/* ---- references ----------------------------------------------------------------- */

/* The predefined one that begins with the '&'; NULL: it is another. */
static const char *
reference_read(const char *at, size_t length, size_t *behind)
{
	static const char *const known[] = {
		"&&amp;", "<&lt;", ">&gt;", "\"&quot;", "'&apos;"};

	for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
		*behind = strlen(known[i] + 1);
		if (*behind <= length && !memcmp(at, known[i] + 1, *behind))
			return known[i];
	}
	return NULL;
}

/* Whether all are predefined, and none, by the looks of it, in a tag. */
static bool
are_references(const char *at, size_t length)
{
	const char *end = at + length, *seen = at;
	bool in_tag = false;

	while ((at = memchr(seen, '&', (size_t)(end - seen)))) {
		const char *mark = at;
		size_t behind;

		while (mark > seen && *mark != '<' && *mark != '>')
			mark--;
		if (*mark == '<' || *mark == '>')
			in_tag = *mark == '<';
		if (in_tag || !reference_read(at, (size_t)(end - at), &behind))
			return false;
		seen = at + behind;
	}
	return true;
}

/* ---- names ------------------------------------------------------------------- */

static bool
is_name(const char *at, size_t length)
{
	for (size_t i = 0; i < length; i++) {
		char c = at[i];
		bool begins = (c >= 'a' && c <= 'z') ||
			(c >= 'A' && c <= 'Z') || c == '_' || c == ':';

		if (!begins &&
			(!i ||
				!((c >= '0' && c <= '9') || c == '-' ||
					c == '.')))
			return false;
	}
	return length > 0;
}

static size_t
known_slot(const char *at, size_t length)
{
	uint64_t first = 0, last = 0;

	if (length >= sizeof first) {
		memcpy(&first, at, sizeof first);
		memcpy(&last, at + length - sizeof last, sizeof last);
	} else {
		while (length)
			first = first << 8 | (unsigned char)at[--length];
	}
	first = (first ^ last << 1) * 0x9e3779b97f4a7c15u;
	return (size_t)(first >> 32) & (KNOWN_NAMES - 1);
}

/* The bytes up to what ends a name; a NUL stands at `end`. */
static size_t
name_length(const char *at, const char *end)
{
	const char *from = at;

	for (; end - at >= WORD; at += WORD) {
		uint64_t word = word_of(at);
		uint64_t marks = bytes_below(word, ' ' + 1) |
			bytes_like(word, '>') | bytes_like(word, '/') |
			bytes_like(word, '=');

		if (marks)
			return (size_t)(at - from) + first_marked(marks);
	}
	while ((unsigned char)*at > ' ' && *at != '>' && *at != '/' &&
		*at != '=')
		at++;
	return (size_t)(at - from);
}

/* As memcmp tells, which costs more where the names are short. */
static inline bool
is_same(const char *a, const char *b, size_t length)
{
	if (length < WORD)
		return !memcmp(a, b, length);
	for (size_t i = 0; i < length - WORD; i += WORD)
		if (word_of(a + i) != word_of(b + i))
			return false;
	return word_of(a + length - WORD) == word_of(b + length - WORD);
}

enum { LONGEST_NAME = 500 };

/* As libxml2 interns it; NULL where it is no plain name. */
static const struct known_name *
name_know(struct xml_parser *parser, const char *at, size_t length)
{
	struct known_name *known = &parser->plain.known[known_slot(at, length)];

	if (known->spelled && known->length == length &&
		is_same(known->spelled, at, length))
		return known;
	if (!is_name(at, length) || length > LONGEST_NAME)
		return NULL;
	*known = (struct known_name){
		(const char *)xmlDictLookup(parser->context->dict,
			(const xmlChar *)at, (int)length),
		length,
	};
	if (known->spelled)
		return known;
	parser->status = fault_memory(&parser->fault);
	return NULL;
}

/* ---- markup ------------------------------------------------------------------ */

/* A walk over an element. Where a step is false, nothing plain follows. */
struct walk {
	struct xml_parser *parser;
	char *at;
	char *end;
	bool returns; /* there are carriage returns */
	bool references;
};

enum { MOST_ATTRIBUTES = 32 }; /* of a plain tag */

static void
blanks_pass(struct walk *walk)
{
	while (is_blank(*walk->at))
		walk->at++;
}

/* The value from its quote; NULL where it is not as it stands there. */
static char *
value_end(char *at, const char *end)
{
	const char quote = *at++;

	if (quote != '"' && quote != '\'')
		return NULL;
	for (; end - at >= WORD; at += WORD) {
		uint64_t word = word_of(at);
		uint64_t marks = bytes_below(word, ' ') |
			bytes_like(word, quote) | bytes_like(word, '<') |
			bytes_like(word, '&');

		if (!marks)
			continue;
		at += first_marked(marks);
		return *at == quote ? at : NULL;
	}
	while (*at != quote && (unsigned char)*at >= ' ' && *at != '<' &&
		*at != '&')
		at++;
	return *at == quote ? at : NULL;
}

static bool
attribute_take(struct walk *walk, const char *spelled, char *value, char *end)
{
	struct xml_parser *parser = walk->parser;
	const struct spelling *spelling =
		spelling_find(&parser->namespaces, spelled);
	const char quote = *end;

	if (!spelling) {
		parser->status = fault_memory(&parser->fault);
		return false;
	}
	*end = '\0';
	parser->status = xml_take_attribute(
		parser, spelling, value, (size_t)(end - value));
	*end = quote;
	return !parser->status;
}

/* An attribute behind others of these names. */
static bool
attribute_walk(struct walk *walk, bool wanted,
	const char *names[MOST_ATTRIBUTES], size_t count)
{
	size_t length = name_length(walk->at, walk->end);
	const struct known_name *name =
		name_know(walk->parser, walk->at, length);
	char *value, *end;

	if (!name || count == MOST_ATTRIBUTES)
		return false;
	for (size_t i = 0; i < count; i++)
		if (names[i] == name->spelled)
			return false;
	names[count] = name->spelled;
	walk->at += length;
	blanks_pass(walk);
	if (*walk->at != '=')
		return false;
	walk->at++;
	blanks_pass(walk);
	value = walk->at + 1;
	end = value_end(walk->at, walk->end);
	if (!end)
		return false;
	walk->at = end + 1;
	return !wanted || attribute_take(walk, names[count], value, end);
}

/* Up to the end of the tag, '>' or "/>". */
static bool
attributes_walk(struct walk *walk, bool wanted)
{
	const char *names[MOST_ATTRIBUTES];
	size_t count = 0;

	for (;;) {
		bool apart = is_blank(*walk->at);

		blanks_pass(walk);
		if (*walk->at == '>' ||
			(*walk->at == '/' && walk->at[1] == '>'))
			return true;
		if (!apart || !attribute_walk(walk, wanted, names, count++))
			return false;
	}
}

static bool
start_walk(struct walk *walk)
{
	struct xml_parser *parser = walk->parser;
	struct plain_element *plain = &parser->plain;
	size_t length = name_length(walk->at + 1, walk->end);
	const struct known_name *known =
		name_know(parser, walk->at + 1, length);
	struct known_name name;
	bool wanted;

	if (!known)
		return false;
	name = *known;
	plain->at = plain->tag = walk->at;
	walk->at += 1 + length;
	wanted = xml_enter(parser);
	if (parser->status || !attributes_walk(walk, wanted))
		return false;
	plain->at = walk->at;
	if (wanted)
		xml_open(parser, name.spelled);
	if (*walk->at == '/') {
		walk->at += 2;
		plain->at = walk->at;
		xml_close(parser);
		return true;
	}
	walk->at++;
	if (array_grow(&plain->open, 1)) {
		parser->status = fault_memory(&parser->fault);
		return false;
	}
	plain->open.at[plain->open.count++] = name;
	return true;
}

static bool
end_walk(struct walk *walk)
{
	struct plain_element *plain = &walk->parser->plain;
	const struct known_name *name;

	if (!plain->open.count)
		return false;
	name = &plain->open.at[--plain->open.count];
	walk->at += 2;
	if ((size_t)(walk->end - walk->at) <= name->length ||
		!is_same(walk->at, name->spelled, name->length))
		return false;
	walk->at += name->length;
	blanks_pass(walk);
	if (*walk->at != '>')
		return false;
	plain->at = ++walk->at;
	xml_close(walk->parser);
	return true;
}

/* A line's end of two characters is one; a return alone is too rare. */
static bool
lines_walk(struct walk *walk, const char *at, const char *end)
{
	const char *line_end;

	while (walk->returns &&
		(line_end = memchr(at, '\r', (size_t)(end - at)))) {
		if (line_end[1] != '\n')
			return false;
		if (line_end > at)
			xml_characters(
				walk->parser, at, (size_t)(line_end - at));
		at = line_end + 1;
	}
	if (end > at)
		xml_characters(walk->parser, at, (size_t)(end - at));
	return true;
}

/* Text with references up to the next tag. */
static bool
references_walk(struct walk *walk, const char *end)
{
	const char *at = walk->at, *mark;

	while (walk->references &&
		(mark = memchr(at, '&', (size_t)(end - at)))) {
		size_t behind;
		const char *meant =
			reference_read(mark, (size_t)(end - mark), &behind);

		if (!meant || !lines_walk(walk, at, mark))
			return false;
		xml_characters(walk->parser, meant, 1);
		at = mark + behind;
	}
	return lines_walk(walk, at, end);
}

static bool
text_walk(struct walk *walk)
{
	char *end = memchr(walk->at, '<', (size_t)(walk->end - walk->at));

	if (!end)
		return false;
	walk->parser->plain.at = end;
	if (!xml_listens(walk->parser)) {
		walk->at = end;
		return true;
	}
	if (!walk->returns && !walk->references)
		xml_characters(
			walk->parser, walk->at, (size_t)(end - walk->at));
	else if (!references_walk(walk, end))
		return false;
	walk->at = end;
	return true;
}

/* The element from its '<' to its end. */
static bool
element_walk(struct walk *walk)
{
	struct xml_parser *parser = walk->parser;
	bool plain = *walk->at == '<' && start_walk(walk);

	while (plain && !parser->status && parser->plain.open.count) {
		if (*walk->at != '<')
			plain = text_walk(walk);
		else if (walk->at[1] == '/')
			plain = end_walk(walk);
		else
			plain = start_walk(walk);
	}
	return plain && !parser->status && walk->at == walk->end;
}

enum tcs_status
xml_read_plain(struct xml_parser *parser, char *bytes, size_t length,
	bool *plain, bool *whole)
{
	const struct byte_kinds kinds = kinds_of(bytes, length);
	struct walk walk = {
		parser, bytes, bytes + length, kinds.returns, kinds.references};
	struct plain_element *element = &parser->plain;
	const char behind = *walk.end;

	*whole = false;
	*plain = !kinds.special &&
		(!kinds.references || are_references(bytes, length)) &&
		(!kinds.foreign ||
			(parser->context->charset == XML_CHAR_ENCODING_UTF8 &&
				are_characters(bytes, length)));
	if (!*plain)
		return TCS_OK;
	element->first = element->at = element->counted = bytes;
	element->line = (uint32_t)parser->context->input->line;
	element->open.count = 0;
	*walk.end = '\0';
	*whole = element_walk(&walk);
	*walk.end = behind;
	parser->context->input->line = (int)xml_line(parser);
	parser->fed += length;
	element->first = NULL;
	if (!parser->status)
		parser->status = xml_check_names(parser);
	*whole = *whole && !parser->status;
	return parser->status;
}
