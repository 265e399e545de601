/* Standard attributes: their place, and their value as the schema wants it. */
#include <string.h>

#include "citygml_compose.h"

/* ---- places --------------------------------------------------------------------- */

/* What an attribute is called in the other versions. */
static const struct {
	const char *before, *after; /* 3.0 */
} renamed[] = {
	{"yearOfConstruction", "dateOfConstruction"},
	{"yearOfDemolition", "dateOfDemolition"},
};

static const char *
name_in_version(const struct composer *composer, const char *name)
{
	for (size_t i = 0; i < sizeof renamed / sizeof *renamed; i++) {
		if (compose_is_3(composer) && !strcmp(name, renamed[i].before))
			return renamed[i].after;
		if (!compose_is_3(composer) && !strcmp(name, renamed[i].after))
			return renamed[i].before;
	}
	return name;
}

/* GML 3.2 lets a description say why there is none. */
static bool
may_be_nil(const struct composer *composer, const struct property *property)
{
	return compose_is_3(composer) && !strcmp(property->module, "gml") &&
		!strcmp(property->name, "description");
}

static bool
fits(struct composer *composer, uint32_t index, const struct property *property)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	const char *note;
	bool by_name;

	if (content_is_simple(property->content))
		return attribute->type == TCS_SET
			? may_be_nil(composer, property) &&
				!value_has_elements(composer, index)
			: value_as(composer, attribute, property->content) !=
				NULL;
	if (attribute->type != TCS_SET)
		return false;
	switch (property->content) {
	case CONTENT_EXTERNAL:
		return value_external_target(composer, index, &by_name) != NULL;
	case CONTENT_ADDRESS:
		return value_member(composer, index, "Address") != TCS_NONE;
	case CONTENT_MEMBER:
	case CONTENT_ROLE:
		return value_role_target(composer, index, &note) != NULL;
	case CONTENT_SET:
	case CONTENT_GRID:
		return value_has_elements(composer, index);
	default:
		return false;
	}
}

static bool
take(struct composer *composer, uint32_t feature, uint16_t property)
{
	struct node *node = &composer->nodes.at[feature];

	if (property == SCHEMA_NONE ||
		(!node->class->properties[property].many &&
			(node->taken >> property & 1)))
		return false;
	node->taken |= (uint64_t)1 << property;
	return true;
}

/* measuredHeight and con:height are each other's. */
static bool
place_height(struct composer *composer, uint32_t index, const char *name,
	uint16_t *property, enum item_kind *kind)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	const struct schema_class *class =
		composer->nodes.at[attribute->feature].class;

	if (compose_is_3(composer) && !strcmp(name, "measuredHeight")) {
		*property = schema_find(class, "height");
		*kind = ITEM_HEIGHT;
		return *property != SCHEMA_NONE &&
			class->properties[*property].content == CONTENT_SET &&
			value_as(composer, attribute, CONTENT_MEASURE);
	}
	if (!compose_is_3(composer) && !strcmp(name, "height") &&
		attribute->type == TCS_SET) {
		uint32_t value = value_measured(composer, index);

		*property = schema_find(class, "measuredHeight");
		*kind = ITEM_MEASURED;
		return value != TCS_NONE &&
			value_as(composer,
				&composer->object.attributes.at[value],
				CONTENT_MEASURE) &&
			take(composer, attribute->feature, *property);
	}
	return false;
}

static const char no_place[] = "no standard place: written as a generic one";

/* With the reason why, unless it was one before. */
static enum tcs_status
place_generic(struct composer *composer, uint32_t index, const char *reason,
	struct tcs_fault *fault)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	uint32_t feature = compose_written(composer, attribute->feature);
	uint16_t property = schema_find_content(
		composer->nodes.at[feature].class, CONTENT_GENERIC);
	const char *name = compose_text(composer, attribute->name);
	enum tcs_status status = TCS_OK;

	if (property == SCHEMA_NONE)
		return compose_note(composer, REPORT_SKIPPED, "attribute",
			"its feature has no place for it", name, fault);
	if (reason)
		status = compose_note(composer, REPORT_NOTE, "attribute",
			reason, name, fault);
	if (status)
		return status;
	return item_add(
		composer, feature, property, ITEM_GENERIC, index, fault);
}

static bool
is_said_by_class(
	const struct composer *composer, uint32_t feature, const char *name)
{
	return !compose_is_3(composer) && composer->nodes.at[feature].inside &&
		!strcmp(name, "relationToConstruction");
}

/* XML attributes that the element may not have stand beside it. */
static enum tcs_status
place_xml_attributes(struct composer *composer, uint32_t index,
	const struct property *property, struct tcs_fault *fault)
{
	uint32_t member = composer->first_member.at[index];
	bool nil = may_be_nil(composer, property);
	enum tcs_status status = TCS_OK;

	if (property->content == CONTENT_MEMBER ||
		property->content == CONTENT_ROLE)
		return TCS_OK;
	for (; member != TCS_NONE && !status;
		member = composer->next_member.at[member]) {
		const char *name = compose_text(
			composer, composer->object.attributes.at[member].name);

		if (value_is_xml_attribute(composer, member) &&
			strcmp(name, "@id") &&
			!(nil && !strcmp(name, "@nilReason")))
			status = place_generic(
				composer, member, no_place, fault);
	}
	return status;
}

/* A code space: 1.0 has it for names only, and most values nowhere. */
static bool
may_have_space(const struct composer *composer, const struct property *property)
{
	return property->content == CONTENT_CODE &&
		(composer->plan->schema.version != GML_1_0 ||
			!strcmp(property->module, "gml"));
}

/* Whether its place takes only a part of it. */
static bool
is_shortened(const struct composer *composer, uint32_t index,
	const struct property *property)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];

	if (property->content == CONTENT_ADDRESS)
		return address_is_shortened(composer, index);
	if (property->content == CONTENT_EXTERNAL)
		return !compose_is_3(composer) &&
			value_deep_member(composer, index, "relationType") !=
			TCS_NONE;
	if (!content_is_simple(property->content))
		return false;
	return (attribute->code_space && !may_have_space(composer, property)) ||
		value_is_shortened(composer, attribute, property->content);
}

static enum tcs_status
place_standard(
	struct composer *composer, uint32_t index, struct tcs_fault *fault)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	uint32_t feature = attribute->feature;
	const struct schema_class *class = composer->nodes.at[feature].class;
	const char *name = compose_text(composer, attribute->name);
	enum item_kind kind = ITEM_ATTRIBUTE;
	enum tcs_status status;
	uint16_t property;

	if (is_said_by_class(composer, feature, name))
		return TCS_OK;
	if (place_height(composer, index, name, &property, &kind))
		return item_add(
			composer, feature, property, kind, index, fault);
	property = schema_find(class, name_in_version(composer, name));
	if (property == SCHEMA_NONE ||
		!fits(composer, index, &class->properties[property]) ||
		!take(composer, feature, property))
		return place_generic(composer, index, no_place, fault);
	if (class->properties[property].content == CONTENT_ADDRESS) {
		if (array_grow(&composer->addresses, 1))
			return fault_memory(fault);
		composer->addresses.at[composer->addresses.count++] =
			(struct address){index, TCS_NONE};
	}
	if (is_shortened(composer, index, &class->properties[property])) {
		status = place_generic(composer, index, no_place, fault);
		if (status)
			return status;
	}
	status = place_xml_attributes(
		composer, index, &class->properties[property], fault);
	return status ? status
		      : item_add(composer, feature, property, ITEM_ATTRIBUTE,
				index, fault);
}

static enum tcs_status
place_attribute(
	struct composer *composer, uint32_t index, struct tcs_fault *fault)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];

	if (attribute->parent != TCS_NONE || value_is_role(composer, index))
		return TCS_OK;
	if (composer->nodes.at[attribute->feature].melted)
		return place_generic(composer, index,
			"its feature is not written: a generic one of what "
			"holds it",
			fault);
	if (attribute->flags & TCS_ATTRIBUTE_GENERIC)
		return place_generic(composer, index, NULL, fault);
	if (*compose_text(composer, attribute->space))
		return place_generic(composer, index, no_place, fault);
	return place_standard(composer, index, fault);
}

/* A name with a code space stands among the attributes too. */
static bool
name_is_attribute(
	const struct composer *composer, uint32_t feature, uint32_t *at)
{
	const struct tcs_object *object = &composer->object;
	const char *name =
		compose_text(composer, object->features.at[feature].name);
	bool found = false;

	while (*at < object->attributes.count &&
		object->attributes.at[*at].feature <= feature) {
		const struct tcs_attribute *attribute =
			&object->attributes.at[(*at)++];

		found |= attribute->feature == feature &&
			attribute->parent == TCS_NONE &&
			attribute->code_space &&
			!(attribute->flags & TCS_ATTRIBUTE_GENERIC) &&
			!strcmp(compose_text(composer, attribute->name),
				"name") &&
			!strcmp(compose_text(composer, attribute->value), name);
	}
	return found;
}

static enum tcs_status
place_feature(struct composer *composer, uint32_t feature, bool name,
	struct tcs_fault *fault)
{
	const struct node *node = &composer->nodes.at[feature];
	uint16_t property;

	if (node->melted)
		return TCS_OK;
	if (name) {
		enum tcs_status status;

		property = schema_find(node->class, "name");
		if (property == SCHEMA_NONE)
			return TCS_OK;
		status = item_add(
			composer, feature, property, ITEM_NAME, feature, fault);
		if (status)
			return status;
	}
	switch (composer->object.features.at[feature].class) {
	case TCS_CLASS_IntBuildingInstallation:
	case TCS_CLASS_IntBridgeInstallation:
	case TCS_CLASS_IntTunnelInstallation:
		property = schema_find_content(node->class, CONTENT_RELATION);
		if (property != SCHEMA_NONE && !node->inside)
			return item_add(composer, feature, property,
				ITEM_INSIDE, feature, fault);
		return TCS_OK;
	default:
		return TCS_OK;
	}
}

enum tcs_status
values_place(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	enum tcs_status status = value_link_members(composer, fault);
	uint32_t at = 0;

	if (!status)
		status = value_find_roles(composer, fault);

	for (uint32_t i = 0; i < object->features.count && !status; i++) {
		bool twice = name_is_attribute(composer, i, &at);

		status = place_feature(composer, i,
			object->features.at[i].name && !twice, fault);
	}
	for (uint32_t i = 0; i < object->attributes.count && !status; i++)
		status = place_attribute(composer, i, fault);
	return status;
}

/* ---- writing -------------------------------------------------------------------- */

static void
write_nil_reason(struct composer *composer, uint32_t attribute)
{
	uint32_t reason = value_member(composer, attribute, "@nilReason");

	if (reason != TCS_NONE)
		markup_attribute(&composer->out->markup, "nilReason",
			compose_text(composer,
				composer->object.attributes.at[reason].value));
}

static void
write_simple(struct composer *composer, uint32_t index, const char *module,
	const struct property *property)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	struct markup *markup = &composer->out->markup;
	const char *value = attribute->type == TCS_SET
		? NULL
		: value_as(composer, attribute, property->content);
	const char *unit = compose_text(composer, attribute->unit);
	const char *space = compose_text(composer, attribute->code_space);

	markup_start(markup, module, property->name);
	if ((property->content == CONTENT_MEASURE ||
		    property->content == CONTENT_MEASURES))
		markup_attribute(markup, "uom", unit);
	else if (*space && may_have_space(composer, property))
		markup_attribute(markup, "codeSpace", space);
	if (may_be_nil(composer, property))
		write_nil_reason(composer, index);
	if (value && *value)
		markup_text(markup, value);
	markup_end(markup, module, property->name);
}

static void
write_external(struct composer *composer, uint32_t set)
{
	struct markup *markup = &composer->out->markup;
	uint32_t system = value_deep_member(composer, set, "informationSystem");
	uint32_t relation = value_deep_member(composer, set, "relationType");
	const struct tcs_attribute *attributes = composer->object.attributes.at;
	bool by_name = false, is_3 = compose_is_3(composer);
	const char *target = value_external_target(composer, set, &by_name);
	const char *value = system == TCS_NONE
		? NULL
		: compose_text(composer, attributes[system].value);

	markup_start(markup, "core", "externalReference");
	if (is_3) {
		markup_start(markup, "core", "ExternalReference");
		markup_leaf(markup, "core", "targetResource", target);
	}
	if (value)
		markup_leaf(markup, "core", "informationSystem", value);
	if (is_3) {
		if (relation != TCS_NONE)
			markup_leaf(markup, "core", "relationType",
				compose_text(
					composer, attributes[relation].value));
		markup_end(markup, "core", "ExternalReference");
	} else {
		markup_start(markup, "core", "externalObject");
		markup_leaf(markup, "core", by_name ? "name" : "uri", target);
		markup_end(markup, "core", "externalObject");
	}
	markup_end(markup, "core", "externalReference");
}

static void
write_height(struct composer *composer, const struct tcs_attribute *attribute)
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "con", "height");
	markup_start(markup, "con", "Height");
	markup_leaf(markup, "con", "highReference", "highestRoofEdge");
	markup_leaf(markup, "con", "lowReference", "lowestGroundPoint");
	markup_leaf(markup, "con", "status", "measured");
	markup_start(markup, "con", "value");
	markup_attribute(
		markup, "uom", compose_text(composer, attribute->unit));
	markup_text(markup, compose_text(composer, attribute->value));
	markup_end(markup, "con", "value");
	markup_end(markup, "con", "Height");
	markup_end(markup, "con", "height");
}

void
value_write(struct composer *composer, const struct item *item)
{
	const struct property *property = compose_property(composer, item);
	const char *module = compose_module(composer, item->feature, property);
	const struct tcs_attribute *attributes = composer->object.attributes.at;
	struct markup *markup = &composer->out->markup;
	const char *target, *note;

	if (item->kind == ITEM_HEIGHT) {
		write_height(composer, &attributes[item->index]);
		return;
	}
	if (item->kind == ITEM_MEASURED) {
		write_simple(composer, value_measured(composer, item->index),
			module, property);
		return;
	}
	switch (property->content) {
	case CONTENT_EXTERNAL:
		write_external(composer, item->index);
		return;
	case CONTENT_ADDRESS:
		address_write(composer, item);
		return;
	case CONTENT_MEMBER:
	case CONTENT_ROLE:
		target = value_role_target(composer, item->index, &note);
		target += *target == '#';
		link_write(composer, item, target, note);
		return;
	case CONTENT_SET:
	case CONTENT_GRID:
		markup_start(markup, module, property->name);
		members_write(composer, item->index,
			property->content == CONTENT_GRID ? "gml"
							  : property->inner);
		markup_end(markup, module, property->name);
		return;
	default:
		write_simple(composer, item->index, module, property);
	}
}
