#include <ctype.h>
#include <math.h>

#include "ifc_georeference.h"
#include "number.h"

enum { SET_NAME = 2, SET_PROPERTIES = 4 };

enum { PROPERTY_NAME, SINGLE_VALUE = 2, PROPERTY_VALUES };

/* Whether a string is a word, but for case. */
static bool
says(const struct step_value *value, const char *word)
{
	size_t i = 0;

	if (value->kind != STEP_STRING)
		return false;
	while (i < value->length && word[i] &&
		tolower((unsigned char)value->text[i]) == word[i])
		i++;
	return i == value->length && !word[i];
}

/* The value of a property of a set; STEP_END where there is none. */
static struct step_value
property_find(const struct ifc_file *file, uint32_t set, const char *name)
{
	struct step_value list = ifc_value(file, set, SET_PROPERTIES), item;

	while (list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t property = step_target(file->step, &item);
		struct step_value values[PROPERTY_VALUES] = {
			{.kind = STEP_END}};
		struct step_cursor cursor;

		if (ifc_entity_of(file, property) != IFC_PROPERTYSINGLEVALUE)
			continue;
		cursor = step_parameters(file->step, property);
		step_fetch(&cursor, values, PROPERTY_VALUES);
		if (says(values + PROPERTY_NAME, name))
			return step_untyped(values + SINGLE_VALUE);
	}
	return (struct step_value){.kind = STEP_END};
}

/* A number, or the text of one; *there stays true only if it is. */
static double
number_find(const struct ifc_file *file, uint32_t set, const char *name,
	double otherwise, bool *there)
{
	struct step_value value = property_find(file, set, name);
	double number = otherwise;
	bool read = step_number(&value, &number) ||
		(value.kind == STEP_STRING && value.length &&
			number_parse(value.text, value.text + value.length,
				&number) == value.text + value.length);

	read = read && isfinite(number);
	*there = *there && read;
	return read ? number : otherwise;
}

/* Metres of a unit that a property names; 0 for one that is not known. */
static double
unit_find(const struct ifc_file *file, uint32_t set)
{
	static const struct {
		const char *name;
		double metres;
	} units[] = {{"metre", 1}, {"meter", 1}, {"m", 1}, {"millimetre", 1e-3},
		{"mm", 1e-3}, {"foot", 0.3048}, {"ft", 0.3048},
		{"us survey foot", 1200.0 / 3937}};
	struct step_value name = property_find(file, set, "mapunit");

	for (size_t i = 0; i < sizeof units / sizeof *units; i++)
		if (says(&name, units[i].name))
			return units[i].metres;
	return 0;
}

/* The property set called `name`, or that with an e before it. */
static uint32_t
set_find(const struct ifc_model *model, const char *name)
{
	const struct ifc_file *file = &model->file;

	for (size_t i = 0; i < model->links.count; i++) {
		const struct ifc_said *said = model->links.at + i;
		enum ifc_entity entity = ifc_entity_of(file, said->object);
		struct step_value value;

		if ((entity != IFC_PROJECT && entity != IFC_SITE &&
			    entity != IFC_BUILDING) ||
			ifc_entity_of(file, said->target) != IFC_PROPERTYSET)
			continue;
		value = ifc_value(file, said->target, SET_NAME);
		if (says(&value, name) || says(&value, name + 1))
			return said->target;
	}
	return STEP_NONE;
}

bool
ifc_map_properties_read(
	const struct ifc_model *model, struct ifc_map_operation *out)
{
	const struct ifc_file *file = &model->file;
	uint32_t set = set_find(model, "epset_mapconversion");
	uint32_t crs = set_find(model, "epset_projectedcrs");
	bool there = set != STEP_NONE, any = true;

	*out = (struct ifc_map_operation){
		.eastings = number_find(file, set, "eastings", 0, &there),
		.northings = number_find(file, set, "northings", 0, &there),
		.height = number_find(file, set, "orthogonalheight", 0, &any),
		.abscissa = number_find(file, set, "xaxisabscissa", 1, &any),
		.ordinate = number_find(file, set, "xaxisordinate", 0, &any),
		.scale = number_find(file, set, "scale", 0, &any),
		.factors = {1, 1, 1},
		.unit = unit_find(file, crs),
		.system = property_find(file, crs, "name")};
	if (out->system.kind != STEP_STRING)
		out->system = property_find(file, set, "targetcrs");
	return there;
}
