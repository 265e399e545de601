/*
 * The document, the model and its members.
 */
#include <stdio.h>
#include <string.h>

#include "citygml_reader.h"

static enum tcs_status
model_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *id = attribute_find_id(attributes, count);
	enum tcs_status status;
	struct xml_stretch tag;

	xml_place_tag(reader->xml, &tag);
	reader->head_end = tag.end;
	status = text_keep(&reader->model_id, id ? id->value : "",
		id ? id->length : 0, fault);
	return status ? status
		      : gml_push(reader, name, ROLE_MODEL, NULL, fault);
}

enum tcs_status
document_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	if (name->kind == NAME_CITY_MODEL)
		return model_begin(reader, name, attributes, count, fault);
	if (name->kind == NAME_FEATURE && reader->pass == PASS_APPEARANCES)
		return gml_skip(reader);
	if (name->kind == NAME_FEATURE)
		return feature_begin(reader, name, attributes, count, fault);
	return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
		"line %u: not CityGML: the root element is %.80s",
		xml_line(reader->xml), name->local);
}

/* Global appearances are read into an object that is none of the model's. */
static enum tcs_status
sheet_open(struct gml_reader *reader, struct tcs_fault *fault)
{
	if (!reader->raw)
		reader->raw = raw_new();
	if (!reader->raw || array_grow(&reader->raw->positions, 64))
		return fault_memory(fault);
	return TCS_OK;
}

/* A member that is somewhere else: named, never fetched. */
static enum tcs_status
member_link(struct gml_reader *reader, const struct xml_attribute *attributes,
	size_t count, struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");
	char target[128];

	if (!href)
		return TCS_OK;
	snprintf(target, sizeof target, "%.*s",
		href->length < 100 ? (int)href->length : 100, href->value);
	return gml_skipped(
		reader, "member", "a link, not followed", target, fault);
}

/* Where it stands, unless its tag is too long for any use of that. */
static void
member_place(struct gml_reader *reader)
{
	struct xml_stretch *tag = &reader->member;

	if (!xml_place_tag(reader->xml, tag) ||
		tag->end - tag->at > MEMBER_TAG_MAX)
		*tag = (struct xml_stretch){0};
}

/* Where the head of the stream keeps it, whose making the first feature begins;
 * NULL for what it does not keep. */
static struct kept_text *
model_text(struct gml_reader *reader, const struct name *name)
{
	struct kept_text *to = NULL;

	if (name->kind == NAME_GML_NAME)
		to = &reader->model_name;
	else if (name->space == SPACE_GML &&
		!strcmp(name->local, "description"))
		to = &reader->model_description;
	return to && !to->count && !reader->objects ? to : NULL;
}

/* What else a model says of itself: versions, definitions, metadata. */
static enum tcs_status
model_property(
	struct gml_reader *reader, struct name *name, struct tcs_fault *fault)
{
	struct frame *frame;
	enum tcs_status status;

	if (model_text(reader, name)) {
		status = gml_push(reader, name, ROLE_MODEL_TEXT, &frame, fault);
		if (!status)
			frame->wants_text = true;
		return status;
	}
	status = gml_skipped(reader, "property of the model",
		"it has no place in a stream", name->local, fault);
	return status ? status : gml_skip(reader);
}

enum tcs_status
model_text_end(struct gml_reader *reader, const struct frame *frame,
	struct tcs_fault *fault)
{
	return gml_keep(reader, model_text(reader, frame->name), fault);
}

/* In the appearances' pass only global appearances are read, and the bounds:
 * georeferenced textures need to know the coordinate system. */
enum tcs_status
model_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	bool wanted = name->kind == NAME_APPEARANCE_MEMBER
		? reader->pass == PASS_APPEARANCES
		: reader->pass == PASS_OBJECTS || name->kind == NAME_BOUNDED_BY;
	enum tcs_status status;

	if (!wanted)
		return gml_skip(reader);
	switch (name->kind) {
	case NAME_MEMBER:
		member_place(reader);
		status = member_link(reader, attributes, count, fault);
		if (status)
			return status;
		return gml_push(reader, name, ROLE_MEMBER, NULL, fault);
	case NAME_APPEARANCE_MEMBER:
		status = member_link(reader, attributes, count, fault);
		if (!status)
			status = sheet_open(reader, fault);
		if (status)
			return status;
		return gml_push(reader, name, ROLE_APPEARANCE, NULL, fault);
	case NAME_BOUNDED_BY:
		return gml_push(reader, name, ROLE_BOUNDS, NULL, fault);
	default:
		return model_property(reader, name, fault);
	}
}

enum tcs_status
member_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	if (name->kind == NAME_APPEARANCE)
		return gml_skip(reader);
	return feature_begin(reader, name, attributes, count, fault);
}
