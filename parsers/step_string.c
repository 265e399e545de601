#include "step_string.h"

#include <string.h>

#include "utf8.h"

enum { REPLACEMENT = 0xfffd, BYTE_ORDER_MARK = 0xfeff, LONGEST = 4 };

struct decoding {
	const char *at, *end;
	char *out;
	unsigned trouble;
	unsigned page;
};

/* windows-1252 from 128 to 159; 0 where it has no character. */
static const uint16_t windows_1252[32] = {0x20ac, 0, 0x201a, 0x192, 0x201e,
	0x2026, 0x2020, 0x2021, 0x2c6, 0x2030, 0x160, 0x2039, 0x152, 0, 0x17d,
	0, 0, 0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014, 0x2dc,
	0x2122, 0x161, 0x203a, 0x153, 0, 0x17e, 0x178};

static void
put(struct decoding *text, uint32_t code)
{
	char *out = text->out;

	if (!code || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) {
		text->trouble |= STEP_NO_CHARACTER;
		code = REPLACEMENT;
	}
	if (code < 0x80) {
		*out++ = (char)code;
	} else if (code < 0x800) {
		*out++ = (char)(0xc0 | code >> 6);
		*out++ = (char)(0x80 | (code & 0x3f));
	} else if (code < 0x10000) {
		*out++ = (char)(0xe0 | code >> 12);
		*out++ = (char)(0x80 | (code >> 6 & 0x3f));
		*out++ = (char)(0x80 | (code & 0x3f));
	} else {
		*out++ = (char)(0xf0 | code >> 18);
		*out++ = (char)(0x80 | (code >> 12 & 0x3f));
		*out++ = (char)(0x80 | (code >> 6 & 0x3f));
		*out++ = (char)(0x80 | (code & 0x3f));
	}
	text->out = out;
}

/* `digits` hexadecimal digits at `at`; false when there are fewer. */
static bool
hex(const char *at, const char *end, int digits, uint32_t *out)
{
	uint32_t value = 0;

	if (end - at < digits)
		return false;
	for (int i = 0; i < digits; i++) {
		char c = at[i];

		if (c >= '0' && c <= '9')
			value = value << 4 | (uint32_t)(c - '0');
		else if (c >= 'A' && c <= 'F')
			value = value << 4 | (uint32_t)(c - 'A' + 10);
		else if (c >= 'a' && c <= 'f')
			value = value << 4 | (uint32_t)(c - 'a' + 10);
		else
			return false;
	}
	*out = value;
	return true;
}

static bool
begins(const struct decoding *text, const char *directive)
{
	size_t length = strlen(directive);

	return (size_t)(text->end - text->at) >= length &&
		!memcmp(text->at, directive, length);
}

/* Digits too few for a character are dropped when \X0\ is behind them. */
static void
decode_remains(struct decoding *text, int digits)
{
	const char *begin = text->at;
	uint32_t digit;

	text->trouble |= STEP_NO_CHARACTER;
	while (--digits > 0 && hex(text->at, text->end, 1, &digit))
		text->at++;
	if (begins(text, "\\X0\\"))
		text->at += 4;
	else
		text->at = begin;
}

/* The characters of \X2\ and \X4\, up to \X0\ or what is not hexadecimal. */
static void
decode_wide(struct decoding *text, int digits)
{
	uint32_t code, low;

	text->at += 4;
	while (hex(text->at, text->end, digits, &code)) {
		text->at += digits;
		if (digits == 4 && code >= 0xd800 && code < 0xdc00 &&
			hex(text->at, text->end, digits, &low) &&
			low >= 0xdc00 && low < 0xe000) {
			text->at += digits;
			code = 0x10000 + ((code - 0xd800) << 10) +
				(low - 0xdc00);
		}
		if (code != BYTE_ORDER_MARK)
			put(text, code);
	}
	if (begins(text, "\\X0\\"))
		text->at += 4;
	else
		decode_remains(text, digits);
}

static void
decode_shifted(struct decoding *text)
{
	unsigned char byte = (unsigned char)text->at[3];

	if (byte >= 0x20 && byte < 0x80)
		put(text, step_pages[text->page][byte - 0x20]);
	else
		put(text, 0);
	text->at += byte == '\'' && begins(text, "\\S\\''") ? 5 : 4;
}

static void
decode_backslash(struct decoding *text)
{
	ptrdiff_t left = text->end - text->at;
	const char *at = text->at;
	uint32_t code;

	if (begins(text, "\\\\")) {
		put(text, '\\');
		text->at += 2;
	} else if (begins(text, "\\X2\\")) {
		decode_wide(text, 4);
	} else if (begins(text, "\\X4\\")) {
		decode_wide(text, 8);
	} else if (begins(text, "\\X\\") && hex(at + 3, text->end, 2, &code)) {
		put(text, code);
		text->at += 5;
	} else if (begins(text, "\\S\\") && left > 3) {
		decode_shifted(text);
	} else if (left > 3 && at[1] == 'P' && at[3] == '\\' && at[2] >= 'A' &&
		at[2] <= 'I') {
		text->page = (unsigned)(at[2] - 'A');
		text->at += 4;
	} else if (begins(text, "\\N\\") || begins(text, "\\F\\")) {
		text->at += 3;
	} else {
		text->trouble |= STEP_STRAY_BACKSLASH;
		put(text, '\\');
		text->at++;
	}
}

static void
decode_raw(struct decoding *text)
{
	unsigned char byte = (unsigned char)*text->at;
	size_t length = utf8_length(text->at, (size_t)(text->end - text->at));

	if (length) {
		text->trouble |= STEP_RAW_BYTES;
		memcpy(text->out, text->at, length);
		text->out += length;
		text->at += length;
		return;
	}
	text->trouble |= STEP_GUESSED_BYTES;
	put(text, byte < 0xa0 ? windows_1252[byte - 0x80] : byte);
	text->at++;
}

static void
decode_one(struct decoding *text)
{
	unsigned char byte = (unsigned char)*text->at;

	if (byte == '\\') {
		decode_backslash(text);
	} else if (byte >= 0x80) {
		decode_raw(text);
	} else {
		if (byte >= ' ' || byte == '\t')
			*text->out++ = (char)byte;
		text->at += byte == '\'' && begins(text, "''") ? 2 : 1;
	}
}

bool
step_is_plain(const char *string, size_t length)
{
	bool plain = true;

	for (size_t i = 0; i < length; i++) {
		unsigned char byte = (unsigned char)string[i];

		plain &= byte >= ' ' && byte < 0x7f && byte != '\\' &&
			byte != '\'';
	}
	return plain;
}

/*
 * One byte becomes at most three, and one more character may be a replacement:
 * the room is enough for any string.
 */
enum tcs_status
step_decode(struct step_text *out, const char *string, size_t length,
	unsigned *trouble, struct tcs_fault *fault)
{
	struct decoding text = {.at = string, .end = string + length};

	if (length > SIZE_MAX / 4 || array_grow(out, length * 3 + LONGEST))
		return fault_memory(fault);
	text.out = out->at + out->count;
	while (text.at < text.end)
		decode_one(&text);
	*text.out = '\0';
	out->count = (size_t)(text.out - out->at);
	*trouble |= text.trouble;
	return TCS_OK;
}
