/* tcs2json: a component stream as lines of JSON. */
#include "crew.h"
#include "json_record.h"
#include "stage.h"
#include "tally_report.h"
#include "tcs.h"

/* A record on its way from the stream to the text. */
struct item {
	struct tcs_record record;
	struct json_text json;
};

struct run {
	struct stage *stage;
	struct tcs_reader reader;
};

static enum tcs_status
read_item(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;

	*done = run->reader.ended;
	return *done ? TCS_OK : reader_next(&run->reader, &item->record, fault);
}

static enum tcs_status
print_item(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct item *item = slot;

	(void)context;
	json_text_clear(&item->json);
	return print_record(&item->json, worker, &item->record, fault);
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct run *run = context;
	const struct item *item = slot;
	const struct output *out = &run->stage->out;
	size_t length = item->json.bytes.count;

	if (fwrite(item->json.bytes.at, 1, length, out->file) != length)
		return fault_system(fault, "cannot write", out->name);
	return TCS_OK;
}

static void
release_item(void *slot)
{
	struct item *item = slot;

	record_release(&item->record);
	json_text_release(&item->json);
}

static void
release_decoder(void *worker)
{
	json_decoder_release(worker);
}

static enum tcs_status
print_stream(struct run *run, struct tcs_fault *fault)
{
	const struct command *command = run->stage->command;
	const struct crew_plan plan = {
		.context = run,
		.slot_size = sizeof(struct item),
		.worker_size = sizeof(struct json_decoder),
		.read = read_item,
		.work = print_item,
		.write = write_item,
		.worker_release = release_decoder,
		.slot_release = release_item,
	};
	enum tcs_status status =
		output_open(&run->stage->out, command->output, fault);

	if (!status)
		status = crew_run(&plan, command->jobs, fault);
	return status
		? status
		: tally_report(&run->reader.tally, &run->stage->report, fault);
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	const uint64_t *max_record = context;
	struct run run = {.stage = stage};
	enum tcs_status status = reader_open(
		&run.reader, stage->command->input, *max_record, fault);

	if (!status)
		status = print_stream(&run, fault);
	reader_close(&run.reader);
	return status;
}

int
main(int argc, char **argv)
{
	uint64_t max_record = TCS_MAX_RECORD;
	const struct option_row options[] = {
		{.type = OPTION_BYTES,
			.name = "max-record",
			.argument = "BYTES",
			.help = "Refuse records of more bytes (default: 8G).",
			.target = &max_record},
		{0},
	};
	const struct program program = {
		.name = "tcs2json",
		.synopsis = "[options] [in [out]]",
		.summary = "Print a component stream as lines of JSON.",
		.options = options,
		.flags = PROGRAM_READS | PROGRAM_BINARY_IN,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	code = stage_run(&command, convert, &max_record);
	program_end(&command);
	return code;
}
