#include "citygml_store.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "citygml_keys.h"

/*
 * A paint in the file: this, then the target, the theme, the matrix if there
 * is one, and for each ring its id and coordinates.
 */
struct stored_paint {
	uint64_t length; /* of all of it */
	uint32_t target_length, theme_length;
	uint32_t material, image;
	uint32_t ring_count;
	uint32_t mapping;
	uint32_t back;
	uint32_t reserved;
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
put_paint(struct paint_store *store, const struct raw_object *raw,
	const struct raw_paint *paint)
{
	const char *target = object_text(&raw->tree, paint->target);
	const char *theme = object_text(&raw->tree, paint->theme);
	struct stored_paint stored = {
		.target_length = (uint32_t)strlen(target),
		.theme_length = (uint32_t)strlen(theme),
		.material = paint->material,
		.image = paint->image,
		.ring_count = paint->ring_count,
		.mapping = paint->mapping,
		.back = paint->back,
	};

	store->bytes.count = 0;
	if (put(store, &stored, sizeof stored) ||
		put(store, target, stored.target_length) ||
		put(store, theme, stored.theme_length) ||
		(paint->mapping == MAPPING_MATRIX &&
			put(store, &raw->texmatrices.at[paint->matrix],
				sizeof(struct raw_texmatrix))) ||
		put_rings(store, raw, paint))
		return -1;
	stored.length = store->bytes.count;
	memcpy(store->bytes.at, &stored, sizeof stored);
	return 0;
}

enum tcs_status
store_add(struct paint_store *store, const struct raw_object *raw,
	const struct raw_paint *paint, struct tcs_fault *fault)
{
	if (!store->file)
		store->file = tmpfile();
	if (!store->file)
		return fault_system(fault, "cannot create", "a temporary file");
	if (put_paint(store, raw, paint) || array_grow(&store->places, 1))
		return fault_memory(fault);
	store->places.at[store->places.count++] = (struct store_place){
		key_hash(object_text(&raw->tree, paint->target)), store->size};
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
store_close(struct paint_store *store, struct tcs_fault *fault)
{
	if (!store->file)
		return TCS_OK;
	if (fflush(store->file))
		return fault_system(fault, "cannot write", "a temporary file");
	qsort(store->places.at, store->places.count, sizeof *store->places.at,
		compare_places);
	return TCS_OK;
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
take_paint(struct taken *taken, struct raw_object *raw, tcs_text target,
	struct tcs_fault *fault)
{
	const struct stored_paint *stored = &taken->paint;
	struct raw_paint paint = {
		.target = target,
		.material = stored->material,
		.image = stored->image,
		.first_ring = (uint32_t)raw->texrings.count,
		.ring_count = stored->ring_count,
		.matrix = (uint32_t)raw->texmatrices.count,
		.mapping = (uint8_t)stored->mapping,
		.back = stored->back,
	};
	enum tcs_status status;

	taken->at += stored->target_length;
	status = take_text(
		taken, stored->theme_length, raw, &paint.theme, fault);
	if (!status && stored->mapping == MAPPING_MATRIX) {
		if (array_grow(&raw->texmatrices, 1))
			return fault_memory(fault);
		memcpy(&raw->texmatrices.at[raw->texmatrices.count++],
			taken->at, sizeof(struct raw_texmatrix));
		taken->at += sizeof(struct raw_texmatrix);
	}
	for (uint32_t i = 0; !status && i < stored->ring_count; i++)
		status = take_ring(taken, raw, fault);
	if (status)
		return status;
	if (array_grow(&raw->paints, 1))
		return fault_memory(fault);
	raw->paints.at[raw->paints.count++] = paint;
	return TCS_OK;
}

static bool
taken_is_for(const struct taken *taken, const char *id)
{
	return strlen(id) == taken->paint.target_length &&
		!memcmp(taken->at, id, taken->paint.target_length);
}

static size_t
first_place(const struct paint_store *store, uint64_t hash)
{
	size_t low = 0, high = store->places.count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (store->places.at[middle].hash < hash)
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
	uint64_t hash = key_hash(object_text(&raw->tree, target));
	enum tcs_status status = TCS_OK;

	for (size_t i = first_place(store, hash); !status &&
		i < store->places.count && store->places.at[i].hash == hash;
		i++) {
		struct taken taken;

		status = taken_read(
			store, store->places.at[i].at, &taken, fault);
		if (status)
			return status;
		if (taken_is_for(&taken, object_text(&raw->tree, target)))
			status = take_paint(&taken, raw, target, fault);
		free(taken.bytes);
	}
	return status;
}
