/*
 * A city becomes files: one GLB, or a .gltf with its .bin.
 */
#ifndef TESSERA_GLTF_FILE_H
#define TESSERA_GLTF_FILE_H

#include <stdbool.h>

#include "fault.h"
#include "gltf_city.h"
#include "gltf_stream.h"
#include "output.h"

/* All zero is empty. The outputs are the caller's. */
struct gltf_file {
	struct output *json; /* or the GLB */
	struct output *bin; /* of a pair; NULL for a GLB */
	char *bin_name; /* owned */
	char *bin_uri; /* owned */
};

/*
 * Open the outputs: a GLB, or with a `bin` a pair, which needs a name that can
 * be a regular file. The file must outlive them.
 */
enum tcs_status file_open(struct gltf_file *file, const char *name,
	struct output *json, struct output *bin,
	struct tcs_fault *fault) TCS_CHECKED;

/* The folder of spools: see gltf_spool.h. */
const char *file_beside(const struct gltf_file *file);

/*
 * Complete the city and write it. With `translate`, the root node moves the
 * city to its origin; that needs a system whose axes are straight.
 */
enum tcs_status file_write(struct gltf_file *file, struct city *city,
	const struct stream_head *head, bool translate,
	struct tcs_fault *fault) TCS_CHECKED;

void file_release(struct gltf_file *file);

#endif
