#include <math.h>

#include "ifc_profile.h"

static const double PI = 3.14159265358979323846;

/* A line of the plane: through (x, y), along (dx, dy). */
struct line {
	double x, y, dx, dy;
};

/* What one flange, or leg, is like. */
struct flange {
	double width; /* half of it, or all of a leg */
	double thickness;
	double fillet; /* radius where it meets the web */
	double edge; /* radius of its edge */
	double rise; /* tangent of its slope: thicker towards the web */
};

/* A number by its name: 0 when it is not there, not finite or negative. */
static double
number(const struct ifc_shaper *shaper, uint32_t profile, const char *name)
{
	const struct ifc_file *file = shaper->file;
	int position = ifc_attribute(
		file->version, ifc_entity_of(file, profile), name);
	double out = 0;

	if (position != IFC_NO_POSITION &&
		!ifc_profile_number(file, profile, position, &out))
		out = 0;
	return isfinite(out) ? out : 0;
}

/* The tangent of a slope; not a number for one beyond the upright. */
static double
rise(const struct ifc_shaper *shaper, uint32_t profile, const char *name)
{
	double angle = number(shaper, profile, name) * shaper->angle;

	return angle < PI / 2 ? tan(angle) : NAN;
}

static enum ifc_outcome
misfit(struct ifc_shaper *shaper, uint32_t profile)
{
	return ifc_refuse(shaper, profile, "a profile's sizes do not fit");
}

/* Where two lines meet, as a rounded corner. */
static struct ifc_corner
meeting(struct line a, struct line b, double radius)
{
	double across = a.dx * b.dy - a.dy * b.dx;
	double part = ((b.x - a.x) * b.dy - (b.y - a.y) * b.dx) / across;

	return (struct ifc_corner){
		a.x + part * a.dx, a.y + part * a.dy, radius};
}

/* ---- I ------------------------------------------------------------------- */

/*
 * How thick a flange is at x: as said a quarter of its full width from its
 * edge (DIN 1025-1).
 */
static double
flange_inside(const struct flange *flange, double x)
{
	return flange->thickness + (flange->width / 2 - x) * flange->rise;
}

static enum ifc_outcome
i_ring(struct ifc_shaper *shaper, uint32_t profile, const struct flange *bottom,
	const struct flange *top, double depth, double web,
	struct ifc_faces *out)
{
	double y = depth / 2, x = web / 2;
	double low_edge = -y + flange_inside(bottom, bottom->width);
	double low = -y + flange_inside(bottom, x);
	double high_edge = y - flange_inside(top, top->width);
	double high = y - flange_inside(top, x);
	const struct ifc_corner corners[] = {
		{-bottom->width, -y, 0},
		{bottom->width, -y, 0},
		{bottom->width, low_edge, bottom->edge},
		{x, low, bottom->fillet},
		{x, high, top->fillet},
		{top->width, high_edge, top->edge},
		{top->width, y, 0},
		{-top->width, y, 0},
		{-top->width, high_edge, top->edge},
		{-x, high, top->fillet},
		{-x, low, bottom->fillet},
		{-bottom->width, low_edge, bottom->edge},
	};

	if (!(x > 0) || !(x < bottom->width) || !(x < top->width) ||
		!(low_edge > -y) || !(high_edge < y) || !(low < high) ||
		!(bottom->thickness > 0) || !(top->thickness > 0))
		return misfit(shaper, profile);
	return ifc_corners_ring(
		shaper, corners, sizeof corners / sizeof *corners, out);
}

static enum ifc_outcome
i_shape(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	const struct flange flange = {
		.width = number(shaper, profile, "OverallWidth") / 2,
		.thickness = number(shaper, profile, "FlangeThickness"),
		.fillet = number(shaper, profile, "FilletRadius"),
		.edge = number(shaper, profile, "FlangeEdgeRadius"),
		.rise = rise(shaper, profile, "FlangeSlope")};

	return i_ring(shaper, profile, &flange, &flange,
		number(shaper, profile, "OverallDepth"),
		number(shaper, profile, "WebThickness"), out);
}

/* A subtype of the I shape in IFC2X3, with the names of that. */
static enum ifc_outcome
asymmetric(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	bool old = shaper->file->version == IFC_2X3;
	const struct flange bottom = {
		.width = number(shaper, profile,
				 old ? "OverallWidth" : "BottomFlangeWidth") /
			2,
		.thickness = number(shaper, profile,
			old ? "FlangeThickness" : "BottomFlangeThickness"),
		.fillet = number(shaper, profile,
			old ? "FilletRadius" : "BottomFlangeFilletRadius"),
		.edge = number(shaper, profile, "BottomFlangeEdgeRadius"),
		.rise = rise(shaper, profile, "BottomFlangeSlope")};
	struct flange top = {
		.width = number(shaper, profile, "TopFlangeWidth") / 2,
		.thickness = number(shaper, profile, "TopFlangeThickness"),
		.fillet = number(shaper, profile, "TopFlangeFilletRadius"),
		.edge = number(shaper, profile, "TopFlangeEdgeRadius"),
		.rise = rise(shaper, profile, "TopFlangeSlope")};

	if (!(top.thickness > 0))
		top.thickness = bottom.thickness;
	return i_ring(shaper, profile, &bottom, &top,
		number(shaper, profile, "OverallDepth"),
		number(shaper, profile, "WebThickness"), out);
}

/* ---- L, T, U, Z, C ------------------------------------------------------- */

/* Legs are as thick as said in the middle of their length. */
static enum ifc_outcome
l_shape(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	double depth = number(shaper, profile, "Depth");
	double width = number(shaper, profile, "Width");
	double thickness = number(shaper, profile, "Thickness");
	double edge = number(shaper, profile, "EdgeRadius");
	double slope = rise(shaper, profile, "LegSlope");
	double x, y = depth / 2;
	struct line low, left;

	if (!(width > 0))
		width = depth;
	x = width / 2;
	low = (struct line){0, -y + thickness, 1, -slope};
	left = (struct line){-x + thickness, 0, -slope, 1};
	if (!(thickness > 0) || !(thickness < fmin(width, depth)) ||
		!(thickness > slope * fmax(x, y)))
		return misfit(shaper, profile);
	return ifc_corners_ring(shaper,
		(struct ifc_corner[]){{-x, -y, 0}, {x, -y, 0},
			{x, low.y - slope * x, edge},
			meeting(low, left,
				number(shaper, profile, "FilletRadius")),
			{left.x - slope * y, y, edge}, {-x, y, 0}},
		6, out);
}

/*
 * The flange is as thick as said a quarter of its width from its edge, the web
 * in the middle of the depth (DIN 1024).
 */
static enum ifc_outcome
t_shape(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	double y = number(shaper, profile, "Depth") / 2;
	double web = number(shaper, profile, "WebThickness");
	double edge = number(shaper, profile, "WebEdgeRadius");
	double slope = rise(shaper, profile, "WebSlope");
	const struct flange flange = {
		.width = number(shaper, profile, "FlangeWidth") / 2,
		.thickness = number(shaper, profile, "FlangeThickness"),
		.edge = number(shaper, profile, "FlangeEdgeRadius"),
		.rise = rise(shaper, profile, "FlangeSlope")};
	double side = y - flange_inside(&flange, flange.width);
	struct ifc_corner inner = meeting((struct line){web / 2, 0, slope, 1},
		(struct line){flange.width, side, 1, flange.rise},
		number(shaper, profile, "FilletRadius"));

	if (!(web > 2 * slope * y) || !(flange.thickness > 0) || !(side < y) ||
		!(inner.x < flange.width) || !(inner.y > -y))
		return misfit(shaper, profile);
	return ifc_corners_ring(shaper,
		(struct ifc_corner[]){{web / 2 - slope * y, -y, edge}, inner,
			{flange.width, side, flange.edge}, {flange.width, y, 0},
			{-flange.width, y, 0},
			{-flange.width, side, flange.edge},
			{-inner.x, inner.y, inner.radius},
			{-web / 2 + slope * y, -y, edge}},
		8, out);
}

/* Flanges are as thick as said in the middle of their width (DIN 1026-1). */
static enum ifc_outcome
u_shape(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	double y = number(shaper, profile, "Depth") / 2;
	double x = number(shaper, profile, "FlangeWidth") / 2;
	double web = number(shaper, profile, "WebThickness") - x;
	double thickness = number(shaper, profile, "FlangeThickness");
	double fillet = number(shaper, profile, "FilletRadius");
	double edge = number(shaper, profile, "EdgeRadius");
	double slope = rise(shaper, profile, "FlangeSlope");
	double tip = y - thickness + slope * x;
	double root = y - thickness + slope * web;

	if (!(web > -x) || !(web < x) || !(thickness > 0) || !(tip < y) ||
		!(root > 0))
		return misfit(shaper, profile);
	return ifc_corners_ring(shaper,
		(struct ifc_corner[]){{-x, -y, 0}, {x, -y, 0}, {x, -tip, edge},
			{web, -root, fillet}, {web, root, fillet},
			{x, tip, edge}, {x, y, 0}, {-x, y, 0}},
		8, out);
}

/* A flange's width includes the web's thickness (DIN 1027). */
static enum ifc_outcome
z_shape(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	double y = number(shaper, profile, "Depth") / 2;
	double web = number(shaper, profile, "WebThickness") / 2;
	double x = number(shaper, profile, "FlangeWidth") - web;
	double inside = y - number(shaper, profile, "FlangeThickness");
	double fillet = number(shaper, profile, "FilletRadius");
	double edge = number(shaper, profile, "EdgeRadius");

	if (!(web > 0) || !(web < x) || !(inside > 0) || !(inside < y))
		return misfit(shaper, profile);
	return ifc_corners_ring(shaper,
		(struct ifc_corner[]){{-web, -y, 0}, {x, -y, 0},
			{x, -inside, edge}, {web, -inside, fillet}, {web, y, 0},
			{-x, y, 0}, {-x, inside, edge}, {-web, inside, fillet}},
		8, out);
}

/*
 * Bent from a sheet: outside, the radius is larger by its thickness. A girth no
 * longer than that makes no lips.
 */
static enum ifc_outcome
c_shape(struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	double y = number(shaper, profile, "Depth") / 2;
	double x = number(shaper, profile, "Width") / 2;
	double wall = number(shaper, profile, "WallThickness");
	double girth = number(shaper, profile, "Girth");
	double in = number(shaper, profile, "InternalFilletRadius");
	double on = in > 0 ? in + wall : 0, lip = y - girth;

	if (!(wall > 0) || !(2 * wall < fmin(2 * x, 2 * y)) || !(lip > 0))
		return misfit(shaper, profile);
	if (!(girth > wall))
		return ifc_corners_ring(shaper,
			(struct ifc_corner[]){{-x, -y, on}, {x, -y, 0},
				{x, wall - y, 0}, {wall - x, wall - y, in},
				{wall - x, y - wall, in}, {x, y - wall, 0},
				{x, y, 0}, {-x, y, on}},
			8, out);
	return ifc_corners_ring(shaper,
		(struct ifc_corner[]){{-x, -y, on}, {x, -y, on}, {x, -lip, 0},
			{x - wall, -lip, 0}, {x - wall, wall - y, in},
			{wall - x, wall - y, in}, {wall - x, y - wall, in},
			{x - wall, y - wall, in}, {x - wall, lip, 0},
			{x, lip, 0}, {x, y, on}, {-x, y, on}},
		12, out);
}

enum ifc_outcome
ifc_profile_steel(
	struct ifc_shaper *shaper, uint32_t profile, struct ifc_faces *out)
{
	switch (ifc_entity_of(shaper->file, profile)) {
	case IFC_ISHAPEPROFILEDEF:
		return i_shape(shaper, profile, out);
	case IFC_ASYMMETRICISHAPEPROFILEDEF:
		return asymmetric(shaper, profile, out);
	case IFC_LSHAPEPROFILEDEF:
		return l_shape(shaper, profile, out);
	case IFC_TSHAPEPROFILEDEF:
		return t_shape(shaper, profile, out);
	case IFC_USHAPEPROFILEDEF:
		return u_shape(shaper, profile, out);
	case IFC_ZSHAPEPROFILEDEF:
		return z_shape(shaper, profile, out);
	case IFC_CSHAPEPROFILEDEF:
		return c_shape(shaper, profile, out);
	default:
		return ifc_refuse(
			shaper, profile, "a profile of this kind is not known");
	}
}
