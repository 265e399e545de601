/*
 * GML geometry: what of it bounds solids, surfaces, lines and points.
 *
 * Every leaf (a polygon, patch, triangle, line string or point) becomes one
 * raw polygon and one member of the geometry being read; links become members
 * too. An element with an id is remembered as the run of members below it,
 * so that links find polygons, surfaces, shells and solids alike.
 *
 * source: GML 3.1.1 (OGC 03-105r1) clause 10, GML 3.2.1 (OGC 07-036).
 */
#include "citygml_reader.h"

#include <string.h>

bool
geometry_is(const struct name *name)
{
	switch (name->kind) {
	case NAME_SOLID:
	case NAME_AGGREGATE:
	case NAME_ORIENTABLE:
	case NAME_SURFACE:
	case NAME_POLYGON:
	case NAME_LINE:
	case NAME_POINT:
	case NAME_CURVE:
	case NAME_RING:
	case NAME_CURVE_UNKNOWN:
	case NAME_SURFACE_UNKNOWN:
		return true;
	default:
		return false;
	}
}

static uint8_t
kind_of(const struct name *name)
{
	switch (name->kind) {
	case NAME_SOLID:
	case NAME_AGGREGATE:
	case NAME_SURFACE:
		return name->geometry;
	case NAME_LINE:
	case NAME_CURVE:
	case NAME_RING:
		return TCS_MULTI_CURVE;
	case NAME_POINT:
		return TCS_MULTI_POINT;
	default:
		return TCS_MULTI_SURFACE;
	}
}

/* ---- members --------------------------------------------------------------- */

static enum tcs_status
member_add(struct gml_reader *reader, const struct frame *frame,
	uint32_t polygon, const struct xml_attribute *href,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_member *member;
	size_t skip;

	if (array_grow(&raw->members, 1))
		return fault_memory(fault);
	member = &raw->members.at[raw->members.count++];
	*member = (struct raw_member){
		.polygon = polygon,
		.shell = frame->shell,
		.reversed = frame->reversed,
	};
	if (!href)
		return TCS_OK;
	raw->has_links = true;
	skip = href->length && *href->value == '#';
	return gml_text(reader, href->value + skip, href->length - skip,
		&member->href, fault);
}

static enum tcs_status
polygon_add(struct gml_reader *reader, struct frame *frame,
	enum raw_shape shape, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;

	if (array_grow(&raw->polygons, 1))
		return fault_memory(fault);
	frame->polygon = (uint32_t)raw->polygons.count++;
	raw->polygons.at[frame->polygon] = (struct raw_polygon){
		.id = frame->id,
		.first_ring = (uint32_t)raw->rings.count,
		.line = xml_line(reader->xml),
		.geometry = (uint32_t)raw->geometries.count - 1,
		.shape = (uint8_t)shape,
	};
	return member_add(reader, frame, frame->polygon, NULL, fault);
}

static enum tcs_status
ring_add(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;

	if (array_grow(&raw->rings, 1))
		return fault_memory(fault);
	reader->pos_ring = (uint32_t)raw->rings.count++;
	raw->rings.at[reader->pos_ring] = (struct raw_ring){
		.first = raw->positions.count,
		.id = frame->id,
		.dimension = frame->dimension,
		.interior = frame->interior,
	};
	raw->polygons.at[frame->polygon].ring_count++;
	return TCS_OK;
}

static enum tcs_status
shell_add(struct gml_reader *reader, struct frame *frame, bool interior,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;

	if (array_grow(&raw->shells, 1))
		return fault_memory(fault);
	frame->is_shell = true;
	frame->shell = (uint32_t)raw->shells.count++;
	raw->shells.at[frame->shell] = (struct raw_shell){
		.geometry = (uint32_t)raw->geometries.count - 1,
		.solid = reader->solids ? reader->solids - 1 : 0,
		.interior = interior,
	};
	return TCS_OK;
}

/* ---- elements ---------------------------------------------------------------- */

static uint8_t
dimension_of(const struct xml_attribute *attributes, size_t count)
{
	const struct xml_attribute *dimension =
		attribute_find(attributes, count, "srsDimension");

	if (!dimension || dimension->length != 1 || *dimension->value < '2' ||
		*dimension->value > '3')
		return 0;
	return (uint8_t)(*dimension->value - '0');
}

static enum tcs_status
take_attributes(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *id = attribute_find_id(attributes, count);
	const struct xml_attribute *srs =
		attribute_find(attributes, count, "srsName");
	uint8_t dimension = dimension_of(attributes, count);
	enum tcs_status status = TCS_OK;

	if (dimension)
		frame->dimension = dimension;
	if (id)
		status = gml_text(
			reader, id->value, id->length, &frame->id, fault);
	if (!status && srs && srs->length && reader->geometry_srs == TCS_NONE)
		status = gml_srs(reader, srs->value, srs->length,
			&reader->geometry_srs, fault);
	return status;
}

/* exterior and interior: of a polygon's rings or of a solid's shells. */
static enum tcs_status
boundary_begin(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");
	enum tcs_status status;

	frame->interior = frame->name->kind == NAME_INTERIOR;
	if (frame->polygon != TCS_NONE)
		return TCS_OK;
	status = shell_add(reader, frame, frame->interior, fault);
	if (!status && href)
		status = member_add(reader, frame, TCS_NONE, href, fault);
	return status;
}

/* The surface directly in a solid's exterior or interior names the shell. */
static void
shell_take_id(struct gml_reader *reader, const struct frame *frame)
{
	const struct frame *parent =
		&reader->frames.at[reader->frames.count - 2];

	if (parent->role == ROLE_GEOMETRY && parent->is_shell)
		reader->raw->shells.at[frame->shell].id = frame->id;
}

static enum tcs_status
ring_begin(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (reader->pos_ring != TCS_NONE)
		return TCS_OK; /* a LineString of a Ring, a Point of a line */
	if (frame->polygon == TCS_NONE)
		status = polygon_add(reader, frame,
			frame->name->kind == NAME_POINT ? RAW_POINT : RAW_LINE,
			fault);
	if (!status)
		status = ring_add(reader, frame, fault);
	return status;
}

static void
orientable_begin(struct frame *frame, const struct xml_attribute *attributes,
	size_t count)
{
	const struct xml_attribute *orientation =
		attribute_find(attributes, count, "orientation");

	if (orientation && orientation->length == 1 &&
		*orientation->value == '-')
		frame->reversed = !frame->reversed;
}

static bool
is_position(const struct name *name)
{
	return name->kind == NAME_POS || name->kind == NAME_POS_LIST ||
		name->kind == NAME_COORDINATES || name->kind == NAME_COORD;
}

/* X, Y, Z of a GML 2 coord. */
static bool
is_ordinate(const struct frame *parent, const struct name *name)
{
	return parent->name->kind == NAME_COORD && name->length == 1;
}

/* The element is a frame on top of the stack; do what it means. */
static enum tcs_status
element_begin(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");

	switch (frame->name->kind) {
	case NAME_SOLID:
		reader->solids++;
		frame->shell = TCS_NONE;
		return TCS_OK;
	case NAME_EXTERIOR:
	case NAME_INTERIOR:
		return boundary_begin(reader, frame, attributes, count, fault);
	case NAME_POLYGON:
		return polygon_add(reader, frame, RAW_AREA, fault);
	case NAME_RING:
	case NAME_LINE:
	case NAME_POINT:
		return ring_begin(reader, frame, fault);
	case NAME_ORIENTABLE:
		orientable_begin(frame, attributes, count);
		return TCS_OK;
	case NAME_AGGREGATE:
	case NAME_SURFACE:
		shell_take_id(reader, frame);
		return TCS_OK;
	default:
		if (!href)
			return TCS_OK;
		if (frame->polygon != TCS_NONE)
			return gml_skipped(reader, "position",
				"links to points are not followed", NULL,
				fault);
		return member_add(reader, frame, TCS_NONE, href, fault);
	}
}

/* Curved pieces are not read: the piece is missing, and said so. */
static enum tcs_status
skip_unknown(
	struct gml_reader *reader, struct name *name, struct tcs_fault *fault)
{
	enum tcs_status status = gml_skipped(reader, "curved geometry",
		"only straight lines and planar faces are read", name->local,
		fault);

	if (status)
		return status;
	return gml_skip(reader);
}

static bool
is_textured(const struct frame *frame)
{
	return frame->name->kind == NAME_ORIENTABLE &&
		!strcmp(frame->name->local, "TexturedSurface");
}

/* They may stand in a TexturedSurface, and nowhere else. */
static enum tcs_status
skip_texture(struct gml_reader *reader, const struct name *name,
	struct tcs_fault *fault)
{
	enum tcs_status status = gml_skipped(reader,
		name->kind == NAME_TEXTURE ? "texture" : "material",
		"inside a geometry", NULL, fault);

	return status ? status : gml_skip(reader);
}

enum tcs_status
geometry_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct frame *parent = gml_top(reader);
	bool ordinate = is_ordinate(parent, name);
	enum tcs_status status;
	struct frame *frame;

	if (name->kind == NAME_CURVE_UNKNOWN ||
		name->kind == NAME_SURFACE_UNKNOWN)
		return skip_unknown(reader, name, fault);
	if (is_textured(parent) && !strcmp(name->local, "appearance"))
		return textured_begin(reader, name, attributes, count, fault);
	if (parent->paints)
		return textured_child(reader, name, attributes, count, fault);
	if (name->kind == NAME_TEXTURE || name->kind == NAME_MATERIAL)
		return skip_texture(reader, name, fault);
	status = gml_push(reader, name, ROLE_GEOMETRY, &frame, fault);
	if (!status)
		status = take_attributes(
			reader, frame, attributes, count, fault);
	if (status)
		return status;
	frame->first_member = (uint32_t)reader->raw->members.count;
	if (is_position(name) || ordinate) {
		frame->wants_text = reader->pos_ring != TCS_NONE &&
			name->kind != NAME_COORD;
		return TCS_OK;
	}
	return element_begin(reader, frame, attributes, count, fault);
}

/* ---- the whole of one geometry ------------------------------------------------ */

static enum tcs_status
geometry_add(struct gml_reader *reader, const struct frame *property,
	uint8_t kind, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_geometry *geometry;

	if (array_grow(&raw->geometries, 1))
		return fault_memory(fault);
	geometry = &raw->geometries.at[raw->geometries.count++];
	*geometry = (struct raw_geometry){
		.feature = property->feature,
		.first_member = (uint32_t)raw->members.count,
		.line = xml_line(reader->xml),
		.lod = property->name->lod,
		.kind = kind,
		.is_template = property->role == ROLE_IMPLICIT,
	};
	reader->geometry_srs = TCS_NONE;
	reader->pos_ring = TCS_NONE;
	reader->solids = 0;
	return gml_name_text(reader, property->name, &geometry->role, fault);
}

enum tcs_status
geometry_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	enum tcs_status status;

	status = geometry_add(reader, gml_top(reader), kind_of(name), fault);
	if (!status)
		status = geometry_child(reader, name, attributes, count, fault);
	if (status)
		return status;
	if (gml_top(reader)->role == ROLE_GEOMETRY)
		raw->geometries.at[raw->geometries.count - 1].id =
			gml_top(reader)->id;
	return TCS_OK;
}

enum tcs_status
geometry_link(struct gml_reader *reader, struct frame *property,
	const struct xml_attribute *href, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	enum tcs_status status;

	status = geometry_add(reader, property, RAW_KIND_UNKNOWN, fault);
	if (!status)
		status = member_add(reader, property, TCS_NONE, href, fault);
	if (status)
		return status;
	raw->geometries.at[raw->geometries.count - 1].member_count = 1;
	return TCS_OK;
}

/* The system in force for the geometry, and the order of its axes. */
static void
geometry_set_order(
	struct gml_reader *reader, const struct raw_geometry *geometry)
{
	struct raw_object *raw = reader->raw;
	uint32_t system = gml_system(reader, reader->geometry_srs);

	if (system == TCS_NONE || geometry->is_template)
		return;
	if (reader->first_srs == TCS_NONE)
		reader->first_srs = system;
	for (uint32_t i = geometry->first_member; i < raw->members.count; i++) {
		struct raw_polygon *polygon;
		const struct raw_ring *ring;

		if (raw->members.at[i].polygon == TCS_NONE)
			continue;
		polygon = &raw->polygons.at[raw->members.at[i].polygon];
		if (!polygon->ring_count)
			continue;
		ring = &raw->rings.at[polygon->first_ring];
		polygon->swap = gml_north_first(reader, system,
			raw->positions.at + ring->first, ring->length);
		polygon->degrees = reader->systems.at[system].srs.kind ==
			TCS_CRS_GEOGRAPHIC;
	}
}

static void
geometry_close(struct gml_reader *reader)
{
	struct raw_object *raw = reader->raw;
	struct raw_geometry *geometry =
		&raw->geometries.at[raw->geometries.count - 1];

	geometry->member_count =
		(uint32_t)raw->members.count - geometry->first_member;
	geometry_set_order(reader, geometry);
}

/* ---- text and ends ---------------------------------------------------------------- */

enum tcs_status
geometry_text(struct gml_reader *reader, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	char *at;

	if (array_grow(&raw->positions, length + 1))
		return fault_memory(fault);
	at = raw->positions.at + raw->positions.count;
	memcpy(at, bytes, length);
	raw->positions.count += length;
	if (gml_top(reader)->name->kind != NAME_COORDINATES)
		return TCS_OK;
	for (size_t i = 0; i < length; i++)
		if (at[i] == ',')
			at[i] = ' ';
	return TCS_OK;
}

static enum tcs_status
position_end(struct gml_reader *reader, const struct frame *frame,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_ring *ring;

	if (reader->pos_ring == TCS_NONE)
		return TCS_OK;
	if (array_grow(&raw->positions, 1))
		return fault_memory(fault);
	raw->positions.at[raw->positions.count++] = ' ';
	ring = &raw->rings.at[reader->pos_ring];
	ring->length = raw->positions.count - ring->first;
	if (frame->name->kind == NAME_POS || frame->name->kind == NAME_COORD)
		ring->pos_count++;
	else if (frame->name->kind != NAME_OTHER)
		ring->has_list = true;
	if (frame->dimension)
		ring->dimension = frame->dimension;
	return TCS_OK;
}

static enum tcs_status
target_add(struct gml_reader *reader, const struct frame *frame, bool reversed,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;

	if (array_grow(&raw->targets, 1))
		return fault_memory(fault);
	raw->targets.at[raw->targets.count++] = (struct raw_target){
		.id = frame->id,
		.first_member = frame->first_member,
		.member_end = (uint32_t)raw->members.count,
		.reversed = reversed,
	};
	return TCS_OK;
}

/* The one patch of a Surface, or segment of a Curve, which have no ids, goes by
 * its. */
static void
patch_take_id(struct gml_reader *reader, const struct frame *frame)
{
	struct raw_object *raw = reader->raw;
	uint32_t polygon;

	if (raw->members.count != frame->first_member + 1u)
		return;
	polygon = raw->members.at[frame->first_member].polygon;
	if (polygon != TCS_NONE && !raw->polygons.at[polygon].id)
		raw->polygons.at[polygon].id = frame->id;
}

enum tcs_status
geometry_end(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	const struct frame *parent = gml_top(reader);
	enum tcs_status status = TCS_OK;

	if (is_position(frame->name) || is_ordinate(parent, frame->name))
		return position_end(reader, frame, fault);
	if (frame->id && frame->name->kind != NAME_RING)
		status = target_add(reader, frame, parent->reversed, fault);
	if (status)
		return status;
	if (frame->id && parent->role == ROLE_GEOMETRY &&
		(frame->name->kind == NAME_SURFACE ||
			frame->name->kind == NAME_CURVE))
		patch_take_id(reader, frame);
	if (frame->name->kind == NAME_RING || parent->polygon == TCS_NONE)
		reader->pos_ring = TCS_NONE;
	if (parent->role != ROLE_GEOMETRY)
		geometry_close(reader);
	return TCS_OK;
}
