/* tcs-exterior: objects as they are seen from outside. */
#include <stdlib.h>

#include "crew.h"
#include "exterior.h"
#include "instances.h"
#include "progress.h"
#include "stage.h"

struct options {
	struct exterior_settings settings;
	uint64_t max_record;
};

/* A record on its way through. */
struct item {
	struct tcs_record record;
	struct tcs_object object;
	struct report report;
};

struct run {
	struct stage *stage;
	struct exterior_settings settings;
	struct prototypes prototypes;
	struct tcs_reader reader;
	struct tcs_writer writer;
	struct progress progress;
};

static enum tcs_status
take_head(struct run *run, struct tcs_record *record, struct tcs_fault *fault)
{
	const struct command *command = run->stage->command;
	struct tcs_head head = {0};
	enum tcs_status status = head_decode(&head, record, fault);

	if (!status) {
		run->settings.crs = head.crs.at[0];
		status = head_sign(&head, command->program->name,
			TESSERA_VERSION, command->arguments, fault);
	}
	if (!status)
		status = head_encode(&head, record, fault);
	head_release(&head);
	return status;
}

static enum tcs_status
read_item(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	enum tcs_status status;

	report_clear(&item->report);
	status = reader_next(&run->reader, &item->record, fault);
	*done = !status && run->reader.ended;
	if (!status && item->record.type == TCS_HEAD)
		status = take_head(run, &item->record, fault);
	if (!status && item->record.type == TCS_PROTOTYPE)
		status = prototypes_add(&run->prototypes, &item->record, fault);
	return status;
}

static enum tcs_status
filter_item(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	enum tcs_status status;

	if (item->record.type != TCS_OBJECT)
		return TCS_OK;
	status = object_decode(&item->object, &item->record, fault);
	if (!status)
		status = instances_expand(&item->object, &run->prototypes,
			&run->settings.crs, run->reader.max_record, fault);
	if (!status)
		status = exterior_keep(worker, &run->settings, &item->object,
			&item->report, fault);
	if (!status)
		status = object_encode(
			&item->object, TCS_OBJECT, &item->record, fault);
	return status;
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	enum tcs_status status =
		report_merge(&run->stage->report, &item->report, fault);

	if (!status && item->record.type != TCS_PROTOTYPE)
		status = writer_put(&run->writer, &item->record, fault);
	progress_show(&run->progress, run->writer.tally.objects, 0, 0);
	return status;
}

static void
release_item(void *slot)
{
	struct item *item = slot;

	record_release(&item->record);
	object_release(&item->object);
	report_release(&item->report);
}

static void
release_worker(void *worker)
{
	exterior_release(worker);
}

static enum tcs_status
filter_stream(struct run *run, struct tcs_fault *fault)
{
	struct stage *stage = run->stage;
	const struct command *command = stage->command;
	const struct crew_plan plan = {
		.context = run,
		.slot_size = sizeof(struct item),
		.worker_size = sizeof(struct exterior),
		.read = read_item,
		.work = filter_item,
		.write = write_item,
		.worker_release = release_worker,
		.slot_release = release_item,
	};
	enum tcs_status status =
		output_open(&stage->out, command->output, fault);

	if (status)
		return status;
	writer_init(&run->writer, stage->out.file, 0);
	progress_begin(&run->progress, command->program->name, "objects",
		command->quiet);
	status = crew_run(&plan, command->jobs, fault);
	progress_end(&run->progress);
	return status ? status : writer_end(&run->writer, fault);
}

static enum tcs_status
filter(void *context, struct stage *stage, struct tcs_fault *fault)
{
	const struct options *options = context;
	struct run run = {.stage = stage, .settings = options->settings};
	enum tcs_status status = reader_open(
		&run.reader, stage->command->input, options->max_record, fault);

	run.settings.jobs = stage->command->jobs;
	if (!status)
		status = filter_stream(&run, fault);
	prototypes_release(&run.prototypes);
	reader_close(&run.reader);
	writer_release(&run.writer);
	return status;
}

int
main(int argc, char **argv)
{
	struct options options = {
		.settings = {.least = 0.01, .pixel = 0.05},
		.max_record = TCS_MAX_RECORD,
	};
	const struct option_row rows[] = {
		{OPTION_FLAG, 0, "faces", NULL,
			"Take out single faces, rather than whole parts.",
			&options.settings.faces, 0, 0, NULL},
		{OPTION_NUMBER, 0, "least", "SHARE",
			"Keep that of which at least this share is seen, 0 to "
			"1 (default: 0.01).",
			&options.settings.least, 0, 1, NULL},
		{OPTION_NUMBER, 0, "pixel", "METRES",
			"Look at pictures with pixels this wide (default: "
			"0.05).",
			&options.settings.pixel, 1e-4, 1000, NULL},
		{OPTION_BYTES, 0, "max-record", "BYTES",
			"Refuse records of more bytes (default: 8G).",
			&options.max_record, 0, 0, NULL},
		{0},
	};
	const struct program program = {
		.name = "tcs-exterior",
		.synopsis = "[options] [in [out]]",
		.summary = "Keep what is seen of objects from outside.",
		.options = rows,
		.flags = PROGRAM_READS | PROGRAM_BINARY_IN | PROGRAM_BINARY_OUT,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	code = stage_run(&command, filter, &options);
	program_end(&command);
	return code;
}
