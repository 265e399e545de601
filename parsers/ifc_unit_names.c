#include "ifc_unit_names.h"

#include <stdio.h>
#include <string.h>

enum { UNIT_TYPE = 1, SI_PREFIX = 2, SI_NAME = 3, CONVERSION_NAME = 2 };

struct symbol {
	const char *name, *symbol;
};

static const struct symbol prefixes[] = {{"EXA", "E"}, {"PETA", "P"},
	{"TERA", "T"}, {"GIGA", "G"}, {"MEGA", "M"}, {"KILO", "k"},
	{"HECTO", "h"}, {"DECA", "da"}, {"DECI", "d"}, {"CENTI", "c"},
	{"MILLI", "m"}, {"MICRO", "u"}, {"NANO", "n"}, {"PICO", "p"},
	{"FEMTO", "f"}, {"ATTO", "a"}};

static const struct symbol symbols[] = {{"METRE", "m"}, {"SQUARE_METRE", "m2"},
	{"CUBIC_METRE", "m3"}, {"GRAM", "g"}, {"SECOND", "s"},
	{"RADIAN", "rad"}, {"STERADIAN", "sr"}, {"KELVIN", "K"},
	{"DEGREE_CELSIUS", "Cel"}, {"AMPERE", "A"}, {"MOLE", "mol"},
	{"CANDELA", "cd"}, {"LUMEN", "lm"}, {"LUX", "lx"}, {"HERTZ", "Hz"},
	{"NEWTON", "N"}, {"PASCAL", "Pa"}, {"JOULE", "J"}, {"WATT", "W"},
	{"VOLT", "V"}, {"OHM", "Ohm"}, {"SIEMENS", "S"}, {"FARAD", "F"},
	{"HENRY", "H"}, {"TESLA", "T"}, {"WEBER", "Wb"}, {"COULOMB", "C"},
	{"BECQUEREL", "Bq"}, {"GRAY", "Gy"}, {"SIEVERT", "Sv"}};

static const char *
symbol_of(const struct symbol *all, size_t count, const struct step_value *name)
{
	for (size_t i = 0; i < count; i++)
		if (step_is(name, all[i].name))
			return all[i].symbol;
	return "";
}

#define SYMBOL(all, name) symbol_of((all), sizeof(all) / sizeof *(all), (name))

/* A unit that is not put together. */
static void
named_unit(const struct ifc_file *file, uint32_t unit, char out[IFC_UNIT_ROOM])
{
	struct step_value prefix = ifc_value(file, unit, SI_PREFIX);
	struct step_value name = ifc_value(file, unit, SI_NAME);
	size_t length = 0;

	*out = '\0';
	if (ifc_entity_of(file, unit) == IFC_SIUNIT) {
		snprintf(out, IFC_UNIT_ROOM, "%s%s", SYMBOL(prefixes, &prefix),
			SYMBOL(symbols, &name));
		return;
	}
	if (!ifc_is_kind(file, unit, IFC_CONVERSIONBASEDUNIT))
		return;
	name = ifc_value(file, unit, CONVERSION_NAME);
	for (size_t i = 0; name.kind == STEP_STRING && i < name.length &&
		length + 1 < IFC_UNIT_ROOM;
		i++) {
		char byte = name.text[i];

		if (byte >= 'A' && byte <= 'Z')
			byte = (char)(byte - 'A' + 'a');
		if (byte > ' ' && byte < 127 && byte != '\\')
			out[length++] = byte;
	}
	out[length] = '\0';
}

/* The elements with exponents of one sign, as "m2.K". */
static size_t
elements_print(const struct ifc_file *file, uint32_t unit, bool below,
	char out[IFC_UNIT_ROOM])
{
	struct step_value list = ifc_value(file, unit, 0), item;
	size_t count = 0, length = 0;

	*out = '\0';
	while (list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t element = step_target(file->step, &item);
		struct step_value power = ifc_value(file, element, 1);
		char name[IFC_UNIT_ROOM], exponent[24] = "";
		int64_t by;

		if (!step_integer(&power, &by) || (by < 0) != below || !by ||
			by > 99 || by < -99)
			continue;
		named_unit(file, ifc_target(file, element, 0), name);
		if (by * by != 1)
			snprintf(exponent, sizeof exponent, "%d",
				(int)(by < 0 ? -by : by));
		length += (size_t)snprintf(out + length, IFC_UNIT_ROOM - length,
			"%s%s%s", count ? "." : "", name, exponent);
		if (length >= IFC_UNIT_ROOM)
			length = IFC_UNIT_ROOM - 1;
		count++;
	}
	return count;
}

void
ifc_unit_name(
	const struct ifc_file *file, uint32_t unit, char out[IFC_UNIT_ROOM])
{
	char above[IFC_UNIT_ROOM], below[IFC_UNIT_ROOM];
	size_t under;
	int length;

	if (ifc_entity_of(file, unit) != IFC_DERIVEDUNIT) {
		named_unit(file, unit, out);
		return;
	}
	*out = '\0';
	if (!elements_print(file, unit, false, above))
		strcpy(above, "1");
	under = elements_print(file, unit, true, below);
	length = snprintf(out, IFC_UNIT_ROOM,
		under > 1	     ? "%s/(%s)"
			: under == 1 ? "%s/%s"
				     : "%s%s",
		above, below);
	if (length >= IFC_UNIT_ROOM)
		*out = '\0';
}

static enum tcs_status
unit_add(const struct ifc_file *file, uint32_t unit,
	struct ifc_project_units *out, struct tcs_fault *fault)
{
	struct step_value type = ifc_value(file, unit, UNIT_TYPE);
	struct ifc_project_unit *to;

	if (type.kind != STEP_ENUMERATION)
		return TCS_OK;
	if (array_grow(out, 1))
		return fault_memory(fault);
	to = out->at + out->count++;
	to->type = type.text;
	to->length = type.length;
	ifc_unit_name(file, unit, to->name);
	return TCS_OK;
}

enum tcs_status
ifc_project_units_read(const struct ifc_file *file,
	struct ifc_project_units *out, struct tcs_fault *fault)
{
	struct step_list projects = step_instances(
		file->step, step_names_find(&file->step->names, "IFCPROJECT"));
	enum tcs_status status = TCS_OK;
	struct step_value list, item;
	uint32_t assignment;

	if (!projects.count)
		return TCS_OK;
	assignment = ifc_target(file, projects.at[0],
		ifc_attribute(file->version, IFC_PROJECT, "UnitsInContext"));
	list = ifc_value(file, assignment, 0);
	while (!status && list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END)
		status = unit_add(
			file, step_target(file->step, &item), out, fault);
	return status;
}

/* The first unit whose type is `type` and then `tail`. */
static const char *
unit_find(const struct ifc_project_units *units, const char *type,
	size_t length, const char *tail)
{
	size_t behind = strlen(tail);

	for (size_t i = 0; i < units->count; i++) {
		const struct ifc_project_unit *unit = units->at + i;

		if (unit->length == length + behind &&
			!memcmp(unit->type, type, length) &&
			!memcmp(unit->type + length, tail, behind))
			return unit->name;
	}
	return "";
}

const char *
ifc_unit_of_type(const struct ifc_project_units *units, const char *type)
{
	return unit_find(units, type, strlen(type), "");
}

const char *
ifc_unit_of_measure(const struct ifc_project_units *units, const char *measure,
	size_t length)
{
	static const char *const before[] = {"IFC", "POSITIVE", "NONNEGATIVE"};
	static const char behind[] = "MEASURE";
	const size_t tail = sizeof behind - 1;

	for (size_t i = 0; i < sizeof before / sizeof *before; i++) {
		size_t head = strlen(before[i]);

		if (length > head && !memcmp(measure, before[i], head)) {
			measure += head;
			length -= head;
		}
	}
	if (length <= tail || memcmp(measure + length - tail, behind, tail))
		return "";
	return unit_find(units, measure, length - tail, "UNIT");
}
