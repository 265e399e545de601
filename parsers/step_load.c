#include "step_load.h"

#include <string.h>

#include "step_zip.h"

enum { PIECE = 1 << 16 };

static enum tcs_status
read_all(struct step_bytes *out, struct input *input, struct tcs_fault *fault)
{
	size_t got;

	do {
		enum tcs_status status;

		if (out->count == out->room && array_grow(out, PIECE))
			return fault_memory(fault);
		status = input_read(input, out->at + out->count,
			out->room - out->count, &got, fault);
		if (status)
			return status;
		out->count += got;
	} while (got);
	return TCS_OK;
}

enum tcs_status
step_load(struct step_bytes *out, struct input *input, uint64_t max_bytes,
	struct tcs_fault *fault)
{
	struct step_bytes packed = {.count = 0};
	enum tcs_status status;

	if (max_bytes && (!input->max_bytes || max_bytes < input->max_bytes))
		input->max_bytes = max_bytes;
	out->count = 0;
	status = read_all(out, input, fault);
	if (status || !zip_is(out->at, out->count))
		return status;
	packed = *out;
	*out = (struct step_bytes){.count = 0};
	status = zip_member(packed.at, packed.count, max_bytes, out, fault);
	array_release(&packed);
	return status;
}
