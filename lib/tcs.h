/*
 * The tessera component stream: what every stage reads and writes.
 *
 * A stream is a sequence of records: one head, then palettes, prototypes and
 * objects in any order (an entry stands before what refers to it), then one
 * end record. tcs(5) specifies the bytes; this header is the same format as C
 * structs, and the arrays of a decoded record point straight into its bytes.
 *
 * Model. An *object* is one top-level feature (a building, a bridge, a relief)
 * with everything below it: a tree of features, their attributes, and their
 * geometries. A geometry owns polygons; a polygon owns a run of vertices,
 * rings and triangles, and belongs to one surface (a feature: the wall, the
 * roof, or the host itself). Polygons share no vertices: equal positions, bit
 * for bit, are the same point. Reading a stream and writing it again changes
 * nothing.
 *
 * Text. Every string of a record lives in its `text` array, NUL-terminated
 * UTF-8, and is named by its byte offset there. Offset 0 is the empty string
 * and means "absent".
 *
 * Index types. Indices count from 0 within the record. TCS_NONE means none.
 */
#ifndef TESSERA_TCS_H
#define TESSERA_TCS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "array.h"
#include "fault.h"

#define TCS_NONE UINT32_MAX
#define TCS_VERSION 1

/* Byte offset of a string in the record's text; 0 is "absent". */
typedef uint32_t tcs_text;

/* The text of a record: one string behind the other, each with its NUL. */
TCS_ARRAY_TYPE(tcs_strings, char);

/* ---- objects --------------------------------------------------------- */

/*
 * One node of the feature tree. Feature 0 is the object itself and the only
 * one without a parent; a parent stands before its children.
 */
struct tcs_feature {
	tcs_text id; /* gml:id or GlobalId as given */
	tcs_text name; /* the first gml:name */
	tcs_text type; /* the source's own type name where the class
	                  does not give it back: "IfcWall", "uro:Dam" */
	tcs_text role; /* the property that holds it in its parent, where
	                  the class does not tell: "interiorRoom" */
	uint32_t parent; /* feature index; TCS_NONE for feature 0 */
	uint16_t class; /* enum tcs_class of labels.h */
	uint16_t flags; /* 0 */
};

enum tcs_attribute_type {
	TCS_STRING,
	TCS_INTEGER,
	TCS_DOUBLE,
	TCS_BOOLEAN,
	TCS_DATE, /* ISO 8601 */
	TCS_URI,
	TCS_MEASURE, /* a number with a unit */
	TCS_CODE, /* a string with a code space */
	TCS_SET, /* no value; its members name it as parent */
};

enum {
	TCS_ATTRIBUTE_GENERIC = 1, /* a gen:…Attribute, not a standard one */
};

/*
 * One attribute. Attributes of one feature stand together, features in
 * order; what has members, a set or a value with XML attributes of its own
 * ("@name"), stands before them. `value` keeps the source's spelling;
 * `number` is its meaning for TCS_INTEGER, TCS_DOUBLE, TCS_MEASURE and
 * TCS_BOOLEAN (0 or 1), and NaN where the spelling has none.
 */
struct tcs_attribute {
	double number;
	uint32_t feature;
	uint32_t parent; /* attribute that it is a member of; TCS_NONE: none */
	tcs_text name; /* local name, or the generic attribute's name */
	tcs_text space; /* namespace prefix for names outside CityGML ("uro") */
	tcs_text value;
	tcs_text unit; /* uom */
	tcs_text code_space;
	uint16_t type; /* enum tcs_attribute_type */
	uint16_t flags; /* TCS_ATTRIBUTE_… */
};

/* A link from a feature to one that is not its child, by id. */
struct tcs_relation {
	uint32_t feature;
	tcs_text role; /* "groupMember", "buildingRoom", "fills", … */
	tcs_text target; /* id or URI as given, without a leading '#' */
	tcs_text note; /* the role attribute of a group member; else absent */
};

enum tcs_geometry_kind {
	TCS_SOLID, /* one shell outside, voids inside */
	TCS_MULTI_SOLID,
	TCS_COMPOSITE_SOLID,
	TCS_MULTI_SURFACE,
	TCS_COMPOSITE_SURFACE,
	TCS_TIN,
	TCS_MULTI_CURVE, /* polygons are line strings: one ring, not closed */
	TCS_MULTI_POINT, /* polygons are points: one ring of one vertex */
};

#define TCS_LOD_NONE 255 /* the source gives no LOD */

enum {
	TCS_GEOMETRY_SIMPLIFIED = 1, /* derived: polygons may have no rings */
};

/* One geometry property of one feature at one LOD. */
struct tcs_geometry {
	uint32_t feature; /* the feature that owns the property */
	tcs_text id; /* gml:id of the outermost geometry */
	tcs_text role; /* property name where kind and LOD do not tell:
	                  "lod0FootPrint", "lod0RoofEdge" */
	uint32_t first_shell; /* shells: none for surfaces, curves, points */
	uint32_t shell_count;
	uint32_t first_polygon;
	uint32_t polygon_count;
	uint8_t lod; /* 0…4 or TCS_LOD_NONE */
	uint8_t kind; /* enum tcs_geometry_kind */
	uint16_t flags; /* TCS_GEOMETRY_… */
};

/* A closed surface of a solid. A geometry's polygons are those of its shells,
 * in order. */
struct tcs_shell {
	tcs_text id;
	uint32_t first_polygon;
	uint32_t polygon_count;
	uint32_t solid; /* which solid of the geometry, from 0 */
	uint32_t interior; /* 0: the outside; 1: a void */
};

enum {
	/* Triangles wind against the rings (OrientableSurface "-"). */
	TCS_POLYGON_REVERSED = 1,
	/* The rings were repaired or re-triangulated: extra vertices may
	   follow the ring vertices, and areas follow the repair. */
	TCS_POLYGON_REPAIRED = 2,
	/* The same polygon (by id) stands in an earlier geometry, or in
	   another object, too. */
	TCS_POLYGON_SHARED = 4,
};

/*
 * A planar piece of one surface. Its vertices are those of its rings, in
 * order, the outer ring first and no ring repeating its first vertex at the
 * end; further vertices may follow. Triangles index vertices of the object,
 * within the polygon's own run, and wind counterclockwise seen from outside.
 *
 * A polygon without rings is no longer the original: its triangles are all
 * that is left of it, they need not lie in one plane, and where one polygon
 * ends says nothing. A filter that changes triangles leaves the rings out,
 * keeps the id where one original stands behind it, and clears the flags;
 * writers join what lies in one plane.
 */
struct tcs_polygon {
	tcs_text id;
	uint32_t surface; /* feature index: the wall, roof, … it belongs to */
	uint32_t first_vertex;
	uint32_t vertex_count;
	uint32_t first_ring;
	uint32_t ring_count;
	uint32_t first_triangle;
	uint32_t triangle_count;
	uint32_t flags; /* TCS_POLYGON_… */
};

struct tcs_ring {
	tcs_text id;
	uint32_t first_vertex;
	uint32_t vertex_count;
};

/* Stream coordinates: easting, northing, up, in the header's units. */
struct tcs_point {
	double x, y, z;
};

struct tcs_triangle {
	uint32_t corner[3]; /* vertex indices */
};

enum {
	TCS_PAINT_BACK = 1, /* paints the back of the polygon */
};

/*
 * How one theme paints one polygon: a material, a texture, or both. With a
 * texture, `first_texcoord` is the coordinate of the polygon's first vertex
 * and one follows for each of its vertices; these runs follow each other in
 * the order of the paints.
 */
struct tcs_paint {
	uint32_t polygon;
	tcs_text theme;
	uint32_t material; /* entry of the stream's materials; TCS_NONE */
	uint32_t image; /* entry of the stream's images; TCS_NONE */
	uint32_t first_texcoord; /* TCS_NONE without a texture */
	uint32_t flags; /* TCS_PAINT_… */
};

struct tcs_texcoord {
	double s, t; /* t = 0 is the image's lower edge, as in CityGML */
};

/*
 * A prototype placed in the world (CityGML ImplicitGeometry, IfcMappedItem):
 * point = anchor + matrix · point of the prototype.
 */
struct tcs_instance {
	double matrix[16]; /* row by row, as CityGML writes it */
	struct tcs_point anchor; /* reference point */
	uint32_t feature;
	uint32_t prototype; /* the stream's prototypes, from 0 */
	tcs_text id;
	uint16_t lod; /* 0…4 or TCS_LOD_NONE */
	uint16_t flags; /* 0 */
};

/*
 * One object, or one prototype (then in coordinates of its own). Owned by the
 * caller and reused: all zero is empty, object_clear keeps the room.
 */
struct tcs_object {
	struct tcs_strings text;
	TCS_ARRAY(struct tcs_feature) features;
	TCS_ARRAY(struct tcs_attribute) attributes;
	TCS_ARRAY(struct tcs_relation) relations;
	TCS_ARRAY(struct tcs_geometry) geometries;
	TCS_ARRAY(struct tcs_shell) shells;
	TCS_ARRAY(struct tcs_polygon) polygons;
	TCS_ARRAY(struct tcs_ring) rings;
	TCS_ARRAY(struct tcs_point) vertices;
	TCS_ARRAY(struct tcs_triangle) triangles;
	TCS_ARRAY(struct tcs_paint) paints;
	TCS_ARRAY(struct tcs_texcoord) texcoords;
	TCS_ARRAY(struct tcs_instance) instances;
};

void object_release(struct tcs_object *object);
void object_clear(struct tcs_object *object);

/* The string at an offset of the object; "" for 0. Valid until text grows. */
const char *object_text(const struct tcs_object *object, tcs_text text);

/*
 * Append a string to a record's text array and name it in *out. The empty
 * string is always 0. Bytes that are not UTF-8 and NULs are the caller's
 * concern (see utf8.h). Fails with TCS_NO_MEMORY, or TCS_LIMIT past 4 GiB.
 */
#define text_append(record, string, length, out, fault) \
	text_append_to(&(record)->text, (string), (length), (out), (fault))
enum tcs_status text_append_to(struct tcs_strings *text, const char *string,
	size_t length, tcs_text *out, struct tcs_fault *fault) TCS_CHECKED;

/* ---- the head -------------------------------------------------------- */

enum tcs_crs_kind {
	TCS_CRS_UNKNOWN, /* taken as a plane in metres */
	TCS_CRS_PROJECTED,
	TCS_CRS_GEOGRAPHIC, /* x is longitude, y latitude, in degrees */
	TCS_CRS_GEOCENTRIC,
	TCS_CRS_LOCAL, /* an engineering system, by declaration */
};

enum {
	/* The source writes northing or latitude first; x and y were
	   exchanged so that stream coordinates are easting first. */
	TCS_CRS_NORTH_FIRST = 1,
	/* The kind, unit or axis order was assumed; `assumed` says how. */
	TCS_CRS_ASSUMED = 2,
	TCS_HAS_BOUNDS = 4,
	TCS_HAS_ORIGIN = 8,
};

/* What the coordinates of the stream mean. Exactly one per head. */
struct tcs_crs {
	double metres_per_unit; /* of x and y; 1 for geographic systems */
	double metres_per_unit_up; /* of z */
	struct tcs_point origin; /* a point near the data, for those who must
	                            go to small floats; positions are absolute */
	struct tcs_point lower; /* bounds of the data, when known */
	struct tcs_point upper;
	tcs_text name; /* srsName as given */
	tcs_text assumed; /* what was assumed about it, in words */
	int32_t epsg; /* horizontal or compound EPSG code; 0 unknown */
	int32_t epsg_up; /* vertical EPSG code; 0 unknown */
	uint32_t kind; /* enum tcs_crs_kind */
	uint32_t flags; /* TCS_CRS_…, TCS_HAS_… */
};

/* Who worked on the stream, in order. */
struct tcs_stage {
	tcs_text program;
	tcs_text version;
	tcs_text arguments; /* as given, separated by blanks */
};

struct tcs_source {
	tcs_text format; /* "CityGML 2.0", "IFC4" */
	tcs_text name; /* file name without its folders; absent for stdin */
};

/* What a source says of all it holds, where it does. */
struct tcs_model {
	tcs_text id; /* gml:id of the CityModel, … */
	tcs_text name;
	tcs_text description;
};

struct tcs_head {
	struct tcs_strings text;
	TCS_ARRAY(struct tcs_crs) crs; /* exactly one */
	TCS_ARRAY(struct tcs_source) sources;
	TCS_ARRAY(struct tcs_model) models;
	TCS_ARRAY(struct tcs_stage) stages;
};

void head_release(struct tcs_head *head);
const char *head_text(const struct tcs_head *head, tcs_text text);

/* Sign the head: append a stage. */
enum tcs_status head_sign(struct tcs_head *head, const char *program,
	const char *version, const char *arguments,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- palettes: images and materials ----------------------------------- */

enum tcs_wrap {
	TCS_WRAP_NONE,
	TCS_WRAP_REPEAT,
	TCS_WRAP_MIRROR,
	TCS_WRAP_CLAMP,
	TCS_WRAP_BORDER,
};

struct tcs_image {
	float border[4]; /* colour outside the image, red green blue alpha */
	tcs_text id; /* of the texture, as given */
	tcs_text uri; /* as given */
	tcs_text mime; /* as given */
	tcs_text type; /* "specific", "typical", "unknown" as given */
	uint32_t wrap; /* enum tcs_wrap */
	uint32_t reserved; /* 0 */
	uint64_t first_byte; /* the encoded image, where embedded */
	uint64_t byte_count; /* 0: not embedded */
};

/* X3DMaterial, CityGML 2.0 9.2. Colours are sRGB 0…1. */
struct tcs_material {
	float diffuse[3];
	float emissive[3];
	float specular[3];
	float ambient; /* ambientIntensity 0…1 */
	float shininess; /* 0…1 */
	float transparency; /* 0 opaque … 1 clear */
	tcs_text id;
	uint32_t smooth; /* 0 or 1 */
};

/*
 * Entries appended to the stream's tables of images and materials. Entry n of
 * the stream is the n-th entry, from 0, over all palettes so far.
 */
struct tcs_palette {
	struct tcs_strings text;
	TCS_ARRAY(struct tcs_image) images;
	TCS_ARRAY(struct tcs_material) materials;
	TCS_ARRAY(unsigned char) bytes;
};

void palette_release(struct tcs_palette *palette);
void palette_clear(struct tcs_palette *palette);
const char *palette_text(const struct tcs_palette *palette, tcs_text text);

/* Append the entries of `more` to `all`, to follow a stream's tables. */
enum tcs_status palette_append(struct tcs_palette *all,
	const struct tcs_palette *more, struct tcs_fault *fault) TCS_CHECKED;

/* ---- records ---------------------------------------------------------- */

#define TCS_TAG(a, b, c, d) \
	((uint32_t)(a) | (uint32_t)(b) << 8 | (uint32_t)(c) << 16 | \
		(uint32_t)(d) << 24)

enum tcs_record_type {
	TCS_HEAD = TCS_TAG('H', 'E', 'A', 'D'),
	TCS_PALETTE = TCS_TAG('P', 'A', 'L', 'T'),
	TCS_PROTOTYPE = TCS_TAG('P', 'R', 'O', 'T'),
	TCS_OBJECT = TCS_TAG('O', 'B', 'J', 'T'),
	TCS_END = TCS_TAG('E', 'N', 'D', ' '),
};

enum {
	TCS_RECORD_COMPRESSED = 1, /* the payload is a zlib stream */
};

/* What has passed in a stream so far; the end record carries it. */
struct tcs_tally {
	uint64_t objects;
	uint64_t prototypes;
	uint64_t images;
	uint64_t materials;
	uint64_t features;
	uint64_t polygons;
	uint64_t triangles;
	uint64_t instances;
};

/*
 * One record as bytes, owned by the caller and reused; all zero is empty.
 * `bytes` is the payload, uncompressed, 8-byte aligned. `type` is an
 * enum tcs_record_type, or another: such a record is passed on as it is.
 */
struct tcs_record {
	uint32_t type;
	uint64_t at; /* offset of the record in the stream, for messages */
	struct tcs_tally before; /* what had passed when it was read */
	TCS_ARRAY(unsigned char) bytes;
	TCS_ARRAY(unsigned char) spare; /* room to encode what it lent */
};

void record_release(struct tcs_record *record);

/*
 * Decode: the arrays of *out are lent by the record and valid until the record
 * changes; what the caller writes into them changes the record's bytes. All
 * counts, indices, ranges, order and text are checked, so that whoever reads
 * the struct need not: the rules of object_check, and that images, materials
 * and prototypes it refers to stand before it in the stream (record->before).
 * Fails with TCS_BAD_INPUT.
 */
enum tcs_status object_decode(struct tcs_object *out,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status head_decode(struct tcs_head *out,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status palette_decode(struct tcs_palette *out,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Encode into record->bytes and set record->type. The struct must keep the
 * rules that decoding checks: breaking one is the caller's bug, found by
 * object_check. Its arrays may be lent by the same record; then they stay as
 * they are until the next encoding. The bytes are canonical: text that nothing
 * names is left out, equal strings are written once, in the order of first
 * use. Fails with TCS_NO_MEMORY.
 */
enum tcs_status object_encode(const struct tcs_object *object,
	enum tcs_record_type type, /* TCS_OBJECT or TCS_PROTOTYPE */
	struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status head_encode(const struct tcs_head *head,
	struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status palette_encode(const struct tcs_palette *palette,
	struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The paints of an encoded object or prototype, lent by the record: writing
 * into them changes its bytes, and nothing is checked. For who numbers materials
 * and images only when the object's turn comes.
 */
enum tcs_status record_paints(struct tcs_record *record,
	struct tcs_paint **paints, size_t *count,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * The rules of an object, whether decoded or about to be encoded:
 * - feature 0 has no parent, every other names an earlier one;
 * - attributes stand in the order of their features; a member stands behind
 *   what it is a member of and belongs to the same feature;
 * - runs follow each other without gap or overlap, in the order of their
 *   owners, and an empty run begins where the one before ended: a geometry's
 *   polygons and shells, a shell's polygons, a polygon's vertices, rings and
 *   triangles, a paint's texture coordinates;
 * - solids with polygons have shells, which cover them; nothing else has;
 * - a polygon's rings have at least one vertex each and begin at its first
 *   vertex; its triangles have their corners among its own vertices; curves
 *   and points have no triangles;
 * - a paint has texture coordinates if and only if it has an image;
 * - indices are in range, enumerations too, but a class may be a newer one;
 * - positions, texture coordinates, matrices are finite (the number of an
 *   attribute need not be);
 * - text begins and ends with NUL and is UTF-8; an offset names the start of
 *   a string, and only 0 names the empty one.
 * What it refers to in the stream's tables is checked by object_decode.
 * Fails with TCS_BAD_INPUT.
 */
enum tcs_status object_check(
	const struct tcs_object *object, struct tcs_fault *fault) TCS_CHECKED;

/* ---- reading and writing a stream -------------------------------------- */

/*
 * A reader over a stdio stream, which it does not own and from which nothing
 * was read before. All zero is not a valid reader: reader_init. Not for use by
 * two threads at once.
 */
struct tcs_reader {
	FILE *file;
	uint64_t at; /* bytes read */
	uint64_t max_record; /* limit on one record's uncompressed bytes */
	struct tcs_tally tally; /* what has passed, for the end record */
	bool began; /* the head has passed */
	bool ended; /* the end record has passed and agreed */
	TCS_ARRAY(unsigned char) packed; /* a compressed payload */
};

#define TCS_MAX_RECORD ((uint64_t)8 << 30) /* the default limit, bytes */

void reader_init(struct tcs_reader *reader, FILE *file);
void reader_release(struct tcs_reader *reader);

/*
 * The same over a file of the reader's own; NULL is standard input. Fails with
 * TCS_SYSTEM. All zero may be closed.
 */
enum tcs_status reader_open(struct tcs_reader *reader, const char *name,
	uint64_t max_record, struct tcs_fault *fault) TCS_CHECKED;
void reader_close(struct tcs_reader *reader);

/*
 * Read the next record: its CRC checked, its payload inflated. The head comes
 * first. The end record is read, compared with what passed, and reported by
 * reader->ended with record->type TCS_END; nothing may follow it, and nobody
 * asks for more. Memory grows as bytes arrive, never by what a length claims.
 * Fails with TCS_TRUNCATED when the stream stops without an end record, with
 * TCS_BAD_INPUT, TCS_LIMIT (a record over max_record), TCS_SYSTEM.
 */
enum tcs_status reader_next(struct tcs_reader *reader,
	struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/*
 * A writer over a stdio stream, which it does not own and to which nothing was
 * written before. Not for use by two threads at once. `level` 0 writes
 * payloads as they are, 1…9 compresses. Some of what was put is written
 * only by writer_end, or by writer_release where that was not called: the
 * stream is to be closed after that.
 */
struct tcs_writer {
	FILE *file;
	uint64_t at; /* bytes written */
	int level; /* zlib level, 0: none */
	struct tcs_tally tally;
	TCS_ARRAY(unsigned char) packed;
	TCS_ARRAY(unsigned char) gathered; /* to be written with what comes */
};

void writer_init(struct tcs_writer *writer, FILE *file, int level);
void writer_release(struct tcs_writer *writer);

/*
 * Write a record of any type but TCS_END, the head first. Counts what the end
 * record must say. Fails with TCS_SYSTEM (a full disk, a closed pipe).
 */
enum tcs_status writer_put(struct tcs_writer *writer,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Write the end record and flush. Only a writer that has seen everything
 * succeed calls this: a stream without its end is known to be broken.
 */
enum tcs_status writer_end(
	struct tcs_writer *writer, struct tcs_fault *fault) TCS_CHECKED;

#endif
