#include "citygml_convert.h"

#include <stdlib.h>
#include <string.h>

#include "citygml_head.h"
#include "citygml_keys.h"
#include "citygml_parts.h"
#include "citygml_passes.h"
#include "citygml_skim.h"
#include "crew.h"
#include "progress.h"

enum { COMPRESSION_LEVEL = 6 };

enum convert_phase {
	PHASE_WRITE, /* write every object that needs no other */
	PHASE_COLLECT, /* copy what the others link to */
	PHASE_DEFERRED, /* write the others */
};

/* One object on its way through the crew. */
struct slot {
	struct raw_object *raw;
	struct tcs_record record;
	struct tcs_record palette;
	struct tcs_object prototype; /* being built */
	TCS_ARRAY(struct tcs_record) prototypes; /* the room's are kept */
	size_t prototype_count;
	struct report templates; /* what became of them */
	TCS_ARRAY(char *) missing; /* owned: ids that were not found */
	TCS_ARRAY(uint64_t) hashes; /* of the ids that links may name */
	enum tcs_status status; /* of the work on it */
	struct tcs_fault fault;
};

/*
 * What goes through the crew at once: objects that one chunk of the document
 * completes. So all but the first are shorter than a chunk.
 */
enum { BATCH = 16 };

struct batch {
	struct slot slots[BATCH];
	size_t count;
};

struct convert {
	struct document document;
	const struct convert_options *options;
	const struct command *command;
	struct report *report;
	struct progress progress;
	struct tcs_writer writer;
	struct build_plan plan;
	struct raw_library library;
	TCS_ARRAY(uint64_t) deferred; /* numbers of the objects that wait */
	size_t next_deferred;
	enum convert_phase phase;
	struct place_log places; /* of the objects of the first phase */
	struct tcs_record head; /* made with the first object read */
	bool head_ready, head_written;
	uint64_t written; /* objects */
};

/* ---- reading ------------------------------------------------------------------ */

/* Objects that this phase has nothing to do with are not worked on. */
static bool
is_wanted(struct convert *convert, const struct raw_object *raw)
{
	if (convert->phase != PHASE_DEFERRED)
		return true;
	if (convert->next_deferred == convert->deferred.count ||
		convert->deferred.at[convert->next_deferred] !=
			raw->place.number)
		return false;
	convert->next_deferred++;
	return true;
}

/* The first object has told what the head needs; NULL: there is none. */
static enum tcs_status
prepare_head(struct convert *convert, const struct raw_object *first,
	struct tcs_fault *fault)
{
	struct tcs_head head = {0};
	enum tcs_status status;

	if (convert->head_ready)
		return TCS_OK;
	status = head_build(&head, &convert->document.reader, first,
		convert->command, fault);
	if (!status)
		status = head_encode(&head, &convert->head, fault);
	convert->head_ready = true;
	head_release(&head);
	return status;
}

/* Put the wanted ones among the complete objects into the batch. */
static void
batch_fill(struct convert *convert, struct batch *batch)
{
	struct gml_reader *reader = &convert->document.reader;
	struct raw_object *raw;

	while (batch->count < BATCH && (raw = gml_take(reader))) {
		if (is_wanted(convert, raw))
			batch->slots[batch->count++].raw = raw;
		else
			gml_recycle(reader, raw);
	}
}

static enum tcs_status
convert_read(void *context, void *item, bool *done, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct document *document = &convert->document;
	struct batch *batch = item;

	for (size_t i = 0; i < batch->count; i++) {
		gml_recycle(&document->reader, batch->slots[i].raw);
		batch->slots[i].raw = NULL;
	}
	batch->count = 0;
	for (;;) {
		enum tcs_status status;

		batch_fill(convert, batch);
		if (batch->count)
			return prepare_head(
				convert, batch->slots[0].raw, fault);
		if (document->ended) {
			*done = true;
			return TCS_OK;
		}
		status = document_feed(document, fault);
		if (status)
			return status;
		progress_show(&convert->progress, convert->written,
			input_consumed(document->input), document->input->size);
	}
}

/* ---- working -------------------------------------------------------------------- */

static void
slot_forget(struct slot *slot)
{
	for (size_t i = 0; i < slot->missing.count; i++)
		free(slot->missing.at[i]);
	array_clear(&slot->missing);
}

static bool
has_palette(const struct raw_object *raw)
{
	return raw->palette.materials.count || raw->palette.images.count;
}

/* Whether it links to a template that may be still to come. */
static bool
slot_waits(const struct convert *convert, const struct slot *slot)
{
	return slot->raw->waits && convert->phase == PHASE_WRITE;
}

/* Missing ids: to look for elsewhere at first, to report in the end. */
static enum tcs_status
keep_missing(struct convert *convert, struct slot *slot,
	const struct link_work *links, struct tcs_fault *fault)
{
	struct raw_object *raw = slot->raw;

	if (array_grow(&slot->missing, links->missing.count))
		return fault_memory(fault);
	for (size_t i = 0; i < links->missing.count; i++) {
		const char *id = object_text(&raw->tree, links->missing.at[i]);
		enum tcs_status status = TCS_OK;

		if (convert->phase == PHASE_DEFERRED) {
			status = report_item(&raw->report, REPORT_SKIPPED,
				"link", "nothing in the document has this id",
				id, TCS_NOWHERE, fault);
		} else {
			slot->missing.at[slot->missing.count] = strdup(id);
			if (!slot->missing.at[slot->missing.count++])
				status = fault_memory(fault);
		}
		if (status)
			return status;
	}
	return TCS_OK;
}

static enum tcs_status
hash_ids(struct slot *slot, struct tcs_fault *fault)
{
	const struct raw_object *raw = slot->raw;

	slot->hashes.count = 0;
	if (array_grow(&slot->hashes, raw->targets.count))
		return fault_memory(fault);
	for (size_t i = 0; i < raw->targets.count; i++)
		slot->hashes.at[slot->hashes.count++] = key_hash(
			object_text(&raw->tree, raw->targets.at[i].id));
	return TCS_OK;
}

/* One record for each template that comes first in this object. */
static enum tcs_status
work_on_templates(struct convert *convert, struct slot *slot,
	struct builder *builder, struct tcs_fault *fault)
{
	struct raw_object *raw = slot->raw;
	enum tcs_status status = TCS_OK;

	slot->prototype_count = 0;
	report_clear(&slot->templates);
	for (size_t i = 0; !status && i < raw->templates.count; i++) {
		if (i == slot->prototypes.count) {
			if (array_grow(&slot->prototypes, 1))
				return fault_memory(fault);
			slot->prototypes.at[slot->prototypes.count++] =
				(struct tcs_record){0};
		}
		status = build_prototype(builder, &convert->plan, raw,
			raw->templates.at[i].geometry, &slot->prototype,
			&slot->templates, fault);
		if (!status)
			status = object_encode(&slot->prototype, TCS_PROTOTYPE,
				&slot->prototypes.at[i], fault);
		slot->prototype_count++;
	}
	return status;
}

static enum tcs_status
slot_work(struct convert *convert, struct slot *slot, struct builder *builder,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	slot_forget(slot);
	if (convert->phase == PHASE_COLLECT)
		return TCS_OK;
	status = hash_ids(slot, fault);
	if (!status)
		status = paints_fetch(&convert->plan, slot->raw, fault);
	if (!status)
		status = work_on_templates(convert, slot, builder, fault);
	if (!status && has_palette(slot->raw))
		status = palette_encode(
			&slot->raw->palette, &slot->palette, fault);
	if (status || slot_waits(convert, slot))
		return status;
	status = build_object(builder, &convert->plan, slot->raw, fault);
	if (!status && builder->links.missing.count)
		status = keep_missing(convert, slot, &builder->links, fault);
	if (status || slot->missing.count)
		return status;
	array_trim(&slot->raw->positions);
	return object_encode(
		&slot->raw->tree, TCS_OBJECT, &slot->record, fault);
}

/* A failure waits until the objects before have been written. */
static enum tcs_status
convert_work(void *context, void *item, void *worker, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct batch *batch = item;

	(void)fault;
	for (size_t i = 0; i < batch->count; i++) {
		struct slot *slot = &batch->slots[i];

		slot->status = slot_work(convert, slot, worker, &slot->fault);
		if (slot->status)
			break;
	}
	return TCS_OK;
}

/* ---- writing ---------------------------------------------------------------------- */

static enum tcs_status
write_head(struct convert *convert, struct tcs_fault *fault)
{
	convert->head_written = true;
	return writer_put(&convert->writer, &convert->head, fault);
}

/* The object waits for what it links to. */
static enum tcs_status
defer(struct convert *convert, const struct slot *slot, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (array_grow(&convert->deferred, 1))
		return fault_memory(fault);
	convert->deferred.at[convert->deferred.count++] =
		slot->raw->place.number;
	for (size_t i = 0; !status && i < slot->missing.count; i++)
		status = library_want(
			&convert->library, slot->missing.at[i], fault);
	return status;
}

static enum tcs_status
slot_write(struct convert *convert, struct slot *slot, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (convert->phase == PHASE_COLLECT)
		return library_collect(&convert->library, slot->raw, fault);
	if (!convert->head_written)
		status = write_head(convert, fault);
	if (!status && convert->phase == PHASE_WRITE)
		status = places_add(&convert->places, &slot->raw->place,
			slot->hashes.at, slot->hashes.count, fault);
	if (!status && has_palette(slot->raw))
		status = writer_put(&convert->writer, &slot->palette, fault);
	for (size_t i = 0; !status && i < slot->prototype_count; i++)
		status = writer_put(
			&convert->writer, &slot->prototypes.at[i], fault);
	if (!status)
		status = report_merge(convert->report, &slot->templates, fault);
	if (status)
		return status;
	if (slot->missing.count || slot_waits(convert, slot))
		return defer(convert, slot, fault);
	convert->written++;
	status = report_merge(convert->report, &slot->raw->report, fault);
	if (!status && convert->command->strict)
		status = report_strict(convert->report, fault);
	return status ? status
		      : writer_put(&convert->writer, &slot->record, fault);
}

static enum tcs_status
convert_write(void *context, void *item, struct tcs_fault *fault)
{
	struct batch *batch = item;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < batch->count; i++) {
		status = batch->slots[i].status;
		if (status)
			*fault = batch->slots[i].fault;
		else
			status = slot_write(context, &batch->slots[i], fault);
	}
	return status;
}

/* ---- the crew ------------------------------------------------------------------------- */

static void
slot_release(struct slot *slot)
{
	raw_free(slot->raw);
	record_release(&slot->record);
	record_release(&slot->palette);
	object_release(&slot->prototype);
	report_release(&slot->templates);
	for (size_t i = 0; i < slot->prototypes.count; i++)
		record_release(&slot->prototypes.at[i]);
	array_release(&slot->prototypes);
	slot_forget(slot);
	array_release(&slot->missing);
	array_release(&slot->hashes);
}

static void
release_batch(void *item)
{
	struct batch *batch = item;

	for (size_t i = 0; i < BATCH; i++)
		slot_release(&batch->slots[i]);
}

static enum tcs_status
begin_builder(void *context, void *worker, struct tcs_fault *fault)
{
	(void)context;
	return builder_init(worker, fault);
}

static void
release_builder(void *worker)
{
	builder_release(worker);
}

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
		.worker_size = sizeof(struct builder),
		.read = convert_read,
		.work = convert_work,
		.write = convert_write,
		.worker_begin = begin_builder,
		.worker_release = release_builder,
		.slot_release = release_batch,
	};
	enum tcs_status status =
		document_start(&convert->document, PASS_OBJECTS, parts, fault);

	convert->phase = phase;
	return status ? status : crew_run(&plan, convert->command->jobs, fault);
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
		hashes[i] = key_hash(convert->library.wanted.at[i]);
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
			&convert->document.reader.images_found, fault);
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
	writer_init(&convert->writer, file,
		convert->options->compress ? COMPRESSION_LEVEL : 0);
	progress_begin(&convert->progress, convert->command->program->name,
		"objects", convert->command->quiet);
	convert->plan.lods = convert->options->lods;
	return gml_begin(
		&convert->document.reader, &convert->options->reading, fault);
}

static void
convert_end(struct convert *convert)
{
	progress_end(&convert->progress);
	gml_release(&convert->document.reader);
	places_release(&convert->places);
	library_release(&convert->library);
	array_release(&convert->deferred);
	record_release(&convert->head);
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
