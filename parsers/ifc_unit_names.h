/*
 * What units are called: "mm", "m2", "W/(m2.K)", and which one a measure has
 * where it names none.
 */
#ifndef TESSERA_IFC_UNIT_NAMES_H
#define TESSERA_IFC_UNIT_NAMES_H

#include "ifc_file.h"

#define IFC_UNIT_ROOM 64

/*
 * The symbol of a unit: an SI unit's, a converted unit's own name, those of a
 * derived unit put together. "" for one that has none.
 */
void ifc_unit_name(
	const struct ifc_file *file, uint32_t unit, char out[IFC_UNIT_ROOM]);

/* A unit of the project. */
struct ifc_project_unit {
	const char *type; /* "LENGTHUNIT", in the file's text */
	size_t length; /* of the type */
	char name[IFC_UNIT_ROOM];
};

/* All zero is none. */
TCS_ARRAY_TYPE(ifc_project_units, struct ifc_project_unit);

/* The units that the project assigns. Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_project_units_read(const struct ifc_file *file,
	struct ifc_project_units *out, struct tcs_fault *fault) TCS_CHECKED;

/*
 * What the project's unit of a type, "LENGTHUNIT", is called; "" where it has
 * none.
 */
const char *ifc_unit_of_type(
	const struct ifc_project_units *units, const char *type);

/* The same of a measure, "IFCPOSITIVELENGTHMEASURE". */
const char *ifc_unit_of_measure(const struct ifc_project_units *units,
	const char *measure, size_t length);

#endif
