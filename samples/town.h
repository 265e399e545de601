/*
 * The sample town: blocks of 72 m by 52 m in a grid of streets 12 m wide, a
 * river with a bridge and a railway with a tunnel south of them, hills around.
 *
 * Plans are in metres from the town's origin, x east and y north.
 */
#ifndef TESSERA_TOWN_H
#define TESSERA_TOWN_H

#include "town_building.h"
#include "town_gml.h"
#include "town_shape.h"

#define BLOCK_WIDTH 72.0
#define BLOCK_DEPTH 52.0
#define STREET 12.0
#define PITCH_X (BLOCK_WIDTH + STREET)
#define PITCH_Y (BLOCK_DEPTH + STREET)

/* The river's bed and the railway, from north to south, metres. */
#define RIVER_NORTH -22.0
#define RIVER_SOUTH -52.0
#define RAILWAY -66.0 /* its middle */
#define TUNNEL_LENGTH 70.0

/* How far the land reaches: east from the tunnel's start, north from the
   northernmost street. */
#define LAND_WEST -75.0
#define LAND_EAST 90.0
#define LAND_SOUTH -115.0
#define LAND_NORTH 55.0

struct town {
	struct gml *gml;
	struct shape shapes[2]; /* scratch */
	uint64_t seed;
	unsigned columns, rows; /* blocks */
	unsigned max_buildings; /* stop there */
	uint64_t max_bytes; /* or there; 0: no limit */
	unsigned buildings; /* so far */
	unsigned plants, fittings; /* trees, lamps and benches so far */
	unsigned ensemble; /* number of the church; 0: none yet */
	unsigned seen; /* bits: prototypes that are written already */
	bool share_walls; /* every row of houses shares its walls */
	bool shared; /* some wall is shared already */
};

/* The frame with its origin at a place of the plan. */
struct frame town_frame(double x, double y, double degrees);

/* A number from 0 to count - 1 that depends on the seed and the salt only. */
unsigned town_pick(const struct town *town, unsigned salt, unsigned count);

/* Where the railway enters the tunnel. */
double tunnel_start(const struct town *town);

bool town_full(const struct town *town);

/* A level rectangle of the plan, looking up, as the only face of a shape. */
void town_area(struct town *town, double x0, double y0, double x1, double y1,
	double z);

/* ---- town_block.c: the buildings of a block and what stands around them */
unsigned block_buildings(
	const struct town *town, unsigned column, unsigned row);
void block_write(struct town *town, unsigned column, unsigned row);

/* ---- town_street.c ---------------------------------------------------- */

/* The street that runs east south of a row of blocks. */
const char *street_name(unsigned row);
void street_write(struct town *town, unsigned column, unsigned row);
void pavement_colours_write(struct town *town);
void railway_write(struct town *town);
void square_write(struct town *town, double x, double y);

/* ---- town_land.c ------------------------------------------------------ */
void tile_relief_write(struct town *town, unsigned column, unsigned row);
void relief_write(struct town *town);
void river_write(struct town *town);
void pond_write(struct town *town, double x, double y);
void land_use_write(struct town *town, double x0, double y0, double x1,
	double y1, const char *function);

/* ---- town_works.c ----------------------------------------------------- */
void bridge_write(struct town *town, double x);
void tunnel_write(struct town *town, double x0, double x1);

/* ---- town_green.c: trees and fittings, at a place of the plan --------- */
enum fitting { FITTING_LAMP, FITTING_BENCH, FITTING_FOUNTAIN };

void tree_write(struct town *town, double x, double y, unsigned species);
void grown_tree_write(struct town *town, double x, double y);
void lawn_write(struct town *town, double x0, double y0, double x1, double y1);
void hedge_write(struct town *town, double x0, double y0, double x1, double y1);
void fitting_write(struct town *town, enum fitting kind, double x, double y);
void monument_write(struct town *town, double x, double y);
void group_write(struct town *town, unsigned first, unsigned count);

#endif
