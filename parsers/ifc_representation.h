/*
 * Which of a product's representations is its body.
 *
 * The one called Body; without one, what programs write in its stead. Never an
 * axis, a footprint, a box, a clearance, or anything else that only stands for
 * the product.
 *
 * source: IfcShapeRepresentation, RepresentationIdentifier (ISO 16739-1 5.1).
 */
#ifndef TESSERA_IFC_REPRESENTATION_H
#define TESSERA_IFC_REPRESENTATION_H

#include "ifc_file.h"

/* The IfcShapeRepresentation; STEP_NONE where there is none. */
uint32_t ifc_body_of(const struct ifc_file *file, uint32_t product);

/* The items of a representation: a list, or a value of another kind. */
struct step_value ifc_items_of(
	const struct ifc_file *file, uint32_t representation);

/* Whether the product has any representation, a body or not. */
bool ifc_is_shown(const struct ifc_file *file, uint32_t product);

#endif
