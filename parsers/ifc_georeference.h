/*
 * Where on the earth a file's coordinates lie, and the matrix that takes them
 * there.
 *
 * With an IfcMapConversion (or IfcRigidOperation) to a named system the stream
 * has that system's coordinates: turned by the abscissa and ordinate of the x
 * axis, scaled into map units, moved. A north that the file also tells is that
 * same turn and not applied again. Without one, or when local coordinates are
 * asked for, the stream has the file's own, in metres.
 *
 * Files of IFC2X3 say the same by property sets of the project, a site or a
 * building, ePSet_MapConversion and ePSet_ProjectedCRS, whose names occur with
 * and without the e and in any case. They count where there is no operation.
 *
 * source: IfcMapConversion, IfcMapConversionScaled, IfcRigidOperation,
 * IfcProjectedCRS (ISO 16739-1 8.18); buildingSMART, User Guide for
 * Geo-referencing in IFC, 2020, for IFC2X3.
 */
#ifndef TESSERA_IFC_GEOREFERENCE_H
#define TESSERA_IFC_GEOREFERENCE_H

#include "ifc_model.h"

struct ifc_georeference {
	struct ifc_matrix world; /* from the file's units to the stream's */
	double metres_per_unit; /* of the stream */
	bool is_local; /* else in the map's coordinates */
	struct step_value system; /* the name of the map's, where it is a
	                             string */
};

void ifc_georeference_read(const struct ifc_model *model, bool local,
	struct ifc_georeference *out);

/*
 * Where the file says north is: degrees clockwise from its y axis. False where
 * it does not say, or tells a map operation, which counts.
 */
bool ifc_true_north(const struct ifc_model *model, double *degrees);

/* ---- ifc_map_properties.c ------------------------------------------------ */

/* What takes coordinates to a map. */
struct ifc_map_operation {
	double eastings, northings, height; /* in map units, of 0 */
	double abscissa, ordinate; /* of the x axis */
	double scale; /* into map units; 0: by the units alone */
	double factors[3];
	double unit; /* metres of the map's unit; 0: the project's */
	struct step_value system;
};

/* The operation that property sets tell; false where none do. */
bool ifc_map_properties_read(
	const struct ifc_model *model, struct ifc_map_operation *out);

#endif
