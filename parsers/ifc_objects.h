/*
 * The objects of the stream: which nodes of the tree each one holds, a parent
 * before its children.
 *
 * A building, or another facility, is an object with all that is in it, parts
 * of buildings included. What is in none is an object by itself, together with
 * what it consists of: a site without its buildings, a wall that stands alone.
 * Openings, ports, annotations, grids and loads are no members.
 */
#ifndef TESSERA_IFC_OBJECTS_H
#define TESSERA_IFC_OBJECTS_H

#include "ifc_tree.h"

struct ifc_member {
	uint32_t node; /* of the tree */
	uint32_t parent; /* member of the same object, from 0; STEP_NONE */
};

struct ifc_object {
	uint32_t first_member;
	uint32_t member_count;
};

/* All zero is empty. */
struct ifc_objects {
	TCS_ARRAY(struct ifc_object) objects; /* in the order of the file */
	TCS_ARRAY(struct ifc_member) members;
};

enum ifc_keep {
	IFC_KEEP_ALL,
	IFC_KEEP_NO_SPACES = 1, /* leave out IfcSpace */
};

/* Fails with TCS_NO_MEMORY. */
enum tcs_status ifc_objects_list(const struct ifc_file *file,
	const struct ifc_tree *tree, unsigned keep, struct ifc_objects *out,
	struct tcs_fault *fault) TCS_CHECKED;

void ifc_objects_release(struct ifc_objects *objects);

#endif
