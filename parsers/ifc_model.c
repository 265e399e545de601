#include "ifc_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

enum tcs_status
ifc_model_read(struct ifc_model *model, const char *text, size_t length,
	const struct ifc_keep *keep, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	*model = (struct ifc_model){.precision = 0};
	status = step_index(&model->step, text, length, report, fault);
	if (!status)
		status = ifc_open(&model->file, &model->step, fault);
	if (!status)
		status = ifc_units_read(
			&model->file, &model->units, report, fault);
	if (!status)
		status = ifc_placements_read(
			&model->file, &model->placements, report, fault);
	if (!status)
		status = ifc_tree_read(
			&model->file, &model->tree, report, fault);
	if (!status)
		status = ifc_objects_list(&model->file, &model->tree, keep,
			&model->objects, fault);
	if (!status)
		status = ifc_openings_list(
			&model->tree, &model->openings, fault);
	if (!status)
		status = ifc_styles_read(&model->file, &model->styles, fault);
	if (!status)
		status = ifc_links_read(&model->file, &model->links, fault);
	if (!status)
		status = ifc_project_units_read(
			&model->file, &model->project_units, fault);
	if (!status)
		status = ifc_direct_read(&model->file, &model->direct, fault);
	if (status)
		return status;
	model->precision = precision_read(&model->file, model->units.length);
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
