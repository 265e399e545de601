/*
 * Which feature has the geometry of another one at a lower level of detail.
 *
 * Down to LOD 3 every feature has its own. At LOD 2 what belongs to a door or
 * window belongs to its wall, and at LOD 0 and 1 all that is of a building or
 * of a part of one, belongs to it.
 *
 * source: CityGML 2.0 (OGC 12-019), 10.3.1 and 10.3.4, table of LODs.
 */
#ifndef TESSERA_LOD_HOME_H
#define TESSERA_LOD_HOME_H

#include "tcs.h"

/* homes[i] is the feature for feature i; `lod` may be TCS_LOD_NONE. */
void lod_homes_find(
	const struct tcs_object *object, unsigned lod, uint32_t *homes);

#endif
