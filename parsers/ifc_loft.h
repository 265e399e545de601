/*
 * Faces between sections: the same rings at one station after the other.
 *
 * source: ISO 16739-1 8.8.3 (swept and sectioned solids).
 */
#ifndef TESSERA_IFC_LOFT_H
#define TESSERA_IFC_LOFT_H

#include "ifc_shape.h"

/* Sections, station after station; all zero is empty. */
struct ifc_loft {
	const uint32_t *rings; /* points of each ring; borrowed */
	size_t ring_count;
	struct ifc_points points; /* of all rings, for each station */
	bool closed; /* the last station is followed by the first one */
};

/*
 * Append the faces of a solid: the first section, the last one, and plane faces
 * between the edges of neighbouring ones, turned outwards all together. What
 * lies between two edges that are not in a plane becomes two triangles. Where
 * points of both sections are the same, bit for bit, there is no face, or a
 * triangle. Fewer than two stations, and a solid without volume, are refused.
 */
enum ifc_outcome ifc_loft_faces(struct ifc_shaper *shaper,
	const struct ifc_loft *loft, struct ifc_faces *out) TCS_CHECKED;

/*
 * Make two faces have as many points in each ring, by points within edges, at
 * the same parts of the rings' lengths, unless they have already. Different
 * counts of rings are refused.
 */
enum ifc_outcome ifc_loft_match(struct ifc_shaper *shaper, uint32_t item,
	struct ifc_faces *a, struct ifc_faces *b) TCS_CHECKED;

#endif
