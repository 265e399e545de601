/*
 * Features of the stream out of the members of an object: ids, classes, names,
 * relations.
 */
#ifndef TESSERA_IFC_FEATURES_H
#define TESSERA_IFC_FEATURES_H

#include "ifc_model.h"

/*
 * Write features of an object to `out`, which is empty: those of `count`
 * members from the one numbered `first` on. Feature n of the object is its n-th
 * member, and so it is named, wherever it stands in `out`. Fails with
 * TCS_NO_MEMORY or TCS_LIMIT.
 */
enum tcs_status ifc_features_write(const struct ifc_model *model,
	const struct ifc_object *object, uint32_t first, uint32_t count,
	struct tcs_object *out, struct tcs_fault *fault) TCS_CHECKED;

/* Append the decoded text of a string; nothing, and 0, for another value. */
enum tcs_status ifc_text_add(struct tcs_object *out,
	const struct step_value *value, tcs_text *text,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
