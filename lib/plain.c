#include "plain.h"

#include <stdbool.h>
#include <string.h>

#include "utf8.h"

static bool
is_control(const unsigned char *at, size_t size)
{
	if (size == 1)
		return *at < 0x20 || *at == 0x7f;
	return size == 2 && at[0] == 0xc2 && at[1] < 0xa0;
}

void
plain_print(FILE *to, const char *text)
{
	size_t length = strlen(text);

	while (length) {
		size_t size = utf8_length(text, length);

		if (!size || is_control((const unsigned char *)text, size)) {
			putc('?', to);
			size += !size;
		} else {
			fwrite(text, 1, size, to);
		}
		text += size;
		length -= size;
	}
}
