/* Bytes to a stdio stream, as they are or through gzip. */
#ifndef TESSERA_CITYGML_SINK_H
#define TESSERA_CITYGML_SINK_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "fault.h"

struct sink {
	FILE *file; /* borrowed */
	void *gzip; /* zlib's state; NULL for plain bytes */
	uint64_t bytes; /* put so far */
};

/* `level` 0: as they are; 1…9: gzip. Fails with TCS_NO_MEMORY. */
enum tcs_status sink_open(struct sink *sink, FILE *file, int level,
	struct tcs_fault *fault) TCS_CHECKED;
/* Fails with TCS_SYSTEM. */
enum tcs_status sink_put(struct sink *sink, const void *bytes, size_t length,
	struct tcs_fault *fault) TCS_CHECKED;
/* Write what is held. Without it a gzip stays incomplete. */
enum tcs_status sink_finish(
	struct sink *sink, struct tcs_fault *fault) TCS_CHECKED;
void sink_release(struct sink *sink);

#endif
