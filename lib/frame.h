/*
 * A local frame in metres: stream coordinates to metres east, north and up of
 * the stream's origin, and back.
 *
 * Projected, local and unknown systems are shifted and scaled. Geographic ones
 * go through a transverse Mercator projection centred on the origin, on the
 * GRS 80 ellipsoid: heights stay heights, and distances are true to one part
 * in a million within 9 km of the origin. Geocentric ones are rotated to east,
 * north, up at the origin.
 *
 * source: J. P. Snyder, Map projections, 1987, eq. 3-21 and 8-9 to 8-15.
 */
#ifndef TESSERA_FRAME_H
#define TESSERA_FRAME_H

#include "tcs.h"

struct frame {
	struct tcs_point origin;
	double scale[3]; /* metres per unit */
	enum tcs_crs_kind kind;
	double turn[9]; /* geocentric: the rotation to east, north, up */
	double meridian; /* geographic: the origin's meridian arc, metres */
};

/* `origin` replaces the one of the head; NULL keeps it. */
void frame_init(struct frame *frame, const struct tcs_crs *crs,
	const struct tcs_point *origin);

struct tcs_point frame_to_local(
	const struct frame *frame, struct tcs_point point);
struct tcs_point frame_from_local(
	const struct frame *frame, struct tcs_point point);

#endif
