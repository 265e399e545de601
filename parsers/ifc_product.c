#include "ifc_product.h"

#include <math.h>

#include "ifc_attributes.h"
#include "ifc_layers.h"
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
			.unit = model->units.length,
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
	ifc_body_release(&worker->tools);
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

/* Append all items of a representation; those that fail are taken back. */
static enum tcs_status
items_shape(struct ifc_worker *worker, uint32_t representation, const char *id,
	struct ifc_body *out, struct report *report, struct tcs_fault *fault)
{
	struct ifc_shaper *shaper = &worker->shaper;
	struct step_value list = ifc_items_of(shaper->file, representation);
	enum tcs_status status = TCS_OK;
	struct step_value value;

	while (!status && list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END) {
		uint32_t item = step_target(shaper->file->step, &value);
		size_t before = out->parts.count;

		shaper->depth = 0;
		switch (ifc_item_body(shaper, item, out)) {
		case IFC_SHAPED:
			break;
		case IFC_REFUSED:
			ifc_body_cut(out, before);
			status =
				refusal_report(shaper, item, id, report, fault);
			break;
		default:
			return fault_memory(fault);
		}
	}
	return status;
}

/* What was remarked about the product so far. */
static enum tcs_status
remarks_report(struct ifc_worker *worker, const char *id, struct report *report,
	struct tcs_fault *fault)
{
	struct ifc_scratch *scratch = worker->shaper.scratch;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < scratch->remarks.count && !status; i++) {
		const struct ifc_remark *remark = scratch->remarks.at + i;
		enum ifc_entity kind =
			ifc_entity_of(worker->shaper.file, remark->instance);

		status = report_item(report, remark->severity, ifc_name(kind),
			remark->reason, id, TCS_NOWHERE, fault);
	}
	array_clear(&scratch->remarks);
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

/* ---- placing and opening ------------------------------------------------- */

/* A product's coordinates in the file's world; false where it is not known. */
static bool
product_world(
	const struct ifc_model *model, uint32_t product, struct ifc_matrix *out)
{
	uint32_t instance =
		ifc_target(&model->file, product, PRODUCT_PLACEMENT);
	const struct ifc_placement *placement =
		ifc_placement_find(&model->placements, instance);

	*out = placement ? placement->world : ifc_identity;
	return instance == STEP_NONE || (placement && placement->known);
}

/* The way back of a placement, whose axes are unit vectors square to others. */
static struct ifc_matrix
placement_back(const struct ifc_matrix *world)
{
	const double *m = world->at;
	struct ifc_matrix back = {{m[0], m[4], m[8], 0, m[1], m[5], m[9], 0,
		m[2], m[6], m[10], 0, 0, 0, 0, 1}};
	struct tcs_point origin =
		ifc_transform(&back, (struct tcs_point){-m[3], -m[7], -m[11]});

	back.at[3] = origin.x;
	back.at[7] = origin.y;
	back.at[11] = origin.z;
	return back;
}

/* The body of an opening or projection, in the host's coordinates, behind the
 * tools. */
static enum tcs_status
tool_shape(struct ifc_worker *worker, const struct ifc_opening *of,
	const struct ifc_matrix *back, const char *id, struct report *report,
	struct tcs_fault *fault)
{
	const struct ifc_model *model = worker->model;
	uint32_t product = model->tree.at[of->opening].instance;
	uint32_t body = ifc_body_of(&model->file, product);
	size_t first = worker->tools.faces.faces.count;
	struct ifc_matrix world;
	enum tcs_status status;

	if (body == STEP_NONE)
		return TCS_OK;
	if (!product_world(model, product, &world))
		return report_item(report, REPORT_SKIPPED,
			of->is_addition ? "projection" : "opening",
			"where it stands is not known", id, TCS_NOWHERE, fault);
	status = items_shape(worker, body, id, &worker->tools, report, fault);
	world = ifc_multiply(back, &world);
	ifc_faces_transform(&worker->tools.faces, first, &world);
	return status;
}

/*
 * The openings of a node, and those of what it is a part of where that has no
 * body of its own to cut; or the projections of a node.
 */
static enum tcs_status
tools_shape(struct ifc_worker *worker, uint32_t node, bool additions,
	const struct ifc_matrix *world, const char *id, struct report *report,
	struct tcs_fault *fault)
{
	const struct ifc_model *model = worker->model;
	struct ifc_matrix back = placement_back(world);
	enum tcs_status status = TCS_OK;

	ifc_body_clear(&worker->tools);
	for (;;) {
		const struct ifc_node *at = model->tree.at + node;
		const struct ifc_opening *found;
		size_t count;

		found = ifc_openings_find(&model->openings, node, &count);
		for (size_t i = 0; i < count && !status; i++)
			if (found[i].is_addition == additions)
				status = tool_shape(worker, found + i, &back,
					id, report, fault);
		if (status || additions || at->link != IFC_LINK_PART)
			return status;
		node = at->parent;
		if (ifc_body_of(&model->file, model->tree.at[node].instance) !=
			STEP_NONE)
			return status;
	}
}

typedef enum ifc_outcome tool_user(struct ifc_shaper *shaper, uint32_t product,
	const struct ifc_body *tools, struct ifc_body *body);

/* What became of a step on the body, which stays as it was if refused. */
static enum tcs_status
outcome_report(const struct ifc_worker *worker, enum ifc_outcome outcome,
	uint32_t product, const char *id, struct report *report,
	struct tcs_fault *fault)
{
	switch (outcome) {
	case IFC_SHAPED:
		return TCS_OK;
	case IFC_REFUSED:
		return refusal_report(
			&worker->shaper, product, id, report, fault);
	default:
		return fault_memory(fault);
	}
}

/* Cut or join the tools. */
static enum tcs_status
tools_use(struct ifc_worker *worker, tool_user *use, uint32_t product,
	const char *id, struct report *report, struct tcs_fault *fault)
{
	if (!worker->tools.parts.count)
		return TCS_OK;
	return outcome_report(worker,
		use(&worker->shaper, product, &worker->tools, &worker->body),
		product, id, report, fault);
}

static enum tcs_status
body_layer(struct ifc_worker *worker, uint32_t product, uint32_t paint,
	const char *id, struct report *report, struct tcs_fault *fault)
{
	return outcome_report(worker,
		ifc_body_layer(&worker->shaper, worker->model, product, paint,
			&worker->body),
		product, id, report, fault);
}

/* Whether a product is a projection that its host has joined to itself. */
static bool
is_joined(const struct ifc_model *model, uint32_t node)
{
	const struct ifc_node *at = model->tree.at + node;

	return at->link == IFC_LINK_ADDITION &&
		ifc_body_of(&model->file,
			model->tree.at[at->parent].instance) != STEP_NONE;
}

/* ---- prototypes ---------------------------------------------------------- */

enum tcs_status
ifc_prototype_shape(struct ifc_worker *worker,
	const struct ifc_prototype *prototype, struct tcs_object *out,
	bool *whole, struct report *report, struct tcs_fault *fault)
{
	struct ifc_shaper *shaper = &worker->shaper;
	struct ifc_matrix matrix, scale = ifc_identity;
	struct step_value list, value;
	enum ifc_outcome outcome;
	uint32_t representation;
	char id[IFC_GLOBAL_ID_ROOM];

	ifc_id(shaper->file, prototype->map, id);
	ifc_body_clear(&worker->body);
	shaper->points = 0;
	shaper->depth = 0;
	outcome = ifc_mapped_read(
		shaper, prototype->item, &representation, &matrix);
	list = ifc_items_of(shaper->file, representation);
	while (!outcome && list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END)
		outcome = ifc_item_body(shaper,
			step_target(shaper->file->step, &value), &worker->body);
	*whole = !outcome && !shaper->scratch->remarks.count;
	array_clear(&shaper->scratch->remarks);
	if (outcome == IFC_NO_MEMORY)
		return fault_memory(fault);
	if (!*whole)
		return TCS_OK;
	body_paint(worker, prototype->paint);
	for (int i = 0; i < 3; i++)
		scale.at[5 * i] = shaper->unit;
	if (array_grow(&out->features, 1))
		return fault_memory(fault);
	out->features.at[out->features.count++] =
		(struct tcs_feature){.parent = TCS_NONE};
	return ifc_polygons_add(worker->triangulator, &worker->body,
		&(struct ifc_target_feature){&scale, 0, LOD, id}, out, report,
		fault);
}

/* An instance of the prototype of a mapped item; false where it cannot be. */
static bool
instance_place(struct ifc_worker *worker, uint32_t item, uint32_t paint,
	const struct ifc_matrix *world, struct tcs_instance *out)
{
	const struct ifc_prototype *prototype = ifc_prototype_find(
		worker->model, worker->prototypes, item, paint);
	struct ifc_matrix mapped;
	uint32_t representation;

	worker->shaper.depth = 0;
	if (!prototype ||
		ifc_mapped_read(
			&worker->shaper, item, &representation, &mapped) ||
		ifc_determinant(&mapped) <= 0)
		return false;
	mapped = ifc_multiply(world, &mapped);
	*out = (struct tcs_instance){.prototype = prototype->number,
		.lod = LOD,
		.anchor = {mapped.at[3], mapped.at[7], mapped.at[11]}};
	for (int i = 0; i < 12; i++) {
		out->matrix[i] =
			i % 4 == 3 ? 0 : mapped.at[i] / worker->shaper.unit;
		if (!isfinite(out->matrix[i]))
			return false;
	}
	out->matrix[15] = 1;
	return isfinite(out->anchor.x) && isfinite(out->anchor.y) &&
		isfinite(out->anchor.z);
}

/* All items of a product as instances, or none: false in *placed. */
static enum tcs_status
instances_place(struct ifc_worker *worker, uint32_t node, uint32_t feature,
	const struct ifc_matrix *world, struct tcs_object *out, bool *placed,
	struct tcs_fault *fault)
{
	const struct ifc_model *model = worker->model;
	uint32_t product = model->tree.at[node].instance;
	struct step_value list =
		ifc_items_of(&model->file, ifc_body_of(&model->file, product));
	size_t before = out->instances.count;
	uint32_t paint = ifc_material_paint(model, product);
	struct step_value value;

	*placed = worker->prototypes && worker->prototypes->count &&
		ifc_is_instance(model, node);
	while (*placed && list.kind == STEP_LIST &&
		step_next(&list.list, &value) > STEP_END) {
		struct tcs_instance instance;

		if (array_grow(&out->instances, 1))
			return fault_memory(fault);
		*placed = instance_place(worker,
			step_target(model->file.step, &value), paint, world,
			&instance);
		instance.feature = feature;
		if (*placed)
			out->instances.at[out->instances.count++] = instance;
	}
	if (!*placed)
		out->instances.count = before;
	return TCS_OK;
}

/* ---- the product --------------------------------------------------------- */

static enum tcs_status
body_shape(struct ifc_worker *worker, uint32_t node, uint32_t representation,
	const struct ifc_matrix *world, const char *id, struct report *report,
	struct tcs_fault *fault)
{
	uint32_t product = worker->model->tree.at[node].instance;
	uint32_t paint = ifc_material_paint(worker->model, product);
	enum tcs_status status;

	ifc_body_clear(&worker->body);
	worker->shaper.points = 0;
	status = items_shape(
		worker, representation, id, &worker->body, report, fault);
	if (!status)
		status = tools_shape(
			worker, node, true, world, id, report, fault);
	if (!status)
		status = tools_use(
			worker, ifc_body_join, product, id, report, fault);
	body_paint(worker, paint);
	if (!status)
		status = tools_shape(
			worker, node, false, world, id, report, fault);
	if (!status)
		status = tools_use(
			worker, ifc_body_open, product, id, report, fault);
	if (!status && worker->layers)
		status = body_layer(worker, product, paint, id, report, fault);
	return status ? status : remarks_report(worker, id, report, fault);
}

enum tcs_status
ifc_product_shape(struct ifc_worker *worker, uint32_t node, uint32_t feature,
	struct tcs_object *out, struct report *report, struct tcs_fault *fault)
{
	const struct ifc_file *file = &worker->model->file;
	uint32_t product = worker->model->tree.at[node].instance;
	uint32_t representation = ifc_body_of(file, product);
	char id[IFC_GLOBAL_ID_ROOM];
	struct ifc_matrix world, placed;
	enum tcs_status status;
	bool done;

	if (!ifc_is_shown(file, product) || is_joined(worker->model, node))
		return TCS_OK;
	ifc_global_id(file, product, id);
	if (representation == STEP_NONE)
		return report_item(report, REPORT_NOTE, "product",
			"has no body, only what stands for it", id, TCS_NOWHERE,
			fault);
	if (!product_world(worker->model, product, &world))
		return report_item(report, REPORT_SKIPPED, "product",
			"where it stands is not known", id, TCS_NOWHERE, fault);
	placed = ifc_multiply(&worker->world, &world);
	status = instances_place(
		worker, node, feature, &placed, out, &done, fault);
	if (status || done)
		return status;
	status = body_shape(
		worker, node, representation, &world, id, report, fault);
	if (!status)
		status = ifc_polygons_add(worker->triangulator, &worker->body,
			&(struct ifc_target_feature){&placed, feature, LOD, id},
			out, report, fault);
	return status;
}
