/*
 * What element names mean to the CityGML reader.
 *
 * Every (namespace, local name) pair of a file is looked up once and becomes
 * a struct name; names are interned, so later lookups compare pointers.
 */
#ifndef TESSERA_CITYGML_NAMES_H
#define TESSERA_CITYGML_NAMES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fault.h"
#include "labels.h"

enum name_space {
	SPACE_NONE, /* no namespace and no telling prefix: taken as CityGML */
	SPACE_CITYGML, /* any module, any version */
	SPACE_GML,
	SPACE_XAL,
	SPACE_XLINK,
	SPACE_XSI,
	SPACE_OTHER, /* application domain extensions and all else */
};

enum name_kind {
	NAME_OTHER, /* a property, a data type, or unknown */
	NAME_FEATURE, /* `class` says which */

	/* the model's members */
	NAME_CITY_MODEL,
	NAME_MEMBER, /* cityObjectMember, featureMember(s) */
	NAME_APPEARANCE_MEMBER,

	/* properties that mean more than text */
	NAME_GML_NAME,
	NAME_BOUNDED_BY,
	NAME_ENVELOPE,
	NAME_ENVELOPE_CORNER, /* lowerCorner, upperCorner */
	NAME_IMPLICIT_GEOMETRY,
	NAME_IMPLICIT_MATRIX, /* transformationMatrix */
	NAME_IMPLICIT_OBJECT, /* libraryObject */
	NAME_IMPLICIT_TEMPLATE, /* relativeGMLGeometry, relativeGeometry */
	NAME_IMPLICIT_ANCHOR, /* referencePoint */
	NAME_GENERIC_ATTRIBUTE, /* `generic` says which type */
	NAME_GENERIC_NAME, /* gen:name */
	NAME_GENERIC_VALUE, /* gen:value */

	/* appearance */
	NAME_APPEARANCE,
	NAME_THEME,
	NAME_MATERIAL,
	NAME_MATERIAL_VALUE, /* a colour or number of a material */
	NAME_TEXTURE,
	NAME_TEXTURE_VALUE, /* imageURI, wrapMode, … */
	NAME_TEXTURE_LIST, /* TexCoordList */
	NAME_TEXTURE_RING, /* textureCoordinates of one ring */
	NAME_TEXTURE_RING_NAME, /* ring, in 3.0 behind the coordinates */
	NAME_TEXTURE_MATRIX, /* worldToTexture */
	NAME_TEXTURE_MATRIX_HOLDER, /* TexCoordGen */
	NAME_TEXTURE_ASSOCIATION, /* textureParameterization of 3.0 */
	NAME_TEXTURE_ORIENTATION, /* of a georeferenced one */
	NAME_SURFACE_DATA, /* surfaceDataMember, surfaceData: may link */
	NAME_TARGET,

	/* GML: what holds surfaces, lines and points */
	NAME_SOLID, /* Solid: exterior and interior shells */
	NAME_AGGREGATE, /* `geometry` says which kind */
	NAME_ORIENTABLE, /* OrientableSurface, OrientableCurve */
	NAME_SURFACE, /* Surface, PolyhedralSurface: patches */
	NAME_POLYGON, /* Polygon, PolygonPatch, Triangle, Rectangle */
	NAME_LINE, /* LineString, LineStringSegment, LinearRing outside
	              polygons */
	NAME_POINT,
	NAME_CURVE, /* Curve, CompositeCurve, Ring: of lines */
	NAME_CURVE_UNKNOWN, /* arcs, splines, … */
	NAME_SURFACE_UNKNOWN, /* cones, spheres, grids, … */
	NAME_SHELL,
	NAME_RING,
	NAME_EXTERIOR, /* also outerBoundaryIs */
	NAME_INTERIOR, /* also innerBoundaryIs */
	NAME_MEMBER_OF_GEOMETRY, /* surfaceMember, baseSurface, …: may link */
	NAME_POS,
	NAME_POS_LIST,
	NAME_COORDINATES,
	NAME_COORD, /* GML 2: coord with X, Y, Z */
};

struct name {
	const char *local; /* interned */
	const char *prefix; /* "" for none; interned */
	const char *uri; /* NULL for none; interned */
	size_t length; /* of local */
	enum name_space space;
	enum name_kind kind;
	enum tcs_class class; /* of NAME_FEATURE, and of an extension's element
	                         that is called like a class */
	uint8_t geometry; /* enum tcs_geometry_kind of NAME_AGGREGATE */
	uint8_t attribute; /* enum tcs_attribute_type this name usually has */
	uint8_t lod; /* of "lod2Solid"; TCS_LOD_NONE */

	/* where the local name stands in the text of object `text_serial` */
	uint64_t text_serial;
	uint32_t text;
};

struct names {
	struct name **slots; /* a hash table of pointers, room a power of 2 */
	size_t room, count;
	int version; /* 2 or 3: which CityGML's names come first */
	const char *spelled; /* the version as "2.0"; NULL: none declared */
	const char *adopted; /* an unknown namespace that the root CityModel is
	                        in, interned: taken as CityGML's, and customary
	                        prefixes at their meaning; NULL: none */
};

/*
 * The meaning of a name; the three are interned. The result stays
 * where it is until names_release. NULL without memory.
 */
struct name *names_find(struct names *names, const char *local,
	const char *prefix, const char *uri);

void names_release(struct names *names);

/* "2.0", "3.0", … of a CityGML namespace; NULL for others. */
const char *names_version(const char *uri);

#endif
