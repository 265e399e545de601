/* json2tcs: lines of JSON, as tcs2json prints them, as a component stream. */
#include <stdio.h>
#include <string.h>

#include "crew.h"
#include "input.h"
#include "json_build.h"
#include "json_lines.h"
#include "stage.h"
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

struct options {
	uint64_t max_record;
	bool compress;
};

struct run {
	const struct options *options;
	struct stage *stage;
	struct input in;
	struct line_reader lines;
	struct tcs_writer writer;
	struct json_builder checked; /* what the writer decodes to check it */
	bool ended;
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
	if (run->stage->command->strict &&
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
build_stream(struct run *run, struct tcs_fault *fault)
{
	const struct command *command = run->stage->command;
	struct output *out = &run->stage->out;
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
	enum tcs_status status = output_open(out, command->output, fault);

	if (status)
		return status;
	writer_init(&run->writer, out->file,
		run->options->compress ? COMPRESSION : 0);
	status = crew_run(&plan, command->jobs, fault);
	if (!status && !run->ended)
		status = fault_set(fault, TCS_TRUNCATED, TCS_NOWHERE,
			"the text stops without its end line");
	return status
		? status
		: tally_report(&run->writer.tally, &run->stage->report, fault);
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	const struct options *options = context;
	struct run run = {.options = options, .stage = stage};
	enum tcs_status status =
		input_open(&run.in, stage->command->input, fault);

	run.lines.input = &run.in;
	run.lines.max_line = options->max_record;
	if (!status)
		status = build_stream(&run, fault);
	json_builder_release(&run.checked);
	writer_release(&run.writer);
	lines_release(&run.lines);
	input_close(&run.in);
	return status;
}

int
main(int argc, char **argv)
{
	struct options asked = {.max_record = TCS_MAX_RECORD};
	const struct option_row options[] = {
		{.type = OPTION_FLAG,
			.letter = 'z',
			.name = "compress",
			.help = "Compress the records, for storage.",
			.target = &asked.compress},
		{.type = OPTION_BYTES,
			.name = "max-record",
			.argument = "BYTES",
			.help = "Refuse lines of more bytes (default: 8G).",
			.target = &asked.max_record},
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
	int code;

	program_begin(&program, argc, argv, &command);
	code = stage_run(&command, convert, &asked);
	program_end(&command);
	return code;
}
