#include "solid_weld.h"

#include <math.h>
#include <string.h>

void
solid_weld_release(struct solid_weld *weld)
{
	array_release(&weld->points);
	array_release(&weld->slots);
	array_release(&weld->next);
}

enum tcs_status
solid_weld_begin(struct solid_weld *weld, double tolerance, size_t count,
	struct tcs_fault *fault)
{
	size_t size = 64;

	while (size < count)
		size *= 2;
	array_clear(&weld->points);
	array_clear(&weld->next);
	array_clear(&weld->slots);
	if (array_grow(&weld->slots, size))
		return fault_memory(fault);
	weld->slots.count = size;
	memset(weld->slots.at, 0, size * sizeof *weld->slots.at);
	weld->tolerance = tolerance;
	return TCS_OK;
}

/* Points are sorted into cubes of several tolerances. */
static double
cube_of(const struct solid_weld *weld, double at)
{
	return floor(at / (8 * weld->tolerance));
}

static uint64_t
mixed(uint64_t hash, double cube)
{
	hash = (hash ^ (uint64_t)(int64_t)cube) * 0x9e3779b97f4a7c15;
	return hash ^ (hash >> 31);
}

static size_t
slot_of(const struct solid_weld *weld, double x, double y, double z)
{
	return (size_t)mixed(mixed(mixed(0, x), y), z) &
		(weld->slots.count - 1);
}

static void
slot_search(const struct solid_weld *weld, size_t slot, struct tcs_point point,
	double *best, uint32_t *number)
{
	uint32_t at = weld->slots.at[slot];

	for (; at; at = weld->next.at[at - 1]) {
		struct tcs_point off =
			point_minus(weld->points.at[at - 1], point);
		double distance = point_dot(off, off);

		if (distance < *best) {
			*best = distance;
			*number = at - 1;
		}
	}
}

/* In all cubes that the tolerance reaches. */
static uint32_t
nearest(const struct solid_weld *weld, struct tcs_point p)
{
	double t = weld->tolerance, best = t * t;
	double low[3] = {cube_of(weld, p.x - t), cube_of(weld, p.y - t),
		cube_of(weld, p.z - t)};
	double high[3] = {cube_of(weld, p.x + t), cube_of(weld, p.y + t),
		cube_of(weld, p.z + t)};
	uint32_t number = UINT32_MAX;

	for (double x = low[0]; x <= high[0]; x++)
		for (double y = low[1]; y <= high[1]; y++)
			for (double z = low[2]; z <= high[2]; z++)
				slot_search(weld, slot_of(weld, x, y, z), p,
					&best, &number);
	return number;
}

enum tcs_status
solid_weld_add(struct solid_weld *weld, struct tcs_point point,
	uint32_t *number, struct tcs_fault *fault)
{
	uint32_t *slot;

	*number = nearest(weld, point);
	if (*number != UINT32_MAX)
		return TCS_OK;
	if (weld->points.count >= UINT32_MAX / 4 ||
		array_grow(&weld->points, 1) || array_grow(&weld->next, 1))
		return fault_memory(fault);
	slot = &weld->slots.at[slot_of(weld, cube_of(weld, point.x),
		cube_of(weld, point.y), cube_of(weld, point.z))];
	*number = (uint32_t)weld->points.count;
	weld->points.at[weld->points.count++] = point;
	weld->next.at[weld->next.count++] = *slot;
	*slot = *number + 1;
	return TCS_OK;
}
