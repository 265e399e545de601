#include "ifc_features.h"

#include <string.h>

#include "ifc_attributes.h"
#include "ifc_class.h"
#include "ifc_spelling.h"
#include "step_string.h"

enum { NAME = 2 };

enum tcs_status
ifc_text_add(struct tcs_object *out, const struct step_value *value,
	tcs_text *text, struct tcs_fault *fault)
{
	struct step_text decoded = {.count = 0};
	enum tcs_status status;
	unsigned trouble = 0;

	*text = 0;
	if (value->kind != STEP_STRING || !value->length)
		return TCS_OK;
	if (step_is_plain(value->text, value->length))
		return text_append(
			out, value->text, value->length, text, fault);
	status = step_decode(
		&decoded, value->text, value->length, &trouble, fault);
	if (!status && decoded.count)
		status = text_append(
			out, decoded.at, decoded.count, text, fault);
	array_release(&decoded);
	return status;
}

/* A slab's landing belongs to its stair. */
static enum tcs_class
class_within(
	const struct ifc_model *model, uint32_t instance, enum tcs_class object)
{
	const struct ifc_file *file = &model->file;
	enum ifc_entity entity = ifc_entity_of(file, instance);
	struct step_value type;

	if (ifc_is_kind(file, instance, IFC_SLAB)) {
		type = ifc_value(file, instance,
			ifc_attribute(file->version, entity, "PredefinedType"));
		if (step_is(&type, "LANDING"))
			entity = IFC_STAIRFLIGHT;
	}
	return ifc_class_within(file, entity, object);
}

/* The class that the object as a whole has. */
static enum tcs_class
class_alone(const struct ifc_model *model, const struct ifc_member *root)
{
	return ifc_class_alone(&model->file,
		ifc_entity_of(
			&model->file, model->tree.at[root->node].instance));
}

static enum tcs_status
feature_add(const struct ifc_model *model, const struct ifc_member *member,
	enum tcs_class object, struct tcs_object *out, struct tcs_fault *fault)
{
	const struct ifc_file *file = &model->file;
	uint32_t instance = model->tree.at[member->node].instance;
	const char *type = ifc_spelled(ifc_entity_of(file, instance));
	struct step_value name = ifc_value(file, instance, NAME);
	struct tcs_feature feature = {.parent = member->parent};
	char id[IFC_GLOBAL_ID_ROOM];
	enum tcs_status status;

	feature.class = (uint16_t)(member->parent == STEP_NONE
			? object
			: class_within(model, instance, object));
	ifc_global_id(file, instance, id);
	status = text_append(out, id, strlen(id), &feature.id, fault);
	if (!status)
		status = text_append(
			out, type, strlen(type), &feature.type, fault);
	if (!status)
		status = ifc_text_add(out, &name, &feature.name, fault);
	if (!status && array_grow(&out->features, 1))
		return fault_memory(fault);
	if (!status)
		out->features.at[out->features.count++] = feature;
	return status;
}

/* A door or window fills the opening of its host. */
static enum tcs_status
filling_add(const struct ifc_model *model, const struct ifc_member *member,
	uint32_t feature, struct tcs_object *out, struct tcs_fault *fault)
{
	uint32_t opening = model->tree.at[member->node].fills, host;
	struct tcs_relation relation = {.feature = feature};
	char id[IFC_GLOBAL_ID_ROOM];
	enum tcs_status status;

	if (opening == STEP_NONE)
		return TCS_OK;
	host = model->tree.at[opening].parent;
	if (host == STEP_NONE)
		return TCS_OK;
	ifc_global_id(&model->file, model->tree.at[host].instance, id);
	status = text_append(out, id, strlen(id), &relation.target, fault);
	if (!status)
		status = text_append(out, "fills", 5, &relation.role, fault);
	if (!status && array_grow(&out->relations, 1))
		return fault_memory(fault);
	if (!status)
		out->relations.at[out->relations.count++] = relation;
	return status;
}

enum tcs_status
ifc_features_write(const struct ifc_model *model,
	const struct ifc_object *object, uint32_t first, uint32_t count,
	struct tcs_object *out, struct tcs_fault *fault)
{
	const struct ifc_member *members =
		model->objects.members.at + object->first_member;
	enum tcs_class class = class_alone(model, members);
	struct ifc_attribute_names names = {.first = 0};
	enum tcs_status status = TCS_OK;

	for (uint32_t i = first; i < first + count && !status; i++) {
		status = feature_add(model, members + i, class, out, fault);
		if (!status)
			status = ifc_attributes_write(model,
				model->tree.at[members[i].node].instance, i,
				&names, out, fault);
		if (!status)
			status = filling_add(model, members + i, i, out, fault);
	}
	ifc_attribute_names_release(&names);
	return status;
}
