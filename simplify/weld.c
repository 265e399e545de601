#include "weld.h"

#include <string.h>

enum { LEAST_SLOTS = 64 };

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
hash_point(const struct tcs_point *point)
{
	uint64_t bits =
		mixed(mixed(mixed(0x2545f491u, point->x), point->y), point->z);

	bits *= 0xbf58476d1ce4e5b9u;
	return (size_t)(bits ^ bits >> 32);
}

static int
is_same(const struct tcs_point *a, const struct tcs_point *b)
{
	return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* The slot of the point, or the free one where it belongs. */
static uint32_t *
slot_of(struct weld *weld, const struct tcs_point *points,
	const struct tcs_point *point)
{
	size_t mask = weld->slots.count - 1, at = hash_point(point) & mask;
	uint32_t *slots = weld->slots.at;

	while (slots[at] && !is_same(&points[slots[at] - 1], point))
		at = (at + 1) & mask;
	return &slots[at];
}

/* Twice as many slots as there are points, at least. */
static enum tcs_status
make_room(struct weld *weld, const struct tcs_point *points, size_t count,
	struct tcs_fault *fault)
{
	size_t room = weld->slots.count ? 2 * weld->slots.count : LEAST_SLOTS;

	if (array_grow(&weld->slots, room - weld->slots.count))
		return fault_memory(fault);
	weld->slots.count = room;
	memset(weld->slots.at, 0, room * sizeof *weld->slots.at);
	for (size_t i = 0; i < count; i++)
		*slot_of(weld, points, &points[i]) = (uint32_t)(i + 1);
	return TCS_OK;
}

enum tcs_status
weld_find(struct weld *weld, const struct tcs_point *points, size_t count,
	const struct tcs_point *point, uint32_t *number,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint32_t *slot;

	if (2 * count >= weld->slots.count)
		status = make_room(weld, points, count, fault);
	if (status)
		return status;
	slot = slot_of(weld, points, point);
	if (!*slot)
		*slot = (uint32_t)(count + 1);
	*number = *slot - 1;
	return TCS_OK;
}

void
weld_clear(struct weld *weld)
{
	array_trim(&weld->slots);
}

void
weld_release(struct weld *weld)
{
	array_release(&weld->slots);
}
