#include "town_gml.h"

#include <stdio.h>
#include <string.h>

void
gml_code(struct gml *gml, const char *name, const char *code)
{
	if (gml->version == 1)
		gml_leaf(gml, name, code);
	else
		gml_leaf_with(gml, name, "codeSpace", "codes/town.xml", code);
}

static void
generic_3(struct gml *gml, const char *type, const char *name,
	const char *value, const char *unit)
{
	const char *property =
		gml->in_set ? "gen:genericAttribute" : "core:genericAttribute";
	char element[48];

	snprintf(element, sizeof element, "gen:%c%sAttribute",
		type[0] - 'a' + 'A', type + 1);
	gml_open(gml, property, NULL);
	gml_open(gml, element, NULL);
	gml_leaf(gml, "gen:name", name);
	gml_leaf_with(gml, "gen:value", "uom", unit, value);
	gml_close(gml, element);
	gml_close(gml, property);
}

void
gml_generic(struct gml *gml, const char *type, const char *name,
	const char *value, const char *unit)
{
	char element[48];

	if (gml->version == 3) {
		generic_3(gml, type, name, value, unit);
		return;
	}
	if (gml->version == 1 && unit)
		type = "double";
	snprintf(element, sizeof element, "gen:%sAttribute", type);
	gml_open_with(gml, element, "name", name);
	gml_leaf_with(gml, "gen:value", "uom", gml->version == 1 ? NULL : unit,
		value);
	gml_close(gml, element);
}

/* 1.0 has no sets: the members stand by themselves. */
void
gml_generic_set_open(struct gml *gml, const char *name, const char *code_space)
{
	char attributes[160];

	if (gml->version == 1)
		return;
	if (gml->version == 2) {
		snprintf(attributes, sizeof attributes, "%s\" codeSpace=\"%s",
			name, code_space);
		gml_open_with(
			gml, "gen:genericAttributeSet", "name", attributes);
		return;
	}
	gml_open(gml, "core:genericAttribute", NULL);
	gml_open(gml, "gen:GenericAttributeSet", NULL);
	gml_leaf(gml, "gen:name", name);
	gml_leaf(gml, "gen:codeSpace", code_space);
	gml->in_set = true;
}

void
gml_generic_set_close(struct gml *gml)
{
	if (gml->version == 2)
		gml_close(gml, "gen:genericAttributeSet");
	if (gml->version < 3)
		return;
	gml_close(gml, "gen:GenericAttributeSet");
	gml_close(gml, "core:genericAttribute");
	gml->in_set = false;
}

/* ---- boundary surfaces of bridges and tunnels ---- */

const char *
gml_surface_class(const struct gml *gml, enum face_class class)
{
	static const char *const names[] = {
		[FACE_GROUND] = "GroundSurface",
		[FACE_WALL] = "WallSurface",
		[FACE_ROOF] = "RoofSurface",
		[FACE_EAVES] = "OuterCeilingSurface",
		[FACE_DECK] = "OuterFloorSurface",
		[FACE_INNER_WALL] = "InteriorWallSurface",
		[FACE_FLOOR] = "FloorSurface",
		[FACE_CEILING] = "CeilingSurface",
		[FACE_CLOSURE] = "ClosureSurface",
	};

	if (gml->version == 1 && (class == FACE_EAVES || class == FACE_DECK))
		return names[FACE_ROOF];
	return names[class];
}

void
gml_bounding(struct gml *gml, const char *module, const char *host,
	const struct shape *shape)
{
	struct lod_name lod = gml_lod_name(gml, module, 2, "MultiSurface");
	char id[GML_ID];

	for (size_t i = 0; i < shape->face_count; i++) {
		const struct face *face = &shape->faces[i];
		const char *class = gml_surface_class(gml, face->class);

		snprintf(id, sizeof id, "%s_S%zu", host, i);
		gml_boundary_open(gml, module, class, id);
		gml_open(gml, lod.text, NULL);
		gml_fresh_id(gml, id);
		gml_open(gml, "gml:MultiSurface", id);
		gml_open(gml, "gml:surfaceMember", NULL);
		snprintf(id, sizeof id, "%s_L2_%zu", host, i);
		gml_polygon(gml, id, shape, face, false);
		gml_close(gml, "gml:surfaceMember");
		gml_close(gml, "gml:MultiSurface");
		gml_close(gml, lod.text);
		gml_boundary_close(gml, module, class);
	}
}

void
gml_bounded_solid(struct gml *gml, const char *module, const char *host,
	const struct shape *shape)
{
	struct lod_name lod = gml_lod_name(gml, module, 2, "Solid");
	char id[GML_ID];

	gml_open(gml, lod.text, NULL);
	gml_solid_open(gml, NULL);
	for (size_t i = 0; i < shape->face_count; i++) {
		snprintf(id, sizeof id, "%s_L2_%zu", host, i);
		gml_link(gml, "gml:surfaceMember", id);
	}
	gml_solid_close(gml);
	gml_close(gml, lod.text);
}

/* ---- addresses ---- */

static void
address_2(struct gml *gml, const char *street, unsigned number)
{
	gml_open(gml, "xAL:AddressDetails", NULL);
	gml_open(gml, "xAL:Country", NULL);
	gml_leaf(gml, "xAL:CountryName", "Deutschland");
	gml_open_with(gml, "xAL:Locality", "Type", "Town");
	gml_leaf(gml, "xAL:LocalityName", TOWN_NAME);
	gml_open_with(gml, "xAL:Thoroughfare", "Type", "Street");
	gml_number(gml, "xAL:ThoroughfareNumber", (long)number);
	gml_leaf(gml, "xAL:ThoroughfareName", street);
	gml_close(gml, "xAL:Thoroughfare");
	gml_open(gml, "xAL:PostalCode", NULL);
	gml_leaf(gml, "xAL:PostalCodeNumber", TOWN_CODE);
	gml_close(gml, "xAL:PostalCode");
	gml_close(gml, "xAL:Locality");
	gml_close(gml, "xAL:Country");
	gml_close(gml, "xAL:AddressDetails");
}

static void
address_3(struct gml *gml, const char *street, unsigned number)
{
	char digits[16];

	snprintf(digits, sizeof digits, "%u", number);
	gml_open(gml, "xAL:Address", NULL);
	gml_open(gml, "xAL:Country", NULL);
	gml_leaf(gml, "xAL:NameElement", "Deutschland");
	gml_close(gml, "xAL:Country");
	gml_open(gml, "xAL:Locality", NULL);
	gml_leaf(gml, "xAL:NameElement", TOWN_NAME);
	gml_close(gml, "xAL:Locality");
	gml_open(gml, "xAL:Thoroughfare", NULL);
	gml_leaf_with(
		gml, "xAL:NameElement", "xAL:NameType", "NameOnly", street);
	gml_leaf(gml, "xAL:Number", digits);
	gml_close(gml, "xAL:Thoroughfare");
	gml_open(gml, "xAL:PostCode", NULL);
	gml_leaf(gml, "xAL:Identifier", TOWN_CODE);
	gml_close(gml, "xAL:PostCode");
	gml_close(gml, "xAL:Address");
}

void
gml_address(struct gml *gml, const char *property, const char *street,
	unsigned number)
{
	char id[GML_ID];

	gml_fresh_id(gml, id);
	gml_open(gml, property, NULL);
	gml_open(gml, "core:Address", id);
	gml_open(gml, "core:xalAddress", NULL);
	if (gml->version == 3)
		address_3(gml, street, number);
	else
		address_2(gml, street, number);
	gml_close(gml, "core:xalAddress");
	gml_close(gml, "core:Address");
	gml_close(gml, property);
}

/* ---- appearances ---- */

static void
colour_text(char out[32], unsigned red, unsigned green, unsigned blue)
{
	snprintf(out, 32, "%u.%02u %u.%02u %u.%02u", red * 100 / 255 / 100,
		red * 100 / 255 % 100, green * 100 / 255 / 100,
		green * 100 / 255 % 100, blue * 100 / 255 / 100,
		blue * 100 / 255 % 100);
}

void
gml_material_open(struct gml *gml, const char *id, struct colour colour)
{
	char text[32];

	gml_open(gml, gml_name(gml, "app:surfaceDataMember", "app:surfaceData"),
		NULL);
	gml_open(gml, "app:X3DMaterial", id);
	gml_leaf(gml, "app:ambientIntensity", "0.2");
	colour_text(text, colour.red, colour.green, colour.blue);
	gml_leaf(gml, "app:diffuseColor", text);
	gml_leaf(gml, "app:emissiveColor", "0 0 0");
	gml_leaf(gml, "app:specularColor", "0.1 0.1 0.1");
	gml_leaf(gml, "app:shininess", "0.2");
	snprintf(text, sizeof text, "%u.%02u", colour.clear / 100u,
		colour.clear % 100u);
	gml_leaf(gml, "app:transparency", text);
	gml_leaf(gml, "app:isSmooth", "false");
}

void
gml_material_close(struct gml *gml)
{
	gml_close(gml, "app:X3DMaterial");
	gml_close(
		gml, gml_name(gml, "app:surfaceDataMember", "app:surfaceData"));
}

static const char *
appearance_property(const struct gml *gml, bool global)
{
	if (global)
		return gml_name(
			gml, "app:appearanceMember", "core:appearanceMember");
	return gml_name(gml, "app:appearance", "core:appearance");
}

void
gml_appearance_open(
	struct gml *gml, bool global, const char *id, const char *theme)
{
	gml_open(gml, appearance_property(gml, global), NULL);
	gml_open(gml, "app:Appearance", id);
	gml_leaf(gml, "app:theme", theme);
}

void
gml_appearance_close(struct gml *gml, bool global)
{
	gml_close(gml, "app:Appearance");
	gml_close(gml, appearance_property(gml, global));
}

/* ---- the whole file ---- */

static const char *const modules_2[][2] = {
	{"bldg", "building"},
	{"brid", "bridge"},
	{"tun", "tunnel"},
	{"tran", "transportation"},
	{"dem", "relief"},
	{"veg", "vegetation"},
	{"wtr", "waterbody"},
	{"luse", "landuse"},
	{"frn", "cityfurniture"},
	{"gen", "generics"},
	{"grp", "cityobjectgroup"},
	{"app", "appearance"},
	{"con", "construction"},
};

static bool
has_module(int version, const char *prefix)
{
	if (!strcmp(prefix, "con"))
		return version == 3;
	if (!strcmp(prefix, "brid") || !strcmp(prefix, "tun"))
		return version > 1;
	return true;
}

/* The root's start tag, as one text for gml_open_with. */
static void
root_attributes(const struct gml *gml, char *out, size_t room)
{
	size_t used = (size_t)snprintf(out, room,
		"http://www.opengis.net/citygml/%d.0\""
		"\n xmlns:gml=\"http://www.opengis.net/gml%s\""
		"\n xmlns:xAL=\"urn:oasis:names:tc:ciq:%s\""
		"\n xmlns:xlink=\"http://www.w3.org/1999/xlink",
		gml->version, gml->version == 3 ? "/3.2" : "",
		gml->version == 3 ? "xal:3" : "xsdschema:xAL:2.0");

	for (size_t i = 0; i < sizeof modules_2 / sizeof *modules_2; i++)
		if (has_module(gml->version, modules_2[i][0]))
			used += (size_t)snprintf(out + used, room - used,
				"\"\n xmlns:%s=\"http://www.opengis.net/"
				"citygml/%s/%d.0",
				modules_2[i][0], modules_2[i][1], gml->version);
}

void
gml_begin(struct gml *gml, struct spot lower, struct spot upper)
{
	char attributes[2048];

	root_attributes(gml, attributes, sizeof attributes);
	gml_line(gml, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
	gml_open_with(gml, "core:CityModel", "xmlns:core", attributes);
	gml_leaf(gml, "gml:name", TOWN_NAME);
	gml_open(gml, "gml:boundedBy", NULL);
	gml_open_with(gml, "gml:Envelope", "srsName",
		"urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::7837\" "
		"srsDimension=\"3");
	gml_corner(gml, "gml:lowerCorner", lower);
	gml_corner(gml, "gml:upperCorner", upper);
	gml_close(gml, "gml:Envelope");
	gml_close(gml, "gml:boundedBy");
}

void
gml_end(struct gml *gml)
{
	gml_close(gml, "core:CityModel");
}
