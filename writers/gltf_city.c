#include "gltf_city.h"

#include <stdio.h>
#include <string.h>

#include "gltf_numbers.h"
#include "gltf_shared.h"
#include "labels.h"

enum { ID_ROOM = 80 };

enum tcs_status
city_begin(struct city *city, const struct city_settings *settings,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	*city = (struct city){
		.textures.folder = {.name = settings->image_folder},
		.textures.limit = settings->image_limit,
		.drop_textures = settings->drop_textures,
		.shared.on_gpu = settings->gpu_instances,
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

/* ---- meshes ---------------------------------------------------------- */

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
			status = city_add_indices(city,
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

enum tcs_status
city_add_mesh(struct city *city, struct mesh *mesh, struct assembly_mesh *out,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	if (mesh->texcoords.count)
		status = find_textures(city, mesh, report, fault);
	if (!status)
		status = city_add_floats(city, CITY_POSITIONS,
			mesh->positions.at, mesh->positions.count, 3,
			&out->positions, fault);
	if (!status)
		status = city_add_floats(city, CITY_NORMALS, mesh->normals.at,
			mesh->normals.count, 3, &out->normals, fault);
	if (!status && mesh_is_textured(mesh))
		status = city_add_floats(city, CITY_TEXCOORDS,
			mesh->texcoords.at, mesh->texcoords.count, 2,
			&out->texcoords, fault);
	if (!status)
		status = add_primitives(city, mesh, fault);
	out->primitives = city->primitives.at;
	out->primitive_count = city->primitives.count;
	mesh_bounds(mesh, out->lower, out->upper);
	return status;
}

static enum tcs_status
add_feature_ids(struct city *city, struct mesh *mesh, size_t feature_count,
	uint32_t object_row, uint32_t base, struct assembly_mesh *out,
	struct tcs_fault *fault)
{
	size_t count = mesh->features.count;
	uint32_t largest = base + (uint32_t)feature_count - 1;
	enum tcs_status status = city_add_ids(
		city, NULL, count, object_row, object_row, out->sets, fault);

	if (!status)
		status = city_add_ids(city, mesh->features.at, count, base,
			largest, out->sets + 1, fault);
	out->feature_counts[0] = 1;
	return status ? status
		      : mesh_count_features(mesh, feature_count,
				out->feature_counts + 1, fault);
}

/* The children of an object's node: its instances, named as their features. */
static enum tcs_status
find_children(struct city *city, const struct tcs_object *object,
	const struct mesh *mesh, uint32_t object_row, uint32_t base,
	struct tcs_fault *fault)
{
	array_clear(&city->children);
	if (array_grow(&city->children, mesh->instances.count))
		return fault_memory(fault);
	for (size_t i = 0; i < mesh->instances.count; i++) {
		const struct mesh_instance *from = mesh->instances.at + i;
		struct assembly_child to = {
			.name = object_text(
				object, object->features.at[from->feature].id),
			.rows = {object_row, base + from->feature},
			.mesh = shared_mesh(city, from),
		};

		if (to.mesh == TCS_NONE)
			continue;
		memcpy(to.matrix, from->matrix, sizeof to.matrix);
		city->children.at[city->children.count++] = to;
	}
	return TCS_OK;
}

enum tcs_status
city_add_object(struct city *city, const struct tcs_object *object,
	struct mesh *mesh, struct report *report, struct tcs_fault *fault)
{
	uint32_t object_row = city->tables[0].row_count;
	uint32_t base = city->tables[1].row_count;
	struct assembly_mesh made = {.primitives = NULL};
	bool empty = !mesh->features.count;
	bool stands = city->shared.on_gpu && mesh->instances.count;
	char room[ID_ROOM];
	enum tcs_status status = add_rows(city, object, report, fault);

	if (!status && !empty)
		status = city_add_mesh(city, mesh, &made, report, fault);
	if (!status && !empty)
		status = add_feature_ids(city, mesh, object->features.count,
			object_row, base, &made, fault);
	array_clear(&city->children);
	if (!status && stands)
		status = shared_stand(city, mesh, object_row, base, fault);
	else if (!status)
		status = find_children(
			city, object, mesh, object_row, base, fault);
	if (status || (stands && empty))
		return status;
	return assembly_add_node(city->assembly,
		feature_id(object, 0, base, room), empty ? NULL : &made,
		city->children.at, city->children.count, fault);
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
	array_release(&city->children);
	shared_release(&city->shared);
	materials_release(&city->materials);
	textures_release(&city->textures);
	palette_release(&city->palette);
}
