#include "lod_select.h"

#include <string.h>

#include "labels.h"

bool
geometry_has_area(const struct tcs_geometry *geometry)
{
	return geometry->kind != TCS_MULTI_CURVE &&
		geometry->kind != TCS_MULTI_POINT;
}

bool
class_is_portion(unsigned class)
{
	return class == TCS_CLASS_BuildingPart ||
		class == TCS_CLASS_BridgePart || class == TCS_CLASS_TunnelPart;
}

/* 0 for "nothing", so that a cleared array is a valid start. */
static uint8_t
lod_rank(unsigned lod)
{
	return lod == TCS_LOD_NONE ? 1 : (uint8_t)(lod + 2);
}

static bool
has_triangles(const struct tcs_object *object, const struct tcs_geometry *of)
{
	if (!geometry_has_area(of))
		return false;
	for (uint32_t i = 0; i < of->polygon_count; i++)
		if (object->polygons.at[of->first_polygon + i].triangle_count)
			return true;
	return false;
}

static int
selection_size(struct selection *selection, const struct tcs_object *object)
{
	size_t features = object->features.count;
	size_t geometries = object->geometries.count;
	size_t instances = object->instances.count;

	array_clear(&selection->hosts);
	array_clear(&selection->best);
	array_clear(&selection->geometries);
	array_clear(&selection->instances);
	if (array_grow(&selection->hosts, features) ||
		array_grow(&selection->best, features) ||
		array_grow(&selection->geometries, geometries + 1) ||
		array_grow(&selection->instances, instances + 1))
		return -1;
	selection->hosts.count = features;
	selection->best.count = features;
	selection->geometries.count = geometries;
	selection->instances.count = instances;
	if (features)
		memset(selection->best.at, 0, features);
	return 0;
}

/* Parents stand before children, so one pass finds every host. */
static void
find_hosts(struct selection *selection, const struct tcs_object *object)
{
	for (size_t i = 0; i < object->features.count; i++) {
		const struct tcs_feature *feature = object->features.at + i;
		enum label_kind kind = label_of(feature->class)->kind;
		bool shares = feature->parent != TCS_NONE &&
			(kind == LABEL_SURFACE || kind == LABEL_OPENING);

		selection->hosts.at[i] = shares
			? selection->hosts.at[feature->parent]
			: (uint32_t)i;
	}
}

static void
rank_level(struct selection *selection, uint32_t feature, unsigned lod)
{
	uint8_t *best = selection->best.at + selection->hosts.at[feature];

	if (*best < lod_rank(lod))
		*best = lod_rank(lod);
}

/* A host ranks no lower than its portions; children stand behind parents. */
static void
raise_hosts(struct selection *selection, const struct tcs_object *object)
{
	for (size_t i = object->features.count; i-- > 0;) {
		const struct tcs_feature *feature = object->features.at + i;
		uint8_t *best;

		if (feature->parent == TCS_NONE ||
			!class_is_portion(feature->class))
			continue;
		best = selection->best.at +
			selection->hosts.at[feature->parent];
		if (*best < selection->best.at[i])
			*best = selection->best.at[i];
	}
}

static bool
level_is_drawn(const struct selection *selection, uint32_t feature,
	unsigned level, int wanted)
{
	if (wanted == SELECT_ALL)
		return true;
	if (wanted >= 0)
		return level == (unsigned)wanted;
	return lod_rank(level) ==
		selection->best.at[selection->hosts.at[feature]];
}

enum tcs_status
selection_make(struct selection *selection, const struct tcs_object *object,
	int lod, struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry = object->geometries.at;
	const struct tcs_instance *instance = object->instances.at;

	if (selection_size(selection, object))
		return fault_memory(fault);
	find_hosts(selection, object);
	for (size_t i = 0; i < object->geometries.count; i++)
		if (has_triangles(object, geometry + i))
			rank_level(selection, geometry[i].feature,
				geometry[i].lod);
	for (size_t i = 0; i < object->instances.count; i++)
		rank_level(selection, instance[i].feature, instance[i].lod);
	raise_hosts(selection, object);
	for (size_t i = 0; i < object->geometries.count; i++)
		selection->geometries.at[i] = geometry_has_area(geometry + i) &&
			level_is_drawn(selection, geometry[i].feature,
				geometry[i].lod, lod);
	for (size_t i = 0; i < object->instances.count; i++)
		selection->instances.at[i] = level_is_drawn(
			selection, instance[i].feature, instance[i].lod, lod);
	return TCS_OK;
}

void
selection_release(struct selection *selection)
{
	array_release(&selection->hosts);
	array_release(&selection->best);
	array_release(&selection->geometries);
	array_release(&selection->instances);
}

const char *
lod_parse(void *target, const char *argument)
{
	if (argument[0] < '0' || argument[0] > '4' || argument[1])
		return "not one of 0, 1, 2, 3, 4";
	*(int *)target = argument[0] - '0';
	return NULL;
}
