/* json2tcs: lines of JSON, as tcs2json prints them, as a component stream. */
#include <stdio.h>
#include <string.h>

#include "crew.h"
#include "input.h"
#include "json_build.h"
#include "json_lines.h"
#include "output.h"
#include "program.h"
#include "report.h"
#include "tally_report.h"
#include "tcs.h"

#define COMPRESSION 6 /* zlib's level with -z */

/* A line on its way to the stream. */
struct item {
	struct line_bytes line;
	uint64_t number;
	struct tcs_record record;
	struct tcs_tally claimed;
};

struct run {
	const struct command *command;
	struct input in;
	struct line_reader lines;
	struct output out;
	struct tcs_writer writer;
	struct json_builder checked; /* what the writer decodes to check it */
	bool ended;
};

struct wishes {
	uint64_t max_record;
	bool compress;
};

/* Name the line in a fault that does not know it. */
static enum tcs_status
blame_line(struct tcs_fault *fault, const struct item *item)
{
	char text[sizeof fault->text];

	memcpy(text, fault->text, sizeof text);
	return fault_set(fault, fault->status, TCS_NOWHERE, "line %llu: %s",
		(unsigned long long)item->number, text);
}

static enum tcs_status
read_item(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	enum tcs_status status =
		lines_next(&run->lines, &item->line, done, fault);

	item->number = run->lines.line;
	return status;
}

static enum tcs_status
build_item(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct item *item = slot;

	(void)context;
	return json_build_line(worker, item->line.at, item->line.count,
		item->number, &item->record, &item->claimed, fault);
}

/* Whoever reads the stream will check it; better to say now what is wrong. */
static enum tcs_status
check_record(struct json_builder *checked, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	switch (record->type) {
	case TCS_HEAD:
		return head_decode(&checked->head, record, fault);
	case TCS_PALETTE:
		return palette_decode(&checked->palette, record, fault);
	case TCS_OBJECT:
	case TCS_PROTOTYPE:
		return object_decode(&checked->object, record, fault);
	default:
		return TCS_OK;
	}
}

static enum tcs_status
end_stream(struct run *run, const struct item *item, struct tcs_fault *fault)
{
	run->ended = true;
	if (run->command->strict &&
		memcmp(&item->claimed, &run->writer.tally,
			sizeof item->claimed) != 0) {
		fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"the end does not count what passed");
		return blame_line(fault, item);
	}
	return writer_end(&run->writer, fault);
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	enum tcs_status status;

	if (run->ended) {
		fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"something follows the end");
		return blame_line(fault, item);
	}
	if (item->record.type == TCS_END)
		return end_stream(run, item, fault);
	item->record.before = run->writer.tally;
	status = check_record(&run->checked, &item->record, fault);
	if (!status)
		status = writer_put(&run->writer, &item->record, fault);
	return status == TCS_BAD_INPUT ? blame_line(fault, item) : status;
}

static void
release_item(void *slot)
{
	struct item *item = slot;

	array_release(&item->line);
	record_release(&item->record);
}

static void
release_builder(void *worker)
{
	json_builder_release(worker);
}

static enum tcs_status
open_run(struct run *run, const struct command *command,
	const struct wishes *wishes, struct tcs_fault *fault)
{
	enum tcs_status status = input_open(&run->in, command->input, fault);

	run->command = command;
	if (status)
		return status;
	run->lines.input = &run->in;
	run->lines.max_line = wishes->max_record;
	status = output_open(&run->out, command->output, fault);
	if (status)
		return status;
	writer_init(&run->writer, run->out.file,
		wishes->compress ? COMPRESSION : 0);
	return TCS_OK;
}

static enum tcs_status
convert(struct run *run, const struct command *command,
	const struct wishes *wishes, struct tcs_fault *fault)
{
	enum tcs_status status = open_run(run, command, wishes, fault);
	const struct crew_plan plan = {
		.context = run,
		.slot_size = sizeof(struct item),
		.worker_size = sizeof(struct json_builder),
		.read = read_item,
		.work = build_item,
		.write = write_item,
		.worker_release = release_builder,
		.slot_release = release_item,
	};

	if (!status)
		status = crew_run(&plan, command->jobs, fault);
	if (!status && !run->ended)
		status = fault_set(fault, TCS_TRUNCATED, TCS_NOWHERE,
			"the text stops without its end line");
	if (!status)
		status = output_commit(&run->out, fault);
	else
		output_discard(&run->out);
	return status;
}

static void
close_run(struct run *run)
{
	json_builder_release(&run->checked);
	writer_release(&run->writer);
	lines_release(&run->lines);
	input_close(&run->in);
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
	struct wishes wishes = {.max_record = TCS_MAX_RECORD};
	const struct option_row options[] = {
		{.type = OPTION_FLAG,
			.letter = 'z',
			.name = "compress",
			.help = "Compress the records, for storage.",
			.target = &wishes.compress},
		{.type = OPTION_BYTES,
			.name = "max-record",
			.argument = "BYTES",
			.help = "Refuse lines of more bytes (default: 8G).",
			.target = &wishes.max_record},
		{0},
	};
	const struct program program = {
		.name = "json2tcs",
		.synopsis = "[options] [in [out]]",
		.summary = "Turn lines of JSON into a component stream.",
		.options = options,
		.flags = PROGRAM_READS | PROGRAM_BINARY_OUT,
	};
	struct command command;
	struct tcs_fault fault;
	struct run run = {0};
	enum tcs_status status;
	int code = EXIT_DONE;

	program_begin(&program, argc, argv, &command);
	status = convert(&run, &command, &wishes, &fault);
	if (!status)
		status = write_stats(&command, &run.writer.tally, &fault);
	if (status)
		code = program_fail(&command, &fault);
	close_run(&run);
	program_end(&command);
	return code;
}
