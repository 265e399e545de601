/*
 * The bytes as an IFC file: units, placements, the tree of objects, every
 * instance as a transformation, and all of it as objects of a stream. What is
 * known must be finite, every way up must end, and what is written must keep
 * the stream's rules.
 */
#include <math.h>
#include <stdlib.h>

#include "parsers/ifc_append.h"
#include "parsers/ifc_features.h"
#include "parsers/ifc_georeference.h"
#include "parsers/ifc_product.h"

static void
placements_check(const struct ifc_file *file, struct report *report)
{
	struct ifc_placements placements = {.count = 0};
	struct tcs_fault fault;

	if (ifc_placements_read(file, &placements, report, &fault))
		abort();
	for (size_t i = 0; i < placements.count; i++) {
		const struct ifc_placement *at = placements.at + i;

		if (ifc_placement_find(&placements, at->instance) != at)
			abort();
		for (int k = 0; k < 16; k++)
			if (!isfinite(at->world.at[k]))
				abort();
		if (at->known && at->parent != STEP_NONE &&
			!placements.at[at->parent].known)
			abort();
	}
	array_release(&placements);
}

static void
tree_check(const struct ifc_file *file, struct report *report)
{
	struct ifc_tree tree = {.count = 0};
	struct tcs_fault fault;

	if (ifc_tree_read(file, &tree, report, &fault))
		abort();
	for (uint32_t i = 0; i < tree.count; i++) {
		size_t steps = 0;

		for (uint32_t at = i; at != STEP_NONE; at = tree.at[at].parent)
			if (steps++ > tree.count)
				abort();
		if ((tree.at[i].parent == STEP_NONE) !=
			(tree.at[i].link == IFC_LINK_NONE))
			abort();
	}
	array_release(&tree);
}

static void
instances_check(const struct ifc_file *file)
{
	for (uint32_t i = 0; i < file->step->instances.count; i++) {
		struct ifc_matrix matrix;
		double factor;

		ifc_axes(file, i, &matrix);
		ifc_operator(file, i, &matrix);
		if (ifc_unit_factor(file, i, &factor) && !(factor > 0))
			abort();
	}
}

/* A shape of the fuzzer's may be large in itself; one of many chords is too. */
static const double DEFLECTION = 1;

static void
piece_build(struct ifc_worker *worker, const struct ifc_object *object,
	uint32_t first, uint32_t count, struct tcs_object *out,
	struct report *report)
{
	const struct ifc_model *model = worker->model;
	struct tcs_fault fault;

	if (ifc_features_write(model, object, first, count, out, &fault))
		abort();
	for (uint32_t i = first; i < first + count; i++)
		if (ifc_product_shape(worker,
			    model->objects.members.at[object->first_member + i]
				    .node,
			    i, out, report, &fault))
			abort();
}

static void
object_build(struct ifc_worker *worker, const struct ifc_object *object,
	struct report *report)
{
	struct tcs_object out = {.text = {0}}, more = {.text = {0}};
	uint32_t half = (object->member_count + 1) / 2;
	struct tcs_fault fault;

	piece_build(worker, object, 0, half, &out, report);
	piece_build(worker, object, half, object->member_count - half, &more,
		report);
	if (ifc_object_append(&out, &more, &fault) ||
		object_check(&out, &fault))
		abort();
	object_release(&out);
	object_release(&more);
}

static void
objects_check(const char *bytes, size_t size)
{
	struct report report = {.counts = {0}};
	struct ifc_georeference place;
	struct ifc_worker worker = {.model = NULL};
	struct ifc_model model;
	struct tcs_fault fault;

	if (!ifc_model_read(&model, bytes, size, &(struct ifc_keep){0}, 1,
		    &report, &fault)) {
		ifc_georeference_read(&model, false, &place);
		if (ifc_worker_begin(
			    &worker, &model, &place.world, DEFLECTION, &fault))
			abort();
		worker.layers = true;
		for (size_t i = 0; i < model.objects.objects.count; i++)
			object_build(
				&worker, model.objects.objects.at + i, &report);
		ifc_worker_end(&worker);
	}
	ifc_model_release(&model);
	report_release(&report);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int
LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
	struct step_file step = {.text = NULL};
	struct ifc_file file = {.step = NULL};
	struct report report = {.counts = {0}};
	struct ifc_units units;
	struct tcs_fault fault;

	if (!step_index(&step, (const char *)bytes, size, &report, &fault) &&
		!ifc_open(&file, &step, &fault)) {
		if (ifc_units_read(&file, &units, &report, &fault) ||
			!(units.length > 0) || !(units.angle > 0))
			abort();
		placements_check(&file, &report);
		tree_check(&file, &report);
		instances_check(&file);
	}
	ifc_close(&file);
	step_release(&step);
	report_release(&report);
	objects_check((const char *)bytes, size);
	return 0;
}
