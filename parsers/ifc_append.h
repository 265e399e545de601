/*
 * Objects put together from pieces that were made apart.
 */
#ifndef TESSERA_IFC_APPEND_H
#define TESSERA_IFC_APPEND_H

#include "tcs.h"

/*
 * Append another piece of the same object: its features, attributes and
 * relations follow those of `out`, and name features by their number in the
 * whole; so do its geometries and instances, which have no text. Fails with
 * TCS_NO_MEMORY, or TCS_LIMIT where indices or offsets run out.
 */
enum tcs_status ifc_object_append(struct tcs_object *out,
	const struct tcs_object *more, struct tcs_fault *fault) TCS_CHECKED;

#endif
