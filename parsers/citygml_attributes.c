/*
 * Attributes: standard ones, those of extensions, and generic ones.
 *
 * An attribute is made only when its first text comes, the sets around it
 * before it; so a property that turns out to hold a feature or a geometry
 * leaves nothing behind.
 */
#include <math.h>
#include <string.h>

#include "citygml_reader.h"
#include "number.h"

/* ---- attributes ------------------------------------------------------------ */

static struct tcs_attribute *
attribute_at(struct gml_reader *reader, uint32_t index)
{
	return &reader->raw->tree.attributes.at[index];
}

static enum tcs_status
attribute_add(struct gml_reader *reader, uint32_t feature, uint32_t parent,
	enum tcs_attribute_type type, uint32_t *out, struct tcs_fault *fault)
{
	struct tcs_object *tree = &reader->raw->tree;

	if (array_grow(&tree->attributes, 1))
		return fault_memory(fault);
	*out = (uint32_t)tree->attributes.count;
	tree->attributes.at[tree->attributes.count++] = (struct tcs_attribute){
		.number = NAN,
		.feature = feature,
		.parent = parent,
		.type = (uint16_t)type,
	};
	return TCS_OK;
}

static double
boolean_of(const char *at, size_t length)
{
	if ((length == 4 && !memcmp(at, "true", 4)) ||
		(length == 1 && *at == '1'))
		return 1;
	if ((length == 5 && !memcmp(at, "false", 5)) ||
		(length == 1 && *at == '0'))
		return 0;
	return NAN;
}

static double
number_of(enum tcs_attribute_type type, const char *at, size_t length)
{
	double number;

	switch (type) {
	case TCS_INTEGER:
	case TCS_DOUBLE:
	case TCS_MEASURE:
		if (length && *at == '+')
			at++, length--;
		if (number_parse(at, at + length, &number) != at + length)
			return NAN;
		return isfinite(number) ? number : NAN;
	case TCS_BOOLEAN:
		return boolean_of(at, length);
	default:
		return NAN;
	}
}

static enum tcs_status
attribute_set_value(struct gml_reader *reader, uint32_t index, const char *at,
	size_t length, struct tcs_fault *fault)
{
	struct tcs_attribute *attribute = attribute_at(reader, index);

	attribute->number = number_of(attribute->type, at, length);
	return gml_text(reader, at, length, &attribute->value, fault);
}

/* The namespace prefix of names that are not CityGML's or GML's. */
static enum tcs_status
attribute_set_name(struct gml_reader *reader, uint32_t index, struct name *name,
	struct tcs_fault *fault)
{
	struct tcs_attribute *attribute = attribute_at(reader, index);
	enum tcs_status status;

	status = gml_name_text(reader, name, &attribute->name, fault);
	if (status || name->space != SPACE_OTHER)
		return status;
	return gml_text(reader, name->prefix, strlen(name->prefix),
		&attribute->space, fault);
}

/* The frame of the property or element that an attribute would come from. */
bool
attribute_may_come_of(const struct frame *frame)
{
	return frame->role == ROLE_PROPERTY || frame->role == ROLE_ATTRIBUTE;
}

/*
 * Make the attribute of a frame, and of those around it up to the property,
 * outermost first.
 */
static enum tcs_status
frame_make_attribute(
	struct gml_reader *reader, size_t index, struct tcs_fault *fault)
{
	size_t first = index;

	while (first > 0 && attribute_may_come_of(&reader->frames.at[first]) &&
		reader->frames.at[first].role != ROLE_PROPERTY &&
		reader->frames.at[first].attribute == TCS_NONE)
		first--;
	for (; first <= index; first++) {
		struct frame *frame = &reader->frames.at[first];
		uint32_t parent = reader->frames.at[first - 1].attribute;
		enum tcs_status status;

		if (frame->attribute != TCS_NONE)
			continue;
		if (frame->role == ROLE_PROPERTY)
			parent = TCS_NONE;
		status = attribute_add(reader, frame->feature, parent, TCS_SET,
			&frame->attribute, fault);
		if (!status)
			status = attribute_set_name(
				reader, frame->attribute, frame->name, fault);
		if (status)
			return status;
		attribute_at(reader, frame->attribute)->unit = frame->unit;
		attribute_at(reader, frame->attribute)->code_space =
			frame->code_space;
	}
	return TCS_OK;
}

/* An XML attribute that is no id or unit: a member "@name". A property's link
 * and its role are more than that. */
static bool
is_plain_attribute(const struct xml_attribute *attribute, bool of_property)
{
	static const char *const known[] = {"id", "gml_id", "uom", "codeSpace",
		"srsName", "srsDimension", "type", "schemaLocation", "nil",
		"lang", "space"};
	bool is_link = attribute->prefix && !strcmp(attribute->prefix, "xlink");

	if (!strcmp(attribute->local, "type") && !attribute->prefix)
		return true;
	for (size_t i = 0; i < sizeof known / sizeof *known; i++)
		if (*attribute->local == *known[i] &&
			!strcmp(attribute->local, known[i]))
			return false;
	return !is_link || (!of_property && !strcmp(attribute->local, "href"));
}

static enum tcs_status
frame_add_member(struct gml_reader *reader, size_t index, const char *local,
	const char *value, size_t length, struct tcs_fault *fault)
{
	char name[128] = "@";
	enum tcs_status status;
	uint32_t member;

	status = frame_make_attribute(reader, index, fault);
	if (status)
		return status;
	status = attribute_add(reader, reader->frames.at[index].feature,
		reader->frames.at[index].attribute, TCS_STRING, &member, fault);
	if (status)
		return status;
	strncat(name, local, sizeof name - 2);
	status = gml_text(reader, name, strlen(name),
		&attribute_at(reader, member)->name, fault);
	if (status)
		return status;
	return attribute_set_value(reader, member, value, length, fault);
}

enum tcs_status
attribute_add_members(struct gml_reader *reader,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	size_t index = reader->frames.count - 1;
	bool of_property = reader->frames.at[index].role == ROLE_PROPERTY;
	bool links = of_property && attribute_find(attributes, count, "href");

	for (size_t i = 0; i < count; i++) {
		enum tcs_status status;

		if (!is_plain_attribute(&attributes[i], of_property) ||
			(links && !strcmp(attributes[i].local, "role")))
			continue;
		status = frame_add_member(reader, index, attributes[i].local,
			attributes[i].value, attributes[i].length, fault);
		if (status)
			return status;
	}
	return TCS_OK;
}

/* Of an element that became no feature; its set is made for it if need be. */
enum tcs_status
attribute_add_id(
	struct gml_reader *reader, size_t index, struct tcs_fault *fault)
{
	tcs_text id = reader->frames.at[index].id;
	enum tcs_status status;
	uint32_t member;

	if (!id)
		return TCS_OK;
	status = frame_make_attribute(reader, index, fault);
	if (!status)
		status = attribute_add(reader, reader->frames.at[index].feature,
			reader->frames.at[index].attribute, TCS_STRING, &member,
			fault);
	if (!status)
		status = gml_text(reader, "@id", 3,
			&attribute_at(reader, member)->name, fault);
	if (!status)
		attribute_at(reader, member)->value = id;
	return status;
}

/* uom and codeSpace wait in the frame for the attribute. */
enum tcs_status
attribute_take_unit(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *unit =
		attribute_find(attributes, count, "uom");
	const struct xml_attribute *space =
		attribute_find(attributes, count, "codeSpace");
	enum tcs_status status = TCS_OK;

	if (unit)
		status = gml_text(
			reader, unit->value, unit->length, &frame->unit, fault);
	if (!status && space)
		status = gml_text(reader, space->value, space->length,
			&frame->code_space, fault);
	return status;
}

static enum tcs_attribute_type
type_of(const struct frame *frame)
{
	if (frame->unit)
		return TCS_MEASURE;
	if (frame->code_space)
		return TCS_CODE;
	return frame->name->attribute;
}

/* The element was a leaf with text. */
enum tcs_status
attribute_finish(
	struct gml_reader *reader, size_t index, struct tcs_fault *fault)
{
	struct tcs_attribute *attribute;
	enum tcs_status status;
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	if (!length)
		return TCS_OK;
	status = frame_make_attribute(reader, index, fault);
	if (status)
		return status;
	attribute = attribute_at(reader, reader->frames.at[index].attribute);
	attribute->type = (uint16_t)type_of(&reader->frames.at[index]);
	return attribute_set_value(
		reader, reader->frames.at[index].attribute, at, length, fault);
}

/* ---- generic attributes -------------------------------------------------- */

enum tcs_status
generic_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct frame *parent = gml_top(reader);
	const struct xml_attribute *given =
		attribute_find(attributes, count, "name");
	uint32_t set =
		parent->role == ROLE_GENERIC ? parent->attribute : TCS_NONE;
	uint32_t feature = parent->feature;
	struct tcs_attribute *attribute;
	enum tcs_status status;
	struct frame *frame;

	status = gml_push(reader, name, ROLE_GENERIC, &frame, fault);
	if (!status)
		status = attribute_add(reader, feature, set, name->attribute,
			&frame->attribute, fault);
	if (!status)
		status = attribute_take_unit(
			reader, frame, attributes, count, fault);
	if (status)
		return status;
	attribute = attribute_at(reader, frame->attribute);
	attribute->flags = TCS_ATTRIBUTE_GENERIC;
	attribute->code_space = frame->code_space;
	if (!given)
		return TCS_OK;
	return gml_text(
		reader, given->value, given->length, &attribute->name, fault);
}

/* Below a generic attribute: its name or value; below a set: its members. */
enum tcs_status
generic_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	uint32_t attribute = gml_top(reader)->attribute;
	enum tcs_status status;
	struct frame *frame;

	if (name->kind == NAME_GENERIC_ATTRIBUTE)
		return generic_begin(reader, name, attributes, count, fault);
	if (strcmp(name->local, "name") && strcmp(name->local, "value")) {
		/* gen:genericAttribute, the property around a member */
		status = gml_push(reader, name, ROLE_GENERIC, &frame, fault);
		if (!status)
			frame->attribute = attribute;
		return status;
	}
	status = gml_push(reader, name, ROLE_GENERIC_PART, &frame, fault);
	if (status)
		return status;
	frame->wants_text = true;
	frame->attribute = attribute;
	return attribute_take_unit(reader, frame, attributes, count, fault);
}

enum tcs_status
generic_part_end(struct gml_reader *reader, const struct frame *frame,
	struct tcs_fault *fault)
{
	struct tcs_attribute *attribute =
		attribute_at(reader, frame->attribute);
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	if (frame->name->local[0] == 'n')
		return gml_text(reader, at, length, &attribute->name, fault);
	if (frame->unit)
		attribute->unit = frame->unit;
	if (frame->code_space)
		attribute->code_space = frame->code_space;
	return attribute_set_value(reader, frame->attribute, at, length, fault);
}
