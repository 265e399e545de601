/*
 * Mapped items that are used more than once, as prototypes of the stream, and
 * the products that are nothing but such items, as instances of them.
 *
 * A prototype is a representation map with the paint that its faces have where
 * no style paints them, for the same shape in two materials is two. It is in
 * metres. What openings cut, what is mirrored, or has a style of its own on the
 * mapped item, is no instance: it is baked.
 */
#ifndef TESSERA_IFC_PROTOTYPES_H
#define TESSERA_IFC_PROTOTYPES_H

#include "ifc_model.h"

struct ifc_prototype {
	uint32_t map; /* the IfcRepresentationMap */
	uint32_t paint; /* of faces that no style paints; 0: none */
	uint32_t item; /* a mapped item that uses it */
	uint32_t number; /* in the stream; TCS_NONE: not there */
};

/* By map, then paint. All zero is empty. */
TCS_ARRAY_TYPE(ifc_prototypes, struct ifc_prototype);

/*
 * List those that two or more items of the model's members use. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status ifc_prototypes_list(const struct ifc_model *model,
	struct ifc_prototypes *out, struct tcs_fault *fault) TCS_CHECKED;

/* The prototype of a mapped item under a paint; NULL when there is none. */
const struct ifc_prototype *ifc_prototype_find(const struct ifc_model *model,
	const struct ifc_prototypes *prototypes, uint32_t item, uint32_t paint);

/*
 * Whether a member's body consists of mapped items only, which nothing cuts
 * and no style of their own paints.
 */
bool ifc_is_instance(const struct ifc_model *model, uint32_t node);

#endif
