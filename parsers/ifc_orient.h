/*
 * Faces of a shell turned so that they agree.
 *
 * source: neighbours of an oriented surface use a common edge in opposite
 * directions (ISO 10303-42 5.2).
 */
#ifndef TESSERA_IFC_ORIENT_H
#define TESSERA_IFC_ORIENT_H

#include "ifc_shape.h"

/*
 * Turn some of the groups of faces from `first_face` on so that, wherever just
 * two of them share edges, they run along them in opposite directions: of two
 * ways, that which turns fewer groups. groups[i] is where group i begins, the
 * first one at first_face. Where that contradicts itself, the first edges of
 * the file decide.
 */
enum ifc_outcome ifc_groups_orient(const uint32_t *groups, size_t group_count,
	struct ifc_faces *faces) TCS_CHECKED;

#endif
