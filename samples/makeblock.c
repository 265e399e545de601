/*
 * makeblock writes buildings of many touching parts as CityGML 2.0, the same
 * bytes for the same options: what simplifiers and tcs-compare are measured
 * with. A building has 25 to 280 parts and 2,500 to 6,000 triangles.
 */
#include <math.h>
#include <stdio.h>

#include "block_plans.h"
#include "output.h"
#include "program.h"

#define EAST 458000000L /* EPSG:25832, millimetres */
#define NORTH 5438000000L
#define HEIGHT 112000L
#define PITCH 40.0 /* metres from building to building */
#define ACROSS 10 /* buildings in a row */

static struct frame
block_frame(unsigned building)
{
	return frame_at(EAST + lround(1000 * PITCH * (building % ACROSS)),
		NORTH + lround(1000 * PITCH * (building / ACROSS)), HEIGHT,
		7.0 * (building % 5));
}

static void
building_open(struct block *block)
{
	char id[GML_ID];

	snprintf(id, sizeof id, "K%u", block->building + 1);
	gml_member_open(block->gml, "bldg:Building", id);
}

/* All plans in turn, each of another size. */
static void
building_write(struct block *block, unsigned seed)
{
	static void (*const plans[])(struct block *) = {
		plan_hall, plan_terrace, plan_pavilion, plan_tower};

	block->frame = block_frame(block->building);
	block->random = 7919u * (uint64_t)seed + block->building;
	block->parts = block->triangles = 0;
	for (int i = 0; i < 4; i++)
		block_choice(block, 0, 1);
	block->part_goal = block_choice(block, 30, 280);
	block->triangle_goal = block_choice(block, 2900, 5900);
	plans[(block->building + seed) % 4](block);
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
		building_write(&block, seed);
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
