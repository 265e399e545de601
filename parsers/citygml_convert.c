#include "citygml_convert.h"

#include <stdlib.h>
#include <string.h>

#include "citygml_head.h"
#include "crew.h"
#include "progress.h"

enum { CHUNK = 64 * 1024, COMPRESSION_LEVEL = 6 };

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
};

struct convert {
	struct input *input;
	const struct convert_options *options;
	const struct command *command;
	struct report *report;
	struct progress progress;
	struct gml_reader reader;
	struct tcs_writer writer;
	struct build_plan plan;
	struct raw_library library;
	TCS_ARRAY(uint64_t) deferred; /* numbers of the objects that wait */
	size_t next_deferred;
	struct builder *builders; /* one per job */
	struct slot *slots;
	size_t slot_count;
	enum convert_phase phase;
	bool ended; /* the document has been read to its end */
	struct tcs_record head; /* made with the first object read */
	bool head_ready, head_written;
	uint64_t written; /* objects */
	char chunk[CHUNK];
};

/* ---- reading ------------------------------------------------------------------ */

static enum tcs_status
feed(struct convert *convert, struct tcs_fault *fault)
{
	size_t got;
	enum tcs_status status;

	status = input_read(convert->input, convert->chunk, CHUNK, &got, fault);
	if (status)
		return status;
	convert->ended = got == 0;
	if (!convert->input->at)
		return fault_set(
			fault, TCS_BAD_INPUT, TCS_NOWHERE, "the file is empty");
	return gml_feed(&convert->reader, convert->chunk, got, fault);
}

static enum tcs_status
start_pass(struct convert *convert, enum gml_pass pass, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (convert->input->at)
		status = input_rewind(convert->input, fault);
	convert->ended = false;
	return status ? status : gml_start_pass(&convert->reader, pass, fault);
}

/* Objects that this phase has nothing to do with are not worked on. */
static bool
is_wanted(struct convert *convert, const struct raw_object *raw)
{
	if (convert->phase != PHASE_DEFERRED)
		return true;
	if (convert->next_deferred == convert->deferred.count ||
		convert->deferred.at[convert->next_deferred] != raw->number)
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
	status = head_build(
		&head, &convert->reader, first, convert->command, fault);
	if (!status)
		status = head_encode(&head, &convert->head, fault);
	convert->head_ready = true;
	head_release(&head);
	return status;
}

static enum tcs_status
convert_read(void *context, void *item, bool *done, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct slot *slot = item;

	gml_recycle(&convert->reader, slot->raw);
	for (;;) {
		enum tcs_status status;

		slot->raw = gml_take(&convert->reader);
		if (slot->raw && is_wanted(convert, slot->raw))
			return prepare_head(convert, slot->raw, fault);
		if (slot->raw) {
			gml_recycle(&convert->reader, slot->raw);
			continue;
		}
		if (convert->ended) {
			*done = true;
			return TCS_OK;
		}
		status = feed(convert, fault);
		if (status)
			return status;
		progress_show(&convert->progress, convert->written,
			input_consumed(convert->input), convert->input->size);
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
convert_work(void *context, void *item, size_t worker, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct builder *builder = &convert->builders[worker];
	struct slot *slot = item;
	enum tcs_status status;

	slot_forget(slot);
	if (convert->phase == PHASE_COLLECT)
		return TCS_OK;
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
	return object_encode(
		&slot->raw->tree, TCS_OBJECT, &slot->record, fault);
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
	convert->deferred.at[convert->deferred.count++] = slot->raw->number;
	for (size_t i = 0; !status && i < slot->missing.count; i++)
		status = library_want(
			&convert->library, slot->missing.at[i], fault);
	return status;
}

static enum tcs_status
convert_write(void *context, void *item, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct slot *slot = item;
	enum tcs_status status = TCS_OK;

	if (convert->phase == PHASE_COLLECT)
		return library_collect(&convert->library, slot->raw, fault);
	if (!convert->head_written)
		status = write_head(convert, fault);
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

/* ---- the passes ----------------------------------------------------------------------- */

/* "appearanceMember", found by its rarest letter. */
static bool
names_appearances(const char *at, size_t length)
{
	static const char before[] = "appearance", after[] = "ember";
	const size_t ahead = sizeof before - 1, behind = sizeof after - 1;
	const char *end = at + length;

	if (length <= ahead + behind)
		return false;
	for (at += ahead; at < end - behind; at++) {
		at = memchr(at, 'M', (size_t)(end - behind - at));
		if (!at)
			return false;
		if (!memcmp(at - ahead, before, ahead) &&
			!memcmp(at + 1, after, behind))
			return true;
	}
	return false;
}

/*
 * A look through the bytes for global appearances. Text in UTF-16, told by its
 * NULs, gets the benefit of the doubt.
 */
static enum tcs_status
document_has_appearances(
	struct convert *convert, bool *found, struct tcs_fault *fault)
{
	const size_t overlap = 16;
	size_t held = 0, got;

	*found = false;
	for (;;) {
		enum tcs_status status = input_read(convert->input,
			convert->chunk + held, CHUNK - held, &got, fault);

		if (status || !got)
			return status;
		held += got;
		*found = names_appearances(convert->chunk, held) ||
			memchr(convert->chunk, 0, held);
		if (*found)
			return TCS_OK;
		if (held > overlap) {
			memmove(convert->chunk, convert->chunk + held - overlap,
				overlap);
			held = overlap;
		}
	}
}

static enum tcs_status
read_appearances(struct convert *convert, struct tcs_fault *fault)
{
	enum tcs_status status;
	bool found;

	status = document_has_appearances(convert, &found, fault);
	if (!status)
		status = start_pass(convert, PASS_APPEARANCES, fault);
	if (status || !found)
		return status;
	while (!status && !convert->ended)
		status = feed(convert, fault);
	convert->plan.store = &convert->reader.store;
	return status ? status : store_close(&convert->reader.store, fault);
}

static enum tcs_status
run_phase(struct convert *convert, enum convert_phase phase,
	struct tcs_fault *fault)
{
	const struct crew_plan plan = {
		.context = convert,
		.slots = convert->slots,
		.slot_size = sizeof *convert->slots,
		.slot_count = convert->slot_count,
		.read = convert_read,
		.work = convert_work,
		.write = convert_write,
	};
	enum tcs_status status = start_pass(convert, PASS_OBJECTS, fault);

	convert->phase = phase;
	return status ? status : crew_run(&plan, convert->command->jobs, fault);
}

static enum tcs_status
run_deferred(struct convert *convert, struct tcs_fault *fault)
{
	enum tcs_status status;

	library_sort(&convert->library);
	status = run_phase(convert, PHASE_COLLECT, fault);
	if (!status)
		status = library_close(&convert->library, fault);
	convert->plan.library = &convert->library;
	return status ? status : run_phase(convert, PHASE_DEFERRED, fault);
}

static enum tcs_status
run_all(struct convert *convert, struct tcs_fault *fault)
{
	enum tcs_status status = input_spool(convert->input, fault);

	if (!status)
		status = read_appearances(convert, fault);
	if (!status)
		status = run_phase(convert, PHASE_WRITE, fault);
	if (!status)
		status = prepare_head(convert, NULL, fault);
	if (!status && !convert->head_written)
		status = write_head(convert, fault);
	if (!status)
		status = report_merge(
			convert->report, &convert->reader.report, fault);
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
	unsigned jobs = convert->command->jobs;
	enum tcs_status status;

	writer_init(&convert->writer, file,
		convert->options->compress ? COMPRESSION_LEVEL : 0);
	progress_begin(&convert->progress, convert->command->program->name,
		"objects", convert->command->quiet);
	convert->plan.lods = convert->options->lods;
	convert->slot_count = crew_slots(jobs);
	convert->slots = calloc(convert->slot_count, sizeof *convert->slots);
	convert->builders = calloc(jobs, sizeof *convert->builders);
	status = gml_begin(&convert->reader, &convert->options->reading, fault);
	if (!status && (!convert->slots || !convert->builders))
		status = fault_memory(fault);
	for (unsigned i = 0; !status && i < jobs; i++)
		status = builder_init(&convert->builders[i], fault);
	return status;
}

static void
convert_end(struct convert *convert)
{
	progress_end(&convert->progress);
	for (size_t i = 0; convert->slots && i < convert->slot_count; i++) {
		raw_free(convert->slots[i].raw);
		record_release(&convert->slots[i].record);
		record_release(&convert->slots[i].palette);
		object_release(&convert->slots[i].prototype);
		report_release(&convert->slots[i].templates);
		for (size_t j = 0; j < convert->slots[i].prototypes.count; j++)
			record_release(&convert->slots[i].prototypes.at[j]);
		array_release(&convert->slots[i].prototypes);
		slot_forget(&convert->slots[i]);
		array_release(&convert->slots[i].missing);
	}
	free(convert->slots);
	for (unsigned i = 0; convert->builders && i < convert->command->jobs;
		i++)
		builder_release(&convert->builders[i]);
	free(convert->builders);
	gml_release(&convert->reader);
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
	convert->input = input;
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
