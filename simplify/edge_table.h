/*
 * The edges of a welded mesh and who uses them.
 */
#ifndef TESSERA_EDGE_TABLE_H
#define TESSERA_EDGE_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "tcs.h"

/* One triangle's use of an edge. */
struct edge_use {
	uint32_t low, high; /* points, low < high */
	uint32_t triangle;
	uint32_t forward; /* 1: from low to high as the triangle winds */
};

/* Uses of the same edge stand together, edges by low and high, the uses of one
   by triangle. All zero is empty. */
struct edge_table {
	TCS_ARRAY(struct edge_use) uses;
};

/* Two corners of the triangle are the same point. */
static inline bool
is_collapsed(const struct tcs_triangle *triangle)
{
	return triangle->corner[0] == triangle->corner[1] ||
		triangle->corner[1] == triangle->corner[2] ||
		triangle->corner[2] == triangle->corner[0];
}

/*
 * Collect and sort; collapsed triangles have no edges. Corners are below
 * `point_count`. What the table held before is forgotten. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status edge_table_build(struct edge_table *table,
	const struct tcs_triangle *triangles, size_t count, size_t point_count,
	struct tcs_fault *fault) TCS_CHECKED;
void edge_table_release(struct edge_table *table);

/* How many uses, from `first` on, are of the same edge. */
static inline size_t
edge_table_run(const struct edge_table *table, size_t first)
{
	const struct edge_use *use = &table->uses.at[first];
	size_t end = first + 1;

	while (end < table->uses.count && table->uses.at[end].low == use->low &&
		table->uses.at[end].high == use->high)
		end++;
	return end - first;
}

#endif
