#include "simplify/png_write.h"

#include <string.h>
#include <zlib.h>

#include "check.h"

enum { WIDTH = 37, HEIGHT = 21, ROW = 3 * WIDTH };

static uint32_t
number_at(const unsigned char *at)
{
	return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 |
		(uint32_t)at[2] << 8 | at[3];
}

static void
fill(unsigned char pixels[HEIGHT * ROW])
{
	for (int i = 0; i < HEIGHT * ROW; i++)
		pixels[i] = (unsigned char)(i * 7 % 251);
}

/* The bytes are taken apart by hand, chunk after chunk. */
static void
what_was_encoded_comes_back(void)
{
	static unsigned char pixels[HEIGHT * ROW], rows[HEIGHT * (ROW + 1)];
	struct png_bytes png = {0};
	struct tcs_fault fault;
	uLongf length = sizeof rows;
	uint32_t packed;

	fill(pixels);
	CHECK(!png_encode(pixels, WIDTH, HEIGHT, &png, &fault));
	CHECK(!memcmp(png.at, "\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
	CHECK(number_at(png.at + 16) == WIDTH);
	CHECK(number_at(png.at + 20) == HEIGHT);
	CHECK(!memcmp(png.at + 24, "\x8\x2\0\0\0", 5));
	CHECK(number_at(png.at + 29) == crc32(0, png.at + 12, 17));
	packed = number_at(png.at + 33);
	CHECK(!memcmp(png.at + 37, "IDAT", 4));
	CHECK(uncompress(rows, &length, png.at + 41, packed) == Z_OK);
	CHECK(length == sizeof rows);
	for (int y = 0; y < HEIGHT; y++) {
		CHECK(rows[y * (ROW + 1)] == 0);
		CHECK(!memcmp(rows + y * (ROW + 1) + 1, pixels + y * ROW, ROW));
	}
	CHECK(number_at(png.at + 41 + packed) ==
		crc32(0, png.at + 37, packed + 4));
	CHECK(png.count == 41 + packed + 4 + 12);
	CHECK(!memcmp(
		png.at + png.count - 12, "\0\0\0\0IEND\xae\x42\x60\x82", 12));
	array_release(&png);
}

static void
encoding_again_forgets_what_was_there(void)
{
	static unsigned char pixels[HEIGHT * ROW];
	struct png_bytes png = {0};
	struct tcs_fault fault;
	size_t count;

	fill(pixels);
	CHECK(!png_encode(pixels, WIDTH, HEIGHT, &png, &fault));
	count = png.count;
	CHECK(!png_encode(pixels, WIDTH, HEIGHT, &png, &fault));
	CHECK(png.count == count);
	CHECK(!png_encode(pixels, 1, 1, &png, &fault));
	CHECK(png.count < 80);
	array_release(&png);
}

static const struct check_test tests[] = {
	CHECK_TEST(what_was_encoded_comes_back),
	CHECK_TEST(encoding_again_forgets_what_was_there),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
