/*
 * makeblock writes buildings of many touching parts as CityGML 2.0, the same
 * bytes for the same options: what simplifiers and tcs-compare are measured
 * with. A building has 25 to 280 closed parts and 2,500 to 6,000 triangles.
 */
#include <math.h>
#include <stdio.h>

#include "output.h"
#include "program.h"
#include "town_gml.h"
#include "town_shape.h"

#define EAST 458000000L /* EPSG:25832, millimetres */
#define NORTH 5438000000L
#define HEIGHT 112000L
#define PITCH 40.0 /* metres from building to building */
#define ACROSS 10 /* buildings in a row */

struct block {
	struct gml *gml;
	struct shape *shape;
	unsigned building, part;
	unsigned columns, posts, steps, windows; /* of this building */
	unsigned sides; /* of a column */
	unsigned grid; /* of the façade */
};

static struct frame
block_frame(unsigned building)
{
	return frame_at(EAST + lround(1000 * PITCH * (building % ACROSS)),
		NORTH + lround(1000 * PITCH * (building / ACROSS)), HEIGHT,
		7.0 * (building % 5));
}

static void
part_begin(struct block *block)
{
	shape_begin(block->shape, block_frame(block->building));
}

static void
part_end(struct block *block, const char *kind)
{
	struct gml *gml = block->gml;
	char id[GML_ID];

	snprintf(id, sizeof id, "K%u_%s%u", block->building + 1, kind,
		++block->part);
	gml_open(gml, "bldg:outerBuildingInstallation", NULL);
	gml_open(gml, "bldg:BuildingInstallation", id);
	gml_multi_surface(gml, "bldg:lod3Geometry", block->shape);
	gml_close(gml, "bldg:BuildingInstallation");
	gml_close(gml, "bldg:outerBuildingInstallation");
}

static void
box_write(struct block *block, const char *kind, struct local low,
	struct local high)
{
	part_begin(block);
	shape_box(block->shape, low, high);
	part_end(block, kind);
}

/* Stands on the slab at z 0.3; the roof beam rests on it, or 5 mm above. */
static void
column_write(struct block *block, unsigned number)
{
	double outline[64][2], u = 1 + 22.0 * number / block->columns;
	double top = number % 4 == 3 ? 6.995 : 7;

	for (unsigned i = 0; i < block->sides; i++) {
		double angle = 2 * acos(-1) * i / block->sides;

		outline[i][0] = u + 0.2 * cos(angle);
		outline[i][1] = 0.7 + 0.2 * sin(angle);
	}
	part_begin(block);
	shape_block(block->shape, (const double(*)[2])outline, block->sides,
		0.3, top);
	part_end(block, "column");
}

/* One side of the house: a wall whose outside is a grid of quads. */
static void
facade_side(struct shape *shape, struct local from, struct local to, double top,
	unsigned grid)
{
	for (unsigned i = 0; i < grid; i++) {
		for (unsigned k = 0; k < grid; k++) {
			double a = (double)i / grid, b = (i + 1.0) / grid;
			double low = from.z + (top - from.z) * k / grid;
			double high = from.z + (top - from.z) * (k + 1) / grid;
			double u = to.u - from.u, v = to.v - from.v;
			const struct local quad[] = {
				{from.u + a * u, from.v + a * v, low},
				{from.u + b * u, from.v + b * v, low},
				{from.u + b * u, from.v + b * v, high},
				{from.u + a * u, from.v + a * v, high},
			};

			shape_polygon(shape, FACE_WALL, quad, 4);
		}
	}
}

/* Floor and ceiling have the grid's points on their edges. */
static void
facade_lid(struct shape *shape, const struct local corners[4], double z,
	unsigned grid, bool up)
{
	shape_face(shape, up ? FACE_ROOF : FACE_GROUND);
	for (unsigned i = 0; i < 4 * grid; i++) {
		unsigned at = up ? i : 4 * grid - 1 - i;
		struct local a = corners[at / grid];
		struct local b = corners[(at / grid + 1) % 4];
		double part = (double)(at % grid) / grid;

		shape_point(shape, a.u + part * (b.u - a.u),
			a.v + part * (b.v - a.v), z);
	}
}

static void
house_write(struct block *block)
{
	const struct local corners[] = {
		{2, 3, 0.3}, {22, 3, 0.3}, {22, 13, 0.3}, {2, 13, 0.3}};

	part_begin(block);
	for (int i = 0; i < 4; i++)
		facade_side(block->shape, corners[i], corners[(i + 1) % 4], 7,
			block->grid);
	facade_lid(block->shape, corners, 0.3, block->grid, false);
	facade_lid(block->shape, corners, 7, block->grid, true);
	part_end(block, "house");
}

/* Overhangs the walls on all sides, and rests on them and on the columns. */
static void
roof_write(struct block *block)
{
	const double profile[][2] = {{0, 7}, {14, 7}, {7, 11}};
	const enum face_class classes[] = {FACE_EAVES, FACE_ROOF, FACE_ROOF};

	part_begin(block);
	shape_extrude(block->shape, profile, classes, 3, 0, 24);
	part_end(block, "roof");
	/* Through the roof. */
	box_write(block, "chimney", (struct local){6, 8, 8},
		(struct local){6.8, 8.8, 12});
}

/* Frames that stand half inside the wall at v 13. */
static void
windows_write(struct block *block)
{
	for (unsigned i = 0; i < block->windows; i++) {
		double u = 2.5 + 19.0 * i / block->windows;

		box_write(block, "window", (struct local){u, 12.9, 1.3},
			(struct local){u + 12.0 / block->windows, 13.05, 2.6});
	}
}

/* Posts on the slab's edge, and a rail that rests on them. */
static void
railing_write(struct block *block)
{
	for (unsigned i = 0; i < block->posts; i++) {
		double u = 0.1 + 23.7 * i / block->posts;

		box_write(block, "post", (struct local){u, 0.1, 0.3},
			(struct local){u + 0.04, 0.14, 1.2});
	}
	box_write(block, "rail", (struct local){0.05, 0.08, 1.2},
		(struct local){23.9, 0.16, 1.25});
}

static void
stairs_write(struct block *block)
{
	for (unsigned i = 0; i < block->steps; i++) {
		double v = 16 - 1.0 / block->steps - (double)i / block->steps;

		box_write(block, "step",
			(struct local){24.0, v - 8, 0.3 * i / block->steps},
			(struct local){26, v - 8 + 1.0 / block->steps,
				0.3 * (i + 1) / block->steps});
	}
}

/* How many parts, then so many sides that there are triangles enough. */
static void
choose(struct block *block, unsigned seed)
{
	unsigned random = (block->building + seed * 7919u) * 2654435761u;
	unsigned parts = 20 + (random >> 8) % 241, boxes;

	block->part = 0;
	block->columns = 8 + (random >> 20) % 8;
	block->steps = 3;
	boxes = parts - block->columns - block->steps;
	block->windows = boxes / 3;
	block->posts = boxes - block->windows;
	block->grid = 8;
	/* A box has 12 triangles, the house and the roof 600, a column four
	   for each side. */
	block->sides = (3000 + (random >> 4) % 2500) / (4 * block->columns);
	boxes = 12 * boxes / (4 * block->columns) + 5;
	block->sides = block->sides > boxes ? block->sides - boxes : 0;
	block->sides = block->sides < 8 ? 8
		: block->sides > 62	? 62
					: block->sides;
}

static void
building_open(struct block *block)
{
	char id[GML_ID];

	snprintf(id, sizeof id, "K%u", block->building + 1);
	gml_member_open(block->gml, "bldg:Building", id);
}

static void
building_write_parts(struct block *block)
{
	box_write(block, "slab", (struct local){0, 0, 0},
		(struct local){24, 14, 0.3});
	house_write(block);
	for (unsigned i = 0; i < block->columns; i++)
		column_write(block, i);
	roof_write(block);
	windows_write(block);
	railing_write(block);
	stairs_write(block);
}

static enum tcs_status
run(const struct command *command, unsigned buildings, unsigned seed,
	bool together, struct tcs_fault *fault)
{
	static struct gml gml;
	static struct shape shape;
	struct block block = {.gml = &gml, .shape = &shape};
	struct spot low = {EAST - 20000, NORTH - 20000, HEIGHT};
	struct spot high = {EAST + 440000,
		NORTH + 40000L * (long)(buildings / ACROSS + 1),
		HEIGHT + 12000};
	struct output output;
	enum tcs_status status = output_open(&output, command->output, fault);

	if (status)
		return status;
	gml.file = output.file;
	gml.version = 2;
	gml_begin(&gml, low, high);
	for (; block.building < buildings; block.building++) {
		if (!together || !block.building)
			building_open(&block);
		choose(&block, seed);
		building_write_parts(&block);
		if (!together || block.building + 1 == buildings)
			gml_member_close(&gml, "bldg:Building");
	}
	gml_end(&gml);
	status = gml_flush(&gml, fault);
	if (!status)
		status = output_commit(&output, fault);
	output_discard(&output);
	return status;
}

int
main(int argc, char **argv)
{
	unsigned buildings = 10, seed = 0;
	bool together = false;
	const struct option_row rows[] = {
		{OPTION_UNSIGNED, 0, "buildings", "N",
			"how many buildings (default 10)", &buildings, 1,
			100000, NULL},
		{OPTION_FLAG, 0, "together", NULL,
			"one building that has the parts of all", &together, 0,
			0, NULL},
		{OPTION_UNSIGNED, 0, "seed", "N", "other buildings", &seed, 0,
			1000000, NULL},
		{0},
	};
	const struct program program = {
		.name = "makeblock",
		.synopsis = "[options]",
		.summary = "write buildings of many parts as CityGML",
		.options = rows,
	};
	struct command command;
	struct tcs_fault fault;
	int code = EXIT_DONE;

	program_begin(&program, argc, argv, &command);
	if (run(&command, buildings, seed, together, &fault))
		code = program_fail(&command, &fault);
	program_end(&command);
	return code;
}
