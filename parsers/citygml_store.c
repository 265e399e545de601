#include "citygml_store.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "citygml_keys.h"

/*
 * A paint in the file: this, then its texts, the matrix if there is one, and
 * for each ring its id and coordinates.
 */
struct stored_paint {
	uint64_t length; /* of all of it */
	uint32_t target_length, theme_length, source_length;
	uint32_t mapping_id_length, link_length;
	uint32_t material, image;
	uint32_t ring_count;
	uint32_t mapping;
	uint32_t back;
};

struct stored_ring {
	uint64_t id_length, length;
};

void
store_release(struct paint_store *store)
{
	if (store->file)
		fclose(store->file);
	array_release(&store->places);
	array_release(&store->mappings);
	array_release(&store->sources);
	for (size_t i = 0; i < store->aliases.count; i++) {
		free(store->aliases.at[i].source);
		free(store->aliases.at[i].theme);
	}
	array_release(&store->aliases);
	array_release(&store->bytes);
	*store = (struct paint_store){0};
}

/* ---- writing ---------------------------------------------------------------- */

static int
put(struct paint_store *store, const void *bytes, size_t length)
{
	if (array_grow(&store->bytes, length))
		return -1;
	if (length)
		memcpy(store->bytes.at + store->bytes.count, bytes, length);
	store->bytes.count += length;
	return 0;
}

static int
put_rings(struct paint_store *store, const struct raw_object *raw,
	const struct raw_paint *paint)
{
	for (uint32_t i = 0; i < paint->ring_count; i++) {
		const struct raw_texring *ring =
			&raw->texrings.at[paint->first_ring + i];
		const char *id = object_text(&raw->tree, ring->ring);
		struct stored_ring stored = {strlen(id), ring->length};

		if (put(store, &stored, sizeof stored) ||
			put(store, id, stored.id_length) ||
			put(store, raw->positions.at + ring->first,
				ring->length))
			return -1;
	}
	return 0;
}

static int
put_text(struct paint_store *store, const struct raw_object *raw, tcs_text text,
	uint32_t *length)
{
	const char *string = object_text(&raw->tree, text);

	*length = (uint32_t)strlen(string);
	return put(store, string, *length);
}

static int
put_paint(struct paint_store *store, const struct raw_object *raw,
	const struct raw_paint *paint)
{
	struct stored_paint stored = {
		.material = paint->material,
		.image = paint->image,
		.ring_count = paint->ring_count,
		.mapping = paint->mapping,
		.back = paint->back,
	};

	store->bytes.count = 0;
	if (put(store, &stored, sizeof stored) ||
		put_text(store, raw, paint->target, &stored.target_length) ||
		put_text(store, raw, paint->theme, &stored.theme_length) ||
		put_text(store, raw, paint->source, &stored.source_length) ||
		put_text(store, raw, paint->mapping_id,
			&stored.mapping_id_length) ||
		put_text(store, raw, paint->link, &stored.link_length) ||
		(paint->mapping == MAPPING_MATRIX &&
			put(store, &raw->texmatrices.at[paint->matrix],
				sizeof(struct raw_texmatrix))) ||
		put_rings(store, raw, paint))
		return -1;
	stored.length = store->bytes.count;
	memcpy(store->bytes.at, &stored, sizeof stored);
	return 0;
}

static uint64_t
store_hash(const struct paint_store *store, const char *id)
{
	return keyed_hash(&store->key, id, strlen(id));
}

static int
place_add(void *places, uint64_t hash, uint64_t at)
{
	TCS_ARRAY_TYPE(places, struct store_place) *to = places;

	if (array_grow(to, 1))
		return -1;
	to->at[to->count++] = (struct store_place){hash, at};
	return 0;
}

/* The ids of materials and textures, each once where its targets follow. */
static int
source_add(struct paint_store *store, const char *source)
{
	uint64_t hash = store_hash(store, source);
	size_t count = store->sources.count;

	if (!*source || (count && store->sources.at[count - 1] == hash))
		return 0;
	if (array_grow(&store->sources, 1))
		return -1;
	store->sources.at[store->sources.count++] = hash;
	return 0;
}

enum tcs_status
store_add(struct paint_store *store, const struct raw_object *raw,
	const struct raw_paint *paint, struct tcs_fault *fault)
{
	const char *target = object_text(&raw->tree, paint->target);
	const char *mapping_id = object_text(&raw->tree, paint->mapping_id);

	if (!store->file) {
		store->file = tmpfile();
		store->key = hash_key_new();
	}
	if (!store->file)
		return fault_system(fault, "cannot create", "a temporary file");
	if (put_paint(store, raw, paint) ||
		place_add(&store->places, store_hash(store, target),
			store->size) ||
		(*mapping_id &&
			place_add(&store->mappings,
				store_hash(store, mapping_id), store->size)) ||
		source_add(store, object_text(&raw->tree, paint->source)))
		return fault_memory(fault);
	if (fwrite(store->bytes.at, 1, store->bytes.count, store->file) !=
		store->bytes.count)
		return fault_system(fault, "cannot write", "a temporary file");
	store->size += store->bytes.count;
	return TCS_OK;
}

static int
compare_places(const void *a, const void *b)
{
	const struct store_place *one = a, *two = b;

	if (one->hash != two->hash)
		return one->hash < two->hash ? -1 : 1;
	return one->at < two->at ? -1 : one->at > two->at;
}

enum tcs_status
store_alias(struct paint_store *store, const char *theme, const char *source,
	struct tcs_fault *fault)
{
	struct store_alias alias = {strdup(source), strdup(theme)};

	if (!alias.source || !alias.theme || array_grow(&store->aliases, 1)) {
		free(alias.source);
		free(alias.theme);
		return fault_memory(fault);
	}
	store->aliases.at[store->aliases.count++] = alias;
	return TCS_OK;
}

static int
compare_aliases(const void *a, const void *b)
{
	const struct store_alias *one = a, *two = b;
	int order = strcmp(one->source, two->source);

	return order ? order : strcmp(one->theme, two->theme);
}

static int
compare_hashes(const void *a, const void *b)
{
	const uint64_t *one = a, *two = b;

	return *one < *two ? -1 : *one > *two;
}

static enum tcs_status
aliases_check(struct paint_store *store, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < store->aliases.count; i++) {
		const struct store_alias *alias = &store->aliases.at[i];
		uint64_t hash = store_hash(store, alias->source);

		if (!store->sources.count ||
			!bsearch(&hash, store->sources.at, store->sources.count,
				sizeof hash, compare_hashes))
			status = report_item(report, REPORT_SKIPPED,
				"appearance",
				"no global material or texture has the id it "
				"links to",
				alias->source, TCS_NOWHERE, fault);
		else if (i >= MOST_THEMES &&
			!strcmp(alias[-MOST_THEMES].source, alias->source))
			status = report_item(report, REPORT_SKIPPED,
				"appearance",
				"more than 64 themes share a material or "
				"texture",
				alias->source, TCS_NOWHERE, fault);
	}
	return status;
}

enum tcs_status
store_close(struct paint_store *store, struct report *report,
	struct tcs_fault *fault)
{
	if (store->file && fflush(store->file))
		return fault_system(fault, "cannot write", "a temporary file");
	if (store->places.count)
		qsort(store->places.at, store->places.count,
			sizeof *store->places.at, compare_places);
	if (store->mappings.count)
		qsort(store->mappings.at, store->mappings.count,
			sizeof *store->mappings.at, compare_places);
	if (store->sources.count)
		qsort(store->sources.at, store->sources.count,
			sizeof *store->sources.at, compare_hashes);
	if (store->aliases.count)
		qsort(store->aliases.at, store->aliases.count,
			sizeof *store->aliases.at, compare_aliases);
	return aliases_check(store, report, fault);
}

/* ---- reading ----------------------------------------------------------------- */

/* One paint read back: `at` moves through its bytes. */
struct taken {
	unsigned char *bytes;
	const unsigned char *at;
	struct stored_paint paint;
};

static int
read_at(const struct paint_store *store, uint64_t at, void *bytes,
	size_t length)
{
	unsigned char *to = bytes;

	while (length) {
		ssize_t got = pread(fileno(store->file), to, length, (off_t)at);

		if (got <= 0)
			return -1;
		to += got;
		at += (uint64_t)got;
		length -= (size_t)got;
	}
	return 0;
}

static enum tcs_status
taken_read(const struct paint_store *store, uint64_t at, struct taken *taken,
	struct tcs_fault *fault)
{
	*taken = (struct taken){0};
	if (read_at(store, at, &taken->paint, sizeof taken->paint))
		return fault_system(fault, "cannot read", "a temporary file");
	taken->bytes = malloc(taken->paint.length);
	if (!taken->bytes)
		return fault_memory(fault);
	if (read_at(store, at, taken->bytes, taken->paint.length)) {
		free(taken->bytes);
		return fault_system(fault, "cannot read", "a temporary file");
	}
	taken->at = taken->bytes + sizeof taken->paint;
	return TCS_OK;
}

static enum tcs_status
take_text(struct taken *taken, size_t length, struct raw_object *raw,
	tcs_text *out, struct tcs_fault *fault)
{
	const char *text = (const char *)taken->at;

	taken->at += length;
	return text_append(&raw->tree, text, length, out, fault);
}

static enum tcs_status
take_ring(struct taken *taken, struct raw_object *raw, struct tcs_fault *fault)
{
	struct stored_ring stored;
	struct raw_texring *ring;
	enum tcs_status status;

	memcpy(&stored, taken->at, sizeof stored);
	taken->at += sizeof stored;
	if (array_grow(&raw->texrings, 1) ||
		array_grow(&raw->positions, stored.length + 1))
		return fault_memory(fault);
	ring = &raw->texrings.at[raw->texrings.count++];
	*ring = (struct raw_texring){
		.first = raw->positions.count, .length = stored.length};
	status = take_text(taken, stored.id_length, raw, &ring->ring, fault);
	if (status)
		return status;
	memcpy(raw->positions.at + ring->first, taken->at, stored.length);
	raw->positions.count += stored.length;
	taken->at += stored.length;
	return TCS_OK;
}

static enum tcs_status
take_mapping(struct taken *taken, struct raw_object *raw,
	struct raw_paint *paint, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	paint->mapping = (uint8_t)taken->paint.mapping;
	paint->first_ring = (uint32_t)raw->texrings.count;
	paint->ring_count = taken->paint.ring_count;
	paint->matrix = (uint32_t)raw->texmatrices.count;
	if (paint->mapping == MAPPING_MATRIX) {
		if (array_grow(&raw->texmatrices, 1))
			return fault_memory(fault);
		memcpy(&raw->texmatrices.at[raw->texmatrices.count++],
			taken->at, sizeof(struct raw_texmatrix));
		taken->at += sizeof(struct raw_texmatrix);
	}
	for (uint32_t i = 0; !status && i < paint->ring_count; i++)
		status = take_ring(taken, raw, fault);
	return status;
}

static enum tcs_status
take_paint(struct taken *taken, struct raw_object *raw, tcs_text target,
	struct tcs_fault *fault)
{
	const struct stored_paint *stored = &taken->paint;
	struct raw_paint paint = {
		.target = target,
		.material = stored->material,
		.image = stored->image,
		.back = stored->back,
	};
	enum tcs_status status;

	taken->at += stored->target_length;
	status = take_text(
		taken, stored->theme_length, raw, &paint.theme, fault);
	if (!status)
		status = take_text(taken, stored->source_length, raw,
			&paint.source, fault);
	taken->at += stored->mapping_id_length;
	if (!status)
		status = take_text(
			taken, stored->link_length, raw, &paint.link, fault);
	if (!status)
		status = take_mapping(taken, raw, &paint, fault);
	if (status)
		return status;
	if (array_grow(&raw->paints, 1))
		return fault_memory(fault);
	raw->paints.at[raw->paints.count++] = paint;
	return TCS_OK;
}

static size_t
first_alias(const struct paint_store *store, const char *source)
{
	size_t low = 0, high = store->aliases.count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (strcmp(store->aliases.at[middle].source, source) < 0)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

/* The last paint again, for the other themes that show it. */
static enum tcs_status
take_aliases(const struct paint_store *store, struct raw_object *raw,
	struct tcs_fault *fault)
{
	struct raw_paint paint = raw->paints.at[raw->paints.count - 1];
	size_t first =
		first_alias(store, object_text(&raw->tree, paint.source));
	tcs_text own = paint.theme;

	if (!paint.source)
		return TCS_OK;
	for (size_t i = first;
		i < store->aliases.count && i - first < MOST_THEMES; i++) {
		const struct store_alias *alias = &store->aliases.at[i];
		enum tcs_status status;

		/* Appending may move the text. */
		if (strcmp(alias->source,
			    object_text(&raw->tree, paint.source)) != 0)
			break;
		if (!strcmp(alias->theme, object_text(&raw->tree, own)) ||
			(i > first && !compare_aliases(alias - 1, alias)))
			continue;
		status = text_append(&raw->tree, alias->theme,
			strlen(alias->theme), &paint.theme, fault);
		if (status)
			return status;
		if (array_grow(&raw->paints, 1))
			return fault_memory(fault);
		raw->paints.at[raw->paints.count++] = paint;
	}
	return TCS_OK;
}

static bool
taken_is_for(const struct taken *taken, const char *id)
{
	return strlen(id) == taken->paint.target_length &&
		!memcmp(taken->at, id, taken->paint.target_length);
}

static size_t
first_place(const struct store_place *places, size_t count, uint64_t hash)
{
	size_t low = 0, high = count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (places[middle].hash < hash)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

enum tcs_status
store_fetch(const struct paint_store *store, struct raw_object *raw,
	tcs_text target, struct tcs_fault *fault)
{
	uint64_t hash = store_hash(store, object_text(&raw->tree, target));
	enum tcs_status status = TCS_OK;

	for (size_t i = first_place(
		     store->places.at, store->places.count, hash);
		!status && i < store->places.count &&
		store->places.at[i].hash == hash;
		i++) {
		struct taken taken;

		status = taken_read(
			store, store->places.at[i].at, &taken, fault);
		if (status)
			return status;
		if (taken_is_for(&taken, object_text(&raw->tree, target))) {
			status = take_paint(&taken, raw, target, fault);
			if (!status)
				status = take_aliases(store, raw, fault);
		}
		free(taken.bytes);
	}
	return status;
}

/* Whether this is the mapping; then `at` stands where it begins. */
static bool
taken_is_mapping(struct taken *taken, const char *id)
{
	const struct stored_paint *stored = &taken->paint;
	bool is_it;

	taken->at += stored->target_length + stored->theme_length +
		stored->source_length;
	is_it = strlen(id) == stored->mapping_id_length &&
		!memcmp(taken->at, id, stored->mapping_id_length);
	taken->at += stored->mapping_id_length + stored->link_length;
	return is_it;
}

enum tcs_status
store_fetch_mapping(const struct paint_store *store, struct raw_object *raw,
	size_t paint, bool *found, struct tcs_fault *fault)
{
	tcs_text link = raw->paints.at[paint].link;
	uint64_t hash = store_hash(store, object_text(&raw->tree, link));
	enum tcs_status status = TCS_OK;

	*found = false;
	for (size_t i = first_place(
		     store->mappings.at, store->mappings.count, hash);
		!status && !*found && i < store->mappings.count &&
		store->mappings.at[i].hash == hash;
		i++) {
		struct taken taken;

		status = taken_read(
			store, store->mappings.at[i].at, &taken, fault);
		if (status)
			return status;
		*found =
			taken_is_mapping(&taken, object_text(&raw->tree, link));
		if (*found)
			status = take_mapping(
				&taken, raw, &raw->paints.at[paint], fault);
		free(taken.bytes);
	}
	return status;
}
