#include "base64.h"

#include <stdint.h>

static const char digits[] =
	"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

void
base64_encode(char *out, const unsigned char *bytes, size_t length)
{
	for (size_t at = 0; at < length; at += 3) {
		size_t left = length - at;
		uint32_t group = (uint32_t)bytes[at] << 16;

		if (left > 1)
			group |= (uint32_t)bytes[at + 1] << 8;
		if (left > 2)
			group |= bytes[at + 2];
		*out++ = digits[group >> 18];
		*out++ = digits[group >> 12 & 63];
		*out++ = left > 1 ? digits[group >> 6 & 63] : '=';
		*out++ = left > 2 ? digits[group & 63] : '=';
	}
}

/* The value of a digit; 64 for what is none. */
static uint32_t
value_of(char digit)
{
	if (digit >= 'A' && digit <= 'Z')
		return (uint32_t)(digit - 'A');
	if (digit >= 'a' && digit <= 'z')
		return (uint32_t)(digit - 'a') + 26;
	if (digit >= '0' && digit <= '9')
		return (uint32_t)(digit - '0') + 52;
	return digit == '+' ? 62 : digit == '/' ? 63 : 64;
}

int
base64_decode(
	unsigned char *out, size_t *count, const char *text, size_t length)
{
	size_t padding = 0;

	*count = 0;
	if (length % 4)
		return -1;
	while (length && padding < 2 && text[length - 1 - padding] == '=')
		padding++;
	for (size_t at = 0; at < length; at += 4) {
		size_t have = at + 4 < length ? 4 : 4 - padding;
		uint32_t group = 0;

		for (size_t i = 0; i < 4; i++) {
			uint32_t value = i < have ? value_of(text[at + i]) : 0;

			if (value > 63)
				return -1;
			group = group << 6 | value;
		}
		/* bits behind the last byte are zero, or two texts would
		   mean the same bytes */
		if ((have < 4 && group & 0xff) || (have < 3 && group & 0xffff))
			return -1;
		out[(*count)++] = (unsigned char)(group >> 16);
		if (have > 2)
			out[(*count)++] = (unsigned char)(group >> 8);
		if (have > 3)
			out[(*count)++] = (unsigned char)group;
	}
	return 0;
}
