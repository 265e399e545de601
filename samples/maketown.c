/*
 * maketown writes a town of any size as CityGML, the same bytes for the same
 * options. The samples and the benches are made by it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output.h"
#include "program.h"
#include "town.h"

#define EAST 458000000L /* the town's origin in EPSG:25832, millimetres */
#define NORTH 5438000000L
#define HEIGHT 112000L
#define BLOCK_BUILDINGS 5.0 /* on the average */
#define BUILDING_BYTES 20000.0 /* at least, with what stands around it */

struct options {
	unsigned version, buildings, megabytes, seed;
	bool lods[5];
	bool share_walls;
};

struct frame
town_frame(double x, double y, double degrees)
{
	return frame_at(EAST + lround(1000 * x), NORTH + lround(1000 * y),
		HEIGHT, degrees);
}

/* splitmix64's finisher over seed and salt. */
unsigned
town_pick(const struct town *town, unsigned salt, unsigned count)
{
	uint64_t bits = town->seed * 0x9e3779b97f4a7c15u + salt;

	bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
	bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
	bits ^= bits >> 31;
	return (unsigned)(bits % count);
}

double
tunnel_start(const struct town *town)
{
	return town->columns * PITCH_X + 25;
}

bool
town_full(const struct town *town)
{
	return town->buildings >= town->max_buildings ||
		(town->max_bytes > 0 && gml_size(town->gml) >= town->max_bytes);
}

void
town_area(
	struct town *town, double x0, double y0, double x1, double y1, double z)
{
	struct shape *shape = &town->shapes[0];

	shape_begin(shape, town_frame(0, 0, 0));
	shape_polygon(shape, FACE_DECK,
		(struct local[]){
			{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}},
		4);
}

/* Rows of blocks until there is room for all buildings. */
static unsigned
rows_for(const struct town *town, unsigned buildings)
{
	unsigned row = 0, room = 0;

	for (; row < 3 || room < buildings; row++)
		for (unsigned column = 0; column < town->columns; column++)
			room += block_buildings(town, column, row);
	return row;
}

/* A town half as wide again as it is deep. A limit on bytes is estimated. */
static void
lay_out(struct town *town, const struct options *options)
{
	unsigned buildings = options->buildings;

	town->max_buildings = buildings;
	if (options->megabytes > 0) {
		town->max_bytes = (uint64_t)options->megabytes * 1000000;
		town->max_buildings = UINT32_MAX;
		buildings =
			(unsigned)((double)town->max_bytes / BUILDING_BYTES) +
			1;
	}
	town->columns = (unsigned)fmax(
		4, ceil(sqrt(1.2 * buildings / BLOCK_BUILDINGS)));
	town->rows = rows_for(town, buildings);
}

static void
write_edges(struct town *town)
{
	for (unsigned row = 0; row < town->rows; row++)
		street_write(town, town->columns, row);
	for (unsigned column = 0; column <= town->columns; column++)
		street_write(town, column, town->rows);
}

static void
write_blocks(struct town *town)
{
	for (unsigned row = 0; row < town->rows; row++) {
		for (unsigned column = 0; column < town->columns; column++) {
			block_write(town, column, row);
			street_write(town, column, row);
			tile_relief_write(town, column, row);
		}
		if (town_full(town))
			town->rows = row + 1;
	}
}

static void
write_bank(struct town *town)
{
	double east = town->columns * PITCH_X;

	for (double x = 4; x + 8 < east; x += 24) {
		fitting_write(town, FITTING_BENCH, x, -15.5);
		tree_write(town, x + 12, -16, 1);
	}
}

static void
write_town(struct town *town)
{
	double north = town->rows * PITCH_Y;
	double start = tunnel_start(town);
	struct frame low = town_frame(LAND_WEST, LAND_SOUTH, 0);
	struct frame high =
		town_frame(start + LAND_EAST, north + LAND_NORTH, 0);

	low.origin.z -= 10000;
	high.origin.z += 60000;
	gml_begin(town->gml, low.origin, high.origin);
	write_blocks(town);
	write_edges(town);
	write_bank(town);
	railway_write(town);
	river_write(town);
	bridge_write(town, 2 * PITCH_X - STREET / 2);
	tunnel_write(
		town, tunnel_start(town), tunnel_start(town) + TUNNEL_LENGTH);
	relief_write(town);
	pavement_colours_write(town);
	if (town->ensemble && town->buildings >= town->ensemble + 4)
		group_write(town, town->ensemble, 5);
	gml_end(town->gml);
}

/* ---- command line ---- */

static const char *
parse_version(void *target, const char *argument)
{
	unsigned *version = target;

	if (strlen(argument) != 3 || strcmp(argument + 1, ".0") ||
		argument[0] < '1' || argument[0] > '3')
		return "not one of 1.0, 2.0, 3.0";
	*version = (unsigned)(argument[0] - '0');
	return NULL;
}

static const char *
parse_lods(void *target, const char *argument)
{
	bool *lods = target;

	memset(lods, 0, 5 * sizeof *lods);
	for (; *argument; argument++) {
		if (*argument == ',')
			continue;
		if (*argument < '0' || *argument > '4')
			return "not a list of levels of detail like 0,1,2";
		lods[*argument - '0'] = true;
	}
	return NULL;
}

static enum tcs_status
run(const struct command *command, const struct options *options,
	struct tcs_fault *fault)
{
	static struct town town;
	static struct gml gml;
	struct output output;
	enum tcs_status status = output_open(&output, command->output, fault);

	if (status)
		return status;
	gml.file = output.file;
	gml.version = (int)options->version;
	memcpy(gml.lods, options->lods, sizeof gml.lods);
	town.gml = &gml;
	town.seed = options->seed;
	town.share_walls = options->share_walls;
	lay_out(&town, options);
	write_town(&town);
	status = gml_flush(&gml, fault);
	if (!status)
		status = output_commit(&output, fault);
	output_discard(&output);
	return status;
}

int
main(int argc, char **argv)
{
	struct options options = {
		.version = 2,
		.buildings = 46,
		.lods = {true, true, true, true, true},
	};
	const struct option_row rows[] = {
		{OPTION_PARSE, 0, "citygml", "N.0",
			"CityGML version: 1.0, 2.0 or 3.0 (default 2.0)",
			&options.version, 0, 0, parse_version},
		{OPTION_UNSIGNED, 0, "buildings", "N",
			"how many buildings (default 46)", &options.buildings,
			1, 10000000, NULL},
		{OPTION_UNSIGNED, 0, "megabytes", "N",
			"stop at about N million bytes instead",
			&options.megabytes, 1, 1000000, NULL},
		{OPTION_PARSE, 0, "lod", "LIST",
			"levels of detail to write (default 0,1,2,3,4)",
			options.lods, 0, 0, parse_lods},
		{OPTION_UNSIGNED, 0, "seed", "N",
			"another town of the same kind", &options.seed, 0,
			1000000, NULL},
		{OPTION_FLAG, 0, "global-xlinks", NULL,
			"let all row houses share their walls",
			&options.share_walls, 0, 0, NULL},
		{0},
	};
	const struct program program = {
		.name = "maketown",
		.synopsis = "[options]",
		.summary = "write a sample town as CityGML",
		.options = rows,
	};
	struct command command;
	struct tcs_fault fault;
	int code = EXIT_DONE;

	program_begin(&program, argc, argv, &command);
	if (run(&command, &options, &fault))
		code = program_fail(&command, &fault);
	program_end(&command);
	return code;
}
