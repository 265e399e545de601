#include "solid.h"
#include "solid_points.h"

/* Twice the ring's area, along its normal. */
static struct tcs_point
ring_area(const struct tcs_point *ring, size_t count)
{
	struct tcs_point sum = {0, 0, 0};

	for (size_t i = 2; i < count; i++)
		sum = point_plus(sum,
			point_cross(point_minus(ring[i - 1], ring[0]),
				point_minus(ring[i], ring[0])));
	return sum;
}

/* The outer ring is to turn counterclockwise around `along`, holes clockwise. */
static bool
is_turned(const struct tcs_point *ring, size_t count, struct tcs_point along,
	bool hole)
{
	return (point_dot(ring_area(ring, count), along) < 0) != hole;
}

/* All points of the solid's last face in reverse, but each ring's first. */
static void
rings_reverse(struct solid *solid, size_t ring, bool turned)
{
	size_t end = solid->ring_ends.at[ring];
	size_t low = (ring ? solid->ring_ends.at[ring - 1] : 0) + 1;

	for (size_t high = end - 1; turned && low < high; low++, high--) {
		struct tcs_point kept = solid->points.at[low];

		solid->points.at[low] = solid->points.at[high];
		solid->points.at[high] = kept;
	}
}

/* The polygon as one end of the prism, moved by `by`. */
static enum tcs_status
end_add(struct solid *solid, const struct tcs_point *points,
	const uint32_t *rings, size_t ring_count, struct tcs_point along,
	bool far, uint32_t label, struct tcs_fault *fault)
{
	size_t at = solid->points.count, ring = solid->ring_ends.count;
	enum tcs_status status =
		solid_add_face(solid, points, rings, ring_count, label, fault);

	if (status)
		return status;
	for (; far && at < solid->points.count; at++)
		solid->points.at[at] = point_plus(solid->points.at[at], along);
	for (size_t i = 0; i < ring_count; points += rings[i++]) {
		bool turned = is_turned(points, rings[i], along, i > 0);

		if (rings[i])
			rings_reverse(solid, ring + i, turned == far);
	}
	return TCS_OK;
}

static enum tcs_status
sides_add(struct solid *solid, const struct tcs_point *ring, uint32_t count,
	struct tcs_point along, bool hole, uint32_t label,
	struct tcs_fault *fault)
{
	static const uint32_t four = 4;
	bool turned = is_turned(ring, count, along, hole);
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < count; i++) {
		struct tcs_point a = ring[i], b = ring[(i + 1) % count];
		struct tcs_point from = turned ? b : a, to = turned ? a : b;
		struct tcs_point side[4] = {from, to, point_plus(to, along),
			point_plus(from, along)};

		status = solid_add_face(solid, side, &four, 1, label, fault);
	}
	return status;
}

enum tcs_status
solid_add_prism(struct solid *solid, const struct tcs_point *points,
	const uint32_t *rings, size_t ring_count, struct tcs_point along,
	uint32_t label, struct tcs_fault *fault)
{
	enum tcs_status status = end_add(
		solid, points, rings, ring_count, along, false, label, fault);

	if (!status)
		status = end_add(solid, points, rings, ring_count, along, true,
			label, fault);
	for (size_t i = 0; !status && i < ring_count; points += rings[i++])
		status = sides_add(
			solid, points, rings[i], along, i > 0, label, fault);
	return status;
}
