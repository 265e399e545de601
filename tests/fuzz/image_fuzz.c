/* The bytes as an image: what is taken of one lies in it, in order. */
#include "lib/image_kind.h"

#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	static const unsigned char none;
	const struct image_bytes from = {size ? bytes : &none, -1, size};
	uint64_t at = 0, part, length, end = 0;
	struct image_kind kind;
	uint32_t width, height;

	if (image_pixels(&from, &width, &height) && !(width && height))
		abort();
	if (image_examine(&from, &kind))
		return 0;
	while ((length = image_part(&from, kind.format, &at, &part)) > 0) {
		if (part < end || length > size - part)
			abort();
		end = part + length;
	}
	return end ? 0 : 1;
}
