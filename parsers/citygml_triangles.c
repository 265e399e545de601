/*
 * From the points of a polygon to triangles, in metres.
 */
#include <math.h>

#include "citygml_build.h"

#define METRES_PER_DEGREE 111320.0 /* along a meridian, roughly */

/* Metres per unit in x where y is this latitude. */
static double
degree_scale(double latitude)
{
	double scale = cos(latitude * (3.14159265358979323846 / 180));

	return METRES_PER_DEGREE * (scale > 1e-6 ? scale : 1e-6);
}

/* Triangles do not change under the scaling; which way a plane leans does. */
static enum tcs_status
points_scale(struct builder *builder, double scale, struct tcs_fault *fault)
{
	size_t count = builder->points.count;

	array_clear(&builder->scaled);
	if (array_grow(&builder->scaled, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		builder->scaled.at[i] = (struct tcs_point){
			builder->points.at[i].x * scale,
			builder->points.at[i].y * METRES_PER_DEGREE,
			builder->points.at[i].z,
		};
	return TCS_OK;
}

enum tcs_status
polygon_triangulate(struct builder *builder, const struct raw_polygon *polygon,
	struct triangulation *out, struct tcs_fault *fault)
{
	const struct tcs_point *points = builder->points.at;
	double scale = 0;
	enum tcs_status status = TCS_OK;

	if (polygon->shape != RAW_AREA) {
		*out = (struct triangulation){0};
		return TCS_OK;
	}
	if (polygon->degrees) {
		scale = degree_scale(points[0].y);
		status = points_scale(builder, scale, fault);
		points = builder->scaled.at;
	}
	if (!status)
		status = triangulate(builder->triangulator, points,
			builder->ring_sizes.at, builder->ring_sizes.count, out,
			fault);
	if (status || !out->extra_count)
		return status;
	if (array_grow(&builder->points, out->extra_count))
		return fault_memory(fault);
	for (size_t i = 0; i < out->extra_count; i++) {
		struct tcs_point point = out->extra[i];

		if (polygon->degrees) {
			point.x /= scale;
			point.y /= METRES_PER_DEGREE;
		}
		builder->points.at[builder->points.count++] = point;
	}
	return TCS_OK;
}
