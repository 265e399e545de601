/*
 * The head of a stream that comes from IFC.
 */
#ifndef TESSERA_IFC_HEAD_H
#define TESSERA_IFC_HEAD_H

#include "ifc_georeference.h"
#include "ifc_model.h"
#include "program.h"

/* Fill an empty head. Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_head_build(struct tcs_head *head,
	const struct ifc_model *model, const struct ifc_georeference *place,
	const struct command *command, struct tcs_fault *fault) TCS_CHECKED;

#endif
