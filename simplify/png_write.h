/* A picture of 8-bit red, green and blue as the bytes of a PNG file. */
#ifndef TESSERA_PNG_WRITE_H
#define TESSERA_PNG_WRITE_H

#include <stdint.h>

#include "array.h"
#include "fault.h"

TCS_ARRAY_TYPE(png_bytes, unsigned char);

/*
 * Encode; `pixels` are rows from the top, three bytes each, and what `out` held
 * is forgotten. At most 2¹⁴ pixels wide and high. Fails with TCS_NO_MEMORY.
 *
 * source: Portable Network Graphics (2nd edition), W3C 2003, 5.3 and 11.2.
 */
enum tcs_status png_encode(const unsigned char *pixels, uint32_t width,
	uint32_t height, struct png_bytes *out,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
