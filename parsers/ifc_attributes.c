#include "ifc_attributes.h"

#include "ifc_features.h"
#include "ifc_unit_names.h"

enum { NAME = 2, TYPE_PROPERTY_SETS = 5 };

/* Direct attributes that are kept, under their own names; lengths or not. */
static const struct {
	const char *name;
	bool is_length;
} direct[] = {
	{"Description", false},
	{"ObjectType", false},
	{"LongName", false},
	{"Tag", false},
	{"PredefinedType", false},
	{"Elevation", true},
	{"RefElevation", true},
	{"OverallHeight", true},
	{"OverallWidth", true},
	{"OperationType", false},
	{"NumberOfRisers", false},
	{"NumberOfTreads", false},
	{"RiserHeight", true},
	{"TreadLength", true},
};

static enum tcs_status
direct_write(
	struct ifc_saying *saying, uint32_t instance, struct tcs_fault *fault)
{
	const struct ifc_model *model = saying->model;
	const struct ifc_file *file = &model->file;
	enum ifc_entity entity = ifc_entity_of(file, instance);
	uint32_t length = ifc_unit_of_type(
		file, model->unit_assignment, "LENGTHUNIT", 10);
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < sizeof direct / sizeof *direct && !status; i++) {
		int position =
			ifc_attribute(file->version, entity, direct[i].name);
		struct step_value value = ifc_value(file, instance, position);

		if (position != IFC_NO_POSITION)
			status = ifc_attribute_value(saying, TCS_NONE,
				direct[i].name, &value,
				direct[i].is_length ? length : STEP_NONE,
				fault);
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
		saying, TCS_NONE, "Type", &name, STEP_NONE, fault);
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
		saying, TCS_NONE, "Classification", &value, STEP_NONE, fault);
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
	uint32_t feature, struct tcs_object *out, struct tcs_fault *fault)
{
	struct ifc_saying saying = {model, out, feature, out->attributes.count};
	const struct ifc_said *type;
	enum tcs_status status;
	bool any, material;
	size_t count;

	status = direct_write(&saying, instance, fault);
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
