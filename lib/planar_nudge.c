#include "planar.h"

/* The unit vector to the right of an edge, where the outside is. */
static struct planar_point
edge_right(struct planar_point from, struct planar_point to)
{
	double x = to.x - from.x, y = to.y - from.y;
	double length = sqrt(x * x + y * y);

	return (struct planar_point){y / length, -x / length};
}

/* At a vertex where the ring turns back, there is no side to move to. */
static struct planar_point
nudged(struct planar_point from, struct planar_point at, struct planar_point to,
	double by)
{
	struct planar_point a = edge_right(from, at), b = edge_right(at, to);
	double x = a.x + b.x, y = a.y + b.y;
	double length = sqrt(x * x + y * y);

	if (!(length > 1e-6))
		return at;
	return (struct planar_point){
		at.x + by * x / length, at.y + by * y / length};
}

enum tcs_status
planar_nudge(const struct planar *polygon, double by, struct planar_points *out,
	struct tcs_fault *fault)
{
	const struct planar_point *points = polygon->points.at;

	out->count = 0;
	if (planar_room(out, polygon->points.count))
		return fault_memory(fault);
	out->count = polygon->points.count;
	for (size_t i = 0; i < polygon->kept.count; i++) {
		uint32_t vertex = polygon->kept.at[i];

		out->at[vertex] = nudged(points[polygon->previous.at[vertex]],
			points[vertex], points[polygon->next.at[vertex]], by);
	}
	return TCS_OK;
}
