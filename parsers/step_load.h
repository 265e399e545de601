/*
 * The text of a STEP file, or of ifcXML, in memory: from a file or standard
 * input, plain, gzip, or the first .ifc or .ifcxml member of a zip archive
 * (.ifczip).
 */
#ifndef TESSERA_STEP_LOAD_H
#define TESSERA_STEP_LOAD_H

#include <stdint.h>

#include "array.h"
#include "input.h"

TCS_ARRAY_TYPE(step_bytes, char);

/*
 * Read all of the input, which nothing was read from before, and unpack it.
 * `max_bytes` bounds what is unpacked; 0: no limit. Memory grows with what
 * arrives, or is as large as a regular file, which `jobs` threads read
 * together. The whole text is in memory rather than mapped, so that a file cut
 * short by somebody else while it is read cannot kill the process. Fails as
 * input_read and zip_member do.
 */
enum tcs_status step_load(struct step_bytes *out, struct input *input,
	uint64_t max_bytes, unsigned jobs, struct tcs_fault *fault) TCS_CHECKED;

#endif
