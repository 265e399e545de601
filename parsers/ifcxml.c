#include "ifcxml.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "byte_index.h"
#include "citygml_xml.h"
#include "ifcxml_names.h"
#include "ifcxml_write.h"

enum { PIECE = 1 << 16, LONGEST_NAME = 64, LONGEST_URI = 128 };

enum level_kind {
	OUTER, /* around the instances */
	INSTANCE,
	ATTRIBUTE, /* of the instance around it */
	INVERSE, /* holds relations to the instance around it */
	VALUE, /* of a defined type, for the attribute around it */
	LINK, /* what is in it does not count */
};

struct level {
	enum level_kind kind;
	int position; /* of the attribute, among those of its instance */
	const char *name; /* of the element, without its prefix */
	const struct ifcxml_inverse *inverse;
	bool used; /* there is something in it already */
};

struct decoding {
	struct xml_parser *parser;
	struct report *report;
	struct step_bytes *out;
	bool began; /* the version is known, and the header written */
	enum ifc_version version;
	TCS_ARRAY(struct level) levels;
	TCS_ARRAY(struct ifcxml_instance) instances; /* open ones, and room */
	size_t open;
	struct byte_index ids;
	TCS_ARRAY(uint32_t) numbers; /* of the instances with these ids */
	uint32_t last_number;
	struct byte_index names;
	TCS_ARRAY(uint16_t) entities; /* of these names of elements */
	struct step_bytes text;
};

/* What the attributes of an element that are no attributes of IFC say. */
struct marks {
	const struct xml_attribute *id, *link, *type, *array_size;
	bool list;
	bool values; /* and there are such attributes, too */
};

static bool
attribute_is(const struct xml_attribute *attribute, const char *name)
{
	return !strcmp(attribute->local, name);
}

static struct marks
marks_of(const struct xml_attribute *attributes, size_t count)
{
	struct marks marks = {.id = NULL};

	for (size_t i = 0; i < count; i++) {
		const struct xml_attribute *at = attributes + i;

		if (attribute_is(at, "id"))
			marks.id = at;
		else if (attribute_is(at, "href") || attribute_is(at, "ref"))
			marks.link = at;
		else if (attribute_is(at, "type") && at->prefix)
			marks.type = at;
		else if (attribute_is(at, "arraySize"))
			marks.array_size = at;
		else if (attribute_is(at, "cType"))
			marks.list = true;
		else if (!at->prefix && !attribute_is(at, "pos"))
			marks.values = true;
	}
	return marks;
}

/* ---- names --------------------------------------------------------------- */

/* In capitals, without "-wrapper"; "" for what is too long. */
static void
type_name(const char *name, size_t length, char out[LONGEST_NAME])
{
	static const char wrapper[] = "-wrapper";
	size_t tail = sizeof wrapper - 1;

	out[0] = '\0';
	if (length > tail && !memcmp(name + length - tail, wrapper, tail))
		length -= tail;
	if (length >= LONGEST_NAME)
		return;
	for (size_t i = 0; i < length; i++) {
		char byte = name[i];

		out[i] = byte >= 'a' && byte <= 'z' ? (char)(byte - 'a' + 'A')
						    : byte;
	}
	out[length] = '\0';
}

/* What stands behind the prefix of a qualified name. */
static enum ifc_entity
entity_of_type(const struct xml_attribute *type)
{
	const char *colon = memchr(type->value, ':', type->length);
	const char *begin = colon ? colon + 1 : type->value;
	char name[LONGEST_NAME];

	type_name(begin, (size_t)(type->value + type->length - begin), name);
	return ifc_find(name);
}

static enum tcs_status
entity_of_name(struct decoding *decoding, const char *name,
	enum ifc_entity *out, struct tcs_fault *fault)
{
	enum tcs_status status;
	char type[LONGEST_NAME];
	uint32_t number;
	bool added;

	status = byte_index_add(
		&decoding->names, name, strlen(name), &number, &added, fault);
	if (status)
		return status;
	if (added) {
		if (array_grow(&decoding->entities, 1))
			return fault_memory(fault);
		type_name(name, strlen(name), type);
		decoding->entities.at[decoding->entities.count++] =
			(uint16_t)ifc_find(type);
	}
	*out = (enum ifc_entity)decoding->entities.at[number];
	return TCS_OK;
}

static bool
is_type_name(const char *name)
{
	return !strncmp(name, "Ifc", 3) || strstr(name, "-wrapper");
}

/* The number of the instance with an id, a new one where it is new. */
static enum tcs_status
number_of(struct decoding *decoding, const struct xml_attribute *id,
	uint32_t *out, struct tcs_fault *fault)
{
	const char *value = id->value;
	size_t length = id->length;
	enum tcs_status status;
	uint32_t index;
	bool added;

	if (length && *value == '#')
		value++, length--;
	status = byte_index_add(
		&decoding->ids, value, length, &index, &added, fault);
	if (status)
		return status;
	if (added) {
		if (array_grow(&decoding->numbers, 1))
			return fault_memory(fault);
		decoding->numbers.at[decoding->numbers.count++] =
			++decoding->last_number;
	}
	*out = decoding->numbers.at[index];
	return TCS_OK;
}

/* ---- the header ---------------------------------------------------------- */

static const char *
schema_of(const char *uri)
{
	static const struct {
		const char *sign, *schema;
	} schemas[] = {{"IFC2X", "IFC2X3"}, {"IFC4X3", "IFC4X3"},
		{"IFC4_3", "IFC4X3"}, {"IFC4", "IFC4"}};
	char text[LONGEST_URI] = "";

	for (size_t i = 0; uri[i] && i + 1 < sizeof text; i++)
		text[i] = uri[i] >= 'a' && uri[i] <= 'z'
			? (char)(uri[i] - 'a' + 'A')
			: uri[i];
	for (size_t i = 0; i < sizeof schemas / sizeof *schemas; i++)
		if (strstr(text, schemas[i].sign))
			return schemas[i].schema;
	return NULL;
}

static enum tcs_status
put_string(
	struct decoding *decoding, const char *string, struct tcs_fault *fault)
{
	return ifcxml_put(decoding->out, string, strlen(string), fault);
}

static enum tcs_status
header_write(
	struct decoding *decoding, const char *uri, struct tcs_fault *fault)
{
	const char *schema = uri ? schema_of(uri) : NULL;
	enum tcs_status status;

	if (!schema || !ifc_version_of(schema, &decoding->version))
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"line %u: not IFC: its namespace is that of no version",
			(unsigned)xml_line(decoding->parser));
	decoding->began = true;
	status = put_string(
		decoding, "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('", fault);
	if (!status)
		status = put_string(decoding, schema, fault);
	return status ? status
		      : put_string(decoding, "'));\nENDSEC;\nDATA;\n", fault);
}

/* ---- levels -------------------------------------------------------------- */

static struct level *
level_top(struct decoding *decoding)
{
	return decoding->levels.at + decoding->levels.count - 1;
}

static struct ifcxml_instance *
instance_top(struct decoding *decoding)
{
	return decoding->instances.at + decoding->open - 1;
}

static enum tcs_status
level_push(struct decoding *decoding, enum level_kind kind, const char *name,
	struct tcs_fault *fault)
{
	if (array_grow(&decoding->levels, 1))
		return fault_memory(fault);
	decoding->levels.at[decoding->levels.count++] =
		(struct level){.kind = kind, .name = name};
	return TCS_OK;
}

static enum tcs_status
left_out(struct decoding *decoding, const char *name, struct tcs_fault *fault)
{
	return report_item(decoding->report, REPORT_NOTE, "attribute",
		"the schema as it is read here has no place for it", name,
		xml_line(decoding->parser), fault);
}

static enum tcs_status
values_take(struct decoding *decoding, const struct xml_attribute *attributes,
	size_t count, struct tcs_fault *fault)
{
	struct ifcxml_instance *instance = instance_top(decoding);
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < count && !status; i++) {
		const struct xml_attribute *at = attributes + i;
		int position;

		if (at->prefix || attribute_is(at, "id") ||
			attribute_is(at, "pos"))
			continue;
		position = ifc_attribute(
			decoding->version, instance->entity, at->local);
		if (position < 0) {
			status = left_out(decoding, at->local, fault);
			continue;
		}
		ifcxml_slot_begin(instance, position, at->local);
		status = ifcxml_put_text(instance, position, at->local,
			at->value, at->length, fault);
	}
	return status;
}

/* Open an instance, for which the level of its element is there. */
static enum tcs_status
instance_open(struct decoding *decoding, enum ifc_entity entity,
	const struct xml_attribute *id, uint32_t *number,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (id)
		status = number_of(decoding, id, number, fault);
	else
		*number = ++decoding->last_number;
	if (status)
		return status;
	if (decoding->open == decoding->instances.count) {
		if (array_grow(&decoding->instances, 1))
			return fault_memory(fault);
		decoding->instances.at[decoding->instances.count++] =
			(struct ifcxml_instance){.number = 0};
	}
	decoding->open++;
	return ifcxml_instance_begin(instance_top(decoding), decoding->version,
		entity, *number, fault);
}

/* Set what leads back to the instance that an inverse attribute is of. */
static enum tcs_status
link_back(struct decoding *decoding, const struct ifcxml_inverse *inverse,
	uint32_t number, struct tcs_fault *fault)
{
	struct ifcxml_instance *instance = instance_top(decoding);
	int position = ifc_attribute(
		decoding->version, instance->entity, inverse->back);

	if (position < 0)
		return TCS_OK;
	ifcxml_slot_begin(instance, position, inverse->back);
	return ifcxml_put_link(instance, position, number, fault);
}

/*
 * An instance begins within what is on top, which is an attribute, an inverse
 * one or neither. With a level of its own or, when it is the attribute's
 * element itself, in place of that.
 */
static enum tcs_status
instance_within(struct decoding *decoding, enum ifc_entity entity,
	const struct xml_attribute *id, const char *name, bool in_place,
	struct tcs_fault *fault)
{
	struct level above = *level_top(decoding);
	uint32_t owner = decoding->open ? instance_top(decoding)->number : 0;
	size_t owner_at = decoding->open - 1;
	enum tcs_status status = TCS_OK;
	uint32_t number;

	level_top(decoding)->used = true;
	if (in_place)
		level_top(decoding)->kind = INSTANCE;
	else
		status = level_push(decoding, INSTANCE, name, fault);
	if (!status)
		status = instance_open(decoding, entity, id, &number, fault);
	if (!status && above.kind == ATTRIBUTE)
		status = ifcxml_put_link(decoding->instances.at + owner_at,
			above.position, number, fault);
	if (!status && above.kind == INVERSE)
		status = link_back(decoding, above.inverse, owner, fault);
	return status;
}

/* ---- elements ------------------------------------------------------------ */

struct element {
	const char *name, *uri;
	const struct xml_attribute *attributes;
	size_t count;
	struct marks marks;
};

/* The last number of "4 3": the length of a row. */
static unsigned
row_of(const struct xml_attribute *size)
{
	unsigned row = 0;
	bool second = false;

	for (size_t i = 0; size && i < size->length; i++) {
		char byte = size->value[i];

		if (byte == ' ') {
			second = row > 0;
			row = 0;
		} else if (byte >= '0' && byte <= '9' && row < 1000000) {
			row = row * 10 + (unsigned)(byte - '0');
		}
	}
	return second ? row : 0;
}

static enum tcs_status
attribute_begin(struct decoding *decoding, const struct element *element,
	int position, struct tcs_fault *fault)
{
	struct ifcxml_instance *instance = instance_top(decoding);
	struct ifcxml_slot *slot =
		ifcxml_slot_begin(instance, position, element->name);
	const struct marks *marks = &element->marks;
	enum ifc_entity type = ifcxml_declared(instance->entity, element->name);
	enum tcs_status status;
	uint32_t number;

	slot->list |= marks->list;
	if (row_of(marks->array_size)) {
		slot->row = row_of(marks->array_size);
		slot->list = true;
	}
	status = level_push(decoding, ATTRIBUTE, element->name, fault);
	if (status)
		return status;
	level_top(decoding)->position = position;
	if (marks->link) {
		level_top(decoding)->kind = LINK;
		status = number_of(decoding, marks->link, &number, fault);
		return status ? status
			      : ifcxml_put_link(instance_top(decoding),
					position, number, fault);
	}
	if (marks->type)
		type = entity_of_type(marks->type);
	if (!marks->type && !marks->id && !(marks->values && type != IFC_NONE))
		return TCS_OK;
	status = instance_within(decoding, type, marks->id, NULL, true, fault);
	return status ? status
		      : values_take(decoding, element->attributes,
				element->count, fault);
}

static enum tcs_status
inverse_begin(struct decoding *decoding, const struct element *element,
	const struct ifcxml_inverse *inverse, struct tcs_fault *fault)
{
	const struct marks *marks = &element->marks;
	enum ifc_entity type =
		marks->type ? entity_of_type(marks->type) : inverse->relation;
	enum tcs_status status;

	status = level_push(
		decoding, marks->link ? LINK : INVERSE, element->name, fault);
	if (status || marks->link)
		return status;
	level_top(decoding)->inverse = inverse;
	if (!marks->type && !marks->id && !marks->values)
		return TCS_OK;
	status = instance_within(decoding, type, marks->id, NULL, true, fault);
	return status ? status
		      : values_take(decoding, element->attributes,
				element->count, fault);
}

/* An element within an instance. */
static enum tcs_status
part_begin(struct decoding *decoding, const struct element *element, bool *skip,
	struct tcs_fault *fault)
{
	enum ifc_entity entity = instance_top(decoding)->entity;
	int position = ifc_attribute(decoding->version, entity, element->name);
	const struct ifcxml_inverse *inverse;

	if (entity == IFC_NONE) /* but there may be others within it */
		return level_push(decoding, OUTER, element->name, fault);
	if (position >= 0)
		return attribute_begin(decoding, element, position, fault);
	inverse = ifcxml_inverse_of(element->name);
	if (inverse)
		return inverse_begin(decoding, element, inverse, fault);
	*skip = true;
	return left_out(decoding, element->name, fault);
}

/* An element with the name of a type. */
static enum tcs_status
type_begin(struct decoding *decoding, const struct element *element,
	struct tcs_fault *fault)
{
	struct level above = *level_top(decoding);
	const struct marks *marks = &element->marks;
	enum ifc_entity entity = IFC_NONE;
	enum tcs_status status;
	uint32_t number;

	status = entity_of_name(decoding, element->name, &entity, fault);
	if (status)
		return status;
	if (marks->link) {
		level_top(decoding)->used = true;
		status = number_of(decoding, marks->link, &number, fault);
		if (!status && above.kind == ATTRIBUTE)
			status = ifcxml_put_link(instance_top(decoding),
				above.position, number, fault);
		return status
			? status
			: level_push(decoding, LINK, element->name, fault);
	}
	if (entity == IFC_NONE && !marks->id && above.kind == ATTRIBUTE)
		return level_push(decoding, VALUE, element->name, fault);
	status = instance_within(
		decoding, entity, marks->id, element->name, false, fault);
	return status || entity == IFC_NONE
		? status
		: values_take(
			  decoding, element->attributes, element->count, fault);
}

/* The instance that an attribute's element turns out to be. */
static enum ifc_entity
hidden_entity(struct decoding *decoding, const struct level *level)
{
	if (level->kind == INVERSE)
		return level->inverse->relation;
	return ifcxml_declared(instance_top(decoding)->entity, level->name);
}

static enum tcs_status
element_begin(struct decoding *decoding, const struct element *element,
	bool *skip, struct tcs_fault *fault)
{
	const struct level *above = level_top(decoding);
	enum ifc_entity hidden;
	enum tcs_status status;

	if (above->kind == INSTANCE)
		return part_begin(decoding, element, skip, fault);
	if (above->kind == VALUE || above->kind == LINK) {
		*skip = true;
		return TCS_OK;
	}
	if (is_type_name(element->name))
		return type_begin(decoding, element, fault);
	if (above->kind == OUTER)
		return level_push(decoding, OUTER, element->name, fault);
	hidden = hidden_entity(decoding, above);
	if (hidden == IFC_NONE || above->used) {
		*skip = true;
		return TCS_OK;
	}
	status = instance_within(decoding, hidden, NULL, NULL, true, fault);
	return status ? status : part_begin(decoding, element, skip, fault);
}

static bool
is_root(const char *name)
{
	return !strcmp(name, "ifcXML") || !strcmp(name, "uos") ||
		!strcmp(name, "iso_10303_28");
}

static enum tcs_status
start(void *context, struct name *name, const struct xml_attribute *attributes,
	size_t count, bool *skip, struct tcs_fault *fault)
{
	struct decoding *decoding = context;
	struct element element = {.name = name->local,
		.uri = name->uri,
		.attributes = attributes,
		.count = count,
		.marks = marks_of(attributes, count)};
	enum tcs_status status = TCS_OK;

	decoding->text.count = 0;
	if (!decoding->levels.count) {
		if (!is_root(element.name))
			return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
				"line %u: not ifcXML: its root is %.60s",
				(unsigned)xml_line(decoding->parser),
				element.name);
		return level_push(decoding, OUTER, element.name, fault);
	}
	if (!decoding->began && !strncmp(element.name, "Ifc", 3))
		status = header_write(decoding, element.uri, fault);
	if (!status && !decoding->began)
		return level_push(decoding, OUTER, element.name, fault);
	return status ? status : element_begin(decoding, &element, skip, fault);
}

static enum tcs_status
value_end(struct decoding *decoding, const struct level *value,
	struct tcs_fault *fault)
{
	struct level *above = level_top(decoding) - 1;
	char type[LONGEST_NAME];

	type_name(value->name, strlen(value->name), type);
	if (!strncmp(type, IFCXML_SEQUENCE "-", sizeof IFCXML_SEQUENCE))
		snprintf(type, sizeof type, IFCXML_SEQUENCE);
	else if (strspn(type, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789") !=
			strlen(type) ||
		strncmp(type, "IFC", 3))
		type[0] = '\0';
	above->used = true;
	return ifcxml_put_typed(instance_top(decoding), above->position, type,
		decoding->text.at, decoding->text.count, fault);
}

static enum tcs_status
end(void *context, struct tcs_fault *fault)
{
	struct decoding *decoding = context;
	const struct level *level = level_top(decoding);
	enum tcs_status status = TCS_OK;

	if (level->kind == INSTANCE) {
		status = ifcxml_instance_write(
			instance_top(decoding), decoding->out, fault);
		decoding->open--;
	} else if (level->kind == VALUE) {
		status = value_end(decoding, level, fault);
	} else if (level->kind == ATTRIBUTE && !level->used) {
		status = ifcxml_put_text(instance_top(decoding),
			level->position, level->name, decoding->text.at,
			decoding->text.count, fault);
	}
	decoding->text.count = 0;
	decoding->levels.count--;
	return status;
}

static enum tcs_status
text(void *context, const char *bytes, size_t length, struct tcs_fault *fault)
{
	struct decoding *decoding = context;

	if (!decoding->levels.count)
		return TCS_OK;
	return ifcxml_put(&decoding->text, bytes, length, fault);
}

/* ---- the contract -------------------------------------------------------- */

bool
ifcxml_is(const char *bytes, size_t length)
{
	size_t at = 0;

	if (length >= 2 &&
		(!memcmp(bytes, "\xff\xfe", 2) ||
			!memcmp(bytes, "\xfe\xff", 2)))
		return true;
	if (length >= 3 && !memcmp(bytes, "\xef\xbb\xbf", 3))
		at = 3;
	while (at < length && strchr(" \t\r\n", bytes[at]) && bytes[at])
		at++;
	return at < length && bytes[at] == '<';
}

static enum tcs_status
decode(struct decoding *decoding, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (array_grow(&decoding->text, PIECE)) /* and so it is somewhere */
		return fault_memory(fault);
	for (size_t at = 0; at < length && !status; at += PIECE)
		status = xml_feed(decoding->parser, bytes + at,
			length - at < PIECE ? length - at : PIECE, fault);
	if (!status)
		status = xml_feed(decoding->parser, "", 0, fault);
	if (!status && !decoding->began)
		status = fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"not IFC: there is no instance in it");
	return status
		? status
		: put_string(decoding, "ENDSEC;\nEND-ISO-10303-21;\n", fault);
}

enum tcs_status
ifcxml_decode(const char *bytes, size_t length, struct step_bytes *out,
	struct report *report, struct tcs_fault *fault)
{
	struct decoding decoding = {.report = report, .out = out};
	struct names names = {.version = 2};
	const struct xml_handler handler = {
		.context = &decoding, .start = start, .end = end, .text = text};
	const struct xml_limits limits = {
		.depth = IFCXML_MOST_DEPTH, .tag = length, .fixed = true};
	enum tcs_status status;

	decoding.parser = xml_new(&handler, &limits, &names);
	status = decoding.parser ? decode(&decoding, bytes, length, fault)
				 : fault_memory(fault);
	xml_free(decoding.parser);
	for (size_t i = 0; i < decoding.instances.count; i++)
		ifcxml_instance_release(decoding.instances.at + i);
	array_release(&decoding.instances);
	array_release(&decoding.levels);
	byte_index_release(&decoding.ids);
	array_release(&decoding.numbers);
	byte_index_release(&decoding.names);
	array_release(&decoding.entities);
	array_release(&decoding.text);
	return status;
}
