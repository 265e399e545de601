/*
 * A stream of any bytes: read, decode, check; what is sound is stable and has
 * a text twin. Checksums are mended first, or nothing would get past them.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/fuzz/mend_sums.h"
#include "tests/fuzz/twin_check.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void
read_all(FILE *file)
{
	struct twin_check check = {0};
	struct tcs_reader reader;
	struct tcs_record record = {0};
	struct tcs_fault fault;

	reader_init(&reader, file);
	reader.max_record = 1 << 20;
	while (!reader.ended && !reader_next(&reader, &record, &fault))
		twin_check(&check, &record);
	reader_release(&reader);
	record_release(&record);
	twin_check_release(&check);
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	unsigned char *bytes;
	FILE *file;

	if (size < 16)
		return 0;
	bytes = malloc(size);
	if (!bytes)
		return 0;
	memcpy(bytes, data, size);
	mend_sums(bytes, size);
	file = fmemopen(bytes, size, "rb");
	if (file) {
		read_all(file);
		fclose(file);
	}
	free(bytes);
	return 0;
}
