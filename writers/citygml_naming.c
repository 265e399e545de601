/* The ids of what is written: legal, and each once. */
#include <stdio.h>
#include <string.h>

#include "citygml_compose.h"

static bool
define(struct composer *composer, const char *id)
{
	uint64_t hash = id_hash(&composer->plan->key, id);
	struct tcs_fault fault;
	bool added;

	if (composer->taken && id_set_has(composer->taken, hash))
		return false;
	if (id_set_add(&composer->ids, hash, &added, &fault) ||
		array_grow(&composer->out->defined, 1)) {
		composer->out->markup.failed = true;
		return true;
	}
	if (added)
		composer->out->defined.at[composer->out->defined.count++] =
			hash;
	return added;
}

/* "object_7": the id of an object that has none. */
static const char *
base_id(struct composer *composer, char room[32])
{
	if (composer->nodes.count && composer->nodes.at[0].id)
		return composer->nodes.at[0].id;
	snprintf(room, 32, "object_%llu", (unsigned long long)composer->number);
	return room;
}

/* "base_2", "base_3", … up to one that is free. */
static const char *
numbered(struct composer *composer, const char *base, const char *joint,
	uint64_t *number)
{
	size_t length = strlen(base) + strlen(joint) + 24;
	char *id = arena_get(&composer->arena, length);

	if (!id) {
		composer->out->markup.failed = true;
		return "";
	}
	do
		snprintf(id, length, "%s%s%llu", base, joint,
			(unsigned long long)++*number);
	while (!define(composer, id));
	return id;
}

/* "id_2", "id_3", …, from where it was left last time: with `taken`, by an
 * earlier object, for what is taken stays so. */
static const char *
another(struct composer *composer, const char *id)
{
	uint64_t *last = id_numbers_at(
		&composer->numbers, id_hash(&composer->plan->key, id));
	uint64_t number;
	const char *made;

	if (!last) {
		composer->out->markup.failed = true;
		return "";
	}
	number = *last ? *last : 1;
	made = numbered(composer, id, "_", &number);
	*last = number;
	return made;
}

const char *
compose_id(struct composer *composer, const char *wanted)
{
	const char *id;
	char room[32];

	if (!*wanted && !composer->nodes.count)
		return numbered(composer, base_id(composer, room), "_g",
			&composer->made);
	if (!*wanted) {
		const char *base = base_id(composer, room);

		if (base == room && define(composer, base)) {
			id = arena_copy(&composer->arena, base, strlen(base));
			if (id)
				return id;
			composer->out->markup.failed = true;
			return "";
		}
		return numbered(composer, base, "_g", &composer->made);
	}
	id = id_legal(wanted, &composer->arena);
	if (!id) {
		composer->out->markup.failed = true;
		return "";
	}
	return define(composer, id) ? id : another(composer, id);
}

const char *
compose_id_in(struct composer *composer, const struct tcs_geometry *geometry,
	tcs_text wanted)
{
	const char *original = compose_text(composer, wanted);
	size_t length = strlen(original) + sizeof "_lod9";
	char *id;

	if (!wanted || !(geometry->flags & TCS_GEOMETRY_SIMPLIFIED) ||
		geometry->lod > 4)
		return compose_id(composer, original);
	id = arena_get(&composer->arena, length);
	if (!id) {
		composer->out->markup.failed = true;
		return "";
	}
	snprintf(id, length, "%s_lod%u", original, geometry->lod);
	return compose_id(composer, id);
}
