/* Which class each feature becomes, and where it hangs. */
#include <stdlib.h>
#include <string.h>

#include "citygml_compose.h"

#define IN_1 1
#define IN_2 2
#define IN_3 4
#define BEFORE_3 (IN_1 | IN_2)

/*
 * What a class becomes where the version has no such class, or its parent no
 * place for it; tried from the top.
 */
static const struct {
	uint16_t from, to;
	uint8_t versions;
} substitutes[] = {
	{TCS_CLASS_OuterCeilingSurface, TCS_CLASS_RoofSurface, IN_1},
	{TCS_CLASS_OuterFloorSurface, TCS_CLASS_RoofSurface, IN_1},
	{TCS_CLASS_Window, TCS_CLASS_WindowSurface, IN_3},
	{TCS_CLASS_Door, TCS_CLASS_DoorSurface, IN_3},
	{TCS_CLASS_WindowSurface, TCS_CLASS_Window, BEFORE_3},
	{TCS_CLASS_DoorSurface, TCS_CLASS_Door, BEFORE_3},
	{TCS_CLASS_BuildingConstructiveElement, TCS_CLASS_BuildingInstallation,
		BEFORE_3},
	{TCS_CLASS_TunnelConstructiveElement, TCS_CLASS_TunnelInstallation,
		BEFORE_3},
	{TCS_CLASS_BuildingInstallation, TCS_CLASS_IntBuildingInstallation,
		BEFORE_3},
	{TCS_CLASS_BridgeInstallation, TCS_CLASS_IntBridgeInstallation,
		BEFORE_3},
	{TCS_CLASS_TunnelInstallation, TCS_CLASS_IntTunnelInstallation,
		BEFORE_3},
	{TCS_CLASS_IntBuildingInstallation, TCS_CLASS_BuildingInstallation,
		BEFORE_3},
	{TCS_CLASS_BuildingFurniture, TCS_CLASS_IntBuildingInstallation,
		BEFORE_3},
	{TCS_CLASS_BridgeFurniture, TCS_CLASS_IntBridgeInstallation, BEFORE_3},
	{TCS_CLASS_TunnelFurniture, TCS_CLASS_IntTunnelInstallation, BEFORE_3},
	{TCS_CLASS_Storey, TCS_CLASS_CityObjectGroup, BEFORE_3},
	{TCS_CLASS_BuildingUnit, TCS_CLASS_CityObjectGroup, BEFORE_3},
	{TCS_CLASS_TransportationComplex, TCS_CLASS_Road, IN_3},
	{TCS_CLASS_Waterway, TCS_CLASS_TransportationComplex, BEFORE_3},
	{TCS_CLASS_Section, TCS_CLASS_TransportationComplex, BEFORE_3},
	{TCS_CLASS_Intersection, TCS_CLASS_TransportationComplex, BEFORE_3},
	{TCS_CLASS_Marking, TCS_CLASS_AuxiliaryTrafficArea, BEFORE_3},
	{TCS_CLASS_HoleSurface, TCS_CLASS_AuxiliaryTrafficArea, BEFORE_3},
	{TCS_CLASS_WaterClosureSurface, TCS_CLASS_ClosureSurface, IN_3},
	{TCS_CLASS_Unknown, TCS_CLASS_GenericCityObject, BEFORE_3},
	{TCS_CLASS_Unknown, TCS_CLASS_GenericOccupiedSpace, IN_3},
	{TCS_CLASS_GenericCityObject, TCS_CLASS_GenericOccupiedSpace, IN_3},
};

/* Not features in 1.0 and 2.0: what they hold belongs to what holds them. */
static const uint16_t only_around[] = {TCS_CLASS_TrafficSpace,
	TCS_CLASS_AuxiliaryTrafficSpace, TCS_CLASS_PointCloud};

static bool
has_class(const struct composer *composer, unsigned class)
{
	return class < TCS_CLASS_COUNT &&
		composer->plan->schema.classes[class].module;
}

static unsigned
version_bit(const struct composer *composer)
{
	return 1u << composer->plan->schema.version;
}

/* The n-th class to try, the first being the class itself; Unknown at the
 * end. */
static unsigned
candidate(const struct composer *composer, unsigned class, size_t n)
{
	if (n == 0)
		return class;
	for (size_t i = 0; i < sizeof substitutes / sizeof *substitutes; i++)
		if (substitutes[i].from == class &&
			(substitutes[i].versions & version_bit(composer)) &&
			--n == 0)
			return substitutes[i].to;
	return TCS_CLASS_Unknown;
}

static bool
is_surface(unsigned class)
{
	enum label_kind kind = label_of(class)->kind;

	return kind == LABEL_SURFACE || kind == LABEL_OPENING;
}

static void
become(struct composer *composer, struct node *node, unsigned class)
{
	node->number = (uint16_t) class;
	node->class = &composer->plan->schema.classes[class];
	node->module = node->class->module;
}

/* Find a class that the parent has a place for. */
static bool
hang(struct composer *composer, struct node *node, unsigned class,
	const char *role)
{
	const struct node *parent = &composer->nodes.at[node->parent];
	unsigned try = class;

	for (size_t n = 0; n == 0 || try != TCS_CLASS_Unknown; n++) {
		uint16_t property;

		try = candidate(composer, class, n);
		if (!has_class(composer, try))
			continue;
		property = schema_find_child(parent->class, try, role);
		if (property == SCHEMA_NONE)
			continue;
		become(composer, node, try);
		node->property = property;
		if (!strcmp(node->module, "bldg") && is_surface(try) &&
			!compose_is_3(composer) &&
			(!strcmp(parent->module, "brid") ||
				!strcmp(parent->module, "tun")))
			node->module = parent->module;
		return true;
	}
	return false;
}

/* Written as a member of the model, whatever the class. */
static enum tcs_status
stand_alone(struct composer *composer, uint32_t feature, unsigned class,
	struct tcs_fault *fault)
{
	struct node *node = &composer->nodes.at[feature];
	unsigned try = class;

	for (size_t n = 1; try != TCS_CLASS_Unknown; n++) {
		if (has_class(composer, try))
			break;
		try = candidate(composer, class, n);
	}
	if (try == TCS_CLASS_Unknown)
		try = shelter_class(composer);
	become(composer, node, try);
	node->property = SCHEMA_NONE;
	node->spread = try == TCS_CLASS_CityObjectGroup && class != try;
	if (array_grow(&composer->roots, 1))
		return fault_memory(fault);
	composer->roots.at[composer->roots.count++] = feature;
	return TCS_OK;
}

static bool
melts(unsigned class)
{
	for (size_t i = 0; i < sizeof only_around / sizeof *only_around; i++)
		if (only_around[i] == class)
			return true;
	return is_surface(class);
}

/* Installations that say they are inside have a class of their own in 2.0. */
static unsigned
class_of(const struct composer *composer, uint32_t feature)
{
	unsigned class = composer->object.features.at[feature].class;

	if (class >= TCS_CLASS_COUNT)
		class = TCS_CLASS_Unknown;
	if (compose_is_3(composer) || !composer->nodes.at[feature].inside)
		return class;
	switch (class) {
	case TCS_CLASS_BuildingInstallation:
		return TCS_CLASS_IntBuildingInstallation;
	case TCS_CLASS_BridgeInstallation:
		return TCS_CLASS_IntBridgeInstallation;
	case TCS_CLASS_TunnelInstallation:
		return TCS_CLASS_IntTunnelInstallation;
	default:
		return class;
	}
}

static enum tcs_status
note_class(struct composer *composer, uint32_t feature, const char *reason,
	struct tcs_fault *fault)
{
	const struct tcs_feature *given =
		&composer->object.features.at[feature];

	return compose_note(composer, REPORT_NOTE, label_of(given->class)->name,
		reason, compose_text(composer, given->id), fault);
}

/* Since 3.0 traffic areas bound a space, in which the traffic is. */
static unsigned
space_of(const struct composer *composer, unsigned class)
{
	if (!compose_is_3(composer) || composer->plan->from_3)
		return TCS_CLASS_Unknown;
	return class == TCS_CLASS_TrafficArea ? TCS_CLASS_TrafficSpace
		: class == TCS_CLASS_AuxiliaryTrafficArea
		? TCS_CLASS_AuxiliaryTrafficSpace
		: TCS_CLASS_Unknown;
}

/* Puts the space around a traffic area that the parent holds. */
static enum tcs_status
plan_space(struct composer *composer, uint32_t feature, struct tcs_fault *fault)
{
	const struct node *node = &composer->nodes.at[feature];
	unsigned space = space_of(composer, node->number);
	uint32_t parent = node->parent, around;
	enum tcs_status status;
	uint16_t property;

	if (space == TCS_CLASS_Unknown)
		return TCS_OK;
	property =
		schema_find_child(composer->nodes.at[parent].class, space, "");
	if (property == SCHEMA_NONE)
		return TCS_OK;
	status = shelter_add(composer, parent, property, space, &around, fault);
	if (status)
		return status;
	composer->nodes.at[around].host = composer->nodes.at[parent].host;
	composer->nodes.at[feature].parent = around;
	composer->nodes.at[feature].property =
		schema_find_child(composer->nodes.at[around].class,
			composer->nodes.at[feature].number, "");
	return TCS_OK;
}

/*
 * As its class asks, in its parent; what was a product of IFC first as the
 * surface it is before 3.0, and higher up where its parent has no place.
 */
static bool
hang_somewhere(struct composer *composer, uint32_t feature, unsigned class)
{
	struct node *node = &composer->nodes.at[feature];
	const char *role = compose_text(
		composer, composer->object.features.at[feature].role);
	uint32_t parent = node->parent;

	if (!element_is_ifc(composer, feature))
		return hang(composer, node, class, role);
	while (node->parent != TCS_NONE) {
		unsigned surface = element_surface(composer, feature);

		if ((surface && hang(composer, node, surface, role)) ||
			hang(composer, node, class, role))
			return true;
		if (label_of(class)->kind == LABEL_OPENING &&
			!compose_is_3(composer) &&
			hang(composer, node, TCS_CLASS_BuildingInstallation,
				role))
			return true;
		node->parent = composer->nodes.at[node->parent].parent;
	}
	node->parent = parent;
	return false;
}

/* A feature below another one. */
static enum tcs_status
plan_child(struct composer *composer, uint32_t feature, unsigned class,
	struct tcs_fault *fault)
{
	const struct tcs_feature *given =
		&composer->object.features.at[feature];
	struct node *node = &composer->nodes.at[feature];
	bool flat = node->flat &&
		schema_find(composer->nodes.at[node->parent].class,
			"lod0FootPrint") != SCHEMA_NONE;
	enum tcs_status status;

	if (!flat && hang_somewhere(composer, feature, class)) {
		if (node->number != given->class &&
			given->class != TCS_CLASS_Window &&
			given->class != TCS_CLASS_Door && !node->inside)
			status = note_class(composer, feature,
				"written as another class", fault);
		else
			status = TCS_OK;
		if (!status)
			status = plan_space(composer, feature, fault);
		if (status)
			return status;
		node = &composer->nodes.at[feature];
		return item_add(composer, node->parent, node->property,
			ITEM_CHILD, feature, fault);
	}
	if (flat || melts(class)) {
		node->melted = true;
		return note_class(composer, feature,
			"no such feature there: its geometry goes to what "
			"holds it",
			fault);
	}
	status = stand_alone(composer, feature, class, fault);
	if (!status)
		status = note_class(composer, feature,
			"no place in its parent: written as a city object",
			fault);
	return status;
}

static void
mark_inside(struct composer *composer)
{
	const struct tcs_object *object = &composer->object;

	for (size_t i = 0; i < object->attributes.count; i++) {
		const struct tcs_attribute *attribute =
			&object->attributes.at[i];

		if (attribute->parent == TCS_NONE &&
			!strcmp(compose_text(composer, attribute->name),
				"relationToConstruction") &&
			!strcmp(compose_text(composer, attribute->value),
				"inside"))
			composer->nodes.at[attribute->feature].inside = true;
	}
}

/* The written feature that a child of this one hangs in. */
static uint32_t
holder(const struct composer *composer, uint32_t feature)
{
	const struct node *node;

	if (feature == TCS_NONE)
		return TCS_NONE;
	node = &composer->nodes.at[feature];
	return node->melted || (node->spread && node->parent != TCS_NONE)
		? node->parent
		: feature;
}

/*
 * A group that stands for a storey keeps the parent the storey had, for its
 * children; it is written as a member all the same.
 */
static enum tcs_status
plan_feature(struct composer *composer, uint32_t feature, uint32_t above,
	struct tcs_fault *fault)
{
	struct node *node = &composer->nodes.at[feature];
	unsigned class = class_of(composer, feature);
	enum tcs_status status;

	node->parent = holder(composer, above);
	node->host = feature;
	if (node->parent == TCS_NONE)
		status = stand_alone(composer, feature, class, fault);
	else
		status = plan_child(composer, feature, class, fault);
	node = &composer->nodes.at[feature];
	if (node->parent != TCS_NONE && node->property != SCHEMA_NONE &&
		!node->melted && is_surface(node->number))
		node->host = composer->nodes.at[node->parent].host;
	return status;
}

static enum tcs_status
name_feature(
	struct composer *composer, uint32_t feature, struct tcs_fault *fault)
{
	const struct tcs_feature *given =
		&composer->object.features.at[feature];
	const char *wanted = compose_text(composer, given->id);
	struct node *node = &composer->nodes.at[feature];
	uint16_t generic;

	if (node->melted || (!*wanted && !compose_is_3(composer)))
		return TCS_OK;
	node->id = compose_id(composer, wanted);
	if (!*wanted || !strcmp(node->id, wanted))
		return TCS_OK;
	generic = schema_find_content(node->class, CONTENT_GENERIC);
	if (generic != SCHEMA_NONE) {
		enum tcs_status status = item_add(composer, feature, generic,
			ITEM_ORIGINAL_ID, feature, fault);

		if (status)
			return status;
	}
	return compose_note(composer, REPORT_NOTE, "id",
		"not legal or not unique: changed, kept as an attribute",
		wanted, fault);
}

static enum tcs_status
join_storey(struct composer *composer, uint32_t feature, uint32_t above,
	struct tcs_fault *fault)
{
	struct node *node = &composer->nodes.at[feature];
	uint16_t property;

	if (above == TCS_NONE || !composer->nodes.at[above].spread ||
		node->melted)
		return TCS_OK;
	property = schema_find_content(
		composer->nodes.at[above].class, CONTENT_MEMBER);
	if (property == SCHEMA_NONE)
		return TCS_OK;
	if (!node->id)
		node->id = compose_id(composer, "");
	return item_add(composer, above, property, ITEM_MEMBER, feature, fault);
}

/*
 * What was below a storey is a member of the group that stands for it; so is
 * in 3.0 what stood in a group itself.
 */
static enum tcs_status
join_group(struct composer *composer, uint32_t feature, struct tcs_fault *fault)
{
	uint32_t above = composer->object.features.at[feature].parent;
	struct node *node = &composer->nodes.at[feature];
	uint16_t property;

	if (above == TCS_NONE || node->melted ||
		composer->nodes.at[above].melted ||
		node->property != SCHEMA_NONE ||
		composer->nodes.at[above].number != TCS_CLASS_CityObjectGroup)
		return join_storey(composer, feature, above, fault);
	property = schema_find_content(
		composer->nodes.at[above].class, CONTENT_ROLE);
	if (property == SCHEMA_NONE)
		return TCS_OK;
	if (!node->id)
		node->id = compose_id(composer, "");
	return item_add(composer, above, property, ITEM_MEMBER, feature, fault);
}

/*
 * What fills an opening, and what is below such, comes behind all others: its
 * host must be there. `hosts` is changed to what each feature hangs in, and
 * `late` says which these are.
 */
static void
hosts_settle(const struct composer *composer, uint32_t *hosts, bool *late)
{
	const struct tcs_feature *features = composer->object.features.at;

	for (size_t i = 0; i < composer->object.features.count; i++) {
		uint32_t parent = features[i].parent;

		late[i] = hosts[i] != TCS_NONE ||
			(parent != TCS_NONE && late[parent]);
		if (hosts[i] == TCS_NONE)
			hosts[i] = parent;
	}
	for (size_t i = 0; i < composer->object.features.count; i++)
		if (hosts[i] != TCS_NONE && hosts[i] != features[i].parent &&
			late[hosts[i]])
			hosts[i] = features[i].parent;
}

/* Place every feature, a parent before its children. */
static enum tcs_status
plan_all(struct composer *composer, struct tcs_fault *fault)
{
	uint32_t count = (uint32_t)composer->object.features.count;
	uint32_t *hosts = calloc(count, sizeof *hosts);
	bool *late = calloc(count, sizeof *late);
	enum tcs_status status;

	if (!hosts || !late)
		status = fault_memory(fault);
	else
		status = elements_find_hosts(composer, hosts, fault);
	if (!status)
		hosts_settle(composer, hosts, late);
	for (int pass = 0; pass < 2; pass++)
		for (uint32_t i = 0; i < count && !status; i++)
			if (late[i] == (pass == 1))
				status = plan_feature(
					composer, i, hosts[i], fault);
	free(hosts);
	free(late);
	return status;
}

enum tcs_status
plan_features(struct composer *composer, struct tcs_fault *fault)
{
	uint32_t count = (uint32_t)composer->object.features.count;
	enum tcs_status status;

	array_clear(&composer->nodes);
	if (array_grow(&composer->nodes, count))
		return fault_memory(fault);
	memset(composer->nodes.at, 0, count * sizeof *composer->nodes.at);
	composer->nodes.count = count;
	mark_inside(composer);
	plan_view_mark(composer);
	status = plan_all(composer, fault);
	for (uint32_t i = 0; i < count && !status; i++)
		status = name_feature(composer, i, fault);
	for (uint32_t i = 0; i < count && !status; i++)
		status = join_group(composer, i, fault);
	for (uint32_t i = 0; i < count && !status; i++)
		status = shelter_say_part_of(composer, i, fault);
	return status;
}
