/*
 * A STEP file as IFC: the schema's version, and the entity of each instance.
 *
 * The layer above a STEP index (step_file.h) and the table of the schemas
 * (ifc_schema.h), and below everything that knows what an entity means: units,
 * placements, the tree of objects, shapes. All of it works on instance numbers
 * and asks for parameters when it needs them; nothing here is changed after
 * ifc_open, so threads may share it.
 */
#ifndef TESSERA_IFC_FILE_H
#define TESSERA_IFC_FILE_H

#include "ifc_schema.h"
#include "step_file.h"

struct ifc_file {
	const struct step_file *step; /* borrowed */
	enum ifc_version version;
	uint16_t *entities; /* by the number of the instance's name */
	uint16_t supers[IFC_ENTITIES]; /* of each in this version */
};

TCS_ARRAY_TYPE(ifc_instances, uint32_t);

/*
 * Fails with TCS_BAD_INPUT when FILE_SCHEMA names no version of IFC, with
 * TCS_NO_MEMORY.
 */
enum tcs_status ifc_open(struct ifc_file *file, const struct step_file *step,
	struct tcs_fault *fault) TCS_CHECKED;

void ifc_close(struct ifc_file *file);

/* IFC_NONE for STEP_NONE, complex instances, and entities not in the table. */
static inline enum ifc_entity
ifc_entity_of(const struct ifc_file *file, uint32_t instance)
{
	if (instance == STEP_NONE)
		return IFC_NONE;
	return (enum ifc_entity)
		file->entities[step_name_of(file->step, instance)];
}

/* Whether the instance is one of `kind` or of a subtype. */
bool ifc_is_kind(
	const struct ifc_file *file, uint32_t instance, enum ifc_entity kind);

/*
 * The parameter at a position, from 0. Its kind is STEP_END or STEP_BAD when
 * there is none.
 */
struct step_value ifc_value(
	const struct ifc_file *file, uint32_t instance, int position);

/* The instance that the parameter at a position refers to; STEP_NONE. */
uint32_t ifc_target(
	const struct ifc_file *file, uint32_t instance, int position);

/*
 * Append all instances of `kind` and its subtypes to `out`, in the order of
 * the file. Fails with TCS_NO_MEMORY.
 */
enum tcs_status ifc_collect(const struct ifc_file *file, enum ifc_entity kind,
	struct ifc_instances *out, struct tcs_fault *fault) TCS_CHECKED;

#define IFC_ID_LENGTH 24 /* "#" and an id of 64 bits, terminated */

/* "#12": an instance's name in reports. */
void ifc_id(const struct ifc_file *file, uint32_t instance,
	char out[IFC_ID_LENGTH]);

#endif
