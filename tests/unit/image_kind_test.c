#include "check.h"
#include "lib/image_kind.h"

#include <string.h>

static const unsigned char png[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n',
	0, 0, 0, 13, 'I', 'H', 'D', 'R', 0, 0, 0, 1, 0, 0, 0, 1, 8, 3, 0, 0, 0,
	1, 2, 3, 4, /* its CRC; none is looked at */
	0, 0, 0, 9, 'p', 'H', 'Y', 's', 0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 2, 3, 4,
	0, 0, 0, 1, 't', 'R', 'N', 'S', 0, 1, 2, 3, 4, /* */
	0, 0, 0, 2, 'I', 'D', 'A', 'T', 7, 7, 1, 2, 3, 4, /* */
	0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};

static const unsigned char jpeg[] = {0xff, 0xd8, 0xff, 0xe0, 0, 4, 'J', 'F',
	0xff, 0xff, 0xc0, 0, 17, 8, 0, 5, 0, 6, 3, 1, 0x11, 0, 2, 0x11, 1, 3,
	0x11, 1, 0xff, 0xda};

static const char *
examine(const unsigned char *bytes, size_t size, struct image_kind *kind)
{
	const struct image_bytes from = {bytes, -1, size};

	return image_examine(&from, kind);
}

static void
a_png_is_known_with_its_transparency(void)
{
	unsigned char other[sizeof png];
	struct image_kind kind;

	CHECK(!examine(png, sizeof png, &kind));
	CHECK(kind.format == IMAGE_PNG && kind.has_alpha);
	memcpy(other, png, sizeof png);
	memcpy(other + 58, "tEXt", 4);
	CHECK(!examine(other, sizeof other, &kind) && !kind.has_alpha);
	other[25] = 6;
	CHECK(!examine(other, sizeof other, &kind) && kind.has_alpha);
}

static void
no_prefix_of_a_png_is_an_image(void)
{
	struct image_kind kind;

	for (size_t i = 0; i < sizeof png; i++)
		CHECK(examine(png, i, &kind));
}

static void
chunks_of_a_wrong_length_are_damage(void)
{
	unsigned char other[sizeof png];
	struct image_kind kind;

	memcpy(other, png, sizeof png);
	other[84] = 1;
	CHECK(examine(other, sizeof other, &kind));
	memcpy(other, png, sizeof png);
	other[11]++;
	CHECK(examine(other, sizeof other, &kind));
}

static void
what_a_png_says_of_its_pixels_size_stays_behind(void)
{
	const struct image_bytes from = {png, -1, sizeof png};
	static const uint64_t starts[] = {0, 8, 54, 67, 81};
	static const uint64_t sizes[] = {8, 25, 13, 14, 12};
	uint64_t at = 0, part = 0;

	for (size_t i = 0; i < 5; i++) {
		CHECK(image_part(&from, IMAGE_PNG, &at, &part) == sizes[i]);
		CHECK(part == starts[i]);
	}
	CHECK(!image_part(&from, IMAGE_PNG, &at, &part));
}

static void
a_jpeg_is_known_by_its_frame(void)
{
	const struct image_bytes from = {jpeg, -1, sizeof jpeg};
	unsigned char other[sizeof jpeg];
	struct image_kind kind;
	uint64_t at = 0, part = 1;

	CHECK(!examine(jpeg, sizeof jpeg, &kind));
	CHECK(kind.format == IMAGE_JPEG && !kind.has_alpha);
	CHECK(image_part(&from, IMAGE_JPEG, &at, &part) == sizeof jpeg);
	CHECK(part == 0 && !image_part(&from, IMAGE_JPEG, &at, &part));
	for (size_t i = 0; i < 19; i++)
		CHECK(examine(jpeg, i, &kind));
	memcpy(other, jpeg, sizeof jpeg);
	other[10] = 0xc9; /* arithmetic coding */
	CHECK(examine(other, sizeof other, &kind));
	other[10] = 0xc2;
	CHECK(!examine(other, sizeof other, &kind));
	other[18] = 4; /* CMYK */
	CHECK(examine(other, sizeof other, &kind));
}

static void
a_webp_is_known_with_its_transparency(void)
{
	unsigned char webp[30] = "RIFF\26\0\0\0WEBPVP8X\12\0\0\0\20";
	struct image_kind kind;

	CHECK(!examine(webp, sizeof webp, &kind));
	CHECK(kind.format == IMAGE_WEBP && kind.has_alpha);
	memcpy(webp + 12, "VP8 ", 4);
	CHECK(!examine(webp, sizeof webp, &kind) && !kind.has_alpha);
	CHECK(examine(webp, sizeof webp - 1, &kind));
	webp[4]++;
	CHECK(examine(webp, sizeof webp, &kind));
}

static void
anything_else_is_none(void)
{
	struct image_kind kind;

	CHECK(examine((const unsigned char *)"II*", 4, &kind));
	CHECK(examine((const unsigned char *)"", 0, &kind));
}

static bool
has_pixels(const unsigned char *bytes, size_t size, uint32_t width,
	uint32_t height)
{
	const struct image_bytes from = {bytes, -1, size};
	uint32_t w, h;

	return image_pixels(&from, &w, &h) && w == width && h == height;
}

static void
headers_tell_the_pixels(void)
{
	static const unsigned char little[] = {'I', 'I', '*', 0, 8, 0, 0, 0, 2,
		0, 0, 1, 3, 0, 1, 0, 0, 0, 5, 0, 9, 9, 1, 1, 4, 0, 1, 0, 0, 0,
		6, 1, 0, 0};
	static const unsigned char big[] = {'M', 'M', 0, '*', 0, 0, 0, 8, 0, 2,
		1, 0, 0, 3, 0, 0, 0, 1, 0, 5, 9, 9, 1, 1, 0, 4, 0, 0, 0, 1, 0,
		0, 1, 6};
	unsigned char other[sizeof png];

	CHECK(has_pixels(png, sizeof png, 1, 1));
	CHECK(has_pixels(jpeg, sizeof jpeg, 6, 5));
	CHECK(has_pixels(little, sizeof little, 5, 262));
	CHECK(has_pixels(big, sizeof big, 5, 262));
	memcpy(other, png, sizeof png);
	other[23] = 0;
	CHECK(!has_pixels(other, sizeof other, 1, 0));
	for (size_t i = 0; i < sizeof big; i++)
		CHECK(!has_pixels(big, i, 5, 262));
	for (size_t i = 0; i < 18; i++)
		CHECK(!has_pixels(jpeg, i, 6, 5));
	CHECK(!has_pixels((const unsigned char *)"", 0, 0, 0));
}

int
main(void)
{
	static const struct check_test tests[] = {
		CHECK_TEST(a_png_is_known_with_its_transparency),
		CHECK_TEST(no_prefix_of_a_png_is_an_image),
		CHECK_TEST(chunks_of_a_wrong_length_are_damage),
		CHECK_TEST(what_a_png_says_of_its_pixels_size_stays_behind),
		CHECK_TEST(a_jpeg_is_known_by_its_frame),
		CHECK_TEST(a_webp_is_known_with_its_transparency),
		CHECK_TEST(anything_else_is_none),
		CHECK_TEST(headers_tell_the_pixels),
		{0},
	};

	return check_run(tests);
}
