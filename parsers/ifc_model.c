#include "ifc_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "crew.h"
#include "ifc_georeference.h"

enum { CONTEXT_PRECISION = 3 };

/* Points nearer than this, in metres, are one where a file does not say. */
static const double PRECISION = 1e-6;

/* The precision of the first context that tells one that can be meant. */
static double
precision_read(const struct ifc_file *file, double length)
{
	struct step_list contexts = step_instances(file->step,
		step_names_find(&file->step->names,
			"IFCGEOMETRICREPRESENTATIONCONTEXT"));

	for (size_t i = 0; i < contexts.count; i++) {
		struct step_value value =
			ifc_value(file, contexts.at[i], CONTEXT_PRECISION);
		double precision;

		if (step_number(&value, &precision) && precision > 0)
			return fmin(precision, PRECISION / length);
	}
	return PRECISION / length;
}

/* ---- parts that know nothing of each other ------------------------------- */

struct reading {
	struct ifc_model *model;
	const struct ifc_keep *keep;
	struct report *report;
	int next; /* part */
};

struct part {
	int number;
	struct report report;
};

static enum tcs_status
objects_read(struct ifc_model *model, const struct ifc_keep *keep,
	struct report *report, struct tcs_fault *fault)
{
	const struct ifc_file *file = &model->file;
	enum tcs_status status =
		ifc_tree_read(file, &model->tree, report, fault);

	if (!status)
		status = ifc_objects_list(
			file, &model->tree, keep, &model->objects, fault);
	if (!status)
		status = ifc_openings_list(
			&model->tree, &model->openings, fault);
	return status;
}

static enum tcs_status
values_read(struct ifc_model *model, struct tcs_fault *fault)
{
	const struct ifc_file *file = &model->file;
	enum tcs_status status =
		ifc_project_units_read(file, &model->project_units, fault);

	if (!status)
		status = ifc_direct_read(file, &model->direct, fault);
	if (!status)
		status = ifc_links_read(file, &model->links, fault);
	return status;
}

enum { PLACEMENTS, OBJECTS, VALUES, STYLES, PARTS };

static enum tcs_status
part_next(void *context, void *slot, bool *done, struct tcs_fault *fault)
{
	struct reading *reading = context;
	struct part *part = slot;

	(void)fault;
	part->number = reading->next++;
	*done = part->number == PARTS;
	return TCS_OK;
}

static enum tcs_status
part_read(void *context, void *slot, void *worker, struct tcs_fault *fault)
{
	struct reading *reading = context;
	struct ifc_model *model = reading->model;
	struct part *part = slot;

	(void)worker;
	report_clear(&part->report);
	switch (part->number) {
	case PLACEMENTS:
		return ifc_placements_read(
			&model->file, &model->placements, &part->report, fault);
	case OBJECTS:
		return objects_read(model, reading->keep, &part->report, fault);
	case VALUES:
		return values_read(model, fault);
	default:
		return ifc_styles_read(&model->file, &model->styles, fault);
	}
}

static enum tcs_status
part_report(void *context, void *slot, struct tcs_fault *fault)
{
	struct reading *reading = context;
	struct part *part = slot;

	return report_merge(reading->report, &part->report, fault);
}

static void
part_release(void *slot)
{
	struct part *part = slot;

	report_release(&part->report);
}

enum tcs_status
ifc_model_read(struct ifc_model *model, const char *text, size_t length,
	const struct ifc_keep *keep, unsigned jobs, struct report *report,
	struct tcs_fault *fault)
{
	struct reading reading = {model, keep, report, PLACEMENTS};
	const struct crew_plan plan = {.context = &reading,
		.slot_size = sizeof(struct part),
		.read = part_next,
		.work = part_read,
		.write = part_report,
		.slot_release = part_release};
	enum tcs_status status;

	*model = (struct ifc_model){.precision = 0};
	status = step_index(&model->step, text, length, report, fault);
	if (!status)
		status = ifc_open(&model->file, &model->step, fault);
	if (!status)
		status = ifc_units_read(
			&model->file, &model->units, report, fault);
	if (!status)
		status = crew_run(&plan, jobs < PARTS ? jobs : PARTS, fault);
	if (status)
		return status;
	model->precision = precision_read(&model->file, model->units.length);
	model->has_north = ifc_true_north(model, &model->north);
	return TCS_OK;
}

void
ifc_model_release(struct ifc_model *model)
{
	free(model->direct);
	array_release(&model->project_units);
	array_release(&model->links);
	array_release(&model->openings);
	ifc_styles_release(&model->styles);
	ifc_objects_release(&model->objects);
	array_release(&model->tree);
	array_release(&model->placements);
	ifc_close(&model->file);
	step_release(&model->step);
}

void
ifc_global_id(const struct ifc_file *file, uint32_t instance,
	char out[IFC_GLOBAL_ID_ROOM])
{
	struct step_value value = ifc_value(file, instance, 0);
	size_t length = 0;

	if (value.kind == STEP_STRING)
		while (length < value.length &&
			length + 1 < IFC_GLOBAL_ID_ROOM &&
			value.text[length] > ' ' && value.text[length] < 127) {
			out[length] = value.text[length];
			length++;
		}
	out[length] = '\0';
	if (!length)
		ifc_id(file, instance, out);
}
