#include "lod_home.h"

#include "labels.h"

static bool
has_its_own(unsigned class, unsigned lod)
{
	enum label_kind kind = label_of(class)->kind;

	if (lod > 2)
		return true;
	if (lod == 2)
		return kind != LABEL_OPENING;
	return kind == LABEL_OBJECT || class == TCS_CLASS_BuildingPart ||
		class == TCS_CLASS_BridgePart || class == TCS_CLASS_TunnelPart;
}

void
lod_homes_find(const struct tcs_object *object, unsigned lod, uint32_t *homes)
{
	for (size_t i = 0; i < object->features.count; i++) {
		const struct tcs_feature *feature = &object->features.at[i];

		/* Parents stand before their children. */
		homes[i] = feature->parent == TCS_NONE ||
				has_its_own(feature->class, lod)
			? (uint32_t)i
			: homes[feature->parent];
	}
}
