/*
 * Instances on their way from ifcXML to STEP text: those that are open, one
 * within another, and what is known of their attributes. Internal to ifcxml.h.
 */
#ifndef TESSERA_IFCXML_WRITE_H
#define TESSERA_IFCXML_WRITE_H

#include "ifc_schema.h"
#include "step_load.h"

/* Instead of a defined type: a list within a list, "Seq-…-wrapper". */
#define IFCXML_SEQUENCE "SEQ"

/* An attribute as parameter: a run of the instance's text. */
struct ifcxml_slot {
	size_t at, end;
	uint32_t values;
	unsigned row; /* of a list of lists: values in each; else 0 */
	bool list;
};

/* All zero is empty; reused. */
struct ifcxml_instance {
	enum ifc_entity entity; /* IFC_NONE: unknown, and not written */
	uint32_t number;
	TCS_ARRAY(struct ifcxml_slot) slots;
	struct step_bytes text;
};

void ifcxml_instance_release(struct ifcxml_instance *instance);

/* Make it one of `entity`, without values. Fails with TCS_NO_MEMORY. */
enum tcs_status ifcxml_instance_begin(struct ifcxml_instance *instance,
	enum ifc_version version, enum ifc_entity entity, uint32_t number,
	struct tcs_fault *fault) TCS_CHECKED;

/* Begin an attribute, forgetting what it had. */
struct ifcxml_slot *ifcxml_slot_begin(
	struct ifcxml_instance *instance, int position, const char *attribute);

/*
 * Append to the attribute that was begun last: a link; a value as it is
 * spelled in XML; or one within the name of its defined type, "IFCLABEL", "" for none. All
 * fail with TCS_NO_MEMORY.
 */
enum tcs_status ifcxml_put_link(struct ifcxml_instance *instance, int position,
	uint32_t number, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status ifcxml_put_text(struct ifcxml_instance *instance, int position,
	const char *attribute, const char *text, size_t length,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status ifcxml_put_typed(struct ifcxml_instance *instance, int position,
	const char *type, const char *text, size_t length,
	struct tcs_fault *fault) TCS_CHECKED;

/* Append the instance as a statement. Fails with TCS_NO_MEMORY. */
enum tcs_status ifcxml_instance_write(const struct ifcxml_instance *instance,
	struct step_bytes *out, struct tcs_fault *fault) TCS_CHECKED;

/* Append bytes as they are. Fails with TCS_NO_MEMORY. */
enum tcs_status ifcxml_put(struct step_bytes *out, const char *bytes,
	size_t length, struct tcs_fault *fault) TCS_CHECKED;

#endif
