/*
 * What ifcXML leaves to the schema: the types of attributes, as far as the
 * spelling of a value depends on them, and inverse attributes.
 *
 * source: ISO 16739-1, the EXPRESS schemas of IFC2X3, IFC4, IFC4X3.
 */
#ifndef TESSERA_IFCXML_NAMES_H
#define TESSERA_IFCXML_NAMES_H

#include "ifc_schema.h"

enum ifcxml_kind {
	IFCXML_PLAIN, /* numbers, truth values, else text: as it looks */
	IFCXML_STRING, /* text that may look like a number */
	IFCXML_ENUMERATION,
};

/* How a simple value of an attribute is to be read. */
enum ifcxml_kind ifcxml_kind_of(enum ifc_entity entity, const char *attribute);

/* Whether the attribute is a list, or a set. */
bool ifcxml_is_list(enum ifc_entity entity, const char *attribute);

/* The length of the rows of an attribute that is a list of lists of numbers,
   which are written without their borders; 0 for any other. */
unsigned ifcxml_row_length(enum ifc_entity entity, const char *attribute);

/*
 * The type that an element called like the attribute has when it does not say
 * it; IFC_NONE where it must, or the attribute is no instance.
 */
enum ifc_entity ifcxml_declared(enum ifc_entity entity, const char *attribute);

/* An inverse attribute: the relation that it holds, and the attribute of it
   that leads back. */
struct ifcxml_inverse {
	const char *name;
	enum ifc_entity relation;
	const char *back;
};

/* NULL for what is no inverse attribute. */
const struct ifcxml_inverse *ifcxml_inverse_of(const char *name);

/* Whether a defined type, "IFCLABEL", is text. */
bool ifcxml_type_is_text(const char *type);

#endif
