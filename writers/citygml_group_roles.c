/* Roles of members that stand in their group. */
#include <string.h>

#include "citygml_compose.h"

/* Per feature; both count from the first. */
struct group {
	uint32_t members; /* that stand in it */
	uint32_t roles;
	uint32_t next; /* attribute to look at for the next role */
	bool mixed; /* some are written as something else */
};

/* A groupMember with a role and nothing else: what stood in it is a feature. */
static const char *
role_of(const struct composer *composer, uint32_t index)
{
	const struct tcs_attribute *all = composer->object.attributes.at;
	const struct tcs_attribute *attribute = &all[index];
	uint32_t member = composer->first_member.at[index];

	if (attribute->parent != TCS_NONE || attribute->type != TCS_SET ||
		member == TCS_NONE ||
		composer->next_member.at[member] != TCS_NONE ||
		composer->object.features.at[attribute->feature].class !=
			TCS_CLASS_CityObjectGroup ||
		strcmp(compose_text(composer, attribute->name),
			"groupMember") ||
		strcmp(compose_text(composer, all[member].name), "@role"))
		return NULL;
	return compose_text(composer, all[member].value);
}

static bool
stands_in_group(const struct composer *composer, uint32_t feature)
{
	const struct tcs_feature *of = &composer->object.features.at[feature];

	return of->parent != TCS_NONE &&
		!strcmp(compose_text(composer, of->role), "groupMember");
}

/* In the group, or beside it and linked to. */
static bool
is_written_as_member(const struct composer *composer, uint32_t feature)
{
	const struct node *node = &composer->nodes.at[feature];

	if (node->melted)
		return false;
	return node->property == SCHEMA_NONE ||
		composer->nodes.at[node->parent]
			.class->properties[node->property]
			.content == CONTENT_MEMBER;
}

static bool
is_known(const struct group *group)
{
	return group->roles && group->roles == group->members && !group->mixed;
}

static void
count(const struct composer *composer, struct group *groups)
{
	const struct tcs_object *object = &composer->object;

	memset(groups, 0, object->features.count * sizeof *groups);
	for (uint32_t i = 0; i < object->features.count; i++) {
		if (!stands_in_group(composer, i))
			continue;
		groups[object->features.at[i].parent].members++;
		if (!is_written_as_member(composer, i))
			groups[object->features.at[i].parent].mixed = true;
	}
	for (uint32_t i = (uint32_t)object->attributes.count; i-- > 0;) {
		struct group *group = &groups[object->attributes.at[i].feature];

		if (role_of(composer, i)) {
			group->roles++;
			group->next = i;
		}
	}
}

enum tcs_status
value_find_roles(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	struct group *groups = arena_get(&composer->arena,
		(object->features.count + 1) * sizeof *groups);

	if (!groups)
		return fault_memory(fault);
	count(composer, groups);
	for (uint32_t i = 0; i < object->features.count; i++) {
		struct group *group;

		if (!stands_in_group(composer, i))
			continue;
		group = &groups[object->features.at[i].parent];
		if (!is_known(group))
			continue;
		while (!role_of(composer, group->next))
			group->next++;
		composer->nodes.at[i].note = role_of(composer, group->next++);
	}
	for (uint32_t i = 0; i < object->features.count; i++)
		composer->nodes.at[i].has_roles = is_known(&groups[i]);
	return TCS_OK;
}

bool
value_is_role(const struct composer *composer, uint32_t attribute)
{
	return role_of(composer, attribute) &&
		composer->nodes
			.at[composer->object.attributes.at[attribute].feature]
			.has_roles;
}
