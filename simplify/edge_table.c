#include "edge_table.h"

#include <stdlib.h>

enum { SHORT_RUN = 24 }; /* edges of one point that are sorted in place */

static uint32_t
next_of(uint32_t k)
{
	return k < 2 ? k + 1 : 0;
}

static struct edge_use
use_of(const struct tcs_triangle *triangles, size_t triangle, uint32_t k)
{
	uint32_t a = triangles[triangle].corner[k];
	uint32_t b = triangles[triangle].corner[next_of(k)];
	bool forward = a < b;

	return (struct edge_use){
		forward ? a : b, forward ? b : a, (uint32_t)triangle, forward};
}

static int
by_high(const void *left, const void *right)
{
	const struct edge_use *a = left, *b = right;

	if (a->high != b->high)
		return a->high < b->high ? -1 : 1;
	return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* A point has few edges as a rule. */
static void
sort_run(struct edge_use *uses, size_t count)
{
	if (count > SHORT_RUN) {
		qsort(uses, count, sizeof *uses, by_high);
		return;
	}
	for (size_t i = 1; i < count; i++) {
		struct edge_use use = uses[i];
		size_t place = i;

		while (place > 0 && by_high(&uses[place - 1], &use) > 0) {
			uses[place] = uses[place - 1];
			place--;
		}
		uses[place] = use;
	}
}

/* Put the uses where their low points belong, then sort those of each. */
static void
distribute(struct edge_table *table, const struct tcs_triangle *triangles,
	size_t count, size_t *starts, size_t point_count)
{
	size_t first = 0;

	for (size_t p = 0; p < point_count; p++)
		starts[p + 1] += starts[p];
	table->uses.count = starts[point_count];
	for (size_t i = 0; i < count; i++) {
		if (is_collapsed(&triangles[i]))
			continue;
		for (uint32_t k = 0; k < 3; k++) {
			struct edge_use use = use_of(triangles, i, k);

			table->uses.at[starts[use.low]++] = use;
		}
	}
	/* Every start has moved to the end of its run. */
	for (size_t p = 0; p < point_count; p++) {
		sort_run(table->uses.at + first, starts[p] - first);
		first = starts[p];
	}
}

enum tcs_status
edge_table_build(struct edge_table *table, const struct tcs_triangle *triangles,
	size_t count, size_t point_count, struct tcs_fault *fault)
{
	size_t *starts = calloc(point_count + 1, sizeof *starts);

	array_clear(&table->uses);
	if (!starts || array_grow(&table->uses, 3 * count)) {
		free(starts);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < count; i++) {
		if (is_collapsed(&triangles[i]))
			continue;
		for (uint32_t k = 0; k < 3; k++)
			starts[use_of(triangles, i, k).low + 1]++;
	}
	distribute(table, triangles, count, starts, point_count);
	free(starts);
	return TCS_OK;
}

void
edge_table_release(struct edge_table *table)
{
	array_release(&table->uses);
}
