/* tcs2json: a component stream as lines of JSON. */
#include <stdlib.h>

#include "crew.h"
#include "json_record.h"
#include "output.h"
#include "program.h"
#include "report.h"
#include "tally_report.h"
#include "tcs.h"

/* A record on its way from the stream to the text. */
struct item {
	struct tcs_record record;
	struct json_text json;
};

struct run {
	FILE *in;
	struct output out;
	struct tcs_reader reader;
	struct json_decoder *decoders; /* one per job */
	struct item *items;
	size_t item_count;
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
print_item(void *context, void *slot, size_t worker, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;

	json_text_clear(&item->json);
	return print_record(
		&item->json, &run->decoders[worker], &item->record, fault);
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct run *run = context;
	const struct item *item = slot;
	size_t length = item->json.bytes.count;

	if (fwrite(item->json.bytes.at, 1, length, run->out.file) != length)
		return fault_system(fault, "cannot write",
			run->out.name ? run->out.name : "standard output");
	return TCS_OK;
}

static enum tcs_status
open_run(struct run *run, const struct command *command, uint64_t max_record,
	struct tcs_fault *fault)
{
	run->item_count = crew_slots(command->jobs);
	run->items = calloc(run->item_count, sizeof *run->items);
	run->decoders = calloc(command->jobs, sizeof *run->decoders);
	if (!run->items || !run->decoders)
		return fault_memory(fault);
	run->in = command->input ? fopen(command->input, "rb") : stdin;
	if (!run->in)
		return fault_system(fault, "cannot open", command->input);
	reader_init(&run->reader, run->in);
	run->reader.max_record = max_record;
	return output_open(&run->out, command->output, fault);
}

static enum tcs_status
convert(struct run *run, const struct command *command, uint64_t max_record,
	struct tcs_fault *fault)
{
	enum tcs_status status = open_run(run, command, max_record, fault);
	struct crew_plan plan = {
		.context = run,
		.slots = run->items,
		.slot_size = sizeof *run->items,
		.slot_count = run->item_count,
		.read = read_item,
		.work = print_item,
		.write = write_item,
	};

	if (!status)
		status = crew_run(&plan, command->jobs, fault);
	if (!status)
		status = output_commit(&run->out, fault);
	else
		output_discard(&run->out);
	return status;
}

static void
close_run(struct run *run, const struct command *command)
{
	for (size_t i = 0; run->items && i < run->item_count; i++) {
		record_release(&run->items[i].record);
		json_text_release(&run->items[i].json);
	}
	for (size_t i = 0; run->decoders && i < command->jobs; i++)
		json_decoder_release(&run->decoders[i]);
	free(run->items);
	free(run->decoders);
	reader_release(&run->reader);
	if (run->in && run->in != stdin)
		fclose(run->in);
}

static enum tcs_status
write_stats(const struct command *command, const struct tcs_tally *tally,
	struct tcs_fault *fault)
{
	struct report report = {0};
	enum tcs_status status;

	if (!command->stats)
		return TCS_OK;
	status = tally_report(tally, &report, fault);
	if (!status)
		status = report_write(
			&report, command->program->name, command->stats, fault);
	report_release(&report);
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
	struct tcs_fault fault;
	struct run run = {0};
	enum tcs_status status;
	int code = EXIT_DONE;

	program_begin(&program, argc, argv, &command);
	status = convert(&run, &command, max_record, &fault);
	if (!status)
		status = write_stats(&command, &run.reader.tally, &fault);
	if (status)
		code = program_fail(&command, &fault);
	close_run(&run, &command);
	program_end(&command);
	return code;
}
