#include "town.h"

#include <math.h>

/* ---- the bridge ---- */

enum { ARCH = 8, BRIDGE = 1 + 2 * (ARCH + 1) + 1 + 5 };

struct outline {
	size_t count;
	double at[BRIDGE][2];
	enum face_class classes[BRIDGE];
};

static void
outline_add(struct outline *outline, double v, double z, enum face_class class)
{
	outline->at[outline->count][0] = v;
	outline->at[outline->count][1] = z;
	outline->classes[outline->count++] = class;
}

static void
arch_add(struct outline *outline, double from, double to)
{
	for (size_t i = 0; i <= ARCH; i++) {
		double part = (double)i / ARCH;
		double z = -3 + 2.6 * sin(part * acos(-1));

		if (i == 0)
			outline_add(outline, from, -4, FACE_WALL);
		else if (i == ARCH)
			outline_add(outline, to, -4, FACE_GROUND);
		else
			outline_add(outline, from + part * (to - from), z,
				i + 1 < ARCH ? FACE_EAVES : FACE_WALL);
	}
}

/*
 * The side of a stone bridge with two arches, counterclockwise seen from the
 * east: v runs north from the south bank, 34 m long.
 */
static void
bridge_outline(struct outline *outline)
{
	static const double deck[][2] = {
		{34, 0.1}, {26, 0.5}, {17, 0.8}, {8, 0.5}, {0, 0.1}};

	outline->count = 0;
	outline_add(outline, 0, -4, FACE_GROUND);
	arch_add(outline, 1.5, 16);
	arch_add(outline, 18, 32.5);
	outline_add(outline, 34, -4, FACE_WALL);
	for (size_t i = 0; i < 5; i++)
		outline_add(outline, deck[i][0], deck[i][1],
			i < 4 ? FACE_DECK : FACE_WALL);
}

static void
raise_bridge(struct shape *shape, double x)
{
	struct outline outline;

	bridge_outline(&outline);
	shape_begin(shape, town_frame(x, RIVER_SOUTH - 2, 0));
	shape_extrude(shape, (const double(*)[2])outline.at, outline.classes,
		outline.count, -4.5, 4.5);
}

static void
railing_write(struct town *town, double x, double side)
{
	struct gml *gml = town->gml;
	const char *property = gml_name(
		gml, "brid:outerBridgeInstallation", "brid:bridgeInstallation");

	shape_begin(&town->shapes[1], town_frame(x, RIVER_SOUTH - 2, 0));
	shape_box(&town->shapes[1], (struct local){side - 0.15, 8, 0.5},
		(struct local){side + 0.15, 26, 1.7});
	gml_open(gml, property, NULL);
	gml_open(gml, "brid:BridgeInstallation",
		side < 0 ? "Bridge_west" : "Bridge_east");
	if (gml->version < 3)
		gml_code(gml, "brid:function", "1010");
	gml_solid(gml, gml_name(gml, "brid:lod2Geometry", "core:lod2Solid"),
		&town->shapes[1]);
	if (gml->version == 3)
		gml_code(gml, "brid:function", "1010");
	gml_close(gml, "brid:BridgeInstallation");
	gml_close(gml, property);
}

/* The stone that parts the water in front of the pier. */
static void
cutwater_write(struct town *town, double x)
{
	static const double outline[][2] = {{-4.5, 16}, {-4.5, 18}, {-6, 17}};
	struct gml *gml = town->gml;
	const char *property = gml_name(gml, "brid:outerBridgeConstruction",
		"brid:bridgeConstructiveElement");
	const char *name = gml_name(gml, "brid:BridgeConstructionElement",
		"brid:BridgeConstructiveElement");

	shape_begin(&town->shapes[1], town_frame(x, RIVER_SOUTH - 2, 0));
	shape_block(&town->shapes[1], outline, 3, -4, -0.6);
	gml_open(gml, property, NULL);
	gml_open(gml, name, "Bridge_cutwater");
	if (gml->version < 3)
		gml_code(gml, "brid:function", "1050");
	gml_solid(gml, gml_name(gml, "brid:lod2Geometry", "core:lod2Solid"),
		&town->shapes[1]);
	if (gml->version == 3)
		gml_code(gml, "brid:function", "1050");
	gml_close(gml, name);
	gml_close(gml, property);
}

void
bridge_write(struct town *town, double x)
{
	struct gml *gml = town->gml;
	const struct shape *shape = &town->shapes[0];

	if (gml->version == 1)
		return;
	raise_bridge(&town->shapes[0], x);
	gml_member_open(gml, "brid:Bridge", "Bridge");
	gml_leaf(gml, "gml:name", "Alte Wehrbrücke");
	if (gml->version == 2) {
		gml_code(gml, "brid:class", "1000");
		gml_code(gml, "brid:function", "1010");
		gml_leaf(gml, "brid:yearOfConstruction", "1764");
		gml_leaf(gml, "brid:isMovable", "false");
		gml_bounded_solid(gml, "brid", "Bridge", shape);
		cutwater_write(town, x);
		railing_write(town, x, -4.35);
		railing_write(town, x, 4.35);
		gml_bounding(gml, "brid", "Bridge", shape);
	} else {
		gml_bounding(gml, "brid", "Bridge", shape);
		gml_bounded_solid(gml, "brid", "Bridge", shape);
		gml_leaf(gml, "con:dateOfConstruction", "1764-01-01");
		gml_code(gml, "brid:class", "1000");
		gml_code(gml, "brid:function", "1010");
		gml_leaf(gml, "brid:isMovable", "false");
		cutwater_write(town, x);
		railing_write(town, x, -4.35);
		railing_write(town, x, 4.35);
	}
	gml_member_close(gml, "brid:Bridge");
}

/* ---- the tunnel ---- */

enum { VAULT = 7 };

/* A horseshoe: upright to height h, then half a circle of radius r. */
static void
horseshoe(double out[VAULT + 2][2], double r, double foot, double h)
{
	out[0][0] = -r;
	out[0][1] = foot;
	out[1][0] = r;
	out[1][1] = foot;
	for (size_t i = 0; i < VAULT; i++) {
		double angle = (double)i / (VAULT - 1) * acos(-1);

		out[i + 2][0] = r * cos(angle);
		out[i + 2][1] = h + r * sin(angle);
	}
}

static void
tube_quad(struct shape *shape, enum face_class class, const double a[2],
	const double b[2], double u0, double u1)
{
	shape_polygon(shape, class,
		(struct local[]){{u0, a[0], a[1]}, {u0, b[0], b[1]},
			{u1, b[0], b[1]}, {u1, a[0], a[1]}},
		4);
}

static enum face_class
tube_class(size_t edge, bool inside)
{
	if (edge == 0)
		return inside ? FACE_DECK : FACE_GROUND;
	if (edge == 1 || edge == VAULT + 1)
		return FACE_WALL;
	return inside ? FACE_EAVES : FACE_ROOF;
}

/* The portal at u: the ring of stone around the opening. */
static void
portal(struct shape *shape, double (*outer)[2], double (*inner)[2], double u,
	bool east)
{
	size_t count = VAULT + 2;

	shape_face(shape, FACE_WALL);
	for (size_t i = 0; i < count; i++) {
		size_t at = east ? i : count - 1 - i;

		shape_point(shape, u, outer[at][0], outer[at][1]);
	}
	shape_hole(shape);
	for (size_t i = 0; i < count; i++) {
		size_t at = east ? count - 1 - i : i;

		shape_point(shape, u, inner[at][0], inner[at][1]);
	}
}

static void
raise_tunnel(struct shape *shape, double x0, double x1)
{
	double outer[VAULT + 2][2], inner[VAULT + 2][2];
	size_t count = VAULT + 2;

	shape_begin(shape, town_frame(0, RAILWAY, 0));
	horseshoe(outer, 6, -1, 2);
	horseshoe(inner, 5, 0.05, 2);
	for (size_t i = 0; i < count; i++) {
		size_t next = (i + 1) % count;

		tube_quad(shape, tube_class(i, false), outer[i], outer[next],
			x0, x1);
		tube_quad(shape, tube_class(i, true), inner[next], inner[i], x0,
			x1);
	}
	portal(shape, outer, inner, x0, false);
	portal(shape, outer, inner, x1, true);
}

static void
raise_hollow(struct shape *shape, double x0, double x1)
{
	double inner[VAULT + 2][2];
	enum face_class classes[VAULT + 2];

	horseshoe(inner, 5, 0.05, 2);
	for (size_t i = 0; i < VAULT + 2; i++)
		classes[i] = i == 0		   ? FACE_FLOOR
			: i == 1 || i == VAULT + 1 ? FACE_INNER_WALL
						   : FACE_CEILING;
	shape_begin(shape, town_frame(0, RAILWAY, 0));
	shape_extrude(
		shape, (const double(*)[2])inner, classes, VAULT + 2, x0, x1);
	for (size_t i = VAULT + 2; i < shape->face_count; i++)
		shape->faces[i].class = FACE_CLOSURE;
}

/* The space inside: LOD4 in 2.0, LOD3 in 3.0. */
static void
hollow_write(struct town *town, double x0, double x1)
{
	struct gml *gml = town->gml;
	const char *property =
		gml_name(gml, "tun:interiorHollowSpace", "tun:hollowSpace");

	if (!gml->lods[gml->version == 3 ? 3 : 4])
		return;
	raise_hollow(&town->shapes[1], x0, x1);
	gml_open(gml, property, NULL);
	gml_open(gml, "tun:HollowSpace", "Tunnel_hollow");
	if (gml->version < 3)
		gml_code(gml, "tun:function", "1000");
	gml_solid(gml, gml_lod_name(gml, "tun", 4, "Solid").text,
		&town->shapes[1]);
	if (gml->version == 3)
		gml_code(gml, "tun:function", "1000");
	gml_close(gml, "tun:HollowSpace");
	gml_close(gml, property);
}

void
tunnel_write(struct town *town, double x0, double x1)
{
	struct gml *gml = town->gml;
	const struct shape *shape = &town->shapes[0];

	if (gml->version == 1)
		return;
	raise_tunnel(&town->shapes[0], x0, x1);
	gml_member_open(gml, "tun:Tunnel", "Tunnel");
	gml_leaf(gml, "gml:name", "Hölltunnel");
	if (gml->version == 2) {
		gml_code(gml, "tun:function", "1030");
		gml_leaf(gml, "tun:yearOfConstruction", "1871");
		gml_bounded_solid(gml, "tun", "Tunnel", shape);
		gml_bounding(gml, "tun", "Tunnel", shape);
		hollow_write(town, x0, x1);
	} else {
		gml_bounding(gml, "tun", "Tunnel", shape);
		gml_bounded_solid(gml, "tun", "Tunnel", shape);
		gml_leaf(gml, "con:dateOfConstruction", "1871-01-01");
		gml_code(gml, "tun:function", "1030");
		hollow_write(town, x0, x1);
	}
	gml_member_close(gml, "tun:Tunnel");
}
