#include "solid.h"

#include <math.h>
#include <string.h>

void
solid_release(struct solid *solid)
{
	array_release(&solid->points);
	array_release(&solid->ring_ends);
	array_release(&solid->faces);
}

void
solid_clear(struct solid *solid)
{
	array_clear(&solid->points);
	array_clear(&solid->ring_ends);
	array_clear(&solid->faces);
}

const struct tcs_point *
solid_ring(const struct solid *solid, size_t ring, size_t *count)
{
	size_t first = ring ? solid->ring_ends.at[ring - 1] : 0;

	*count = solid->ring_ends.at[ring] - first;
	return *count ? solid->points.at + first : NULL;
}

enum tcs_status
solid_add_face(struct solid *solid, const struct tcs_point *points,
	const uint32_t *rings, size_t ring_count, uint32_t label,
	struct tcs_fault *fault)
{
	struct solid_face face = {
		.first_ring = (uint32_t)solid->ring_ends.count,
		.ring_count = (uint32_t)ring_count,
		.label = label,
		.face = SOLID_NO_FACE};
	size_t count = 0;

	for (size_t i = 0; i < ring_count; i++)
		count += rings[i];
	if (count > UINT32_MAX - solid->points.count ||
		array_grow(&solid->points, count) ||
		array_grow(&solid->ring_ends, ring_count) ||
		array_grow(&solid->faces, 1))
		return fault_memory(fault);
	if (count)
		memcpy(solid->points.at + solid->points.count, points,
			count * sizeof *points);
	for (size_t i = 0; i < ring_count; i++) {
		solid->points.count += rings[i];
		solid->ring_ends.at[solid->ring_ends.count++] =
			(uint32_t)solid->points.count;
	}
	solid->faces.at[solid->faces.count++] = face;
	return TCS_OK;
}
