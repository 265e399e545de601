#include "ifc_file.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_SCHEMA = 32 };

/* The first name of FILE_SCHEMA that is one of IFC's. */
static bool
version_find(const struct step_file *step, enum ifc_version *out)
{
	struct step_cursor cursor = step_header_parameters(step, STEP_SCHEMA);
	struct step_value list, name;

	if (step_next(&cursor, &list) != STEP_LIST)
		return false;
	while (step_next(&list.list, &name) == STEP_STRING) {
		char schema[LONGEST_SCHEMA] = "";

		for (size_t i = 0; i < name.length && i + 1 < sizeof schema;
			i++) {
			char byte = name.text[i];

			if (byte >= 'a' && byte <= 'z')
				byte = (char)(byte - 'a' + 'A');
			schema[i] = byte;
		}
		if (ifc_version_of(schema, out))
			return true;
	}
	return false;
}

enum tcs_status
ifc_open(struct ifc_file *file, const struct step_file *step,
	struct tcs_fault *fault)
{
	size_t names = step->names.list.count;

	file->step = step;
	if (!version_find(step, &file->version))
		return fault_set(fault, TCS_BAD_INPUT,
			step->header[STEP_SCHEMA],
			"not an IFC file: FILE_SCHEMA names no version of it");
	file->entities = calloc(names + 1, sizeof *file->entities);
	if (!file->entities)
		return fault_memory(fault);
	for (size_t i = 0; i < names; i++)
		file->entities[i] =
			(uint16_t)ifc_find(step->names.list.at[i].text);
	for (int i = 0; i < IFC_ENTITIES; i++)
		file->supers[i] =
			(uint16_t)ifc_super(file->version, (enum ifc_entity)i);
	return TCS_OK;
}

void
ifc_close(struct ifc_file *file)
{
	free(file->entities);
	*file = (struct ifc_file){.step = NULL};
}

bool
ifc_is_kind(
	const struct ifc_file *file, uint32_t instance, enum ifc_entity kind)
{
	enum ifc_entity entity = ifc_entity_of(file, instance);

	while (entity != kind && entity != IFC_NONE)
		entity = (enum ifc_entity)file->supers[entity];
	return entity == kind;
}

struct step_value
ifc_value(const struct ifc_file *file, uint32_t instance, int position)
{
	struct step_value value = {.kind = STEP_END};
	struct step_cursor cursor;

	if (instance == STEP_NONE || position < 0)
		return value;
	cursor = step_parameters(file->step, instance);
	do {
		if (step_next(&cursor, &value) <= STEP_END)
			break;
	} while (position-- > 0);
	return value;
}

uint32_t
ifc_target(const struct ifc_file *file, uint32_t instance, int position)
{
	struct step_value value = ifc_value(file, instance, position);

	return step_target(file->step, &value);
}

static int
instance_order(const void *left, const void *right)
{
	uint32_t a = *(const uint32_t *)left, b = *(const uint32_t *)right;

	return a < b ? -1 : a > b;
}

enum tcs_status
ifc_collect(const struct ifc_file *file, enum ifc_entity kind,
	struct ifc_instances *out, struct tcs_fault *fault)
{
	size_t before = out->count;

	for (size_t i = 0; i < file->step->names.list.count; i++) {
		struct step_list list = step_instances(file->step, (uint16_t)i);

		if (!list.count ||
			!ifc_is(file->version,
				(enum ifc_entity)file->entities[i], kind))
			continue;
		if (array_grow(out, list.count))
			return fault_memory(fault);
		memcpy(out->at + out->count, list.at,
			list.count * sizeof *list.at);
		out->count += list.count;
	}
	if (out->count > before)
		qsort(out->at + before, out->count - before, sizeof *out->at,
			instance_order);
	return TCS_OK;
}

void
ifc_id(const struct ifc_file *file, uint32_t instance, char out[IFC_ID_LENGTH])
{
	snprintf(out, IFC_ID_LENGTH, "#%" PRIu64,
		file->step->instances.at[instance].id);
}
