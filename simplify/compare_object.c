#include "compare_object.h"

#include <math.h>

#include "compare_distance.h"
#include "compare_health.h"
#include "split_work.h"

enum { LARGE = 20000 }; /* triangles worth more than one thread */

static double
surface_area(const struct component_set *set)
{
	double area = 0;

	for (size_t i = 0; i < set->components.count; i++)
		area += set->components.at[i].area;
	return area;
}

static double
enclosed_volume(const struct component_set *set)
{
	double volume = 0;

	for (size_t i = 0; i < set->components.count; i++)
		volume += set->components.at[i].volume;
	return volume;
}

static enum tcs_status
describe_side(const struct compare_side *side, bool is_after, double *at,
	struct tcs_fault *fault)
{
	const struct component_set *set = &side->set;
	struct mesh_health health;
	enum tcs_status status = mesh_health_measure(set, &health, fault);

	/* Each name of before is followed by that of after. */
	at += is_after;
	at[COMPARE_TRIANGLES_BEFORE] = (double)set->triangles.count;
	at[COMPARE_COMPONENTS_BEFORE] = (double)set->components.count;
	at[COMPARE_AREA_BEFORE] = surface_area(set);
	at[COMPARE_VOLUME_BEFORE] = enclosed_volume(set);
	at[COMPARE_OPEN_BEFORE] = (double)health.open;
	at[COMPARE_NON_MANIFOLD_BEFORE] = (double)health.non_manifold;
	at[COMPARE_MISALIGNED_BEFORE] = (double)health.misaligned;
	at[COMPARE_DEGENERATE_BEFORE] = (double)health.degenerate;
	at[COMPARE_DUPLICATE_BEFORE] = (double)health.duplicate;
	return status;
}

static enum tcs_status
find_lost_surfaces(const struct comparer *comparer,
	struct compare_result *result, struct tcs_fault *fault)
{
	const struct compare_side *before = &comparer->before;
	const struct compare_side *after = &comparer->after;

	for (uint32_t i = 0; i < before->roots.count; i++) {
		uint32_t twin = before->twins.at[i];

		if (before->roots.at[i] == NO_TREE)
			continue;
		result->metrics.at[COMPARE_SURFACES_BEFORE]++;
		if (twin != TCS_NONE && after->roots.at[twin] != NO_TREE)
			continue;
		if (array_grow(&result->lost, 1))
			return fault_memory(fault);
		result->lost.at[result->lost.count++] = i;
	}
	result->metrics.at[COMPARE_SURFACES_LOST] = (double)result->lost.count;
	return TCS_OK;
}

static enum tcs_status
measure_distances(const struct comparer *comparer, double tolerance, double *at,
	struct tcs_fault *fault)
{
	struct surface_distance there, back;
	enum tcs_status status = surface_distance_measure(
		&comparer->before, &comparer->after, tolerance, &there, fault);

	if (!status)
		status = surface_distance_measure(&comparer->after,
			&comparer->before, tolerance, &back, fault);
	if (status)
		return status;
	at[COMPARE_THERE_MAX] = there.max;
	at[COMPARE_THERE_AT_MOST] = there.at_most;
	at[COMPARE_THERE_MEAN] = there.mean;
	at[COMPARE_THERE_RMS] = there.rms;
	at[COMPARE_THERE_SPACING] = there.spacing;
	at[COMPARE_BACK_MAX] = back.max;
	at[COMPARE_BACK_AT_MOST] = back.at_most;
	at[COMPARE_BACK_MEAN] = back.mean;
	at[COMPARE_BACK_RMS] = back.rms;
	at[COMPARE_BACK_SPACING] = back.spacing;
	return TCS_OK;
}

/* The features of the first triangles stand for the components. */
static enum tcs_status
name_broken(const struct compare_side *before, struct compare_result *result,
	struct tcs_fault *fault)
{
	const struct component_set *set = &before->set;

	if (array_grow(&result->features, 2 * result->broken.count))
		return fault_memory(fault);
	for (size_t i = 0; i < result->broken.count; i++) {
		const struct broken_contact *broken = &result->broken.at[i];
		uint32_t pair[2] = {broken->a, broken->b};

		for (int k = 0; k < 2; k++) {
			uint32_t first = set->components.at[pair[k]].first;

			result->features.at[result->features.count++] =
				set->features.at[set->order.at[first]];
		}
	}
	return TCS_OK;
}

/* What it takes to load a side, and how that ended. */
struct loading {
	struct compare_side *side;
	const struct compared_object *from;
	int lod;
	struct frame frame;
	enum tcs_status status;
	struct tcs_fault fault;
};

static void
load_one(void *context, size_t piece, size_t first, size_t end)
{
	struct loading *loading = (struct loading *)context + piece;

	(void)first;
	(void)end;
	loading->status = side_load(loading->side, loading->from->object,
		loading->from->placed, loading->lod, &loading->frame,
		&loading->fault);
}

/* A point of the object, so that nothing is lost far from 0. */
static struct tcs_point
choose_origin(const struct tcs_object *before, const struct tcs_object *after)
{
	const struct tcs_object *both[2] = {before, after};

	for (int i = 0; i < 2; i++) {
		if (both[i] && both[i]->vertices.count)
			return both[i]->vertices.at[0];
		if (both[i] && both[i]->instances.count)
			return both[i]->instances.at[0].anchor;
	}
	return (struct tcs_point){0, 0, 0};
}

static enum tcs_status
load_sides(struct comparer *comparer, const struct compare_settings *settings,
	const struct compared_object pair[2], struct tcs_fault *fault)
{
	const struct tcs_object *before = pair[0].object;
	const struct tcs_object *after = pair[1].object;
	struct tcs_point origin = choose_origin(before, after);
	struct loading sides[2] = {
		{.side = &comparer->before, .from = &pair[0]},
		{.side = &comparer->after, .from = &pair[1]},
	};
	unsigned jobs = before && after &&
			before->triangles.count + after->triangles.count >=
				LARGE
		? settings->jobs
		: 1;
	enum tcs_status status;

	for (int i = 0; i < 2; i++) {
		sides[i].lod = settings->lods[i];
		sides[i].side->set.jobs = jobs;
		frame_init(&sides[i].frame, &settings->crs[i], &origin);
	}
	status = split_work(2, 1, jobs, load_one, sides, fault);
	for (int i = 0; i < 2 && !status; i++) {
		status = sides[i].status;
		if (status)
			*fault = sides[i].fault;
	}
	if (!status)
		status = side_match_features(&comparer->before, before,
			&comparer->after, after, fault);
	return status;
}

static enum tcs_status
compare_crossings(
	struct comparer *comparer, double *at, struct tcs_fault *fault)
{
	struct crossings *before = &comparer->crossings[0];
	struct crossings *after = &comparer->crossings[1];
	enum tcs_status status =
		crossings_find(&comparer->before.set, before, fault);

	if (!status)
		status = crossings_find(&comparer->after.set, after, fault);
	if (status)
		return status;
	at[COMPARE_CROSSING_OWN_BEFORE] = (double)before->own;
	at[COMPARE_CROSSING_OWN_AFTER] = (double)after->own;
	at[COMPARE_CROSSING_BEFORE] = (double)before->pairs.count;
	at[COMPARE_CROSSING_AFTER] = (double)after->pairs.count;
	at[COMPARE_CROSSING_NEW] =
		(double)crossings_count_new(before, after, &comparer->match);
	return TCS_OK;
}

static enum tcs_status
compare_sides(struct comparer *comparer, double eps,
	struct compare_result *result, struct tcs_fault *fault)
{
	struct compare_side *before = &comparer->before;
	double *at = result->metrics.at;
	enum tcs_status status = describe_side(before, false, at, fault);
	size_t flipped;

	if (!status)
		status = describe_side(&comparer->after, true, at, fault);
	if (!status)
		status = contacts_find(
			&before->set, eps, &before->contacts, fault);
	if (!status)
		status = match_components(
			&comparer->match, before, &comparer->after, eps, fault);
	if (!status)
		status = compare_contacts(before, &comparer->after,
			&comparer->match, eps, &result->metrics,
			&result->broken, fault);
	if (!status)
		status = name_broken(before, result, fault);
	if (!status)
		status = compare_crossings(comparer, at, fault);
	if (!status)
		status = find_lost_surfaces(comparer, result, fault);
	if (status)
		return status;
	status = count_flipped(before, &comparer->after, &comparer->match, eps,
		&flipped, fault);
	at[COMPARE_FLIPPED] = (double)flipped;
	if (status)
		return status;
	return measure_distances(comparer, fmin(eps / 10, 0.001), at, fault);
}

/* By more than rounding, so that there is something to draw. */
static bool
differs(const struct compare_result *result)
{
	const double *at = result->metrics.at;

	return at[COMPARE_TRIANGLES_BEFORE] > 0 &&
		!(at[COMPARE_THERE_MAX] < 1e-6 && at[COMPARE_BACK_MAX] < 1e-6 &&
			result->broken.count == 0 &&
			at[COMPARE_COMPONENTS_FLIPPED] <= 0);
}

enum tcs_status
compare_objects(struct comparer *comparer,
	const struct compare_settings *settings,
	const struct compared_object pair[2], struct compare_result *result,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	double eps;

	result->metrics = (struct compare_metrics){0};
	result->broken.count = 0;
	result->features.count = 0;
	result->lost.count = 0;
	for (int i = 0; i < PICTURE_COUNT; i++)
		array_clear(&result->pictures.png[i]);
	status = load_sides(comparer, settings, pair, fault);
	if (status)
		return status;
	eps = settings->eps > 0 ? settings->eps
				: contact_reach(&comparer->before.set);
	result->metrics.at[COMPARE_DIAGONAL] =
		box_diagonal(&comparer->before.set.bounds);
	result->metrics.at[COMPARE_EPS] = eps;
	status = compare_sides(comparer, eps, result, fault);
	if (!status && settings->pixels > 0)
		status = compare_views(&comparer->before, &comparer->after,
			&comparer->match, &result->broken, settings->pixels,
			&comparer->pictures, &result->metrics, fault);
	if (!status && settings->pictures && differs(result))
		status = object_pictures_draw(&comparer->before,
			&comparer->after,
			(const struct tcs_object *[]){
				pair[0].object, pair[1].object},
			4 * eps, &result->pictures, fault);
	return status;
}

void
comparer_release(struct comparer *comparer)
{
	side_release(&comparer->before);
	side_release(&comparer->after);
	match_release(&comparer->match);
	for (int i = 0; i < 2; i++)
		crossings_release(&comparer->crossings[i]);
	pictures_release(&comparer->pictures);
}

void
compare_result_release(struct compare_result *result)
{
	array_release(&result->broken);
	array_release(&result->features);
	array_release(&result->lost);
	object_pictures_release(&result->pictures);
}
