#include <math.h>

#include "ifc_curve.h"
#include "ifc_sweep_curve.h"
#include "solid_points.h"

enum { DIRECTRIX, RADIUS, INNER_RADIUS, START, END, FILLET };

static const double PI = 3.14159265358979323846;

static struct tcs_point
moved(struct tcs_point from, struct tcs_point along, double by)
{
	return (struct tcs_point){from.x + by * along.x, from.y + by * along.y,
		from.z + by * along.z};
}

static double
unit(struct tcs_point from, struct tcs_point to, struct tcs_point *out)
{
	double length;

	*out = point_minus(to, from);
	length = sqrt(point_dot(*out, *out));
	if (length > 0)
		*out = moved((struct tcs_point){0, 0, 0}, *out, 1 / length);
	return length;
}

/* ---- fillets ------------------------------------------------------------- */

/* The arc that rounds a corner; one too large for its edges is made smaller. */
static enum ifc_outcome
corner_points(struct ifc_shaper *shaper, const struct tcs_point at[3],
	double radius, struct ifc_points *out)
{
	struct tcs_point in, on, side, start, centre;
	double room =
		fmin(unit(at[0], at[1], &in), unit(at[1], at[2], &on)) / 2;
	double cosine = point_dot(in, on), sine, turn, cut;
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t count;

	side = moved(on, in, -cosine);
	sine = sqrt(point_dot(side, side));
	if (!(sine > 1e-9))
		return ifc_point_add(shaper, out, at[1]);
	side = moved((struct tcs_point){0, 0, 0}, side, 1 / sine);
	turn = atan2(sine, cosine);
	cut = fmin(radius * tan(turn / 2), room);
	radius = cut / tan(turn / 2);
	start = moved(at[1], in, -cut);
	centre = moved(start, side, radius);
	count = ifc_arc_chords(shaper, radius, turn);
	for (size_t i = 0; i <= count && !outcome; i++) {
		double angle = turn * (double)i / (double)count;

		outcome = ifc_point_add(shaper, out,
			moved(moved(centre, side, -radius * cos(angle)), in,
				radius * sin(angle)));
	}
	return outcome;
}

static enum ifc_outcome
fillet_points(struct ifc_shaper *shaper, const struct ifc_path *path,
	double radius, struct ifc_points *out)
{
	const struct ifc_station *all = path->stations.at;
	size_t count = path->stations.count;
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < count && !outcome; i++) {
		size_t last = (i + count - 1) % count, next = (i + 1) % count;

		if (!path->closed && (i == 0 || next == 0))
			outcome = ifc_point_add(shaper, out, all[i].at);
		else
			outcome = corner_points(shaper,
				(struct tcs_point[]){
					all[last].at, all[i].at, all[next].at},
				radius, out);
	}
	return !outcome && path->closed ? ifc_point_add(shaper, out, out->at[0])
					: outcome;
}

static enum ifc_outcome
path_fillet(struct ifc_shaper *shaper, double radius, double reach,
	struct ifc_path *path)
{
	struct ifc_points points = {.count = 0};
	double before = shaper->reach;
	enum ifc_outcome outcome;

	shaper->reach += reach;
	outcome = fillet_points(shaper, path, radius, &points);
	shaper->reach = before;
	if (!outcome)
		outcome = ifc_path_along(shaper, &points, path);
	array_release(&points);
	return outcome;
}

/* ---- disks --------------------------------------------------------------- */

/* A ring of the section; the outer and the inner one have as many points. */
static enum ifc_outcome
circle_points(struct ifc_shaper *shaper, double radius, size_t count,
	bool inner, struct ifc_faces *out)
{
	enum ifc_outcome outcome = ifc_points_room(shaper, &out->points, count);

	for (size_t i = 0; i < count && !outcome; i++) {
		double angle = 2 * PI * (double)i / (double)count;

		out->points.at[out->points.count++] =
			(struct tcs_point){radius * cos(angle),
				(inner ? -1 : 1) * radius * sin(angle), 0};
	}
	return outcome ? outcome : ifc_ring_end(shaper, out, NULL);
}

static enum ifc_outcome
disk_section(struct ifc_shaper *shaper, double radius, double inner,
	struct ifc_faces *out)
{
	size_t count = ifc_arc_chords(shaper, radius, 2 * PI);
	enum ifc_outcome outcome =
		circle_points(shaper, radius, count, false, out);

	if (!outcome && inner > 0)
		outcome = circle_points(shaper, inner, count, true, out);
	return outcome ? outcome : ifc_face_end(shaper, out);
}

static enum ifc_outcome
disk_path(struct ifc_shaper *shaper, uint32_t item, double radius,
	struct ifc_path *path)
{
	const struct ifc_file *file = shaper->file;
	struct step_value start = ifc_value(file, item, START);
	struct step_value end = ifc_value(file, item, END);
	struct step_value value = ifc_value(file, item, FILLET);
	enum ifc_outcome outcome;
	double fillet;

	outcome = ifc_path_read(shaper, ifc_target(file, item, DIRECTRIX),
		&start, &end, radius, path);
	if (!outcome && ifc_is_kind(file, item, IFC_SWEPTDISKSOLIDPOLYGONAL) &&
		step_number(&value, &fillet) && fillet > shaper->precision)
		outcome = path_fillet(shaper, fillet, radius, path);
	if (!outcome)
		ifc_path_carry(path);
	return outcome;
}

enum ifc_outcome
ifc_swept_disk(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value value = ifc_value(file, item, RADIUS);
	struct step_value inside = ifc_value(file, item, INNER_RADIUS);
	struct ifc_faces section = {.points = {.count = 0}};
	struct ifc_path path = {.closed = false};
	double radius, inner = 0;
	enum ifc_outcome outcome;

	if (!step_number(&value, &radius) || !(radius > 0) ||
		(step_number(&inside, &inner) &&
			!(inner >= 0 && inner < radius)))
		return ifc_refuse(shaper, item, "a disk's radius is bad");
	outcome = disk_path(shaper, item, radius, &path);
	if (!outcome)
		outcome = disk_section(shaper, radius, inner, &section);
	if (!outcome)
		outcome = ifc_sweep_along(shaper, &section, &path, out);
	ifc_faces_release(&section);
	ifc_path_release(&path);
	return outcome;
}
