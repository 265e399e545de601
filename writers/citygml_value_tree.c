/* Attributes as a tree, and what is looked for in it. */
#include <string.h>

#include "citygml_compose.h"

enum tcs_status
value_link_members(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	uint32_t count = (uint32_t)object->attributes.count;

	array_clear(&composer->first_member);
	array_clear(&composer->next_member);
	array_clear(&composer->last_member);
	if (array_grow(&composer->first_member, count) ||
		array_grow(&composer->next_member, count) ||
		array_grow(&composer->last_member, count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < count; i++) {
		uint32_t set = object->attributes.at[i].parent;

		composer->first_member.at[i] = TCS_NONE;
		composer->next_member.at[i] = TCS_NONE;
		if (set == TCS_NONE)
			continue;
		if (composer->first_member.at[set] == TCS_NONE)
			composer->first_member.at[set] = i;
		else
			composer->next_member
				.at[composer->last_member.at[set]] = i;
		composer->last_member.at[set] = i;
	}
	return TCS_OK;
}

uint32_t
value_member(const struct composer *composer, uint32_t set, const char *name)
{
	uint32_t member = composer->first_member.at[set];

	while (member != TCS_NONE &&
		strcmp(compose_text(composer,
			       composer->object.attributes.at[member].name),
			name))
		member = composer->next_member.at[member];
	return member;
}

/* "https://…", "urn:…", "../…", "#…"; else a target is called by its name. */
static bool
is_address(const char *target)
{
	return strpbrk(target, ":/#") != NULL;
}

const char *
value_external_target(
	const struct composer *composer, uint32_t set, bool *by_name)
{
	static const char *const inside[] = {
		"externalObject", "ExternalReference"};
	static const char *const names[] = {"uri", "targetResource", "name"};

	for (size_t i = 0; i < 3; i++) {
		uint32_t member = set;

		if (i < 2) {
			member = value_member(composer, set, inside[i]);
			if (member == TCS_NONE)
				continue;
		}
		for (size_t j = 0; j < 3; j++) {
			uint32_t at = value_member(composer, member, names[j]);
			const char *target;

			if (at == TCS_NONE)
				continue;
			target = compose_text(composer,
				composer->object.attributes.at[at].value);
			*by_name = j == 2 || (j == 1 && !is_address(target));
			return target;
		}
	}
	return NULL;
}

uint32_t
value_deep_member(
	const struct composer *composer, uint32_t set, const char *name)
{
	uint32_t inner = value_member(composer, set, "ExternalReference");

	return value_member(composer, inner == TCS_NONE ? set : inner, name);
}

const char *
value_role_target(
	const struct composer *composer, uint32_t set, const char **note)
{
	const struct tcs_attribute *attributes = composer->object.attributes.at;
	uint32_t role = value_member(composer, set, "Role");
	uint32_t member, href;

	if (role == TCS_NONE)
		return NULL;
	member = value_member(composer, role, "groupMember");
	if (member == TCS_NONE)
		return NULL;
	href = value_member(composer, member, "@href");
	role = value_member(composer, role, "role");
	*note = role == TCS_NONE
		? ""
		: compose_text(composer, attributes[role].value);
	return href == TCS_NONE
		? NULL
		: compose_text(composer, attributes[href].value);
}

bool
value_is_xml_attribute(const struct composer *composer, uint32_t member)
{
	return *compose_text(composer,
		       composer->object.attributes.at[member].name) == '@';
}

bool
value_has_elements(const struct composer *composer, uint32_t set)
{
	uint32_t member = composer->first_member.at[set];

	while (member != TCS_NONE && value_is_xml_attribute(composer, member))
		member = composer->next_member.at[member];
	return member != TCS_NONE;
}

uint32_t
value_measured(const struct composer *composer, uint32_t set)
{
	uint32_t inner = value_member(composer, set, "Height");

	return inner == TCS_NONE ? TCS_NONE
				 : value_member(composer, inner, "value");
}
