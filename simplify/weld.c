#include "weld.h"

#include <stdlib.h>
#include <string.h>

/* A slot names the first point that came to it, plus one; 0 is free. */
struct weld_slots {
	uint32_t *at;
	size_t mask;
};

static uint64_t
mixed(uint64_t bits, double value)
{
	uint64_t more;

	value += 0.0; /* -0 becomes 0 */
	memcpy(&more, &value, sizeof more);
	bits = (bits ^ more) * 0x9e3779b97f4a7c15u;
	return bits ^ bits >> 29;
}

static size_t
hash_point(struct tcs_point point)
{
	uint64_t bits =
		mixed(mixed(mixed(0x2545f491u, point.x), point.y), point.z);

	bits *= 0xbf58476d1ce4e5b9u;
	return (size_t)(bits ^ bits >> 32);
}

static int
is_same(struct tcs_point a, struct tcs_point b)
{
	return a.x == b.x && a.y == b.y && a.z == b.z;
}

/* The first point equal to points[i], which may be itself. */
static size_t
first_equal(struct weld_slots *slots, const struct tcs_point *points, size_t i)
{
	size_t at = hash_point(points[i]) & slots->mask;

	while (slots->at[at]) {
		size_t other = slots->at[at] - 1;

		if (is_same(points[other], points[i]))
			return other;
		at = (at + 1) & slots->mask;
	}
	slots->at[at] = (uint32_t)(i + 1);
	return i;
}

enum tcs_status
weld_points(const struct tcs_point *points, size_t count, uint32_t *numbers,
	size_t *distinct, struct tcs_fault *fault)
{
	struct weld_slots slots;
	size_t room = 16;

	while (room < 2 * count)
		room *= 2;
	slots.mask = room - 1;
	slots.at = calloc(room, sizeof *slots.at);
	if (!slots.at)
		return fault_memory(fault);
	*distinct = 0;
	for (size_t i = 0; i < count; i++) {
		size_t first = first_equal(&slots, points, i);

		numbers[i] =
			first < i ? numbers[first] : (uint32_t)(*distinct)++;
	}
	free(slots.at);
	return TCS_OK;
}
