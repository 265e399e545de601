/*
 * What an IFC entity is as a class of the stream.
 *
 * A building's products become parts of the building: load-bearing and
 * enclosing elements BuildingConstructiveElement, doors and windows openings,
 * furniture, rooms and storeys what they are in CityGML 3.0, the rest
 * installations. What stands alone, in no building, becomes an object by
 * itself. The entity's own name is kept as the feature's type.
 *
 * source: CityGML 3.0 (OGC 20-010) 7.7, 8.3; ISO 16739-1 5.4, 6.1.
 */
#ifndef TESSERA_IFC_CLASS_H
#define TESSERA_IFC_CLASS_H

#include "ifc_file.h"
#include "labels.h"

/* The class of an entity as an object of the stream. */
enum tcs_class ifc_class_alone(
	const struct ifc_file *file, enum ifc_entity entity);

/* … as a part of an object of the class `object`. */
enum tcs_class ifc_class_within(const struct ifc_file *file,
	enum ifc_entity entity, enum tcs_class object);

#endif
