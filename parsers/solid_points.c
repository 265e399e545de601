#include "solid_points.h"

#include <string.h>

static uint64_t
mixed(uint64_t hash, double value)
{
	uint64_t bits;

	value += 0.0; /* -0 becomes 0 */
	memcpy(&bits, &value, sizeof bits);
	hash = (hash ^ bits) * 0x9e3779b97f4a7c15;
	return hash ^ (hash >> 29);
}

static size_t
point_hash(struct tcs_point point)
{
	uint64_t hash = mixed(mixed(mixed(0, point.x), point.y), point.z);

	return (size_t)(hash ^ (hash >> 32));
}

static bool
same(struct tcs_point a, struct tcs_point b)
{
	return a.x == b.x && a.y == b.y && a.z == b.z;
}

static enum tcs_status
tables_make(struct solid_points *all, size_t count, struct tcs_fault *fault)
{
	size_t size = 16;

	while (size < 2 * count)
		size *= 2;
	array_clear(&all->slots);
	array_clear(&all->numbers);
	if (count >= UINT32_MAX / 4 || array_grow(&all->slots, size) ||
		array_grow(&all->numbers, count + 1))
		return fault_memory(fault);
	all->slots.count = size;
	memset(all->slots.at, 0, size * sizeof *all->slots.at);
	return TCS_OK;
}

enum tcs_status
solid_points_number(struct solid_points *all, const struct tcs_point *points,
	size_t count, struct tcs_fault *fault)
{
	enum tcs_status status = tables_make(all, count, fault);
	size_t mask = all->slots.count - 1;

	if (status)
		return status;
	all->distinct = 0;
	for (size_t i = 0; i < count; i++) {
		size_t slot = point_hash(points[i]) & mask;
		uint32_t found;

		while ((found = all->slots.at[slot]) &&
			!same(points[found - 1], points[i]))
			slot = (slot + 1) & mask;
		if (!found)
			all->slots.at[slot] = (uint32_t)i + 1;
		all->numbers.at[i] = found ? all->numbers.at[found - 1]
					   : (uint32_t)all->distinct++;
	}
	all->numbers.count = count;
	return TCS_OK;
}

void
solid_points_release(struct solid_points *all)
{
	array_release(&all->slots);
	array_release(&all->numbers);
}
