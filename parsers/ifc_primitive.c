#include <math.h>

#include "ifc_curve.h"
#include "ifc_sweep_curve.h"

enum { POSITION, FIRST, SECOND, THIRD };

static const double PI = 3.14159265358979323846;

static enum ifc_outcome
size_read(struct ifc_shaper *shaper, uint32_t item, int position, double *out)
{
	struct step_value value = ifc_value(shaper->file, item, position);

	if (!step_number(&value, out) || !(*out > 0))
		return ifc_refuse(
			shaper, item, "a primitive's size is not positive");
	return IFC_SHAPED;
}

/* Add a section: a ring, or its middle as often as it has points. */
static enum ifc_outcome
section_add(struct ifc_shaper *shaper, const struct tcs_point *ring,
	size_t count, double scale, double z, struct ifc_points *out)
{
	enum ifc_outcome outcome = ifc_points_room(shaper, out, count);

	for (size_t i = 0; i < count && !outcome; i++)
		out->at[out->count++] = (struct tcs_point){
			ring[i].x * scale, ring[i].y * scale, z};
	return outcome;
}

/* A solid of two sections, the upper one scaled. */
static enum ifc_outcome
prismoid(struct ifc_shaper *shaper, const struct tcs_point *ring,
	uint32_t count, double scale, double height, struct ifc_faces *out)
{
	struct ifc_loft loft = {.rings = &count, .ring_count = 1};
	enum ifc_outcome outcome =
		section_add(shaper, ring, count, 1, 0, &loft.points);

	if (!outcome)
		outcome = section_add(
			shaper, ring, count, scale, height, &loft.points);
	if (!outcome)
		outcome = ifc_loft_faces(shaper, &loft, out);
	array_release(&loft.points);
	return outcome;
}

/* From the middle of its base a pyramid rises; a block stands in its corner. */
static enum ifc_outcome
block(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	bool pyramid = ifc_is_kind(shaper->file, item, IFC_RECTANGULARPYRAMID);
	double x, y, z, low_x, low_y;
	enum ifc_outcome outcome = size_read(shaper, item, FIRST, &x);

	if (!outcome)
		outcome = size_read(shaper, item, SECOND, &y);
	if (!outcome)
		outcome = size_read(shaper, item, THIRD, &z);
	if (outcome)
		return outcome;
	low_x = pyramid ? -x / 2 : 0;
	low_y = pyramid ? -y / 2 : 0;
	return prismoid(shaper,
		(struct tcs_point[]){{low_x, low_y, 0}, {low_x + x, low_y, 0},
			{low_x + x, low_y + y, 0}, {low_x, low_y + y, 0}},
		4, pyramid ? 0 : 1, z, out);
}

static enum ifc_outcome
circle_points(struct ifc_shaper *shaper, double radius, struct ifc_points *out)
{
	const struct ifc_conic circle = {ifc_identity, radius, radius};
	enum ifc_outcome outcome =
		ifc_arc_points(shaper, &circle, 0, 2 * PI, out);

	if (!outcome)
		out->count--;
	return outcome;
}

static enum ifc_outcome
cylinder(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	bool cone = ifc_is_kind(shaper->file, item, IFC_RIGHTCIRCULARCONE);
	struct ifc_points ring = {.count = 0};
	double height, radius;
	enum ifc_outcome outcome = size_read(shaper, item, FIRST, &height);

	if (!outcome)
		outcome = size_read(shaper, item, SECOND, &radius);
	if (!outcome)
		outcome = circle_points(shaper, radius, &ring);
	if (!outcome)
		outcome = prismoid(shaper, ring.at, (uint32_t)ring.count,
			cone ? 0 : 1, height, out);
	array_release(&ring);
	return outcome;
}

/* From pole to pole, in as many steps as half of a circle has chords. */
static enum ifc_outcome
sphere(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	struct ifc_points ring = {.count = 0};
	struct ifc_loft loft = {.ring_count = 1};
	double radius;
	uint32_t count;
	enum ifc_outcome outcome = size_read(shaper, item, FIRST, &radius);

	if (!outcome)
		outcome = circle_points(shaper, radius, &ring);
	count = (uint32_t)ring.count;
	loft.rings = &count;
	for (uint32_t i = 0; i <= count / 2 && !outcome; i++) {
		double angle = PI * (2. * i / count - 0.5);
		bool pole = i == 0 || i == count / 2;

		outcome = section_add(shaper, ring.at, count,
			pole ? 0 : cos(angle),
			pole ? copysign(radius, angle) : radius * sin(angle),
			&loft.points);
	}
	if (!outcome)
		outcome = ifc_loft_faces(shaper, &loft, out);
	array_release(&loft.points);
	array_release(&ring);
	return outcome;
}

enum ifc_outcome
ifc_primitive(struct ifc_shaper *shaper, uint32_t item, struct ifc_faces *out)
{
	size_t first = out->faces.count;
	enum ifc_outcome outcome;

	switch (ifc_entity_of(shaper->file, item)) {
	case IFC_BLOCK:
	case IFC_RECTANGULARPYRAMID:
		outcome = block(shaper, item, out);
		break;
	case IFC_RIGHTCIRCULARCONE:
	case IFC_RIGHTCIRCULARCYLINDER:
		outcome = cylinder(shaper, item, out);
		break;
	case IFC_SPHERE:
		outcome = sphere(shaper, item, out);
		break;
	default:
		return ifc_refuse(
			shaper, item, "a primitive of this kind is not known");
	}
	return outcome ? outcome
		       : ifc_faces_place(shaper, item, POSITION, out, first);
}
