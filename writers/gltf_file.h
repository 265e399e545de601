/*
 * A city becomes files: one GLB, or a .gltf with its .bin. Nothing appears
 * under its name before everything is written.
 */
#ifndef TESSERA_GLTF_FILE_H
#define TESSERA_GLTF_FILE_H

#include <stdbool.h>

#include "fault.h"
#include "gltf_city.h"
#include "gltf_stream.h"
#include "output.h"

struct gltf_file {
	struct output json; /* or the GLB */
	struct output bin; /* of a pair */
	bool is_pair;
	char *bin_name; /* owned */
	char *bin_uri; /* owned */
};

/* A pair needs a name that can be a regular file. */
enum tcs_status file_open(struct gltf_file *file, const char *name,
	bool is_pair, struct tcs_fault *fault) TCS_CHECKED;

/* The folder of spools: see gltf_spool.h. */
const char *file_beside(const struct gltf_file *file);

/*
 * Complete the city and write it. With `translate`, the root node moves the
 * city to its origin; that needs a system whose axes are straight.
 */
enum tcs_status file_write(struct gltf_file *file, struct city *city,
	const struct stream_head *head, bool translate,
	struct tcs_fault *fault) TCS_CHECKED;

/* Let the file or the pair appear. */
enum tcs_status file_commit(
	struct gltf_file *file, struct tcs_fault *fault) TCS_CHECKED;

/* Remove what was not committed; harmless after a commit. */
void file_discard(struct gltf_file *file);

#endif
