#include "object_simplifier.h"

#include <math.h>

/* How far faces may turn, and once that is all, to come to the rate. */
#define LEAST_COSINE 0.5
#define LAST_COSINE 0.1

/* Short of the rate by more than this is worth a word. */
#define RATE_TOLERANCE 0.01

static enum tcs_status
prepare(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	struct tcs_fault *fault)
{
	const struct component_set *set = &simplifier->source.set;
	const struct collapse_settings first = {
		settings->base_ratio, LEAST_COSINE, false};
	double reach;
	enum tcs_status status = lod_source_load(&simplifier->source, in,
		settings->source, &settings->crs, fault);

	if (!status)
		status = sheets_build(&simplifier->sheets, set, fault);
	if (status)
		return status;
	reach = contact_reach(set);
	status = contacts_find(set, reach, &simplifier->contacts, fault);
	if (!status)
		status =
			seams_find(&simplifier->seams, set, &simplifier->sheets,
				&simplifier->contacts, reach, fault);
	if (!status)
		status = collapses_begin(&simplifier->collapses, set,
			&simplifier->sheets, &simplifier->seams, &first, fault);
	return status;
}

/* Collapse down to a level: first as it should be, then as it can be. */
static enum tcs_status
reach_level(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, double rate,
	struct tcs_fault *fault)
{
	struct collapses *collapses = &simplifier->collapses;
	const struct collapse_settings last = {
		settings->base_ratio, LAST_COSINE, true};
	double faces = (double)simplifier->source.set.triangles.count;
	size_t target = (size_t)ceil(faces * (1 - rate));
	enum tcs_status status = collapses_run(collapses, target, fault);

	if (!status && collapses->face_count > target)
		status = collapses_resume(collapses, &last, fault);
	if (!status)
		status = collapses_run(collapses, target, fault);
	return status;
}

static enum tcs_status
report_level(const struct object_simplifier *simplifier,
	const struct tcs_object *in, const struct simplify_level *level,
	struct report *report, struct tcs_fault *fault)
{
	double before = (double)simplifier->source.set.triangles.count;
	double after = (double)simplifier->collapses.face_count;

	if (!before || 1 - after / before >= level->rate - RATE_TOLERANCE)
		return TCS_OK;
	return report_item(report, REPORT_NOTE, "object",
		"short of its rate: no collapse is left that keeps it whole",
		object_text(in, in->features.at[0].id), TCS_NOWHERE, fault);
}

/* What is replaced is left out: by the level that takes its place. */
static bool
is_replaced(const struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	uint32_t geometry)
{
	const struct tcs_geometry *own = &in->geometries.at[geometry];

	for (size_t i = 0; i < settings->level_count; i++)
		if (settings->levels[i].lod < 0
				? simplifier->source.selection.geometries
					  .at[geometry]
				: settings->levels[i].lod == own->lod &&
					geometry_has_area(own))
			return true;
	return false;
}

static enum tcs_status
write_level(struct object_simplifier *simplifier, const struct tcs_object *in,
	const struct simplify_level *level, struct tcs_fault *fault)
{
	struct lod_writer *writer = &simplifier->writer;
	const struct lod_source *source = &simplifier->source;
	enum tcs_status status =
		lod_write_faces(writer, source, &simplifier->collapses, fault);

	if (!status && level->lod >= 0)
		return lod_write_level(
			writer, source, (uint8_t)level->lod, fault);
	for (uint32_t i = 0; !status && i < in->geometries.count; i++)
		if (source->selection.geometries.at[i])
			status = lod_write_simplified(writer, source, i, fault);
	return status;
}

static enum tcs_status
write_kept(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		lod_write_begin(&simplifier->writer, in, fault);

	for (uint32_t i = 0; !status && i < in->geometries.count; i++)
		if (!is_replaced(simplifier, settings, in, i))
			status = lod_write_copy(&simplifier->writer, i, fault);
	return status;
}

enum tcs_status
simplify_object(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, const struct tcs_object *in,
	const struct tcs_object **out, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = prepare(simplifier, settings, in, fault);

	*out = &simplifier->writer.to;
	if (!status)
		status = report_add(report, "triangles before",
			simplifier->source.set.triangles.count, fault);
	if (!status)
		status = write_kept(simplifier, settings, in, fault);
	for (size_t i = 0; !status && i < settings->level_count; i++) {
		const struct simplify_level *level = &settings->levels[i];

		status = reach_level(simplifier, settings, level->rate, fault);
		if (!status)
			status = write_level(simplifier, in, level, fault);
		if (!status)
			status = report_level(
				simplifier, in, level, report, fault);
		if (!status)
			status = report_add(report, "triangles after",
				simplifier->collapses.face_count, fault);
	}
	return status;
}

void
object_simplifier_release(struct object_simplifier *simplifier)
{
	lod_source_release(&simplifier->source);
	sheets_release(&simplifier->sheets);
	array_release(&simplifier->contacts);
	seams_release(&simplifier->seams);
	collapses_release(&simplifier->collapses);
	lod_write_release(&simplifier->writer);
}
