#include "image_kind.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

static const char damaged[] = "the image is damaged";

/* Chunks or segments: more are no honest image. */
enum { MOST_PARTS = 65536 };

size_t
image_read(const struct image_bytes *from, uint64_t at, void *to, size_t room)
{
	size_t done = 0;

	if (at >= from->size)
		return 0;
	if (room > from->size - at)
		room = (size_t)(from->size - at);
	if (from->held) {
		memcpy(to, from->held + at, room);
		return room;
	}
	while (done < room) {
		ssize_t got = pread(from->file, (char *)to + done, room - done,
			(off_t)(at + done));

		if (got < 0 && errno == EINTR)
			continue;
		if (got <= 0)
			break;
		done += (size_t)got;
	}
	return done;
}

static uint32_t
big_endian(const unsigned char *bytes, int count)
{
	uint32_t value = 0;

	for (int i = 0; i < count; i++)
		value = value << 8 | bytes[i];
	return value;
}

/* ---- PNG ----------------------------------------------------------------- */

/* Through the chunks to the last one, which proves the image whole. */
static const char *
walk_png(const struct image_bytes *from, struct image_kind *kind)
{
	unsigned char chunk[8];
	uint64_t at = 33;

	for (int i = 0; i < MOST_PARTS; i++) {
		if (image_read(from, at, chunk, 8) < 8)
			return damaged;
		if (!memcmp(chunk + 4, "IEND", 4))
			return at + 12 + (uint64_t)big_endian(chunk, 4) <=
					from->size
				? NULL
				: damaged;
		if (!memcmp(chunk + 4, "tRNS", 4))
			kind->has_alpha = true;
		at += 12 + (uint64_t)big_endian(chunk, 4);
	}
	return damaged;
}

static const char *
examine_png(const struct image_bytes *from, struct image_kind *kind)
{
	unsigned char head[33];

	kind->format = IMAGE_PNG;
	if (image_read(from, 0, head, sizeof head) < sizeof head ||
		big_endian(head + 8, 4) != 13 ||
		memcmp(head + 12, "IHDR", 4) != 0 ||
		!big_endian(head + 16, 4) || !big_endian(head + 20, 4))
		return damaged;
	kind->has_alpha = head[25] & 4;
	return walk_png(from, kind);
}

static bool
is_carried(const unsigned char *name)
{
	static const char names[][5] = {"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};

	for (size_t i = 0; i < sizeof names / sizeof *names; i++)
		if (!memcmp(name, names[i], 4))
			return true;
	return false;
}

static uint64_t
png_part(const struct image_bytes *from, uint64_t *at, uint64_t *part)
{
	unsigned char chunk[8];

	if (!*at) {
		*part = 0;
		return *at = 8;
	}
	while (image_read(from, *at, chunk, 8) == 8) {
		uint64_t size = 12 + (uint64_t)big_endian(chunk, 4);

		*part = *at;
		*at = memcmp(chunk + 4, "IEND", 4) ? *at + size : UINT64_MAX;
		if (is_carried(chunk + 4))
			return size;
	}
	return 0;
}

/* ---- JPEG ---------------------------------------------------------------- */

static bool
is_frame(unsigned char marker)
{
	return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 &&
		marker != 0xc8 && marker != 0xcc;
}

/* Baseline, extended or progressive, in grey or three colours. */
static const char *
examine_frame(const struct image_bytes *from, uint64_t at, unsigned char marker)
{
	unsigned char frame[8];

	if (image_read(from, at + 2, frame, sizeof frame) < sizeof frame ||
		!big_endian(frame + 3, 2) || !big_endian(frame + 5, 2))
		return damaged;
	if (marker > 0xc2 || frame[2] != 8 || (frame[7] != 1 && frame[7] != 3))
		return "this kind of JPEG is not shown by viewers";
	return NULL;
}

static const char *
examine_jpeg(const struct image_bytes *from, struct image_kind *kind)
{
	unsigned char head[4];
	uint64_t at = 2;

	kind->format = IMAGE_JPEG;
	for (int i = 0; i < MOST_PARTS; i++) {
		if (image_read(from, at, head, 4) < 4 || head[0] != 0xff)
			return damaged;
		if (head[1] == 0xff) {
			at++;
			continue;
		}
		if (is_frame(head[1]))
			return examine_frame(from, at, head[1]);
		if (head[1] == 0xda || head[1] == 0xd9)
			return damaged;
		at += 2 + (uint64_t)big_endian(head + 2, 2);
	}
	return damaged;
}

/* ---- WebP ---------------------------------------------------------------- */

static const char *
examine_webp(const struct image_bytes *from, struct image_kind *kind)
{
	unsigned char head[30] = {0};
	uint64_t size;

	kind->format = IMAGE_WEBP;
	if (image_read(from, 0, head, sizeof head) < sizeof head)
		return damaged;
	size = (uint64_t)head[4] | (uint64_t)head[5] << 8 |
		(uint64_t)head[6] << 16 | (uint64_t)head[7] << 24;
	if (size + 8 > from->size)
		return damaged;
	if (!memcmp(head + 12, "VP8X", 4))
		kind->has_alpha = head[20] & 0x10;
	else if (!memcmp(head + 12, "VP8L", 4))
		kind->has_alpha = head[24] & 0x10;
	else if (memcmp(head + 12, "VP8 ", 4) != 0)
		return damaged;
	return NULL;
}

/* ---- the choice ---------------------------------------------------------- */

const char *
image_examine(const struct image_bytes *from, struct image_kind *kind)
{
	static const unsigned char png[8] = {
		0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
	unsigned char head[12] = {0};
	size_t got = image_read(from, 0, head, sizeof head);

	*kind = (struct image_kind){.has_alpha = false};
	if (got >= 8 && !memcmp(head, png, sizeof png))
		return examine_png(from, kind);
	if (got >= 3 && head[0] == 0xff && head[1] == 0xd8 && head[2] == 0xff)
		return examine_jpeg(from, kind);
	if (got == 12 && !memcmp(head, "RIFF", 4) &&
		!memcmp(head + 8, "WEBP", 4))
		return examine_webp(from, kind);
	return "the image is neither JPEG nor PNG nor WebP";
}

uint64_t
image_part(const struct image_bytes *from, enum image_format format,
	uint64_t *at, uint64_t *part)
{
	if (format == IMAGE_PNG)
		return png_part(from, at, part);
	*part = *at;
	*at = from->size;
	return *at - *part;
}

const char *
image_mime(enum image_format format)
{
	static const char *const names[] = {
		"image/jpeg", "image/png", "image/webp"};

	return names[format];
}

/* ---- pixels -------------------------------------------------------------- */

static void
png_pixels(const struct image_bytes *from, uint32_t size[2])
{
	unsigned char header[16];

	if (image_read(from, 8, header, sizeof header) < sizeof header ||
		memcmp(header + 4, "IHDR", 4) != 0)
		return;
	size[0] = big_endian(header + 8, 4);
	size[1] = big_endian(header + 12, 4);
}

static void
jpeg_pixels(const struct image_bytes *from, uint32_t size[2])
{
	unsigned char head[9];
	uint64_t at = 2;

	for (int i = 0; i < MOST_PARTS; i++) {
		if (image_read(from, at, head, 9) < 9 || head[0] != 0xff)
			return;
		if (head[1] == 0xff) {
			at++;
			continue;
		}
		if (is_frame(head[1])) {
			size[0] = big_endian(head + 7, 2);
			size[1] = big_endian(head + 5, 2);
			return;
		}
		at += 2 + (uint64_t)big_endian(head + 2, 2);
	}
}

static uint32_t
tiff_number(const unsigned char *bytes, int count, bool little)
{
	uint32_t value = 0;

	if (!little)
		return big_endian(bytes, count);
	while (count--)
		value = value << 8 | bytes[count];
	return value;
}

/* Entries 256 and 257 of the first directory, each of 16 or 32 bits. */
static void
tiff_pixels(const struct image_bytes *from, bool little, uint32_t size[2])
{
	unsigned char bytes[12];
	uint32_t at, count;

	if (image_read(from, 4, bytes, 4) < 4)
		return;
	at = tiff_number(bytes, 4, little);
	if (image_read(from, at, bytes, 2) < 2)
		return;
	count = tiff_number(bytes, 2, little);
	for (uint32_t i = 0; i < count; i++) {
		uint32_t tag, type;

		if (image_read(from, at + (uint64_t)2 + (uint64_t)12 * i, bytes,
			    12) < 12)
			return;
		tag = tiff_number(bytes, 2, little);
		type = tiff_number(bytes + 2, 2, little);
		if ((tag == 256 || tag == 257) && (type == 3 || type == 4))
			size[tag - 256] = tiff_number(
				bytes + 8, type == 3 ? 2 : 4, little);
	}
}

bool
image_pixels(const struct image_bytes *from, uint32_t *width, uint32_t *height)
{
	unsigned char head[8] = {0};
	uint32_t size[2] = {0, 0};

	image_read(from, 0, head, sizeof head);
	if (!memcmp(head, "\x89PNG\r\n\x1a\n", 8))
		png_pixels(from, size);
	else if (head[0] == 0xff && head[1] == 0xd8)
		jpeg_pixels(from, size);
	else if (!memcmp(head, "II*\0", 4) || !memcmp(head, "MM\0*", 4))
		tiff_pixels(from, head[0] == 'I', size);
	*width = size[0];
	*height = size[1];
	return size[0] && size[1];
}
