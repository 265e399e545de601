#include <math.h>

#include "ifc_curve.h"
#include "ifc_profile.h"

static const double PI = 3.14159265358979323846;

/* Positions behind those of IfcParameterizedProfileDef. */
enum { FIRST = 3, SECOND, THIRD, FOURTH, FIFTH };

bool
ifc_profile_number(const struct ifc_file *file, uint32_t profile, int position,
	double *out)
{
	struct step_value value = ifc_value(file, profile, position);
	double read;

	if (!step_number(&value, &read) || !(read >= 0))
		return false;
	*out = read;
	return true;
}

/* ---- corners ------------------------------------------------------------- */

struct edge {
	double x, y, length; /* x and y are a unit vector */
};

static struct edge
edge_from(const struct ifc_corner *a, const struct ifc_corner *b)
{
	struct edge edge = {b->x - a->x, b->y - a->y, 0};

	edge.length = hypot(edge.x, edge.y);
	if (edge.length > 0) {
		edge.x /= edge.length;
		edge.y /= edge.length;
	}
	return edge;
}

/* How far an edge's ends are cut back where a corner is round. */
static double
corner_cut(const struct ifc_corner *before, const struct ifc_corner *corner,
	const struct ifc_corner *behind)
{
	struct edge in = edge_from(before, corner);
	struct edge on = edge_from(corner, behind);
	double across = fabs(in.x * on.y - in.y * on.x);
	double ahead = in.x * on.x + in.y * on.y;

	return across > 0 ? corner->radius * across / (1 + ahead) : 0;
}

/* The factor by which the cuts at both ends fit an edge. */
static double
cuts_fit(double length, double cut, double other)
{
	return cut + other > length ? length / (cut + other) : 1;
}

/* The corner at[2], rounded, between two before and two behind it. */
static enum ifc_outcome
corner_points(struct ifc_shaper *shaper, const struct ifc_corner *const at[5],
	struct ifc_points *out)
{
	const struct ifc_corner *corner = at[2];
	struct edge in = edge_from(at[1], corner);
	struct edge on = edge_from(corner, at[3]);
	double turn =
		atan2(in.x * on.y - in.y * on.x, in.x * on.x + in.y * on.y);
	double cut = corner_cut(at[1], corner, at[3]);
	double fit = fmin(
		cuts_fit(in.length, cut, corner_cut(at[0], at[1], corner)),
		cuts_fit(on.length, cut, corner_cut(corner, at[3], at[4])));
	double radius = corner->radius * fit, side, start;
	struct ifc_conic arc;

	cut *= fit;
	if (!(radius > shaper->precision) || !(cut > shaper->precision))
		return ifc_point_add(shaper, out,
			(struct tcs_point){corner->x, corner->y, 0});
	side = turn > 0 ? 1 : -1;
	arc.at = ifc_identity;
	arc.a = arc.b = radius;
	arc.at.at[3] = corner->x - cut * in.x - side * radius * in.y;
	arc.at.at[7] = corner->y - cut * in.y + side * radius * in.x;
	start = atan2(-side * in.x, side * in.y);
	return ifc_arc_points(shaper, &arc, start, start + turn, out);
}

enum ifc_outcome
ifc_corners_ring(struct ifc_shaper *shaper, const struct ifc_corner *corners,
	size_t count, struct ifc_faces *out)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < count && !outcome; i++)
		outcome = corner_points(shaper,
			(const struct ifc_corner *[]){
				corners + (i + count - 2) % count,
				corners + (i + count - 1) % count, corners + i,
				corners + (i + 1) % count,
				corners + (i + 2) % count},
			&out->points);
	return outcome ? outcome : ifc_ring_end(shaper, out, NULL);
}

/* ---- the profiles -------------------------------------------------------- */

static enum ifc_outcome
rectangle_ring(struct ifc_shaper *shaper, double x, double y, double radius,
	struct ifc_faces *out)
{
	const struct ifc_corner corners[4] = {{-x / 2, -y / 2, radius},
		{x / 2, -y / 2, radius}, {x / 2, y / 2, radius},
		{-x / 2, y / 2, radius}};

	return ifc_corners_ring(shaper, corners, 4, out);
}

static enum ifc_outcome
rectangle(struct ifc_shaper *shaper, uint32_t profile, enum ifc_entity entity,
	struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	double x = 0, y = 0, wall = 0, inner = 0, outer = 0;
	enum ifc_outcome outcome;

	if (!ifc_profile_number(file, profile, FIRST, &x) ||
		!ifc_profile_number(file, profile, SECOND, &y) || !(x > 0) ||
		!(y > 0))
		return ifc_refuse(
			shaper, profile, "a profile's size is not positive");
	if (entity == IFC_ROUNDEDRECTANGLEPROFILEDEF)
		ifc_profile_number(file, profile, THIRD, &outer);
	if (entity != IFC_RECTANGLEHOLLOWPROFILEDEF)
		return rectangle_ring(shaper, x, y, outer, out);
	if (!ifc_profile_number(file, profile, THIRD, &wall) || !(wall > 0) ||
		!(2 * wall < fmin(x, y)))
		return ifc_refuse(
			shaper, profile, "a wall's thickness does not fit");
	ifc_profile_number(file, profile, FOURTH, &inner);
	ifc_profile_number(file, profile, FIFTH, &outer);
	outcome = rectangle_ring(shaper, x, y, outer, out);
	return outcome ? outcome
		       : rectangle_ring(shaper, x - 2 * wall, y - 2 * wall,
				 inner, out);
}

static enum ifc_outcome
ellipse_ring(
	struct ifc_shaper *shaper, double a, double b, struct ifc_faces *out)
{
	const struct ifc_conic conic = {ifc_identity, a, b};
	enum ifc_outcome outcome =
		ifc_arc_points(shaper, &conic, 0, 2 * PI, &out->points);

	if (outcome)
		return outcome;
	out->points.count--;
	return ifc_ring_end(shaper, out, NULL);
}

static enum ifc_outcome
circle(struct ifc_shaper *shaper, uint32_t profile, enum ifc_entity entity,
	struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	double a = 0, b = 0, wall = 0;
	enum ifc_outcome outcome;

	if (!ifc_profile_number(file, profile, FIRST, &a) || !(a > 0) ||
		(entity == IFC_ELLIPSEPROFILEDEF &&
			(!ifc_profile_number(file, profile, SECOND, &b) ||
				!(b > 0))))
		return ifc_refuse(shaper, profile, "a radius is not positive");
	if (entity == IFC_ELLIPSEPROFILEDEF)
		return ellipse_ring(shaper, a, b, out);
	outcome = ellipse_ring(shaper, a, a, out);
	if (outcome || entity != IFC_CIRCLEHOLLOWPROFILEDEF)
		return outcome;
	if (!ifc_profile_number(file, profile, SECOND, &wall) || !(wall > 0) ||
		wall > a)
		return ifc_refuse(
			shaper, profile, "a wall's thickness does not fit");
	return wall < a ? ellipse_ring(shaper, a - wall, a - wall, out)
			: IFC_SHAPED;
}

static enum ifc_outcome
trapezium(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	const struct ifc_file *file = shaper->file;
	struct step_value value = ifc_value(file, profile, FOURTH);
	double bottom, top, y, offset;

	if (!ifc_profile_number(file, profile, FIRST, &bottom) ||
		!ifc_profile_number(file, profile, SECOND, &top) ||
		!ifc_profile_number(file, profile, THIRD, &y) ||
		!step_number(&value, &offset) || !(y > 0) ||
		!(bottom + top > 0))
		return ifc_refuse(
			shaper, profile, "a profile's size is not positive");
	return ifc_corners_ring(shaper,
		(struct ifc_corner[]){{-bottom / 2, -y / 2, 0},
			{bottom / 2, -y / 2, 0},
			{-bottom / 2 + offset + top, y / 2, 0},
			{-bottom / 2 + offset, y / 2, 0}},
		4, out);
}

enum ifc_outcome
ifc_profile_plain(
	struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	enum ifc_entity entity = ifc_entity_of(shaper->file, profile);

	switch (entity) {
	case IFC_RECTANGLEPROFILEDEF:
	case IFC_RECTANGLEHOLLOWPROFILEDEF:
	case IFC_ROUNDEDRECTANGLEPROFILEDEF:
		return rectangle(shaper, profile, entity, out);
	case IFC_CIRCLEPROFILEDEF:
	case IFC_CIRCLEHOLLOWPROFILEDEF:
	case IFC_ELLIPSEPROFILEDEF:
		return circle(shaper, profile, entity, out);
	case IFC_TRAPEZIUMPROFILEDEF:
		return trapezium(shaper, profile, out);
	default:
		return ifc_profile_steel(shaper, profile, out);
	}
}
