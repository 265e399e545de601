#include "gltf_city.h"

#include <stdio.h>
#include <string.h>

#include "labels.h"

enum { ID_ROOM = 80, CHUNK = 4096 };

enum tcs_status
city_begin(struct city *city, const struct city_settings *settings,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	*city = (struct city){
		.textures.folder = {settings->image_folder,
			settings->image_limit, 0},
		.drop_textures = settings->drop_textures,
	};
	for (int i = 0; i < CITY_PARTS; i++)
		city->open[i] = TCS_NONE;
	for (int i = 0; i < CITY_PARTS; i++)
		spool_open(city->parts + i, settings->beside);
	for (int i = 0; i < ASSEMBLY_SETS && !status; i++)
		status = table_init(
			city->tables + i, settings->column_limit, fault);
	if (status)
		return status;
	city->assembly = assembly_new(settings->beside, fault);
	return city->assembly ? TCS_OK : fault->status;
}

enum tcs_status
city_add_palette(struct city *city, const struct tcs_palette *palette,
	struct report *report, struct tcs_fault *fault)
{
	struct tcs_palette entries = *palette;
	size_t before = city->palette.images.count;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < palette->images.count && !status; i++) {
		const struct tcs_image *image = palette->images.at + i;

		if (image->byte_count && !city->drop_textures)
			status = textures_take(&city->textures,
				(uint32_t)(before + i),
				palette_text(palette, image->uri),
				palette->bytes.at + image->first_byte,
				image->byte_count, city->parts + CITY_IMAGES,
				report, fault);
	}
	entries.bytes.count = 0;
	return status ? status
		      : palette_append(&city->palette, &entries, fault);
}

/* ---- rows ------------------------------------------------------------ */

/* The feature's id, or one made of its class and number. */
static const char *
feature_id(const struct tcs_object *object, uint32_t feature, uint32_t base,
	char room[ID_ROOM])
{
	const struct tcs_feature *of = object->features.at + feature;

	if (*object_text(object, of->id))
		return object_text(object, of->id);
	snprintf(room, ID_ROOM, "%s#%u", label_of(of->class)->name,
		base + feature);
	return room;
}

static enum tcs_status
add_surface_row(struct city *city, const struct tcs_object *object,
	uint32_t feature, uint32_t base, size_t first, size_t end,
	struct report *report, struct tcs_fault *fault)
{
	uint32_t parent = object->features.at[feature].parent;
	char own_room[ID_ROOM], parent_room[ID_ROOM];
	const char *above = "";

	if (parent != TCS_NONE)
		above = feature_id(object, parent, base, parent_room);
	return table_add(city->tables + 1, object, feature,
		feature_id(object, feature, base, own_room), above, first, end,
		report, fault);
}

/* Rows for all features; attributes stand in the order of the features. */
static enum tcs_status
add_rows(struct city *city, const struct tcs_object *object,
	struct report *report, struct tcs_fault *fault)
{
	const struct tcs_attribute *attributes = object->attributes.at;
	uint32_t base = city->tables[1].row_count;
	enum tcs_status status = TCS_OK;
	size_t first = 0, end;
	char room[ID_ROOM];

	for (uint32_t i = 0; i < object->features.count && !status; i++) {
		for (end = first; end < object->attributes.count; end++)
			if (attributes[end].feature != i)
				break;
		if (i == 0)
			status = table_add(city->tables, object, 0,
				feature_id(object, 0, base, room), "", first,
				end, report, fault);
		if (!status)
			status = add_surface_row(city, object, i, base,
				i ? first : end, end, report, fault);
		first = end;
	}
	return status;
}

/* ---- numbers --------------------------------------------------------- */

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

static enum tcs_status
add_floats(struct city *city, enum city_part part, const float *values,
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

/*
 * Feature ids, four bytes apart: UNSIGNED_SHORT while the largest fits, FLOAT
 * beyond. `features` NULL: all are `base`.
 */
static enum tcs_status
add_ids(struct city *city, const uint32_t *features, size_t count,
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

static enum tcs_status
add_indices(struct city *city, const uint32_t *indices, size_t count,
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

static enum tcs_status
add_primitives(
	struct city *city, const struct mesh *mesh, struct tcs_fault *fault)
{
	bool narrow = mesh->features.count <= UINT16_MAX;
	enum tcs_status status = TCS_OK;

	array_clear(&city->primitives);
	if (array_grow(&city->primitives, mesh->runs.count))
		return fault_memory(fault);
	for (size_t i = 0; i < mesh->runs.count && !status; i++) {
		const struct mesh_run *run = mesh->runs.at + i;
		struct assembly_primitive *to = city->primitives.at + i;

		to->is_textured = (run->paint & PAINT_TEXTURE) != 0;
		status = materials_find(&city->materials, run->paint,
			&city->palette, &city->textures, &to->material, fault);
		if (!status)
			status = add_indices(city,
				mesh->indices.at + run->first, run->count,
				narrow, &to->indices, fault);
	}
	city->primitives.count = mesh->runs.count;
	return status;
}

/*
 * Turn the images of the stream into textures of the glTF, in the order of the
 * runs. Without its image a run keeps its paint.
 */
static enum tcs_status
find_textures(struct city *city, struct mesh *mesh, struct report *report,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < mesh->runs.count && !status; i++) {
		struct mesh_run *run = mesh->runs.at + i;
		uint32_t sides = run->paint & PAINT_DOUBLE_SIDED, number;

		if (run->image == TCS_NONE)
			continue;
		status = textures_find(&city->textures, run->image,
			&city->palette, city->parts + CITY_IMAGES, &number,
			report, fault);
		run->image = TCS_NONE;
		if (!status && number <= PAINT_NUMBER)
			run->paint = PAINT_TEXTURE | number | sides;
	}
	return status ? status : mesh_group(mesh, fault);
}

static bool
mesh_is_textured(const struct mesh *mesh)
{
	for (size_t i = 0; i < mesh->runs.count; i++)
		if (mesh->runs.at[i].paint & PAINT_TEXTURE)
			return true;
	return false;
}

static enum tcs_status
add_mesh(struct city *city, struct mesh *mesh, size_t feature_count,
	uint32_t object_row, uint32_t base, struct assembly_mesh *out,
	struct tcs_fault *fault)
{
	size_t count = mesh->features.count;
	uint32_t largest = base + (uint32_t)feature_count - 1;
	enum tcs_status status =
		add_floats(city, CITY_POSITIONS, mesh->positions.at,
			mesh->positions.count, 3, &out->positions, fault);

	if (!status)
		status = add_floats(city, CITY_NORMALS, mesh->normals.at,
			mesh->normals.count, 3, &out->normals, fault);
	if (!status && mesh_is_textured(mesh))
		status = add_floats(city, CITY_TEXCOORDS, mesh->texcoords.at,
			mesh->texcoords.count, 2, &out->texcoords, fault);
	if (!status)
		status = add_ids(city, NULL, count, object_row, object_row,
			out->sets, fault);
	if (!status)
		status = add_ids(city, mesh->features.at, count, base, largest,
			out->sets + 1, fault);
	if (!status)
		status = add_primitives(city, mesh, fault);
	if (!status)
		status = mesh_count_features(
			mesh, feature_count, out->feature_counts + 1, fault);
	out->feature_counts[0] = 1;
	out->primitives = city->primitives.at;
	out->primitive_count = city->primitives.count;
	mesh_bounds(mesh, out->lower, out->upper);
	return status;
}

enum tcs_status
city_add_object(struct city *city, const struct tcs_object *object,
	struct mesh *mesh, struct report *report, struct tcs_fault *fault)
{
	uint32_t object_row = city->tables[0].row_count;
	uint32_t base = city->tables[1].row_count;
	struct assembly_mesh made = {.primitives = NULL};
	bool empty = !mesh->features.count;
	char room[ID_ROOM];
	enum tcs_status status = add_rows(city, object, report, fault);

	if (!status && mesh->texcoords.count)
		status = find_textures(city, mesh, report, fault);
	if (!status && !empty)
		status = add_mesh(city, mesh, object->features.count,
			object_row, base, &made, fault);
	return status ? status
		      : assembly_add_node(city->assembly,
				feature_id(object, 0, base, room),
				empty ? NULL : &made, fault);
}

void
city_release(struct city *city)
{
	for (int i = 0; i < CITY_PARTS; i++)
		spool_close(city->parts + i);
	for (int i = 0; i < ASSEMBLY_SETS; i++)
		table_release(city->tables + i);
	if (city->assembly)
		assembly_free(city->assembly);
	array_release(&city->views);
	array_release(&city->primitives);
	materials_release(&city->materials);
	textures_release(&city->textures);
	palette_release(&city->palette);
}
