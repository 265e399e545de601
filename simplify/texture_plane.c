#include "texture_plane.h"

#include "vector.h"

/* Squared sine of the angle below which a triangle is too thin. */
#define THIN 1e-12

static double
square_distance(struct tcs_point a, struct tcs_point b)
{
	struct tcs_point ab = vector_difference(b, a);

	return vector_dot(ab, ab);
}

static struct tcs_texcoord
nearest_coordinate(const struct tcs_point corners[3],
	const struct tcs_texcoord coordinates[3], struct tcs_point at)
{
	int best = 0;

	for (int k = 1; k < 3; k++)
		if (square_distance(corners[k], at) <
			square_distance(corners[best], at))
			best = k;
	return coordinates[best];
}

struct tcs_texcoord
texture_plane_at(const struct tcs_point corners[3],
	const struct tcs_texcoord coordinates[3], struct tcs_point at)
{
	struct tcs_point u = vector_difference(corners[1], corners[0]);
	struct tcs_point v = vector_difference(corners[2], corners[0]);
	struct tcs_point w = vector_difference(at, corners[0]);
	double uu = vector_dot(u, u), uv = vector_dot(u, v);
	double vv = vector_dot(v, v), uw = vector_dot(u, w);
	double vw = vector_dot(v, w);
	double determinant = uu * vv - uv * uv;
	double a, b;

	if (!(determinant > THIN * uu * vv))
		return nearest_coordinate(corners, coordinates, at);
	a = (uw * vv - vw * uv) / determinant;
	b = (vw * uu - uw * uv) / determinant;
	return (struct tcs_texcoord){coordinates[0].s +
			a * (coordinates[1].s - coordinates[0].s) +
			b * (coordinates[2].s - coordinates[0].s),
		coordinates[0].t + a * (coordinates[1].t - coordinates[0].t) +
			b * (coordinates[2].t - coordinates[0].t)};
}
