#include "paint_index.h"

#include <string.h>

/* Count, then place. */
enum tcs_status
paint_index_build(struct paint_index *index, const struct tcs_object *object,
	struct tcs_fault *fault)
{
	size_t polygons = object->polygons.count;
	uint32_t *first;

	array_clear(&index->paints);
	array_clear(&index->first);
	if (array_grow(&index->paints, object->paints.count) ||
		array_grow(&index->first, polygons + 2))
		return fault_memory(fault);
	index->paints.count = object->paints.count;
	index->first.count = polygons + 1;
	first = index->first.at;
	memset(first, 0, (polygons + 2) * sizeof *first);
	for (size_t i = 0; i < object->paints.count; i++)
		first[object->paints.at[i].polygon + 2]++;
	for (size_t i = 0; i < polygons; i++)
		first[i + 2] += first[i + 1];
	for (size_t i = 0; i < object->paints.count; i++)
		index->paints.at[first[object->paints.at[i].polygon + 1]++] =
			(uint32_t)i;
	return TCS_OK;
}

void
paint_index_release(struct paint_index *index)
{
	array_release(&index->paints);
	array_release(&index->first);
}
