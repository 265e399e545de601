/*
 * The units of an IFC project, as factors to metres and radians.
 *
 * source: IfcUnitAssignment, IfcSIUnit, IfcConversionBasedUnit,
 * IfcMeasureWithUnit (ISO 16739-1, 8.11).
 */
#ifndef TESSERA_IFC_UNITS_H
#define TESSERA_IFC_UNITS_H

#include "ifc_file.h"
#include "report.h"

struct ifc_units {
	double length; /* metres */
	double area; /* square metres */
	double volume; /* cubic metres */
	double angle; /* radians */
};

/*
 * The units of the first project of the file. What it does not say, or says
 * wrongly, is a metre, its square and cube, and a radian, with a note in the
 * report; an area or volume that is not said is that of the length. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status ifc_units_read(const struct ifc_file *file,
	struct ifc_units *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * How many of the SI unit one of a named unit is: an SI unit with its prefix,
 * which a square or cubic metre takes squared or cubed, or one that is
 * converted. A gram is a thousandth. False for anything else, for a factor
 * that is not positive, and for conversions that lead nowhere.
 */
bool ifc_unit_factor(const struct ifc_file *file, uint32_t unit, double *out);

#endif
