#include <string.h>

#include "ifc_attributes.h"
#include "number.h"

enum { NOWHERE = -1 };

/* Where a definition keeps its list of parts, and a part its material. */
static const struct {
	enum ifc_entity entity;
	int parts; /* a list of materials, or of what has one */
	int material; /* the next definition below */
} definitions[] = {
	{IFC_MATERIALLAYERSETUSAGE, NOWHERE, 0},
	{IFC_MATERIALPROFILESETUSAGE, NOWHERE, 0},
	{IFC_MATERIALLAYERSET, 0, NOWHERE},
	{IFC_MATERIALPROFILESET, 2, NOWHERE},
	{IFC_MATERIALCONSTITUENTSET, 2, NOWHERE},
	{IFC_MATERIALLIST, 0, NOWHERE},
	{IFC_MATERIALLAYER, NOWHERE, 0},
	{IFC_MATERIALPROFILE, NOWHERE, 2},
	{IFC_MATERIALCONSTITUENT, NOWHERE, 2},
};

enum { MOST_STEPS = 4 };

/* A definition with the usages taken off: a material, or one with parts. */
static uint32_t
material_below(const struct ifc_file *file, uint32_t instance,
	struct step_value *parts)
{
	*parts = (struct step_value){.kind = STEP_END};
	for (int step = 0; step < MOST_STEPS; step++) {
		size_t i = 0, count = sizeof definitions / sizeof *definitions;

		if (ifc_entity_of(file, instance) == IFC_MATERIAL)
			return instance;
		while (i < count &&
			!ifc_is_kind(file, instance, definitions[i].entity))
			i++;
		if (i == count)
			return STEP_NONE;
		if (definitions[i].parts != NOWHERE) {
			*parts =
				ifc_value(file, instance, definitions[i].parts);
			return STEP_NONE;
		}
		instance = ifc_target(file, instance, definitions[i].material);
	}
	return STEP_NONE;
}

/* ---- told ---------------------------------------------------------------- */

/* What is told of a definition beside its material. */
static const struct {
	enum ifc_entity entity;
	const char *name;
	int at;
	bool is_length;
} facts[] = {
	{IFC_MATERIALLAYERSETUSAGE, "Direction", 1, false},
	{IFC_MATERIALLAYERSETUSAGE, "Sense", 2, false},
	{IFC_MATERIALLAYERSETUSAGE, "Offset", 3, true},
	{IFC_MATERIALPROFILESETUSAGE, "CardinalPoint", 1, false},
	{IFC_MATERIALLAYERSET, "Name", 1, false},
	{IFC_MATERIALPROFILESET, "Name", 0, false},
	{IFC_MATERIALCONSTITUENTSET, "Name", 0, false},
	{IFC_MATERIALLAYER, "Thickness", 1, true},
	{IFC_MATERIALLAYER, "Ventilated", 2, false},
	{IFC_MATERIALLAYER, "Name", 3, false},
	{IFC_MATERIALLAYER, "Category", 5, false},
	{IFC_MATERIALLAYER, "Priority", 6, false},
	{IFC_MATERIALPROFILE, "Name", 0, false},
	{IFC_MATERIALPROFILE, "Priority", 4, false},
	{IFC_MATERIALPROFILE, "Category", 5, false},
	{IFC_MATERIALCONSTITUENT, "Name", 0, false},
	{IFC_MATERIALCONSTITUENT, "Fraction", 3, false},
	{IFC_MATERIALCONSTITUENT, "Category", 4, false},
};

static enum tcs_status
facts_write(struct ifc_saying *saying, uint32_t set, uint32_t definition,
	struct tcs_fault *fault)
{
	const struct ifc_model *model = saying->model;
	const char *length =
		ifc_unit_of_type(&model->project_units, "LENGTHUNIT");
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < sizeof facts / sizeof *facts && !status; i++) {
		struct step_value value;

		if (!ifc_is_kind(&model->file, definition, facts[i].entity))
			continue;
		value = ifc_value(&model->file, definition, facts[i].at);
		status = ifc_attribute_value(saying, set, facts[i].name, &value,
			facts[i].is_length ? length : NULL, fault);
	}
	return status;
}

/* Append the name of a part's material to those before it. */
static enum tcs_status
name_join(const struct ifc_file *file, uint32_t part, struct step_text *names,
	struct tcs_fault *fault)
{
	struct step_value parts,
		name = ifc_value(file, material_below(file, part, &parts), 0);

	return ifc_string_join(names, &name, ", ", fault);
}

/* The names of all materials, as one attribute. */
static enum tcs_status
names_write(struct ifc_saying *saying, uint32_t definition,
	struct step_value parts, struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	struct step_text names = {.count = 0};
	enum tcs_status status = TCS_OK;
	struct step_value part;

	if (parts.kind != STEP_LIST)
		status = name_join(file, definition, &names, fault);
	while (!status && parts.kind == STEP_LIST &&
		step_next(&parts.list, &part) > STEP_END)
		status = name_join(
			file, step_target(file->step, &part), &names, fault);
	if (!status && names.count)
		status = ifc_attribute_string(saying, TCS_NONE, "Material",
			names.at, names.count, fault);
	array_release(&names);
	return status;
}

/* One part under its number, from 1. */
static enum tcs_status
part_write(struct ifc_saying *saying, uint32_t above, uint32_t part,
	size_t number, struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	struct step_value parts,
		name = ifc_value(file, material_below(file, part, &parts), 0);
	char text[NUMBER_LENGTH];
	enum tcs_status status;
	uint32_t set;

	text[number_print(text, (double)number)] = '\0';
	status = ifc_attribute_set(saying, above, text, &set, fault);
	if (!status)
		status = ifc_attribute_value(
			saying, set, "Material", &name, NULL, fault);
	return status ? status : facts_write(saying, set, part, fault);
}

/* The set of the parts; NULL where their materials are all there is to tell. */
static const char *
set_name(const struct ifc_file *file, uint32_t part)
{
	if (ifc_is_kind(file, part, IFC_MATERIALLAYER))
		return "MaterialLayers";
	if (ifc_is_kind(file, part, IFC_MATERIALPROFILE))
		return "MaterialProfiles";
	if (ifc_is_kind(file, part, IFC_MATERIALCONSTITUENT))
		return "MaterialConstituents";
	return NULL;
}

/* What tells of the usage and of the whole, then the parts in their order. */
static enum tcs_status
parts_write(struct ifc_saying *saying, uint32_t definition,
	struct step_value parts, struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	enum tcs_status status = TCS_OK;
	uint32_t set = TCS_NONE;
	struct step_value part;

	for (size_t number = 1; !status && parts.kind == STEP_LIST &&
		step_next(&parts.list, &part) > STEP_END &&
		saying->out->attributes.count - saying->first <
			IFC_MOST_ATTRIBUTES;
		number++) {
		uint32_t at = step_target(file->step, &part);
		const char *name = set_name(file, at);

		if (!name)
			continue;
		if (set == TCS_NONE) {
			status = ifc_attribute_set(
				saying, TCS_NONE, name, &set, fault);
			if (!status)
				status = facts_write(
					saying, set, definition, fault);
			if (!status)
				status = facts_write(saying, set,
					ifc_target(file, definition, 0), fault);
		}
		if (!status)
			status = part_write(saying, set, at, number, fault);
	}
	return status;
}

enum tcs_status
ifc_material_write(
	struct ifc_saying *saying, uint32_t material, struct tcs_fault *fault)
{
	struct step_value parts;
	enum tcs_status status;

	material_below(&saying->model->file, material, &parts);
	status = names_write(saying, material, parts, fault);
	return status ? status : parts_write(saying, material, parts, fault);
}

/* ---- painted ------------------------------------------------------------- */

/* The paint of a material, or of the first part that has one. */
static uint32_t
definition_paint(const struct ifc_model *model, uint32_t definition)
{
	struct step_value parts, part;
	uint32_t material = material_below(&model->file, definition, &parts);
	uint32_t paint = ifc_style_paint(&model->styles, material);

	while (!paint && parts.kind == STEP_LIST &&
		step_next(&parts.list, &part) > STEP_END) {
		struct step_value none;

		paint = ifc_style_paint(&model->styles,
			material_below(&model->file,
				step_target(model->file.step, &part), &none));
	}
	return paint;
}

uint32_t
ifc_material_paint(const struct ifc_model *model, uint32_t instance)
{
	const struct ifc_said *said;
	uint32_t paint = 0;
	size_t count;

	said = ifc_links_find(
		&model->links, instance, IFC_SAYS_MATERIAL, &count);
	for (size_t i = 0; i < count && !paint; i++)
		paint = definition_paint(model, said[i].target);
	said = ifc_links_find(&model->links, instance, IFC_SAYS_TYPE, &count);
	if (paint || !count)
		return paint;
	said = ifc_links_find(
		&model->links, said->target, IFC_SAYS_MATERIAL, &count);
	for (size_t i = 0; i < count && !paint; i++)
		paint = definition_paint(model, said[i].target);
	return paint;
}
