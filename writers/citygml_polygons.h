/* Positions, rings and polygons, for the geometries made of them. */
#ifndef TESSERA_CITYGML_POLYGONS_H
#define TESSERA_CITYGML_POLYGONS_H

#include "citygml_compose.h"

/* The numbers of a position, in the source's order of axes. */
void shape_point(struct composer *composer, struct tcs_point point);
void shape_start_positions(struct composer *composer);

/* An element of GML with an id, or without for NULL. */
void shape_start_with_id(
	struct composer *composer, const char *name, const char *id);

/* An id is made up only where GML 3.2 or a link wants it. */
void shape_start(struct composer *composer, const char *name);
/* The same with an id that is made already, or NULL. */
void shape_start_named(
	struct composer *composer, const char *name, const char *id);
/* The same with the id as given, of the geometry or of a part of it. */
void shape_start_in(struct composer *composer, const char *name,
	const struct tcs_geometry *geometry, tcs_text given);

/* The n-th triangle of a part of a triangulated surface. */
void shape_patch(struct composer *composer, uint32_t polygon, uint32_t n);
void shape_rings(struct composer *composer, uint32_t polygon);

/* How many faces it is written as: one with rings, else those that its
 * triangles begin when they are joined. */
uint32_t shape_face_count(const struct composer *composer, uint32_t polygon);
void shape_polygon(struct composer *composer, uint32_t polygon, uint32_t face);

/*
 * What a geometry links to for a face of a polygon; NULL where it is written
 * in full, which it is at home unless it repeats another one.
 */
const char *shape_reference(const struct composer *composer, uint32_t polygon,
	uint32_t face, bool at_home);

/* Whether a geometry of its own turns it over. */
bool shape_is_reversed(const struct composer *composer, uint32_t polygon);

/* All faces of the polygon as members of a geometry of `feature`. */
void shape_members(struct composer *composer, uint32_t polygon,
	uint32_t feature, bool reversed);

#endif
