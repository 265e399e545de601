/*
 * The storeys of a file that are chosen by their names.
 */
#ifndef TESSERA_IFC_STOREYS_H
#define TESSERA_IFC_STOREYS_H

#include "ifc_objects.h"

/*
 * Set chosen[i] for every node that is a storey with one of the names, or has
 * such a storey above it, or is neither in a storey nor one and can hold some:
 * a site, a building. `chosen` has room for the tree's nodes. Fails with
 * TCS_BAD_INPUT when no storey has one of the names, with TCS_NO_MEMORY.
 */
enum tcs_status ifc_storeys_choose(const struct ifc_file *file,
	const struct ifc_tree *tree, const struct ifc_keep *keep, bool *chosen,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
