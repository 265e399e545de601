#include "ifc_attributes.h"
#include "ifc_features.h"

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

enum { MOST_STEPS = 4, LAYER_THICKNESS = 1 };

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

/* A part's material: its name, and the thickness where it is a layer. */
static enum tcs_status
part_write(struct ifc_saying *saying, uint32_t part, struct tcs_fault *fault)
{
	const struct ifc_model *model = saying->model;
	struct step_value parts, name, thickness;
	uint32_t material = material_below(&model->file, part, &parts);
	enum tcs_status status;

	if (material == STEP_NONE)
		return TCS_OK;
	name = ifc_value(&model->file, material, 0);
	status = ifc_attribute_value(
		saying, TCS_NONE, "Material", &name, NULL, fault);
	if (status || !ifc_is_kind(&model->file, part, IFC_MATERIALLAYER))
		return status;
	thickness = ifc_value(&model->file, part, LAYER_THICKNESS);
	return ifc_attribute_value(saying, TCS_NONE, "LayerThickness",
		&thickness,
		ifc_unit_of_type(&model->project_units, "LENGTHUNIT"), fault);
}

enum tcs_status
ifc_material_write(
	struct ifc_saying *saying, uint32_t material, struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	struct step_value parts, part;
	enum tcs_status status = TCS_OK;

	if (material_below(file, material, &parts) != STEP_NONE)
		return part_write(saying, material, fault);
	while (!status && parts.kind == STEP_LIST &&
		step_next(&parts.list, &part) > STEP_END)
		status = part_write(
			saying, step_target(file->step, &part), fault);
	return status;
}

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
