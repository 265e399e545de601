#include "json_build.h"

#include <string.h>

#include "base64.h"

static const char *const none[] = {NULL};

void
json_builder_release(struct json_builder *builder)
{
	head_release(&builder->head);
	palette_release(&builder->palette);
	object_release(&builder->object);
}

/* Every key of the line is "record" or listed. */
static enum tcs_status
check_keys(
	struct json_place *place, const json_t *line, const char *const *listed)
{
	const char *key;
	json_t *value;

	json_object_foreach((json_t *)(uintptr_t)line, key, value)
	{
		const char *const *name = listed;

		while (*name && strcmp(*name, key) != 0)
			name++;
		if (!*name && strcmp(key, "record") != 0)
			return json_fault(place, key, "no such key here");
	}
	return TCS_OK;
}

/* ---- head ------------------------------------------------------------ */

static enum tcs_status
build_crs(struct json_place *place, const json_t *line, struct tcs_head *head)
{
	struct tcs_crs crs;
	enum tcs_status status;

	json_enter(place, "crs", JSON_NO_INDEX);
	status = json_get_fields(place, json_object_get(line, "crs"),
		&fields_crs, none, &crs, &head->text);
	json_leave(place);
	if (status)
		return status;
	if (array_grow(&head->crs, 1))
		return fault_memory(place->fault);
	head->crs.at[head->crs.count++] = crs;
	return TCS_OK;
}

static enum tcs_status
build_sources(
	struct json_place *place, const json_t *line, struct tcs_head *head)
{
	const json_t *array;
	enum tcs_status status = json_get_array(place, line, "sources", &array);

	for (size_t i = 0; !status && i < json_array_size(array); i++) {
		struct tcs_source source;

		json_enter(place, "sources", i);
		status = json_get_fields(place, json_array_get(array, i),
			&fields_source, none, &source, &head->text);
		json_leave(place);
		if (status)
			break;
		if (array_grow(&head->sources, 1))
			return fault_memory(place->fault);
		head->sources.at[head->sources.count++] = source;
	}
	return status;
}

static enum tcs_status
build_models(
	struct json_place *place, const json_t *line, struct tcs_head *head)
{
	const json_t *array;
	enum tcs_status status = json_get_array(place, line, "models", &array);

	for (size_t i = 0; !status && i < json_array_size(array); i++) {
		struct tcs_model model;

		json_enter(place, "models", i);
		status = json_get_fields(place, json_array_get(array, i),
			&fields_model, none, &model, &head->text);
		json_leave(place);
		if (status)
			break;
		if (array_grow(&head->models, 1))
			return fault_memory(place->fault);
		head->models.at[head->models.count++] = model;
	}
	return status;
}

static enum tcs_status
build_stages(
	struct json_place *place, const json_t *line, struct tcs_head *head)
{
	const json_t *array;
	enum tcs_status status = json_get_array(place, line, "stages", &array);

	for (size_t i = 0; !status && i < json_array_size(array); i++) {
		struct tcs_stage stage;

		json_enter(place, "stages", i);
		status = json_get_fields(place, json_array_get(array, i),
			&fields_stage, none, &stage, &head->text);
		json_leave(place);
		if (status)
			break;
		if (array_grow(&head->stages, 1))
			return fault_memory(place->fault);
		head->stages.at[head->stages.count++] = stage;
	}
	return status;
}

static enum tcs_status
build_head(struct json_place *place, const json_t *line, struct tcs_head *head,
	struct tcs_record *record)
{
	static const char *const keys[] = {
		"crs", "sources", "models", "stages", NULL};
	enum tcs_status status = check_keys(place, line, keys);

	array_clear(&head->text);
	array_clear(&head->crs);
	array_clear(&head->sources);
	array_clear(&head->models);
	array_clear(&head->stages);
	if (!status)
		status = build_crs(place, line, head);
	if (!status)
		status = build_sources(place, line, head);
	if (!status)
		status = build_models(place, line, head);
	if (!status)
		status = build_stages(place, line, head);
	return status ? status : head_encode(head, record, place->fault);
}

/* ---- palette --------------------------------------------------------- */

static enum tcs_status
append_base64(struct json_place *place, const json_t *value, void *byte_array,
	uint64_t *appended)
{
	struct tcs_array bytes;
	size_t length, count;

	*appended = 0;
	if (!value)
		return TCS_OK;
	if (!json_is_string(value))
		return json_fault(place, "bytes", "not a string");
	length = json_string_length(value);
	if (length % 4)
		return json_fault(place, "bytes", "not base64");
	if (array_grow_bytes(byte_array, 1, length / 4 * 3))
		return fault_memory(place->fault);
	memcpy(&bytes, byte_array, sizeof bytes);
	if (length &&
		base64_decode((unsigned char *)bytes.at + bytes.count, &count,
			json_string_value(value), length))
		return json_fault(place, "bytes", "not base64");
	*appended = length ? count : 0;
	bytes.count += (size_t)*appended;
	memcpy(byte_array, &bytes, sizeof bytes);
	return TCS_OK;
}

static enum tcs_status
build_image(struct json_place *place, const json_t *value,
	struct tcs_palette *palette)
{
	static const char *const nested[] = {"bytes", NULL};
	struct tcs_image image;
	enum tcs_status status = json_get_fields(
		place, value, &fields_image, nested, &image, &palette->text);

	if (status)
		return status;
	image.first_byte = palette->bytes.count;
	status = append_base64(place, json_object_get(value, "bytes"),
		&palette->bytes, &image.byte_count);
	if (status)
		return status;
	if (array_grow(&palette->images, 1))
		return fault_memory(place->fault);
	palette->images.at[palette->images.count++] = image;
	return TCS_OK;
}

static enum tcs_status
build_material(struct json_place *place, const json_t *value,
	struct tcs_palette *palette)
{
	struct tcs_material material;
	enum tcs_status status = json_get_fields(place, value, &fields_material,
		none, &material, &palette->text);

	if (status)
		return status;
	if (array_grow(&palette->materials, 1))
		return fault_memory(place->fault);
	palette->materials.at[palette->materials.count++] = material;
	return TCS_OK;
}

static enum tcs_status
build_entries(struct json_place *place, const json_t *line, const char *key,
	struct tcs_palette *palette,
	enum tcs_status (*build)(struct json_place *place, const json_t *value,
		struct tcs_palette *palette))
{
	const json_t *array;
	enum tcs_status status = json_get_array(place, line, key, &array);

	for (size_t i = 0; !status && i < json_array_size(array); i++) {
		json_enter(place, key, i);
		status = build(place, json_array_get(array, i), palette);
		json_leave(place);
	}
	return status;
}

static enum tcs_status
build_palette(struct json_place *place, const json_t *line,
	struct tcs_palette *palette, struct tcs_record *record)
{
	static const char *const keys[] = {"images", "materials", NULL};
	enum tcs_status status = check_keys(place, line, keys);

	palette_clear(palette);
	if (!status)
		status = build_entries(
			place, line, "images", palette, build_image);
	if (!status)
		status = build_entries(
			place, line, "materials", palette, build_material);
	return status ? status : palette_encode(palette, record, place->fault);
}

/* ---- objects, others, the end ---------------------------------------- */

static enum tcs_status
build_object(struct json_place *place, const json_t *line,
	enum tcs_record_type type, struct tcs_object *object,
	struct tcs_record *record)
{
	static const char *const keys[] = {"features", "relations",
		"geometries", "paints", "instances", NULL};
	enum tcs_status status = check_keys(place, line, keys);

	object_clear(object);
	if (!status)
		status = json_build_object(place, line, object);
	return status ? status
		      : object_encode(object, type, record, place->fault);
}

static enum tcs_status
build_other(
	struct json_place *place, const json_t *line, struct tcs_record *record)
{
	static const char *const keys[] = {"type", "bytes", NULL};
	const json_t *type = json_object_get(line, "type");
	uint64_t number, count;
	enum tcs_status status = check_keys(place, line, keys);

	if (status)
		return status;
	if (json_is_string(type) && json_string_length(type) == 4) {
		memcpy(&record->type, json_string_value(type), 4);
	} else {
		status = json_get_index(
			place, "type", type, UINT32_MAX, &number);
		if (status)
			return status;
		record->type = (uint32_t)number;
	}
	if (record->type == TCS_END)
		return json_fault(
			place, "type", "the end has a line of its own");
	array_clear(&record->bytes);
	status = append_base64(
		place, json_object_get(line, "bytes"), &record->bytes, &count);
	if (!status && count % 8)
		status =
			json_fault(place, "bytes", "not a multiple of 8 bytes");
	return status;
}

static enum tcs_status
build_end(struct json_place *place, const json_t *line,
	struct tcs_record *record, struct tcs_tally *claimed)
{
	static const char *const nested[] = {"record", NULL};

	array_clear(&record->bytes);
	record->type = TCS_END;
	return json_get_fields(
		place, line, &fields_tally, nested, claimed, NULL);
}

static enum tcs_status
build_record(struct json_builder *builder, struct json_place *place,
	const json_t *line, struct tcs_record *record,
	struct tcs_tally *claimed)
{
	const char *kind = json_string_value(json_object_get(line, "record"));

	if (!kind)
		return json_fault(place, "record", "missing, or not a string");
	if (!strcmp(kind, "object"))
		return build_object(
			place, line, TCS_OBJECT, &builder->object, record);
	if (!strcmp(kind, "prototype"))
		return build_object(
			place, line, TCS_PROTOTYPE, &builder->object, record);
	if (!strcmp(kind, "head"))
		return build_head(place, line, &builder->head, record);
	if (!strcmp(kind, "palette"))
		return build_palette(place, line, &builder->palette, record);
	if (!strcmp(kind, "other"))
		return build_other(place, line, record);
	if (!strcmp(kind, "end"))
		return build_end(place, line, record, claimed);
	return json_fault(place, "record", "no such kind of record");
}

enum tcs_status
json_build_line(struct json_builder *builder, const char *line, size_t length,
	uint64_t number, struct tcs_record *record, struct tcs_tally *claimed,
	struct tcs_fault *fault)
{
	struct json_place place = {.line = number, .fault = fault};
	json_error_t error;
	json_t *value = json_loadb(line, length,
		JSON_REJECT_DUPLICATES | JSON_DECODE_INT_AS_REAL, &error);
	enum tcs_status status;

	if (!value && json_error_code(&error) == json_error_out_of_memory)
		return fault_memory(fault);
	if (!value)
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"line %llu: column %d: %s", (unsigned long long)number,
			error.column, error.text);
	status = json_is_object(value)
		? build_record(builder, &place, value, record, claimed)
		: json_fault(&place, NULL, "not an object");
	json_decref(value);
	return status;
}
