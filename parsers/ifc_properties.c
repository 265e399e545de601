#include <math.h>
#include <string.h>

#include "ifc_attributes.h"
#include "ifc_features.h"
#include "step_string.h"

enum { SET_NAME = 2 };

enum { PROPERTY_NAME = 0, PROPERTY_VALUES = 7, MOST_DEPTH = 4 };

/* Positions, all below PROPERTY_VALUES. */
enum { SINGLE_VALUE = 2, SINGLE_UNIT = 3 };
enum { BOUNDED_UPPER = 2, BOUNDED_LOWER, BOUNDED_UNIT, BOUNDED_SET_POINT };
enum { TABLE_DEFINING = 2, TABLE_DEFINED, TABLE_EXPRESSION, TABLE_UNITS };
enum { REFERENCE_OBJECT = 3 };
enum { QUANTITY_UNIT = 2, QUANTITY_VALUE = 3 };
enum { COMPLEX_QUANTITIES = 2, COMPLEX_PROPERTIES = 3 };

/* ---- values -------------------------------------------------------------- */

static enum tcs_status
text_plain(struct tcs_object *out, const char *text, size_t length,
	tcs_text *to, struct tcs_fault *fault)
{
	return length ? text_append(out, text, length, to, fault) : TCS_OK;
}

static enum tcs_status
truth_fill(const struct step_value *value, struct tcs_object *out,
	struct tcs_attribute *to, struct tcs_fault *fault)
{
	bool yes = step_is(value, "T"), no = step_is(value, "F");
	const char *word = yes ? "true" : no ? "false" : "unknown";

	if (!yes && !no && !step_is(value, "U"))
		return text_plain(
			out, value->text, value->length, &to->value, fault);
	if (yes || no) {
		to->type = TCS_BOOLEAN;
		to->number = yes;
	}
	return text_plain(out, word, strlen(word), &to->value, fault);
}

static enum tcs_status
number_fill(const struct step_value *value, const char *unit,
	struct tcs_object *out, struct tcs_attribute *to,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		text_plain(out, value->text, value->length, &to->value, fault);

	if (value->kind == STEP_INTEGER) {
		to->type = TCS_INTEGER;
		to->number = (double)value->integer;
	} else {
		to->type = TCS_DOUBLE;
		to->number = value->real;
	}
	if (status || !*unit)
		return status;
	to->type = TCS_MEASURE;
	return text_plain(out, unit, strlen(unit), &to->unit, fault);
}

/* The values of a list, as "a, b"; strings without characters are none. */
static enum tcs_status
list_fill(const struct step_value *list, const char *unit,
	struct tcs_object *out, struct tcs_attribute *to,
	struct tcs_fault *fault)
{
	struct step_text joined = {.count = 0};
	struct step_cursor walk = list->list;
	enum tcs_status status = TCS_OK;
	struct step_value item;
	unsigned trouble = 0;

	while (!status && step_next(&walk, &item) > STEP_END) {
		struct step_value inner = step_untyped(&item);

		if (inner.kind == STEP_LIST || inner.kind == STEP_UNSET ||
			!inner.length)
			continue;
		if (joined.count)
			status = step_decode(&joined, ", ", 2, &trouble, fault);
		if (!status)
			status = step_decode(&joined, inner.text, inner.length,
				&trouble, fault);
	}
	if (!status)
		status = text_plain(
			out, joined.at, joined.count, &to->value, fault);
	if (!status)
		status = text_plain(out, unit, strlen(unit), &to->unit, fault);
	array_release(&joined);
	return status;
}

/* What the unit of a measure is called; "" for a number without. */
static const char *
unit_of(const struct ifc_saying *saying, const struct step_value *value)
{
	if (value->kind != STEP_TYPED)
		return "";
	return ifc_unit_of_measure(
		&saying->model->project_units, value->text, value->length);
}

/* That of the first value of a list. */
static const char *
list_unit(const struct ifc_saying *saying, const struct step_value *list)
{
	struct step_cursor walk = list->list;
	struct step_value first;

	return step_next(&walk, &first) > STEP_END ? unit_of(saying, &first)
						   : "";
}

/* The type, value, number and unit; *unset where there is no value. */
static enum tcs_status
value_fill(const struct ifc_saying *saying, const struct step_value *value,
	const char *unit, struct tcs_attribute *to, bool *unset,
	struct tcs_fault *fault)
{
	struct step_value inner = step_untyped(value);

	to->type = TCS_STRING;
	to->number = NAN;
	*unset = false;
	switch (inner.kind) {
	case STEP_STRING:
		return ifc_text_add(saying->out, &inner, &to->value, fault);
	case STEP_ENUMERATION:
		return truth_fill(&inner, saying->out, to, fault);
	case STEP_INTEGER:
	case STEP_REAL:
		return number_fill(&inner, unit ? unit : unit_of(saying, value),
			saying->out, to, fault);
	case STEP_LIST:
		return list_fill(&inner,
			unit ? unit : list_unit(saying, &inner), saying->out,
			to, fault);
	default:
		*unset = true;
		return TCS_OK;
	}
}

static enum tcs_status
attribute_push(const struct ifc_saying *saying, struct tcs_attribute attribute,
	struct tcs_fault *fault)
{
	attribute.feature = saying->feature;
	attribute.flags = TCS_ATTRIBUTE_GENERIC;
	if (array_grow(&saying->out->attributes, 1))
		return fault_memory(fault);
	saying->out->attributes.at[saying->out->attributes.count++] = attribute;
	return TCS_OK;
}

enum tcs_status
ifc_attribute_value(struct ifc_saying *saying, uint32_t parent,
	const char *name, const struct step_value *value, const char *unit,
	struct tcs_fault *fault)
{
	struct tcs_attribute attribute = {.parent = parent};
	enum tcs_status status;
	bool unset;

	status = value_fill(saying, value, unit, &attribute, &unset, fault);
	if (status || unset)
		return status;
	status = text_plain(
		saying->out, name, strlen(name), &attribute.name, fault);
	return status ? status : attribute_push(saying, attribute, fault);
}

static enum tcs_status
string_push(struct ifc_saying *saying, uint32_t parent, tcs_text name,
	const char *text, size_t length, struct tcs_fault *fault)
{
	struct tcs_attribute attribute = {
		.parent = parent, .name = name, .number = NAN};
	enum tcs_status status =
		text_plain(saying->out, text, length, &attribute.value, fault);

	return status ? status : attribute_push(saying, attribute, fault);
}

enum tcs_status
ifc_attribute_string(struct ifc_saying *saying, uint32_t parent,
	const char *name, const char *text, size_t length,
	struct tcs_fault *fault)
{
	tcs_text named = 0;
	enum tcs_status status =
		text_plain(saying->out, name, strlen(name), &named, fault);

	return status ? status
		      : string_push(saying, parent, named, text, length, fault);
}

/* Append a set without members; its number in *set. */
static enum tcs_status
attribute_set(struct ifc_saying *saying, uint32_t parent, tcs_text name,
	uint32_t *set, struct tcs_fault *fault)
{
	*set = (uint32_t)saying->out->attributes.count;
	return attribute_push(saying,
		(struct tcs_attribute){.number = NAN,
			.parent = parent,
			.name = name,
			.type = TCS_SET},
		fault);
}

enum tcs_status
ifc_attribute_set(struct ifc_saying *saying, uint32_t parent, const char *name,
	uint32_t *set, struct tcs_fault *fault)
{
	tcs_text text = 0;
	enum tcs_status status =
		text_plain(saying->out, name, strlen(name), &text, fault);

	return status ? status
		      : attribute_set(saying, parent, text, set, fault);
}

/* ---- properties ---------------------------------------------------------- */

/* A name that is said already is passed over: false in *fresh. */
static enum tcs_status
name_take(const struct ifc_saying *saying, uint32_t parent,
	const struct step_value *value, tcs_text *name, bool *fresh,
	struct tcs_fault *fault)
{
	enum tcs_status status = ifc_text_add(saying->out, value, name, fault);
	uint32_t found = TCS_NONE;

	if (!status && *name)
		status = ifc_attribute_find(saying->names, saying->out, parent,
			*name, &found, fault);
	*fresh = *name && found == TCS_NONE;
	return status;
}

/* The type of unit that a quantity has where it names none; NULL: a count. */
static const char *
quantity_unit(enum ifc_entity entity)
{
	switch (entity) {
	case IFC_QUANTITYLENGTH:
		return "LENGTHUNIT";
	case IFC_QUANTITYAREA:
		return "AREAUNIT";
	case IFC_QUANTITYVOLUME:
		return "VOLUMEUNIT";
	case IFC_QUANTITYWEIGHT:
		return "MASSUNIT";
	case IFC_QUANTITYTIME:
		return "TIMEUNIT";
	default:
		return NULL;
	}
}

static enum tcs_status
named_value(struct ifc_saying *saying, uint32_t parent, tcs_text name,
	const struct step_value *value, const char *unit,
	struct tcs_fault *fault)
{
	struct tcs_attribute attribute = {.parent = parent, .name = name};
	enum tcs_status status;
	bool unset;

	status = value_fill(saying, value, unit, &attribute, &unset, fault);
	return status || unset ? status
			       : attribute_push(saying, attribute, fault);
}

/* What the unit that a value refers to is called; NULL: it refers to none. */
static const char *
unit_named(const struct ifc_saying *saying, const struct step_value *value,
	char room[IFC_UNIT_ROOM])
{
	const struct ifc_file *file = &saying->model->file;
	uint32_t unit = step_target(file->step, value);

	if (unit == STEP_NONE)
		return NULL;
	ifc_unit_name(file, unit, room);
	return room;
}

static enum tcs_status
bounds_write(struct ifc_saying *saying, uint32_t parent,
	const struct step_value *values, tcs_text name, struct tcs_fault *fault)
{
	static const struct {
		const char *name;
		int at;
	} bounds[] = {{"Upper", BOUNDED_UPPER}, {"Lower", BOUNDED_LOWER},
		{"SetPoint", BOUNDED_SET_POINT}};
	char room[IFC_UNIT_ROOM];
	const char *unit = unit_named(saying, values + BOUNDED_UNIT, room);
	uint32_t set;
	enum tcs_status status =
		attribute_set(saying, parent, name, &set, fault);

	for (size_t i = 0; i < sizeof bounds / sizeof *bounds && !status; i++)
		status = ifc_attribute_value(saying, set, bounds[i].name,
			values + bounds[i].at, unit, fault);
	return status;
}

/* The values that define, those defined, in the same order, and the formula. */
static enum tcs_status
table_write(struct ifc_saying *saying, uint32_t parent,
	const struct step_value *values, tcs_text name, struct tcs_fault *fault)
{
	static const char *const names[] = {"Defining", "Defined"};
	char room[IFC_UNIT_ROOM];
	uint32_t set;
	enum tcs_status status;

	if (values[TABLE_DEFINED].kind != STEP_LIST)
		return TCS_OK;
	status = attribute_set(saying, parent, name, &set, fault);
	for (int i = 0; i < 2 && !status; i++)
		status = ifc_attribute_value(saying, set, names[i],
			values + TABLE_DEFINING + i,
			unit_named(saying, values + TABLE_UNITS + i, room),
			fault);
	return status ? status
		      : ifc_attribute_value(saying, set, "Expression",
				values + TABLE_EXPRESSION, "", fault);
}

static enum tcs_status
reference_write(struct ifc_saying *saying, uint32_t parent, uint32_t object,
	tcs_text name, struct tcs_fault *fault)
{
	struct step_text text = {.count = 0};
	enum tcs_status status =
		ifc_reference_text(&saying->model->file, object, &text, fault);

	if (!status && text.count)
		status = string_push(
			saying, parent, name, text.at, text.count, fault);
	array_release(&text);
	return status;
}

static enum tcs_status
quantity_write(struct ifc_saying *saying, uint32_t parent,
	enum ifc_entity entity, const struct step_value *values, tcs_text name,
	struct tcs_fault *fault)
{
	const char *type = quantity_unit(entity);
	char room[IFC_UNIT_ROOM];
	const char *unit = unit_named(saying, values + QUANTITY_UNIT, room);

	if (!unit && type)
		unit = ifc_unit_of_type(&saying->model->project_units, type);
	return named_value(
		saying, parent, name, values + QUANTITY_VALUE, unit, fault);
}

static enum tcs_status properties_list(struct ifc_saying *saying,
	uint32_t parent, struct step_value list, unsigned depth,
	struct tcs_fault *fault);

/* One property or quantity with a name that is new. */
static enum tcs_status
property_write(struct ifc_saying *saying, uint32_t parent, uint32_t property,
	const struct step_value *values, tcs_text name, unsigned depth,
	struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	enum ifc_entity entity = ifc_entity_of(file, property);
	enum tcs_status status;
	char room[IFC_UNIT_ROOM];
	uint32_t set;

	switch (entity) {
	case IFC_PROPERTYSINGLEVALUE:
	case IFC_PROPERTYLISTVALUE:
		return named_value(saying, parent, name, values + SINGLE_VALUE,
			unit_named(saying, values + SINGLE_UNIT, room), fault);
	case IFC_PROPERTYENUMERATEDVALUE:
		return named_value(saying, parent, name, values + SINGLE_VALUE,
			NULL, fault);
	case IFC_PROPERTYBOUNDEDVALUE:
		return bounds_write(saying, parent, values, name, fault);
	case IFC_PROPERTYTABLEVALUE:
		return table_write(saying, parent, values, name, fault);
	case IFC_PROPERTYREFERENCEVALUE:
		return reference_write(saying, parent,
			step_target(file->step, values + REFERENCE_OBJECT),
			name, fault);
	case IFC_COMPLEXPROPERTY:
	case IFC_PHYSICALCOMPLEXQUANTITY:
		if (depth == MOST_DEPTH)
			return TCS_OK;
		status = attribute_set(saying, parent, name, &set, fault);
		return status ? status
			      : properties_list(saying, set,
					values[entity == IFC_COMPLEXPROPERTY
							? COMPLEX_PROPERTIES
							: COMPLEX_QUANTITIES],
					depth + 1, fault);
	default:
		if (!ifc_is_kind(file, property, IFC_PHYSICALSIMPLEQUANTITY))
			return TCS_OK;
		return quantity_write(
			saying, parent, entity, values, name, fault);
	}
}

static enum tcs_status
properties_list(struct ifc_saying *saying, uint32_t parent,
	struct step_value list, unsigned depth, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	struct step_value item;

	while (!status && list.kind == STEP_LIST &&
		saying->out->attributes.count - saying->first <
			IFC_MOST_ATTRIBUTES &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t property =
			step_target(saying->model->file.step, &item);
		struct step_value values[PROPERTY_VALUES] = {
			{.kind = STEP_END}};
		struct step_cursor cursor;
		tcs_text name;
		bool fresh;

		if (property == STEP_NONE)
			continue;
		cursor = step_parameters(saying->model->file.step, property);
		step_fetch(&cursor, values, PROPERTY_VALUES);
		status = name_take(saying, parent, values + PROPERTY_NAME,
			&name, &fresh, fault);
		if (!status && fresh)
			status = property_write(saying, parent, property,
				values, name, depth, fault);
	}
	return status;
}

enum tcs_status
ifc_properties_write(
	struct ifc_saying *saying, uint32_t set, struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	enum ifc_entity entity = ifc_entity_of(file, set);
	struct step_value value = ifc_value(file, set, SET_NAME);
	enum tcs_status status;
	uint32_t at;
	tcs_text name;

	if (entity != IFC_PROPERTYSET && entity != IFC_ELEMENTQUANTITY)
		return TCS_OK;
	status = ifc_text_add(saying->out, &value, &name, fault);
	if (!status && !name)
		status = text_append(
			saying->out, "Properties", 10, &name, fault);
	if (status)
		return status;
	status = ifc_attribute_find(
		saying->names, saying->out, TCS_NONE, name, &at, fault);
	if (status)
		return status;
	if (at == TCS_NONE || saying->out->attributes.at[at].type != TCS_SET)
		status = attribute_set(saying, TCS_NONE, name, &at, fault);
	if (status)
		return status;
	return properties_list(saying, at,
		ifc_value(file, set, entity == IFC_PROPERTYSET ? 4 : 5), 0,
		fault);
}
