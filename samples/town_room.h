/*
 * The inside of a building: two rooms one above the other, with furniture.
 * LOD4 in 1.0 and 2.0; in 3.0 LOD3, with a storey for each and a unit.
 */
#ifndef TESSERA_TOWN_ROOM_H
#define TESSERA_TOWN_ROOM_H

#include "town_building.h"

void rooms_write_2(struct gml *gml, const struct body *body, const char *id,
	struct shape *scratch);

void rooms_write_3(struct gml *gml, const struct body *body, const char *id,
	struct shape *scratch);

#endif
