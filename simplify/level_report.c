#include "level_report.h"

#include <math.h>

#include "labels.h"

/* Short of the goal by more than this share is worth a word. */
#define GOAL_TOLERANCE 0.01

bool
level_is_unchanged(const struct object_simplifier *simplifier)
{
	return simplifier->openings.dissolved == 0 &&
		simplifier->collapses.face_count ==
		simplifier->sheets.face_triangles.count;
}

static const char *
reason_of(const struct object_simplifier *simplifier)
{
	bool watched = simplifier->collapses.watch.limit < INFINITY;

	if (level_is_unchanged(simplifier))
		return watched ? "unchanged: nothing can go without moving "
				 "farther than --max-error, or tearing it apart"
			       : "unchanged: nothing can go without tearing it "
				 "apart";
	return watched ? "short of its rate: all that is left would move "
			 "farther than --max-error, or tear it apart"
		       : "short of its rate: no collapse is left that keeps "
			 "it whole";
}

/* Openings that became part of their walls have not vanished. */
static enum tcs_status
list_vanished(const struct object_simplifier *simplifier,
	const struct tcs_object *in, struct report *report,
	struct tcs_fault *fault)
{
	const struct collapses *work = &simplifier->collapses;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < work->surfaces.count; i++) {
		const struct tcs_feature *feature = &in->features.at[i];

		if (simplifier->writer.faces.samples.at[i] == TCS_NONE ||
			simplifier->homes.at[i] != i ||
			work->surfaces.at[i] > 0)
			continue;
		status = report_listed(report, "surface",
			"vanished: no triangle of it is left",
			object_text(in, feature->id),
			label_of(feature->class)->name, fault);
	}
	return status;
}

/* Each surface once. */
static enum tcs_status
list_merged(struct merges *merges, const struct tcs_object *in,
	struct report *report, struct tcs_fault *fault)
{
	const uint32_t *features;
	size_t count = merges_features(merges, &features);
	enum tcs_status status =
		report_add(report, "parts merged", merges->joined, fault);

	for (size_t i = 0; !status && i < count; i++) {
		const struct tcs_feature *feature =
			&in->features.at[features[i]];

		status = report_listed(report, "surface",
			"merged: touching parts of it became one",
			object_text(in, feature->id),
			label_of(feature->class)->name, fault);
	}
	merges->joined = 0;
	merges->features.count = 0;
	return status;
}

enum tcs_status
level_report_work(struct object_simplifier *simplifier,
	const struct tcs_object *in, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = report_add(
		report, "overlaps parted", simplifier->overlaps.parted, fault);

	if (!status)
		status = report_add(report, "holes closed",
			simplifier->handles.closed, fault);
	if (!status)
		status = report_add(report, "panels made",
			simplifier->handles.panels.made, fault);
	simplifier->handles.closed = simplifier->handles.panels.made = 0;
	return status ? status
		      : list_merged(&simplifier->merges, in, report, fault);
}

enum tcs_status
level_report(const struct object_simplifier *simplifier,
	const struct tcs_object *in, const struct simplify_level *level,
	size_t target, struct report *report, struct tcs_fault *fault)
{
	const struct collapses *work = &simplifier->collapses;
	double all = (double)simplifier->source.set.triangles.count;
	double over = (double)work->face_count - (double)target;
	enum tcs_status status =
		report_add(report, "triangles after", work->face_count, fault);

	if (!status && level->budget.kind != BUDGET_ERROR &&
		over > GOAL_TOLERANCE * all)
		status = report_item(report, REPORT_NOTE, "object",
			reason_of(simplifier),
			object_text(in, in->features.at[0].id), TCS_NOWHERE,
			fault);
	if (!status && !level_is_unchanged(simplifier))
		status = list_vanished(simplifier, in, report, fault);
	return status;
}
