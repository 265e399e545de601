/* tcs2json: a component stream as lines of JSON. */
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
	size_t length = item->json.bytes.count;

	if (fwrite(item->json.bytes.at, 1, length, run->out.file) != length)
		return fault_system(fault, "cannot write",
			run->out.name ? run->out.name : "standard output");
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
open_run(struct run *run, const struct command *command, uint64_t max_record,
	struct tcs_fault *fault)
{
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

	if (!status)
		status = crew_run(&plan, command->jobs, fault);
	if (!status)
		status = output_commit(&run->out, fault);
	else
		output_discard(&run->out);
	return status;
}

static void
close_run(struct run *run)
{
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
	close_run(&run);
	program_end(&command);
	return code;
}
