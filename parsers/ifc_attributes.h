/*
 * What a file says about an object, as attributes of its feature: direct
 * attributes, property sets and quantities, its own and those of its type,
 * materials, classifications.
 *
 * A set is an attribute with members. What the object says itself counts; its
 * type adds what it does not. Values keep their spelling, and measures the
 * file's units, named.
 *
 * source: ISO 16739-1 5.1.4, 8.7 (properties), 8.10 (materials).
 */
#ifndef TESSERA_IFC_ATTRIBUTES_H
#define TESSERA_IFC_ATTRIBUTES_H

#include "ifc_attribute_names.h"
#include "ifc_model.h"

enum { IFC_MOST_ATTRIBUTES = 20000 }; /* of one feature */

/*
 * Append the attributes of the instance, as those of `feature`. `names` is
 * scratch that one feature after the other may use. Fails with TCS_NO_MEMORY
 * or TCS_LIMIT.
 */
enum tcs_status ifc_attributes_write(const struct ifc_model *model,
	uint32_t instance, uint32_t feature, struct ifc_attribute_names *names,
	struct tcs_object *out, struct tcs_fault *fault) TCS_CHECKED;

/* ---- ifc_properties.c ---------------------------------------------------- */

/* Where attributes go. */
struct ifc_saying {
	const struct ifc_model *model;
	struct tcs_object *out;
	struct ifc_attribute_names *names; /* of the feature */
	uint32_t feature;
	size_t first; /* of the feature's attributes */
};

/*
 * Append a value under a name; nothing for a value that is unset. `unit` is
 * what its unit is called, NULL for that of its measure.
 */
enum tcs_status ifc_attribute_value(struct ifc_saying *saying, uint32_t parent,
	const char *name, const struct step_value *value, const char *unit,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append a property set or element quantity. Where the feature has a set of
 * the same name, its members are added that are not there yet.
 */
enum tcs_status ifc_properties_write(struct ifc_saying *saying, uint32_t set,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- ifc_materials.c ----------------------------------------------------- */

/* Append the names of a material, or of those of a list, layers and so on. */
enum tcs_status ifc_material_write(struct ifc_saying *saying, uint32_t material,
	struct tcs_fault *fault) TCS_CHECKED;

/* The first material that is painted; 0 for none. */
uint32_t ifc_material_paint(const struct ifc_model *model, uint32_t instance);

#endif
