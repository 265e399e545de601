/*
 * A building of the sample town: its bodies, its facts, and how it is written.
 */
#ifndef TESSERA_TOWN_BUILDING_H
#define TESSERA_TOWN_BUILDING_H

#include "town_gml.h"
#include "town_shape.h"

enum installation_kind {
	INSTALLATION_NONE,
	INSTALLATION_CHIMNEY,
	INSTALLATION_DORMER,
	INSTALLATION_BALCONY,
};

/* A box in the body's frame that stands on, in or at it. */
struct installation {
	enum installation_kind kind;
	struct local low, high;
};

struct body;

/* Build the faces of a body, windows included, into an empty shape. */
typedef void body_raise(struct shape *shape, const struct body *body);

/* One closed volume. Lengths in metres, in its frame. */
struct body {
	body_raise *raise;
	struct frame frame;
	double u, width; /* from u to u + width along the street */
	double depth;
	double eaves; /* height of the walls */
	double rise; /* from the eaves to the ridge */
	unsigned storeys, bays;
	bool door;
	struct installation installations[3];
};

struct building {
	unsigned number; /* unique in the town */
	const char *name; /* NULL: none */
	const char *street;
	unsigned house; /* house number; 0: no address */
	const char *function, *roof; /* codes */
	unsigned year;
	struct colour wall, paint; /* of the walls and of the roof */
	bool painted; /* has an appearance of its own */
	bool lod3;
	bool interior; /* rooms, furniture, storeys, units */
	bool solid_holds; /* the LOD2 solid holds the polygons, and the
	                     surfaces link to them; else the reverse */
	bool has_void;
	bool shares_wall; /* its first end wall is that of number - 1 */
	unsigned body_count; /* more than one: building parts */
	struct body bodies[3];
};

/* The ways to raise a body. */
body_raise raise_gabled; /* pitched roof with eaves; the ends at u */
body_raise raise_hipped; /* pyramid where width equals depth */
body_raise raise_flat; /* with a parapet */
body_raise raise_ell; /* two gabled wings around a corner */
body_raise raise_court; /* four wings around a yard */
body_raise raise_round; /* octagon with a spire */

/* Write it as a city object. `scratch` has room for two shapes. */
void building_write(struct gml *gml, const struct building *building,
	struct shape scratch[2]);

/* The id of a building, and of the LOD2 polygon that a neighbour shares. */
void building_id(char out[GML_ID], unsigned number);

#endif
