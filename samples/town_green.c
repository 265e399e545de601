#include "town.h"

#include <math.h>
#include <string.h>

/* ---- shapes that are turned around an axis ---- */

enum { SEGMENTS = 8 };

static void
turned_point(struct shape *shape, const double ring[2], size_t segment)
{
	double angle = (double)segment * 2 * acos(-1) / SEGMENTS;

	shape_point(shape, ring[0] * cos(angle), ring[0] * sin(angle), ring[1]);
}

/* Closed below and above; rings of (radius, height) from below. */
static void
turn(struct shape *shape, const double (*rings)[2], size_t count)
{
	shape_face(shape, FACE_GROUND);
	for (size_t i = SEGMENTS; i-- > 0;)
		turned_point(shape, rings[0], i);
	for (size_t r = 0; r + 1 < count; r++) {
		for (size_t i = 0; i < SEGMENTS; i++) {
			shape_face(shape, FACE_WALL);
			turned_point(shape, rings[r], i);
			turned_point(shape, rings[r], i + 1);
			turned_point(shape, rings[r + 1], i + 1);
			turned_point(shape, rings[r + 1], i);
		}
	}
	shape_face(shape, FACE_ROOF);
	for (size_t i = 0; i < SEGMENTS; i++)
		turned_point(shape, rings[count - 1], i);
}

static void
raise_tree(struct shape *shape, unsigned species)
{
	static const double trunk[][2] = {{0.25, 0}, {0.2, 2.6}};
	static const double broad[][2] = {
		{1.1, 2.6}, {2.8, 4.2}, {3, 5.8}, {2.1, 7.6}, {0.6, 8.6}};
	static const double slim[][2] = {
		{0.5, 2.6}, {1.2, 4}, {1.3, 7}, {0.9, 10.5}, {0.15, 12.5}};

	turn(shape, trunk, 2);
	turn(shape, species == 0 ? broad : slim, 5);
}

static void
raise_fitting(struct shape *shape, enum fitting kind)
{
	static const double post[][2] = {{0.1, 0}, {0.06, 4.4}};
	static const double lantern[][2] = {
		{0.12, 4.4}, {0.34, 4.9}, {0.05, 5.2}};
	static const double basin[][2] = {{2, 0}, {2, 0.6}, {0.5, 0.6},
		{0.35, 2.1}, {0.8, 2.3}, {0.1, 2.8}};

	switch (kind) {
	case FITTING_LAMP:
		turn(shape, post, 2);
		turn(shape, lantern, 3);
		break;
	case FITTING_BENCH:
		shape_box(shape, (struct local){-0.9, -0.25, 0.4},
			(struct local){0.9, 0.25, 0.5});
		shape_box(shape, (struct local){-0.7, -0.2, 0},
			(struct local){-0.6, 0.2, 0.4});
		shape_box(shape, (struct local){0.6, -0.2, 0},
			(struct local){0.7, 0.2, 0.4});
		break;
	case FITTING_FOUNTAIN:
		turn(shape, basin, 6);
		break;
	}
}

/* ---- prototypes ---- */

/* An id that all towns share: the prototype of a tree or fitting. */
static void
prototype_write(struct town *town, const char *id, bool first)
{
	struct gml *gml = town->gml;
	const char *property = gml_name(
		gml, "core:relativeGMLGeometry", "core:relativeGeometry");

	if (!first) {
		gml_link(gml, property, id);
		return;
	}
	gml_open(gml, property, NULL);
	gml_open(gml, "gml:MultiSurface", id);
	gml_members(gml, &town->shapes[0], 0, town->shapes[0].face_count);
	gml_close(gml, "gml:MultiSurface");
	gml_close(gml, property);
}

/* Prototype `id`, in shapes[0] for its first use, at a place, scaled. */
static void
implicit_write(struct town *town, const char *module, const char *id,
	bool first, struct spot spot, unsigned percent)
{
	struct gml *gml = town->gml;
	struct lod_name lod =
		gml_lod_name(gml, module, 2, "ImplicitRepresentation");
	char text[128], scale[16], fresh[GML_ID];

	snprintf(scale, sizeof scale, "%u.%02u", percent / 100, percent % 100);
	snprintf(text, sizeof text, "%s 0 0 0 0 %s 0 0 0 0 %s 0 0 0 0 1", scale,
		scale, scale);
	gml_open(gml, lod.text, NULL);
	gml_fresh_id(gml, fresh);
	gml_open(gml, "core:ImplicitGeometry", fresh);
	gml_leaf(gml, "core:transformationMatrix", text);
	if (gml->version < 3)
		prototype_write(town, id, first);
	gml_open(gml, "core:referencePoint", NULL);
	gml_point(gml, spot);
	gml_close(gml, "core:referencePoint");
	if (gml->version == 3)
		prototype_write(town, id, first);
	gml_close(gml, "core:ImplicitGeometry");
	gml_close(gml, lod.text);
}

/* ---- trees and plants ---- */

static void
tree_facts(struct gml *gml, unsigned species, unsigned percent)
{
	if (gml->version > 1)
		gml_code(gml, "veg:usage", "1000");
	gml_code(gml, "veg:species", species == 0 ? "1640" : "1500");
	gml_metres(gml, "veg:height",
		(long)(species == 0 ? 86 : 125) * (long)percent);
	gml_metres(gml, "veg:trunkDiameter", 5 * (long)percent);
	gml_metres(gml, "veg:crownDiameter",
		(long)(species == 0 ? 60 : 26) * (long)percent);
}

void
tree_write(struct town *town, double x, double y, unsigned species)
{
	struct gml *gml = town->gml;
	unsigned percent = 75 + town_pick(town, 7000 + town->plants, 50);
	struct frame frame = town_frame(x, y, 0);
	char id[GML_ID], prototype[GML_ID];
	bool first = !(town->seen & 1u << species);

	town->seen |= 1u << species;
	snprintf(id, sizeof id, "Tree_%u", ++town->plants);
	snprintf(prototype, sizeof prototype, "TreeShape_%u", species);
	shape_begin(&town->shapes[0], (struct frame){{0, 0, 0}, 1, 0});
	if (first)
		raise_tree(&town->shapes[0], species);
	gml_member_open(gml, "veg:SolitaryVegetationObject", id);
	if (gml->version < 3)
		tree_facts(gml, species, percent);
	implicit_write(town, "veg", prototype, first, frame.origin, percent);
	if (gml->version == 3)
		tree_facts(gml, species, percent);
	gml_member_close(gml, "veg:SolitaryVegetationObject");
}

/* A tree with geometry of its own. */
void
grown_tree_write(struct town *town, double x, double y)
{
	struct gml *gml = town->gml;
	char id[GML_ID];

	snprintf(id, sizeof id, "Tree_%u", ++town->plants);
	shape_begin(&town->shapes[0], town_frame(x, y, 0));
	raise_tree(&town->shapes[0], 0);
	gml_member_open(gml, "veg:SolitaryVegetationObject", id);
	gml_leaf(gml, "gml:name", "Gerichtslinde");
	if (gml->version < 3)
		tree_facts(gml, 0, 100);
	gml_multi_surface(gml,
		gml_name(gml, "veg:lod2Geometry", "core:lod2MultiSurface"),
		&town->shapes[0]);
	if (gml->version == 3)
		tree_facts(gml, 0, 100);
	gml_member_close(gml, "veg:SolitaryVegetationObject");
}

void
lawn_write(struct town *town, double x0, double y0, double x1, double y1)
{
	struct gml *gml = town->gml;
	char id[GML_ID];

	snprintf(id, sizeof id, "Lawn_%u", ++town->plants);
	town_area(town, x0, y0, x1, y1, 0.06);
	gml_member_open(gml, "veg:PlantCover", id);
	gml_leaf(gml, "gml:name", "日本庭園");
	if (gml->version < 3) {
		gml_code(gml, "veg:class", "1010");
		gml_metres(gml, "veg:averageHeight", 60);
		gml_multi_surface(
			gml, "veg:lod1MultiSurface", &town->shapes[0]);
	} else {
		gml_multi_surface(
			gml, "core:lod0MultiSurface", &town->shapes[0]);
		gml_code(gml, "veg:class", "1010");
		gml_metres(gml, "veg:averageHeight", 60);
	}
	gml_member_close(gml, "veg:PlantCover");
}

/* A solid without a property of its own, as a member of several. */
static void
solid_member(struct gml *gml, const struct shape *shape)
{
	gml_open(gml, "gml:solidMember", NULL);
	gml_solid_open(gml, NULL);
	gml_members(gml, shape, 0, shape->face_count);
	gml_solid_close(gml);
	gml_close(gml, "gml:solidMember");
}

void
hedge_write(struct town *town, double x0, double y0, double x1, double y1)
{
	struct gml *gml = town->gml;
	struct shape *shape = &town->shapes[0];
	double middle = (y0 + y1) / 2;
	char id[GML_ID];

	snprintf(id, sizeof id, "Hedge_%u", ++town->plants);
	gml_member_open(gml, "veg:PlantCover", id);
	shape_begin(shape, town_frame(0, 0, 0));
	shape_box(shape, (struct local){x0, y0, 0},
		(struct local){x1, middle - 1, 1.2});
	if (gml->version == 3) {
		gml_solid(gml, "core:lod2Solid", shape);
		gml_code(gml, "veg:class", "1060");
	} else {
		gml_code(gml, "veg:class", "1060");
		gml_open(gml, "veg:lod2MultiSolid", NULL);
		gml_open(gml, "gml:MultiSolid", NULL);
		solid_member(gml, shape);
		shape_begin(shape, town_frame(0, 0, 0));
		shape_box(shape, (struct local){x0, middle + 1, 0},
			(struct local){x1, y1, 1.2});
		solid_member(gml, shape);
		gml_close(gml, "gml:MultiSolid");
		gml_close(gml, "veg:lod2MultiSolid");
	}
	gml_member_close(gml, "veg:PlantCover");
}

/* ---- furniture, a monument, a group ---- */

void
fitting_write(struct town *town, enum fitting kind, double x, double y)
{
	static const char *const codes[] = {
		[FITTING_LAMP] = "1040",
		[FITTING_BENCH] = "1110",
		[FITTING_FOUNTAIN] = "1080",
	};
	struct gml *gml = town->gml;
	struct frame frame = town_frame(x, y, 0);
	char id[GML_ID], prototype[GML_ID];
	bool first = !(town->seen & 16u << kind);

	town->seen |= 16u << kind;
	snprintf(id, sizeof id, "Fitting_%u", ++town->fittings);
	snprintf(prototype, sizeof prototype, "FittingShape_%d", (int)kind);
	shape_begin(&town->shapes[0], (struct frame){{0, 0, 0}, 1, 0});
	if (first)
		raise_fitting(&town->shapes[0], kind);
	gml_member_open(gml, "frn:CityFurniture", id);
	if (gml->version < 3)
		gml_code(gml, "frn:function", codes[kind]);
	implicit_write(town, "frn", prototype, first, frame.origin, 100);
	if (gml->version == 3)
		gml_code(gml, "frn:function", codes[kind]);
	gml_member_close(gml, "frn:CityFurniture");
}

void
monument_write(struct town *town, double x, double y)
{
	static const double stone[][2] = {{1.6, 0}, {1.6, 0.4}, {0.7, 0.5},
		{0.7, 2}, {0.45, 2.1}, {0.3, 7}, {0.02, 7.6}};
	struct gml *gml = town->gml;
	const char *name = gml_name(
		gml, "gen:GenericCityObject", "gen:GenericOccupiedSpace");

	shape_begin(&town->shapes[0], town_frame(x, y, 0.1));
	turn(&town->shapes[0], stone, 7);
	gml_member_open(gml, name, "Monument");
	gml_leaf(gml, "gml:name", "Obelisk „Frieden“");
	gml_generic(gml, "string", "sculptor", "Grete Öhm", NULL);
	if (gml->version < 3)
		gml_code(gml, "gen:function", "monument");
	gml_solid(gml, gml_name(gml, "gen:lod2Geometry", "core:lod2Solid"),
		&town->shapes[0]);
	if (gml->version == 3)
		gml_code(gml, "gen:function", "monument");
	gml_member_close(gml, name);
}

static void
group_link(struct gml *gml, const char *id, const char *role)
{
	char target[GML_ID + 32], fresh[GML_ID];

	if (gml->version == 3) {
		gml_fresh_id(gml, fresh);
		gml_open(gml, "grp:groupMember", NULL);
		gml_open(gml, "grp:Role", fresh);
		gml_leaf(gml, "grp:role", role);
		gml_link(gml, "grp:groupMember", id);
		gml_close(gml, "grp:Role");
		gml_close(gml, "grp:groupMember");
		return;
	}
	snprintf(target, sizeof target, "%s\" xlink:href=\"#%s", role, id);
	gml_open_with(gml, "grp:groupMember", "role", target);
	gml_close(gml, "grp:groupMember");
}

/* Buildings first to first + count - 1 as one ensemble. */
void
group_write(struct town *town, unsigned first, unsigned count)
{
	struct gml *gml = town->gml;
	char id[GML_ID];

	gml_member_open(gml, "grp:CityObjectGroup", "Ensemble");
	gml_leaf(gml, "gml:name", "Ensemble Marktplatz");
	gml_code(gml, "grp:function", "ensemble");
	for (unsigned i = first; i < first + count; i++) {
		building_id(id, i);
		group_link(gml, id, i == first ? "main" : "member");
	}
	gml_member_close(gml, "grp:CityObjectGroup");
}
