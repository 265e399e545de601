#include "utf8.h"

#include <stdint.h>
#include <string.h>

static bool
is_tail(unsigned char byte)
{
	return (byte & 0xc0) == 0x80;
}

size_t
utf8_length(const char *bytes, size_t length)
{
	const unsigned char *at = (const unsigned char *)bytes;
	unsigned char lead = at[0];

	if (lead < 0x80)
		return 1;
	if (lead < 0xc2 || lead > 0xf4 || length < 2 || !is_tail(at[1]))
		return 0;
	if (lead < 0xe0)
		return 2;
	if (length < 3 || !is_tail(at[2]))
		return 0;
	if (lead < 0xf0) {
		/* overlong below U+0800; surrogates from U+D800 */
		bool bad = (lead == 0xe0 && at[1] < 0xa0) ||
			(lead == 0xed && at[1] > 0x9f);
		return bad ? 0 : 3;
	}
	if (length < 4 || !is_tail(at[3]))
		return 0;
	/* overlong below U+10000; nothing beyond U+10FFFF */
	if ((lead == 0xf0 && at[1] < 0x90) || (lead == 0xf4 && at[1] > 0x8f))
		return 0;
	return 4;
}

/* The count of leading bytes that are plain ASCII, eight at a time. */
static size_t
ascii_run(const char *bytes, size_t length)
{
	size_t at = 0;
	uint64_t eight;

	while (length - at >= sizeof eight) {
		memcpy(&eight, bytes + at, sizeof eight);
		if (eight & 0x8080808080808080u)
			break;
		at += sizeof eight;
	}
	return at;
}

bool
utf8_valid(const char *bytes, size_t length)
{
	size_t at = 0;

	while (at < length) {
		size_t step;

		at += ascii_run(bytes + at, length - at);
		if (at == length)
			break;
		step = utf8_length(bytes + at, length - at);
		if (!step)
			return false;
		at += step;
	}
	return true;
}
