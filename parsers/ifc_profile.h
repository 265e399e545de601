/*
 * Profiles as faces in their plane: z is 0, outer rings run counterclockwise,
 * holes clockwise.
 *
 * source: ISO 16739-1 8.15 (IfcProfileDef).
 */
#ifndef TESSERA_IFC_PROFILE_H
#define TESSERA_IFC_PROFILE_H

#include "ifc_shape.h"

/*
 * Append the faces of a profile's area; of several for a composite one, which
 * may touch. A profile without area, or that is a curve, is refused.
 */
enum ifc_outcome ifc_profile_faces(struct ifc_shaper *shaper, uint32_t profile,
	struct ifc_faces *out) TCS_CHECKED;

/*
 * A number of a profile: false unless it is there, finite and not negative. An
 * optional one that is not there is 0 where the caller set *out so.
 */
bool ifc_profile_number(const struct ifc_file *file, uint32_t profile,
	int position, double *out);

/* ---- ifc_profile_untangle.c ---------------------------------------------- */

/*
 * Where the rings of the last face cross themselves or each other, which the
 * standard forbids, put faces in its stead that do not: what is inside an odd
 * number of times (the rule that polygons of other formats are repaired by), so
 * that an 8 has two lobes. A remark is made about the profile. Fails as any
 * evaluator.
 */
enum ifc_outcome ifc_profile_untangle(struct ifc_shaper *shaper,
	uint32_t profile, struct ifc_faces *faces) TCS_CHECKED;

/* ---- ifc_profile_plain.c: with a centre, without Position ---------------- */

/* A corner of an outline, rounded with a radius that may be 0. */
struct ifc_corner {
	double x, y, radius;
};

/*
 * Close a ring over corners in order; radii too large for an edge are made
 * smaller by the same factor at both of its ends.
 */
enum ifc_outcome ifc_corners_ring(struct ifc_shaper *shaper,
	const struct ifc_corner *corners, size_t count,
	struct ifc_faces *out) TCS_CHECKED;

/*
 * Rectangles, circles, ellipses, trapeziums, hollow or not; any other goes on
 * to ifc_profile_steel.
 */
enum ifc_outcome ifc_profile_plain(struct ifc_shaper *shaper, uint32_t profile,
	struct ifc_faces *out) TCS_CHECKED;

/* ---- ifc_profile_steel.c ------------------------------------------------- */

/*
 * I, L, T, U, Z and C shapes, as above. Where a flange or leg slopes, its
 * thickness holds where the rolling standards measure it: I and T a quarter of
 * the width from the edge (DIN 1025-1, DIN 1024), U and L in the middle (DIN
 * 1026-1).
 */
enum ifc_outcome ifc_profile_steel(struct ifc_shaper *shaper, uint32_t profile,
	struct ifc_faces *out) TCS_CHECKED;

/* ---- ifc_profile_strip.c ------------------------------------------------- */

/*
 * IfcCenterLineProfileDef: as wide as its thickness, half of it to each side of
 * its curve, with mitres at corners and square ends. A closed curve makes a
 * face with a hole.
 */
enum ifc_outcome ifc_profile_strip(struct ifc_shaper *shaper, uint32_t profile,
	struct ifc_faces *out) TCS_CHECKED;

#endif
