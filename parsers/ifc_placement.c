#include "ifc_placement.h"

#include <math.h>
#include <stdlib.h>

#include "ifc_alignment.h"
#include "ifc_placement_grid.h"
#include "ifc_units.h"

/* In metres, for the curves that placements lie on. */
static const double DEFLECTION = 1e-4, PRECISION = 1e-6;

/* The state of a placement while the chains are multiplied out. */
enum { UNSEEN, WAITING, DONE };

struct resolving {
	const struct ifc_file *file;
	struct ifc_placements *placements;
	struct report *report;
	struct ifc_shaper shaper; /* for those along curves */
	struct ifc_alignment_kept alignment;
	unsigned char *states;
	uint32_t *chain; /* indices, from the first asked for up to the root */
	int parent_at, relative_at, cartesian_at;
};

static const struct ifc_placement *
placement_at(const struct ifc_placements *placements, uint32_t instance)
{
	size_t low = 0, high = placements->count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (placements->at[middle].instance < instance)
			low = middle + 1;
		else
			high = middle;
	}
	return low < placements->count &&
			placements->at[low].instance == instance
		? placements->at + low
		: NULL;
}

const struct ifc_placement *
ifc_placement_find(const struct ifc_placements *placements, uint32_t instance)
{
	return placement_at(placements, instance);
}

static enum tcs_status
unknown(struct resolving *resolving, const struct ifc_placement *placement,
	const char *reason, struct tcs_fault *fault)
{
	char id[IFC_ID_LENGTH];

	ifc_id(resolving->file, placement->instance, id);
	return report_item(resolving->report, REPORT_SKIPPED, "placement",
		reason, id,
		step_place(resolving->file->step, placement->instance), fault);
}

static bool
is_finite(const struct ifc_matrix *matrix)
{
	for (int i = 0; i < 16; i++)
		if (!isfinite(matrix->at[i]))
			return false;
	return true;
}

/* Whether a linear placement says where in the world it is. */
static bool
is_cartesian(const struct resolving *resolving, uint32_t instance,
	struct ifc_matrix *out)
{
	const struct ifc_file *file = resolving->file;

	return ifc_entity_of(file, instance) == IFC_LINEARPLACEMENT &&
		ifc_axes(file,
			ifc_target(file, instance, resolving->cartesian_at),
			out);
}

/* The matrix of a placement by itself; NULL, or why there is none. */
static const char *
own_matrix(struct resolving *resolving, const struct ifc_placement *placement,
	struct ifc_matrix *out)
{
	const struct ifc_file *file = resolving->file;
	uint32_t instance = placement->instance;

	switch (ifc_entity_of(file, instance)) {
	case IFC_LOCALPLACEMENT:
		if (ifc_axes(file,
			    ifc_target(file, instance, resolving->relative_at),
			    out))
			return NULL;
		return "it has no axes";
	case IFC_LINEARPLACEMENT:
		if (is_cartesian(resolving, instance, out))
			return NULL;
		resolving->shaper.depth = 0;
		resolving->shaper.points = 0;
		if (!ifc_linear_axes(&resolving->shaper,
			    ifc_target(file, instance, resolving->relative_at),
			    &resolving->alignment, out))
			return NULL;
		return "along a curve that is not known";
	case IFC_GRIDPLACEMENT:
		return ifc_grid_matrix(&resolving->shaper, instance, out);
	default:
		return "of a kind not supported";
	}
}

/* Grid placements had no such attribute before IFC4X3. */
static bool
has_parent(const struct resolving *resolving, uint32_t instance)
{
	const struct ifc_file *file = resolving->file;
	int position = ifc_attribute(
		file->version, ifc_entity_of(file, instance), "PlacementRelTo");

	return position != IFC_NO_POSITION &&
		ifc_value(file, instance, position).kind != STEP_UNSET;
}

static uint32_t
parent_of(const struct resolving *resolving, uint32_t instance)
{
	const struct ifc_file *file = resolving->file;

	if (ifc_entity_of(file, instance) == IFC_GRIDPLACEMENT &&
		!has_parent(resolving, instance))
		return ifc_grid_placement_of(file, instance);
	return ifc_target(file, instance, resolving->parent_at);
}

/* The placement's parent is done, or it has none. */
static enum tcs_status
placement_finish(struct resolving *resolving, struct ifc_placement *placement,
	struct tcs_fault *fault)
{
	const struct ifc_placement *parent = placement->parent == STEP_NONE
		? NULL
		: resolving->placements->at + placement->parent;
	struct ifc_matrix own, unused;
	const char *reason = own_matrix(resolving, placement, &own);

	if (!reason && parent && !parent->known)
		reason = "relative to one that is not known";
	if (!reason && !parent && has_parent(resolving, placement->instance))
		reason = "relative to what is no placement";
	if (reason)
		return unknown(resolving, placement, reason, fault);
	/* Those of a linear placement's Cartesian position are the world's. */
	if (parent && !is_cartesian(resolving, placement->instance, &unused))
		own = ifc_multiply(&parent->world, &own);
	if (!is_finite(&own))
		return unknown(resolving, placement, "not finite", fault);
	placement->world = own;
	placement->known = true;
	return TCS_OK;
}

/* Those from `first` on of the chain go round. */
static enum tcs_status
cycle_close(struct resolving *resolving, size_t *count, uint32_t first,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint32_t index;

	do {
		index = resolving->chain[--*count];
		resolving->states[index] = DONE;
		status = unknown(resolving, resolving->placements->at + index,
			"relative to itself", fault);
	} while (!status && index != first);
	return status;
}

/* Up to what is done or the root, and down again. */
static enum tcs_status
chain_resolve(
	struct resolving *resolving, uint32_t start, struct tcs_fault *fault)
{
	struct ifc_placement *all = resolving->placements->at;
	enum tcs_status status = TCS_OK;
	uint32_t index = start;
	size_t count = 0;

	while (index != STEP_NONE && resolving->states[index] == UNSEEN) {
		resolving->states[index] = WAITING;
		resolving->chain[count++] = index;
		index = all[index].parent;
	}
	if (index != STEP_NONE && resolving->states[index] == WAITING)
		status = cycle_close(resolving, &count, index, fault);
	while (count && !status) {
		index = resolving->chain[--count];
		resolving->states[index] = DONE;
		status = placement_finish(resolving, all + index, fault);
	}
	return status;
}

static enum tcs_status
placements_list(struct resolving *resolving, struct tcs_fault *fault)
{
	const struct ifc_file *file = resolving->file;
	struct ifc_placements *out = resolving->placements;
	struct ifc_instances found = {.count = 0};
	enum tcs_status status;

	status = ifc_collect(file, IFC_OBJECTPLACEMENT, &found, fault);
	if (!status && array_grow(out, found.count + 1))
		status = fault_memory(fault);
	for (size_t i = 0; i < found.count && !status; i++)
		out->at[out->count++] =
			(struct ifc_placement){.instance = found.at[i],
				.parent = STEP_NONE,
				.world = ifc_identity};
	array_release(&found);
	for (size_t i = 0; i < out->count && !status; i++) {
		const struct ifc_placement *parent = placement_at(
			out, parent_of(resolving, out->at[i].instance));

		if (parent)
			out->at[i].parent = (uint32_t)(parent - out->at);
	}
	return status;
}

/* What evaluates the curves that placements lie on. */
static enum tcs_status
shaper_make(const struct ifc_file *file, struct ifc_shaper *out,
	struct tcs_fault *fault)
{
	struct report unread = {.reasons = {.count = 0}};
	struct ifc_units units;
	enum tcs_status status = ifc_units_read(file, &units, &unread, fault);

	report_release(&unread);
	if (!status)
		*out = (struct ifc_shaper){.file = file,
			.angle = units.angle,
			.deflection = DEFLECTION / units.length,
			.precision = PRECISION / units.length};
	return status;
}

enum tcs_status
ifc_placements_read(const struct ifc_file *file, struct ifc_placements *out,
	struct report *report, struct tcs_fault *fault)
{
	struct resolving resolving = {.file = file,
		.placements = out,
		.report = report,
		.parent_at = ifc_attribute(
			file->version, IFC_LOCALPLACEMENT, "PlacementRelTo"),
		.relative_at = ifc_attribute(
			file->version, IFC_LOCALPLACEMENT, "RelativePlacement"),
		.cartesian_at = ifc_attribute(file->version,
			IFC_LINEARPLACEMENT, "CartesianPosition")};
	enum tcs_status status;

	array_clear(out);
	status = shaper_make(file, &resolving.shaper, fault);
	if (!status)
		status = placements_list(&resolving, fault);
	if (status)
		return status;
	resolving.states = calloc(out->count + 1, 1);
	resolving.chain = calloc(out->count + 1, sizeof *resolving.chain);
	if (!resolving.states || !resolving.chain)
		status = fault_memory(fault);
	for (uint32_t i = 0; i < out->count && !status; i++)
		status = chain_resolve(&resolving, i, fault);
	array_release(&resolving.alignment.marks);
	free(resolving.states);
	free(resolving.chain);
	return status;
}
