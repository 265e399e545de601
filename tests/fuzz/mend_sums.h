/* Checksums of a stream of any bytes, set right: nothing would get past them. */
#ifndef TESSERA_MEND_SUMS_H
#define TESSERA_MEND_SUMS_H

#include <stdint.h>
#include <string.h>
#include <zlib.h>

static inline void
mend_sums(unsigned char *bytes, size_t size)
{
	size_t at = 16;

	while (size >= at && size - at >= 32) {
		uint64_t stored;
		uint32_t crc;

		memcpy(&stored, bytes + at + 8, sizeof stored);
		if (stored > size - at - 32)
			return;
		crc = (uint32_t)crc32_z(0, bytes + at, 28);
		crc = (uint32_t)crc32_z(crc, bytes + at + 32, stored);
		memcpy(bytes + at + 28, &crc, sizeof crc);
		at += 32 + stored;
	}
}

#endif
