#include "merges.h"

#include <math.h>

#include "number_sort.h"

/* Metres: what is less off is not worth a look yet. */
#define LEAST_OFF 0.01

/* Of the faces that an object came with, no more than this share goes beyond
   what is wanted. */
#define MOST_BELOW 0.005

/* What is empty may be less than it seems: groups know no slanting boxes. */
#define EMPTY_SHARE 0.5

/* ---- finding ------------------------------------------------------------- */

/* What a group may cost, if it does not fit exactly: nothing is looked at before
   that is dear. What is empty is taken to be spread over the surface. */
static double
least_price(const struct merges *merges, const struct merge_group *group)
{
	const struct parts *parts = &merges->removals->parts;
	double area = 0, faces = 0, off;

	for (uint32_t i = 0; i < group->count; i++) {
		const struct part *own =
			&parts->at
				 .at[merges->groups.parts.at[group->first + i]];

		area += own->area;
		faces += own->count;
	}
	off = fmax(LEAST_OFF, EMPTY_SHARE * group->empty / area);
	return HIDDEN_SHARE * area * off * off / (0.5 * faces);
}

enum tcs_status
merges_find(struct merges *merges, struct component_set *set,
	struct collapses *work, struct removals *removals,
	struct tcs_fault *fault)
{
	enum tcs_status status = merge_groups_find(
		&merges->groups, work, &removals->parts, fault);
	size_t count = merges->groups.at.count;

	merges->set = set;
	merges->work = work;
	merges->removals = removals;
	merges->joined = 0;
	array_clear(&merges->features);
	array_clear(&merges->postponed);
	array_clear(&merges->known);
	if (!status && array_grow(&merges->known, count))
		status = fault_memory(fault);
	if (!status)
		status = node_queue_reset(&merges->queue, count, fault);
	if (!status)
		status = merge_pricing_begin(&merges->pricing, removals, fault);
	if (status)
		return status;
	merges->known.count = count;
	for (size_t i = 0; i < count; i++)
		merges->known.at[i] = (struct merge_known){.parts = 0};
	/* What is watched cannot be refilled. */
	for (uint32_t i = 0; !(work->settings.max_error > 0) && i < count; i++)
		node_queue_set(&merges->queue, i,
			least_price(merges, &merges->groups.at.at[i]));
	return TCS_OK;
}

enum tcs_status
merges_aim(struct merges *merges, size_t target, struct tcs_fault *fault)
{
	size_t slack =
		(size_t)((double)merges->work->features.count * MOST_BELOW);

	merges->least = target > slack ? target - slack : 0;
	for (size_t i = 0; i < merges->postponed.count; i++) {
		const struct queue_entry *own = &merges->postponed.at[i];

		node_queue_set(&merges->queue, own->node, own->cost);
	}
	merges->postponed.count = 0;
	/* There is room for all of them. */
	return array_grow(&merges->postponed, merges->known.count)
		? fault_memory(fault)
		: TCS_OK;
}

double
merges_next_cost(const struct merges *merges)
{
	const struct queue_entry *first = node_queue_first(&merges->queue);

	return first ? first->cost : INFINITY;
}

/* What would save more than is wanted waits for the next level. */
static bool
saves_too_much(const struct merges *merges)
{
	const struct merge_plan *plan = &merges->plan;

	return merges->work->face_count < merges->least + plan->faces.count -
		PRISM_TRIANGLES_OF(plan->prism.sides);
}

static void
postpone(struct merges *merges, struct queue_entry own)
{
	merges->postponed.at[merges->postponed.count++] = own;
	node_queue_set(&merges->queue, own.node, INFINITY);
}

/* ---- the price ----------------------------------------------------------- */

/* Faces that the plan saves. */
static double
saved_by(const struct merge_plan *plan)
{
	return (double)plan->faces.count -
		PRISM_TRIANGLES_OF(plan->prism.sides);
}

/* Of what is planned, with what breaks; less than that while nobody has looked
   how much of it is seen. */
static double
price_with(const struct merges *merges, struct merge_known *known, double harm)
{
	const struct merge_plan *plan = &merges->plan;
	const struct removals *removals = merges->removals;
	double paid = merge_paid(plan, &merges->pricing);

	known->shape = merge_seen_share(plan, removals) * known->off;
	return (fmax(known->shape - paid, 0) + harm * removals->contact_cost) /
		(0.5 * saved_by(plan));
}

/* Of what is planned; INFINITY if it must not be. What is dearer than it seemed
   before all has been looked for is not looked at closer. */
static enum tcs_status
price_of(struct merges *merges, uint32_t number, double seemed, double *price,
	struct tcs_fault *fault)
{
	const struct merge_plan *plan = &merges->plan;
	struct merge_known *known = &merges->known.at[number];
	enum tcs_status status = TCS_OK;
	double harm = 0;
	bool fine = true;

	if (known->off < 0)
		status = merge_off(plan, &merges->pricing, merges->removals,
			&known->off, fault);
	if (status)
		return status;
	*price = price_with(merges, known, 0);
	if (*price > seemed)
		return TCS_OK;
	status = removals_look(merges->removals, fault);
	if (status)
		return status;
	*price = price_with(merges, known, 0);
	if (*price > seemed)
		return TCS_OK;
	status = merge_harm(
		plan, &merges->pricing, merges->removals, &harm, &fine, fault);
	*price = fine ? price_with(merges, known, harm) : INFINITY;
	return status;
}

/* ---- making them one ------------------------------------------------------ */

static enum tcs_status
merge(struct merges *merges, uint32_t number, struct tcs_fault *fault)
{
	struct merge_plan *plan = &merges->plan;
	uint32_t feature = merges->work->features.at[plan->faces.at[0]];

	node_queue_set(&merges->queue, number, INFINITY);
	if (array_grow(&merges->features, 1))
		return fault_memory(fault);
	merges->features.at[merges->features.count++] = feature;
	merges->pricing.paid.at[plan->host] = merges->known.at[number].shape;
	merges->joined += plan->parts.count - 1;
	return merge_build(&merges->builder, plan, merges->set, merges->work,
		merges->removals, fault);
}

enum tcs_status
merges_try(struct merges *merges, struct tcs_fault *fault)
{
	struct queue_entry first = *node_queue_first(&merges->queue);
	double price = INFINITY;
	bool fine = false;
	enum tcs_status status = merge_plan_make(&merges->plan, merges->work,
		merges->removals, &merges->groups, first.node,
		&merges->known.at[first.node], &fine, fault);

	if (!status && fine && saves_too_much(merges)) {
		postpone(merges, first);
		return TCS_OK;
	}
	if (!status && fine)
		status =
			price_of(merges, first.node, first.cost, &price, fault);
	if (status)
		return status;
	if (price <= first.cost)
		return merge(merges, first.node, fault);
	node_queue_set(&merges->queue, first.node, price);
	return TCS_OK;
}

size_t
merges_features(struct merges *merges, const uint32_t **features)
{
	merges->features.count =
		number_sort_once(merges->features.at, merges->features.count);
	*features = merges->features.at;
	return merges->features.count;
}

void
merges_end(struct merges *merges)
{
	merge_groups_release(&merges->groups);
	array_release(&merges->known);
	node_queue_release(&merges->queue);
	merge_plan_release(&merges->plan);
	merge_pricing_release(&merges->pricing);
	merge_builder_release(&merges->builder);
	array_release(&merges->postponed);
}

void
merges_release(struct merges *merges)
{
	merges_end(merges);
	array_release(&merges->features);
}
