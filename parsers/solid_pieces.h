/*
 * The faces of solids as convex pieces, each in one of the planes; and pieces
 * cut to the cells of a box, which tells what a cell still is to be cut by.
 *
 * Positions are relative to an origin from here on, and so are the planes.
 */
#ifndef TESSERA_SOLID_PIECES_H
#define TESSERA_SOLID_PIECES_H

#include "array.h"
#include "fault.h"
#include "solid.h"
#include "solid_cells.h"
#include "solid_planes.h"
#include "triangulate.h"

TCS_ARRAY_TYPE(solid_point_list, struct tcs_point);

struct solid_piece {
	uint32_t plane;
	uint32_t first, count; /* in points */
	uint32_t origin, face; /* as in struct solid_face */
	uint32_t label;
	signed char side; /* 1: the plane's normal points out of the solid;
	                     -1: into it; 0: a limit, of no solid */
};

/* All zero is empty. */
struct solid_pieces {
	TCS_ARRAY(struct solid_piece) list;
	struct solid_point_list points;
	struct solid_point_list ring_points; /* of the face at hand */
	struct solid_numbers ring_counts;
	struct triangulator *triangulator; /* when one was needed */
};

void solid_pieces_clear(struct solid_pieces *pieces);
void solid_pieces_release(struct solid_pieces *pieces);

/*
 * Append the pieces of a solid's faces: `turned` turns them over. Faces without
 * area are left out. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_pieces_add(struct solid_pieces *pieces,
	struct solid_planes *planes, const struct solid *solid,
	struct tcs_point origin, uint32_t number, bool turned,
	struct tcs_fault *fault) TCS_CHECKED;

/* Append a piece like another with points of its own. Fails with
 * TCS_NO_MEMORY. */
enum tcs_status solid_piece_add(struct solid_pieces *pieces,
	const struct solid_piece *like, const struct tcs_point *points,
	uint32_t count, struct tcs_fault *fault) TCS_CHECKED;

/* ---- pieces in cells --------------------------------------------------------- */

/* What of a piece lies in a cell. */
struct solid_item {
	uint32_t piece;
	uint32_t count; /* points, those of the items before it skipped */
};

TCS_ARRAY_TYPE(solid_item_list, struct solid_item);

struct solid_items {
	struct solid_item_list list;
	struct solid_point_list points;
};

void solid_items_release(struct solid_items *items);

/* How far the points reach below and above a plane. */
struct solid_range {
	double low, high;
};

struct solid_range solid_range_of(const struct solid_plane *plane,
	const struct tcs_point *points, size_t count);

/*
 * Append what of the points lies above the plane (side 1) or below it (-1).
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_items_clip(struct solid_items *items, uint32_t piece,
	const struct tcs_point *points, size_t count,
	const struct solid_plane *plane, int side,
	struct tcs_fault *fault) TCS_CHECKED;

/* Append all of the points. Fails with TCS_NO_MEMORY. */
enum tcs_status solid_items_add(struct solid_items *items, uint32_t piece,
	const struct tcs_point *points, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
