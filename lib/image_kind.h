/*
 * What the bytes of an image are, told by themselves and not by a name.
 *
 * Only headers are looked at, and nothing is decoded: enough to know that a
 * viewer will take the image for what it is said to be, and how many pixels it
 * has.
 *
 * source: PNG (W3C, 2nd edition) 5.2, 11.2.2, 11.3.2; JPEG ITU-T T.81 B.1;
 * WebP container specification; TIFF 6.0, sections 2 and 8.
 */
#ifndef TESSERA_IMAGE_KIND_H
#define TESSERA_IMAGE_KIND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum image_format { IMAGE_JPEG, IMAGE_PNG, IMAGE_WEBP };

struct image_kind {
	enum image_format format;
	bool has_alpha; /* some of it may be transparent */
};

/* Where the bytes are: in memory, or else in an open regular file. */
struct image_bytes {
	const unsigned char *held; /* NULL: in the file */
	int file;
	uint64_t size;
};

/* Copy up to `room` bytes from `at`; fewer at the end or on a read error. */
size_t image_read(
	const struct image_bytes *from, uint64_t at, void *to, size_t room);

/* NULL with *kind filled, or the reason why not: static text. */
const char *image_examine(
	const struct image_bytes *from, struct image_kind *kind);

/*
 * Pixels of a JPEG, a PNG or a TIFF, neither 0. False for other bytes.
 */
bool image_pixels(
	const struct image_bytes *from, uint32_t *width, uint32_t *height);

/*
 * The next part of an examined image, from *at on, that goes into a glTF: its
 * size, or 0 at the end. *part is where it begins, and *at moves behind it. Of
 * a PNG that is the header, the palette, the transparency and the pixels; the
 * other chunks (colour profiles, pixel sizes, texts) are what glTF has viewers
 * ignore (3.8.3). Other formats are one part.
 */
uint64_t image_part(const struct image_bytes *from, enum image_format format,
	uint64_t *at, uint64_t *part);

/* "image/png" */
const char *image_mime(enum image_format format);

#endif
