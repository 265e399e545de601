#include "components.h"

#include <stdlib.h>

#include "forest.h"

/* A corner of a triangle: a feature's use of a point. */
struct corner_use {
	uint32_t feature, point, triangle;
};

static int
by_feature_and_point(const void *left, const void *right)
{
	const struct corner_use *a = left, *b = right;

	if (a->feature != b->feature)
		return a->feature < b->feature ? -1 : 1;
	if (a->point != b->point)
		return a->point < b->point ? -1 : 1;
	return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

static void
join_corners(uint32_t *parents, struct corner_use *uses,
	const struct tcs_triangle *triangles, const uint32_t *features,
	size_t count)
{
	for (size_t i = 0; i < 3 * count; i++)
		uses[i] = (struct corner_use){features[i / 3],
			triangles[i / 3].corner[i % 3], (uint32_t)(i / 3)};
	qsort(uses, 3 * count, sizeof *uses, by_feature_and_point);
	for (size_t i = 1; i < 3 * count; i++)
		if (uses[i].feature == uses[i - 1].feature &&
			uses[i].point == uses[i - 1].point)
			forest_join(parents, uses[i - 1].triangle,
				uses[i].triangle);
}

static void
join_edges(uint32_t *parents, const struct edge_table *table)
{
	size_t run;

	for (size_t i = 0; i < table->uses.count; i += run) {
		const struct edge_use *use = &table->uses.at[i];

		run = edge_table_run(table, i);
		if (run == 2)
			forest_join(parents, use[0].triangle, use[1].triangle);
	}
}

enum tcs_status
components_find(const struct tcs_triangle *triangles, const uint32_t *features,
	size_t count, const struct edge_table *table, uint32_t *components,
	size_t *component_count, struct tcs_fault *fault)
{
	struct corner_use *uses = calloc(3 * count + 1, sizeof *uses);
	uint32_t *parents = calloc(count + 1, sizeof *parents);

	*component_count = 0;
	if (!uses || !parents) {
		free(uses);
		free(parents);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < count; i++)
		parents[i] = (uint32_t)i;
	join_corners(parents, uses, triangles, features, count);
	join_edges(parents, table);
	/* A root is the first of its triangles. */
	for (size_t i = 0; i < count; i++) {
		uint32_t root = forest_root(parents, (uint32_t)i);

		components[i] = root < i ? components[root]
					 : (uint32_t)(*component_count)++;
	}
	free(uses);
	free(parents);
	return TCS_OK;
}
