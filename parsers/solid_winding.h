/*
 * How often faces go around a point, from their solid angles.
 */
#ifndef TESSERA_SOLID_WINDING_H
#define TESSERA_SOLID_WINDING_H

#include "solid_inside.h"

/*
 * Rounded to the nearest number. `at` is not on a face.
 *
 * source: A. van Oosterom and J. Strackee, The solid angle of a plane triangle,
 * 1983.
 */
struct solid_winding solid_winding_at(
	const struct solid_pieces *pieces, struct tcs_point at);

/* Whether a point of the piece's plane lies in it. Of pieces that share an edge
 * exactly one holds a point on it. */
bool solid_piece_holds(const struct solid_pieces *pieces,
	const struct solid_piece *piece, const struct solid_plane *plane,
	struct tcs_point at);

#endif
