/* Lines of any bytes: what builds a sound record is stable. */
#include <stdint.h>
#include <string.h>

#include "tests/fuzz/twin_check.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	const char *at = (const char *)data, *end = at + size;
	struct twin_check check = {0};
	struct json_builder builder = {0};
	struct tcs_record record = {0};
	uint64_t number = 0;

	/* as if all that a record may name stood before it */
	record.before.materials = record.before.images =
		record.before.prototypes = UINT32_MAX;
	while (at < end) {
		const char *stop = memchr(at, '\n', (size_t)(end - at));
		struct tcs_tally claimed;
		struct tcs_fault fault;

		stop = stop ? stop : end;
		if (!json_build_line(&builder, at, (size_t)(stop - at),
			    ++number, &record, &claimed, &fault))
			twin_check(&check, &record);
		at = stop + (stop < end);
	}
	json_builder_release(&builder);
	record_release(&record);
	twin_check_release(&check);
	return 0;
}
