#include "citygml_library.h"

#include <stdlib.h>
#include <string.h>

/* ---- ids ------------------------------------------------------------------- */

void
index_release(struct id_index *index)
{
	array_release(&index->slots);
}

static uint32_t *
index_slot(const struct id_index *index, const struct raw_object *raw,
	const char *id)
{
	size_t mask = index->slots.count - 1;
	size_t i = (size_t)keyed_hash(&index->key, id, strlen(id)) & mask;

	while (index->slots.at[i]) {
		const struct raw_target *target =
			&raw->targets.at[index->slots.at[i] - 1];

		if (!strcmp(object_text(&raw->tree, target->id), id))
			break;
		i = (i + 1) & mask;
	}
	return &index->slots.at[i];
}

enum tcs_status
index_build(struct id_index *index, const struct raw_object *raw,
	struct tcs_fault *fault)
{
	size_t room = 16;

	while (room < raw->targets.count * 2)
		room *= 2;
	array_clear(&index->slots);
	if (array_grow(&index->slots, room))
		return fault_memory(fault);
	index->slots.count = room;
	index->key = hash_key_new();
	memset(index->slots.at, 0, room * sizeof *index->slots.at);
	for (size_t i = 0; i < raw->targets.count; i++) {
		uint32_t *slot = index_slot(index, raw,
			object_text(&raw->tree, raw->targets.at[i].id));

		if (!*slot)
			*slot = (uint32_t)i + 1;
	}
	return TCS_OK;
}

const struct raw_target *
index_find(const struct id_index *index, const struct raw_object *raw,
	const char *id)
{
	uint32_t found;

	if (!index->slots.count)
		return NULL;
	found = *index_slot(index, raw, id);
	return found ? &raw->targets.at[found - 1] : NULL;
}

/* ---- walking links ------------------------------------------------------------ */

#define MAX_LINK_DEPTH 32

struct walk_level {
	uint32_t next, end;
	uint32_t shell;
	bool reversed;
	bool linked;
};

enum tcs_status
members_walk(struct member_walk *walk, uint32_t first, uint32_t end,
	bool reversed, uint32_t shell, bool linked, struct tcs_fault *fault)
{
	struct walk_level levels[MAX_LINK_DEPTH];
	int depth = 0;

	levels[0] = (struct walk_level){first, end, shell, reversed, linked};
	while (depth >= 0) {
		struct walk_level *level = &levels[depth];
		const struct raw_member *member;
		const struct raw_target *target = NULL;
		uint32_t in_shell;
		bool turned;
		enum tcs_status status;

		if (level->next == level->end) {
			depth--;
			continue;
		}
		if (!walk->budget) {
			walk->exceeded = true;
			return TCS_OK;
		}
		walk->budget--;
		member = &walk->raw->members.at[level->next++];
		turned = level->reversed != member->reversed;
		in_shell =
			level->shell != TCS_NONE ? level->shell : member->shell;
		if (member->polygon == TCS_NONE && walk->index)
			target = index_find(walk->index, walk->raw,
				object_text(&walk->raw->tree, member->href));
		if (!target) {
			status = walk->take(walk->context, member, turned,
				in_shell, level->linked, fault);
			if (status)
				return status;
			continue;
		}
		if (depth + 1 == MAX_LINK_DEPTH) {
			walk->exceeded = true;
			continue;
		}
		levels[++depth] = (struct walk_level){target->first_member,
			target->member_end, in_shell,
			turned != target->reversed, true};
	}
	return TCS_OK;
}

/* ---- the library ------------------------------------------------------------------ */

void
library_release(struct raw_library *library)
{
	for (size_t i = 0; i < library->wanted.count; i++)
		free(library->wanted.at[i]);
	array_release(&library->wanted);
	raw_free(library->store);
	index_release(&library->index);
	*library = (struct raw_library){0};
}

enum tcs_status
library_want(
	struct raw_library *library, const char *id, struct tcs_fault *fault)
{
	if (array_grow(&library->wanted, 1))
		return fault_memory(fault);
	library->wanted.at[library->wanted.count] = strdup(id);
	if (!library->wanted.at[library->wanted.count])
		return fault_memory(fault);
	library->wanted.count++;
	return TCS_OK;
}

static int
compare_ids(const void *a, const void *b)
{
	return strcmp(*(char *const *)a, *(char *const *)b);
}

void
library_sort(struct raw_library *library)
{
	char **ids = library->wanted.at;
	size_t kept = 0;

	if (!library->wanted.count)
		return;
	qsort(ids, library->wanted.count, sizeof *ids, compare_ids);
	for (size_t i = 0; i < library->wanted.count; i++) {
		if (kept && !strcmp(ids[kept - 1], ids[i]))
			free(ids[i]);
		else
			ids[kept++] = ids[i];
	}
	library->wanted.count = kept;
}

static bool
library_wants(const struct raw_library *library, const char *id)
{
	return library->wanted.count &&
		bsearch(&id, library->wanted.at, library->wanted.count,
			sizeof *library->wanted.at, compare_ids);
}

static enum tcs_status
store_text(struct raw_library *library, const struct raw_object *from,
	tcs_text text, tcs_text *out, struct tcs_fault *fault)
{
	const char *string = object_text(&from->tree, text);

	return text_append(
		&library->store->tree, string, strlen(string), out, fault);
}

static enum tcs_status
store_ring(struct raw_library *library, const struct raw_object *from,
	const struct raw_ring *ring, struct tcs_fault *fault)
{
	struct raw_object *store = library->store;
	struct raw_ring *copy;

	if (array_grow(&store->rings, 1) ||
		array_grow(&store->positions, ring->length + 1))
		return fault_memory(fault);
	copy = &store->rings.at[store->rings.count++];
	*copy = *ring;
	copy->first = store->positions.count;
	if (ring->length)
		memcpy(store->positions.at + copy->first,
			from->positions.at + ring->first, ring->length);
	store->positions.count += ring->length;
	return store_text(library, from, ring->id, &copy->id, fault);
}

static enum tcs_status
store_polygon(struct raw_library *library, const struct raw_object *from,
	const struct raw_polygon *polygon, struct tcs_fault *fault)
{
	struct raw_object *store = library->store;
	struct raw_polygon *copy;
	enum tcs_status status;

	if (array_grow(&store->polygons, 1))
		return fault_memory(fault);
	copy = &store->polygons.at[store->polygons.count++];
	*copy = *polygon;
	copy->first_ring = (uint32_t)store->rings.count;
	copy->geometry = TCS_NONE;
	status = store_text(library, from, polygon->id, &copy->id, fault);
	for (uint32_t i = 0; !status && i < polygon->ring_count; i++)
		status = store_ring(library, from,
			&from->rings.at[polygon->first_ring + i], fault);
	return status;
}

struct store_context {
	struct raw_library *library;
	const struct raw_object *from;
};

static enum tcs_status
store_member(void *context, const struct raw_member *member, bool reversed,
	uint32_t shell, bool linked, struct tcs_fault *fault)
{
	struct store_context *to = context;
	struct raw_object *store = to->library->store;
	enum tcs_status status;

	(void)shell;
	(void)linked;
	if (member->polygon == TCS_NONE)
		return TCS_OK; /* dangles there, and is reported there */
	if (array_grow(&store->members, 1))
		return fault_memory(fault);
	status = store_polygon(to->library, to->from,
		&to->from->polygons.at[member->polygon], fault);
	if (status)
		return status;
	store->members.at[store->members.count++] = (struct raw_member){
		.polygon = (uint32_t)store->polygons.count - 1,
		.shell = TCS_NONE,
		.reversed = reversed,
	};
	return TCS_OK;
}

static enum tcs_status
store_target(struct raw_library *library, const struct raw_object *from,
	const struct id_index *index, const struct raw_target *target,
	struct tcs_fault *fault)
{
	struct raw_object *store = library->store;
	uint32_t first = (uint32_t)store->members.count;
	struct store_context context = {library, from};
	struct member_walk walk = {
		.raw = from,
		.index = index,
		.context = &context,
		.take = store_member,
		.budget = 64 + 16 * (uint64_t)from->members.count,
	};
	enum tcs_status status;
	tcs_text id;

	status = members_walk(&walk, target->first_member, target->member_end,
		target->reversed, TCS_NONE, false, fault);
	if (!status)
		status = store_text(library, from, target->id, &id, fault);
	if (status)
		return status;
	if (array_grow(&store->targets, 1))
		return fault_memory(fault);
	store->targets.at[store->targets.count++] = (struct raw_target){
		.id = id,
		.first_member = first,
		.member_end = (uint32_t)store->members.count,
	};
	return TCS_OK;
}

enum tcs_status
library_collect(struct raw_library *library, const struct raw_object *raw,
	struct tcs_fault *fault)
{
	struct id_index index = {0};
	enum tcs_status status = TCS_OK;

	if (!library->store)
		library->store = raw_new();
	if (!library->store)
		return fault_memory(fault);
	for (size_t i = 0; !status && i < raw->targets.count; i++) {
		const struct raw_target *target = &raw->targets.at[i];

		if (!library_wants(
			    library, object_text(&raw->tree, target->id)))
			continue;
		if (!index.slots.count)
			status = index_build(&index, raw, fault);
		if (!status)
			status = store_target(
				library, raw, &index, target, fault);
	}
	index_release(&index);
	return status;
}

enum tcs_status
library_close(struct raw_library *library, struct tcs_fault *fault)
{
	if (!library->store)
		return TCS_OK;
	return index_build(&library->index, library->store, fault);
}
