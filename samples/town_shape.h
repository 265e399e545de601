/*
 * The solids of the sample town, as lists of plane faces.
 *
 * A shape is built in metres in a frame of its own: u along the street, v away
 * from it, z up. Points are placed in the world and rounded to millimetres
 * once, by the same arithmetic, so that faces that meet there share the point
 * exactly. Faces wind counterclockwise seen from outside.
 */
#ifndef TESSERA_TOWN_SHAPE_H
#define TESSERA_TOWN_SHAPE_H

#include <stdbool.h>
#include <stddef.h>

enum {
	SHAPE_SPOTS = 4096,
	SHAPE_RINGS = 1024,
	SHAPE_FACES = 512,
	SHAPE_OPENINGS = 512,
};

/* A place in the world: easting, northing, height, in millimetres. */
struct spot {
	long x, y, z;
};

/* Where the local frame lies: its origin in millimetres, and u's direction. */
struct frame {
	struct spot origin;
	double cosine, sine;
};

enum face_class {
	FACE_GROUND,
	FACE_WALL,
	FACE_ROOF,
	FACE_EAVES, /* seen from below: an outer ceiling */
	FACE_DECK, /* walked on outside: an outer floor */
	FACE_INNER_WALL,
	FACE_FLOOR,
	FACE_CEILING,
	FACE_CLOSURE,
};

struct ring {
	size_t first, count; /* spots */
};

struct face {
	enum face_class class;
	size_t first_ring, ring_count; /* the outer one first */
	size_t first_opening, opening_count;
	bool party; /* a wall that the neighbour shares */
};

/* A window or door in a face; its ring winds as the face does. */
struct opening {
	struct ring ring;
	bool door;
};

struct shape {
	struct frame frame;
	size_t spot_count, ring_count, face_count, opening_count;
	struct spot spots[SHAPE_SPOTS];
	struct ring rings[SHAPE_RINGS];
	struct face faces[SHAPE_FACES];
	struct opening openings[SHAPE_OPENINGS];
	size_t shell_faces; /* faces of the outer shell; the rest is a void */
	long top; /* highest spot */
};

/* A point of a frame, metres. */
struct local {
	double u, v, z;
};

struct frame frame_at(long x, long y, long z, double degrees);
struct spot frame_place(const struct frame *frame, struct local local);

/* Forget all faces and build in this frame from now on. */
void shape_begin(struct shape *shape, struct frame frame);

/* Faces one by one: open a face, add its points; a hole adds further ones. */
size_t shape_face(struct shape *shape, enum face_class class);
void shape_point(struct shape *shape, double u, double v, double z);
void shape_hole(struct shape *shape);
size_t shape_polygon(struct shape *shape, enum face_class class,
	const struct local *points, size_t count);

/*
 * Windows in a wall whose foot runs from `left` to `right` seen from outside:
 * `bays` in each of `storeys`, and a door in the middle bay of the lowest.
 */
void shape_windows(struct shape *shape, size_t face, struct local left,
	struct local right, unsigned storeys, unsigned bays, bool door);

/* One opening by its foot points and its top. */
void shape_opening(struct shape *shape, size_t face, struct local left,
	struct local right, double top, bool door);

/*
 * A prism along u from u0 to u1 over a profile in (v, z), counterclockwise seen
 * from larger u. classes[i] is that of the face from point i to i + 1. Returns
 * its first face; the ends follow the `count` sides, that at u0 first.
 */
size_t shape_extrude(struct shape *shape, const double (*profile)[2],
	const enum face_class *classes, size_t count, double u0, double u1);

/* The same upright: a footprint in (u, v), counterclockwise from above. */
size_t shape_block(struct shape *shape, const double (*outline)[2],
	size_t count, double z0, double z1);

void shape_box(struct shape *shape, struct local low, struct local high);

/* A box that faces inwards: the faces of a void, or of a room. */
void shape_cavity(struct shape *shape, struct local low, struct local high,
	enum face_class wall, enum face_class floor, enum face_class ceiling);

#endif
