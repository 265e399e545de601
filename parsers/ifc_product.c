#include "ifc_product.h"

#include "ifc_attributes.h"
#include "ifc_representation.h"

enum { PRODUCT_PLACEMENT = 5, LOD = 3 };

enum tcs_status
ifc_worker_begin(struct ifc_worker *worker, const struct ifc_model *model,
	const struct ifc_matrix *world, double deflection,
	struct tcs_fault *fault)
{
	*worker = (struct ifc_worker){.model = model,
		.world = *world,
		.shaper = {.file = &model->file,
			.angle = model->units.angle,
			.deflection = deflection / model->units.length,
			.precision = model->precision,
			.styles = &model->styles}};
	worker->triangulator = triangulator_new();
	if (!worker->triangulator)
		return fault_memory(fault);
	return ifc_scratch_new(&worker->shaper.scratch, fault);
}

void
ifc_worker_end(struct ifc_worker *worker)
{
	triangulator_free(worker->triangulator);
	ifc_scratch_free(worker->shaper.scratch);
	ifc_body_release(&worker->body);
}

/* What was refused: the kind of the culprit, and why. */
static enum tcs_status
refusal_report(const struct ifc_shaper *shaper, uint32_t item, const char *id,
	struct report *report, struct tcs_fault *fault)
{
	const struct ifc_file *file = shaper->file;
	uint32_t culprit =
		shaper->culprit == STEP_NONE ? item : shaper->culprit;
	const char *kind = ifc_name(ifc_entity_of(file, culprit));

	return report_item(report, REPORT_SKIPPED, *kind ? kind : "item",
		shaper->reason, id, TCS_NOWHERE, fault);
}

/* All items of a representation; those that fail are taken back. */
static enum tcs_status
items_shape(struct ifc_worker *worker, uint32_t representation, const char *id,
	struct report *report, struct tcs_fault *fault)
{
	struct ifc_shaper *shaper = &worker->shaper;
	struct step_value list = ifc_items_of(shaper->file, representation);
	enum tcs_status status = TCS_OK;
	struct step_value value;

	ifc_body_clear(&worker->body);
	shaper->points = 0;
	while (!status && list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END) {
		uint32_t item = step_target(shaper->file->step, &value);
		size_t before = worker->body.parts.count;

		shaper->depth = 0;
		switch (ifc_item_body(shaper, item, &worker->body)) {
		case IFC_SHAPED:
			break;
		case IFC_REFUSED:
			ifc_body_cut(&worker->body, before);
			status =
				refusal_report(shaper, item, id, report, fault);
			break;
		default:
			return fault_memory(fault);
		}
	}
	return status;
}

/* Faces that no style paints have that of the product's material. */
static void
body_paint(struct ifc_worker *worker, uint32_t paint)
{
	struct ifc_faces *faces = &worker->body.faces;

	for (size_t i = 0; paint && i < faces->faces.count; i++)
		if (!faces->faces.at[i].paint)
			faces->faces.at[i].paint = paint;
}

/* From the product's coordinates, in the file's unit, to the stream's. */
static bool
product_matrix(const struct ifc_worker *worker, uint32_t product,
	struct ifc_matrix *out)
{
	const struct ifc_model *model = worker->model;
	uint32_t instance =
		ifc_target(&model->file, product, PRODUCT_PLACEMENT);
	const struct ifc_placement *placement =
		ifc_placement_find(&model->placements, instance);

	if (instance != STEP_NONE && (!placement || !placement->known))
		return false;
	*out = placement ? ifc_multiply(&worker->world, &placement->world)
			 : worker->world;
	return true;
}

enum tcs_status
ifc_product_shape(struct ifc_worker *worker, uint32_t node, uint32_t feature,
	struct tcs_object *out, struct report *report, struct tcs_fault *fault)
{
	const struct ifc_file *file = &worker->model->file;
	uint32_t product = worker->model->tree.at[node].instance;
	uint32_t body = ifc_body_of(file, product);
	char id[IFC_GLOBAL_ID_ROOM];
	struct ifc_matrix matrix;
	enum tcs_status status;

	if (!ifc_is_shown(file, product))
		return TCS_OK;
	ifc_global_id(file, product, id);
	if (body == STEP_NONE)
		return report_item(report, REPORT_NOTE, "product",
			"has no body, only what stands for it", id, TCS_NOWHERE,
			fault);
	if (!product_matrix(worker, product, &matrix))
		return report_item(report, REPORT_SKIPPED, "product",
			"where it stands is not known", id, TCS_NOWHERE, fault);
	status = items_shape(worker, body, id, report, fault);
	body_paint(worker, ifc_material_paint(worker->model, product));
	if (!status)
		status = ifc_polygons_add(worker->triangulator, &worker->body,
			&(struct ifc_target_feature){&matrix, feature, LOD, id},
			out, report, fault);
	return status;
}
