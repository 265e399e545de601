/*
 * What is said about objects: for each, the property sets, quantities, type,
 * materials and classifications that relations link to it.
 *
 * source: IfcRelDefinesByProperties, IfcRelDefinesByType,
 * IfcRelAssociatesMaterial, IfcRelAssociatesClassification (ISO 16739-1 5.1).
 */
#ifndef TESSERA_IFC_LINKS_H
#define TESSERA_IFC_LINKS_H

#include "ifc_file.h"

enum ifc_link_kind {
	IFC_SAYS_PROPERTIES, /* IfcPropertySet, IfcElementQuantity */
	IFC_SAYS_TYPE, /* IfcTypeObject */
	IFC_SAYS_MATERIAL, /* any of IfcMaterialSelect */
	IFC_SAYS_CLASS, /* IfcClassificationReference, IfcClassification */
};

struct ifc_said {
	uint32_t object; /* an instance */
	uint32_t target; /* an instance */
	enum ifc_link_kind kind;
};

/* Sorted by object, then kind, then by the order of the targets in the file. */
TCS_ARRAY_TYPE(ifc_links, struct ifc_said);

/* Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_links_read(const struct ifc_file *file,
	struct ifc_links *out, struct tcs_fault *fault) TCS_CHECKED;

/* The links of one kind of an object: the first, and how many follow it. */
const struct ifc_said *ifc_links_find(const struct ifc_links *links,
	uint32_t object, enum ifc_link_kind kind, size_t *count);

#endif
