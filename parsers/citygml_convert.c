#include "citygml_convert.h"

#include <stdlib.h>
#include <string.h>

#include "citygml_convert_state.h"
#include "citygml_keys.h"
#include "citygml_skim.h"
#include "crew.h"

enum { COMPRESSION_LEVEL = 6 };

/* ---- the passes ----------------------------------------------------------------------- */

static enum tcs_status
feed_all(struct convert *convert, const struct document_parts *parts,
	struct tcs_fault *fault)
{
	struct document *document = &convert->document;
	enum tcs_status status;

	status = document_start(document, PASS_APPEARANCES, parts, fault);
	while (!status && !document->ended)
		status = document_feed(document, fault);
	return status;
}

/*
 * What is no XML is read as a whole, where the first fault is found first.
 */
static enum tcs_status
read_appearances(struct convert *convert, struct tcs_fault *fault)
{
	struct gml_reader *reader = &convert->document.reader;
	struct document_parts parts = {0};
	enum skim_result result;
	enum tcs_status status;

	status = skim_appearances(
		convert->document.input, &parts, &result, fault);
	if (!status && result == SKIM_PARTS) {
		status = feed_all(convert, &parts, fault);
		if (status == TCS_BAD_INPUT) {
			store_release(&reader->store);
			report_clear(&reader->report);
			result = SKIM_UNSURE;
			status = TCS_OK;
		}
	}
	if (!status && result == SKIM_UNSURE)
		status = feed_all(convert, NULL, fault);
	parts_release(&parts);
	convert->plan.store = &reader->store;
	return status ? status
		      : store_close(&reader->store, &reader->report, fault);
}

static enum tcs_status
run_phase(struct convert *convert, enum convert_phase phase,
	const struct document_parts *parts, struct tcs_fault *fault)
{
	const struct crew_plan plan = {
		.context = convert,
		.slot_size = sizeof(struct batch),
		.worker_size = sizeof(struct convert_worker),
		.read = convert_read,
		.work = convert_work,
		.write = convert_write,
		.worker_begin = convert_begin_worker,
		.worker_release = convert_release_worker,
		.slot_release = convert_release_batch,
	};
	enum tcs_status status =
		document_start(&convert->document, PASS_OBJECTS, parts, fault);

	convert->phase = phase;
	convert->helped = false;
	if (!status)
		status = crew_run(&plan, convert->command->jobs, fault);
	if (status || !convert->helped)
		return status;
	return gml_feed(&convert->document.reader, NULL, 0, fault);
}

static int
compare_hashes(const void *a, const void *b)
{
	uint64_t one, two;

	memcpy(&one, a, sizeof one);
	memcpy(&two, b, sizeof two);
	return one < two ? -1 : one > two;
}

/* Where the wanted ids may be, and the deferred objects. */
static enum tcs_status
parts_find(struct convert *convert, struct document_parts *wanted,
	struct document_parts *deferred, struct tcs_fault *fault)
{
	size_t count = convert->library.wanted.count;
	uint64_t *hashes = malloc((count + 1) * sizeof *hashes);
	const struct place_query query = {
		hashes, count, convert->deferred.at, convert->deferred.count};
	enum tcs_status status;

	if (!hashes)
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		hashes[i] =
			id_hash(&convert->plan, convert->library.wanted.at[i]);
	qsort(hashes, count, sizeof *hashes, compare_hashes);
	wanted->head_end = deferred->head_end =
		convert->document.reader.head_end;
	status = places_select(
		&convert->places, &query, wanted, deferred, fault);
	free(hashes);
	return status;
}

/* What the deferred objects link to, then these. */
static enum tcs_status
run_deferred(struct convert *convert, struct tcs_fault *fault)
{
	struct document_parts wanted = {0}, deferred = {0};
	bool all = convert->places.unknown;
	enum tcs_status status = TCS_OK;

	library_sort(&convert->library);
	if (!all)
		status = parts_find(convert, &wanted, &deferred, fault);
	if (!status)
		status = run_phase(
			convert, PHASE_COLLECT, all ? NULL : &wanted, fault);
	if (!status)
		status = library_close(&convert->library, fault);
	convert->plan.library = &convert->library;
	if (!status)
		status = run_phase(
			convert, PHASE_DEFERRED, all ? NULL : &deferred, fault);
	parts_release(&wanted);
	parts_release(&deferred);
	return status;
}

static enum tcs_status
run_all(struct convert *convert, struct tcs_fault *fault)
{
	enum tcs_status status = input_spool(convert->document.input, fault);

	if (!status)
		status = read_appearances(convert, fault);
	if (!status)
		status = run_phase(convert, PHASE_WRITE, NULL, fault);
	if (!status)
		status = prepare_head(convert, NULL, fault);
	if (!status && !convert->head_written)
		status = write_head(convert, fault);
	if (!status)
		status = report_merge(convert->report,
			&convert->document.reader.report, fault);
	if (!status)
		status = report_merge(convert->report,
			&convert->document.reader.numbers.found, fault);
	if (!status && convert->deferred.count)
		status = run_deferred(convert, fault);
	if (!status && convert->command->strict)
		status = report_strict(convert->report, fault);
	return status ? status : writer_end(&convert->writer, fault);
}

/* ---- life ------------------------------------------------------------------------------- */

static enum tcs_status
convert_begin(struct convert *convert, FILE *file, struct tcs_fault *fault)
{
	enum tcs_status status;

	writer_init(&convert->writer, file,
		convert->options->compress ? COMPRESSION_LEVEL : 0);
	progress_begin(&convert->progress, convert->command->program->name,
		"objects", convert->command->quiet);
	convert->plan.lods = convert->options->lods;
	convert->plan.id_key = hash_key_new();
	status = builder_init(&convert->builder, fault);
	return status ? status
		      : gml_begin(&convert->document.reader,
				&convert->options->reading, fault);
}

/* Longer members are read piece by piece, by the leader. */
static uint64_t
member_limit(const struct gml_options *options)
{
	uint64_t limit = 1024 * 1024;

	if (options->max_feature && options->max_feature < limit)
		limit = options->max_feature;
	return options->xml.tag < limit ? options->xml.tag : limit;
}

static void
convert_end(struct convert *convert)
{
	progress_end(&convert->progress);
	array_release(&convert->bytes);
	array_release(&convert->pieces);
	slot_release(&convert->turn);
	builder_release(&convert->builder);
	helper_start_release(&convert->start);
	gml_release(&convert->document.reader);
	splitter_release(&convert->splitter);
	places_release(&convert->places);
	library_release(&convert->library);
	array_release(&convert->deferred);
	record_release(&convert->head_record);
	record_release(&convert->palette);
	writer_release(&convert->writer);
}

enum tcs_status
citygml_convert(struct input *input, FILE *file,
	const struct convert_options *options, const struct command *command,
	struct report *report, struct tcs_fault *fault)
{
	struct convert *convert = calloc(1, sizeof *convert);
	enum tcs_status status;

	if (!convert)
		return fault_memory(fault);
	convert->document.input = input;
	convert->splitter = (struct splitter){
		.input = input,
		.max_member = member_limit(&options->reading),
	};
	convert->options = options;
	convert->command = command;
	convert->report = report;
	status = convert_begin(convert, file, fault);
	if (!status)
		status = run_all(convert, fault);
	convert_end(convert);
	free(convert);
	return status;
}
