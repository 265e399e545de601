#include "planar.h"

static struct tcs_point
minus(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

static struct tcs_point
cross(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
		a.x * b.y - a.y * b.x};
}

static double
dot(struct tcs_point a, struct tcs_point b)
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static double
largest(struct tcs_point a)
{
	return planar_larger(fabs(a.x), planar_larger(fabs(a.y), fabs(a.z)));
}

static double
axis_get(struct tcs_point point, unsigned axis)
{
	return axis == 0 ? point.x : axis == 1 ? point.y : point.z;
}

static void
axis_set(struct tcs_point *point, unsigned axis, double value)
{
	*(axis == 0 ? &point->x : axis == 1 ? &point->y : &point->z) = value;
}

/* ---- the plane --------------------------------------------------------------- */

/* What rounding of the coordinates may add to an area within `reach`. */
static double
area_noise(struct tcs_point origin, double reach)
{
	return 2e-15 * (reach + largest(origin)) * reach;
}

/*
 * Newell's normal, as the sum of the triangles from the first vertex. Where
 * they cancel, as in a figure of eight, rounding would decide: the largest of
 * them gives the direction and their sum the sense.
 */
static struct tcs_point
ring_normal(const struct tcs_point *ring, size_t count, double *reach)
{
	struct tcs_point all = {0, 0, 0}, most = {0, 0, 0};
	struct tcs_point last = minus(ring[1], ring[0]);
	double sum = 0, most_size = 0;

	*reach = largest(last);
	for (size_t i = 2; i < count; i++) {
		struct tcs_point here = minus(ring[i], ring[0]);
		struct tcs_point one = cross(last, here);
		double size = largest(one);

		all.x += one.x;
		all.y += one.y;
		all.z += one.z;
		sum += size;
		if (size > most_size) {
			most = one;
			most_size = size;
		}
		*reach = planar_larger(*reach, largest(here));
		last = here;
	}
	if (largest(all) > 1e-6 * sum &&
		largest(all) > area_noise(ring[0], *reach))
		return all;
	return dot(all, most) < 0 ? minus((struct tcs_point){0, 0, 0}, most)
				  : most;
}

enum { X, Y, Z };

/* The axis nearest the normal is left out; the others keep it upwards. */
static void
plane_axes(struct planar_plane *plane)
{
	struct tcs_point n = plane->normal;
	double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
	unsigned third = z >= x && z >= y ? Z : x >= y ? X : Y;
	unsigned next = third == Z ? X : third + 1;
	unsigned after = next == Z ? X : next + 1;
	bool up = axis_get(n, third) > 0;

	plane->axes[0] = (unsigned char)(up ? next : after);
	plane->axes[1] = (unsigned char)(up ? after : next);
	plane->axes[2] = (unsigned char)third;
	plane->cosine = fabs(axis_get(n, third));
	plane->slope_x = -axis_get(n, plane->axes[0]) / axis_get(n, third);
	plane->slope_y = -axis_get(n, plane->axes[1]) / axis_get(n, third);
}

static const char *
plane_find(
	struct planar_plane *plane, const struct tcs_point *ring, size_t count)
{
	double reach, length;
	struct tcs_point n;

	if (count < 3)
		return "the outer ring has fewer than three points";
	n = ring_normal(ring, count, &reach);
	if (!(reach < 1e75))
		return "points too far apart";
	plane->noise = area_noise(ring[0], reach);
	if (reach < 1e-75 || largest(n) <= plane->noise)
		return "the outer ring has no area";
	length = sqrt(dot(n, n));
	plane->origin = ring[0];
	plane->normal =
		(struct tcs_point){n.x / length, n.y / length, n.z / length};
	plane_axes(plane);
	return NULL;
}

/*
 * Shift the plane to the middle of the outer ring. Returns the largest distance
 * from it.
 */
static double
plane_level(struct planar_plane *plane, const struct tcs_point *vertices,
	size_t outer, size_t count)
{
	double low = 0, high = 0, sum = 0, mean;

	for (size_t i = 0; i < count; i++) {
		double off =
			dot(plane->normal, minus(vertices[i], plane->origin));

		low = off < low ? off : low;
		high = off > high ? off : high;
		sum += i < outer ? off : 0;
	}
	mean = sum / (double)outer;
	plane->height = mean / axis_get(plane->normal, plane->axes[2]);
	return planar_larger(high - mean, mean - low);
}

const char *
planar_find(struct planar_plane *plane, const struct tcs_point *vertices,
	size_t outer, size_t count, double *flatness)
{
	const char *reason = plane_find(plane, vertices, outer);

	if (!reason)
		*flatness = plane_level(plane, vertices, outer, count);
	return reason;
}

struct planar_point
planar_project(const struct planar_plane *plane, struct tcs_point point)
{
	struct tcs_point at = minus(point, plane->origin);

	return (struct planar_point){
		axis_get(at, plane->axes[0]), axis_get(at, plane->axes[1])};
}

struct tcs_point
planar_lift(
	const struct planar_plane *plane, struct planar_point at, double off)
{
	struct tcs_point point = plane->origin;
	double third = plane->height + plane->slope_x * at.x +
		plane->slope_y * at.y + off;

	axis_set(
		&point, plane->axes[0], axis_get(point, plane->axes[0]) + at.x);
	axis_set(
		&point, plane->axes[1], axis_get(point, plane->axes[1]) + at.y);
	axis_set(&point, plane->axes[2],
		axis_get(point, plane->axes[2]) + third);
	return point;
}

double
planar_height(const struct planar_plane *plane, struct planar_point at,
	struct tcs_point position)
{
	unsigned third = plane->axes[2];

	return axis_get(position, third) - axis_get(plane->origin, third) -
		(plane->height + plane->slope_x * at.x + plane->slope_y * at.y);
}

/* ---- the cycles -------------------------------------------------------------- */

static void
points_project(
	struct planar *polygon, const struct tcs_point *vertices, size_t count)
{
	struct planar_point low = {0, 0}, high = {0, 0};

	for (size_t i = 0; i < count; i++) {
		struct planar_point at =
			planar_project(&polygon->plane, vertices[i]);

		polygon->points.at[i] = at;
		low.x = at.x < low.x ? at.x : low.x;
		low.y = at.y < low.y ? at.y : low.y;
		high.x = at.x > high.x ? at.x : high.x;
		high.y = at.y > high.y ? at.y : high.y;
	}
	polygon->points.count = count;
	polygon->extent = planar_larger(high.x - low.x, high.y - low.y);
}

static bool
same(struct planar_point a, struct planar_point b)
{
	return a.x == b.x && a.y == b.y;
}

/* Append the ring's vertices to `kept`, without repeated points. */
static size_t
ring_keep(struct planar *polygon, uint32_t first, uint32_t count)
{
	const struct planar_point *points = polygon->points.at;
	uint32_t *kept = polygon->kept.at + polygon->kept.count;
	size_t length = 0;

	for (uint32_t i = first; i < first + count; i++) {
		if (!length || !same(points[kept[length - 1]], points[i]))
			kept[length++] = i;
	}
	while (length > 1 && same(points[kept[length - 1]], points[kept[0]]))
		length--;
	return length;
}

/* Twice the signed area. */
static double
ring_area(const struct planar *polygon, const uint32_t *ring, size_t count)
{
	const struct planar_point *points = polygon->points.at;
	struct planar_point first = points[ring[0]];
	double x = points[ring[1]].x - first.x, y = points[ring[1]].y - first.y;
	double area = 0;

	for (size_t i = 2; i < count; i++) {
		double to_x = points[ring[i]].x - first.x;
		double to_y = points[ring[i]].y - first.y;

		area += x * to_y - y * to_x;
		x = to_x;
		y = to_y;
	}
	return area;
}

static void
ring_link(
	uint32_t *next, uint32_t *previous, const uint32_t *ring, size_t count)
{
	uint32_t last = ring[count - 1];

	for (size_t i = 0; i < count; i++) {
		next[last] = ring[i];
		previous[ring[i]] = last;
		last = ring[i];
	}
}

static void
ring_lay(struct planar *polygon, uint32_t first, uint32_t count, bool hole)
{
	const uint32_t *ring = polygon->kept.at + polygon->kept.count;
	uint32_t *next = polygon->next.at, *previous = polygon->previous.at;
	size_t length = ring_keep(polygon, first, count);
	double area;

	if (length < 3)
		return;
	area = ring_area(polygon, ring, length) / 2;
	if (hole && area > 0)
		ring_link(previous, next, ring, length);
	else
		ring_link(next, previous, ring, length);
	polygon->area += hole ? -fabs(area) : area;
	polygon->firsts.at[polygon->firsts.count++] = ring[0];
	polygon->kept.count += length;
}

static enum tcs_status
room_make(struct planar *polygon, size_t count, size_t ring_count)
{
	polygon->points.count = 0;
	polygon->next.count = 0;
	polygon->previous.count = 0;
	polygon->kept.count = 0;
	polygon->firsts.count = 0;
	if (count > UINT32_MAX / 4 || planar_room(&polygon->points, count) ||
		planar_room(&polygon->next, count) ||
		planar_room(&polygon->previous, count) ||
		planar_room(&polygon->kept, count) ||
		planar_room(&polygon->firsts, ring_count))
		return TCS_NO_MEMORY;
	return TCS_OK;
}

const char *
planar_lay(struct planar *polygon, const struct tcs_point *vertices,
	const uint32_t *rings, size_t ring_count, size_t count,
	enum tcs_status *status)
{
	uint32_t first = 0;

	*status = room_make(polygon, count, ring_count);
	if (*status)
		return NULL;
	points_project(polygon, vertices, count);
	if (!(polygon->extent < 1e75))
		return "points too far apart";
	polygon->area = 0;
	for (size_t i = 0; i < ring_count; i++) {
		ring_lay(polygon, first, rings[i], i > 0);
		if (!polygon->firsts.count)
			return "the outer ring has fewer than three points";
		first += rings[i];
	}
	return NULL;
}

void
planar_trim(struct planar *polygon)
{
	array_trim(&polygon->points);
	array_trim(&polygon->next);
	array_trim(&polygon->previous);
	array_trim(&polygon->kept);
	array_trim(&polygon->firsts);
}

void
planar_release(struct planar *polygon)
{
	array_release(&polygon->points);
	array_release(&polygon->next);
	array_release(&polygon->previous);
	array_release(&polygon->kept);
	array_release(&polygon->firsts);
}
