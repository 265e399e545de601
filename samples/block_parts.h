/*
 * The parts that makeblock puts buildings together from. Each part is a closed
 * mesh and a building installation of its own; hulls, which close together, are
 * boundary surfaces and are written last, as CityGML orders them.
 */
#ifndef TESSERA_BLOCK_PARTS_H
#define TESSERA_BLOCK_PARTS_H

#include <stdint.h>

#include "town_gml.h"
#include "town_shape.h"

enum { BLOCK_SIDES = 64 }; /* of a round part, at most */

/* One building while it is written. */
struct block {
	struct gml *gml;
	struct shape *shape;
	struct frame frame;
	unsigned building;
	unsigned parts, triangles; /* written so far */
	unsigned part_goal, triangle_goal;
	uint64_t random;
};

/* From low to high. */
unsigned block_choice(struct block *block, unsigned low, unsigned high);
double block_length(struct block *block, double low, double high);

/* How many parts there are still to write, beside `others` to come. */
unsigned block_left(const struct block *block, unsigned others);

void block_box(struct block *block, const char *kind, struct local low,
	struct local high);
/* An upright prism over a footprint in (u, v), counterclockwise from above. */
void block_prism(struct block *block, const char *kind,
	const double (*outline)[2], unsigned count, double low, double high);
/* The same over a regular polygon. */
void block_round(struct block *block, const char *kind, struct local foot,
	double radius, unsigned sides, double high);
/* A cone with its tip above the middle. */
void block_cone(struct block *block, const char *kind, struct local foot,
	double radius, unsigned sides, double high);
/* A slanting beam of width `wide` along v, from one foot to another. */
void block_slant(struct block *block, const char *kind, struct local from,
	struct local to, double wide, double thick);
/* A beam of square section between two points at the same height. */
void block_beam(struct block *block, const char *kind, struct local from,
	struct local to, double thick);

enum { HULL_PARTS = 6 }; /* surfaces of a hull */

/* A box whose four walls are grids of quads, as fine as the goal allows. */
void block_hull(struct block *block, struct local low, struct local high);
/* A roof with its ridge along u that hangs over all around; one surface. */
void block_gable(struct block *block, struct local low, struct local high);

#endif
