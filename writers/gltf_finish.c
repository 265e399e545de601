#include "gltf_city.h"

#include <stdlib.h>
#include <string.h>

#include "gltf_shared.h"

/* ---- metadata -------------------------------------------------------- */

/* A view of its own for bytes that are complete. */
static enum tcs_status
add_own_view(struct city *city, enum city_part part, uint64_t start,
	uint64_t end, uint32_t *number, struct tcs_fault *fault)
{
	if (array_grow(&city->views, 1))
		return fault_memory(fault);
	*number = (uint32_t)city->views.count;
	city->views.at[city->views.count++] =
		(struct city_view){part, start, end};
	return TCS_OK;
}

/* "unit: m; code space: …"; NULL in *out when there is nothing to say. */
static enum tcs_status
describe_column(
	const struct table_column *column, char **out, struct tcs_fault *fault)
{
	const char *unit = column->unit ? column->unit : "";
	const char *code = column->code_space ? column->code_space : "";
	size_t size = strlen(unit) + strlen(code) + 32;

	*out = NULL;
	if (!*unit && !*code)
		return TCS_OK;
	*out = malloc(size);
	if (!*out)
		return fault_memory(fault);
	snprintf(*out, size, "%s%s%s%s%s", *unit ? "unit: " : "", unit,
		*unit && *code ? "; " : "", *code ? "code space: " : "", code);
	return TCS_OK;
}

static enum tcs_status
write_column(struct city *city, const struct table *table, size_t which,
	struct assembly_property *out, char **description,
	struct tcs_fault *fault)
{
	const struct table_column *column = table->columns.at + which;
	struct column_place place;
	enum tcs_status status = column_write(&column->column, table->row_count,
		city->parts + CITY_METADATA, &place, fault);

	if (!status)
		status = add_own_view(city, CITY_METADATA, place.values_at,
			place.values_at + place.values_size, &out->values_view,
			fault);
	if (!status && place.type == COLUMN_STRING)
		status = add_own_view(city, CITY_METADATA, place.offsets_at,
			place.offsets_at + place.offsets_size,
			&out->offsets_view, fault);
	if (!status)
		status = describe_column(column, description, fault);
	out->id = column->property;
	out->name = column->name;
	out->description = *description;
	out->semantic = which == TABLE_ID ? "ID"
		: which == TABLE_NAME	  ? "NAME"
					  : NULL;
	out->type = place.type;
	out->required = which == TABLE_ID || which == TABLE_CLASS;
	out->has_gaps = place.has_gaps;
	out->wide_offsets = place.wide_offsets;
	return status;
}

static enum tcs_status
write_table(struct city *city, const struct table *table, const char *class,
	struct tcs_fault *fault)
{
	size_t count = table->columns.count, used = 0;
	struct assembly_property *properties =
		calloc(count, sizeof *properties);
	char **descriptions = calloc(count, sizeof *descriptions);
	enum tcs_status status = TCS_OK;

	if (!properties || !descriptions)
		status = fault_memory(fault);
	for (size_t i = 0; i < count && !status; i++) {
		if (!table->columns.at[i].column.rows.count)
			continue;
		status = write_column(city, table, i, properties + used,
			descriptions + used, fault);
		used++;
	}
	if (!status)
		status = assembly_add_table(city->assembly, class,
			table->row_count, properties, used, fault);
	for (size_t i = 0; descriptions && i < count; i++)
		free(descriptions[i]);
	free(descriptions);
	free(properties);
	return status;
}

/* ---- textures -------------------------------------------------------- */

static enum tcs_status
write_textures(struct city *city, struct tcs_fault *fault)
{
	const struct textures *all = &city->textures;
	enum tcs_status status = TCS_OK;
	uint32_t view;

	for (size_t i = 0; i < all->images.count && !status; i++) {
		const struct texture_image *image = all->images.at + i;

		status = add_own_view(city, CITY_IMAGES, image->start,
			image->end, &view, fault);
		if (!status)
			status = assembly_add_image(city->assembly, view,
				image_mime(image->kind.format), image->name,
				fault);
	}
	for (size_t i = 0; i < all->list.count && !status; i++) {
		const struct texture *texture = all->list.at + i;

		status = assembly_add_texture(city->assembly, texture->image,
			texture->wrap,
			all->images.at[texture->image].kind.format ==
				IMAGE_WEBP,
			fault);
	}
	return status;
}

/* ---- the end --------------------------------------------------------- */

static enum tcs_status
add_views(struct city *city, uint64_t *buffer_size, struct tcs_fault *fault)
{
	static const struct assembly_view kinds[CITY_PARTS] = {
		[CITY_POSITIONS] = {0, 0, 12, ASSEMBLY_VERTICES},
		[CITY_NORMALS] = {0, 0, 12, ASSEMBLY_VERTICES},
		[CITY_TEXCOORDS] = {0, 0, 8, ASSEMBLY_VERTICES},
		[CITY_IDS] = {0, 0, 4, ASSEMBLY_VERTICES},
		[CITY_ROTATIONS] = {0, 0, 16, ASSEMBLY_VERTICES},
		[CITY_INDICES] = {0, 0, 0, ASSEMBLY_INDICES},
		[CITY_METADATA] = {0, 0, 0, ASSEMBLY_ANYTHING},
		[CITY_IMAGES] = {0, 0, 0, ASSEMBLY_ANYTHING},
	};
	uint64_t starts[CITY_PARTS], end = 0;
	enum tcs_status status = TCS_OK;

	for (int i = 0; i < CITY_PARTS && !status; i++) {
		status = spool_align(city->parts + i, 8, fault);
		starts[i] = end;
		end += city->parts[i].size;
	}
	for (size_t i = 0; i < city->views.count && !status; i++) {
		const struct city_view *from = city->views.at + i;
		struct assembly_view view = kinds[from->part];

		view.offset = starts[from->part] + from->start;
		view.length = from->end - from->start;
		status = assembly_add_view(city->assembly, &view, fault);
	}
	*buffer_size = end;
	return status;
}

enum tcs_status
city_finish(struct city *city, struct assembly_root *root, uint64_t *json_size,
	struct tcs_fault *fault)
{
	static const char *const classes[ASSEMBLY_SETS] = {"object", "surface"};
	enum tcs_status status = shared_finish(city, fault);

	for (int i = 0; i < ASSEMBLY_SETS && !status; i++)
		if (city->tables[i].row_count)
			status = write_table(
				city, city->tables + i, classes[i], fault);
	for (size_t i = 0; i < city->materials.looks.count && !status; i++)
		status = assembly_add_material(
			city->assembly, city->materials.looks.at + i, fault);
	if (!status)
		status = write_textures(city, fault);
	if (!status)
		status = add_views(city, &root->buffer_size, fault);
	return status ? status
		      : assembly_finish(city->assembly, root, json_size, fault);
}

/* ---- files ----------------------------------------------------------- */

static enum tcs_status
write_bytes(struct output *out, const void *bytes, size_t size,
	struct tcs_fault *fault)
{
	return fwrite(bytes, 1, size, out->file) == size
		? TCS_OK
		: fault_system(fault, "cannot write", out->name);
}

static enum tcs_status
write_words(struct output *out, const uint32_t *words, size_t count,
	struct tcs_fault *fault)
{
	unsigned char bytes[4];
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < count && !status; i++) {
		for (int k = 0; k < 4; k++)
			bytes[k] = (unsigned char)(words[i] >> 8 * k);
		status = write_bytes(out, bytes, sizeof bytes, fault);
	}
	return status;
}

static enum tcs_status
pour_parts(struct city *city, struct output *out, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (int i = 0; i < CITY_PARTS && !status; i++)
		status = spool_pour(
			city->parts + i, out->file, out->name, fault);
	return status;
}

/* source: glTF 2.0, 4.4 (GLB). The buffer begins at a multiple of 8. */
enum tcs_status
city_write_glb(struct city *city, uint64_t json_size, uint64_t buffer_size,
	struct output *out, struct tcs_fault *fault)
{
	uint64_t padded = json_size + (12 - json_size % 8) % 8;
	uint64_t total = 12 + 8 + padded + (buffer_size ? 8 + buffer_size : 0);
	const uint32_t head[5] = {
		0x46546c67, 2, (uint32_t)total, (uint32_t)padded, 0x4e4f534a};
	const uint32_t behind[2] = {(uint32_t)buffer_size, 0x004e4942};
	enum tcs_status status;

	if (total > UINT32_MAX)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"the GLB would have %llu bytes, and its format ends at "
			"4 GiB: use --format gltf",
			(unsigned long long)total);
	status = write_words(out, head, 5, fault);
	if (!status)
		status = assembly_pour(
			city->assembly, out->file, out->name, fault);
	if (!status)
		status = write_bytes(
			out, "       ", (size_t)(padded - json_size), fault);
	if (status || !buffer_size)
		return status;
	status = write_words(out, behind, 2, fault);
	return status ? status : pour_parts(city, out, fault);
}

enum tcs_status
city_write_pair(struct city *city, struct output *json, struct output *bin,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		assembly_pour(city->assembly, json->file, json->name, fault);

	return status ? status : pour_parts(city, bin, fault);
}
