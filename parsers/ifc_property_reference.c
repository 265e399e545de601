#include <string.h>

#include "ifc_attributes.h"

enum { MOST_NAMES = 7, NO_NAME = -1 };

/* Where an object has what it is called by: those that are said, joined, or
 * without a joint the first of them. */
static const struct {
	enum ifc_entity entity;
	int names[MOST_NAMES];
	int count;
	const char *joint;
} rows[] = {
	{IFC_EXTERNALREFERENCE, {2, 1, 0}, 3, NULL},
	{IFC_ORGANIZATION, {1, 0}, 2, NULL},
	{IFC_PERSON, {2, 1}, 2, " "},
	{IFC_POSTALADDRESS, {3, 4, 5, 6, 7, 8, 9}, 7, ", "},
	{IFC_MATERIALLAYERSET, {1}, 1, NULL},
};

enum tcs_status
ifc_string_join(struct step_text *text, const struct step_value *value,
	const char *joint, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	unsigned trouble = 0;

	if (value->kind != STEP_STRING || !value->length)
		return TCS_OK;
	if (text->count)
		status = step_decode(
			text, joint, strlen(joint), &trouble, fault);
	return status ? status
		      : step_decode(text, value->text, value->length, &trouble,
				fault);
}

/* Join a string, or those of a list. */
static enum tcs_status
value_join(struct step_text *text, struct step_value value, const char *joint,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	struct step_value item;

	if (value.kind != STEP_LIST)
		return ifc_string_join(text, &value, joint, fault);
	while (!status && step_next(&value.list, &item) > STEP_END)
		status = ifc_string_join(text, &item, joint, fault);
	return status;
}

/* By the table, or by the first value. */
static enum tcs_status
name_join(const struct ifc_file *file, uint32_t object, struct step_text *text,
	struct tcs_fault *fault)
{
	size_t row = 0, count = sizeof rows / sizeof *rows,
	       before = text->count;
	enum tcs_status status = TCS_OK;

	while (row < count && !ifc_is_kind(file, object, rows[row].entity))
		row++;
	if (row == count)
		return value_join(
			text, ifc_value(file, object, 0), ", ", fault);
	for (int i = 0; i < rows[row].count && !status; i++) {
		const char *joint = rows[row].joint;

		if (text->count == before)
			joint = ", ";
		else if (!joint)
			break;
		status = value_join(text,
			ifc_value(file, object, rows[row].names[i]), joint,
			fault);
	}
	return status;
}

enum tcs_status
ifc_reference_text(const struct ifc_file *file, uint32_t object,
	struct step_text *text, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	unsigned trouble = 0;

	if (ifc_entity_of(file, object) == IFC_PERSONANDORGANIZATION)
		for (int i = 0; i < 2 && !status; i++)
			status = name_join(
				file, ifc_target(file, object, i), text, fault);
	else if (object != STEP_NONE)
		status = name_join(file, object, text, fault);
	if (!status && !text->count && object != STEP_NONE)
		status = step_decode(text, step_name_text(file->step, object),
			strlen(step_name_text(file->step, object)), &trouble,
			fault);
	return status;
}
