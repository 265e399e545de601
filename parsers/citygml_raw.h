/*
 * One top-level feature as the XML parser leaves it: the feature tree with its
 * attributes is done, geometry is still text, links are still names.
 *
 * The reading thread fills a raw object, a worker turns it into a tcs_object
 * (citygml_build.h). All zero is empty; raw_clear keeps the room.
 */
#ifndef TESSERA_CITYGML_RAW_H
#define TESSERA_CITYGML_RAW_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "report.h"
#include "tcs.h"

/* A run of positions: a ring, a line string, a point. */
struct raw_ring {
	size_t first; /* its numbers: bytes of `positions` */
	size_t length;
	tcs_text id;
	uint32_t pos_count; /* single positions in it */
	bool has_list; /* a list of positions in it */
	bool interior; /* bounds a hole */
	uint8_t dimension; /* as declared; 0: not */
};

enum raw_shape { RAW_AREA, RAW_LINE, RAW_POINT };

struct raw_polygon {
	tcs_text id;
	uint32_t first_ring; /* the outer ring first */
	uint32_t ring_count;
	uint32_t line; /* in the file, for messages */
	uint32_t geometry; /* where it stands inline */
	uint8_t shape; /* enum raw_shape */
	bool swap; /* x and y come in the order north, east */
	bool degrees; /* x and y are degrees */
};

/* One entry of a geometry: a polygon inline, or a link to others. */
struct raw_member {
	uint32_t polygon; /* TCS_NONE for a link */
	tcs_text href; /* of a link: the id without '#', or a foreign URI */
	uint32_t shell; /* raw_shell index; TCS_NONE outside solids */
	bool reversed; /* below an odd number of orientation="-" */
};

struct raw_shell {
	tcs_text id;
	uint32_t geometry;
	uint32_t solid; /* counted from 0 within the geometry */
	bool interior;
};

/* A geometry property of a feature. */
struct raw_geometry {
	uint32_t feature;
	tcs_text id;
	tcs_text role;
	uint32_t first_member, member_count;
	uint32_t line;
	uint8_t lod;
	uint8_t kind; /* enum tcs_geometry_kind, or RAW_KIND_UNKNOWN */
	bool is_template; /* in coordinates of its own: a prototype */
};

#define RAW_KIND_UNKNOWN 255 /* the property only links */

/* A geometry element with an id, as the members below it. */
struct raw_target {
	tcs_text id;
	uint32_t first_member, member_end;
	bool reversed; /* by the orientation around it, which links to it
	                  do not see */
};

/* A template whose prototype no object before this one has brought. */
struct raw_template {
	uint32_t geometry;
	uint32_t prototype; /* its number in the stream */
};

/* A template placed: an ImplicitGeometry. */
struct raw_instance {
	double matrix[16]; /* as written */
	double anchor[3]; /* as written */
	tcs_text id;
	tcs_text href; /* to a template that is not known yet; else absent */
	uint32_t feature;
	uint32_t prototype; /* TCS_NONE: not known */
	uint32_t geometry; /* its own template, if it holds one, is this */
	uint32_t line;
	uint8_t lod;
	bool swap; /* the anchor comes north first */
	bool has_matrix, has_anchor;
};

/* How texture coordinates are given. */
enum raw_mapping {
	MAPPING_NONE, /* a material */
	MAPPING_LIST, /* ring by ring */
	MAPPING_MATRIX, /* worldToTexture */
	MAPPING_ORDER, /* ring by ring of polygons that follow each other */
};

/* Texture coordinates of one ring, as text. */
struct raw_texring {
	tcs_text ring; /* its id */
	size_t first; /* bytes of `positions` */
	size_t length;
};

/* What a theme puts on whatever has this id: a material or a texture. */
struct raw_paint {
	tcs_text theme;
	tcs_text target;
	tcs_text source; /* gml:id of the material or texture */
	tcs_text mapping_id; /* gml:id of its texture coordinates */
	tcs_text link; /* they are those with this mapping_id; absent: its own,
	                  or found */
	uint32_t material; /* of the stream's palette, or marked: of the
	                      object's (citygml_palette.h); TCS_NONE */
	uint32_t image; /* the same */
	uint32_t first_ring; /* MAPPING_LIST and _ORDER: of `texrings` */
	uint32_t ring_count;
	uint32_t matrix; /* MAPPING_MATRIX: of `texmatrices` */
	uint32_t first_polygon; /* MAPPING_ORDER: that of the first ring */
	uint8_t mapping; /* enum raw_mapping */
	bool back;
};

/* From (x, y, z, 1) to (s q, t q, q); row by row. */
struct raw_texmatrix {
	double at[12];
	bool east_first; /* x is easting; else positions are as written */
};

enum { MOST_THEMES = 64 }; /* that show the same material or texture */

/* A theme that shows a material or a texture of another theme, too. */
struct raw_alias {
	tcs_text theme;
	tcs_text source; /* gml:id of that */
};

#define MEMBER_TAG_MAX 1000 /* bytes of a tag whose place is kept */

/* Where a feature stands in the bytes of the document. */
struct raw_place {
	uint64_t member, member_end; /* the start tag around it; equal: none */
	uint64_t at, end; /* end is 0 where the place is not known */
	uint64_t number; /* counts top-level features of the file, from 0 */
	uint64_t line; /* of its first byte */
};

struct raw_object {
	struct tcs_object tree; /* text, features, attributes, relations */
	TCS_ARRAY(char) positions;
	TCS_ARRAY(struct raw_ring) rings;
	TCS_ARRAY(struct raw_polygon) polygons;
	TCS_ARRAY(struct raw_member) members;
	TCS_ARRAY(struct raw_shell) shells;
	TCS_ARRAY(struct raw_geometry) geometries;
	TCS_ARRAY(struct raw_target) targets;
	TCS_ARRAY(struct raw_paint) paints;
	TCS_ARRAY(struct raw_texring) texrings;
	TCS_ARRAY(struct raw_texmatrix) texmatrices;
	TCS_ARRAY(struct raw_alias) aliases;
	TCS_ARRAY(struct raw_template) templates;
	TCS_ARRAY(struct raw_instance) instances;
	struct report report; /* what the parser left out */
	struct tcs_palette palette; /* what its own appearance shows */
	struct raw_place place;
	bool has_links; /* a member links */
	bool waits; /* an instance links to a template not known yet */
	struct raw_object *next; /* of a list of ready or spare ones */
};

struct raw_object *raw_new(void); /* NULL without memory */
void raw_free(struct raw_object *raw);
void raw_clear(struct raw_object *raw);

/*
 * Note an item of the document: by its id, or by its line where `id` is NULL
 * or empty.
 */
enum tcs_status raw_report(struct report *report, enum report_severity severity,
	const char *item, const char *reason, const char *id, uint32_t line,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
