/*
 * A spool: bytes on their way into an output that needs them later.
 *
 * The numbers of a glTF stand behind a JSON text that names their sizes, so
 * they wait: the first SPOOL_HELD bytes in memory, and when there are more,
 * all of them in an unnamed temporary file. All zero is a closed spool.
 */
#ifndef TESSERA_GLTF_SPOOL_H
#define TESSERA_GLTF_SPOOL_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "array.h"
#include "fault.h"

#define SPOOL_HELD (UINT64_C(64) << 20)

struct spool {
	const char *beside; /* borrowed */
	TCS_ARRAY(unsigned char) held;
	FILE *file; /* NULL while all is held */
	uint64_t size; /* bytes written */
};

/*
 * `beside` names a regular output file, for as long as the spool is open: a
 * temporary file goes to its folder, which has to have the room anyway. NULL:
 * to $TMPDIR, else to /tmp.
 */
void spool_open(struct spool *spool, const char *beside);

/* Fails with TCS_SYSTEM, TCS_NO_MEMORY. */
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
