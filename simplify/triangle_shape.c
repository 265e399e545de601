#include "triangle_shape.h"

static inline struct tcs_point
segment_nearest(struct tcs_point a, struct tcs_point b, struct tcs_point point)
{
	struct tcs_point ab = vector_difference(b, a);
	double square = vector_dot(ab, ab);
	double t = vector_dot(vector_difference(point, a), ab);

	if (!(square > 0) || t <= 0)
		return a;
	return t >= square ? b : vector_along(a, ab, t / square);
}

static inline double
square_distance(struct tcs_point a, struct tcs_point b)
{
	struct tcs_point ab = vector_difference(b, a);

	return vector_dot(ab, ab);
}

/* In a coordinate plane. */
struct flat {
	double u, v;
};

/* From one point to another, along two of the axes. */
static inline struct flat
flat_difference(struct tcs_point a, struct tcs_point b, size_t u, size_t v)
{
	const double from[3] = {b.x, b.y, b.z}, to[3] = {a.x, a.y, a.z};

	return (struct flat){to[u] - from[u], to[v] - from[v]};
}

/* Whether a turns right into b, seen from where the plane's normal points: that
   is `up` there. */
static inline bool
turns_right(struct flat a, struct flat b, double up)
{
	double turn = a.u * b.v - a.v * b.u;

	return up < 0 ? turn > 0 : turn < 0;
}

/* A bit for each edge, from corner i to the next, that has a point of the plane
   on its right; `u` and `v` are the axes across that which the normal is most
   upright on. */
static inline unsigned
edges_left_across(const struct triangle_shape *t, struct tcs_point point,
	size_t u, size_t v, double up)
{
	struct flat a = flat_difference(t->corner[0], point, u, v);
	struct flat b = flat_difference(t->corner[1], point, u, v);
	struct flat c = flat_difference(t->corner[2], point, u, v);

	return (unsigned)turns_right(a, b, up) |
		(unsigned)turns_right(b, c, up) << 1 |
		(unsigned)turns_right(c, a, up) << 2;
}

static inline unsigned
edges_left_of(const struct triangle_shape *t, struct tcs_point normal,
	struct tcs_point point)
{
	double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);

	if (z >= x && z >= y)
		return edges_left_across(t, point, 0, 1, normal.z);
	if (y >= x)
		return edges_left_across(t, point, 2, 0, normal.y);
	return edges_left_across(t, point, 1, 2, normal.x);
}

/* The point on the plane below another; `square` is the normal's, not 0. */
static inline struct tcs_point
foot_of(const struct triangle_shape *t, struct tcs_point normal, double square,
	struct tcs_point point)
{
	return vector_along(point, normal,
		-vector_dot(normal, vector_difference(point, t->corner[0])) /
			square);
}

bool
triangle_is_above(const struct triangle_shape *t, struct tcs_point normal,
	struct tcs_point point)
{
	double square = vector_dot(normal, normal);

	return !(square > 0) ||
		!edges_left_of(t, normal, foot_of(t, normal, square, point));
}

/* Only an edge that has the point on its outer side can be nearest. */
struct tcs_point
triangle_nearest_along(const struct triangle_shape *t, struct tcs_point normal,
	struct tcs_point point)
{
	double square = vector_dot(normal, normal), least = INFINITY;
	struct tcs_point best = t->corner[0];
	unsigned edges = 7;

	if (square > 0) {
		struct tcs_point foot = foot_of(t, normal, square, point);

		edges = edges_left_of(t, normal, foot);
		if (!edges)
			return foot;
	}
	for (int i = 0; i < 3; i++) {
		struct tcs_point at;
		double distance;

		if (!(edges >> i & 1))
			continue;
		at = segment_nearest(
			t->corner[i], t->corner[i < 2 ? i + 1 : 0], point);
		distance = square_distance(at, point);
		if (distance < least) {
			least = distance;
			best = at;
		}
	}
	return best;
}

struct tcs_point
triangle_nearest(const struct triangle_shape *t, struct tcs_point point)
{
	return triangle_nearest_along(t, triangle_normal(t), point);
}

static double
clamp(double value)
{
	return value < 0 ? 0 : value > 1 ? 1 : value;
}

double
segment_gap(const struct tcs_point p[2], const struct tcs_point q[2],
	struct tcs_point out[2])
{
	struct tcs_point d = vector_difference(p[1], p[0]);
	struct tcs_point e = vector_difference(q[1], q[0]);
	struct tcs_point r = vector_difference(p[0], q[0]);
	double dd = vector_dot(d, d), ee = vector_dot(e, e);
	double de = vector_dot(d, e), er = vector_dot(e, r);
	double denominator = dd * ee - de * de;
	double s = denominator > 0
		? clamp((de * er - vector_dot(d, r) * ee) / denominator)
		: 0;

	/* The best of q for s, then the best of p for that, and again: exact
	   where the middle of both is meant, and never beyond an end. */
	out[0] = vector_along(p[0], d, s);
	out[1] = segment_nearest(q[0], q[1], out[0]);
	out[0] = segment_nearest(p[0], p[1], out[1]);
	return sqrt(square_distance(out[0], out[1]));
}

bool
triangle_pierced(const struct triangle_shape *t,
	const struct tcs_point segment[2], struct tcs_point *at)
{
	struct tcs_point normal = triangle_normal(t);
	double a =
		vector_dot(normal, vector_difference(segment[0], t->corner[0]));
	double b =
		vector_dot(normal, vector_difference(segment[1], t->corner[0]));

	if (!((a < 0 && b > 0) || (a > 0 && b < 0)))
		return false;
	*at = vector_along(segment[0],
		vector_difference(segment[1], segment[0]), a / (a - b));
	return triangle_is_above(t, normal, *at);
}

/* Pierced by an edge of the other: *at is where. */
static bool
is_pierced_by(const struct triangle_shape *a, const struct triangle_shape *b,
	struct tcs_point *at)
{
	for (int i = 0; i < 3; i++)
		if (triangle_pierced(a,
			    (struct tcs_point[]){
				    b->corner[i], b->corner[(i + 1) % 3]},
			    at))
			return true;
	return false;
}

struct nearer {
	double distance;
	struct tcs_point *out;
};

static void
take_nearer(struct nearer *best, double distance, struct tcs_point a,
	struct tcs_point b)
{
	if (distance >= best->distance)
		return;
	best->distance = distance;
	best->out[0] = a;
	best->out[1] = b;
}

double
triangle_gap(const struct triangle_shape *a, const struct triangle_shape *b,
	struct tcs_point out[2])
{
	struct nearer best = {INFINITY, out};

	if (is_pierced_by(a, b, &out[0]) || is_pierced_by(b, a, &out[0])) {
		out[1] = out[0];
		return 0;
	}
	for (int i = 0; i < 3; i++) {
		struct tcs_point p = a->corner[i], q = b->corner[i];
		struct tcs_point on_b = triangle_nearest(b, p);
		struct tcs_point on_a = triangle_nearest(a, q);

		take_nearer(&best, sqrt(square_distance(p, on_b)), p, on_b);
		take_nearer(&best, sqrt(square_distance(q, on_a)), on_a, q);
	}
	for (int i = 0; i < 9; i++) {
		struct tcs_point at[2];
		int k = i / 3, m = i % 3;
		double distance = segment_gap((struct tcs_point[]){a->corner[k],
						      a->corner[(k + 1) % 3]},
			(struct tcs_point[]){
				b->corner[m], b->corner[(m + 1) % 3]},
			at);

		take_nearer(&best, distance, at[0], at[1]);
	}
	return best.distance;
}

bool
triangle_hit(const struct triangle_shape *triangle, struct tcs_point origin,
	struct tcs_point direction, double *t, double *margin)
{
	struct tcs_point a = triangle->corner[0];
	struct tcs_point ab = vector_difference(triangle->corner[1], a);
	struct tcs_point ac = vector_difference(triangle->corner[2], a);
	struct tcs_point p = vector_cross(direction, ac);
	double determinant = vector_dot(ab, p);
	struct tcs_point s = vector_difference(origin, a);
	struct tcs_point q = vector_cross(s, ab);
	double u, v;

	if (!(fabs(determinant) > 0))
		return false;
	u = vector_dot(s, p) / determinant;
	v = vector_dot(direction, q) / determinant;
	*margin = fmin(fmin(u, v), 1 - u - v);
	*t = vector_dot(ac, q) / determinant;
	return *margin >= 0;
}
