/*
 * The bytes as an IFC file: units, placements, the tree of objects, and every
 * instance as a transformation. What is known must be finite, and every way up
 * must end.
 */
#include <math.h>
#include <stdlib.h>

#include "parsers/ifc_placement.h"
#include "parsers/ifc_tree.h"
#include "parsers/ifc_units.h"

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
	return 0;
}
