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

/* The units of the project: STEP_NONE for a file without. */
uint32_t ifc_unit_assignment(const struct ifc_file *file);

/*
 * The project's unit of a type, "LENGTHUNIT"; STEP_NONE where there is none.
 */
uint32_t ifc_unit_of_type(const struct ifc_file *file, uint32_t assignment,
	const char *type, size_t length);

/*
 * The project's unit for a measure, "IFCPOSITIVELENGTHMEASURE"; STEP_NONE
 * where there is none.
 */
uint32_t ifc_unit_of_measure(const struct ifc_file *file, uint32_t assignment,
	const char *measure, size_t length);

#endif
