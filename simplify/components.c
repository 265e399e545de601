#include "components.h"

#include <stdbool.h>
#include <stdlib.h>

#include "forest.h"

/* A use of a point by a feature's triangle, or of an edge by a body's. */
struct use {
	uint32_t owner, triangle;
};

static int
by_owner(const void *left, const void *right)
{
	const struct use *a = left, *b = right;

	if (a->owner != b->owner)
		return a->owner < b->owner ? -1 : 1;
	return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

static void
sort_uses(struct use *uses, size_t count)
{
	bool sorted = true;

	for (size_t i = 1; i < count; i++)
		sorted &= uses[i].owner >= uses[i - 1].owner;
	if (!sorted)
		qsort(uses, count, sizeof *uses, by_owner);
}

/* The uses of one point: mostly all by the same feature. */
static void
join_uses(uint32_t *parents, struct use *uses, size_t count)
{
	sort_uses(uses, count);
	for (size_t i = 1; i < count; i++)
		if (uses[i].owner == uses[i - 1].owner)
			forest_join(parents, uses[i - 1].triangle,
				uses[i].triangle);
}

/* ends[point] is where the uses of the point end, once they are there. */
static void
join_corners(uint32_t *parents, struct use *uses, uint32_t *ends,
	const struct tcs_triangle *triangles, const uint32_t *features,
	size_t count, size_t point_count)
{
	uint32_t first = 0;

	for (size_t i = 0; i < 3 * count; i++)
		ends[triangles[i / 3].corner[i % 3] + 1]++;
	for (size_t p = 0; p < point_count; p++)
		ends[p + 1] += ends[p];
	for (size_t i = 0; i < 3 * count; i++)
		uses[ends[triangles[i / 3].corner[i % 3]]++] =
			(struct use){features[i / 3], (uint32_t)(i / 3)};
	for (size_t p = 0; p < point_count; p++) {
		join_uses(parents, uses + first, ends[p] - first);
		first = ends[p];
	}
}

/* What exactly two triangles of a body use, at an edge that others use, too. */
static void
join_bodies(uint32_t *parents, struct use *uses, size_t count)
{
	size_t run;

	sort_uses(uses, count);
	for (size_t i = 0; i < count; i += run) {
		for (run = 1;
			i + run < count && uses[i + run].owner == uses[i].owner;
			run++)
			;
		if (run == 2)
			forest_join(parents, uses[i].triangle,
				uses[i + 1].triangle);
	}
}

/* There is room for all uses. */
static void
join_edges(uint32_t *parents, struct use *uses, const uint32_t *bodies,
	const struct edge_table *table)
{
	size_t run;

	for (size_t i = 0; i < table->uses.count; i += run) {
		const struct edge_use *use = &table->uses.at[i];

		run = edge_table_run(table, i);
		if (run == 2)
			forest_join(parents, use[0].triangle, use[1].triangle);
		for (size_t k = 0; run > 2 && k < run; k++)
			uses[k] = (struct use){
				bodies[use[k].triangle], use[k].triangle};
		if (run > 2)
			join_bodies(parents, uses, run);
	}
}

enum tcs_status
components_find(const struct tcs_triangle *triangles, const uint32_t *features,
	const uint32_t *bodies, size_t count, size_t point_count,
	const struct edge_table *table, uint32_t *components,
	size_t *component_count, struct tcs_fault *fault)
{
	struct use *uses = calloc(3 * count + 1, sizeof *uses);
	uint32_t *ends = calloc(point_count + 1, sizeof *ends);
	uint32_t *parents = calloc(count + 1, sizeof *parents);

	*component_count = 0;
	if (!uses || !ends || !parents) {
		free(uses);
		free(ends);
		free(parents);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < count; i++)
		parents[i] = (uint32_t)i;
	join_corners(
		parents, uses, ends, triangles, features, count, point_count);
	join_edges(parents, uses, bodies, table);
	/* A root is the first of its triangles. */
	for (size_t i = 0; i < count; i++) {
		uint32_t root = forest_root(parents, (uint32_t)i);

		components[i] = root < i ? components[root]
					 : (uint32_t)(*component_count)++;
	}
	free(uses);
	free(ends);
	free(parents);
	return TCS_OK;
}
