#include <math.h>

#include "ifc_curve.h"
#include "ifc_item.h"
#include "ifc_profile.h"

enum { SWEPT_AREA, POSITION, DIRECTION, DEPTH, AXIS = 2, ANGLE = 3 };

static const double PI = 3.14159265358979323846;

static enum ifc_outcome
profile_read(struct ifc_shaper *shaper, uint32_t item)
{
	ifc_faces_clear(&shaper->scratch->profile);
	return ifc_profile_faces(shaper,
		ifc_target(shaper->file, item, SWEPT_AREA),
		&shaper->scratch->profile);
}

/* Place the faces as the solid's Position says, and turn them outwards. */
static enum ifc_outcome
solid_place(struct ifc_shaper *shaper, uint32_t item, size_t first_face,
	struct ifc_faces *out)
{
	struct step_value position = ifc_value(shaper->file, item, POSITION);
	struct ifc_matrix matrix;

	if (ifc_faces_volume6(out, first_face) < 0)
		ifc_faces_reverse(out, first_face);
	if (position.kind != STEP_REFERENCE)
		return IFC_SHAPED;
	if (!ifc_axes(shaper->file, step_target(shaper->file->step, &position),
		    &matrix))
		return ifc_refuse(shaper, item, "a position is bad");
	ifc_faces_transform(out, first_face, &matrix);
	return IFC_SHAPED;
}

/* ---- extruded ------------------------------------------------------------ */

static bool
extrusion_vector(
	const struct ifc_file *file, uint32_t item, struct tcs_point *out)
{
	struct step_value value = ifc_value(file, item, DEPTH);
	double depth, length;

	if (!step_number(&value, &depth) ||
		!ifc_triple(file, ifc_target(file, item, DIRECTION), out))
		return false;
	length = sqrt(out->x * out->x + out->y * out->y + out->z * out->z);
	if (!(length > 0) || !isfinite(depth / length) || depth == 0)
		return false;
	depth /= length;
	*out = (struct tcs_point){
		out->x * depth, out->y * depth, out->z * depth};
	return out->z != 0;
}

static struct tcs_point
plus(struct tcs_point a, struct tcs_point b)
{
	return (struct tcs_point){a.x + b.x, a.y + b.y, a.z + b.z};
}

/* The four-cornered faces along one ring. */
static enum ifc_outcome
walls(struct ifc_shaper *shaper, const struct tcs_point *ring, size_t count,
	struct tcs_point along, struct ifc_faces *out)
{
	enum ifc_outcome outcome =
		ifc_points_room(shaper, &out->points, 4 * count);

	if (outcome)
		return outcome;
	if (array_grow(&out->rings, count) || array_grow(&out->faces, count))
		return IFC_NO_MEMORY;
	for (size_t i = 0; i < count; i++) {
		struct tcs_point a = ring[i], b = ring[(i + 1) % count];
		struct tcs_point *at = out->points.at + out->points.count;

		out->faces.at[out->faces.count++] =
			(struct ifc_face){(uint32_t)out->points.count,
				(uint32_t)out->rings.count, 1, 0};
		out->rings.at[out->rings.count++] = 4;
		at[0] = a;
		at[1] = b;
		at[2] = plus(b, along);
		at[3] = plus(a, along);
		out->points.count += 4;
	}
	return IFC_SHAPED;
}

/* The profile's faces twice, at the start looking back, and at the end. */
static enum ifc_outcome
ends(struct ifc_shaper *shaper, const struct ifc_faces *profile,
	const struct ifc_matrix *to_end, struct ifc_faces *out)
{
	size_t first = out->faces.count;
	enum ifc_outcome outcome = ifc_faces_append(shaper, out, profile, 0);

	if (outcome)
		return outcome;
	ifc_faces_reverse(out, first);
	first = out->faces.count;
	outcome = ifc_faces_append(shaper, out, profile, 0);
	if (!outcome)
		ifc_faces_transform(out, first, to_end);
	return outcome;
}

static enum ifc_outcome
extrude(struct ifc_shaper *shaper, const struct ifc_faces *profile,
	struct tcs_point along, struct ifc_faces *out)
{
	const struct tcs_point *points = profile->points.at;
	struct ifc_matrix to_end = ifc_identity;
	enum ifc_outcome outcome;

	to_end.at[3] = along.x;
	to_end.at[7] = along.y;
	to_end.at[11] = along.z;
	outcome = ends(shaper, profile, &to_end, out);
	for (size_t i = 0; i < profile->rings.count && !outcome; i++) {
		outcome =
			walls(shaper, points, profile->rings.at[i], along, out);
		points += profile->rings.at[i];
	}
	return outcome;
}

enum ifc_outcome
ifc_extrusion(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	size_t first = out->faces.faces.count;
	struct tcs_point along;
	enum ifc_outcome outcome;

	if (!extrusion_vector(shaper->file, item, &along))
		return ifc_refuse(shaper, item,
			"an extrusion's depth or direction is bad");
	outcome = profile_read(shaper, item);
	if (!outcome)
		outcome = ifc_part_begin(out, IFC_PART_SOLID, item);
	if (!outcome)
		outcome = extrude(
			shaper, &shaper->scratch->profile, along, &out->faces);
	return outcome ? outcome
		       : solid_place(shaper, item, first, &out->faces);
}

/* ---- revolved ------------------------------------------------------------ */

/* About the z axis of `axis`, by an angle. */
static struct ifc_matrix
rotation(const struct ifc_matrix *axis, double angle)
{
	const double *m = axis->at;
	struct ifc_matrix back = {{m[0], m[4], m[8], 0, m[1], m[5], m[9], 0,
		m[2], m[6], m[10], 0, 0, 0, 0, 1}};
	struct ifc_matrix turn = {{cos(angle), -sin(angle), 0, 0, sin(angle),
		cos(angle), 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
	struct tcs_point origin =
		ifc_transform(&back, (struct tcs_point){-m[3], -m[7], -m[11]});

	back.at[3] = origin.x;
	back.at[7] = origin.y;
	back.at[11] = origin.z;
	turn = ifc_multiply(&turn, &back);
	return ifc_multiply(axis, &turn);
}

static double
largest_radius(const struct ifc_matrix *axis, const struct ifc_points *points)
{
	const double *m = axis->at;
	double largest = 0;

	for (size_t i = 0; i < points->count; i++) {
		struct tcs_point p = points->at[i];
		double x = p.x - m[3], y = p.y - m[7], z = p.z - m[11];
		double along = x * m[2] + y * m[6] + z * m[10];

		largest = fmax(largest,
			sqrt(fmax(0, x * x + y * y + z * z - along * along)));
	}
	return largest;
}

/* The faces between one edge of a ring and its turned self. */
static enum ifc_outcome
turned_wall(struct ifc_shaper *shaper, const struct tcs_point corners[4],
	struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t first = out->points.count;

	for (int i = 0; i < 4 && !outcome; i++) {
		if (out->points.count > first &&
			ifc_same_point(shaper, corners[i],
				out->points.at[out->points.count - 1]))
			continue;
		if (i == 3 && ifc_same_point(shaper, corners[3], corners[0]))
			continue;
		outcome = ifc_point_add(shaper, &out->points, corners[i]);
	}
	if (!outcome)
		outcome = ifc_ring_end(shaper, out, NULL);
	return outcome ? outcome : ifc_face_end(shaper, out);
}

static enum ifc_outcome
turned_walls(struct ifc_shaper *shaper, const struct ifc_faces *profile,
	const struct ifc_matrix *from, const struct ifc_matrix *to,
	struct ifc_faces *out)
{
	const struct tcs_point *ring = profile->points.at;
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < profile->rings.count; i++) {
		size_t count = profile->rings.at[i];

		for (size_t k = 0; k < count && !outcome; k++) {
			struct tcs_point a = ring[k], b = ring[(k + 1) % count];

			outcome = turned_wall(shaper,
				(struct tcs_point[]){ifc_transform(from, a),
					ifc_transform(from, b),
					ifc_transform(to, b),
					ifc_transform(to, a)},
				out);
		}
		ring += count;
	}
	return outcome;
}

static enum ifc_outcome
revolve(struct ifc_shaper *shaper, const struct ifc_faces *profile,
	const struct ifc_matrix *axis, double angle, struct ifc_faces *out)
{
	bool full = fabs(angle) >= 2 * PI - 1e-9;
	double radius = largest_radius(axis, &profile->points);
	struct ifc_matrix last, from, to = ifc_identity;
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t count;

	if (full)
		angle = 2 * PI;
	count = ifc_arc_chords(shaper, radius, angle);
	last = full ? ifc_identity : rotation(axis, angle);
	if (!full)
		outcome = ends(shaper, profile, &last, out);
	for (size_t i = 1; i <= count && !outcome; i++) {
		from = to;
		to = i < count
			? rotation(axis, angle * (double)i / (double)count)
			: last;
		outcome = turned_walls(shaper, profile, &from, &to, out);
	}
	return outcome;
}

enum ifc_outcome
ifc_revolution(struct ifc_shaper *shaper, uint32_t item, struct ifc_body *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value value = ifc_value(file, item, ANGLE);
	size_t first = out->faces.faces.count;
	struct ifc_matrix axis;
	enum ifc_outcome outcome;
	double angle;

	if (!ifc_axes(file, ifc_target(file, item, AXIS), &axis) ||
		!step_number(&value, &angle) || angle == 0)
		return ifc_refuse(
			shaper, item, "a revolution's axis or angle is bad");
	outcome = profile_read(shaper, item);
	if (!outcome)
		outcome = ifc_part_begin(out, IFC_PART_SOLID, item);
	if (!outcome)
		outcome = revolve(shaper, &shaper->scratch->profile, &axis,
			angle * shaper->angle, &out->faces);
	return outcome ? outcome
		       : solid_place(shaper, item, first, &out->faces);
}
