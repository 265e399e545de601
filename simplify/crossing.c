#include "crossing.h"

#include "vector.h"

/* Metres: what reaches less far through a plane does not cross what lies in
   it, but at angles under 6 degrees. */
#define BARELY (CROSSING_DEPTH / 10)

/* A triangle that edges may pass through. */
struct target {
	const struct triangle_shape *shape;
	struct tcs_point normal; /* of length 1 */
};

static int
next_of(int corner)
{
	return corner < 2 ? corner + 1 : 0;
}

/* Inside by more than the depth; the point lies in the plane. */
static inline bool
is_well_inside(const struct target *target, struct tcs_point point)
{
	for (int i = 0; i < 3; i++) {
		struct tcs_point from = target->shape->corner[i];
		struct tcs_point side = vector_difference(
			target->shape->corner[next_of(i)], from);
		double inward = vector_dot(vector_cross(target->normal, side),
			vector_difference(point, from));

		if (inward <= 0 ||
			inward * inward <= CROSSING_DEPTH * CROSSING_DEPTH *
					vector_dot(side, side))
			return false;
	}
	return true;
}

/* How high the corners of `other` are over the target. */
static inline void
find_heights(const struct target *target, const struct triangle_shape *other,
	double height[3])
{
	for (int i = 0; i < 3; i++)
		height[i] = vector_dot(target->normal,
			vector_difference(
				other->corner[i], target->shape->corner[0]));
}

/* Whether some are on the one side, and some on the other. */
static bool
are_on_both_sides(const double height[3])
{
	return (height[0] < -BARELY || height[1] < -BARELY ||
		       height[2] < -BARELY) &&
		(height[0] > BARELY || height[1] > BARELY ||
			height[2] > BARELY);
}

/* Whether an edge of `by` passes through. */
static inline bool
is_pierced(const struct target *target, const struct triangle_shape *by,
	const double height[3])
{
	for (int i = 0; i < 3; i++) {
		int k = next_of(i);

		if (((height[i] < -CROSSING_DEPTH &&
			     height[k] > CROSSING_DEPTH) ||
			    (height[k] < -CROSSING_DEPTH &&
				    height[i] > CROSSING_DEPTH)) &&
			is_well_inside(target,
				vector_along(by->corner[i],
					vector_difference(
						by->corner[k], by->corner[i]),
					height[i] / (height[i] - height[k]))))
			return true;
	}
	return false;
}

/* Whether edges of `by` pass through the plane of a triangle at all. */
static bool
is_cut(const struct triangle_shape *shape, struct tcs_point normal,
	const struct triangle_shape *by)
{
	const struct target target = {shape, normal};
	double height[3];

	find_heights(&target, by, height);
	return (height[0] < 0 || height[1] < 0 || height[2] < 0) &&
		(height[0] > 0 || height[1] > 0 || height[2] > 0);
}

/* False where it has no normal. */
static bool
aim_at(const struct triangle_shape *shape, struct target *target)
{
	struct tcs_point normal = triangle_normal(shape);
	double length = vector_length(normal);

	if (!(length > 0))
		return false;
	*target = (struct target){shape, vector_scaled(normal, 1 / length)};
	return true;
}

bool
triangles_cross_along(const struct triangle_shape *a, struct tcs_point normal,
	const struct triangle_shape *b)
{
	struct target target = {a, normal};
	double height[3];

	find_heights(&target, b, height);
	if (!are_on_both_sides(height))
		return false;
	if (is_pierced(&target, b, height))
		return true;
	if (!is_cut(b, triangle_normal(b), a) || !aim_at(b, &target))
		return false;
	find_heights(&target, a, height);
	return is_pierced(&target, a, height);
}

bool
triangles_cross(const struct triangle_shape *a, const struct triangle_shape *b)
{
	struct target target;
	double height[3];

	if (aim_at(a, &target))
		return triangles_cross_along(a, target.normal, b);
	if (!aim_at(b, &target))
		return false;
	find_heights(&target, a, height);
	return is_pierced(&target, a, height);
}
