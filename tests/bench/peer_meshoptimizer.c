#include "peer.h"

#include <float.h>
#include <stdlib.h>

#include <meshoptimizer.h>

/*
 * It takes equal positions for one vertex. So that components that touch stay
 * apart, each is shifted as a whole by a step of its own, too small to matter
 * to the cost; vertices keep their positions, as it chooses among them.
 */
static void
place_points(const struct peer_mesh *in, float *positions)
{
	double size = 1;

	for (size_t i = 0; i < in->point_count; i++)
		if (in->points[i].x - in->points[0].x > size)
			size = in->points[i].x - in->points[0].x;
	for (size_t i = 0; i < in->point_count; i++) {
		double shift = size * 0x1p-20 * (in->components[i] % 4096);

		positions[3 * i] = (float)(in->points[i].x + shift);
		positions[3 * i + 1] = (float)in->points[i].y;
		positions[3 * i + 2] = (float)in->points[i].z;
	}
}

int
peer_meshoptimizer(
	const struct peer_mesh *in, size_t target, struct peer_mesh *out)
{
	size_t count = 3 * in->triangle_count, left = 0;
	float *positions = calloc(3 * in->point_count, sizeof *positions);
	unsigned *result = calloc(count, sizeof *result);
	int status = positions && result ? 0 : -1;

	if (!status) {
		place_points(in, positions);
		left = meshopt_simplify(result, in->triangles[0].corner, count,
			positions, in->point_count, 3 * sizeof *positions,
			3 * target, FLT_MAX, 0, NULL);
		for (size_t i = 0; i < left; i += 3)
			peer_put(in,
				&(struct tcs_triangle){{result[i],
					result[i + 1], result[i + 2]}},
				out);
		for (size_t i = 0; i < in->point_count; i++)
			out->points[i] = in->points[i];
		out->point_count = in->point_count;
	}
	free(positions);
	free(result);
	return status;
}
