#include "ifc_attributes.h"

#include "ifc_features.h"

enum { NAME = 2, TYPE_PROPERTY_SETS = 5 };

static enum tcs_status
direct_write(
	struct ifc_saying *saying, uint32_t instance, struct tcs_fault *fault)
{
	const struct ifc_model *model = saying->model;
	const struct step_file *file = &model->step;
	const struct ifc_direct_places *places =
		model->direct + step_name_of(file, instance);
	const char *length =
		ifc_unit_of_type(&model->project_units, "LENGTHUNIT");
	struct step_value values[IFC_DIRECT_REACH];
	struct step_cursor cursor = step_parameters(file, instance);
	size_t count = step_fetch(&cursor, values, IFC_DIRECT_REACH);
	enum tcs_status status = TCS_OK;

	for (int i = 0; i < IFC_DIRECT_ROWS && !status; i++) {
		const struct ifc_direct_row *row = ifc_direct_rows + i;
		int at = places->at[i];

		if (at >= 0 && (size_t)at < count)
			status = ifc_attribute_value(saying, TCS_NONE,
				row->name, values + at,
				row->is_length ? length : NULL, fault);
	}
	return status;
}

/* Its name, property sets and materials; what is said already stays. */
static enum tcs_status
type_write(struct ifc_saying *saying, uint32_t type, bool material,
	struct tcs_fault *fault)
{
	const struct ifc_model *model = saying->model;
	struct step_value name = ifc_value(&model->file, type, NAME);
	struct step_value sets =
		ifc_value(&model->file, type, TYPE_PROPERTY_SETS);
	const struct ifc_said *said;
	enum tcs_status status;
	struct step_value set;
	size_t count;

	if (!ifc_is_kind(&model->file, type, IFC_TYPEOBJECT))
		return TCS_OK;
	status = ifc_attribute_value(
		saying, TCS_NONE, "Type", &name, NULL, fault);
	while (!status && sets.kind == STEP_LIST &&
		step_next(&sets.list, &set) > STEP_END)
		status = ifc_properties_write(
			saying, step_target(model->file.step, &set), fault);
	if (!material)
		return status;
	said = ifc_links_find(&model->links, type, IFC_SAYS_MATERIAL, &count);
	for (size_t i = 0; i < count && !status; i++)
		status = ifc_material_write(saying, said[i].target, fault);
	return status;
}

/* The code of a classification, of the system it belongs to. */
static enum tcs_status
class_write(
	struct ifc_saying *saying, uint32_t reference, struct tcs_fault *fault)
{
	const struct ifc_file *file = &saying->model->file;
	struct tcs_object *out = saying->out;
	struct step_value value = ifc_value(file, reference, 1);
	struct step_value system = ifc_value(file,
		ifc_target(file, reference, 3),
		ifc_attribute(file->version, IFC_CLASSIFICATION, "Name"));
	size_t before = out->attributes.count;
	enum tcs_status status;

	if (ifc_entity_of(file, reference) != IFC_CLASSIFICATIONREFERENCE)
		return TCS_OK;
	status = ifc_attribute_value(
		saying, TCS_NONE, "Classification", &value, NULL, fault);
	if (status || out->attributes.count == before)
		return status;
	out->attributes.at[before].type = TCS_CODE;
	return ifc_text_add(
		out, &system, &out->attributes.at[before].code_space, fault);
}

/* Whatever relations link to the instance. */
static enum tcs_status
said_write(struct ifc_saying *saying, uint32_t instance,
	enum ifc_link_kind kind,
	enum tcs_status (*write)(
		struct ifc_saying *, uint32_t, struct tcs_fault *),
	bool *any, struct tcs_fault *fault)
{
	size_t count;
	const struct ifc_said *said =
		ifc_links_find(&saying->model->links, instance, kind, &count);
	enum tcs_status status = TCS_OK;

	*any = count > 0;
	for (size_t i = 0; i < count && !status; i++)
		status = write(saying, said[i].target, fault);
	return status;
}

enum tcs_status
ifc_attributes_write(const struct ifc_model *model, uint32_t instance,
	uint32_t feature, struct ifc_attribute_names *names,
	struct tcs_object *out, struct tcs_fault *fault)
{
	struct ifc_saying saying = {
		model, out, names, feature, out->attributes.count};
	const struct ifc_said *type;
	enum tcs_status status;
	bool any, material;
	size_t count;

	ifc_attribute_names_begin(names, out);
	status = direct_write(&saying, instance, fault);
	if (!status)
		status = ifc_whereabouts_write(&saying, instance, fault);
	if (!status)
		status = said_write(&saying, instance, IFC_SAYS_MATERIAL,
			ifc_material_write, &material, fault);
	if (!status)
		status = said_write(&saying, instance, IFC_SAYS_CLASS,
			class_write, &any, fault);
	if (!status)
		status = said_write(&saying, instance, IFC_SAYS_PROPERTIES,
			ifc_properties_write, &any, fault);
	type = ifc_links_find(&model->links, instance, IFC_SAYS_TYPE, &count);
	if (!status && count)
		status = type_write(&saying, type->target, !material, fault);
	return status;
}
