#include "object_stream.h"

#include "crew.h"
#include "instances.h"
#include "progress.h"

/* A record on its way through. */
struct item {
	struct tcs_record record;
	struct tcs_object object;
	struct report report;
};

struct run {
	const struct object_work *filter;
	struct stage *stage;
	struct tcs_crs crs;
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
		run->crs = head.crs.at[0];
		run->filter->begin(run->filter->context, &run->crs);
		status = head_sign(&head, command->program->name,
			TESSERA_VERSION, command->arguments, fault);
	}
	if (!status)
		status = head_encode(&head, record, fault);
	head_release(&head);
	return status;
}

/* What is expanded stands in the objects, and nowhere else. */
static bool
is_expanded(const struct run *run, const struct item *item)
{
	return run->filter->expand && item->record.type == TCS_PROTOTYPE;
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
	if (!status && is_expanded(run, item))
		status = prototypes_add(&run->prototypes, &item->record, fault);
	return status;
}

static enum tcs_status
filter_item(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct run *run = context;
	const struct object_work *filter = run->filter;
	struct item *item = slot;
	const struct tcs_object *out;
	enum tcs_status status;

	if (item->record.type != TCS_OBJECT)
		return TCS_OK;
	status = object_decode(&item->object, &item->record, fault);
	if (!status && filter->expand)
		status = instances_expand(&item->object, &run->prototypes,
			&run->crs, run->reader.max_record, fault);
	if (!status)
		status = filter->filter(filter->context, worker, &item->object,
			&out, &item->report, fault);
	if (!status)
		status = object_encode(out, TCS_OBJECT, &item->record, fault);
	return status;
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct run *run = context;
	struct item *item = slot;
	enum tcs_status status =
		report_merge(&run->stage->report, &item->report, fault);

	if (!status && !is_expanded(run, item))
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

static enum tcs_status
pass_all(struct run *run, struct tcs_fault *fault)
{
	struct stage *stage = run->stage;
	const struct command *command = stage->command;
	const struct crew_plan plan = {
		.context = run,
		.slot_size = sizeof(struct item),
		.worker_size = run->filter->worker_size,
		.read = read_item,
		.work = filter_item,
		.write = write_item,
		.worker_release = run->filter->worker_release,
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
	if (!status && command->strict)
		status = report_strict(&stage->report, fault);
	return status ? status : writer_end(&run->writer, fault);
}

enum tcs_status
object_stream_run(const struct object_work *filter, struct stage *stage,
	struct tcs_fault *fault)
{
	struct run run = {.filter = filter, .stage = stage};
	enum tcs_status status = reader_open(
		&run.reader, stage->command->input, filter->max_record, fault);

	if (!status)
		status = pass_all(&run, fault);
	prototypes_release(&run.prototypes);
	reader_close(&run.reader);
	writer_release(&run.writer);
	return status;
}
