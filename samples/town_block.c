#include "town.h"

/* What a block is built over with. */
enum block_kind {
	BLOCK_HOUSES,
	BLOCK_ROW,
	BLOCK_COURT,
	BLOCK_SQUARE,
	BLOCK_HALL,
	BLOCK_PARK,
	BLOCK_YARD,
};

struct block {
	struct town *town;
	unsigned column, row;
	double x, y; /* its south-west corner */
	unsigned salt; /* differs from block to block */
};

static const struct colour plasters[] = {
	{236, 224, 200, 0},
	{224, 205, 170, 0},
	{214, 186, 150, 0},
	{232, 214, 184, 0},
	{205, 210, 196, 0},
	{226, 196, 176, 0},
	{240, 236, 226, 0},
};

static const struct colour tiles[] = {
	{158, 62, 42, 0},
	{140, 52, 40, 0},
	{172, 80, 52, 0},
	{96, 70, 62, 0},
};

static const struct colour slate = {84, 90, 100, 0};
static const struct colour copper = {112, 158, 138, 0};
static const struct colour gravel = {150, 148, 142, 0};
static const struct colour sandstone = {196, 150, 112, 0};

static unsigned
pick(const struct block *block, unsigned lot, unsigned what, unsigned count)
{
	return town_pick(block->town, block->salt + 64 * lot + what, count);
}

/* A building with what all have; the number counts only when written. */
static struct building
plain_building(const struct block *block, unsigned lot)
{
	unsigned number = block->town->buildings + 1;

	return (struct building){
		.number = number,
		.street = street_name(block->row),
		.house = 2 * lot + 1,
		.function = "1000",
		.roof = "1030",
		.year = 1780 + pick(block, lot, 1, 230),
		.wall = plasters[pick(
			block, lot, 2, sizeof plasters / sizeof *plasters)],
		.paint = tiles[pick(
			block, lot, 3, sizeof tiles / sizeof *tiles)],
		.painted = true,
		.solid_holds = number % 2 == 0,
		.body_count = 1,
	};
}

/* Coordinates are spelled in three ways, building by building. */
static enum ring_style
style_of(unsigned number)
{
	if (number == 5)
		return STYLE_POINT_PROPERTY;
	return number % 7 == 3 ? STYLE_POS : STYLE_POS_LIST;
}

static void
put_up(const struct block *block, struct building *building)
{
	struct town *town = block->town;

	if (town_full(town))
		return;
	building->number = ++town->buildings;
	town->gml->style = style_of(building->number);
	building_write(town->gml, building, town->shapes);
	town->gml->style = STYLE_POS_LIST;
}

/* ---- houses with gardens ---- */

static void
add_chimney(struct body *body)
{
	double u = body->u + body->width * 0.7, v = body->depth * 0.5 + 1;

	body->installations[0] = (struct installation){
		INSTALLATION_CHIMNEY,
		{u, v, body->eaves},
		{u + 0.7, v + 0.7, body->eaves + body->rise + 1},
	};
}

static void
add_dormer(struct body *body)
{
	double u = body->u + body->width / 2 - 1;

	body->installations[1] = (struct installation){
		INSTALLATION_DORMER,
		{u, 0.8, body->eaves + 0.6},
		{u + 2, body->depth / 2, body->eaves + 2.9},
	};
}

static void
add_balcony(struct body *body)
{
	double u = body->u + body->width / 2;

	body->installations[2] = (struct installation){
		INSTALLATION_BALCONY,
		{u - 1.5, body->depth, 2.8},
		{u + 1.5, body->depth + 1.4, 3},
	};
}

static void
house(const struct block *block, unsigned lot, struct frame frame)
{
	struct building building = plain_building(block, lot);
	struct body *body = &building.bodies[0];
	unsigned form = pick(block, lot, 4, 5);

	*body = (struct body){
		.raise = form == 4 ? raise_ell
			: form < 3 ? raise_gabled
				   : raise_hipped,
		.frame = frame,
		.u = -6.5 + 0.5 * pick(block, lot, 5, 3),
		.width = 11 + 0.5 * pick(block, lot, 6, 4),
		.depth = form == 4 ? 13 : 9 + 0.5 * pick(block, lot, 7, 3),
		.eaves = 5.9,
		.rise = 3.4 + 0.25 * pick(block, lot, 8, 6),
		.storeys = 2,
		.bays = 3,
		.door = true,
	};
	building.roof = form < 3 ? "1030" : "1040";
	building.lod3 = pick(block, lot, 9, 4) == 0;
	add_chimney(body);
	if (form < 3 && body->rise > 4)
		add_dormer(body);
	if (form < 4 && pick(block, lot, 10, 2))
		add_balcony(body);
	put_up(block, &building);
}

static void
houses(const struct block *block)
{
	double x = block->x, y = block->y;

	for (unsigned lot = 0; lot < 3; lot++) {
		house(block, 2 * lot, town_frame(x + 12 + 24 * lot, y + 6, 0));
		house(block, 2 * lot + 1,
			town_frame(
				x + 12 + 24 * lot, y + BLOCK_DEPTH - 6, 180));
	}
	land_use_write(
		block->town, x, y, x + BLOCK_WIDTH, y + BLOCK_DEPTH, "1010");
	for (unsigned i = 0; i < 5; i++)
		tree_write(block->town, x + 8 + 13.5 * i,
			y + 24 + pick(block, i, 11, 5), pick(block, i, 12, 2));
}

/* ---- rows of houses that share their end walls ---- */

static void
row_house(const struct block *block, unsigned lot, struct frame frame,
	unsigned place, double eaves)
{
	struct building building = plain_building(block, lot);
	struct body *body = &building.bodies[0];
	struct town *town = block->town;

	*body = (struct body){
		.raise = raise_gabled,
		.frame = frame,
		.u = 14 * place,
		.width = 14,
		.depth = 10,
		.eaves = eaves,
		.rise = 4,
		.storeys = eaves > 8 ? 3 : 2,
		.bays = 4,
		.door = true,
	};
	building.solid_holds = false;
	if (place > 0 && (town->share_walls || !town->shared)) {
		building.shares_wall = true;
		town->shared = true;
	}
	if (place % 2 == 0)
		add_chimney(body);
	put_up(block, &building);
}

static void
rows(const struct block *block)
{
	double x = block->x, y = block->y;
	double eaves = 6.2 + 2.9 * pick(block, 0, 13, 2);

	for (unsigned place = 0; place < 4; place++)
		row_house(block, place, town_frame(x + 8, y + 3, 0), place,
			eaves);
	for (unsigned place = 0; place < 4; place++)
		row_house(block, 4 + place,
			town_frame(
				x + BLOCK_WIDTH - 8, y + BLOCK_DEPTH - 3, 180),
			place, 6.2);
	land_use_write(
		block->town, x, y, x + BLOCK_WIDTH, y + BLOCK_DEPTH, "1010");
	for (unsigned i = 0; i < 4; i++)
		tree_write(block->town, x + 12 + 16 * i, y + 26, i % 2);
}

/* ---- wings around a yard ---- */

static void
court(const struct block *block)
{
	struct building building = plain_building(block, 0);
	struct building pavilion = plain_building(block, 1);

	building.bodies[0] = (struct body){
		.raise = raise_court,
		.frame = town_frame(block->x + 5, block->y + 3, 0),
		.width = BLOCK_WIDTH - 10,
		.depth = BLOCK_DEPTH - 6,
		.eaves = 11.8,
		.rise = 4.2,
		.storeys = 4,
		.bays = 11,
		.door = true,
	};
	building.function = "1120";
	put_up(block, &building);
	pavilion.bodies[0] = (struct body){
		.raise = raise_hipped,
		.frame = town_frame(block->x + 32, block->y + 22, 0),
		.width = 8,
		.depth = 8,
		.eaves = 3.2,
		.rise = 2.6,
		.storeys = 1,
		.bays = 2,
		.door = true,
	};
	pavilion.roof = "1070";
	pavilion.house = 0;
	put_up(block, &pavilion);
	land_use_write(block->town, block->x, block->y, block->x + BLOCK_WIDTH,
		block->y + BLOCK_DEPTH, "1020");
	for (unsigned i = 0; i < 2; i++)
		tree_write(
			block->town, block->x + 22 + 28 * i, block->y + 26, 0);
}

/* ---- the market square ---- */

static void
church(const struct block *block)
{
	struct building building = plain_building(block, 0);
	double x = block->x, y = block->y;

	building.name = "St.-Änne-Kirche";
	building.function = "2700";
	building.year = 1487;
	building.wall = sandstone;
	building.paint = slate;
	building.body_count = 3;
	building.bodies[0] = (struct body){
		.raise = raise_gabled,
		.frame = town_frame(x + 24, y + 28, 0),
		.width = 30,
		.depth = 14,
		.eaves = 10,
		.rise = 8,
		.storeys = 3,
		.bays = 6,
		.door = true,
	};
	building.bodies[1] = (struct body){
		.raise = raise_hipped,
		.frame = town_frame(x + 15.9, y + 31, 0),
		.width = 8,
		.depth = 8,
		.eaves = 24,
		.rise = 17,
		.storeys = 7,
		.bays = 1,
		.door = true,
	};
	building.bodies[2] = (struct body){
		.raise = raise_round,
		.frame = town_frame(x + 54.2, y + 29, 0),
		.width = 12,
		.depth = 12,
		.eaves = 8,
		.rise = 6,
		.storeys = 1,
	};
	building.lod3 = true;
	put_up(block, &building);
	block->town->ensemble = building.number;
}

static void
square(const struct block *block)
{
	struct town *town = block->town;
	struct building market = plain_building(block, 1);
	double x = block->x, y = block->y;

	church(block);
	market.name = "Eishaus";
	market.has_void = true;
	market.roof = "1000";
	market.function = "2100";
	market.paint = gravel;
	market.bodies[0] = (struct body){
		.raise = raise_flat,
		.frame = town_frame(x + 3, y + 36, 0),
		.width = 9,
		.depth = 9,
		.eaves = 5,
		.storeys = 1,
		.bays = 2,
		.door = true,
	};
	put_up(block, &market);
	square_write(town, x, y);
	fitting_write(town, FITTING_FOUNTAIN, x + 36, y + 12);
	monument_write(town, x + 12, y + 12);
	grown_tree_write(town, x + 60, y + 12);
	for (unsigned i = 0; i < 6; i++) {
		fitting_write(town, FITTING_LAMP, x + 6 + 12 * i, y + 3);
		fitting_write(town, FITTING_BENCH, x + 6 + 12 * i, y + 22);
		tree_write(town, x + 6 + 12 * i, y + 24.5, 1);
	}
}

/* ---- the town hall ---- */

static void
hall(const struct block *block)
{
	struct building town_hall = plain_building(block, 0);
	struct building library = plain_building(block, 1);
	struct building tower = plain_building(block, 2);
	double x = block->x, y = block->y;

	town_hall.name = "Rathaus";
	town_hall.function = "1140";
	town_hall.lod3 = true;
	town_hall.paint = copper;
	town_hall.bodies[0] = (struct body){
		.raise = raise_hipped,
		.frame = town_frame(x + 4, y + 22, -90),
		.u = -24,
		.width = 40,
		.depth = 15,
		.eaves = 9.4,
		.rise = 6,
		.storeys = 3,
		.bays = 6,
		.door = true,
	};
	put_up(block, &town_hall);
	library.name = "Stadtbücherei";
	library.function = "2500";
	library.roof = "1000";
	library.lod3 = true;
	library.interior = true;
	library.paint = gravel;
	library.bodies[0] = (struct body){
		.raise = raise_flat,
		.frame = town_frame(x + 34, y + 6, 0),
		.width = 24,
		.depth = 14,
		.eaves = 6.6,
		.storeys = 2,
		.bays = 6,
		.door = true,
	};
	put_up(block, &library);
	tower.name = "Hexenturm";
	tower.paint = slate;
	tower.wall = sandstone;
	tower.roof = "1080";
	tower.bodies[0] = (struct body){
		.raise = raise_round,
		.frame = town_frame(x + 58, y + 38, 0),
		.width = 9,
		.depth = 9,
		.eaves = 16,
		.rise = 8,
		.storeys = 5,
	};
	put_up(block, &tower);
	land_use_write(
		block->town, x, y, x + BLOCK_WIDTH, y + BLOCK_DEPTH, "1140");
	for (unsigned i = 0; i < 5; i++)
		tree_write(block->town, x + 30 + 7 * i, y + 28, 0);
}

/* ---- park and works yard ---- */

static void
park(const struct block *block)
{
	struct town *town = block->town;
	double x = block->x, y = block->y;

	lawn_write(town, x, y, x + BLOCK_WIDTH, y + BLOCK_DEPTH);
	pond_write(town, x + 38, y + 27);
	hedge_write(town, x + 1, y + 4, x + 2.2, y + BLOCK_DEPTH - 4);
	for (unsigned i = 0; i < 12; i++)
		tree_write(town, x + 9 + 11 * (i % 6) + pick(block, i, 15, 4),
			y + 9 + 34 * (i / 6) + pick(block, i, 16, 4),
			pick(block, i, 17, 3) == 0);
	for (unsigned i = 0; i < 3; i++)
		fitting_write(town, FITTING_BENCH, x + 28 + 9 * i, y + 18.5);
}

static void
yard(const struct block *block)
{
	double x = block->x, y = block->y;

	for (unsigned i = 0; i < 3; i++) {
		struct building shed = plain_building(block, i);

		shed.function = "1350";
		shed.roof = i == 2 ? "1030" : "1000";
		shed.year = 1960 + 20 * i;
		shed.bodies[0] = (struct body){
			.raise = i == 2 ? raise_gabled : raise_flat,
			.frame =
				town_frame(x + 5 + (i == 1 ? 36 : 0), y + 6, 0),
			.width = i == 2 ? 60 : 28 - 2.0 * i,
			.depth = i == 2 ? 12 : 18,
			.eaves = 6.5 + i,
			.rise = i == 2 ? 2.4 : 0,
			.storeys = 1,
			.bays = 4,
			.door = true,
		};
		if (i == 2)
			shed.bodies[0].frame = town_frame(x + 5, y + 34, 0);
		else
			shed.paint = gravel;
		put_up(block, &shed);
	}
	land_use_write(
		block->town, x, y, x + BLOCK_WIDTH, y + BLOCK_DEPTH, "1700");
}

/* ---- the plan ---- */

static enum block_kind
kind_of(const struct town *town, unsigned column, unsigned row)
{
	static const enum block_kind centre[3][4] = {
		{BLOCK_ROW, BLOCK_HOUSES, BLOCK_COURT, BLOCK_HOUSES},
		{BLOCK_COURT, BLOCK_SQUARE, BLOCK_HALL, BLOCK_HOUSES},
		{BLOCK_HOUSES, BLOCK_COURT, BLOCK_PARK, BLOCK_YARD},
	};
	static const enum block_kind others[] = {
		BLOCK_HOUSES,
		BLOCK_HOUSES,
		BLOCK_HOUSES,
		BLOCK_HOUSES,
		BLOCK_ROW,
		BLOCK_ROW,
		BLOCK_ROW,
		BLOCK_COURT,
		BLOCK_COURT,
		BLOCK_PARK,
		BLOCK_YARD,
	};

	if (column < 4 && row < 3)
		return centre[row][column];
	return others[town_pick(town, 97 * column + 8191 * row + 5,
		sizeof others / sizeof *others)];
}

unsigned
block_buildings(const struct town *town, unsigned column, unsigned row)
{
	static const unsigned counts[] = {
		[BLOCK_HOUSES] = 6,
		[BLOCK_ROW] = 8,
		[BLOCK_COURT] = 2,
		[BLOCK_SQUARE] = 2,
		[BLOCK_HALL] = 3,
		[BLOCK_PARK] = 0,
		[BLOCK_YARD] = 3,
	};

	return counts[kind_of(town, column, row)];
}

/* Trees and lamps along the street south of the block. */
static void
avenue(const struct block *block)
{
	for (unsigned i = 0; i < 4; i++)
		tree_write(
			block->town, block->x + 9 + 18 * i, block->y - 0.5, 0);
	for (unsigned i = 0; i < 2; i++)
		fitting_write(block->town, FITTING_LAMP, block->x + 18 + 36 * i,
			block->y - 11.4);
}

void
block_write(struct town *town, unsigned column, unsigned row)
{
	static void (*const build[])(const struct block *) = {
		[BLOCK_HOUSES] = houses,
		[BLOCK_ROW] = rows,
		[BLOCK_COURT] = court,
		[BLOCK_SQUARE] = square,
		[BLOCK_HALL] = hall,
		[BLOCK_PARK] = park,
		[BLOCK_YARD] = yard,
	};
	const struct block block = {
		.town = town,
		.column = column,
		.row = row,
		.x = column * PITCH_X,
		.y = row * PITCH_Y,
		.salt = 10007 * column + 1299709 * row,
	};

	build[kind_of(town, column, row)](&block);
	avenue(&block);
}
