#include <math.h>

#include "ifc_curve.h"
#include "ifc_offset.h"
#include "ifc_profile.h"

enum { CURVE = 2, THICKNESS = 3 };

static const struct tcs_point up = {0, 0, 1};

/* Both sides of the line: one ring around it, or two where it is closed. */
static enum ifc_outcome
strip_rings(struct ifc_shaper *shaper, const struct ifc_points *line,
	bool closed, double half, struct ifc_faces *out)
{
	enum ifc_outcome outcome = ifc_offset_points(
		shaper, line->at, line->count, closed, -half, up, &out->points);
	size_t first = out->points.count;

	if (!outcome && closed)
		outcome = ifc_ring_end(shaper, out, NULL);
	if (!outcome)
		outcome = ifc_offset_points(shaper, line->at, line->count,
			closed, half, up, &out->points);
	for (size_t low = first, high = out->points.count;
		!outcome && low + 1 < high; low++) {
		struct tcs_point swap = out->points.at[low];

		out->points.at[low] = out->points.at[--high];
		out->points.at[high] = swap;
	}
	return outcome ? outcome : ifc_ring_end(shaper, out, NULL);
}

static double
area2(const struct ifc_points *ring)
{
	double area = 0;

	for (size_t i = 0; i < ring->count; i++) {
		struct tcs_point a = ring->at[i];
		struct tcs_point b = ring->at[(i + 1) % ring->count];

		area += a.x * b.y - b.x * a.y;
	}
	return area;
}

enum ifc_outcome
ifc_profile_strip(
	struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct ifc_points line = {.count = 0};
	double thickness = 0, reach = shaper->reach;
	enum ifc_outcome outcome;
	bool closed;

	if (!ifc_profile_number(file, profile, THICKNESS, &thickness) ||
		!(thickness > 0))
		return ifc_refuse(
			shaper, profile, "a thickness is not positive");
	shaper->reach += thickness / 2;
	outcome = ifc_curve_points(
		shaper, ifc_target(file, profile, CURVE), &line);
	shaper->reach = reach;
	for (size_t i = 0; i < line.count; i++)
		line.at[i].z = 0;
	closed = !outcome && line.count > 3 &&
		ifc_same_point(shaper, line.at[0], line.at[line.count - 1]);
	/* The outer ring of a closed one is to come first. */
	if (closed && area2(&line) < 0)
		ifc_ring_reverse(line.at, line.count);
	if (!outcome)
		outcome =
			strip_rings(shaper, &line, closed, thickness / 2, out);
	array_release(&line);
	return outcome ? outcome : ifc_face_end(shaper, out);
}
