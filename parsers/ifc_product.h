/*
 * One product's geometry: its body, evaluated, placed and triangulated.
 */
#ifndef TESSERA_IFC_PRODUCT_H
#define TESSERA_IFC_PRODUCT_H

#include "ifc_model.h"
#include "ifc_polygons.h"
#include "ifc_prototypes.h"

/* One worker's memory, reused. All zero is empty. */
struct ifc_worker {
	const struct ifc_model *model; /* borrowed */
	const struct ifc_prototypes *prototypes; /* borrowed; NULL: bake all */
	struct ifc_matrix world; /* from the file's world to the stream's */
	bool layers; /* cut bodies into those of their material */
	struct ifc_shaper shaper;
	struct triangulator *triangulator;
	struct ifc_body body;
	struct ifc_body tools; /* its openings, in its coordinates */
};

/* `deflection` is in metres. Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_worker_begin(struct ifc_worker *worker,
	const struct ifc_model *model, const struct ifc_matrix *world,
	double deflection, struct tcs_fault *fault) TCS_CHECKED;
void ifc_worker_end(struct ifc_worker *worker);

/*
 * Build a prototype: an object of one feature. False in *whole when some of it
 * cannot be evaluated, or nothing is left; then nothing is reported, and it is
 * no prototype. Fails with TCS_NO_MEMORY or TCS_LIMIT.
 */
enum tcs_status ifc_prototype_shape(struct ifc_worker *worker,
	const struct ifc_prototype *prototype, struct tcs_object *out,
	bool *whole, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append the geometries of a node's product to `out`, as those of `feature`,
 * or its instances where it is nothing but prototypes. Its projections are
 * joined to it, and have no geometry of their own. Items that cannot be
 * evaluated are left out, each reported by its kind and with the product's id.
 * Fails with TCS_NO_MEMORY or TCS_LIMIT.
 */
enum tcs_status ifc_product_shape(struct ifc_worker *worker, uint32_t node,
	uint32_t feature, struct tcs_object *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
