/*
 * STEP text for the sample house, instance by instance.
 *
 * Each function writes one instance, or a few, and returns the number of the
 * last, to be referred to. Lengths are millimetres.
 */
#ifndef TESSERA_HOUSE_STEP_H
#define TESSERA_HOUSE_STEP_H

#include <stdbool.h>
#include <stdio.h>

enum house_schema { HOUSE_2X3, HOUSE_4 };

struct house {
	FILE *file;
	enum house_schema schema;
	unsigned last; /* instance written */
	unsigned ids; /* GlobalIds given */
	unsigned history; /* IfcOwnerHistory */
	unsigned up; /* the direction along z */
	unsigned body; /* the context of bodies */
	unsigned storey_place;
};

#if defined(__GNUC__)
#define HOUSE_PRINTF __attribute__((format(printf, 2, 3)))
#else
#define HOUSE_PRINTF
#endif

/* Write "#n=" and the text, which is an instance without its semicolon. */
unsigned house_write(struct house *house, const char *format, ...) HOUSE_PRINTF;

/* A GlobalId that no other call gave; the same for the same count of calls. */
const char *house_id(struct house *house, char out[23]);

unsigned house_point(struct house *house, double x, double y, double z);
unsigned house_direction(struct house *house, double x, double y, double z);

/* An axis placement, along the axes of the one around it … */
unsigned house_axes(struct house *house, double x, double y, double z);

/* … or turned: z along one direction, x along another. */
unsigned house_turned(
	struct house *house, unsigned point, unsigned z, unsigned x);

/* A local placement relative to another; 0: to none. */
unsigned house_place(struct house *house, unsigned within, unsigned axes);

/* A box upwards from the middle of its base; x and y are its sizes. */
unsigned house_box(
	struct house *house, unsigned axes, double x, double y, double height);

/* A polygon of `count` corners, x and y in turn, pushed along z of the axes. */
unsigned house_prism(struct house *house, unsigned axes, const double *corners,
	size_t count, double height);

/* A product definition shape with one body; `type` as in 'SweptSolid'. */
unsigned house_shape(struct house *house, const char *type, unsigned item);

/* Paint an item. */
void house_paint(struct house *house, unsigned item, unsigned style);

/* A surface style. */
unsigned house_style(struct house *house, const char *name, double red,
	double green, double blue, double clear);

/*
 * A relation of one thing to a list of `count` others, or, with a count of 0,
 * to one that stands in no list.
 */
void house_relate(struct house *house, const char *entity, bool list_first,
	unsigned one, const unsigned *others, size_t count);

#endif
