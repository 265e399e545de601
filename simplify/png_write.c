#include "png_write.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

static void
put_number(unsigned char *at, uint32_t number)
{
	for (int i = 0; i < 4; i++)
		at[i] = (unsigned char)(number >> (24 - 8 * i));
}

static enum tcs_status
put_chunk(struct png_bytes *out, const char *type, const unsigned char *data,
	uint32_t length, struct tcs_fault *fault)
{
	unsigned char *at;

	if (array_grow(out, (size_t)length + 12))
		return fault_memory(fault);
	at = out->at + out->count;
	put_number(at, length);
	memcpy(at + 4, type, 4);
	if (length > 0)
		memcpy(at + 8, data, length);
	put_number(at + 8 + length,
		(uint32_t)crc32(crc32(0, NULL, 0), at + 4, length + 4));
	out->count += (size_t)length + 12;
	return TCS_OK;
}

/* Rows with a leading 0, no filter, deflated. */
static enum tcs_status
put_rows(struct png_bytes *out, const unsigned char *pixels, uint32_t width,
	uint32_t height, struct tcs_fault *fault)
{
	size_t row = 3 * (size_t)width;
	uLong length = (uLong)((row + 1) * height);
	uLongf packed_length = compressBound(length);
	unsigned char *raw = malloc(length), *packed = malloc(packed_length);
	enum tcs_status status = TCS_OK;

	if (!raw || !packed)
		status = fault_memory(fault);
	for (uint32_t y = 0; !status && y < height; y++) {
		raw[y * (row + 1)] = 0;
		memcpy(raw + y * (row + 1) + 1, pixels + y * row, row);
	}
	if (!status &&
		compress2(packed, &packed_length, raw, length, 6) != Z_OK)
		status = fault_memory(fault);
	if (!status)
		status = put_chunk(
			out, "IDAT", packed, (uint32_t)packed_length, fault);
	free(raw);
	free(packed);
	return status;
}

enum tcs_status
png_encode(const unsigned char *pixels, uint32_t width, uint32_t height,
	struct png_bytes *out, struct tcs_fault *fault)
{
	static const unsigned char signature[8] = {
		0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
	unsigned char head[13] = {
		[8] = 8, /* bits a channel */
		[9] = 2, /* red, green, blue */
	};
	enum tcs_status status;

	array_clear(out);
	if (array_grow(out, sizeof signature))
		return fault_memory(fault);
	memcpy(out->at, signature, sizeof signature);
	out->count = sizeof signature;
	put_number(head, width);
	put_number(head + 4, height);
	status = put_chunk(out, "IHDR", head, sizeof head, fault);
	if (!status)
		status = put_rows(out, pixels, width, height, fault);
	if (!status)
		status = put_chunk(out, "IEND", NULL, 0, fault);
	return status;
}
