#include "solid_winding.h"

#include <math.h>

#include "planar.h"

/* ---- around a point ---------------------------------------------------------- */

/* Half the solid angle of a triangle, positive where the origin is behind it. */
static double
half_angle(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	double la = sqrt(point_dot(a, a)), lb = sqrt(point_dot(b, b));
	double lc = sqrt(point_dot(c, c));

	return atan2(point_dot(a, point_cross(b, c)),
		la * lb * lc + point_dot(a, b) * lc + point_dot(b, c) * la +
			point_dot(c, a) * lb);
}

static double
piece_angle(const struct solid_pieces *pieces, const struct solid_piece *piece,
	struct tcs_point at)
{
	const struct tcs_point *points = pieces->points.at + piece->first;
	struct tcs_point first = point_minus(points[0], at);
	struct tcs_point last = point_minus(points[1], at);
	double sum = 0;

	for (uint32_t i = 2; i < piece->count; i++) {
		struct tcs_point here = point_minus(points[i], at);

		sum += half_angle(first, last, here);
		last = here;
	}
	return sum;
}

struct solid_winding
solid_winding_at(const struct solid_pieces *pieces, struct tcs_point at)
{
	const double whole = 2 * 3.14159265358979323846;
	double sums[2] = {0, 0};

	for (size_t i = 0; i < pieces->list.count; i++) {
		const struct solid_piece *piece = &pieces->list.at[i];

		if (piece->side)
			sums[piece->origin > 0] +=
				piece_angle(pieces, piece, at);
	}
	return (struct solid_winding){{(int)lround(sums[HOST] / whole),
		(int)lround(sums[TOOLS] / whole)}};
}

/* ---- in a piece -------------------------------------------------------------- */

/* Along the plane's steepest axis: which way round does not matter. */
static struct planar_point
flat(const struct solid_plane *plane, struct tcs_point at)
{
	double x = fabs(plane->normal.x), y = fabs(plane->normal.y);
	double z = fabs(plane->normal.z);

	if (x >= y && x >= z)
		return (struct planar_point){at.y, at.z};
	if (y >= z)
		return (struct planar_point){at.z, at.x};
	return (struct planar_point){at.x, at.y};
}

/* Whether a ray from the point along x meets the edge; the lower end is part of
 * the edge and the upper is not. */
static bool
ray_meets(struct planar_point a, struct planar_point b, struct planar_point at)
{
	if ((a.y <= at.y) == (b.y <= at.y))
		return false;
	return a.y <= at.y ? planar_orient(a, b, at) > 0
			   : planar_orient(b, a, at) > 0;
}

bool
solid_piece_holds(const struct solid_pieces *pieces,
	const struct solid_piece *piece, const struct solid_plane *plane,
	struct tcs_point point)
{
	const struct tcs_point *points = pieces->points.at + piece->first;
	struct planar_point at = flat(plane, point);
	struct planar_point last = flat(plane, points[piece->count - 1]);
	bool odd = false;

	for (uint32_t i = 0; i < piece->count; i++) {
		struct planar_point here = flat(plane, points[i]);

		odd ^= ray_meets(last, here, at);
		last = here;
	}
	return odd;
}
