#include "peer.h"

#include <math.h>
#include <stdlib.h>

/* The cell of a point, and its number. */
struct cell_use {
	int64_t at[3];
	uint32_t point;
};

/* A triangle of cells, and the component that it is of. */
struct cell_triangle {
	uint32_t corner[3];
	uint32_t component;
};

struct clusters {
	struct cell_use *uses;
	uint32_t *numbers; /* per point */
	struct cell_triangle *sorted;
	size_t count;
};

static int
by_cell(const void *left, const void *right)
{
	const struct cell_use *a = left, *b = right;

	for (int i = 0; i < 3; i++)
		if (a->at[i] != b->at[i])
			return a->at[i] < b->at[i] ? -1 : 1;
	return (a->point > b->point) - (a->point < b->point);
}

static void
number_cells(const struct peer_mesh *in, double size, struct clusters *clusters)
{
	clusters->count = 0;
	for (size_t i = 0; i < in->point_count; i++)
		clusters->uses[i] = (struct cell_use){
			{(int64_t)floor(in->points[i].x / size),
				(int64_t)floor(in->points[i].y / size),
				(int64_t)floor(in->points[i].z / size)},
			(uint32_t)i};
	qsort(clusters->uses, in->point_count, sizeof *clusters->uses, by_cell);
	for (size_t i = 0; i < in->point_count; i++) {
		const struct cell_use *use = &clusters->uses[i];

		if (!i || use->at[0] != use[-1].at[0] ||
			use->at[1] != use[-1].at[1] ||
			use->at[2] != use[-1].at[2])
			clusters->count++;
		clusters->numbers[use->point] = (uint32_t)clusters->count - 1;
	}
}

static int
by_corners(const void *left, const void *right)
{
	const struct cell_triangle *a = left, *b = right;

	for (int i = 0; i < 3; i++)
		if (a->corner[i] != b->corner[i])
			return a->corner[i] < b->corner[i] ? -1 : 1;
	return (a->component > b->component) - (a->component < b->component);
}

/* Triangles with three different cells, each once for a component. */
static void
collect(const struct peer_mesh *in, const struct clusters *clusters,
	struct peer_mesh *out)
{
	struct cell_triangle *sorted = clusters->sorted;
	size_t count = 0;

	for (size_t i = 0; i < in->triangle_count; i++) {
		const uint32_t *corner = in->triangles[i].corner;
		struct tcs_triangle t;
		int first = 0;

		for (int k = 0; k < 3; k++) {
			t.corner[k] = clusters->numbers[corner[k]];
			if (t.corner[k] < t.corner[first])
				first = k;
		}
		if (t.corner[0] == t.corner[1] || t.corner[1] == t.corner[2] ||
			t.corner[2] == t.corner[0])
			continue;
		sorted[count++] = (struct cell_triangle){
			{t.corner[first], t.corner[(first + 1) % 3],
				t.corner[(first + 2) % 3]},
			in->components[corner[0]]};
	}
	qsort(sorted, count, sizeof *sorted, by_corners);
	out->triangle_count = 0;
	for (size_t i = 0; i < count; i++) {
		const uint32_t *c = sorted[i].corner;

		if (i && !by_corners(&sorted[i - 1], &sorted[i]))
			continue;
		out->components[out->triangle_count] = sorted[i].component;
		out->triangles[out->triangle_count++] =
			(struct tcs_triangle){{c[0], c[1], c[2]}};
	}
}

static void
place_means(const struct peer_mesh *in, const struct clusters *clusters,
	struct peer_mesh *out)
{
	uint32_t end = 0;

	for (uint32_t i = 0; i < clusters->count; i++) {
		struct tcs_point sum = {0, 0, 0};
		uint32_t first = end;

		for (; end < in->point_count; end++) {
			uint32_t point = clusters->uses[end].point;

			if (clusters->numbers[point] != i)
				break;
			sum.x += in->points[point].x;
			sum.y += in->points[point].y;
			sum.z += in->points[point].z;
		}
		out->points[i] = (struct tcs_point){sum.x / (end - first),
			sum.y / (end - first), sum.z / (end - first)};
	}
	out->point_count = clusters->count;
}

int
peer_clustering(
	const struct peer_mesh *in, size_t target, struct peer_mesh *out)
{
	struct clusters clusters = {
		calloc(in->point_count, sizeof *clusters.uses),
		calloc(in->point_count, sizeof *clusters.numbers),
		calloc(in->triangle_count, sizeof *clusters.sorted), 0};
	double low = 1e-4, high = 1e4; /* metres */
	int status =
		clusters.uses && clusters.numbers && clusters.sorted ? 0 : -1;

	for (int i = 0; !status && i < 40; i++) {
		double size = sqrt(low * high);

		number_cells(in, size, &clusters);
		collect(in, &clusters, out);
		if (out->triangle_count > target)
			low = size;
		else
			high = size;
	}
	if (!status) {
		number_cells(in, high, &clusters);
		collect(in, &clusters, out);
		place_means(in, &clusters, out);
	}
	free(clusters.uses);
	free(clusters.numbers);
	free(clusters.sorted);
	return status;
}
