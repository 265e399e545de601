#include "step_load.h"

#include <string.h>

#include "crew.h"
#include "step_zip.h"

enum {
	PIECE = 1 << 16, /* bytes read at a time from what is no file */
	PART = 1 << 22, /* bytes of a file that one thread reads */
};

/* ---- a file, by many threads ----------------------------------------------- */

struct loading {
	const struct input *input;
	struct step_bytes *out; /* what was read without a gap */
	size_t size; /* of the file, for all that is known */
	size_t next; /* to be given to a thread */
	bool ended; /* the file is shorter */
};

struct part {
	size_t at, length, got;
};

static enum tcs_status
part_next(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct loading *loading = context;
	struct part *part = slot;
	size_t left = loading->size - loading->next;

	(void)fault;
	*done = !left;
	*part = (struct part){
		.at = loading->next, .length = left < PART ? left : PART};
	loading->next += part->length;
	return TCS_OK;
}

static enum tcs_status
part_read(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	const struct loading *loading = context;
	struct part *part = slot;
	enum tcs_status status = TCS_OK;
	size_t got = 1;

	(void)worker;
	while (!status && got && part->got < part->length) {
		size_t at = part->at + part->got;

		status =
			input_read_at(loading->input, at, loading->out->at + at,
				part->length - part->got, &got, fault);
		part->got += got;
	}
	return status;
}

static enum tcs_status
part_take(void *context, void *slot, struct tcs_fault *fault)
{
	struct loading *loading = context;
	const struct part *part = slot;

	(void)fault;
	if (!loading->ended)
		loading->out->count += part->got;
	loading->ended |= part->got < part->length;
	return TCS_OK;
}

/* Nothing where a file is too large for memory as a whole. */
static enum tcs_status
read_together(struct step_bytes *out, struct input *input, unsigned jobs,
	struct tcs_fault *fault)
{
	struct loading loading = {input, out, (size_t)input->size, 0, false};
	const struct crew_plan plan = {
		.context = &loading,
		.slot_size = sizeof(struct part),
		.read = part_next,
		.work = part_read,
		.write = part_take,
	};
	enum tcs_status status;

	if (array_grow(out, loading.size + 1))
		return TCS_OK;
	status = crew_run(&plan, jobs, fault);
	return status ? status : input_seek(input, out->count, fault);
}

/* ---- anything, as it comes -------------------------------------------------- */

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
	unsigned jobs, struct tcs_fault *fault)
{
	struct step_bytes packed = {.count = 0};
	enum tcs_status status = TCS_OK;

	if (max_bytes && (!input->max_bytes || max_bytes < input->max_bytes))
		input->max_bytes = max_bytes;
	out->count = 0;
	if (jobs > 1 && input_is_plain_file(input) && input->size > PART &&
		(!input->max_bytes || input->size <= input->max_bytes))
		status = read_together(out, input, jobs, fault);
	if (!status)
		status = read_all(out, input, fault);
	if (status || !zip_is(out->at, out->count))
		return status;
	packed = *out;
	*out = (struct step_bytes){.count = 0};
	status = zip_member(packed.at, packed.count, max_bytes, out, fault);
	array_release(&packed);
	return status;
}
