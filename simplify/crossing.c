#include "crossing.h"

#include "vector.h"

/* A triangle that edges may pass through. */
struct target {
	const struct triangle_shape *shape;
	struct tcs_point normal; /* of length 1 */
};

/* Inside by more than the depth; the point lies in the plane. */
static bool
is_well_inside(const struct target *target, struct tcs_point point)
{
	for (int i = 0; i < 3; i++) {
		struct tcs_point from = target->shape->corner[i];
		struct tcs_point side = vector_difference(
			target->shape->corner[(i + 1) % 3], from);
		double inward = vector_dot(vector_cross(target->normal, side),
			vector_difference(point, from));

		if (inward <= 0 ||
			inward * inward <= CROSSING_DEPTH * CROSSING_DEPTH *
					vector_dot(side, side))
			return false;
	}
	return true;
}

/* Whether an edge of `by` passes through. */
static bool
is_pierced(const struct triangle_shape *shape, const struct triangle_shape *by)
{
	struct target target = {shape, triangle_normal(shape)};
	double length = vector_length(target.normal), height[3];

	if (!(length > 0))
		return false;
	target.normal = vector_scaled(target.normal, 1 / length);
	for (int i = 0; i < 3; i++)
		height[i] = vector_dot(target.normal,
			vector_difference(by->corner[i], shape->corner[0]));
	for (int i = 0; i < 3; i++) {
		int k = (i + 1) % 3;
		double least = height[i] < height[k] ? height[i] : height[k];
		double most = height[i] < height[k] ? height[k] : height[i];

		if (least < -CROSSING_DEPTH && most > CROSSING_DEPTH &&
			is_well_inside(&target,
				vector_along(by->corner[i],
					vector_difference(
						by->corner[k], by->corner[i]),
					height[i] / (height[i] - height[k]))))
			return true;
	}
	return false;
}

bool
triangles_cross(const struct triangle_shape *a, const struct triangle_shape *b)
{
	return is_pierced(a, b) || is_pierced(b, a);
}
