/*
 * Which plane is to cut a cell next.
 */
#ifndef TESSERA_SOLID_CHOOSE_H
#define TESSERA_SOLID_CHOOSE_H

#include "solid_pieces.h"

/*
 * The plane of one of the items, of which there is at least one, that parts the
 * others evenly and cuts few; or, where there are many, an axis and where on it
 * to cut them, *axis 0 to 2 and *at; otherwise *axis is -1.
 */
uint32_t solid_choose(const struct solid_pieces *pieces,
	const struct solid_plane *planes, double tolerance,
	const struct solid_item *items, size_t count,
	const struct tcs_point *points, int *axis, double *at);

#endif
