#include <stdint.h>

#include "utf8.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* A text is valid exactly when its characters, taken singly, cover it. */
int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	const char *text = (const char *)bytes;
	size_t at = 0;

	while (at < size) {
		size_t length = utf8_length(text + at, size - at);

		if (length > 4 || length > size - at)
			__builtin_trap();
		if (!length)
			break;
		at += length;
	}
	if (utf8_valid(text, size) != (at == size))
		__builtin_trap();
	return 0;
}
