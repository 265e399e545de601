/*
 * One member of a zip archive that is wholly in memory.
 *
 * Every size and offset of the archive's directory is checked against the bytes
 * there are before it is used. Members may be stored or deflated; encrypted
 * ones, archives of several disks and of 4 GB or more (zip64) are refused.
 *
 * source: PKWARE APPNOTE 4.3.7, 4.3.12, 4.3.16; RFC 1951.
 */
#ifndef TESSERA_STEP_ZIP_H
#define TESSERA_STEP_ZIP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "step_load.h"

/* Whether the bytes begin as an archive does. */
bool zip_is(const char *bytes, size_t length);

/*
 * Append the first member, in the order of the directory, whose name ends in
 * .ifc or .ifcxml, in capitals or not, to `out`, and check its CRC. Memory grows
 * with what is unpacked; beyond `max_bytes`, unless 0, it fails with TCS_LIMIT.
 * Fails with TCS_BAD_INPUT for a damaged archive or one without such a member,
 * with TCS_NO_MEMORY.
 */
enum tcs_status zip_member(const char *bytes, size_t length, uint64_t max_bytes,
	struct step_bytes *out, struct tcs_fault *fault) TCS_CHECKED;

#endif
