/*
 * The folder that image files are read from, and nothing outside of it.
 *
 * The names come from a stranger's file. A name is followed step by step from
 * the folder down; absolute names, "..", addresses, symbolic links and what is
 * no regular file are refused, so that no name reaches a file that its author
 * was not given.
 */
#ifndef TESSERA_GLTF_IMAGE_FOLDER_H
#define TESSERA_GLTF_IMAGE_FOLDER_H

#include <stdbool.h>
#include <stdint.h>

#include "fault.h"
#include "gltf_image_kind.h"

struct image_folder {
	const char *name; /* NULL: there is none; borrowed */
	uint64_t limit; /* bytes of one image */
	int file; /* the folder, while is_open */
	bool is_open;
};

/*
 * Open the image of that URI, relative to the folder; '\' is taken for '/',
 * and %XX for its byte when no file is called so literally. *reason is NULL
 * and the caller closes out->file, or it is static text that says why the
 * image cannot be had. Fails when the folder itself cannot be opened.
 */
enum tcs_status image_folder_open(struct image_folder *folder, const char *uri,
	struct image_bytes *out, const char **reason,
	struct tcs_fault *fault) TCS_CHECKED;

void image_folder_close(struct image_folder *folder);

#endif
