/*
 * Bodies cut into the layers of their material.
 *
 * source: IfcMaterialLayerSetUsage (ISO 16739-1 8.10): layers follow each other
 * from an offset on, along an axis of the product, in one sense.
 */
#ifndef TESSERA_IFC_LAYERS_H
#define TESSERA_IFC_LAYERS_H

#include "ifc_cut.h"
#include "ifc_model.h"

/*
 * Cut each solid of a body into one part a layer, in the order of the layers.
 * Faces that have no style, or that of the product's material, `paint`, get
 * that of their layer, if it has one. A body that reaches beyond the layers, as that of a bent
 * wall does, or a product that has fewer than two, is left as it is; so is one
 * that cannot be cut, with a remark about `product`.
 */
enum ifc_outcome ifc_body_layer(struct ifc_shaper *shaper,
	const struct ifc_model *model, uint32_t product, uint32_t paint,
	struct ifc_body *body) TCS_CHECKED;

#endif
