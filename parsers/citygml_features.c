/*
 * Features and the properties below them.
 *
 * A property is what its content turns out to be: a feature begins a child, a
 * geometry begins a geometry, text makes an attribute, and further elements
 * make a set of attributes.
 */
#include <stdio.h>
#include <string.h>

#include "citygml_reader.h"

/* ---- features ---------------------------------------------------------------- */

/* The source's type where the class does not say it. */
static enum tcs_status
feature_set_type(struct gml_reader *reader, struct tcs_feature *feature,
	const struct name *name, struct tcs_fault *fault)
{
	char type[160];
	int length;

	if (name->kind == NAME_FEATURE)
		return TCS_OK;
	length = snprintf(type, sizeof type, "%.60s%s%.80s", name->prefix,
		*name->prefix ? ":" : "", name->local);
	return gml_text(reader, type, (size_t)length, &feature->type, fault);
}

/* The property that holds the feature being begun. */
static struct name *
holding_property(struct gml_reader *reader)
{
	struct frame *top = gml_top(reader);

	return reader->raw->tree.features.count > 0 && top->name ? top->name
								 : NULL;
}

static enum tcs_status
feature_add(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *id, uint32_t parent, struct name *role,
	uint32_t *out, struct tcs_fault *fault)
{
	struct tcs_object *tree = &reader->raw->tree;
	enum tcs_status status = TCS_OK;
	struct tcs_feature *feature;

	if (array_grow(&tree->features, 1))
		return fault_memory(fault);
	*out = (uint32_t)tree->features.count;
	feature = &tree->features.at[tree->features.count++];
	*feature = (struct tcs_feature){
		.parent = parent, .class = (uint16_t)name->class};
	if (id)
		status = gml_text(
			reader, id->value, id->length, &feature->id, fault);
	if (!status)
		status = feature_set_type(reader, feature, name, fault);
	if (!status && role)
		status = gml_name_text(reader, role, &feature->role, fault);
	return status;
}

enum tcs_status
feature_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	uint32_t parent = reader->raw ? gml_top(reader)->feature : TCS_NONE;
	enum tcs_status status;
	struct name *role;
	struct frame *frame;
	uint32_t feature;

	if (!reader->raw) {
		status = gml_open_object(reader, fault);
		if (status)
			return status;
	}
	role = holding_property(reader);
	status = feature_add(reader, name, attribute_find_id(attributes, count),
		parent, role, &feature, fault);
	if (!status)
		status = gml_push(reader, name, ROLE_FEATURE, &frame, fault);
	if (status)
		return status;
	frame->feature = feature;
	return TCS_OK;
}

/* Whether an element of an extension is an object: they are capitalised. */
static bool
is_foreign_object(const struct frame *frame)
{
	return frame->role == ROLE_ATTRIBUTE &&
		frame->name->space == SPACE_OTHER &&
		(frame->id ||
			(*frame->name->local >= 'A' &&
				*frame->name->local <= 'Z'));
}

/*
 * What was an attribute set becomes a feature: its members become attributes
 * of that, and the set itself goes (to no feature, which the sorting drops),
 * with the property around it if that holds nothing else.
 */
static void
attributes_move(struct gml_reader *reader, struct frame *frame,
	struct frame *property, uint32_t feature)
{
	struct tcs_object *tree = &reader->raw->tree;
	uint32_t set = frame->attribute;

	if (set == TCS_NONE)
		return;
	for (size_t i = set + 1u; i < tree->attributes.count; i++) {
		struct tcs_attribute *member = &tree->attributes.at[i];

		if (member->feature == frame->feature)
			member->feature = feature;
		if (member->parent == set)
			member->parent = TCS_NONE;
	}
	tree->attributes.at[set].feature = TCS_NONE;
	if (property->attribute != TCS_NONE && property->attribute + 1 == set) {
		tree->attributes.at[property->attribute].feature = TCS_NONE;
		property->attribute = TCS_NONE;
	}
}

/*
 * An element of an extension that holds geometry is a feature of its own:
 * turn the innermost one below the property into one.
 */
static enum tcs_status
feature_promote(struct gml_reader *reader, struct tcs_fault *fault)
{
	size_t i = reader->frames.count - 1;
	struct frame *frame;
	enum tcs_status status;
	uint32_t feature;

	while (i > 0 && attribute_may_come_of(&reader->frames.at[i]) &&
		!is_foreign_object(&reader->frames.at[i]))
		i--;
	frame = &reader->frames.at[i];
	if (!attribute_may_come_of(frame))
		return TCS_OK;
	status = feature_add(reader, frame->name, NULL, frame->feature,
		frame[-1].name, &feature, fault);
	if (status)
		return status;
	reader->raw->tree.features.at[feature].id = frame->id;
	attributes_move(reader, frame, frame - 1, feature);
	frame->role = ROLE_FEATURE;
	for (size_t j = i; j < reader->frames.count; j++) {
		reader->frames.at[j].feature = feature;
		reader->frames.at[j].attribute = TCS_NONE;
	}
	if (i + 1 < reader->frames.count)
		reader->frames.at[i + 1].role = ROLE_PROPERTY;
	return TCS_OK;
}

/* ---- properties ---------------------------------------------------------------- */

static enum tcs_status
relation_add(struct gml_reader *reader, struct name *role,
	const struct xml_attribute *href, const struct xml_attribute *note,
	struct tcs_fault *fault)
{
	struct tcs_object *tree = &reader->raw->tree;
	struct tcs_relation *relation;
	enum tcs_status status;
	size_t skip = href->length && *href->value == '#';

	if (array_grow(&tree->relations, 1))
		return fault_memory(fault);
	relation = &tree->relations.at[tree->relations.count++];
	*relation = (struct tcs_relation){.feature = gml_top(reader)->feature};
	status = gml_name_text(reader, role, &relation->role, fault);
	if (!status)
		status = gml_text(reader, href->value + skip,
			href->length - skip, &relation->target, fault);
	if (!status && note)
		status = gml_text(reader, note->value, note->length,
			&relation->note, fault);
	return status;
}

static enum tcs_status
property_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");
	enum tcs_status status;
	struct frame *frame;

	status = gml_push(reader, name, ROLE_PROPERTY, &frame, fault);
	if (!status)
		status = attribute_take_unit(
			reader, frame, attributes, count, fault);
	if (status)
		return status;
	frame->wants_text = true;
	if (href && name->lod != TCS_LOD_NONE)
		return geometry_link(reader, frame, href, fault);
	if (href)
		status = relation_add(reader, name, href,
			attribute_find(attributes, count, "role"), fault);
	if (status || name->lod != TCS_LOD_NONE)
		return status;
	return attribute_add_members(reader, attributes, count, fault);
}

static enum tcs_status
property_child_of_feature(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	switch (name->kind) {
	case NAME_BOUNDED_BY:
		return gml_push(reader, name, ROLE_BOUNDS, NULL, fault);
	case NAME_GENERIC_ATTRIBUTE:
		return generic_begin(reader, name, attributes, count, fault);
	default:
		return property_begin(reader, name, attributes, count, fault);
	}
}

/* An element below a property that is no feature, geometry or the like. */
static enum tcs_status
nested_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *id = attribute_find_id(attributes, count);
	enum tcs_status status;
	struct frame *frame;

	status = gml_push(reader, name, ROLE_ATTRIBUTE, &frame, fault);
	if (!status && id)
		status = gml_text(
			reader, id->value, id->length, &frame->id, fault);
	if (!status)
		status = attribute_take_unit(
			reader, frame, attributes, count, fault);
	if (status)
		return status;
	frame->wants_text = true;
	return attribute_add_members(reader, attributes, count, fault);
}

enum tcs_status
feature_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	enum frame_role role = gml_top(reader)->role;
	enum tcs_status status;

	if (role == ROLE_FEATURE)
		return property_child_of_feature(
			reader, name, attributes, count, fault);
	if (role == ROLE_GENERIC)
		return generic_child(reader, name, attributes, count, fault);
	if (geometry_is(name)) {
		status = feature_promote(reader, fault);
		if (status)
			return status;
		return geometry_begin(reader, name, attributes, count, fault);
	}
	switch (name->kind) {
	case NAME_FEATURE:
		return feature_begin(reader, name, attributes, count, fault);
	case NAME_GENERIC_ATTRIBUTE:
		return generic_begin(reader, name, attributes, count, fault);
	case NAME_IMPLICIT_GEOMETRY:
		return implicit_begin(reader, name, attributes, count, fault);
	case NAME_APPEARANCE:
		return appearance_child(reader, name, attributes, count, fault);
	default:
		return nested_begin(reader, name, attributes, count, fault);
	}
}

/* ---- ends --------------------------------------------------------------------------- */

static enum tcs_status
gml_name_end(struct gml_reader *reader, const struct frame *frame,
	struct tcs_fault *fault)
{
	struct tcs_feature *feature =
		&reader->raw->tree.features.at[frame->feature];
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	return gml_text(reader, at, length, &feature->name, fault);
}

/*
 * The frame that ends was popped, but still stands above the top: its
 * attribute is made in place.
 */
static enum tcs_status
property_end(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	bool first_name = frame->role == ROLE_PROPERTY &&
		frame->name->kind == NAME_GML_NAME &&
		!reader->raw->tree.features.at[frame->feature].name;
	enum tcs_status status = TCS_OK;

	if (frame->role == ROLE_ATTRIBUTE)
		status = attribute_add_id(reader, reader->frames.count, fault);
	if (status || frame->has_children)
		return status;
	if (first_name)
		status = gml_name_end(reader, frame, fault);
	if (status || (first_name && !frame->code_space))
		return status;
	return attribute_finish(reader, reader->frames.count, fault);
}

enum tcs_status
feature_end(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	switch (frame->role) {
	case ROLE_FEATURE:
		if (frame->feature == 0)
			gml_close_object(reader);
		return TCS_OK;
	case ROLE_PROPERTY:
	case ROLE_ATTRIBUTE:
		return property_end(reader, frame, fault);
	case ROLE_GENERIC_PART:
		return generic_part_end(reader, frame, fault);
	default:
		return TCS_OK;
	}
}
