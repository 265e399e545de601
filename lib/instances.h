/*
 * Placed prototypes as plain geometry: each instance of an object gives way to
 * a copy of what it places, where it places it.
 *
 * A copy belongs to the feature that places it, surfaces included, and has its
 * level of detail; the first geometry has the id of the instance. Polygons,
 * rings and shells of a copy have no ids, for those of the prototype would be
 * there as often as it is placed. Paints and texture coordinates are kept; what
 * a prototype places itself is not followed.
 * Under a matrix that mirrors, triangles are turned, so that their outside
 * stays outside, and wind against the rings.
 *
 * source: ISO 19136, CityGML 2.0 (OGC 12-019) 8.3: point = anchor + matrix ·
 * point of the prototype. In geographic systems the product is in metres east,
 * north and up of the anchor.
 */
#ifndef TESSERA_INSTANCES_H
#define TESSERA_INSTANCES_H

#include "prototypes.h"
#include "tcs.h"

/*
 * Expand all instances of a decoded object. What it lent is copied where it
 * grows; without instances nothing changes. Fails with TCS_NO_MEMORY, and with
 * TCS_LIMIT where copies of more than `most` bytes are asked for, an array
 * would have 2^32 elements or a position would be no finite number; the object
 * is then good for nothing but its release.
 */
enum tcs_status instances_expand(struct tcs_object *object,
	const struct prototypes *prototypes, const struct tcs_crs *crs,
	uint64_t most, struct tcs_fault *fault) TCS_CHECKED;

#endif
