/*
 * What CityGML's schemas allow: per version and class the properties in their
 * order, and what each may hold.
 *
 * The tables are text, one row per schema type, in citygml_schema_2.c (1.0 and
 * 2.0) and citygml_schema_3.c: the place to change a property. A row is the
 * module, the type (a name with "_" stands for an abstract one), the type it
 * extends, and its own properties in schema order:
 *
 *     name:content     '*' behind it: any number of times
 *                      '!' behind it: must be there
 *                      '@1', '@2' behind it: only in 1.0, only since 2.0
 *                      '@g' behind it: belongs to GML's namespace
 *
 * where content is a word of enum content in lower case, or `>A|B` for
 * features of these classes (labels of the stream), or `set=prefix` for a
 * structured value whose elements belong to that module.
 *
 * source: the schemas of OGC 08-007r1, 12-019, 21-006r2.
 */
#ifndef TESSERA_CITYGML_SCHEMA_H
#define TESSERA_CITYGML_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fault.h"
#include "labels.h"

enum gml_version { GML_1_0, GML_2_0, GML_3_0 };

enum content {
	/* simple values */
	CONTENT_STRING,
	CONTENT_CODE, /* text with a code space */
	CONTENT_URI,
	CONTENT_DATE,
	CONTENT_TIME, /* xs:dateTime */
	CONTENT_YEAR,
	CONTENT_BOOLEAN,
	CONTENT_INTEGER,
	CONTENT_COUNT, /* not negative */
	CONTENT_DOUBLE,
	CONTENT_MEASURE, /* a number with a unit */
	CONTENT_MEASURES, /* numbers with a unit */
	CONTENT_LEVEL, /* a level of detail */
	CONTENT_TERRAIN, /* one of the words of relativeToTerrain; … */
	CONTENT_WATER,
	CONTENT_SPACETYPE,
	CONTENT_CONDITION,
	CONTENT_RELATION,
	CONTENT_GRANULARITY,
	CONTENT_DIRECTION,

	/* structured values */
	CONTENT_EXTERNAL, /* an external reference */
	CONTENT_ADDRESS,
	CONTENT_SET, /* `inner` is the module of its elements */
	CONTENT_GRID,

	/* geometries */
	CONTENT_SOLID,
	CONTENT_MULTISOLID,
	CONTENT_MULTISURFACE,
	CONTENT_SURFACE,
	CONTENT_MULTICURVE,
	CONTENT_MULTIPOINT,
	CONTENT_POINT,
	CONTENT_GEOMETRY, /* any */
	CONTENT_COMPLEX, /* a geometric complex of lines */
	CONTENT_TIN,
	CONTENT_POLYGON,
	CONTENT_IMPLICIT,

	/* the rest */
	CONTENT_FEATURE, /* `classes` says which */
	CONTENT_MEMBER, /* a member of a group or a link to it, with its role */
	CONTENT_ROLE, /* the same in 3.0, by link only */
	CONTENT_LINK,
	CONTENT_GENERIC,
	CONTENT_APPEARANCE,
};

#define SCHEMA_NONE UINT16_MAX
#define SCHEMA_LOD_NONE 255

/* One property of a class, all inherited ones included, in schema order. */
struct property {
	char name[32];
	char module[5];
	char inner[5]; /* CONTENT_SET: the module of what is inside */
	uint8_t length; /* of name */
	uint8_t content; /* enum content */
	uint8_t lod; /* of "lod2Solid"; SCHEMA_LOD_NONE */
	bool many;
	bool required;
	uint64_t classes[2]; /* CONTENT_FEATURE: bit n is class n */
};

struct schema_class {
	const struct property *properties;
	uint16_t count;
	const char *module; /* NULL: the version has no such class */
	const char *name;
};

struct schema {
	enum gml_version version;
	struct schema_class classes[TCS_CLASS_COUNT];
	struct property *all; /* owned */
};

/* The schema of a version. Fails with TCS_NO_MEMORY. */
enum tcs_status schema_init(struct schema *schema, enum gml_version version,
	struct tcs_fault *fault) TCS_CHECKED;
void schema_release(struct schema *schema);

/* The property of this name; SCHEMA_NONE for none. */
uint16_t schema_find(const struct schema_class *of, const char *name);

/* The first property with this content; SCHEMA_NONE for none. */
uint16_t schema_find_content(
	const struct schema_class *of, enum content content);

/*
 * The property that holds a child of this class: the one called `role` if it
 * may, else the first that may; SCHEMA_NONE for none.
 */
uint16_t schema_find_child(
	const struct schema_class *of, unsigned class, const char *role);

bool schema_may_hold(const struct property *property, unsigned class);

static inline bool
content_is_geometry(unsigned content)
{
	return content >= CONTENT_SOLID && content <= CONTENT_POLYGON;
}

static inline bool
content_is_simple(unsigned content)
{
	return content <= CONTENT_DIRECTION;
}

/* ---- the tables --------------------------------------------------------- */

struct schema_row {
	const char *module;
	const char *name;
	const char *base; /* of the same table, before it; NULL for none */
	const char *properties;
};

struct schema_table {
	const struct schema_row *rows;
	size_t count;
};

extern const struct schema_table schema_table_2; /* 1.0 and 2.0 */
extern const struct schema_table schema_table_3;

#endif
