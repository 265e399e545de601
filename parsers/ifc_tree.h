/*
 * What belongs to what: the project, its sites, buildings, storeys and spaces,
 * the products in them, their parts, openings and what fills those.
 *
 * One node for every object definition of the file that is no type: products,
 * groups, the project. A node has at most one parent. Of several relations that
 * offer one, a decomposition (aggregation or nesting) counts before an opening
 * in its host, that before containment in a spatial structure, and among equals
 * the first of the file; the others are noted. A ring of parents is cut once,
 * and reported, so that every way up ends.
 *
 * source: IfcRelAggregates, IfcRelNests, IfcRelVoidsElement,
 * IfcRelProjectsElement, IfcRelContainedInSpatialStructure, IfcRelFillsElement.
 */
#ifndef TESSERA_IFC_TREE_H
#define TESSERA_IFC_TREE_H

#include "ifc_file.h"
#include "report.h"

enum ifc_link {
	IFC_LINK_NONE, /* no parent: the project, and what is left alone */
	IFC_LINK_PART, /* aggregated or nested: a storey of a building */
	IFC_LINK_VOID, /* an opening of its host */
	IFC_LINK_ADDITION, /* a projection of its host */
	IFC_LINK_CONTENT, /* contained: a wall in a storey */
};

struct ifc_node {
	uint32_t instance;
	uint32_t parent; /* a node; STEP_NONE */
	uint32_t fills; /* the node of the opening it fills; STEP_NONE */
	enum ifc_link link;
};

/* In the order of the file. */
TCS_ARRAY_TYPE(ifc_tree, struct ifc_node);

/* Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_tree_read(const struct ifc_file *file, struct ifc_tree *out,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

/* The node of an instance; STEP_NONE for none. */
uint32_t ifc_tree_find(const struct ifc_tree *tree, uint32_t instance);

/*
 * The nearest node that is a `kind`, from `node` itself upwards; STEP_NONE when
 * there is none. The building of a window: IFC_BUILDING.
 */
uint32_t ifc_tree_above(const struct ifc_file *file,
	const struct ifc_tree *tree, uint32_t node, enum ifc_entity kind);

#endif
