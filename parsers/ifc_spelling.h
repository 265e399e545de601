/*
 * The names of IFC entities as the schema spells them.
 */
#ifndef TESSERA_IFC_SPELLING_H
#define TESSERA_IFC_SPELLING_H

#include "ifc_schema.h"

/* "IfcWall" for IFC_WALL; the name in capitals for what is no product. */
const char *ifc_spelled(enum ifc_entity entity);

#endif
