#include "ifc_schema.h"

#include <string.h>

struct row {
	const char *name;
	enum ifc_entity super;
	const char *versions;
	const char *attributes;
};

static const struct row rows[IFC_ENTITIES] = {
	[IFC_NONE] = {"", IFC_NONE, "", ""},
#define X(name, super, versions, attributes) \
	[IFC_##name] = {"IFC" #name, IFC_##super, versions, attributes},
	IFC_ROWS(X)
#undef X
};

static const char digits[IFC_VERSIONS] = {
	[IFC_2X3] = '2',
	[IFC_4] = '4',
	[IFC_4X3] = '5',
};

bool
ifc_version_of(const char *schema, enum ifc_version *out)
{
	if (!strncmp(schema, "IFC2X", 5))
		*out = IFC_2X3;
	else if (!strncmp(schema, "IFC4X", 5) && schema[5] >= '3')
		*out = IFC_4X3;
	else if (!strncmp(schema, "IFC4", 4))
		*out = IFC_4;
	else
		return false;
	return true;
}

const char *
ifc_name(enum ifc_entity entity)
{
	return rows[entity].name;
}

enum ifc_entity
ifc_find(const char *name)
{
	if (strncmp(name, "IFC", 3))
		return IFC_NONE;
	for (int i = IFC_NONE + 1; i < IFC_ENTITIES; i++)
		if (rows[i].name[3] == name[3] && !strcmp(rows[i].name, name))
			return (enum ifc_entity)i;
	return IFC_NONE;
}

bool
ifc_exists(enum ifc_version version, enum ifc_entity entity)
{
	return strchr(rows[entity].versions, digits[version]) != NULL;
}

/* The version from which the entity is taken. */
static enum ifc_version
version_near(enum ifc_version version, enum ifc_entity entity)
{
	for (int i = (int)version; i < IFC_VERSIONS; i++)
		if (ifc_exists((enum ifc_version)i, entity))
			return (enum ifc_version)i;
	for (int i = (int)version; i > IFC_2X3; i--)
		if (ifc_exists((enum ifc_version)i, entity))
			return (enum ifc_version)i;
	return ifc_exists(IFC_2X3, entity) ? IFC_2X3 : version;
}

enum ifc_entity
ifc_super(enum ifc_version version, enum ifc_entity entity)
{
	char digit = digits[version_near(version, entity)];

	switch (entity) {
#define X(name, versions, above) \
	case IFC_##name: \
		return strchr(versions, digit) ? IFC_##above \
					       : rows[entity].super;
		IFC_MOVED_ROWS(X)
#undef X
	default:
		return rows[entity].super;
	}
}

bool
ifc_is(enum ifc_version version, enum ifc_entity entity, enum ifc_entity kind)
{
	while (entity != kind && entity != IFC_NONE)
		entity = ifc_super(version, entity);
	return entity == kind;
}

/*
 * The count of the entity's own attributes in a version, up to the one called
 * `wanted`; *found says whether that is there. NULL counts all.
 */
static size_t
own_count(enum ifc_version version, enum ifc_entity entity, const char *wanted,
	bool *found)
{
	char digit = digits[version_near(version, entity)];
	const char *at = rows[entity].attributes;
	size_t count = 0;

	while (*at) {
		size_t length = strcspn(at, " ");
		size_t name = strcspn(at, " :");
		bool there = name == length ||
			memchr(at + name, digit, length - name);

		if (there && wanted && strlen(wanted) == name &&
			!memcmp(at, wanted, name)) {
			*found = true;
			return count;
		}
		count += there;
		at += length;
		at += strspn(at, " ");
	}
	return count;
}

size_t
ifc_attribute_count(enum ifc_version version, enum ifc_entity entity)
{
	size_t count = 0;

	for (; entity != IFC_NONE; entity = ifc_super(version, entity))
		count += own_count(version, entity, NULL, NULL);
	return count;
}

int
ifc_attribute(
	enum ifc_version version, enum ifc_entity entity, const char *attribute)
{
	for (; entity != IFC_NONE; entity = ifc_super(version, entity)) {
		bool found = false;
		size_t own = own_count(version, entity, attribute, &found);
		enum ifc_entity super = ifc_super(version, entity);

		if (found)
			return (int)(own + ifc_attribute_count(version, super));
	}
	return IFC_NO_POSITION;
}
