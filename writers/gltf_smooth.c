#include "gltf_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Corners at one point beyond which only their common average is tried. */
#define CROWD 64

struct corner {
	float at[3];
	uint32_t feature;
	uint32_t vertex;
};

static int
compare_places(const struct corner *a, const struct corner *b)
{
	if (a->feature != b->feature)
		return a->feature < b->feature ? -1 : 1;
	for (int k = 0; k < 3; k++)
		if (a->at[k] < b->at[k] || a->at[k] > b->at[k])
			return a->at[k] < b->at[k] ? -1 : 1;
	return 0;
}

static int
compare_corners(const void *left, const void *right)
{
	const struct corner *a = left, *b = right;
	int order = compare_places(a, b);

	if (order)
		return order;
	return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static double
dot_normals(const float *a, const float *b)
{
	return (double)a[0] * b[0] + (double)a[1] * b[1] + (double)a[2] * b[2];
}

static void
average(const float *normals, const struct corner *group, size_t count,
	const float *own, double crease_cosine, float *out)
{
	double sum[3] = {0, 0, 0}, length;

	for (size_t i = 0; i < count; i++) {
		const float *n = normals + 3 * (size_t)group[i].vertex;

		if (dot_normals(own, n) < crease_cosine)
			continue;
		for (int k = 0; k < 3; k++)
			sum[k] += n[k];
	}
	length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
	for (int k = 0; k < 3; k++)
		out[k] = length > 1e-3 ? (float)(sum[k] / length) : own[k];
}

static void
smooth_group(const float *normals, const struct corner *group, size_t count,
	double crease_cosine, float *out)
{
	float middle[3] = {0, 0, 0};

	if (count > CROWD)
		average(normals, group, count,
			normals + 3 * (size_t)group->vertex, -1, middle);
	for (size_t i = 0; i < count; i++) {
		const float *own = normals + 3 * (size_t)group[i].vertex;
		float *to = out + 3 * (size_t)group[i].vertex;

		if (count <= CROWD)
			average(normals, group, count, own, crease_cosine, to);
		else if (dot_normals(own, middle) >= crease_cosine)
			memcpy(to, middle, sizeof middle);
		else
			memcpy(to, own, sizeof middle);
	}
}

enum tcs_status
mesh_smooth(struct mesh *mesh, double crease_cosine, struct tcs_fault *fault)
{
	size_t count = mesh->features.count, end;
	struct corner *corners = calloc(count + 1, sizeof *corners);
	float *out = calloc(3 * count + 1, sizeof *out);
	enum tcs_status status = TCS_OK;

	if (!corners || !out) {
		status = fault_memory(fault);
		goto done;
	}
	for (size_t i = 0; i < count; i++) {
		memcpy(corners[i].at, mesh->positions.at + 3 * i,
			sizeof corners[i].at);
		corners[i].feature = mesh->features.at[i];
		corners[i].vertex = (uint32_t)i;
	}
	qsort(corners, count, sizeof *corners, compare_corners);
	for (size_t first = 0; first < count; first = end) {
		for (end = first + 1; end < count; end++)
			if (compare_places(corners + first, corners + end))
				break;
		smooth_group(mesh->normals.at, corners + first, end - first,
			crease_cosine, out);
	}
	if (count)
		memcpy(mesh->normals.at, out, 3 * count * sizeof *out);
done:
	free(corners);
	free(out);
	return status;
}
