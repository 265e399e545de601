/*
 * Paints: from what themes name to the polygons they colour.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_build.h"

static enum tcs_status
paint_target(struct builder *builder, const struct raw_object *raw,
	const struct raw_target *target, tcs_text theme, uint32_t material,
	bool back, struct tcs_fault *fault)
{
	for (uint32_t i = target->first_member; i < target->member_end; i++) {
		uint32_t polygon = raw->members.at[i].polygon;

		if (polygon == TCS_NONE)
			continue;
		if (array_grow(&builder->paints, 1))
			return fault_memory(fault);
		builder->paints.at[builder->paints.count++] =
			(struct build_paint){polygon, theme, material, back};
	}
	return TCS_OK;
}

static enum tcs_status
paints_local(struct builder *builder, struct raw_object *raw,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < raw->paints.count; i++) {
		const struct raw_paint *paint = &raw->paints.at[i];
		const char *id = object_text(&raw->tree, paint->target);
		const struct raw_target *target =
			index_find(&builder->links.targets, raw, id);

		if (paint->material == TCS_NONE)
			continue;
		if (target)
			status =
				paint_target(builder, raw, target, paint->theme,
					paint->material, paint->back, fault);
		else if (report)
			status = report_item(report, REPORT_SKIPPED, "material",
				"its target is not in the feature", id,
				TCS_NOWHERE, fault);
	}
	return status;
}

static int
compare_global(const void *key, const void *row)
{
	return strcmp(key, ((const struct global_paint *)row)->target);
}

/* All global paints of one target stand together; any of them is found. */
static const struct global_paint *
global_first(const struct build_plan *plan, const char *id)
{
	const struct global_paint *found = plan->paint_count
		? bsearch(id, plan->paints, plan->paint_count,
			  sizeof *plan->paints, compare_global)
		: NULL;

	while (found && found > plan->paints && !strcmp(found[-1].target, id))
		found--;
	return found;
}

static enum tcs_status
paints_global(struct builder *builder, const struct build_plan *plan,
	struct raw_object *raw, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	const char *last = NULL;
	tcs_text theme = 0;

	if (!plan->paint_count)
		return TCS_OK;
	for (size_t i = 0; i < raw->targets.count; i++) {
		const struct raw_target *target = &raw->targets.at[i];
		const struct global_paint *paint =
			global_first(plan, object_text(&raw->tree, target->id));
		const char *id = paint ? paint->target : NULL;

		for (; paint && paint < plan->paints + plan->paint_count &&
			!strcmp(paint->target, id);
			paint++) {
			if (!last || strcmp(last, paint->theme))
				status = text_append(&raw->tree, paint->theme,
					strlen(paint->theme), &theme, fault);
			last = paint->theme;
			if (!status)
				status = paint_target(builder, raw, target,
					theme, paint->material, paint->back,
					fault);
			if (status)
				return status;
		}
	}
	return TCS_OK;
}

static int
compare_paints(const void *a, const void *b)
{
	const struct build_paint *one = a, *two = b;

	if (one->polygon != two->polygon)
		return one->polygon < two->polygon ? -1 : 1;
	if (one->theme != two->theme)
		return one->theme < two->theme ? -1 : 1;
	return (int)one->back - (int)two->back;
}

enum tcs_status
paints_collect(struct builder *builder, const struct build_plan *plan,
	struct raw_object *raw, struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status;

	array_clear(&builder->paints);
	status = paints_local(builder, raw, report, fault);
	if (!status)
		status = paints_global(builder, plan, raw, fault);
	if (!status && builder->paints.count)
		qsort(builder->paints.at, builder->paints.count,
			sizeof *builder->paints.at, compare_paints);
	return status;
}

enum tcs_status
paints_write(const struct builder *builder, const struct raw_object *raw,
	struct tcs_object *out, uint32_t raw_polygon, uint32_t polygon,
	struct tcs_fault *fault)
{
	size_t low = 0, high = builder->paints.count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (builder->paints.at[middle].polygon < raw_polygon)
			low = middle + 1;
		else
			high = middle;
	}
	for (; low < builder->paints.count &&
		builder->paints.at[low].polygon == raw_polygon;
		low++) {
		const struct build_paint *paint = &builder->paints.at[low];

		tcs_text theme;
		enum tcs_status status = text_carry(
			out, &raw->tree, paint->theme, &theme, fault);

		if (status)
			return status;
		if (array_grow(&out->paints, 1))
			return fault_memory(fault);
		out->paints.at[out->paints.count++] = (struct tcs_paint){
			.polygon = polygon,
			.theme = theme,
			.material = paint->material,
			.image = TCS_NONE,
			.first_texcoord = TCS_NONE,
			.flags = paint->back ? TCS_PAINT_BACK : 0,
		};
	}
	return TCS_OK;
}
