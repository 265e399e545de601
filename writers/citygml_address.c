/* Structured values as elements, and addresses between versions of xAL. */
#include <string.h>

#include "citygml_compose.h"

static const struct tcs_attribute *
attribute_at(const struct composer *composer, uint32_t index)
{
	return &composer->object.attributes.at[index];
}

static const char *
name_at(const struct composer *composer, uint32_t index)
{
	return compose_text(composer, attribute_at(composer, index)->name);
}

/* xAL 3 has its attributes in its namespace, but for these. */
static const char *
prefix_of(const struct composer *composer, const char *module, const char *name)
{
	static const char *const common[] = {"DateValidFrom", "DateValidTo",
		"Abbreviation", "DataQualityType", "ValidFrom", "ValidTo",
		"LanguageCode"};

	if (!strcmp(name, "href"))
		return "xlink:";
	if (!compose_is_3(composer) || strcmp(module, "xAL"))
		return "";
	for (size_t i = 0; i < sizeof common / sizeof *common; i++)
		if (!strcmp(name, common[i]))
			return "ct:";
	return "xAL:";
}

/* Names of XML attributes that an element has got. */
struct given {
	const char *names[32];
	size_t count;
};

/* Whether it may stand there: a legal name, for the first time. */
static bool
may_give(struct given *given, const char *name)
{
	const size_t most = sizeof given->names / sizeof *given->names;

	if (!id_is_legal(name) || strlen(name) > 100 ||
		!strcmp(name, "xmlns") || given->count == most)
		return false;
	for (size_t i = 0; i < given->count; i++)
		if (!strcmp(given->names[i], name))
			return false;
	given->names[given->count++] = name;
	return true;
}

static void
write_xml_attributes(struct composer *composer, uint32_t index,
	const char *module, struct given *given)
{
	struct markup *markup = &composer->out->markup;
	uint32_t member = composer->first_member.at[index];

	for (; member != TCS_NONE; member = composer->next_member.at[member]) {
		const char *name = name_at(composer, member);
		const char *value = compose_text(
			composer, attribute_at(composer, member)->value);
		char qualified[128];

		if (*name != '@' || !strcmp(name, "@id"))
			continue;
		if (!may_give(given, name + 1)) {
			compose_lose(composer, "attribute of an element",
				"its name is not legal or stands there twice",
				name);
			continue;
		}
		strcpy(qualified, prefix_of(composer, module, name + 1));
		strcat(qualified, name + 1);
		markup_attribute(markup, qualified, value);
	}
}

/* An address is a feature, and in 3.0 has an id. */
static void
write_id(struct composer *composer, uint32_t index, const char *module)
{
	uint32_t given = value_member(composer, index, "@id");
	const char *wanted = given == TCS_NONE
		? ""
		: compose_text(composer, attribute_at(composer, given)->value);
	bool is_feature = !strcmp(module, "core") &&
		!strcmp(name_at(composer, index), "Address");

	if (*wanted || (is_feature && compose_is_3(composer)))
		markup_attribute(&composer->out->markup, "gml:id",
			compose_id(composer, wanted));
}

static void
open_element(struct composer *composer, uint32_t index, const char *module)
{
	const struct tcs_attribute *attribute = attribute_at(composer, index);
	const char *name = name_at(composer, index);
	const char *unit = compose_text(composer, attribute->unit);
	const char *space = compose_text(composer, attribute->code_space);
	const char *value = compose_text(composer, attribute->value);
	struct markup *markup = &composer->out->markup;
	struct given given = {.count = 0};

	markup_start(markup, module, name);
	write_id(composer, index, module);
	if (*unit && may_give(&given, "uom"))
		markup_attribute(markup, "uom", unit);
	if (*space && may_give(&given, "codeSpace"))
		markup_attribute(markup, "codeSpace", space);
	write_xml_attributes(composer, index, module, &given);
	if (*value)
		markup_text(markup, value);
}

/* The points of an address stand behind its text. */
static void
close_element(struct composer *composer, uint32_t index, const char *module)
{
	const char *name = name_at(composer, index);
	uint32_t above = attribute_at(composer, index)->parent;

	if (!strcmp(name, "Address") && !strcmp(module, "core") &&
		above != TCS_NONE)
		address_points_write(composer, above);
	markup_end(&composer->out->markup, module, name);
}

static bool
is_element(const struct composer *composer, uint32_t index)
{
	return id_is_legal(name_at(composer, index)) &&
		*name_at(composer, index);
}

/* The next element at or behind a member; TCS_NONE for none. */
static uint32_t
next_element(struct composer *composer, uint32_t member)
{
	while (member != TCS_NONE && !is_element(composer, member)) {
		const char *name = name_at(composer, member);

		if (*name != '@')
			compose_lose(composer, "part of an attribute",
				"its name is not legal", name);
		member = composer->next_member.at[member];
	}
	return member;
}

static bool
is_xal(const struct composer *composer, uint32_t index)
{
	return !strcmp(name_at(composer, index), "xalAddress");
}

/* What is below an xalAddress belongs to xAL, the rest to `module`. */
void
members_write(struct composer *composer, uint32_t set, const char *module)
{
	uint32_t at = next_element(composer, composer->first_member.at[set]);
	uint32_t xal = is_xal(composer, set) ? set : TCS_NONE;

	while (at != TCS_NONE) {
		uint32_t below;

		open_element(composer, at, xal == TCS_NONE ? module : "xAL");
		below = next_element(composer, composer->first_member.at[at]);
		if (below != TCS_NONE) {
			if (xal == TCS_NONE && is_xal(composer, at))
				xal = at;
			at = below;
			continue;
		}
		for (;;) {
			uint32_t above = attribute_at(composer, at)->parent;

			if (at == xal)
				xal = TCS_NONE;
			close_element(
				composer, at, xal == TCS_NONE ? module : "xAL");
			below = next_element(
				composer, composer->next_member.at[at]);
			if (below != TCS_NONE || above == set)
				break;
			at = above;
		}
		at = below;
	}
}

/* ---- xAL 2.0 and 3.0 ------------------------------------------------------ */

/* The common part: where a name stands in 3.0, and what 2.0 calls it. */
static const struct {
	const char *around, *after, *before;
} parts[] = {
	{"Country", "NameElement", "CountryName"},
	{"AdministrativeArea", "NameElement", "AdministrativeAreaName"},
	{"Locality", "NameElement", "LocalityName"},
	{"Thoroughfare", "NameElement", "ThoroughfareName"},
	{"Thoroughfare", "Number", "ThoroughfareNumber"},
	{"PostCode", "Identifier", "PostalCodeNumber"},
};

enum { COUNTRY, AREA, LOCALITY, STREET, NUMBER, POST_CODE, PART_COUNT };

/* What stands behind a member of the tree below a set; TCS_NONE at the end. */
static uint32_t
next_below(const struct composer *composer, uint32_t at, uint32_t set)
{
	if (composer->first_member.at[at] != TCS_NONE)
		return composer->first_member.at[at];
	while (at != set && composer->next_member.at[at] == TCS_NONE)
		at = attribute_at(composer, at)->parent;
	return at == set ? TCS_NONE : composer->next_member.at[at];
}

/* The part that an attribute is; PART_COUNT for none. */
static size_t
part_of(const struct composer *composer, uint32_t index, bool from_3)
{
	uint32_t above = attribute_at(composer, index)->parent;
	const char *name = name_at(composer, index);
	size_t part = 0;

	while (part < PART_COUNT &&
		!(from_3 ? !strcmp(name, parts[part].after) &&
					!strcmp(name_at(composer, above),
						parts[part].around)
			 : !strcmp(name, parts[part].before)))
		part++;
	return part;
}

/* Fill in the parts; returns how many other leaves there are. */
static size_t
find_parts(const struct composer *composer, uint32_t set, bool from_3,
	const char *found[PART_COUNT])
{
	uint32_t at = next_below(composer, set, set);
	size_t others = 0;

	for (; at != TCS_NONE; at = next_below(composer, at, set)) {
		const char *value = compose_text(
			composer, attribute_at(composer, at)->value);
		size_t part = part_of(composer, at, from_3);

		if (!*value || *name_at(composer, at) == '@')
			continue;
		if (part < PART_COUNT && !found[part])
			found[part] = value;
		else
			others++;
	}
	return others;
}

static void
write_3(struct composer *composer, const char *const found[PART_COUNT])
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "xAL", "Address");
	for (size_t i = 0; i < PART_COUNT; i++) {
		bool with_last =
			i && !strcmp(parts[i].around, parts[i - 1].around);

		if (with_last || (!found[i] && !(i == STREET && found[NUMBER])))
			continue;
		markup_start(markup, "xAL", parts[i].around);
		if (found[i])
			markup_leaf(markup, "xAL", parts[i].after, found[i]);
		if (i == STREET && found[NUMBER])
			markup_leaf(markup, "xAL", "Number", found[NUMBER]);
		markup_end(markup, "xAL", parts[i].around);
	}
	markup_end(markup, "xAL", "Address");
}

static void
write_locality_2(struct composer *composer, const char *const found[PART_COUNT])
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "xAL", "Locality");
	markup_attribute(markup, "Type", "Town");
	if (found[LOCALITY])
		markup_leaf(markup, "xAL", "LocalityName", found[LOCALITY]);
	if (found[STREET] || found[NUMBER]) {
		markup_start(markup, "xAL", "Thoroughfare");
		markup_attribute(markup, "Type", "Street");
		if (found[NUMBER])
			markup_leaf(markup, "xAL", "ThoroughfareNumber",
				found[NUMBER]);
		if (found[STREET])
			markup_leaf(markup, "xAL", "ThoroughfareName",
				found[STREET]);
		markup_end(markup, "xAL", "Thoroughfare");
	}
	if (found[POST_CODE]) {
		markup_start(markup, "xAL", "PostalCode");
		markup_leaf(
			markup, "xAL", "PostalCodeNumber", found[POST_CODE]);
		markup_end(markup, "xAL", "PostalCode");
	}
	markup_end(markup, "xAL", "Locality");
}

static void
write_2(struct composer *composer, const char *const found[PART_COUNT])
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "xAL", "AddressDetails");
	markup_start(markup, "xAL", "Country");
	if (found[COUNTRY])
		markup_leaf(markup, "xAL", "CountryName", found[COUNTRY]);
	if (found[AREA]) {
		markup_start(markup, "xAL", "AdministrativeArea");
		markup_leaf(
			markup, "xAL", "AdministrativeAreaName", found[AREA]);
	}
	if (found[LOCALITY] || found[STREET] || found[NUMBER] ||
		found[POST_CODE])
		write_locality_2(composer, found);
	if (found[AREA])
		markup_end(markup, "xAL", "AdministrativeArea");
	markup_end(markup, "xAL", "Country");
	markup_end(markup, "xAL", "AddressDetails");
}

static void
convert(struct composer *composer, uint32_t index, uint32_t xal, bool from_3)
{
	const char *found[PART_COUNT] = {0};
	struct markup *markup = &composer->out->markup;

	find_parts(composer, xal, from_3, found);
	markup_start(markup, "core", "Address");
	write_id(composer, attribute_at(composer, xal)->parent, "core");
	markup_start(markup, "core", "xalAddress");
	if (from_3)
		write_2(composer, found);
	else
		write_3(composer, found);
	markup_end(markup, "core", "xalAddress");
	address_points_write(composer, index);
	markup_end(markup, "core", "Address");
}

/* The xAL of an address that is of the other version; TCS_NONE for none. */
static uint32_t
xal_to_convert(const struct composer *composer, uint32_t index)
{
	const char *theirs =
		compose_is_3(composer) ? "AddressDetails" : "Address";
	uint32_t address = value_member(composer, index, "Address");
	uint32_t xal = value_member(composer, address, "xalAddress");

	return xal != TCS_NONE &&
			value_member(composer, xal, theirs) != TCS_NONE
		? xal
		: TCS_NONE;
}

bool
address_is_shortened(const struct composer *composer, uint32_t index)
{
	const char *found[PART_COUNT] = {0};

	return xal_to_convert(composer, index) != TCS_NONE &&
		find_parts(composer, index, !compose_is_3(composer), found);
}

void
address_write(struct composer *composer, const struct item *item)
{
	const struct property *property = compose_property(composer, item);
	const char *module = compose_module(composer, item->feature, property);
	uint32_t xal = xal_to_convert(composer, item->index);

	markup_start(&composer->out->markup, module, property->name);
	if (xal != TCS_NONE)
		convert(composer, item->index, xal, !compose_is_3(composer));
	else
		members_write(composer, item->index, "core");
	markup_end(&composer->out->markup, module, property->name);
}
