#include "ifc_convert.h"

#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "ifc_append.h"
#include "ifc_features.h"
#include "ifc_head.h"
#include "ifc_product.h"
#include "ifcxml.h"
#include "progress.h"
#include "step_load.h"

enum { BATCH = 16, COMPRESSION_LEVEL = 6 };

/* Some members of one object on their way through the crew. */
struct slot {
	uint32_t object;
	uint32_t first, count; /* members */
	bool begins, ends; /* the object */
	struct tcs_object piece;
	struct tcs_record record; /* of an object in one piece */
	uint32_t prototype; /* in the pass that makes those */
	bool whole;
	struct report report;
};

struct convert {
	const struct ifc_options *options;
	const struct command *command;
	struct report *report;
	struct progress progress;
	struct step_bytes text;
	struct ifc_model model;
	struct ifc_georeference place;
	struct tcs_writer writer;
	struct ifc_prototypes prototypes;
	const struct ifc_prototypes *made; /* these, once they are written */
	uint32_t next_prototype; /* to be read */
	uint32_t next_object, next_member; /* the same */
	struct tcs_object object; /* being put together */
	struct tcs_record record;
	uint64_t written; /* members */
};

/* ---- the crew ------------------------------------------------------------ */

static enum tcs_status
convert_read(void *context, void *item, bool *done, struct tcs_fault *fault)
{
	struct convert *convert = context;
	const struct ifc_objects *objects = &convert->model.objects;
	struct slot *slot = item;
	uint32_t left;

	(void)fault;
	if (convert->next_object == objects->objects.count) {
		*done = true;
		return TCS_OK;
	}
	left = objects->objects.at[convert->next_object].member_count -
		convert->next_member;
	slot->object = convert->next_object;
	slot->first = convert->next_member;
	slot->count = left < BATCH ? left : BATCH;
	slot->begins = slot->first == 0;
	slot->ends = slot->count == left;
	convert->next_member += slot->count;
	if (slot->ends) {
		convert->next_object++;
		convert->next_member = 0;
	}
	return TCS_OK;
}

static enum tcs_status
convert_work(void *context, void *item, void *worker, struct tcs_fault *fault)
{
	struct convert *convert = context;
	const struct ifc_model *model = &convert->model;
	struct slot *slot = item;
	const struct ifc_object *object =
		model->objects.objects.at + slot->object;
	const struct ifc_member *members =
		model->objects.members.at + object->first_member;
	enum tcs_status status;

	object_clear(&slot->piece);
	report_clear(&slot->report);
	status = ifc_features_write(
		model, object, slot->first, slot->count, &slot->piece, fault);
	for (uint32_t i = slot->first; i < slot->first + slot->count && !status;
		i++)
		status = ifc_product_shape(worker, members[i].node, i,
			&slot->piece, &slot->report, fault);
	if (!status && slot->begins && slot->ends)
		status = object_encode(
			&slot->piece, TCS_OBJECT, &slot->record, fault);
	return status;
}

/* Put the slot's piece behind what there is of the object. */
static enum tcs_status
piece_take(struct convert *convert, struct slot *slot, struct tcs_fault *fault)
{
	struct tcs_object swap;

	if (!slot->begins)
		return ifc_object_append(&convert->object, &slot->piece, fault);
	swap = convert->object;
	convert->object = slot->piece;
	slot->piece = swap;
	return TCS_OK;
}

static enum tcs_status
convert_write(void *context, void *item, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct slot *slot = item;
	const struct tcs_record *record = &slot->record;
	enum tcs_status status;

	status = report_merge(convert->report, &slot->report, fault);
	if (!status && convert->command->strict)
		status = report_strict(convert->report, fault);
	convert->written += slot->count;
	progress_show(&convert->progress, convert->written, convert->written,
		convert->model.objects.members.count);
	if (!status && !(slot->begins && slot->ends)) {
		status = piece_take(convert, slot, fault);
		if (status || !slot->ends)
			return status;
		status = object_encode(
			&convert->object, TCS_OBJECT, &convert->record, fault);
		record = &convert->record;
	}
	return status ? status : writer_put(&convert->writer, record, fault);
}

/* ---- what the crew has ---------------------------------------------------- */

static enum tcs_status
worker_begin(void *context, void *worker, struct tcs_fault *fault)
{
	struct convert *convert = context;
	enum tcs_status status = ifc_worker_begin(worker, &convert->model,
		&convert->place.world, convert->options->deflection, fault);

	((struct ifc_worker *)worker)->prototypes = convert->made;
	((struct ifc_worker *)worker)->layers = convert->options->layers;
	return status;
}

static void
worker_release(void *worker)
{
	ifc_worker_end(worker);
}

static void
slot_release(void *item)
{
	struct slot *slot = item;

	object_release(&slot->piece);
	record_release(&slot->record);
	report_release(&slot->report);
}

/* ---- the crew on prototypes ---------------------------------------------- */

static enum tcs_status
prototype_read(void *context, void *item, bool *done, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct slot *slot = item;

	(void)fault;
	*done = convert->next_prototype == convert->prototypes.count;
	slot->prototype = convert->next_prototype;
	if (!*done)
		convert->next_prototype++;
	return TCS_OK;
}

static enum tcs_status
prototype_work(void *context, void *item, void *worker, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct slot *slot = item;
	enum tcs_status status;

	object_clear(&slot->piece);
	report_clear(&slot->report);
	status = ifc_prototype_shape(worker,
		convert->prototypes.at + slot->prototype, &slot->piece,
		&slot->whole, &slot->report, fault);
	slot->whole = slot->whole && slot->piece.polygons.count;
	if (!status && slot->whole)
		status = object_encode(
			&slot->piece, TCS_PROTOTYPE, &slot->record, fault);
	return status;
}

static enum tcs_status
prototype_write(void *context, void *item, struct tcs_fault *fault)
{
	struct convert *convert = context;
	struct slot *slot = item;
	enum tcs_status status;

	if (!slot->whole)
		return TCS_OK;
	convert->prototypes.at[slot->prototype].number =
		(uint32_t)convert->writer.tally.prototypes;
	status = report_merge(convert->report, &slot->report, fault);
	return status ? status
		      : writer_put(&convert->writer, &slot->record, fault);
}

static enum tcs_status
prototypes_write(struct convert *convert, struct tcs_fault *fault)
{
	const struct crew_plan plan = {
		.context = convert,
		.slot_size = sizeof(struct slot),
		.worker_size = sizeof(struct ifc_worker),
		.read = prototype_read,
		.work = prototype_work,
		.write = prototype_write,
		.worker_begin = worker_begin,
		.worker_release = worker_release,
		.slot_release = slot_release,
	};
	enum tcs_status status;

	if (convert->options->bake)
		return TCS_OK;
	status = ifc_prototypes_list(
		&convert->model, &convert->prototypes, fault);
	if (!status)
		status = crew_run(&plan, convert->command->jobs, fault);
	convert->made = &convert->prototypes;
	return status;
}

/* ---- the passes ---------------------------------------------------------- */

static enum tcs_status
head_write(struct convert *convert, struct tcs_fault *fault)
{
	const struct tcs_palette *palette = &convert->model.styles.palette;
	struct tcs_head head = {0};
	enum tcs_status status = ifc_head_build(&head, &convert->model,
		&convert->place, convert->command, fault);

	if (!status)
		status = head_encode(&head, &convert->record, fault);
	if (!status)
		status = writer_put(&convert->writer, &convert->record, fault);
	if (!status && palette->materials.count) {
		status = palette_encode(palette, &convert->record, fault);
		if (!status)
			status = writer_put(
				&convert->writer, &convert->record, fault);
	}
	head_release(&head);
	return status;
}

/* What is ifcXML is STEP from here on. */
static enum tcs_status
load(struct convert *convert, struct input *input, struct tcs_fault *fault)
{
	struct step_bytes xml = {.count = 0};
	enum tcs_status status = step_load(&convert->text, input,
		convert->options->max_bytes, convert->command->jobs, fault);

	if (status || !ifcxml_is(convert->text.at, convert->text.count))
		return status;
	xml = convert->text;
	convert->text = (struct step_bytes){.count = 0};
	status = ifcxml_decode(
		xml.at, xml.count, &convert->text, convert->report, fault);
	array_release(&xml);
	return status;
}

static enum tcs_status
run(struct convert *convert, struct input *input, struct tcs_fault *fault)
{
	const struct crew_plan plan = {
		.context = convert,
		.slot_size = sizeof(struct slot),
		.worker_size = sizeof(struct ifc_worker),
		.read = convert_read,
		.work = convert_work,
		.write = convert_write,
		.worker_begin = worker_begin,
		.worker_release = worker_release,
		.slot_release = slot_release,
	};
	enum tcs_status status;

	status = load(convert, input, fault);
	if (!status)
		status = ifc_model_read(&convert->model, convert->text.at,
			convert->text.count, &convert->options->keep,
			convert->command->jobs, convert->report, fault);
	if (status)
		return status;
	ifc_georeference_read(
		&convert->model, convert->options->local, &convert->place);
	status = head_write(convert, fault);
	if (!status)
		status = prototypes_write(convert, fault);
	if (!status)
		status = crew_run(&plan, convert->command->jobs, fault);
	if (!status && convert->command->strict)
		status = report_strict(convert->report, fault);
	return status ? status : writer_end(&convert->writer, fault);
}

/* ---- life ---------------------------------------------------------------- */

static enum tcs_status
counts_report(struct convert *convert, struct tcs_fault *fault)
{
	const struct tcs_tally *tally = &convert->writer.tally;
	enum tcs_status status =
		report_add(convert->report, "objects", tally->objects, fault);

	if (!status)
		status = report_add(
			convert->report, "features", tally->features, fault);
	if (!status)
		status = report_add(
			convert->report, "polygons", tally->polygons, fault);
	if (!status)
		status = report_add(
			convert->report, "triangles", tally->triangles, fault);
	if (!status && tally->prototypes)
		status = report_add(convert->report, "prototypes",
			tally->prototypes, fault);
	if (!status && tally->instances)
		status = report_add(
			convert->report, "instances", tally->instances, fault);
	return status;
}

static void
convert_end(struct convert *convert)
{
	progress_end(&convert->progress);
	object_release(&convert->object);
	record_release(&convert->record);
	writer_release(&convert->writer);
	ifc_model_release(&convert->model);
	array_release(&convert->prototypes);
	array_release(&convert->text);
}

enum tcs_status
ifc_convert(struct input *input, FILE *file, const struct ifc_options *options,
	const struct command *command, struct report *report,
	struct tcs_fault *fault)
{
	struct convert *convert = calloc(1, sizeof *convert);
	enum tcs_status status;

	if (!convert)
		return fault_memory(fault);
	convert->options = options;
	convert->command = command;
	convert->report = report;
	writer_init(&convert->writer, file,
		options->compress ? COMPRESSION_LEVEL : 0);
	progress_begin(&convert->progress, command->program->name, "products",
		command->quiet);
	status = run(convert, input, fault);
	if (!status)
		status = counts_report(convert, fault);
	convert_end(convert);
	free(convert);
	return status;
}
