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

enum { IFC_MOST_TYPES = 64, IFC_MOST_STOREYS = 64 };

/* A storey's name or GlobalId, UTF-8, borrowed. */
struct ifc_storey_name {
	const char *text;
	size_t length;
};

/* Which products are members; all zero: all that can be. */
struct ifc_keep {
	bool no_spaces; /* leave out IfcSpace */
	/* Keep of the products that are no spatial elements these and their
	   subtypes only; none listed: all. */
	enum ifc_entity types[IFC_MOST_TYPES];
	size_t type_count;
	/* Keep of the buildings these storeys and what is in them only; none
	   listed: all. */
	struct ifc_storey_name storeys[IFC_MOST_STOREYS];
	size_t storey_count;
};

/*
 * Fails with TCS_BAD_INPUT when a storey that is listed is not there, naming
 * those that are, and with TCS_NO_MEMORY.
 */
enum tcs_status ifc_objects_list(const struct ifc_file *file,
	const struct ifc_tree *tree, const struct ifc_keep *keep,
	struct ifc_objects *out, struct tcs_fault *fault) TCS_CHECKED;

void ifc_objects_release(struct ifc_objects *objects);

#endif
