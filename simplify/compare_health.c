#include "compare_health.h"

#include <math.h>
#include <stdlib.h>

#include "split_work.h"
#include "vector.h"

#define THINNEST 1e-6 /* metres */

enum { TRIANGLES_AT_ONCE = 1024 };

static void
judge_edges(const struct edge_table *edges, struct mesh_health *health)
{
	size_t run;

	for (size_t i = 0; i < edges->uses.count; i += run) {
		const struct edge_use *use = &edges->uses.at[i];

		run = edge_table_run(edges, i);
		health->open += run == 1;
		health->non_manifold += run > 2;
		health->misaligned +=
			run == 2 && use[0].forward == use[1].forward;
	}
}

static bool
is_thin(const struct triangle_shape *shape)
{
	double longest = 0;

	for (int i = 0; i < 3; i++)
		longest = fmax(longest,
			vector_length(vector_difference(
				shape->corner[(i + 1) % 3], shape->corner[i])));
	return 2 * triangle_area(shape) < THINNEST * longest ||
		longest < THINNEST;
}

static int
by_corners(const void *left, const void *right)
{
	const struct tcs_triangle *a = left, *b = right;

	for (int i = 0; i < 3; i++)
		if (a->corner[i] != b->corner[i])
			return a->corner[i] < b->corner[i] ? -1 : 1;
	return 0;
}

static void
swap_corners(struct tcs_triangle *t, int a, int b)
{
	uint32_t corner = t->corner[a];

	if (corner <= t->corner[b])
		return;
	t->corner[a] = t->corner[b];
	t->corner[b] = corner;
}

static enum tcs_status
count_duplicates(const struct component_set *set, struct mesh_health *health,
	struct tcs_fault *fault)
{
	size_t count = set->triangles.count;
	struct tcs_triangle *sorted = calloc(count + 1, sizeof *sorted);

	if (!sorted)
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		sorted[i] = set->triangles.at[i];
		swap_corners(&sorted[i], 0, 1);
		swap_corners(&sorted[i], 1, 2);
		swap_corners(&sorted[i], 0, 1);
	}
	qsort(sorted, count, sizeof *sorted, by_corners);
	for (size_t i = 1; i < count; i++)
		health->duplicate +=
			by_corners(&sorted[i - 1], &sorted[i]) == 0;
	free(sorted);
	return TCS_OK;
}

enum tcs_status
mesh_health_measure(const struct component_set *set, struct mesh_health *health,
	struct tcs_fault *fault)
{
	*health = (struct mesh_health){0};
	judge_edges(&set->edges, health);
	for (size_t i = 0; i < set->triangles.count; i++) {
		struct triangle_shape shape = component_set_shape(set, i);

		health->degenerate += is_thin(&shape);
	}
	return count_duplicates(set, health, fault);
}

static bool
is_flipped(const struct compare_side *before, uint32_t root,
	const struct triangle_shape *shape, double eps)
{
	struct tcs_point normal = triangle_normal(shape);
	struct tcs_point centre = vector_scaled(
		vector_sum(shape->corner[0],
			vector_sum(shape->corner[1], shape->corner[2])),
		1.0 / 3);
	struct triangle_shape nearest;
	struct tree_hit any;

	if (is_thin(shape))
		return false;
	any = triangle_tree_nearest(&before->set.tree, root, centre, INFINITY);
	nearest = component_set_shape(&before->set, any.item);
	return vector_dot(triangle_normal(&nearest), normal) <= 0 &&
		!isfinite(triangle_tree_nearest_facing(&before->set.tree, root,
			centre, normal, any.distance + eps)
				  .distance);
}

struct flip_count {
	const struct compare_side *before, *after;
	const struct compare_match *match;
	double eps;
	size_t *found; /* per piece of work */
};

static void
count_some_flipped(void *context, size_t piece, size_t first, size_t end)
{
	const struct flip_count *count = context;
	const struct component_set *after = &count->after->set;

	for (size_t i = first; i < end; i++) {
		struct triangle_shape shape = component_set_shape(after, i);
		uint32_t parent =
			count->match->pieces.at[count->match->numbers.at[i]]
				.parent;

		if (parent != TCS_NONE)
			count->found[piece] += is_flipped(count->before,
				count->before->set.components.at[parent].root,
				&shape, count->eps);
	}
}

enum tcs_status
count_flipped(const struct compare_side *before,
	const struct compare_side *after, const struct compare_match *match,
	double eps, size_t *flipped, struct tcs_fault *fault)
{
	size_t triangles = after->set.triangles.count;
	size_t pieces = split_pieces(triangles, TRIANGLES_AT_ONCE);
	struct flip_count count = {before, after, match, eps,
		calloc(pieces + 1, sizeof *count.found)};
	enum tcs_status status;

	*flipped = 0;
	if (!count.found)
		return fault_memory(fault);
	status = split_work(triangles, TRIANGLES_AT_ONCE, after->set.jobs,
		count_some_flipped, &count, fault);
	for (size_t i = 0; i < pieces; i++)
		*flipped += count.found[i];
	free(count.found);
	return status;
}
