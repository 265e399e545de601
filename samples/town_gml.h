/*
 * CityGML text for the sample town, version 1.0, 2.0 or 3.0.
 *
 * What the versions call differently is told apart here and in the order in
 * which a feature writes its parts. Lengths are whole millimetres.
 */
#ifndef TESSERA_TOWN_GML_H
#define TESSERA_TOWN_GML_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "fault.h"
#include "town_shape.h"

#define GML_ID 64 /* room for an id of the town */
#define TOWN_NAME "Grünau am Wehr"
#define TOWN_CODE "76999"

/* How the coordinates of a ring are written. */
enum ring_style { STYLE_POS_LIST, STYLE_POS, STYLE_POINT_PROPERTY };

struct gml {
	FILE *file;
	int version; /* 1, 2 or 3 */
	bool lods[5]; /* which levels of detail to write */
	enum ring_style style;
	uint64_t written; /* bytes handed to the file */
	uint64_t serial; /* of ids that nobody refers to */
	bool failed; /* a write failed; gml_flush tells */
	bool in_void; /* within the inner shell of a solid */
	bool in_set; /* within a set of generic attributes */
	unsigned depth;
	size_t used;
	char buffer[1 << 16];
};

/* Everything written so far, buffered or not, in bytes. */
uint64_t gml_size(const struct gml *gml);

/* Fails with TCS_SYSTEM when any write so far has failed. */
enum tcs_status gml_flush(struct gml *gml, struct tcs_fault *fault) TCS_CHECKED;

/* One of two names, by version: that of 1.0 and 2.0, or that of 3.0. */
const char *gml_name(
	const struct gml *gml, const char *name_2, const char *name_3);

/* The name of a LOD property: "bldg:lod2Solid", or "core:lod2Solid". */
struct lod_name {
	char text[48];
};
struct lod_name gml_lod_name(const struct gml *gml, const char *module, int lod,
	const char *property);

/* ---- elements: `id` becomes gml:id, NULL gives none ------------------- */

void gml_open(struct gml *gml, const char *name, const char *id);
void gml_open_with(struct gml *gml, const char *name, const char *attribute,
	const char *value);
void gml_close(struct gml *gml, const char *name);
void gml_leaf(struct gml *gml, const char *name, const char *text);
void gml_leaf_with(struct gml *gml, const char *name, const char *attribute,
	const char *value, const char *text);
void gml_number(struct gml *gml, const char *name, long number);
void gml_metres(struct gml *gml, const char *name, long millimetres);
void gml_corner(struct gml *gml, const char *name, struct spot spot);
void gml_line(struct gml *gml, const char *text); /* as it is */
void gml_link(struct gml *gml, const char *name, const char *id);

/* An id that nobody refers to; GML 3.2 wants one on every geometry. */
void gml_fresh_id(struct gml *gml, char out[GML_ID]);

/* ---- geometry -------------------------------------------------------- */

void gml_point(struct gml *gml, struct spot spot);

/*
 * The rings of a face as a gml:Polygon, or with patch as a gml:Triangle. With
 * `openings` its openings are holes too.
 */
void gml_polygon(struct gml *gml, const char *id, const struct shape *shape,
	const struct face *face, bool openings);

/* One ring of a shape as a gml:Polygon, backwards when `reverse`. */
void gml_ring_polygon(struct gml *gml, const char *id,
	const struct shape *shape, struct ring ring, bool reverse);

/* A gml:Triangle of a TIN. */
void gml_triangle(struct gml *gml, const struct spot corner[3]);

/* gml:Solid and its outer shell, up to the members, and behind them. */
void gml_solid_open(struct gml *gml, const char *id);
void gml_solid_close(struct gml *gml);
/* Between the two: the outer shell is over, a void begins. */
void gml_solid_void(struct gml *gml);

/* Every face of a shape as surface members, ids fresh. */
void gml_members(struct gml *gml, const struct shape *shape, size_t first_face,
	size_t face_count);

/* A property with a MultiSurface of all faces of a shape. */
void gml_multi_surface(
	struct gml *gml, const char *property, const struct shape *shape);

/* A property with a Solid of all faces of a shape. */
void gml_solid(
	struct gml *gml, const char *property, const struct shape *shape);

/* ---- what every module uses ------------------------------------------ */

/* <core:cityObjectMember><name gml:id="id"> and back. */
void gml_member_open(struct gml *gml, const char *name, const char *id);
void gml_member_close(struct gml *gml, const char *name);

/* A boundary surface of a host in `module` ("bldg"): property and feature. */
void gml_boundary_open(
	struct gml *gml, const char *module, const char *class, const char *id);
void gml_boundary_close(struct gml *gml, const char *module, const char *class);

/* The class of a face; 1.0 has no outer ceilings and floors. */
const char *gml_surface_class(const struct gml *gml, enum face_class class);

/* A boundary surface for each face of a host at LOD2, and a solid of them. */
void gml_bounding(struct gml *gml, const char *module, const char *host,
	const struct shape *shape);
void gml_bounded_solid(struct gml *gml, const char *module, const char *host,
	const struct shape *shape);

/* class, function or usage: a code with its code space. */
void gml_code(struct gml *gml, const char *name, const char *code);

/* Generic attributes: one of the six types, "string", "int", "double", "date",
   "uri", "measure"; `unit` for a measure only. 1.0 has no measure. */
void gml_generic(struct gml *gml, const char *type, const char *name,
	const char *value, const char *unit);
void gml_generic_set_open(
	struct gml *gml, const char *name, const char *code_space);
void gml_generic_set_close(struct gml *gml);

/* An address, as property `property` of a feature. */
void gml_address(struct gml *gml, const char *property, const char *street,
	unsigned number);

/* One X3DMaterial without its closing tag, so that targets can follow. */
struct colour {
	unsigned char red, green, blue;
	unsigned char clear; /* transparency in percent */
};
void gml_material_open(struct gml *gml, const char *id, struct colour colour);
void gml_material_close(struct gml *gml);

/* An appearance, on the model or on the feature, up to its materials. */
void gml_appearance_open(
	struct gml *gml, bool global, const char *id, const char *theme);
void gml_appearance_close(struct gml *gml, bool global);

/* The root element with name and envelope, and its end. */
void gml_begin(struct gml *gml, struct spot lower, struct spot upper);
void gml_end(struct gml *gml);

#endif
