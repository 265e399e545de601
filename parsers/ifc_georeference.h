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
 * source: IfcMapConversion, IfcMapConversionScaled, IfcRigidOperation,
 * IfcProjectedCRS (ISO 16739-1 8.18); for IFC2X3 there is none.
 */
#ifndef TESSERA_IFC_GEOREFERENCE_H
#define TESSERA_IFC_GEOREFERENCE_H

#include "ifc_placement.h"
#include "ifc_units.h"

struct ifc_georeference {
	struct ifc_matrix world; /* from the file's units to the stream's */
	double metres_per_unit; /* of the stream */
	uint32_t crs; /* the coordinate reference system; STEP_NONE: local */
};

void ifc_georeference_read(const struct ifc_file *file,
	const struct ifc_units *units, bool local,
	struct ifc_georeference *out);

#endif
