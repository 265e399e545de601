#include "citygml_names.h"

#include <stdlib.h>
#include <string.h>

#include "tcs.h"

/* One fixed meaning of a local name, whatever its namespace of that family. */
struct meaning {
	const char *local;
	enum name_space space;
	enum name_kind kind;
	uint8_t detail; /* geometry kind or attribute type */
};

/* Sorted by local name, for bsearch. */
static const struct meaning meanings[] = {
	{"Appearance", SPACE_CITYGML, NAME_APPEARANCE, 0},
	{"Arc", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"ArcByBulge", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"ArcByCenterPoint", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"ArcString", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"BSpline", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"Bezier", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"Circle", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"CircleByCenterPoint", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"CityModel", SPACE_CITYGML, NAME_CITY_MODEL, 0},
	{"Clothoid", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"CodeAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_CODE},
	{"CompositeCurve", SPACE_GML, NAME_CURVE, TCS_MULTI_CURVE},
	{"CompositeSolid", SPACE_GML, NAME_AGGREGATE, TCS_COMPOSITE_SOLID},
	{"CompositeSurface", SPACE_GML, NAME_AGGREGATE, TCS_COMPOSITE_SURFACE},
	{"Cone", SPACE_GML, NAME_SURFACE_UNKNOWN, 0},
	{"CubicSpline", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"Curve", SPACE_GML, NAME_CURVE, TCS_MULTI_CURVE},
	{"Cylinder", SPACE_GML, NAME_SURFACE_UNKNOWN, 0},
	{"DateAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_DATE},
	{"DoubleAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_DOUBLE},
	{"Envelope", SPACE_GML, NAME_ENVELOPE, 0},
	{"FeatureCollection", SPACE_GML, NAME_CITY_MODEL, 0},
	{"GenericAttributeSet", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_SET},
	{"Geodesic", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"GeodesicString", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"GeometricComplex", SPACE_GML, NAME_AGGREGATE, TCS_MULTI_SURFACE},
	{"GeoreferencedTexture", SPACE_CITYGML, NAME_TEXTURE, 0},
	{"ImplicitGeometry", SPACE_CITYGML, NAME_IMPLICIT_GEOMETRY, 0},
	{"IntAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_INTEGER},
	{"LineString", SPACE_GML, NAME_LINE, 0},
	{"LineStringSegment", SPACE_GML, NAME_LINE, 0},
	{"LinearRing", SPACE_GML, NAME_RING, 0},
	{"Material", SPACE_CITYGML, NAME_MATERIAL, 0},
	{"MeasureAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE,
		TCS_MEASURE},
	{"MultiCurve", SPACE_GML, NAME_AGGREGATE, TCS_MULTI_CURVE},
	{"MultiGeometry", SPACE_GML, NAME_AGGREGATE, TCS_MULTI_SURFACE},
	{"MultiPoint", SPACE_GML, NAME_AGGREGATE, TCS_MULTI_POINT},
	{"MultiPolygon", SPACE_GML, NAME_AGGREGATE, TCS_MULTI_SURFACE},
	{"MultiSolid", SPACE_GML, NAME_AGGREGATE, TCS_MULTI_SOLID},
	{"MultiSurface", SPACE_GML, NAME_AGGREGATE, TCS_MULTI_SURFACE},
	{"OffsetCurve", SPACE_GML, NAME_CURVE_UNKNOWN, 0},
	{"OrientableCurve", SPACE_GML, NAME_CURVE, TCS_MULTI_CURVE},
	{"OrientableSurface", SPACE_GML, NAME_ORIENTABLE, 0},
	{"ParameterizedTexture", SPACE_CITYGML, NAME_TEXTURE, 0},
	{"Point", SPACE_GML, NAME_POINT, 0},
	{"Polygon", SPACE_GML, NAME_POLYGON, 0},
	{"PolygonPatch", SPACE_GML, NAME_POLYGON, 0},
	{"PolyhedralSurface", SPACE_GML, NAME_SURFACE, TCS_MULTI_SURFACE},
	{"Rectangle", SPACE_GML, NAME_POLYGON, 0},
	{"Ring", SPACE_GML, NAME_RING, 0},
	{"Shell", SPACE_GML, NAME_AGGREGATE, TCS_COMPOSITE_SURFACE},
	{"SimpleTexture", SPACE_CITYGML, NAME_TEXTURE, 0},
	{"Solid", SPACE_GML, NAME_SOLID, TCS_SOLID},
	{"Sphere", SPACE_GML, NAME_SURFACE_UNKNOWN, 0},
	{"StringAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_STRING},
	{"Surface", SPACE_GML, NAME_SURFACE, TCS_MULTI_SURFACE},
	{"TexCoordGen", SPACE_CITYGML, NAME_TEXTURE_MATRIX_HOLDER, 0},
	{"TexCoordList", SPACE_CITYGML, NAME_TEXTURE_LIST, 0},
	{"TexturedSurface", SPACE_CITYGML, NAME_ORIENTABLE, 0},
	{"Tin", SPACE_GML, NAME_SURFACE, TCS_TIN},
	{"Triangle", SPACE_GML, NAME_POLYGON, 0},
	{"TriangulatedSurface", SPACE_GML, NAME_SURFACE, TCS_TIN},
	{"UriAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_URI},
	{"X3DMaterial", SPACE_CITYGML, NAME_MATERIAL, 0},
	{"ambientIntensity", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"appearanceMember", SPACE_CITYGML, NAME_APPEARANCE_MEMBER, 0},
	{"baseSurface", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"borderColor", SPACE_CITYGML, NAME_TEXTURE_VALUE, 0},
	{"boundedBy", SPACE_GML, NAME_BOUNDED_BY, 0},
	{"cityObjectMember", SPACE_CITYGML, NAME_MEMBER, 0},
	{"coord", SPACE_GML, NAME_COORD, 0},
	{"coordinates", SPACE_GML, NAME_COORDINATES, 0},
	{"curveMember", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"dateAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_DATE},
	{"diffuseColor", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"doubleAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_DOUBLE},
	{"emissiveColor", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"exterior", SPACE_GML, NAME_EXTERIOR, 0},
	{"featureMember", SPACE_GML, NAME_MEMBER, 0},
	{"featureMembers", SPACE_GML, NAME_MEMBER, 0},
	{"genericAttributeSet", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_SET},
	{"geometryMember", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"imageURI", SPACE_CITYGML, NAME_TEXTURE_VALUE, 0},
	{"innerBoundaryIs", SPACE_GML, NAME_INTERIOR, 0},
	{"intAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_INTEGER},
	{"interior", SPACE_GML, NAME_INTERIOR, 0},
	{"isFront", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"isSmooth", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"libraryObject", SPACE_CITYGML, NAME_IMPLICIT_OBJECT, 0},
	{"lowerCorner", SPACE_GML, NAME_ENVELOPE_CORNER, 0},
	{"measureAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE,
		TCS_MEASURE},
	{"mimeType", SPACE_CITYGML, NAME_TEXTURE_VALUE, 0},
	{"name", SPACE_CITYGML, NAME_GENERIC_NAME, 0},
	{"name", SPACE_GML, NAME_GML_NAME, 0},
	{"orientation", SPACE_CITYGML, NAME_TEXTURE_ORIENTATION, 0},
	{"outerBoundaryIs", SPACE_GML, NAME_EXTERIOR, 0},
	{"patches", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"pointMember", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"pos", SPACE_GML, NAME_POS, 0},
	{"posList", SPACE_GML, NAME_POS_LIST, 0},
	{"referencePoint", SPACE_CITYGML, NAME_IMPLICIT_ANCHOR, 0},
	{"relativeGMLGeometry", SPACE_CITYGML, NAME_IMPLICIT_TEMPLATE, 0},
	{"relativeGeometry", SPACE_CITYGML, NAME_IMPLICIT_TEMPLATE, 0},
	{"repeat", SPACE_CITYGML, NAME_TEXTURE_VALUE, 0},
	{"ring", SPACE_CITYGML, NAME_TEXTURE_RING_NAME, 0},
	{"shininess", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"solidMember", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"specularColor", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"stringAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_STRING},
	{"surfaceData", SPACE_CITYGML, NAME_SURFACE_DATA, 0},
	{"surfaceDataMember", SPACE_CITYGML, NAME_SURFACE_DATA, 0},
	{"surfaceMember", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"surfaceMembers", SPACE_GML, NAME_MEMBER_OF_GEOMETRY, 0},
	{"target", SPACE_CITYGML, NAME_TARGET, 0},
	{"textureCoordinates", SPACE_CITYGML, NAME_TEXTURE_RING, 0},
	{"textureMap", SPACE_CITYGML, NAME_TEXTURE_VALUE, 0},
	{"textureParameterization", SPACE_CITYGML, NAME_TEXTURE_ASSOCIATION, 0},
	{"textureType", SPACE_CITYGML, NAME_TEXTURE_VALUE, 0},
	{"theme", SPACE_CITYGML, NAME_THEME, 0},
	{"transformationMatrix", SPACE_CITYGML, NAME_IMPLICIT_MATRIX, 0},
	{"transparency", SPACE_CITYGML, NAME_MATERIAL_VALUE, 0},
	{"upperCorner", SPACE_GML, NAME_ENVELOPE_CORNER, 0},
	{"uriAttribute", SPACE_CITYGML, NAME_GENERIC_ATTRIBUTE, TCS_URI},
	{"value", SPACE_CITYGML, NAME_GENERIC_VALUE, 0},
	{"worldToTexture", SPACE_CITYGML, NAME_TEXTURE_MATRIX, 0},
	{"wrapMode", SPACE_CITYGML, NAME_TEXTURE_VALUE, 0},
};

/* Standard attributes that are more than strings. Sorted. */
static const struct {
	const char *local;
	enum tcs_attribute_type type;
} typed[] = {
	{"averageHeight", TCS_MEASURE},
	{"class", TCS_CODE},
	{"creationDate", TCS_DATE},
	{"crownDiameter", TCS_MEASURE},
	{"dateOfConstruction", TCS_DATE},
	{"dateOfDemolition", TCS_DATE},
	{"function", TCS_CODE},
	{"isMovable", TCS_BOOLEAN},
	{"isStructuralElement", TCS_BOOLEAN},
	{"lod", TCS_INTEGER},
	{"measuredHeight", TCS_MEASURE},
	{"roofType", TCS_CODE},
	{"species", TCS_CODE},
	{"storeysAboveGround", TCS_INTEGER},
	{"storeysBelowGround", TCS_INTEGER},
	{"surfaceMaterial", TCS_CODE},
	{"terminationDate", TCS_DATE},
	{"trunkDiameter", TCS_MEASURE},
	{"usage", TCS_CODE},
	{"validFrom", TCS_DATE},
	{"validTo", TCS_DATE},
	{"yearOfConstruction", TCS_DATE},
	{"yearOfDemolition", TCS_DATE},
};

const char *
names_version(const char *uri)
{
	static const char *const versions[] = {"3.0", "2.0", "1.0"};

	if (!uri)
		return NULL;
	if (strstr(uri, "citygml.org/citygml/"))
		return "0.4";
	if (!strstr(uri, "opengis.net/citygml"))
		return NULL;
	for (size_t i = 0; i < 3; i++)
		if (strstr(uri, versions[i]))
			return versions[i];
	return strstr(uri, "1.1") ? "1.1" : NULL;
}

static enum name_space
space_of_prefix(const char *prefix)
{
	static const char *const modules[] = {"app", "bldg", "brid", "con",
		"core", "dem", "dyn", "frn", "gen", "grp", "luse", "pcl", "tex",
		"tran", "tun", "veg", "vers", "wtr"};

	if (!strcmp(prefix, "gml"))
		return SPACE_GML;
	if (!strcmp(prefix, "xAL") || !strcmp(prefix, "xal"))
		return SPACE_XAL;
	for (size_t i = 0; i < sizeof modules / sizeof *modules; i++)
		if (!strcmp(prefix, modules[i]))
			return SPACE_CITYGML;
	return *prefix ? SPACE_OTHER : SPACE_NONE;
}

/* Undeclared prefixes are taken at their customary meaning. */
static enum name_space
space_of(const char *uri, const char *prefix)
{
	if (!uri || !*uri)
		return space_of_prefix(prefix);
	if (strstr(uri, "opengis.net/gml"))
		return SPACE_GML;
	if (strstr(uri, "opengis.net/citygml") ||
		strstr(uri, "citygml.org/citygml"))
		return SPACE_CITYGML;
	if (strstr(uri, "names:tc:ciq"))
		return SPACE_XAL;
	if (strstr(uri, "w3.org/1999/xlink"))
		return SPACE_XLINK;
	if (strstr(uri, "XMLSchema-instance"))
		return SPACE_XSI;
	return SPACE_OTHER;
}

/* A CityGML or GML name may also come without a namespace. */
static bool
space_fits(enum name_space have, enum name_space want)
{
	return have == want || have == SPACE_NONE;
}

static int
meaning_compare(const void *key, const void *row)
{
	return strcmp(key, ((const struct meaning *)row)->local);
}

static const struct meaning *
meaning_find(const char *local, enum name_space space)
{
	const size_t count = sizeof meanings / sizeof *meanings;
	const struct meaning *row = bsearch(
		local, meanings, count, sizeof *meanings, meaning_compare);

	if (!row)
		return NULL;
	while (row > meanings && !strcmp(row[-1].local, local))
		row--;
	for (; row < meanings + count && !strcmp(row->local, local); row++)
		if (space_fits(space, row->space))
			return row;
	return NULL;
}

static enum tcs_class
class_of(const struct names *names, const struct name *name)
{
	int other = names->version == 3 ? 2 : 3;
	enum tcs_class class;

	if (name->space == SPACE_GML || name->space == SPACE_XAL)
		return TCS_CLASS_Unknown;
	class = label_find_citygml(names->version, name->local, name->length);
	if (class == TCS_CLASS_Unknown)
		class = label_find_citygml(other, name->local, name->length);
	return class;
}

static uint8_t
attribute_type_of(const struct name *name)
{
	if (!space_fits(name->space, SPACE_CITYGML))
		return TCS_STRING;
	for (size_t i = 0; i < sizeof typed / sizeof *typed; i++)
		if (!strcmp(typed[i].local, name->local))
			return (uint8_t)typed[i].type;
	return TCS_STRING;
}

static uint8_t
lod_of(const char *local)
{
	if (!strncmp(local, "lod", 3) && local[3] >= '0' && local[3] <= '4')
		return (uint8_t)(local[3] - '0');
	return TCS_LOD_NONE;
}

static void
name_understand(const struct names *names, struct name *name)
{
	const struct meaning *row = meaning_find(name->local, name->space);

	name->attribute = attribute_type_of(name);
	name->lod = lod_of(name->local);
	name->class = class_of(names, name);
	if (name->class != TCS_CLASS_Unknown && name->space != SPACE_OTHER) {
		name->kind = NAME_FEATURE;
	} else if (row) {
		name->kind = row->kind;
		name->geometry = row->detail;
		if (row->kind == NAME_GENERIC_ATTRIBUTE)
			name->attribute = row->detail;
	}
}

static struct name *
name_new(const struct names *names, const char *local, const char *prefix,
	const char *uri)
{
	struct name *name = calloc(1, sizeof *name);

	if (!name)
		return NULL;
	name->local = local;
	name->length = strlen(local);
	name->prefix = prefix ? prefix : "";
	name->uri = uri;
	name->space = space_of(uri, name->prefix);
	if (name->space == SPACE_OTHER && names->adopted)
		name->space = uri == names->adopted
			? SPACE_CITYGML
			: space_of_prefix(name->prefix);
	name_understand(names, name);
	return name;
}

/* Interned pointers differ in their middle bits; mix them down. */
static inline size_t
slot_of(const char *local, const char *prefix, const char *uri, size_t room)
{
	uint64_t mixed = (uint64_t)(uintptr_t)local * 0x9e3779b97f4a7c15u;

	mixed ^= (uint64_t)(uintptr_t)uri * 0xc2b2ae3d27d4eb4fu;
	mixed ^= (uint64_t)(uintptr_t)prefix * 0x165667b19e3779f9u;
	return (size_t)(mixed >> 32) & (room - 1);
}

static inline bool
name_is(const struct name *name, const char *local, const char *prefix,
	const char *uri)
{
	return name->local == local && name->uri == uri &&
		(name->prefix == prefix || (!prefix && !*name->prefix));
}

static inline struct name **
slot_find(struct name **slots, size_t room, const char *local,
	const char *prefix, const char *uri)
{
	size_t i = slot_of(local, prefix, uri, room);

	while (slots[i] && !name_is(slots[i], local, prefix, uri))
		i = (i + 1) & (room - 1);
	return &slots[i];
}

static int
names_grow(struct names *names)
{
	size_t room = names->room ? names->room * 2 : 256;
	struct name **slots = calloc(room, sizeof *slots);

	if (!slots)
		return -1;
	for (size_t i = 0; i < names->room; i++) {
		struct name *name = names->slots[i];

		if (name)
			*slot_find(slots, room, name->local,
				*name->prefix ? name->prefix : NULL,
				name->uri) = name;
	}
	free(names->slots);
	names->slots = slots;
	names->room = room;
	return 0;
}

struct name *
names_find(struct names *names, const char *local, const char *prefix,
	const char *uri)
{
	struct name **slot;

	if (names->count * 2 >= names->room && names_grow(names))
		return NULL;
	slot = slot_find(names->slots, names->room, local, prefix, uri);
	if (*slot)
		return *slot;
	*slot = name_new(names, local, prefix, uri);
	if (*slot)
		names->count++;
	return *slot;
}

void
names_release(struct names *names)
{
	for (size_t i = 0; i < names->room; i++)
		free(names->slots[i]);
	free(names->slots);
	*names = (struct names){
		.version = names->version, .spelled = names->spelled};
}
