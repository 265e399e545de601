#include "step_lex.h"

#include <stdint.h>
#include <string.h>

#define EACH(byte) (UINT64_C(0x0101010101010101) * (byte))

const char *
step_blank_more(const char *at, const char *end)
{
	while (at < end) {
		if ((unsigned char)*at <= ' ') {
			at++;
		} else if (*at == '/' && end - at > 1 && at[1] == '*') {
			at += 2;
			do {
				at = memchr(at, '*', (size_t)(end - at));
				if (!at)
					return end;
				at++;
			} while (at == end || *at != '/');
			at++;
		} else if (*at == '\\' && end - at > 2 && at[2] == '\\' &&
			(at[1] == 'N' || at[1] == 'F')) {
			at += 3;
		} else {
			break;
		}
	}
	return at;
}

const char *
step_string_end(const char *at, const char *end)
{
	for (;;) {
		at = memchr(at, '\'', (size_t)(end - at));
		if (!at)
			return NULL;
		at++;
		if (at == end || *at != '\'')
			return at;
		at++;
	}
}

/* The top bit of the lowest byte that is zero, and maybe of some above it. */
static uint64_t
zero_bytes(uint64_t word)
{
	return (word - EACH(1)) & ~word & EACH(0x80);
}

static bool
is_special(char byte)
{
	return byte == '\'' || byte == ';' || byte == '/';
}

/* The first quote, semicolon or slash. */
static const char *
special_find(const char *at, const char *end)
{
	while (end - at >= 8) {
		uint64_t word;

		memcpy(&word, at, sizeof word);
		if (zero_bytes(word ^ EACH('\'')) |
			zero_bytes(word ^ EACH(';')) |
			zero_bytes(word ^ EACH('/')))
			break;
		at += 8;
	}
	while (at < end && !is_special(*at))
		at++;
	return at;
}

const char *
step_statement_end(const char *at, const char *end)
{
	for (;;) {
		at = special_find(at, end);
		if (at == end)
			return NULL;
		if (*at == ';')
			return at;
		if (*at == '\'') {
			at = step_string_end(at + 1, end);
			if (!at)
				return NULL;
		} else {
			const char *behind = step_blank_more(at, end);

			at = behind == at ? at + 1 : behind;
		}
	}
}

enum { PLAIN, OPENS, CLOSES, QUOTE, SLASH, ENDS };

static const unsigned char list_class[256] = {
	['('] = OPENS,
	[')'] = CLOSES,
	['\''] = QUOTE,
	['/'] = SLASH,
	[';'] = ENDS,
};

const char *
step_list_end(const char *at, const char *end)
{
	uint64_t depth = 1;

	while (at < end) {
		unsigned char class = list_class[(unsigned char)*at++];

		if (class == PLAIN)
			continue;
		if (class == ENDS)
			return NULL;
		if (class == OPENS)
			depth++;
		else if (class == CLOSES && --depth == 0)
			return at;
		else if (class == SLASH && at < end && *at == '*')
			at = step_blank_more(at - 1, end);
		else if (class == QUOTE && !(at = step_string_end(at, end)))
			return NULL;
	}
	return NULL;
}

static bool
is_keyword(unsigned char byte)
{
	return (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') ||
		byte == '_' || (byte >= 'a' && byte <= 'z') || byte == '!';
}

const char *
step_keyword_end(const char *at, const char *end)
{
	while (at < end && is_keyword((unsigned char)*at))
		at++;
	return at;
}
