#include "town.h"

static const char *const streets[] = {
	"Uferstraße",
	"Am Wehr",
	"Lindenstraße",
	"Gerbergasse",
	"Königsallee",
	"Mühlweg",
};

const char *
street_name(unsigned row)
{
	return streets[row % (sizeof streets / sizeof *streets)];
}

struct strip {
	double x0, y0, x1, y1, z;
	const char *function, *material;
	bool auxiliary;
};

/* The polygon of a strip, which colours name. */
static void
strip_surface(struct town *town, const struct strip *strip, const char *id)
{
	struct gml *gml = town->gml;
	struct lod_name lod = gml_lod_name(gml, "tran", 2, "MultiSurface");
	char text[GML_ID + 8];

	town_area(town, strip->x0, strip->y0, strip->x1, strip->y1, strip->z);
	gml_fresh_id(gml, text);
	gml_open(gml, lod.text, NULL);
	gml_open(gml, "gml:MultiSurface", text);
	gml_open(gml, "gml:surfaceMember", NULL);
	snprintf(text, sizeof text, "%s_P", id);
	gml_polygon(
		gml, text, &town->shapes[0], &town->shapes[0].faces[0], false);
	gml_close(gml, "gml:surfaceMember");
	gml_close(gml, "gml:MultiSurface");
	gml_close(gml, lod.text);
}

static void
strip_write_2(struct town *town, const struct strip *strip, const char *id)
{
	const char *property = strip->auxiliary ? "tran:auxiliaryTrafficArea"
						: "tran:trafficArea";
	const char *name = strip->auxiliary ? "tran:AuxiliaryTrafficArea"
					    : "tran:TrafficArea";

	gml_open(town->gml, property, NULL);
	gml_open(town->gml, name, id);
	gml_code(town->gml, "tran:function", strip->function);
	gml_code(town->gml, "tran:surfaceMaterial", strip->material);
	strip_surface(town, strip, id);
	gml_close(town->gml, name);
	gml_close(town->gml, property);
}

/* In 3.0 the areas bound spaces of the road. */
static void
strip_write_3(struct town *town, const struct strip *strip, const char *id)
{
	struct gml *gml = town->gml;
	const char *property = strip->auxiliary ? "tran:auxiliaryTrafficSpace"
						: "tran:trafficSpace";
	const char *name = strip->auxiliary ? "tran:AuxiliaryTrafficSpace"
					    : "tran:TrafficSpace";
	const char *area =
		strip->auxiliary ? "AuxiliaryTrafficArea" : "TrafficArea";
	char space[GML_ID + 8];

	snprintf(space, sizeof space, "%s_space", id);
	gml_open(gml, property, NULL);
	gml_open(gml, name, space);
	gml_boundary_open(gml, "tran", area, id);
	strip_surface(town, strip, id);
	gml_code(gml, "tran:function", strip->function);
	gml_code(gml, "tran:surfaceMaterial", strip->material);
	gml_boundary_close(gml, "tran", area);
	gml_leaf(gml, "tran:granularity", "way");
	gml_close(gml, name);
	gml_close(gml, property);
}

static void
strips_write(struct town *town, const char *name, const char *id,
	const char *label, const struct strip *strips, size_t count)
{
	struct gml *gml = town->gml;
	char area[GML_ID];

	gml_member_open(gml, name, id);
	gml_leaf(gml, "gml:name", label);
	if (gml->version < 3)
		gml_code(gml, "tran:function", "1010");
	for (int auxiliary = 0; auxiliary < 2; auxiliary++) {
		for (size_t i = 0; i < count; i++) {
			if (strips[i].auxiliary != (auxiliary == 1))
				continue;
			snprintf(area, sizeof area, "%s_A%zu", id, i);
			if (gml->version == 3)
				strip_write_3(town, &strips[i], area);
			else
				strip_write_2(town, &strips[i], area);
		}
	}
	if (gml->version == 3)
		gml_code(gml, "tran:function", "1010");
	gml_member_close(gml, name);
}

/* The street south of a block, the one west of it, and where they cross. */
void
street_write(struct town *town, unsigned column, unsigned row)
{
	double x = column * PITCH_X, y = row * PITCH_Y;
	double east = x + BLOCK_WIDTH, north = y + BLOCK_DEPTH;
	const struct strip strips[] = {
		{x - 12, y - 12, x, y, 0, "2", "2", false},
		{x, y - 9.5, east, y - 2.5, 0, "1", "1", false},
		{x, y - 12, east, y - 9.5, 0.12, "2", "2", false},
		{x, y - 2.5, east, y - 1, 0.12, "2", "2", false},
		{x, y - 1, east, y, 0.1, "1020", "3", true},
		{x - 9.5, y, x - 2.5, north, 0, "1", "1", false},
		{x - 12, y, x - 9.5, north, 0.12, "2", "2", false},
		{x - 2.5, y, x, north, 0.12, "2", "2", false},
	};
	size_t count = sizeof strips / sizeof *strips;
	char id[GML_ID], label[64];

	if (row == town->rows)
		count = 5; /* nothing north of the last street */
	if (column == town->columns && row == town->rows)
		count = 1;
	snprintf(id, sizeof id, "Road_%u_%u", column, row);
	snprintf(label, sizeof label, "%s, %u. Querweg", street_name(row),
		column + 1);
	if (column == town->columns && row < town->rows) {
		const struct strip last[] = {
			strips[0], strips[5], strips[6], strips[7]};

		strips_write(town, "tran:Road", id, label, last, 4);
		return;
	}
	strips_write(town, "tran:Road", id, label, strips, count);
}

void
railway_write(struct town *town)
{
	double west = LAND_WEST, east = tunnel_start(town) + LAND_EAST;
	const struct strip strips[] = {
		{west, RAILWAY - 2.6, east, RAILWAY - 1.1, 0.3, "8", "9",
			false},
		{west, RAILWAY + 1.1, east, RAILWAY + 2.6, 0.3, "8", "9",
			false},
		{west, RAILWAY - 4, east, RAILWAY + 4, 0.1, "1020", "6", true},
	};

	strips_write(town, "tran:Railway", "Railway", "Wehrtalbahn", strips,
		sizeof strips / sizeof *strips);
}

enum { COLOURED = 8 }; /* streets each way that have colours */

/* The streets at the town's east and north edge have fewer strips. */
static bool
strip_exists(const struct town *town, unsigned column, unsigned row, char strip)
{
	if (column == town->columns && row == town->rows)
		return false;
	if (column == town->columns)
		return strip <= '3';
	return row < town->rows || strip <= '4';
}

/* The strips numbered in `which` of one street. */
static void
strip_targets(
	struct town *town, unsigned column, unsigned row, const char *which)
{
	char target[GML_ID];

	for (; *which; which++) {
		if (!strip_exists(town, column, row, *which))
			continue;
		snprintf(target, sizeof target, "#Road_%u_%u_A%c_P", column,
			row, *which);
		gml_leaf(town->gml, "app:target", target);
	}
}

static void
strip_colour(struct town *town, const char *id, struct colour colour,
	const char *which)
{
	gml_material_open(town->gml, id, colour);
	for (unsigned row = 0; row <= town->rows && row < COLOURED; row++)
		for (unsigned column = 0;
			column <= town->columns && column < COLOURED; column++)
			strip_targets(town, column, row, which);
	gml_material_close(town->gml);
}

/* Colours that belong to the model, not to a road: the first streets' only. */
void
pavement_colours_write(struct town *town)
{
	const struct colour slabs = {190, 184, 174, 0},
			    grass = {122, 156, 84, 0};

	gml_appearance_open(town->gml, true, "Pavement", "Farben");
	strip_colour(town, "Pavement_slabs", slabs, "2367");
	strip_colour(town, "Pavement_grass", grass, "4");
	gml_appearance_close(town->gml, true);
}

/* A paved block with a hole where the fountain stands. */
static void
raise_paving(struct shape *shape, double x, double y)
{
	shape_begin(shape, town_frame(x, y, 0));
	shape_face(shape, FACE_DECK);
	shape_point(shape, 0, 0, 0.1);
	shape_point(shape, BLOCK_WIDTH, 0, 0.1);
	shape_point(shape, BLOCK_WIDTH, BLOCK_DEPTH, 0.1);
	shape_point(shape, 0, BLOCK_DEPTH, 0.1);
	shape_hole(shape);
	shape_point(shape, 34, 10, 0.1);
	shape_point(shape, 34, 14, 0.1);
	shape_point(shape, 38, 14, 0.1);
	shape_point(shape, 38, 10, 0.1);
}

void
square_write(struct town *town, double x, double y)
{
	struct gml *gml = town->gml;
	struct lod_name lod = gml_lod_name(gml, "tran", 2, "MultiSurface");

	raise_paving(&town->shapes[0], x, y);
	gml_member_open(gml, "tran:Square", "Square");
	gml_leaf(gml, "gml:name", "Marktplatz");
	if (gml->version < 3) {
		gml_code(gml, "tran:function", "1210");
		gml_multi_surface(gml, lod.text, &town->shapes[0]);
	} else {
		gml_open(gml, "tran:trafficSpace", NULL);
		gml_open(gml, "tran:TrafficSpace", "Square_space");
		gml_boundary_open(gml, "tran", "TrafficArea", "Square_A0");
		gml_multi_surface(gml, lod.text, &town->shapes[0]);
		gml_boundary_close(gml, "tran", "TrafficArea");
		gml_leaf(gml, "tran:granularity", "way");
		gml_close(gml, "tran:TrafficSpace");
		gml_close(gml, "tran:trafficSpace");
		gml_code(gml, "tran:function", "1210");
	}
	gml_member_close(gml, "tran:Square");
}
