/*
 * The textures of a glTF: images of the stream that are really there, each
 * taken into a spool once, when something is painted with it.
 *
 * An image comes from the stream itself or from the folder of images. One that
 * cannot be had is reported once, and what it would paint keeps its colour.
 */
#ifndef TESSERA_GLTF_TEXTURE_H
#define TESSERA_GLTF_TEXTURE_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "byte_index.h"
#include "fault.h"
#include "folder.h"
#include "gltf_material.h"
#include "gltf_spool.h"
#include "image_kind.h"
#include "report.h"
#include "tcs.h"

/* An image that was taken, numbered as in the glTF. */
struct texture_image {
	struct image_kind kind;
	uint64_t start, end; /* in the spool */
	char *name; /* the last part of its URI; owned */
};

/* Numbered as in the glTF. */
struct texture {
	uint32_t image;
	enum texture_wrap wrap;
};

/* All zero, but for the folder and the limit, is empty. */
struct textures {
	struct folder folder;
	uint64_t limit; /* bytes of one image of the folder */
	TCS_ARRAY(struct texture_image) images;
	TCS_ARRAY(struct texture) list;
	struct byte_index by_source; /* URIs met … */
	TCS_ARRAY(uint32_t) of_source; /* … and the image; TCS_NONE: none */
	struct byte_index by_texture; /* same numbers as the list */
};

/*
 * Take image `entry` of the stream from its bytes, as it passes: they are not
 * kept in memory. Fails with TCS_NO_MEMORY or TCS_SYSTEM.
 */
enum tcs_status textures_take(struct textures *textures, uint32_t entry,
	const char *uri, const unsigned char *bytes, uint64_t size,
	struct spool *spool, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * The texture of image `entry` of the stream, from its folder if it was not
 * taken before. *number is TCS_NONE when there is no such image to have. Fails
 * with TCS_NO_MEMORY or TCS_SYSTEM.
 */
enum tcs_status textures_find(struct textures *textures, uint32_t entry,
	const struct tcs_palette *palette, struct spool *spool,
	uint32_t *number, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

void textures_release(struct textures *textures);

#endif
