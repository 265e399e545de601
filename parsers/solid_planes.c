#include "solid_planes.h"

#include <math.h>
#include <string.h>

enum {
	SLOTS = 4096,
	DIRECTIONS = 64, /* parts of a coordinate of the normal */
	REACHES = 64, /* parts of the extent */
};

/* Normals and reaches of one plane differ by less than this part of a part. */
#define BLUR 0.02

enum tcs_status
solid_planes_begin(struct solid_planes *planes, double tolerance, double extent,
	struct tcs_fault *fault)
{
	array_clear(&planes->list);
	array_clear(&planes->next);
	array_clear(&planes->slots);
	if (array_grow(&planes->slots, SLOTS))
		return fault_memory(fault);
	planes->slots.count = SLOTS;
	memset(planes->slots.at, 0, SLOTS * sizeof *planes->slots.at);
	planes->tolerance = tolerance;
	planes->extent = extent;
	return TCS_OK;
}

void
solid_planes_release(struct solid_planes *planes)
{
	array_release(&planes->list);
	array_release(&planes->next);
	array_release(&planes->slots);
}

/* ---- the ring's own plane ---------------------------------------------------- */

/* Newell's normal; its length is twice the area. */
static struct tcs_point
ring_normal(const struct tcs_point *ring, size_t count, double *length,
	double *reach)
{
	struct tcs_point sum = {0, 0, 0}, last = point_minus(ring[1], ring[0]);

	*reach = sqrt(point_dot(last, last));
	for (size_t i = 2; i < count; i++) {
		struct tcs_point here = point_minus(ring[i], ring[0]);

		sum = point_plus(sum, point_cross(last, here));
		*reach = fmax(*reach, sqrt(point_dot(here, here)));
		last = here;
	}
	*length = sqrt(point_dot(sum, sum));
	return sum;
}

static double
rounded(double value)
{
	return ldexp(nearbyint(ldexp(value, 40)), -40);
}

struct range {
	double low, high;
};

static struct range
range_along(
	struct tcs_point normal, const struct tcs_point *points, size_t count)
{
	struct range range = {INFINITY, -INFINITY};

	for (size_t i = 0; i < count; i++) {
		double at = point_dot(normal, points[i]);

		range.low = fmin(range.low, at);
		range.high = fmax(range.high, at);
	}
	return range;
}

/* The axis that is the normal as far as the points can tell, or the normal. */
static struct tcs_point
normal_choose(struct tcs_point normal, const struct tcs_point *points,
	size_t count, double tolerance)
{
	double x = fabs(normal.x), y = fabs(normal.y), z = fabs(normal.z);
	struct tcs_point axis = {x > y && x > z, 0, 0};
	struct range range;

	axis.y = axis.x == 0 && y > z;
	axis.z = axis.x == 0 && axis.y == 0;
	if (point_dot(axis, normal) < 0)
		axis = point_minus((struct tcs_point){0, 0, 0}, axis);
	range = range_along(axis, points, count);
	if (range.high - range.low <= tolerance / 8)
		return axis;
	return (struct tcs_point){
		rounded(normal.x), rounded(normal.y), rounded(normal.z)};
}

/* ---- planes that are there --------------------------------------------------- */

/* Where a plane stands in the table, whichever way its normal points: a little
 * less of each part, and a little more. */
struct place {
	int64_t less[4], more[4];
	unsigned blurred; /* a bit for each part of which these differ */
};

static struct place
place_of(const struct solid_planes *planes, const struct solid_plane *plane)
{
	const double parts[4] = {fabs(plane->normal.x) * DIRECTIONS,
		fabs(plane->normal.y) * DIRECTIONS,
		fabs(plane->normal.z) * DIRECTIONS,
		fmin(fabs(plane->reach) / planes->extent * REACHES, 1e15)};
	struct place place = {.blurred = 0};

	for (unsigned i = 0; i < 4; i++) {
		/* Rounded down, as none is negative. */
		place.less[i] = (int64_t)(parts[i] + (1 - BLUR)) - 1;
		place.more[i] = (int64_t)(parts[i] + BLUR);
		place.blurred |= (unsigned)(place.less[i] != place.more[i])
			<< i;
	}
	return place;
}

/* `shift` has a bit for each part that is to be looked at a little further. */
static size_t
slot_of(const struct place *place, unsigned shift)
{
	uint64_t hash = 0;

	for (unsigned i = 0; i < 4; i++) {
		hash = (hash ^
			       (uint64_t)(shift >> i & 1 ? place->more[i]
							 : place->less[i])) *
			0x9e3779b97f4a7c15;
		hash ^= hash >> 32;
	}
	return (size_t)hash % SLOTS;
}

static bool
is_within(const struct solid_plane *plane, double tolerance,
	const struct tcs_point *points, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (!(fabs(solid_plane_distance(plane, points[i])) <=
			    tolerance))
			return false;
	}
	return true;
}

static uint32_t
plane_search(const struct solid_planes *planes, const struct solid_plane *own,
	const struct tcs_point *points, size_t count)
{
	struct place place = place_of(planes, own);

	for (unsigned shift = 0; shift < 16; shift++) {
		uint32_t at;

		if (shift & ~place.blurred)
			continue;
		at = planes->slots.at[slot_of(&place, shift)];
		for (; at; at = planes->next.at[at - 1]) {
			const struct solid_plane *plane =
				&planes->list.at[at - 1];

			if (is_within(
				    plane, planes->tolerance, points, count) &&
				fabs(point_dot(plane->normal, own->normal)) >
					0.9)
				return at - 1;
		}
	}
	return UINT32_MAX;
}

/* Into every slot where a blurred one of it may be looked for. */
static enum tcs_status
plane_add(struct solid_planes *planes, const struct solid_plane *own,
	uint32_t *plane, struct tcs_fault *fault)
{
	struct place place = place_of(planes, own);
	uint32_t *slot = &planes->slots.at[slot_of(&place, 0)];

	if (planes->list.count >= UINT32_MAX - 1 ||
		array_grow(&planes->list, 1) || array_grow(&planes->next, 1))
		return fault_memory(fault);
	*plane = (uint32_t)planes->list.count;
	planes->list.at[planes->list.count++] = *own;
	planes->next.at[planes->next.count++] = *slot;
	*slot = *plane + 1;
	return TCS_OK;
}

enum tcs_status
solid_planes_find(struct solid_planes *planes, const struct tcs_point *points,
	size_t outer, size_t count, uint32_t *plane, int *side,
	struct tcs_fault *fault)
{
	struct solid_plane own;
	struct tcs_point sum;
	struct range range;
	double length, reach;
	enum tcs_status status = TCS_OK;

	*side = 0;
	if (outer < 3)
		return TCS_OK;
	sum = ring_normal(points, outer, &length, &reach);
	if (!(length > planes->tolerance * reach))
		return TCS_OK;
	own.normal = normal_choose((struct tcs_point){sum.x / length,
					   sum.y / length, sum.z / length},
		points, count, planes->tolerance);
	range = range_along(own.normal, points, count);
	own.reach = range.low + (range.high - range.low) / 2;
	*plane = plane_search(planes, &own, points, count);
	if (*plane == UINT32_MAX &&
		range.high - range.low > 2 * planes->tolerance)
		return TCS_OK;
	if (*plane == UINT32_MAX)
		status = plane_add(planes, &own, plane, fault);
	if (!status)
		*side = point_dot(planes->list.at[*plane].normal, sum) > 0 ? 1
									   : -1;
	return status;
}

enum tcs_status
solid_planes_place(struct solid_planes *planes, struct tcs_point point,
	struct tcs_point normal, uint32_t *plane, int *side,
	struct tcs_fault *fault)
{
	struct tcs_point axis = {fabs(normal.x) < 0.6, 0, 0}, u, v;
	struct tcs_point square[4];
	double scale;

	axis.y = 1 - axis.x;
	u = point_cross(normal, axis);
	scale = planes->extent / sqrt(point_dot(u, u));
	u = (struct tcs_point){u.x * scale, u.y * scale, u.z * scale};
	v = point_cross(normal, u);
	square[0] = point_plus(point, u);
	square[1] = point_plus(point, v);
	square[2] = point_minus(point, u);
	square[3] = point_minus(point, v);
	return solid_planes_find(planes, square, 4, 4, plane, side, fault);
}
