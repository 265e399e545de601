#include <string.h>

#include "sweep.h"

static bool
before(const struct sweep_event *a, const struct sweep_event *b)
{
	if (a->x != b->x)
		return a->x < b->x;
	if (a->y != b->y)
		return a->y < b->y;
	return a->vertex < b->vertex;
}

static void
sort_few(struct sweep_event *events, size_t count)
{
	for (size_t i = 1; i < count; i++) {
		struct sweep_event event = events[i];
		size_t j = i;

		for (; j && before(&event, &events[j - 1]); j--)
			events[j] = events[j - 1];
		events[j] = event;
	}
}

static void
merge(const struct sweep_event *from, size_t middle, size_t count,
	struct sweep_event *to)
{
	size_t i = 0, j = middle;

	while (i < middle && j < count)
		*to++ = before(&from[j], &from[i]) ? from[j++] : from[i++];
	memcpy(to, from + i, (middle - i) * sizeof *to);
	memcpy(to + (middle - i), from + j, (count - j) * sizeof *to);
}

enum { FEW = 12 };

void
sweep_sort(struct sweep_event *events, size_t count, struct sweep_event *room)
{
	struct sweep_event *from = events, *to = room, *swap;

	for (size_t i = 0; i < count; i += FEW)
		sort_few(events + i, count - i < FEW ? count - i : FEW);
	for (size_t run = FEW; run < count; run *= 2) {
		for (size_t i = 0; i < count; i += 2 * run) {
			size_t left = count - i;

			merge(from + i, left < run ? left : run,
				left < 2 * run ? left : 2 * run, to + i);
		}
		swap = from;
		from = to;
		to = swap;
	}
	if (from != events)
		memcpy(events, from, count * sizeof *events);
}
