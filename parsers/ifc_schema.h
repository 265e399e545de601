/*
 * What the IFC schemas say of the entities that are read here: each entity's
 * supertype and the positions of its attributes, for three versions.
 *
 * One table of rows, X(entity, supertype, versions, attributes). `versions`
 * names those that have the entity by a digit each: 2 is IFC2X3, 4 is IFC4, 5
 * is IFC4X3. `attributes` are its own, in order, without the inherited ones;
 * "Name:45" is there in the versions named only. Where a name changed and the
 * position did not, the newer name stands for both. Entities of a version that
 * are no business of a building's shape or of what is told about it are not in
 * the table, and neither are derived and inverse attributes.
 *
 * An entity that a version does not have, but a file of that version uses, is
 * taken from the nearest version that has it, the newer one first.
 *
 *     position = ifc_attribute(version, IFC_DOOR, "OverallHeight");
 *     if (ifc_is(version, entity, IFC_ELEMENT))
 *             …
 *
 * source: ISO 16739-1:2024 (IFC4X3), ISO 16739:2013 with its second addendum
 * (IFC4), and IFC2X3 TC1 of buildingSMART.
 */
#ifndef TESSERA_IFC_SCHEMA_H
#define TESSERA_IFC_SCHEMA_H

#include <stdbool.h>
#include <stddef.h>

#include "ifc_rows_moved.h"
#include "ifc_rows_product.h"
#include "ifc_rows_relation.h"
#include "ifc_rows_shape.h"
#include "ifc_rows_type.h"

#define IFC_ROWS(X) \
	IFC_PRODUCT_ROWS(X) \
	IFC_TYPE_ROWS(X) \
	IFC_RELATION_ROWS(X) \
	IFC_SHAPE_ROWS(X)

enum ifc_version { IFC_2X3, IFC_4, IFC_4X3, IFC_VERSIONS };

/* IFC_WALL is IfcWall; IFC_NONE is no entity of the table. */
enum ifc_entity {
	IFC_NONE,
#define X(name, super, versions, attributes) IFC_##name,
	IFC_ROWS(X)
#undef X
		IFC_ENTITIES
};

enum { IFC_NO_POSITION = -1 };

/*
 * The version that a name in FILE_SCHEMA stands for: IFC2X…, IFC4, IFC4X1 and
 * IFC4X2 as the nearest of the three, any later IFC4X as IFC4X3. False for a
 * name that is none of IFC's.
 */
bool ifc_version_of(const char *schema, enum ifc_version *out);

/* "IFCWALL"; "" for IFC_NONE. */
const char *ifc_name(enum ifc_entity entity);

/* The entity with a name in capitals, IFC_NONE for one not in the table. */
enum ifc_entity ifc_find(const char *name);

bool ifc_exists(enum ifc_version version, enum ifc_entity entity);

/* The entity's supertype; IFC_NONE for one without. */
enum ifc_entity ifc_super(enum ifc_version version, enum ifc_entity entity);

/* Whether `entity` is `kind` or a subtype of it, at any distance. */
bool ifc_is(
	enum ifc_version version, enum ifc_entity entity, enum ifc_entity kind);

/* The count of an entity's attributes, the inherited ones included. */
size_t ifc_attribute_count(enum ifc_version version, enum ifc_entity entity);

/*
 * The position, from 0, of an attribute, own or inherited, among an instance's
 * parameters; IFC_NO_POSITION when there is none of that name.
 */
int ifc_attribute(enum ifc_version version, enum ifc_entity entity,
	const char *attribute);

#endif
