/*
 * Openings and projections: which ones a product has, cutting the ones out of
 * its body and joining the others to it.
 *
 * source: IfcRelVoidsElement, IfcOpeningElement, IfcRelProjectsElement,
 * IfcProjectionElement (ISO 16739-1 5.4, 6.1).
 */
#ifndef TESSERA_IFC_OPENING_H
#define TESSERA_IFC_OPENING_H

#include "ifc_cut.h"
#include "ifc_tree.h"

/* One under its host, both nodes of the tree. */
struct ifc_opening {
	uint32_t host, opening;
	bool is_addition; /* a projection */
};

/* Sorted by host. */
TCS_ARRAY_TYPE(ifc_openings, struct ifc_opening);

/* Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_openings_list(const struct ifc_tree *tree,
	struct ifc_openings *out, struct tcs_fault *fault) TCS_CHECKED;

/* The first opening of a host, and how many follow it; NULL for none. */
const struct ifc_opening *ifc_openings_find(
	const struct ifc_openings *openings, uint32_t host, size_t *count);

/*
 * Cut the parts of `tools` out of every part of `body` that they reach. A part
 * that nothing is left of is gone, with a remark about `product`; so is what
 * could not be cut, which stays whole.
 */
enum ifc_outcome ifc_body_open(struct ifc_shaper *shaper, uint32_t product,
	const struct ifc_body *tools, struct ifc_body *body) TCS_CHECKED;

/*
 * Join the parts of `tools` to `body`, each solid to the first of the body that
 * it touches. One that touches none, or cannot be joined, which is remarked
 * about `product`, becomes a part by itself.
 */
enum ifc_outcome ifc_body_join(struct ifc_shaper *shaper, uint32_t product,
	const struct ifc_body *tools, struct ifc_body *body) TCS_CHECKED;

#endif
