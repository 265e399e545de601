#include "ifc_offset.h"

#include <math.h>

#include "ifc_curve.h"
#include "solid_points.h"

enum { BASIS, DISTANCE, UP = 3 };

static const double LONGEST_MITRE = 8;

static bool
normalise(struct tcs_point *vector)
{
	double length = sqrt(point_dot(*vector, *vector));

	if (!(length > 0) || !isfinite(length))
		return false;
	vector->x /= length;
	vector->y /= length;
	vector->z /= length;
	return true;
}

/* To the side of the way from a to b; false when there is none. */
static bool
side_of(struct tcs_point a, struct tcs_point b, struct tcs_point up,
	struct tcs_point *out)
{
	*out = point_cross(up, point_minus(b, a));
	return normalise(out);
}

/* The point beside a corner, between the sides before and behind it. */
static struct tcs_point
mitre(struct tcs_point at, struct tcs_point before, struct tcs_point behind,
	double distance)
{
	struct tcs_point side = point_plus(before, behind);

	if (normalise(&side))
		distance /= fmax(point_dot(side, behind), 1 / LONGEST_MITRE);
	else
		side = before;
	return (struct tcs_point){at.x + distance * side.x,
		at.y + distance * side.y, at.z + distance * side.z};
}

/* The points without those that are the same as the one before. */
static enum ifc_outcome
distinct(struct ifc_shaper *shaper, const struct tcs_point *points,
	size_t count, bool closed, struct ifc_points *out)
{
	enum ifc_outcome outcome = ifc_points_room(shaper, out, count);

	for (size_t i = 0; i < count && !outcome; i++)
		if (!out->count ||
			!ifc_same_point(
				shaper, out->at[out->count - 1], points[i]))
			out->at[out->count++] = points[i];
	while (!outcome && closed && out->count > 1 &&
		ifc_same_point(shaper, out->at[0], out->at[out->count - 1]))
		out->count--;
	return outcome;
}

enum ifc_outcome
ifc_offset_points(struct ifc_shaper *shaper, const struct tcs_point *points,
	size_t count, bool closed, double distance, struct tcs_point up,
	struct ifc_points *out)
{
	struct ifc_points all = {.count = 0};
	enum ifc_outcome outcome =
		distinct(shaper, points, count, closed, &all);

	if (!outcome && all.count > 1)
		outcome = ifc_points_room(shaper, out, all.count);
	for (size_t i = 0; i < all.count && all.count > 1 && !outcome; i++) {
		size_t next = (i + 1) % all.count;
		size_t last = (i + all.count - 1) % all.count;
		struct tcs_point before = up, behind = up;
		bool begins = !closed && i == 0, ends = !closed && next == 0;

		if ((!begins &&
			    !side_of(all.at[last], all.at[i], up, &before)) ||
			(!ends &&
				!side_of(all.at[i], all.at[next], up, &behind)))
			outcome = ifc_refuse(shaper, STEP_NONE,
				"a curve runs along what it is offset from");
		else
			out->at[out->count++] =
				mitre(all.at[i], begins ? behind : before,
					ends ? before : behind, distance);
	}
	array_release(&all);
	return outcome;
}

enum ifc_outcome
ifc_offset_between(struct ifc_shaper *shaper, uint32_t curve, double from,
	double to, struct ifc_points *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value value = ifc_value(file, curve, DISTANCE);
	struct ifc_points basis = {.count = 0};
	struct tcs_point up = {0, 0, 1};
	double distance, reach = shaper->reach;
	size_t first = out->count;
	enum ifc_outcome outcome;
	bool closed;

	if (!step_number(&value, &distance) ||
		(ifc_entity_of(file, curve) == IFC_OFFSETCURVE3D &&
			(!ifc_triple(file, ifc_target(file, curve, UP), &up) ||
				!normalise(&up))))
		return ifc_refuse(shaper, curve, "an offset is bad");
	shaper->reach += fabs(distance);
	outcome = ifc_curve_between(
		shaper, ifc_target(file, curve, BASIS), from, to, &basis);
	shaper->reach = reach;
	closed = !outcome && basis.count > 2 &&
		ifc_same_point(shaper, basis.at[0], basis.at[basis.count - 1]);
	if (!outcome)
		outcome = ifc_offset_points(shaper, basis.at, basis.count,
			closed, distance, up, out);
	if (!outcome && closed && out->count > first)
		outcome = ifc_point_add(shaper, out, out->at[first]);
	array_release(&basis);
	return outcome;
}
