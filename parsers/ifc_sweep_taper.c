#include <math.h>

#include "ifc_curve.h"
#include "ifc_profile.h"
#include "ifc_sweep_curve.h"
#include "solid_points.h"

enum { SWEPT_AREA, POSITION, DIRECTION, DEPTH, END_AREA };

enum { AXIS = 2, ANGLE = 3 };

static const double PI = 3.14159265358979323846;

/* How a section moves: turned about an axis, or pushed along. */
struct motion {
	struct ifc_matrix axis; /* its z axis */
	double angle; /* radians; 0: pushed along */
	struct tcs_point along;
};

static struct tcs_point
between(struct tcs_point a, struct tcs_point b, double part)
{
	return (struct tcs_point){a.x + part * (b.x - a.x),
		a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)};
}

/* A point turned about the axis by a part of the angle. */
static struct tcs_point
turned(const struct motion *motion, struct tcs_point point, double part)
{
	const double *m = motion->axis.at;
	struct tcs_point origin = {m[3], m[7], m[11]};
	struct tcs_point axis = {m[2], m[6], m[10]};
	struct tcs_point off = point_minus(point, origin), side;
	double high = point_dot(off, axis), angle = part * motion->angle;
	double c = cos(angle), s = sin(angle);

	off = point_minus(off,
		(struct tcs_point){
			high * axis.x, high * axis.y, high * axis.z});
	side = point_cross(axis, off);
	return (struct tcs_point){
		origin.x + high * axis.x + c * off.x + s * side.x,
		origin.y + high * axis.y + c * off.y + s * side.y,
		origin.z + high * axis.z + c * off.z + s * side.z};
}

static struct tcs_point
moved(const struct motion *motion, struct tcs_point point, double part)
{
	if (motion->angle != 0)
		return part > 0 ? turned(motion, point, part) : point;
	return (struct tcs_point){point.x + part * motion->along.x,
		point.y + part * motion->along.y,
		point.z + part * motion->along.z};
}

static enum ifc_outcome
extrusion_read(struct ifc_shaper *shaper, uint32_t item, struct motion *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value value = ifc_value(file, item, DEPTH);
	struct tcs_point along;
	double depth, length;

	if (!step_number(&value, &depth) || depth == 0 ||
		!ifc_triple(file, ifc_target(file, item, DIRECTION), &along) ||
		along.z == 0)
		return ifc_refuse(shaper, item,
			"an extrusion's depth or direction is bad");
	length = sqrt(point_dot(along, along));
	*out = (struct motion){.along = between((struct tcs_point){0, 0, 0},
				       along, depth / length)};
	return IFC_SHAPED;
}

static enum ifc_outcome
revolution_read(struct ifc_shaper *shaper, uint32_t item, struct motion *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value value = ifc_value(file, item, ANGLE);

	*out = (struct motion){.angle = 0};
	if (!step_number(&value, &out->angle) || out->angle == 0 ||
		!ifc_axes(file, ifc_target(file, item, AXIS), &out->axis))
		return ifc_refuse(
			shaper, item, "a revolution's axis or angle is bad");
	out->angle *= shaper->angle;
	if (fabs(out->angle) > 2 * PI)
		out->angle = copysign(2 * PI, out->angle);
	return IFC_SHAPED;
}

static double
radius_of(const struct motion *motion, const struct ifc_points *points)
{
	const double *m = motion->axis.at;
	struct tcs_point origin = {m[3], m[7], m[11]};
	struct tcs_point axis = {m[2], m[6], m[10]};
	double radius = 0;

	for (size_t i = 0; i < points->count; i++) {
		struct tcs_point off =
			point_cross(axis, point_minus(points->at[i], origin));

		radius = fmax(radius, sqrt(point_dot(off, off)));
	}
	return radius;
}

static size_t
steps_of(const struct ifc_shaper *shaper, const struct motion *motion,
	const struct ifc_faces *a, const struct ifc_faces *b)
{
	return motion->angle == 0
		? 1
		: ifc_arc_chords(shaper,
			  fmax(radius_of(motion, &a->points),
				  radius_of(motion, &b->points)),
			  motion->angle);
}

static enum ifc_outcome
face_between(struct ifc_shaper *shaper, const struct motion *motion,
	size_t steps, const struct ifc_faces *a, const struct ifc_faces *b,
	size_t face, struct ifc_faces *out)
{
	const struct ifc_face *from = a->faces.at + face;
	const struct tcs_point *at_a = a->points.at + from->first_point;
	const struct tcs_point *at_b =
		b->points.at + b->faces.at[face].first_point;
	size_t size = ifc_face_points(a, from);
	struct ifc_loft loft = {.rings = a->rings.at + from->first_ring,
		.ring_count = from->ring_count};
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i <= steps && !outcome; i++) {
		double part = (double)i / (double)steps;

		outcome = ifc_points_room(shaper, &loft.points, size);
		for (size_t k = 0; k < size && !outcome; k++)
			loft.points.at[loft.points.count++] = moved(
				motion, between(at_a[k], at_b[k], part), part);
	}
	if (!outcome)
		outcome = ifc_loft_faces(shaper, &loft, out);
	array_release(&loft.points);
	return outcome;
}

enum ifc_outcome
ifc_tapered(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct ifc_faces a = {.points = {.count = 0}};
	struct ifc_faces b = {.points = {.count = 0}};
	size_t first = out->faces.count, steps = 0;
	struct motion motion;
	enum ifc_outcome outcome;

	outcome = ifc_is_kind(file, item, IFC_REVOLVEDAREASOLID)
		? revolution_read(shaper, item, &motion)
		: extrusion_read(shaper, item, &motion);
	if (!outcome)
		outcome = ifc_profile_faces(
			shaper, ifc_target(file, item, SWEPT_AREA), &a);
	if (!outcome)
		outcome = ifc_profile_faces(
			shaper, ifc_target(file, item, END_AREA), &b);
	if (!outcome)
		outcome = ifc_loft_match(shaper, item, &a, &b);
	if (!outcome)
		steps = steps_of(shaper, &motion, &a, &b);
	for (size_t i = 0; i < a.faces.count && !outcome; i++)
		outcome = face_between(shaper, &motion, steps, &a, &b, i, out);
	if (!outcome)
		outcome = ifc_faces_place(shaper, item, POSITION, out, first);
	ifc_faces_release(&a);
	ifc_faces_release(&b);
	return outcome;
}
