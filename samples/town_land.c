#include "town.h"

#include <assert.h>
#include <math.h>

enum { MAX_LINES = 2048 };

/* ---- relief ---- */

/* Lines of a grid, ascending. */
struct lines {
	size_t count;
	double at[MAX_LINES];
};

static void
lines_add(struct lines *lines, double at)
{
	assert(lines->count < MAX_LINES);
	lines->at[lines->count++] = at;
}

static double
beyond(double at, double low, double high)
{
	return at < low ? low - at : at > high ? at - high : 0;
}

/* 0 up to low, 1 from high on. */
static double
ramp(double at, double low, double high)
{
	return fmin(fmax((at - low) / (high - low), 0), 1);
}

/* The hill that the tunnel goes through, east of the town. */
static double
hill_height(const struct town *town, double x, double y)
{
	double from = tunnel_start(town), to = from + TUNNEL_LENGTH;
	double along = (x - (from + to) / 2) / 26, across = (y - RAILWAY) / 17;

	if (y > RIVER_SOUTH - 1)
		return 0;
	return 24 * exp(-along * along - across * across) *
		ramp(x, from, from + 8) * ramp(-x, -to, -to + 8);
}

/* Level in the town and along river and railway, rolling further out. */
static double
ground_height(const struct town *town, double x, double y)
{
	double east = town->columns * PITCH_X, north = town->rows * PITCH_Y;
	double out = hypot(beyond(x, -12, east), beyond(y, -80, north));
	double reach = ramp(beyond(y, -80, -12), 0, 60);
	double rolling = ramp(out, 0, 70) *
		(4 + 4 * sin(x / 47) + 3 * cos(y / 39 + x / 83));

	if (y > RIVER_SOUTH + 1 && y < RIVER_NORTH - 1)
		return -4;
	return reach * rolling + hill_height(town, x, y);
}

static void
patches_open(struct gml *gml, const char *id, const char *label)
{
	char fresh[GML_ID];

	gml_member_open(gml, "dem:ReliefFeature", id);
	gml_leaf(gml, "gml:name", label);
	gml_number(gml, "dem:lod", 1);
	gml_open(gml, "dem:reliefComponent", NULL);
	gml_fresh_id(gml, fresh);
	gml_open(gml, "dem:TINRelief", fresh);
	gml_number(gml, "dem:lod", 1);
	gml_open(gml, "dem:tin", NULL);
	gml_fresh_id(gml, fresh);
	gml_open(gml, "gml:TriangulatedSurface", fresh);
	gml_open(
		gml, gml_name(gml, "gml:trianglePatches", "gml:patches"), NULL);
}

static void
patches_close(struct gml *gml)
{
	gml_close(gml, gml_name(gml, "gml:trianglePatches", "gml:patches"));
	gml_close(gml, "gml:TriangulatedSurface");
	gml_close(gml, "dem:tin");
	gml_close(gml, "dem:TINRelief");
	gml_close(gml, "dem:reliefComponent");
	gml_member_close(gml, "dem:ReliefFeature");
}

static void
cell_write(struct town *town, double x0, double y0, double x1, double y1)
{
	const double corners[][2] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
	struct frame frame = town_frame(0, 0, 0);
	struct spot spots[4];

	for (size_t i = 0; i < 4; i++) {
		double x = corners[i][0], y = corners[i][1];

		spots[i] = frame_place(&frame,
			(struct local){x, y, ground_height(town, x, y) - 0.1});
	}
	gml_triangle(town->gml, (struct spot[]){spots[0], spots[1], spots[2]});
	gml_triangle(town->gml, (struct spot[]){spots[0], spots[2], spots[3]});
}

/* The level ground under a block and its streets. */
void
tile_relief_write(struct town *town, unsigned column, unsigned row)
{
	double x = column * PITCH_X - STREET, y = row * PITCH_Y - STREET;
	char id[GML_ID];

	snprintf(id, sizeof id, "Relief_%u_%u", column, row);
	patches_open(town->gml, id, "Gelände der Stadt");
	cell_write(town, x, y, x + PITCH_X, y + PITCH_Y);
	patches_close(town->gml);
}

static void
relief_lines(const struct town *town, struct lines *x, struct lines *y)
{
	static const double west[] = {LAND_WEST, -45};
	static const double east[] = {0, 8, 20, 35, 50, 62, 70, 90};
	static const double south[] = {LAND_SOUTH, -95, -82, -74, -66, -58,
		RIVER_SOUTH, -49, -25, RIVER_NORTH};
	double right = town->columns * PITCH_X, top = town->rows * PITCH_Y;

	for (size_t i = 0; i < sizeof west / sizeof *west; i++)
		lines_add(x, west[i]);
	for (unsigned i = 0; i <= town->columns; i++)
		lines_add(x, i * PITCH_X - STREET);
	lines_add(x, right);
	for (size_t i = 0; i < sizeof east / sizeof *east; i++)
		lines_add(x, tunnel_start(town) + east[i]);
	for (size_t i = 0; i < sizeof south / sizeof *south; i++)
		lines_add(y, south[i]);
	for (unsigned i = 0; i <= town->rows; i++)
		lines_add(y, i * PITCH_Y - STREET);
	lines_add(y, top);
	lines_add(y, top + LAND_NORTH);
}

/* Everything around the blocks. */
void
relief_write(struct town *town)
{
	double right = town->columns * PITCH_X - STREET;
	double top = town->rows * PITCH_Y - STREET;
	static struct lines x, y;

	x.count = 0;
	y.count = 0;
	relief_lines(town, &x, &y);
	patches_open(town->gml, "Relief", "Umland");
	for (size_t j = 0; j + 1 < y.count; j++) {
		for (size_t i = 0; i + 1 < x.count; i++) {
			bool inside = x.at[i] >= -STREET && x.at[i] < right &&
				y.at[j] >= -STREET && y.at[j] < top;

			if (!inside)
				cell_write(town, x.at[i], y.at[j], x.at[i + 1],
					y.at[j + 1]);
		}
	}
	patches_close(town->gml);
}

/* ---- water and land use ---- */

static void
water_surface(struct town *town, const char *class, const char *id)
{
	struct gml *gml = town->gml;
	char fresh[GML_ID];

	gml_boundary_open(gml, "wtr", class, id);
	if (gml->version == 3) {
		gml_multi_surface(
			gml, "core:lod2MultiSurface", &town->shapes[0]);
	} else {
		gml_fresh_id(gml, fresh);
		gml_open(gml, "wtr:lod2Surface", NULL);
		gml_polygon(gml, fresh, &town->shapes[0],
			&town->shapes[0].faces[0], false);
		gml_close(gml, "wtr:lod2Surface");
	}
	gml_boundary_close(gml, "wtr", class);
}

static void
water_write(struct town *town, const char *id, const char *label,
	const double box[4], double level, double bed)
{
	struct gml *gml = town->gml;
	char surface[GML_ID];

	gml_member_open(gml, "wtr:WaterBody", id);
	gml_leaf(gml, "gml:name", label);
	if (gml->version < 3)
		gml_code(gml, "wtr:function", "1000");
	town_area(town, box[0], box[1], box[2], box[3], level);
	snprintf(surface, sizeof surface, "%s_surface", id);
	water_surface(town, "WaterSurface", surface);
	town_area(town, box[0], box[1], box[2], box[3], bed);
	snprintf(surface, sizeof surface, "%s_bed", id);
	water_surface(town, "WaterGroundSurface", surface);
	if (gml->version == 3)
		gml_code(gml, "wtr:function", "1000");
	gml_member_close(gml, "wtr:WaterBody");
}

void
river_write(struct town *town)
{
	const double box[] = {
		-160, RIVER_SOUTH, town->columns * PITCH_X + 170, RIVER_NORTH};

	water_write(town, "River", "Wehrbach", box, -1.2, -4);
}

void
pond_write(struct town *town, double x, double y)
{
	const double box[] = {x - 9, y - 6, x + 9, y + 6};
	char id[GML_ID];

	snprintf(id, sizeof id, "Pond_%u", town->plants);
	water_write(town, id, "蓮池", box, 0.15, -0.8);
}

void
land_use_write(struct town *town, double x0, double y0, double x1, double y1,
	const char *function)
{
	struct gml *gml = town->gml;
	char id[GML_ID];

	gml_fresh_id(gml, id);
	gml_member_open(gml, "luse:LandUse", id);
	if (gml->version < 3)
		gml_code(gml, "luse:function", function);
	town_area(town, x0, y0, x1, y1, 0);
	gml_multi_surface(gml,
		gml_lod_name(gml, "luse", 1, "MultiSurface").text,
		&town->shapes[0]);
	if (gml->version == 3)
		gml_code(gml, "luse:function", function);
	gml_member_close(gml, "luse:LandUse");
}
