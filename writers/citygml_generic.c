/* Generic attributes: typed, in sets, as each version writes them. */
#include <stdio.h>
#include <string.h>

#include "citygml_compose.h"

/* Per kind of generic attribute: its names, and what its value must be. */
static const struct {
	const char *before, *after; /* 3.0 */
	enum content content;
} kinds[] = {
	[TCS_STRING] = {"stringAttribute", "StringAttribute", CONTENT_STRING},
	[TCS_INTEGER] = {"intAttribute", "IntAttribute", CONTENT_INTEGER},
	[TCS_DOUBLE] = {"doubleAttribute", "DoubleAttribute", CONTENT_DOUBLE},
	[TCS_BOOLEAN] = {"stringAttribute", "StringAttribute", CONTENT_STRING},
	[TCS_DATE] = {"dateAttribute", "DateAttribute", CONTENT_DATE},
	[TCS_URI] = {"uriAttribute", "UriAttribute", CONTENT_URI},
	[TCS_MEASURE] = {"measureAttribute", "MeasureAttribute",
		CONTENT_MEASURE},
	[TCS_CODE] = {"stringAttribute", "CodeAttribute", CONTENT_CODE},
};

static bool
is_1_0(const struct composer *composer)
{
	return composer->plan->schema.version == GML_1_0;
}

static bool
is_set(const struct composer *composer, uint32_t attribute)
{
	return composer->first_member.at[attribute] != TCS_NONE;
}

/* The type it can be written as; a string at worst. */
static unsigned
type_of(struct composer *composer, const struct tcs_attribute *attribute)
{
	unsigned type = attribute->type;
	const char *value = compose_text(composer, attribute->value);
	const char *same;

	if (type == TCS_SET)
		return TCS_STRING;
	if (type == TCS_MEASURE && is_1_0(composer))
		type = TCS_DOUBLE;
	same = value_as(composer, attribute, kinds[type].content);
	return same && !strcmp(same, value) ? type : TCS_STRING;
}

/* In 3.0 members of a set hang by a property of another module. */
static const char *
module_of(bool inside)
{
	return inside ? "gen" : "core";
}

static void
start(struct composer *composer, bool inside, const char *before,
	const char *after, const char *name)
{
	struct markup *markup = &composer->out->markup;

	if (!compose_is_3(composer)) {
		markup_start(markup, "gen", before);
		markup_attribute(markup, "name", name);
		return;
	}
	markup_start(markup, module_of(inside), "genericAttribute");
	markup_start(markup, "gen", after);
	markup_leaf(markup, "gen", "name", name);
}

static void
finish(struct composer *composer, bool inside, const char *before,
	const char *after)
{
	struct markup *markup = &composer->out->markup;

	markup_end(markup, "gen", compose_is_3(composer) ? after : before);
	if (compose_is_3(composer))
		markup_end(markup, module_of(inside), "genericAttribute");
}

/* CityGML 1.0 has no sets: names tell where a member was, as they do of a
 * member that stands alone. */
static const char *
name_of(struct composer *composer, uint32_t index, bool inside)
{
	const struct tcs_attribute *attributes = composer->object.attributes.at;
	const char *name = compose_text(composer, attributes[index].name);
	const char *space = compose_text(composer, attributes[index].space);
	size_t length;
	char *text;

	if ((is_1_0(composer) || !inside) &&
		attributes[index].parent != TCS_NONE)
		space = compose_text(
			composer, attributes[attributes[index].parent].name);
	if (!*space)
		return name;
	length = strlen(space) + strlen(name) + 2;
	text = arena_get(&composer->arena, length);
	if (!text) {
		composer->out->markup.failed = true;
		return name;
	}
	snprintf(text, length, "%s:%s", space, name);
	return text;
}

static void
write_leaf(struct composer *composer, bool inside, uint32_t index,
	const char *name)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	unsigned type = type_of(composer, attribute);
	struct markup *markup = &composer->out->markup;
	const char *value = compose_text(composer, attribute->value);
	const char *space = compose_text(composer, attribute->code_space);

	start(composer, inside, kinds[type].before, kinds[type].after, name);
	markup_start(markup, "gen", "value");
	if (type == TCS_MEASURE)
		markup_attribute(
			markup, "uom", compose_text(composer, attribute->unit));
	if (type == TCS_CODE && *space && compose_is_3(composer))
		markup_attribute(markup, "codeSpace", space);
	if (*value)
		markup_text(markup, value);
	markup_end(markup, "gen", "value");
	finish(composer, inside, kinds[type].before, kinds[type].after);
}

static void
write_string(struct composer *composer, bool inside, const char *name,
	const char *value)
{
	start(composer, inside, "stringAttribute", "StringAttribute", name);
	markup_leaf(&composer->out->markup, "gen", "value", value);
	finish(composer, inside, "stringAttribute", "StringAttribute");
}

void
generic_write_string(
	struct composer *composer, const char *name, const char *value)
{
	write_string(composer, false, name, value);
}

/* A string "name:what", for what the element has no place for. */
static void
write_beside(struct composer *composer, bool inside, const char *name,
	const char *what, const char *value)
{
	size_t length = strlen(name) + strlen(what) + 2;
	char *text = arena_get(&composer->arena, length);

	if (!text) {
		composer->out->markup.failed = true;
		return;
	}
	snprintf(text, length, "%s:%s", name, what);
	write_string(composer, inside, text, value);
}

/* The unit of a measure where it is none there, the space of a code. */
static void
write_rest(struct composer *composer, bool inside, uint32_t index,
	const char *name)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	const char *unit = compose_text(composer, attribute->unit);
	const char *space = compose_text(composer, attribute->code_space);
	unsigned type = type_of(composer, attribute);

	if (*unit && type != TCS_MEASURE)
		write_beside(composer, inside, name, "uom", unit);
	if (*space && !(type == TCS_CODE && compose_is_3(composer)))
		write_beside(composer, inside, name, "codeSpace", space);
}

static void
enter(struct composer *composer, bool inside, uint32_t index)
{
	const struct tcs_attribute *attribute =
		&composer->object.attributes.at[index];
	const char *space = compose_text(composer, attribute->code_space);
	const char *name = name_of(composer, index, inside);
	const char *value = compose_text(composer, attribute->value);
	struct markup *markup = &composer->out->markup;

	if (!is_set(composer, index)) {
		write_leaf(composer, inside, index, name);
		write_rest(composer, inside, index, name);
		return;
	}
	if (!is_1_0(composer)) {
		start(composer, inside, "genericAttributeSet",
			"GenericAttributeSet", name);
		if (*space && compose_is_3(composer))
			markup_leaf(markup, "gen", "codeSpace", space);
		else if (*space)
			markup_attribute(markup, "codeSpace", space);
	}
	if (*value)
		write_string(composer, true, "value", value);
}

static void
leave(struct composer *composer, bool inside, uint32_t index)
{
	if (is_set(composer, index) && !is_1_0(composer))
		finish(composer, inside, "genericAttributeSet",
			"GenericAttributeSet");
}

void
generic_write(struct composer *composer, uint32_t attribute)
{
	uint32_t at = attribute;

	enter(composer, false, at);
	for (;;) {
		if (is_set(composer, at)) {
			at = composer->first_member.at[at];
			enter(composer, true, at);
			continue;
		}
		for (;;) {
			leave(composer, at != attribute, at);
			if (at == attribute)
				return;
			if (composer->next_member.at[at] != TCS_NONE)
				break;
			at = composer->object.attributes.at[at].parent;
		}
		at = composer->next_member.at[at];
		enter(composer, true, at);
	}
}
