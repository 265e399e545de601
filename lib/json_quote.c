#include "json_quote.h"

#include <string.h>

#include "utf8.h"

/* One character, or one byte that begins none, which becomes U+FFFD. */
static size_t
json_character(const char *at, size_t length, FILE *to)
{
	size_t size = utf8_length(at, length);

	if (!size) {
		fputs("\\ufffd", to);
		return 1;
	}
	if (size == 1 && (*at == '"' || *at == '\\'))
		fprintf(to, "\\%c", *at);
	else if (size == 1 && ((unsigned char)*at < 0x20 || *at == 0x7f))
		fprintf(to, "\\u%04x", (unsigned)*at);
	else
		fwrite(at, 1, size, to);
	return size;
}

void
json_quote(const char *text, FILE *to)
{
	size_t length = strlen(text);

	putc('"', to);
	while (length) {
		size_t size = json_character(text, length, to);

		text += size;
		length -= size;
	}
	putc('"', to);
}
