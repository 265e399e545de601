/*
 * Implicit geometry: templates in coordinates of their own, and the places
 * where features put them.
 *
 * A template gets its number in the stream when it first comes, under its id;
 * links to it find the number, and an object with a link to a template that is
 * still to come waits for a later pass. A template without an id is known by
 * its place in the document, so that every pass gives it the same number.
 *
 * source: CityGML 2.0 (OGC 12-019) 8.2 and 10.8.
 */
#include <stdio.h>
#include <string.h>

#include "citygml_numbers.h"
#include "citygml_reader.h"

static struct raw_instance *
instance_last(struct gml_reader *reader)
{
	return &reader->raw->instances.at[reader->raw->instances.count - 1];
}

/* ---- the template ------------------------------------------------------------ */

static enum tcs_status
template_link(struct gml_reader *reader, const struct xml_attribute *href,
	struct tcs_fault *fault)
{
	struct raw_instance *instance = instance_last(reader);
	size_t skip = href->length && *href->value == '#';
	enum tcs_status status;

	status = gml_text(reader, href->value + skip, href->length - skip,
		&instance->href, fault);
	if (status)
		return status;
	instance->prototype = keys_find(&reader->templates,
		object_text(&reader->raw->tree, instance->href));
	if (instance->prototype == TCS_NONE)
		reader->raw->waits = true;
	else
		instance->href = 0;
	return TCS_OK;
}

enum tcs_status
template_add(struct gml_reader *reader, const char *key, uint32_t geometry,
	struct raw_instance *instance, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	enum tcs_status status;
	bool added;

	status = keys_add(
		&reader->templates, key, &instance->prototype, &added, fault);
	if (status || !added)
		return status;
	if (array_grow(&raw->templates, 1))
		return fault_memory(fault);
	raw->templates.at[raw->templates.count++] =
		(struct raw_template){geometry, instance->prototype};
	return TCS_OK;
}

/* The geometry below relativeGMLGeometry is complete. */
static enum tcs_status
template_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_instance *instance = instance_last(reader);
	uint32_t geometry = instance->geometry;
	char place[64];
	const char *id;

	if (geometry == raw->geometries.count)
		return TCS_OK; /* there was none */
	id = object_text(&raw->tree, raw->geometries.at[geometry].id);
	if (!*id) {
		snprintf(place, sizeof place, "\n%llu.%zu",
			(unsigned long long)(raw->place.at ? raw->place.at
							   : raw->place.number),
			raw->instances.count);
		id = place;
	}
	return template_add(reader, id, geometry, instance, fault);
}

/* ---- the placement -------------------------------------------------------------- */

enum tcs_status
implicit_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *id = attribute_find_id(attributes, count);
	const struct frame *property = gml_top(reader);
	struct raw_object *raw = reader->raw;
	struct raw_instance *instance;
	enum tcs_status status = TCS_OK;

	if (gml_out_of_turn(reader))
		return gml_skip(reader);
	if (array_grow(&raw->instances, 1))
		return fault_memory(fault);
	instance = &raw->instances.at[raw->instances.count++];
	*instance = (struct raw_instance){
		.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
		.feature = property->feature,
		.prototype = TCS_NONE,
		.geometry = (uint32_t)raw->geometries.count,
		.line = xml_line(reader->xml),
		.lod = property->name->lod,
	};
	reader->geometry_srs = TCS_NONE;
	if (id)
		status = gml_text(
			reader, id->value, id->length, &instance->id, fault);
	if (status)
		return status;
	return gml_push(reader, name, ROLE_IMPLICIT, NULL, fault);
}

enum tcs_status
implicit_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");
	const struct xml_attribute *srs =
		attribute_find(attributes, count, "srsName");
	bool in_template =
		gml_top(reader)->name->kind == NAME_IMPLICIT_TEMPLATE;
	enum tcs_status status = TCS_OK;
	struct frame *frame;

	if (in_template && geometry_is(name))
		return geometry_begin(reader, name, attributes, count, fault);
	if (name->kind == NAME_IMPLICIT_TEMPLATE && href)
		status = template_link(reader, href, fault);
	if (!status && srs && srs->length)
		status = gml_srs(reader, srs->value, srs->length,
			&reader->geometry_srs, fault);
	if (!status)
		status = gml_push(reader, name, ROLE_IMPLICIT, &frame, fault);
	if (status)
		return status;
	frame->wants_text = name->kind == NAME_IMPLICIT_MATRIX ||
		name->kind == NAME_IMPLICIT_OBJECT || name->kind == NAME_POS ||
		name->kind == NAME_COORDINATES;
	return TCS_OK;
}

static void
anchor_end(struct gml_reader *reader)
{
	struct raw_instance *instance = instance_last(reader);
	uint32_t system = gml_system(reader, reader->geometry_srs);
	int count = numbers_first(
		reader->text.at, reader->text.count, instance->anchor, 3);

	instance->has_anchor = count >= 2;
	if (!instance->has_anchor || system == TCS_NONE)
		return;
	if (reader->first_srs == TCS_NONE)
		reader->first_srs = system;
	instance->swap = gml_north_first(
		reader, system, reader->text.at, reader->text.count);
}

enum tcs_status
implicit_end(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	struct raw_instance *instance = instance_last(reader);

	switch (frame->name->kind) {
	case NAME_IMPLICIT_MATRIX:
		instance->has_matrix =
			numbers_first(reader->text.at, reader->text.count,
				instance->matrix, 16) == 16;
		return TCS_OK;
	case NAME_IMPLICIT_OBJECT:
		return mesh_take(reader, instance, fault);
	case NAME_IMPLICIT_TEMPLATE:
		return frame->has_children ? template_end(reader, fault)
					   : TCS_OK;
	case NAME_POS:
	case NAME_COORDINATES:
		anchor_end(reader);
		return TCS_OK;
	default:
		return TCS_OK;
	}
}
