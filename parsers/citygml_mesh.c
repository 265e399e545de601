/*
 * Templates of implicit geometry that are files of their own: read once, as if
 * their faces stood in the document where their name does.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_reader.h"
#include "mesh_file.h"
#include "number.h"
#include "utf8.h"

/* ---- faces as polygons ------------------------------------------------------- */

static enum tcs_status
numbers_add(struct raw_object *raw, const double *numbers, int count,
	struct tcs_fault *fault)
{
	if (array_grow(&raw->positions, (size_t)count * (NUMBER_LENGTH + 1)))
		return fault_memory(fault);
	for (int i = 0; i < count; i++) {
		raw->positions.count += number_print(
			raw->positions.at + raw->positions.count, numbers[i]);
		raw->positions.at[raw->positions.count++] = ' ';
	}
	return TCS_OK;
}

/* A closed ring. */
static enum tcs_status
ring_add(struct raw_object *raw, const struct mesh_file *mesh,
	const struct mesh_face *face, struct tcs_fault *fault)
{
	const uint32_t *corners = mesh->corners.at + face->first_corner;
	struct raw_ring *ring;
	enum tcs_status status = TCS_OK;

	if (array_grow(&raw->rings, 1))
		return fault_memory(fault);
	ring = &raw->rings.at[raw->rings.count++];
	*ring = (struct raw_ring){
		.first = raw->positions.count,
		.has_list = true,
		.dimension = 3,
	};
	for (uint32_t i = 0; !status && i <= face->corner_count; i++) {
		const struct tcs_point *at =
			&mesh->points.at[corners[i % face->corner_count]];

		status = numbers_add(
			raw, (const double[]){at->x, at->y, at->z}, 3, fault);
	}
	ring->length = raw->positions.count - ring->first;
	return status;
}

static enum tcs_status
face_add(struct gml_reader *reader, const struct mesh_file *mesh,
	const struct mesh_face *face, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;

	if (array_grow(&raw->polygons, 1) || array_grow(&raw->members, 1))
		return fault_memory(fault);
	raw->members.at[raw->members.count++] = (struct raw_member){
		.polygon = (uint32_t)raw->polygons.count, .shell = TCS_NONE};
	raw->polygons.at[raw->polygons.count++] = (struct raw_polygon){
		.first_ring = (uint32_t)raw->rings.count,
		.ring_count = 1,
		.line = xml_line(reader->xml),
		.geometry = (uint32_t)raw->geometries.count,
		.shape = RAW_AREA,
	};
	return ring_add(raw, mesh, face, fault);
}

/* ---- materials --------------------------------------------------------------- */

/* Text as the file has it may not be UTF-8: then it is none. */
static size_t
name_length(const char *name)
{
	size_t length = strlen(name);

	return utf8_valid(name, length) ? length : 0;
}

static enum tcs_status
material_take(struct gml_reader *reader, const struct mesh_file *mesh,
	const struct mesh_material *from, uint32_t *out,
	struct tcs_fault *fault)
{
	const char *name = mesh->names.at + from->name;
	enum tcs_status status =
		text_keep(&reader->source, name, name_length(name), fault);

	reader->material = material_plain();
	memcpy(reader->material.diffuse, from->diffuse, sizeof from->diffuse);
	reader->material.transparency = from->transparency;
	return status ? status : material_add(reader, out, fault);
}

static enum tcs_status
name_take(struct gml_reader *reader, const char *name, tcs_text *out,
	struct tcs_fault *fault)
{
	return text_append(
		&reader->raw->palette, name, name_length(name), out, fault);
}

/* All images of the mesh, in the object's palette. */
static enum tcs_status
images_take(struct gml_reader *reader, const struct mesh_file *mesh,
	struct tcs_fault *fault)
{
	struct tcs_palette *palette = &reader->raw->palette;
	size_t bytes = mesh->bytes.count;
	enum tcs_status status = TCS_OK;

	if (array_grow(&palette->images, mesh->images.count) ||
		array_grow(&palette->bytes, bytes))
		return fault_memory(fault);
	for (size_t i = 0; !status && i < mesh->images.count; i++) {
		const struct mesh_image *from = &mesh->images.at[i];
		struct tcs_image image = {
			.wrap = from->wrap,
			.first_byte = palette->bytes.count + from->first_byte,
			.byte_count = from->byte_count,
		};

		status = name_take(
			reader, mesh->names.at + from->uri, &image.uri, fault);
		if (!status)
			status = name_take(reader, mesh->names.at + from->mime,
				&image.mime, fault);
		palette->images.at[palette->images.count++] = image;
	}
	if (bytes)
		memcpy(palette->bytes.at + palette->bytes.count, mesh->bytes.at,
			bytes);
	palette->bytes.count += bytes;
	return status;
}

/* ---- paints ------------------------------------------------------------------ */

static enum tcs_status
texcoords_add(struct raw_object *raw, const struct mesh_file *mesh,
	const struct mesh_face *face, struct tcs_fault *fault)
{
	const struct tcs_texcoord *at = mesh->texcoords.at + face->first_corner;
	struct raw_texring ring = {.first = raw->positions.count};
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < face->corner_count; i++)
		status = numbers_add(
			raw, (const double[]){at[i].s, at[i].t}, 2, fault);
	ring.length = raw->positions.count - ring.first;
	if (!status && array_grow(&raw->texrings, 1))
		return fault_memory(fault);
	if (!status)
		raw->texrings.at[raw->texrings.count++] = ring;
	return status;
}

/* What a run of faces has on it. */
static enum tcs_status
paint_find(struct gml_reader *reader, const struct mesh_file *mesh,
	const struct mesh_face *face, const struct mesh_face *end,
	uint32_t first_image, struct raw_paint *paint, struct tcs_fault *fault)
{
	const struct mesh_material *from = &mesh->materials.at[face->material];
	struct raw_object *raw = reader->raw;
	enum tcs_status status =
		material_take(reader, mesh, from, &paint->material, fault);

	if (status || !face->textured)
		return status;
	paint->image = PALETTE_OWN | (first_image + from->image);
	paint->mapping = MAPPING_ORDER;
	paint->first_ring = (uint32_t)raw->texrings.count;
	paint->ring_count = (uint32_t)(end - face);
	paint->first_polygon =
		(uint32_t)raw->polygons.count - paint->ring_count;
	for (; !status && face < end; face++)
		status = texcoords_add(raw, mesh, face, fault);
	return status;
}

/* What is on the last members, which are these faces. */
static enum tcs_status
paint_use(struct gml_reader *reader, const struct mesh_file *mesh,
	const struct mesh_face *face, const struct mesh_face *end,
	uint32_t first_image, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint paint = {.image = TCS_NONE};
	enum tcs_status status =
		paint_find(reader, mesh, face, end, first_image, &paint, fault);

	if (!status)
		status = members_name(reader,
			(uint32_t)(raw->members.count - (size_t)(end - face)),
			&paint.target, fault);
	if (status)
		return status;
	if (array_grow(&raw->paints, 1))
		return fault_memory(fault);
	raw->paints.at[raw->paints.count++] = paint;
	return TCS_OK;
}

/* ---- the template ------------------------------------------------------------ */

/* In runs of one look. */
static enum tcs_status
faces_add(struct gml_reader *reader, const struct mesh_file *mesh,
	struct tcs_fault *fault)
{
	const struct mesh_face *face = mesh->faces.at;
	const struct mesh_face *end = face + mesh->faces.count;
	uint32_t first_image = (uint32_t)reader->raw->palette.images.count;
	enum tcs_status status = images_take(reader, mesh, fault);

	while (!status && face < end) {
		const struct mesh_face *run = face;

		for (; !status && face < end &&
			face->material == run->material &&
			face->textured == run->textured;
			face++)
			status = face_add(reader, mesh, face, fault);
		if (!status && run->material != TCS_NONE)
			status = paint_use(
				reader, mesh, run, face, first_image, fault);
	}
	return status;
}

static enum tcs_status
geometry_add(struct gml_reader *reader, const struct mesh_file *mesh,
	const struct raw_instance *instance, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_geometry geometry = {
		.feature = instance->feature,
		.first_member = (uint32_t)raw->members.count,
		.line = instance->line,
		.lod = instance->lod,
		.kind = TCS_MULTI_SURFACE,
		.is_template = true,
	};
	enum tcs_status status = faces_add(reader, mesh, fault);

	if (status)
		return status;
	if (array_grow(&raw->geometries, 1))
		return fault_memory(fault);
	geometry.member_count =
		(uint32_t)raw->members.count - geometry.first_member;
	raw->geometries.at[raw->geometries.count++] = geometry;
	return TCS_OK;
}

/* *problem is why there is no template, or NULL. */
static enum tcs_status
mesh_load(struct gml_reader *reader, const char *path, const char *key,
	struct raw_instance *instance, const char **problem,
	struct tcs_fault *fault)
{
	const struct mesh_source source = {
		&reader->folder, path, reader->options.max_library};
	uint32_t geometry = (uint32_t)reader->raw->geometries.count;
	struct mesh_file mesh = {0};
	enum tcs_status status = mesh_read(&mesh, &source, problem, fault);

	if (!status && !*problem)
		status = geometry_add(reader, &mesh, instance, fault);
	if (!status && !*problem)
		status = template_add(reader, key, geometry, instance, fault);
	if (!status && !*problem && mesh.lacks)
		status = raw_report(&reader->raw->report, REPORT_NOTE,
			"library object", mesh.lacks, path, instance->line,
			fault);
	mesh_file_release(&mesh);
	return status;
}

/* A file that cannot be used is tried once. */
static enum tcs_status
mesh_find(struct gml_reader *reader, const char *key,
	struct raw_instance *instance, const char **problem,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	uint32_t number;
	bool added;

	instance->prototype = keys_find(&reader->templates, key);
	if (instance->prototype != TCS_NONE)
		return TCS_OK;
	number = keys_find(&reader->meshes, key);
	if (number != TCS_NONE) {
		*problem = reader->mesh_problems.at[number];
		return TCS_OK;
	}
	status = mesh_load(reader, key + 1, key, instance, problem, fault);
	if (status || !*problem)
		return status;
	if (array_grow(&reader->mesh_problems, 1))
		return fault_memory(fault);
	reader->mesh_problems.at[reader->mesh_problems.count++] = *problem;
	return keys_add(&reader->meshes, key, &number, &added, fault);
}

enum tcs_status
mesh_take(struct gml_reader *reader, struct raw_instance *instance,
	struct tcs_fault *fault)
{
	const char *problem = NULL, *at;
	enum tcs_status status;
	size_t length;
	char *key;

	gml_trimmed(reader, &at, &length);
	if (!length || instance->prototype != TCS_NONE)
		return TCS_OK;
	key = malloc(length + 2);
	if (!key)
		return fault_memory(fault);
	/* No id begins like this. */
	key[0] = '\1';
	memcpy(key + 1, at, length);
	key[length + 1] = 0;
	status = mesh_find(reader, key, instance, &problem, fault);
	if (!status && problem)
		status = gml_skipped(
			reader, "library object", problem, key + 1, fault);
	free(key);
	return status;
}
