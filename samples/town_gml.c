#include "town_gml.h"

#include <string.h>

/* ---- text ---- */

static void
drain(struct gml *gml)
{
	if (!gml->failed && gml->used > 0 &&
		fwrite(gml->buffer, 1, gml->used, gml->file) != gml->used)
		gml->failed = true;
	gml->written += gml->used;
	gml->used = 0;
}

static void
put_bytes(struct gml *gml, const char *bytes, size_t length)
{
	while (length > 0) {
		size_t room = sizeof gml->buffer - gml->used;
		size_t part = length < room ? length : room;

		memcpy(gml->buffer + gml->used, bytes, part);
		gml->used += part;
		bytes += part;
		length -= part;
		if (gml->used == sizeof gml->buffer)
			drain(gml);
	}
}

static void
put(struct gml *gml, const char *text)
{
	put_bytes(gml, text, strlen(text));
}

static void
put_long(struct gml *gml, long number)
{
	char digits[24];
	size_t at = sizeof digits;
	unsigned long rest = (unsigned long)number;

	if (number < 0) {
		put_bytes(gml, "-", 1);
		rest = 0 - rest;
	}
	do {
		digits[--at] = (char)('0' + rest % 10);
		rest /= 10;
	} while (rest > 0);
	put_bytes(gml, digits + at, sizeof digits - at);
}

/* Metres with as many of three decimals as are needed. */
static void
put_metres(struct gml *gml, long millimetres)
{
	long rest = millimetres % 1000;
	char decimals[4] = ".000";
	size_t length = 4;

	if (millimetres < 0) {
		put_bytes(gml, "-", 1);
		millimetres = -millimetres;
		rest = -rest;
	}
	put_long(gml, millimetres / 1000);
	if (rest == 0)
		return;
	decimals[1] = (char)('0' + rest / 100);
	decimals[2] = (char)('0' + rest / 10 % 10);
	decimals[3] = (char)('0' + rest % 10);
	while (decimals[length - 1] == '0')
		length--;
	put_bytes(gml, decimals, length);
}

static void
put_spot(struct gml *gml, struct spot spot)
{
	put_metres(gml, spot.x);
	put_bytes(gml, " ", 1);
	put_metres(gml, spot.y);
	put_bytes(gml, " ", 1);
	put_metres(gml, spot.z);
}

static void
put_margin(struct gml *gml)
{
	static const char blanks[] = "                                ";
	size_t length = gml->depth;

	put_bytes(gml, blanks,
		length < sizeof blanks ? length : sizeof blanks - 1);
}

uint64_t
gml_size(const struct gml *gml)
{
	return gml->written + gml->used;
}

enum tcs_status
gml_flush(struct gml *gml, struct tcs_fault *fault)
{
	drain(gml);
	if (gml->failed || fflush(gml->file) != 0)
		return fault_system(fault, "cannot write", "the town");
	return TCS_OK;
}

const char *
gml_name(const struct gml *gml, const char *name_2, const char *name_3)
{
	return gml->version == 3 ? name_3 : name_2;
}

/* In 3.0 spaces and surfaces have the property, and LOD4 became LOD3. */
struct lod_name
gml_lod_name(const struct gml *gml, const char *module, int lod,
	const char *property)
{
	struct lod_name name;

	if (gml->version == 3) {
		module = "core";
		lod = lod > 3 ? 3 : lod;
	}
	snprintf(name.text, sizeof name.text, "%s:lod%d%s", module, lod,
		property);
	return name;
}

/* ---- elements ---- */

void
gml_open_with(struct gml *gml, const char *name, const char *attribute,
	const char *value)
{
	put_margin(gml);
	put(gml, "<");
	put(gml, name);
	if (value) {
		put(gml, " ");
		put(gml, attribute);
		put(gml, "=\"");
		put(gml, value);
		put(gml, "\"");
	}
	put(gml, ">\n");
	gml->depth++;
}

void
gml_open(struct gml *gml, const char *name, const char *id)
{
	gml_open_with(gml, name, "gml:id", id);
}

void
gml_close(struct gml *gml, const char *name)
{
	gml->depth--;
	put_margin(gml);
	put(gml, "</");
	put(gml, name);
	put(gml, ">\n");
}

static void
leaf_begin(struct gml *gml, const char *name, const char *attribute,
	const char *value)
{
	put_margin(gml);
	put(gml, "<");
	put(gml, name);
	if (value) {
		put(gml, " ");
		put(gml, attribute);
		put(gml, "=\"");
		put(gml, value);
		put(gml, "\"");
	}
	put(gml, ">");
}

static void
leaf_end(struct gml *gml, const char *name)
{
	put(gml, "</");
	put(gml, name);
	put(gml, ">\n");
}

void
gml_leaf_with(struct gml *gml, const char *name, const char *attribute,
	const char *value, const char *text)
{
	leaf_begin(gml, name, attribute, value);
	put(gml, text);
	leaf_end(gml, name);
}

void
gml_leaf(struct gml *gml, const char *name, const char *text)
{
	gml_leaf_with(gml, name, NULL, NULL, text);
}

void
gml_number(struct gml *gml, const char *name, long number)
{
	leaf_begin(gml, name, NULL, NULL);
	put_long(gml, number);
	leaf_end(gml, name);
}

void
gml_metres(struct gml *gml, const char *name, long millimetres)
{
	leaf_begin(gml, name, "uom", "m");
	put_metres(gml, millimetres);
	leaf_end(gml, name);
}

void
gml_corner(struct gml *gml, const char *name, struct spot spot)
{
	leaf_begin(gml, name, NULL, NULL);
	put_spot(gml, spot);
	leaf_end(gml, name);
}

void
gml_line(struct gml *gml, const char *text)
{
	put_margin(gml);
	put(gml, text);
	put(gml, "\n");
}

void
gml_link(struct gml *gml, const char *name, const char *id)
{
	put_margin(gml);
	put(gml, "<");
	put(gml, name);
	put(gml, " xlink:href=\"#");
	put(gml, id);
	put(gml, "\"/>\n");
}

void
gml_fresh_id(struct gml *gml, char out[GML_ID])
{
	snprintf(out, GML_ID, "_%llu", (unsigned long long)++gml->serial);
}

/* ---- geometry ---- */

static struct spot
ring_spot(
	const struct shape *shape, struct ring ring, size_t index, bool reverse)
{
	size_t at = index % ring.count;

	return shape->spots[ring.first + (reverse ? ring.count - 1 - at : at)];
}

/* One point as a pos, or as a point of its own. */
static void
put_ring_point(struct gml *gml, struct spot spot)
{
	char id[GML_ID];

	if (gml->style == STYLE_POINT_PROPERTY) {
		gml_fresh_id(gml, id);
		put(gml, "<gml:pointProperty><gml:Point gml:id=\"");
		put(gml, id);
		put(gml, "\">");
	}
	put(gml, "<gml:pos>");
	put_spot(gml, spot);
	put(gml, "</gml:pos>");
	if (gml->style == STYLE_POINT_PROPERTY)
		put(gml, "</gml:Point></gml:pointProperty>");
}

/* A ring stands on one line. */
static void
put_ring(struct gml *gml, const char *property, const struct shape *shape,
	struct ring ring, bool reverse)
{
	bool list = gml->style == STYLE_POS_LIST;

	leaf_begin(gml, property, NULL, NULL);
	put(gml, "<gml:LinearRing>");
	put(gml, list ? "<gml:posList>" : "");
	for (size_t i = 0; i <= ring.count; i++) {
		struct spot spot = ring_spot(shape, ring, i, reverse);

		if (!list) {
			put_ring_point(gml, spot);
			continue;
		}
		put(gml, i > 0 ? " " : "");
		put_spot(gml, spot);
	}
	put(gml, list ? "</gml:posList>" : "");
	put(gml, "</gml:LinearRing>");
	leaf_end(gml, property);
}

void
gml_polygon(struct gml *gml, const char *id, const struct shape *shape,
	const struct face *face, bool openings)
{
	gml_open(gml, "gml:Polygon", id);
	for (size_t i = 0; i < face->ring_count; i++)
		put_ring(gml, i == 0 ? "gml:exterior" : "gml:interior", shape,
			shape->rings[face->first_ring + i], false);
	for (size_t i = 0; openings && i < face->opening_count; i++)
		put_ring(gml, "gml:interior", shape,
			shape->openings[face->first_opening + i].ring, true);
	gml_close(gml, "gml:Polygon");
}

void
gml_ring_polygon(struct gml *gml, const char *id, const struct shape *shape,
	struct ring ring, bool reverse)
{
	gml_open(gml, "gml:Polygon", id);
	put_ring(gml, "gml:exterior", shape, ring, reverse);
	gml_close(gml, "gml:Polygon");
}

void
gml_triangle(struct gml *gml, const struct spot corner[3])
{
	leaf_begin(gml, "gml:Triangle", NULL, NULL);
	put(gml, "<gml:exterior><gml:LinearRing><gml:posList>");
	for (size_t i = 0; i < 4; i++) {
		put_spot(gml, corner[i % 3]);
		put(gml, i < 3 ? " " : "");
	}
	put(gml, "</gml:posList></gml:LinearRing></gml:exterior>");
	leaf_end(gml, "gml:Triangle");
}

void
gml_point(struct gml *gml, struct spot spot)
{
	char id[GML_ID];

	gml_fresh_id(gml, id);
	gml_open(gml, "gml:Point", id);
	leaf_begin(gml, "gml:pos", NULL, NULL);
	put_spot(gml, spot);
	leaf_end(gml, "gml:pos");
	gml_close(gml, "gml:Point");
}

/* A shell is a Shell in GML 3.2 and a CompositeSurface in GML 3.1. */
static const char *
shell_name(const struct gml *gml)
{
	return gml_name(gml, "gml:CompositeSurface", "gml:Shell");
}

static void
shell_open(struct gml *gml, const char *property)
{
	char id[GML_ID];

	gml_fresh_id(gml, id);
	gml_open(gml, property, NULL);
	gml_open(gml, shell_name(gml), id);
}

static void
shell_close(struct gml *gml, const char *property)
{
	gml_close(gml, shell_name(gml));
	gml_close(gml, property);
}

void
gml_solid_open(struct gml *gml, const char *id)
{
	char fresh[GML_ID];

	gml_fresh_id(gml, fresh);
	gml_open(gml, "gml:Solid", id ? id : fresh);
	shell_open(gml, "gml:exterior");
}

void
gml_solid_void(struct gml *gml)
{
	shell_close(gml, "gml:exterior");
	shell_open(gml, "gml:interior");
	gml->in_void = true;
}

void
gml_solid_close(struct gml *gml)
{
	shell_close(gml, gml->in_void ? "gml:interior" : "gml:exterior");
	gml->in_void = false;
	gml_close(gml, "gml:Solid");
}

void
gml_members(struct gml *gml, const struct shape *shape, size_t first_face,
	size_t face_count)
{
	for (size_t i = first_face; i < first_face + face_count; i++) {
		char id[GML_ID];

		gml_fresh_id(gml, id);
		gml_open(gml, "gml:surfaceMember", NULL);
		gml_polygon(gml, id, shape, &shape->faces[i], false);
		gml_close(gml, "gml:surfaceMember");
	}
}

void
gml_multi_surface(
	struct gml *gml, const char *property, const struct shape *shape)
{
	char id[GML_ID];

	gml_fresh_id(gml, id);
	gml_open(gml, property, NULL);
	gml_open(gml, "gml:MultiSurface", id);
	gml_members(gml, shape, 0, shape->face_count);
	gml_close(gml, "gml:MultiSurface");
	gml_close(gml, property);
}

void
gml_solid(struct gml *gml, const char *property, const struct shape *shape)
{
	gml_open(gml, property, NULL);
	gml_solid_open(gml, NULL);
	gml_members(gml, shape, 0, shape->face_count);
	gml_solid_close(gml);
	gml_close(gml, property);
}

/* ---- what every module uses ---- */

void
gml_member_open(struct gml *gml, const char *name, const char *id)
{
	gml_open(gml, "core:cityObjectMember", NULL);
	gml_open(gml, name, id);
}

void
gml_member_close(struct gml *gml, const char *name)
{
	gml_close(gml, name);
	gml_close(gml, "core:cityObjectMember");
}

static struct lod_name
qualified(const char *module, const char *name)
{
	struct lod_name out;

	snprintf(out.text, sizeof out.text, "%s:%s", module, name);
	return out;
}

/* Where 3.0 keeps a boundary surface: all but three are constructions'. */
static const char *
surface_module(const struct gml *gml, const char *module, const char *class)
{
	if (gml->version < 3 || !strcmp(module, "wtr") ||
		!strcmp(module, "tran"))
		return module;
	return strcmp(class, "ClosureSurface") ? "con" : "core";
}

void
gml_boundary_open(
	struct gml *gml, const char *module, const char *class, const char *id)
{
	struct lod_name property = qualified(module, "boundedBy");

	gml_open(gml, gml_name(gml, property.text, "core:boundary"), NULL);
	gml_open(gml, qualified(surface_module(gml, module, class), class).text,
		id);
}

void
gml_boundary_close(struct gml *gml, const char *module, const char *class)
{
	struct lod_name property = qualified(module, "boundedBy");

	gml_close(
		gml, qualified(surface_module(gml, module, class), class).text);
	gml_close(gml, gml_name(gml, property.text, "core:boundary"));
}
