/*
 * Which geometries of an object are taken, by level of detail.
 *
 * A level is chosen per *host*: a building, a part, an installation, a room.
 * Surfaces and openings belong to their host and share its choice, so a wall
 * is never shown at one level and the roof over it at another. What a building
 * has at a lower level than one of its parts stands for the parts too, and is
 * not shown with them.
 */
#ifndef TESSERA_LOD_SELECT_H
#define TESSERA_LOD_SELECT_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "tcs.h"

enum {
	SELECT_HIGHEST = -1, /* the highest level that has triangles */
	SELECT_ALL = -2,
};

/* All zero is empty; reused from object to object. */
struct selection {
	TCS_ARRAY(uint32_t) hosts; /* per feature */
	TCS_ARRAY(uint8_t) best; /* per feature: rank of its best level */
	TCS_ARRAY(bool) geometries; /* per geometry: drawn */
	TCS_ARRAY(bool) instances; /* per instance: drawn */
};

/*
 * `lod` is a level or SELECT_…. A geometry without a level ranks below LOD 0.
 * Curves and points are never drawn and never count. Fails with TCS_NO_MEMORY.
 */
enum tcs_status selection_make(struct selection *selection,
	const struct tcs_object *object, int lod,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * For option tables (program.h): "0" to "4", into an int. Anything else
 * changes nothing, and what is wrong with it is returned.
 */
const char *lod_parse(void *target, const char *argument);

/* Whether what the class is in may stand for it: a BuildingPart. */
bool class_is_portion(unsigned class);

/* Whether a geometry is made of polygons: neither curves nor points. */
bool geometry_has_area(const struct tcs_geometry *geometry);

void selection_release(struct selection *selection);

#endif
