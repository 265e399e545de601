#include "ifc_units.h"

#include <math.h>
#include <stddef.h>

/* A conversion by way of more units than these leads nowhere. */
enum { MOST_STEPS = 8 };

enum { UNIT_TYPE = 1, SI_PREFIX = 2, SI_NAME = 3, CONVERSION_FACTOR = 3 };

static bool
prefix_factor(const struct step_value *prefix, double *out)
{
	static const struct {
		const char *name;
		double factor;
	} all[] = {{"EXA", 1e18}, {"PETA", 1e15}, {"TERA", 1e12}, {"GIGA", 1e9},
		{"MEGA", 1e6}, {"KILO", 1e3}, {"HECTO", 1e2}, {"DECA", 1e1},
		{"DECI", 1e-1}, {"CENTI", 1e-2}, {"MILLI", 1e-3},
		{"MICRO", 1e-6}, {"NANO", 1e-9}, {"PICO", 1e-12},
		{"FEMTO", 1e-15}, {"ATTO", 1e-18}};

	*out = 1;
	if (prefix->kind == STEP_UNSET)
		return true;
	for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
		if (!step_is(prefix, all[i].name))
			continue;
		*out = all[i].factor;
		return true;
	}
	return false;
}

static bool
si_factor(const struct ifc_file *file, uint32_t unit, double *out)
{
	struct step_value prefix = ifc_value(file, unit, SI_PREFIX);
	struct step_value name = ifc_value(file, unit, SI_NAME);
	double factor;

	if (name.kind != STEP_ENUMERATION || !prefix_factor(&prefix, &factor))
		return false;
	if (step_is(&name, "SQUARE_METRE"))
		factor *= factor;
	else if (step_is(&name, "CUBIC_METRE"))
		factor *= factor * factor;
	else if (step_is(&name, "GRAM"))
		factor /= 1000;
	*out = factor;
	return true;
}

bool
ifc_unit_factor(const struct ifc_file *file, uint32_t unit, double *out)
{
	double factor = 1, own;

	for (int step = 0; step < MOST_STEPS; step++) {
		struct step_value value;
		uint32_t measure;

		if (ifc_entity_of(file, unit) == IFC_SIUNIT) {
			if (!si_factor(file, unit, &own))
				return false;
			*out = factor * own;
			return isfinite(*out) && *out > 0;
		}
		if (!ifc_is_kind(file, unit, IFC_CONVERSIONBASEDUNIT))
			return false;
		measure = ifc_target(file, unit, CONVERSION_FACTOR);
		if (ifc_entity_of(file, measure) != IFC_MEASUREWITHUNIT)
			return false;
		value = ifc_value(file, measure, 0);
		if (!step_number(&value, &own))
			return false;
		factor *= own;
		unit = ifc_target(file, measure, 1);
	}
	return false;
}

static uint32_t
project_find(const struct ifc_file *file)
{
	struct step_list projects = step_instances(
		file->step, step_names_find(&file->step->names, "IFCPROJECT"));

	return projects.count && ifc_entity_of(file, projects.at[0])
		? projects.at[0]
		: STEP_NONE;
}

/* Where the factor of a unit of the assignment belongs; NULL: nowhere. */
static double *
factor_place(struct ifc_units *units, const struct step_value *type)
{
	if (step_is(type, "LENGTHUNIT"))
		return &units->length;
	if (step_is(type, "AREAUNIT"))
		return &units->area;
	if (step_is(type, "VOLUMEUNIT"))
		return &units->volume;
	if (step_is(type, "PLANEANGLEUNIT"))
		return &units->angle;
	return NULL;
}

static enum tcs_status
assumed(struct report *report, const char *what, struct tcs_fault *fault)
{
	return report_item(
		report, REPORT_NOTE, "unit", what, NULL, TCS_NOWHERE, fault);
}

enum tcs_status
ifc_units_read(const struct ifc_file *file, struct ifc_units *out,
	struct report *report, struct tcs_fault *fault)
{
	uint32_t project = project_find(file);
	uint32_t assignment = ifc_target(file, project,
		ifc_attribute(file->version, IFC_PROJECT, "UnitsInContext"));
	struct step_value list = ifc_value(file, assignment, 0), item;
	enum tcs_status status = TCS_OK;

	*out = (struct ifc_units){.length = 0};
	while (list.kind == STEP_LIST &&
		step_next(&list.list, &item) > STEP_END) {
		uint32_t unit = step_target(file->step, &item);
		struct step_value type = ifc_value(file, unit, UNIT_TYPE);
		double *place = factor_place(out, &type), factor;

		if (place && *place == 0 &&
			ifc_unit_factor(file, unit, &factor))
			*place = factor;
	}
	if (out->length == 0) {
		out->length = 1;
		status = assumed(report, "lengths taken as metres", fault);
	}
	if (out->angle == 0) {
		out->angle = 1;
		if (!status)
			status = assumed(
				report, "angles taken as radians", fault);
	}
	if (out->area == 0)
		out->area = out->length * out->length;
	if (out->volume == 0)
		out->volume = out->length * out->length * out->length;
	return status;
}
