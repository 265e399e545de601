/*
 * Which attributes of one feature are there, by parent and name: looked
 * through while they are few, indexed once they are many.
 */
#ifndef TESSERA_IFC_ATTRIBUTE_NAMES_H
#define TESSERA_IFC_ATTRIBUTE_NAMES_H

#include "byte_index.h"
#include "tcs.h"

/* All zero is that of no feature. */
struct ifc_attribute_names {
	struct byte_index index; /* parents and names */
	TCS_ARRAY(uint32_t) attributes; /* the first, by number in the index */
	TCS_ARRAY(char) key;
	size_t first, seen; /* of the feature's attributes; those indexed end */
};

/* Go on to the feature whose attributes are the next that are appended. */
void ifc_attribute_names_begin(
	struct ifc_attribute_names *names, const struct tcs_object *object);

void ifc_attribute_names_release(struct ifc_attribute_names *names);

/*
 * The first attribute of the feature with a name and a parent, which may be
 * TCS_NONE; TCS_NONE where there is none. Fails with TCS_NO_MEMORY.
 */
enum tcs_status ifc_attribute_find(struct ifc_attribute_names *names,
	const struct tcs_object *object, uint32_t parent, tcs_text name,
	uint32_t *found, struct tcs_fault *fault) TCS_CHECKED;

#endif
