/*
 * Attributes in the order of their features.
 */
#include <string.h>

#include "citygml_build.h"

/* Counting keeps the order within a feature. */
enum tcs_status
attributes_sort(struct builder *builder, struct tcs_object *tree,
	struct tcs_fault *fault)
{
	size_t features = tree->features.count;
	size_t count = tree->attributes.count;
	struct tcs_attribute *from = tree->attributes.at;
	uint32_t *starts, *places;
	bool sorted = !count || from[count - 1].feature != TCS_NONE;

	for (size_t i = 1; i < count; i++)
		sorted &= from[i - 1].feature <= from[i].feature;
	if (sorted)
		return TCS_OK;
	array_clear(&builder->order);
	array_clear(&builder->attributes);
	if (array_grow(&builder->order, features + 1 + count) ||
		array_grow(&builder->attributes, count))
		return fault_memory(fault);
	starts = builder->order.at;
	places = starts + features + 1;
	memset(starts, 0, (features + 1) * sizeof *starts);
	for (size_t i = 0; i < count; i++)
		if (from[i].feature != TCS_NONE)
			starts[from[i].feature + 1]++;
	for (size_t i = 0; i < features; i++)
		starts[i + 1] += starts[i];
	tree->attributes.count = starts[features];
	for (size_t i = 0; i < count; i++)
		if (from[i].feature != TCS_NONE)
			places[i] = starts[from[i].feature]++;
	for (size_t i = 0; i < count; i++) {
		struct tcs_attribute *to;

		if (from[i].feature == TCS_NONE)
			continue;
		to = &builder->attributes.at[places[i]];
		*to = from[i];
		if (to->parent != TCS_NONE)
			to->parent = places[to->parent];
	}
	memcpy(from, builder->attributes.at,
		tree->attributes.count * sizeof *from);
	return TCS_OK;
}
