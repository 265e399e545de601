/*
 * What elements of IFC are in CityGML: before 3.0, which has constructive
 * elements, surfaces of the building; and whose openings they fill.
 */
#include <string.h>

#include "byte_index.h"
#include "citygml_compose.h"

static bool
begins(const char *text, const char *with)
{
	return !strncmp(text, with, strlen(with));
}

bool
element_is_ifc(const struct composer *composer, uint32_t feature)
{
	const struct tcs_feature *given =
		&composer->object.features.at[feature];

	return begins(compose_text(composer, given->type), "Ifc");
}

/* The value of an attribute of the feature, in a set or not; "" for none. */
static const char *
attribute_value(
	const struct composer *composer, uint32_t feature, const char *name)
{
	const struct tcs_attribute *attributes = composer->object.attributes.at;
	size_t low = 0, high = composer->object.attributes.count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (attributes[middle].feature < feature)
			low = middle + 1;
		else
			high = middle;
	}
	for (; low < composer->object.attributes.count &&
		attributes[low].feature == feature;
		low++)
		if (!strcmp(compose_text(composer, attributes[low].name), name))
			return compose_text(composer, attributes[low].value);
	return "";
}

unsigned
element_surface(const struct composer *composer, uint32_t feature)
{
	static const struct {
		const char *type, *predefined; /* NULL: any */
		unsigned class;
	} rows[] = {
		{"IfcWall", NULL, TCS_CLASS_WallSurface},
		{"IfcCurtainWall", NULL, TCS_CLASS_WallSurface},
		{"IfcRoof", NULL, TCS_CLASS_RoofSurface},
		{"IfcSlab", "ROOF", TCS_CLASS_RoofSurface},
		{"IfcSlab", "BASESLAB", TCS_CLASS_GroundSurface},
		{"IfcSlab", NULL, TCS_CLASS_FloorSurface},
		{"IfcFooting", NULL, TCS_CLASS_GroundSurface},
		{"IfcCovering", "ROOFING", TCS_CLASS_RoofSurface},
		{"IfcCovering", "CEILING", TCS_CLASS_CeilingSurface},
		{"IfcCovering", "FLOORING", TCS_CLASS_FloorSurface},
	};
	const struct tcs_feature *given =
		&composer->object.features.at[feature];
	const char *type = compose_text(composer, given->type);
	const char *predefined;

	if (compose_is_3(composer) ||
		given->class != TCS_CLASS_BuildingConstructiveElement)
		return TCS_CLASS_Unknown;
	if (begins(type, "IfcWall") &&
		!strcmp(attribute_value(composer, feature, "IsExternal"),
			"false"))
		return TCS_CLASS_InteriorWallSurface;
	predefined = attribute_value(composer, feature, "PredefinedType");
	for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
		if (begins(type, rows[i].type) &&
			(!rows[i].predefined ||
				!strcmp(rows[i].predefined, predefined)))
			return rows[i].class;
	return TCS_CLASS_Unknown;
}

static enum tcs_status
ids_list(const struct composer *composer, struct byte_index *ids,
	uint32_t *features, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; i < object->features.count && !status; i++) {
		const char *id =
			compose_text(composer, object->features.at[i].id);
		uint32_t number;
		bool added;

		status = byte_index_add(
			ids, id, strlen(id), &number, &added, fault);
		if (!status && added)
			features[number] = i;
	}
	return status;
}

enum tcs_status
elements_find_hosts(const struct composer *composer, uint32_t *hosts,
	struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	struct byte_index ids = {.slots.count = 0};
	TCS_ARRAY(uint32_t) features = {.count = 0};
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < object->features.count; i++)
		hosts[i] = TCS_NONE;
	if (!object->relations.count)
		return TCS_OK;
	if (array_grow(&features, object->features.count))
		return fault_memory(fault);
	status = ids_list(composer, &ids, features.at, fault);
	for (size_t i = 0; i < object->relations.count && !status; i++) {
		const struct tcs_relation *relation = &object->relations.at[i];
		const char *target = compose_text(composer, relation->target);
		uint32_t number = byte_index_find(&ids, target, strlen(target));

		if (number != INDEX_NONE &&
			element_is_ifc(composer, relation->feature) &&
			!strcmp(compose_text(composer, relation->role),
				"fills"))
			hosts[relation->feature] = features.at[number];
	}
	array_release(&features);
	byte_index_release(&ids);
	return status;
}
