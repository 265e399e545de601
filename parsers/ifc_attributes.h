/*
 * What a file says about an object, as attributes of its feature: direct
 * attributes, property sets and quantities, its own and those of its type,
 * materials, classifications, addresses.
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
#include "step_string.h"

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

/* Append a string, UTF-8 already. */
enum tcs_status ifc_attribute_string(struct ifc_saying *saying, uint32_t parent,
	const char *name, const char *text, size_t length,
	struct tcs_fault *fault) TCS_CHECKED;

/* Append a set without members; its number in *set. */
enum tcs_status ifc_attribute_set(struct ifc_saying *saying, uint32_t parent,
	const char *name, uint32_t *set, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append a property set or element quantity. Where the feature has a set of
 * the same name, its members are added that are not there yet.
 */
enum tcs_status ifc_properties_write(struct ifc_saying *saying, uint32_t set,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- ifc_property_reference.c -------------------------------------------- */

/*
 * Append a string to a text, decoded, behind the joint where there is some
 * text; nothing for another value. Fails with TCS_NO_MEMORY.
 */
enum tcs_status ifc_string_join(struct step_text *text,
	const struct step_value *value, const char *joint,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append to a text what an object that a property refers to is called: a
 * person, an organization, a document, a material, a table, the parts of a
 * postal address. What has no name is told by its entity. Nothing for
 * STEP_NONE. Fails with TCS_NO_MEMORY.
 */
enum tcs_status ifc_reference_text(const struct ifc_file *file, uint32_t object,
	struct step_text *text, struct tcs_fault *fault) TCS_CHECKED;

/* ---- ifc_whereabouts.c --------------------------------------------------- */

/*
 * Append where a site or building says it is: a site's latitude, longitude and
 * true north, in degrees, and address, and a building's address as CityGML has it (2.0
 * 10.3.4, in xAL 2.0), which readers of CityGML look for.
 */
enum tcs_status ifc_whereabouts_write(struct ifc_saying *saying,
	uint32_t instance, struct tcs_fault *fault) TCS_CHECKED;

/* ---- ifc_materials.c ----------------------------------------------------- */

/*
 * Append the name of a material; of one with parts their names, and for
 * layers, profiles and constituents a set that has them one by one, under
 * their numbers from 1, with what is told of each and of the whole.
 */
enum tcs_status ifc_material_write(struct ifc_saying *saying, uint32_t material,
	struct tcs_fault *fault) TCS_CHECKED;

/* The first material that is painted; 0 for none. */
uint32_t ifc_material_paint(const struct ifc_model *model, uint32_t instance);

#endif
