#include "ifc_attribute_names.h"

#include <string.h>

enum { FEW = 48 };

void
ifc_attribute_names_begin(
	struct ifc_attribute_names *names, const struct tcs_object *object)
{
	if (names->attributes.count)
		byte_index_clear(&names->index);
	array_clear(&names->attributes);
	names->first = names->seen = object->attributes.count;
}

void
ifc_attribute_names_release(struct ifc_attribute_names *names)
{
	byte_index_release(&names->index);
	array_release(&names->attributes);
	array_release(&names->key);
}

static uint32_t
look_through(const struct tcs_object *object, size_t first, uint32_t parent,
	tcs_text name)
{
	const char *wanted = object_text(object, name);

	for (size_t i = first; i < object->attributes.count; i++)
		if (object->attributes.at[i].parent == parent &&
			!strcmp(object_text(
					object, object->attributes.at[i].name),
				wanted))
			return (uint32_t)i;
	return TCS_NONE;
}

static enum tcs_status
key_make(struct ifc_attribute_names *names, const struct tcs_object *object,
	uint32_t parent, tcs_text name, struct tcs_fault *fault)
{
	const char *text = object_text(object, name);
	size_t length = strlen(text);

	array_clear(&names->key);
	if (array_grow(&names->key, sizeof parent + length))
		return fault_memory(fault);
	memcpy(names->key.at, &parent, sizeof parent);
	memcpy(names->key.at + sizeof parent, text, length);
	names->key.count = sizeof parent + length;
	return TCS_OK;
}

static enum tcs_status
attribute_index(struct ifc_attribute_names *names,
	const struct tcs_object *object, struct tcs_fault *fault)
{
	const struct tcs_attribute *attribute =
		object->attributes.at + names->seen;
	enum tcs_status status = key_make(
		names, object, attribute->parent, attribute->name, fault);
	uint32_t number;
	bool added = false;

	if (!status)
		status = byte_index_add(&names->index, names->key.at,
			names->key.count, &number, &added, fault);
	if (status || !added)
		return status;
	if (array_grow(&names->attributes, 1))
		return fault_memory(fault);
	names->attributes.at[names->attributes.count++] = (uint32_t)names->seen;
	return TCS_OK;
}

enum tcs_status
ifc_attribute_find(struct ifc_attribute_names *names,
	const struct tcs_object *object, uint32_t parent, tcs_text name,
	uint32_t *found, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint32_t number;

	if (object->attributes.count - names->first <= FEW) {
		*found = look_through(object, names->first, parent, name);
		return TCS_OK;
	}
	for (; !status && names->seen < object->attributes.count; names->seen++)
		status = attribute_index(names, object, fault);
	if (!status)
		status = key_make(names, object, parent, name, fault);
	if (status)
		return status;
	number =
		byte_index_find(&names->index, names->key.at, names->key.count);
	*found = number == INDEX_NONE ? TCS_NONE : names->attributes.at[number];
	return TCS_OK;
}
