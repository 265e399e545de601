/* tcs2citygml: a component stream as CityGML. */
#include <string.h>

#include "citygml_document.h"
#include "crew.h"
#include "image_files.h"
#include "stage.h"
#include "tally_report.h"
#include "tcs.h"

enum { COMPRESSION = 6 }; /* zlib's level of a gzip file */

struct options {
	enum gml_version version;
	bool gzip;
	uint64_t max_record;
};

/* A record on its way from the stream to the document. */
struct passing {
	struct tcs_record record;
	struct composed composed;
};

struct run {
	const struct options *options;
	struct stage *stage;
	struct tcs_reader reader;
	struct tcs_record head_record;
	struct tcs_head head;
	struct gml_palette palette;
	struct tcs_palette more; /* a palette record decoded, by who reads … */
	struct tcs_palette shown; /* … and by who writes */
	struct image_files images;
	struct compose_plan plan;
	struct document document;
};

/* Palettes are taken here: workers look at them under the same lock. */
static enum tcs_status
take_palette(struct run *run, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	enum tcs_status status = palette_decode(&run->more, record, fault);

	return status ? status
		      : gml_palette_add(&run->palette, &run->more,
				record->before.objects, fault);
}

static enum tcs_status
read_item(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct run *run = context;
	struct passing *item = slot;
	enum tcs_status status;

	*done = run->reader.ended;
	if (*done)
		return TCS_OK;
	status = reader_next(&run->reader, &item->record, fault);
	if (!status && item->record.type == TCS_PALETTE)
		status = take_palette(run, &item->record, fault);
	return status;
}

static enum tcs_status
compose_item(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct run *run = context;
	struct passing *item = slot;
	struct composer *composer = worker;

	composer->plan = &run->plan;
	switch (item->record.type) {
	case TCS_OBJECT:
		return compose_object(
			composer, &item->record, NULL, &item->composed, fault);
	case TCS_PROTOTYPE:
		return compose_prototype(
			composer, &item->record, NULL, &item->composed, fault);
	default:
		return TCS_OK;
	}
}

static enum tcs_status
write_images(struct run *run, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	enum tcs_status status = palette_decode(&run->shown, record, fault);

	return status ? status
		      : image_files_add(&run->images, &run->shown,
				&run->stage->report, fault);
}

static enum tcs_status
write_item(void *context, void *slot, struct tcs_fault *fault)
{
	struct run *run = context;
	struct passing *item = slot;

	switch (item->record.type) {
	case TCS_OBJECT:
	case TCS_PROTOTYPE:
		return document_add(
			&run->document, &item->composed, &item->record, fault);
	case TCS_PALETTE:
		return write_images(run, &item->record, fault);
	case TCS_END:
		return TCS_OK;
	default:
		return report_item(&run->stage->report, REPORT_SKIPPED,
			"record", "of a kind this program does not know", NULL,
			item->record.at, fault);
	}
}

static void
release_item(void *slot)
{
	struct passing *item = slot;

	record_release(&item->record);
	composed_release(&item->composed);
}

static void
release_composer(void *worker)
{
	composer_release(worker);
}

static enum tcs_status
read_head(struct run *run, struct tcs_fault *fault)
{
	const struct tcs_crs *crs;
	enum tcs_status status;

	status = reader_next(&run->reader, &run->head_record, fault);
	if (!status)
		status = head_decode(&run->head, &run->head_record, fault);
	if (!status)
		status = schema_init(
			&run->plan.schema, run->options->version, fault);
	if (status)
		return status;
	run->plan.key = hash_key_new();
	run->plan.palette = &run->palette;
	run->plan.writes_images = run->images.document != NULL;
	crs = &run->head.crs.at[0];
	run->plan.from_3 = run->head.sources.count == 1 &&
		!strcmp(head_text(&run->head, run->head.sources.at[0].format),
			"CityGML 3.0");
	run->plan.north_first = (crs->flags & TCS_CRS_NORTH_FIRST) != 0;
	run->plan.geographic = crs->kind == TCS_CRS_GEOGRAPHIC;
	run->plan.metres = crs->metres_per_unit;
	run->plan.metres_up = crs->metres_per_unit_up;
	return document_begin(
		&run->document, &run->plan, &run->stage->report, fault);
}

static bool
ends_in_gz(const char *name)
{
	size_t length = name ? strlen(name) : 0;

	return length > 3 && !strcmp(name + length - 3, ".gz");
}

static enum tcs_status
write_document(struct run *run, struct tcs_fault *fault)
{
	const struct command *command = run->stage->command;
	struct output *out = &run->stage->out;
	bool gzip = run->options->gzip || ends_in_gz(command->output);
	enum tcs_status status = TCS_OK;

	if (command->strict)
		status = report_strict(&run->stage->report, fault);
	if (!status)
		status = output_open(out, command->output, fault);
	return status ? status
		      : document_end(&run->document, &run->head, out->file,
				gzip ? COMPRESSION : 0, fault);
}

static enum tcs_status
read_stream(struct run *run, struct tcs_fault *fault)
{
	const struct crew_plan plan = {
		.context = run,
		.slot_size = sizeof(struct passing),
		.worker_size = sizeof(struct composer),
		.read = read_item,
		.work = compose_item,
		.write = write_item,
		.worker_release = release_composer,
		.slot_release = release_item,
	};
	enum tcs_status status = read_head(run, fault);

	return status ? status
		      : crew_run(&plan, run->stage->command->jobs, fault);
}

static enum tcs_status
count(struct run *run, struct tcs_fault *fault)
{
	struct report *report = &run->stage->report;
	const struct document *document = &run->document;
	enum tcs_status status =
		tally_report(&run->reader.tally, report, fault);

	if (!status)
		status = report_add(
			report, "members", document->member_count, fault);
	if (!status)
		status = report_add(
			report, "polygons written", document->polygons, fault);
	if (!status && run->images.written.count)
		status = report_add(report, "images written",
			run->images.written.count, fault);
	return status ? status
		      : report_add(report, "bytes", document->bytes, fault);
}

static void
close_run(struct run *run)
{
	document_release(&run->document);
	schema_release(&run->plan.schema);
	head_release(&run->head);
	record_release(&run->head_record);
	gml_palette_release(&run->palette);
	palette_release(&run->more);
	palette_release(&run->shown);
	image_files_release(&run->images);
	pthread_rwlock_destroy(&run->palette.lock);
	reader_close(&run->reader);
}

static enum tcs_status
convert(void *context, struct stage *stage, struct tcs_fault *fault)
{
	const struct options *options = context;
	struct run run = {.options = options, .stage = stage};
	enum tcs_status status;

	if (pthread_rwlock_init(&run.palette.lock, NULL))
		return fault_memory(fault);
	image_files_init(&run.images, stage->command->output);
	status = reader_open(
		&run.reader, stage->command->input, options->max_record, fault);
	if (!status)
		status = read_stream(&run, fault);
	if (!status)
		status = write_document(&run, fault);
	if (!status)
		status = count(&run, fault);
	if (status)
		image_files_undo(&run.images);
	close_run(&run);
	return status;
}

int
main(int argc, char **argv)
{
	struct options asked = {
		.version = GML_2_0, .max_record = TCS_MAX_RECORD};
	const struct option_row options[] = {
		{.type = OPTION_CHOICE,
			.name = "citygml",
			.argument = "1.0|2.0|3.0",
			.help = "Write this version of CityGML (default: 2.0).",
			.target = &asked.version},
		{.type = OPTION_FLAG,
			.name = "gzip",
			.help = "Compress; names that end in .gz ask for it.",
			.target = &asked.gzip},
		{.type = OPTION_BYTES,
			.name = "max-record",
			.argument = "BYTES",
			.help = "Refuse records of more bytes (default: 8G).",
			.target = &asked.max_record},
		{0},
	};
	const struct program program = {
		.name = "tcs2citygml",
		.synopsis = "[options] [in [out]]",
		.summary = "Write a component stream as CityGML.",
		.options = options,
		.flags = PROGRAM_READS | PROGRAM_BINARY_IN,
	};
	struct command command;
	int code;

	program_begin(&program, argc, argv, &command);
	code = stage_run(&command, convert, &asked);
	program_end(&command);
	return code;
}
