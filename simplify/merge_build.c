#include "merge_build.h"

#include "number_sort.h"

struct build {
	struct merge_builder *scratch;
	struct merge_plan *plan;
	struct collapses *work;
	struct removals *removals;
};

/* What they enclosed the prism does. */
static void
enclose(const struct build *build)
{
	const struct merge_plan *plan = build->plan;
	struct parts *parts = &build->removals->parts;
	uint32_t host = parts->at.at[plan->host].component;

	for (size_t i = 0; i < plan->parts.count; i++) {
		uint32_t own = parts->at.at[plan->parts.at[i]].component;

		if (own == host || parts->left.at[own] > 0)
			continue;
		parts->enclosed.at[host] += parts->enclosed.at[own];
		parts->enclosed.at[own] = 0;
	}
}

static enum tcs_status
join_parts(const struct build *build, struct tcs_fault *fault)
{
	const struct merge_plan *plan = build->plan;
	struct removals *removals = build->removals;
	struct part *host = &removals->parts.at.at[plan->host];
	enum tcs_status status = parts_join(&removals->parts, plan->parts.at,
		plan->parts.count, plan->host, fault);

	if (status)
		return status;
	host->rebuilt = true;
	host->depth = host->area > 0 ? 3 * plan->prism.volume / host->area : 0;
	for (unsigned i = 0; i < 2 * plan->prism.sides; i++)
		box_add_point(&host->box, plan->prism.corners[i]);
	enclose(build);
	return removals_join(
		removals, plan->parts.at, plan->parts.count, plan->host, fault);
}

/* The components nothing of which will be left but the prism are in it, unless
   there is but one. */
static enum tcs_status
cover_components(const struct build *build, struct tcs_fault *fault)
{
	const struct merge_plan *plan = build->plan;
	const struct parts *parts = &build->removals->parts;
	enum tcs_status status = TCS_OK;
	size_t count = plan->parts.count, kept = 0;
	uint32_t *at;

	if (array_grow(&build->scratch->components, count))
		return fault_memory(fault);
	at = build->scratch->components.at;
	for (size_t i = 0; i < count; i++)
		at[i] = parts->at.at[plan->parts.at[i]].component;
	number_sort(at, count);
	for (size_t i = 0, end; i < count; i = end) {
		uint32_t own = at[i];

		for (end = i; end < count && at[end] == own;)
			end++;
		if (parts->left.at[own] == end - i)
			at[kept++] = own;
	}
	for (size_t i = 0; !status && kept > 1 && i < kept; i++)
		status = cover_watch_put(build->work, at[i], fault);
	return status;
}

/* Put the prism there, which covers what it is made of. */
static enum tcs_status
put_prism(const struct build *build, struct tcs_fault *fault)
{
	struct refill refill = merge_plan_refill(build->plan);
	struct collapses *work = build->work;
	enum tcs_status status = cover_watch_open(work, build->removals->list,
		refill.faces, refill.face_count, fault);

	if (!status)
		status = cover_components(build, fault);
	if (!status)
		status = collapses_refill(work, &refill, fault);
	return status
		? status
		: cover_watch_close(work, refill.numbers, refill.count, fault);
}

enum tcs_status
merge_build(struct merge_builder *builder, struct merge_plan *plan,
	struct component_set *set, struct collapses *work,
	struct removals *removals, struct tcs_fault *fault)
{
	const struct build build = {builder, plan, work, removals};
	uint32_t component =
		set->numbers
			.at[work->sheets->face_triangles.at[plan->numbers[0]]];
	enum tcs_status status;

	for (unsigned i = 0; i < 2 * plan->prism.sides; i++)
		component_set_enlarge(set, component, plan->prism.corners[i]);
	merge_plan_choose_models(plan, work, &removals->parts);
	status = put_prism(&build, fault);
	return status ? status : join_parts(&build, fault);
}

void
merge_builder_release(struct merge_builder *builder)
{
	array_release(&builder->components);
}
