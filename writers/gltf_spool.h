/*
 * A spool: bytes on their way into an output that needs them later.
 *
 * The numbers of a glTF stand behind a JSON text that names their sizes, so
 * they wait in an unnamed temporary file instead of in memory. All zero is a
 * closed spool.
 */
#ifndef TESSERA_GLTF_SPOOL_H
#define TESSERA_GLTF_SPOOL_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "fault.h"

struct spool {
	FILE *file;
	uint64_t size; /* bytes written */
};

/*
 * `beside` names a regular output file: the spool lives in its folder, which
 * has to have the room anyway. NULL: in $TMPDIR, else in /tmp. The file has no
 * name by the time this returns. Fails with TCS_SYSTEM, TCS_NO_MEMORY.
 */
enum tcs_status spool_open(struct spool *spool, const char *beside,
	struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status spool_write(struct spool *spool, const void *bytes, size_t size,
	struct tcs_fault *fault) TCS_CHECKED;

/* Fill with zeros up to a multiple of `unit`, at most 8. */
enum tcs_status spool_align(struct spool *spool, unsigned unit,
	struct tcs_fault *fault) TCS_CHECKED;

/* Append all of it to `to`, whose name is for messages. */
enum tcs_status spool_pour(struct spool *spool, FILE *to, const char *name,
	struct tcs_fault *fault) TCS_CHECKED;

void spool_close(struct spool *spool);

#endif
