#include "gltf_numbers.h"

enum { CHUNK = 4096 };

/* Where the bytes will go that are about to be written to a part. */
static enum tcs_status
city_reserve(struct city *city, enum city_part part, uint64_t bytes,
	struct assembly_accessor *out, struct tcs_fault *fault)
{
	uint64_t at = city->parts[part].size;
	uint32_t *open = city->open + part;
	struct city_view *view;

	if (*open == TCS_NONE ||
		at + bytes - city->views.at[*open].start > CITY_VIEW) {
		if (array_grow(&city->views, 1))
			return fault_memory(fault);
		*open = (uint32_t)city->views.count;
		city->views.at[city->views.count++] =
			(struct city_view){part, at, at};
	}
	view = city->views.at + *open;
	out->view = *open;
	out->offset = at - view->start;
	view->end = at + bytes;
	return TCS_OK;
}

enum tcs_status
city_add_floats(struct city *city, enum city_part part, const float *values,
	size_t count, unsigned width, struct assembly_accessor *out,
	struct tcs_fault *fault)
{
	enum tcs_status status;

	out->component = ASSEMBLY_FLOAT;
	out->count = (uint32_t)(count / width);
	if (!count)
		return TCS_OK;
	status = city_reserve(city, part, count * sizeof *values, out, fault);
	return status ? status
		      : spool_write(city->parts + part, values,
				count * sizeof *values, fault);
}

enum tcs_status
city_add_ids(struct city *city, const uint32_t *features, size_t count,
	uint32_t base, uint32_t largest, struct assembly_accessor *out,
	struct tcs_fault *fault)
{
	bool is_short = largest <= UINT16_MAX;
	uint32_t shorts[CHUNK];
	float floats[CHUNK];
	const void *chunk = is_short ? (const void *)shorts : floats;
	enum tcs_status status;

	out->component = is_short ? ASSEMBLY_UNSIGNED_SHORT : ASSEMBLY_FLOAT;
	out->count = (uint32_t)count;
	status = city_reserve(city, CITY_IDS, count * 4, out, fault);
	for (size_t first = 0; first < count && !status; first += CHUNK) {
		size_t size = count - first < CHUNK ? count - first : CHUNK;

		for (size_t i = 0; i < size; i++) {
			uint32_t id =
				base + (features ? features[first + i] : 0);

			shorts[i] = id;
			floats[i] = (float)id;
		}
		status = spool_write(
			city->parts + CITY_IDS, chunk, size * 4, fault);
	}
	return status;
}

enum tcs_status
city_add_indices(struct city *city, const uint32_t *indices, size_t count,
	bool narrow, struct assembly_accessor *out, struct tcs_fault *fault)
{
	struct spool *spool = city->parts + CITY_INDICES;
	uint16_t shorts[CHUNK];
	size_t width = narrow ? sizeof *shorts : sizeof *indices;
	enum tcs_status status;

	out->component =
		narrow ? ASSEMBLY_UNSIGNED_SHORT : ASSEMBLY_UNSIGNED_INT;
	out->count = (uint32_t)count;
	status = spool_align(spool, 4, fault);
	if (!status)
		status = city_reserve(
			city, CITY_INDICES, count * width, out, fault);
	if (!status && !narrow)
		return spool_write(spool, indices, count * width, fault);
	for (size_t first = 0; first < count && !status; first += CHUNK) {
		size_t size = count - first < CHUNK ? count - first : CHUNK;

		for (size_t i = 0; i < size; i++)
			shorts[i] = (uint16_t)indices[first + i];
		status = spool_write(spool, shorts, size * width, fault);
	}
	return status;
}
