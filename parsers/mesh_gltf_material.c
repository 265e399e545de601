/*
 * glTF: materials, and the images that lie on what has them. An image that
 * cannot be had leaves the plain colour.
 *
 * source: glTF 2.0 (ISO/IEC 12113) 3.8 and 3.9, KHR_texture_transform.
 */
#include "mesh_gltf.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- images ------------------------------------------------------------------ */

enum { CLAMP_TO_EDGE = 33071, MIRRORED_REPEAT = 33648 };

static uint32_t
wrap_of(const struct gltf *gltf, const json_t *texture)
{
	const json_t *sampler = gltf_element(
		gltf, "samplers", gltf_number(texture, "sampler", SIZE_MAX));

	switch (gltf_number(sampler, "wrapS", 0)) {
	case CLAMP_TO_EDGE:
		return TCS_WRAP_CLAMP;
	case MIRRORED_REPEAT:
		return TCS_WRAP_MIRROR;
	default:
		return TCS_WRAP_REPEAT;
	}
}

static const char *
suffix_of(const char *mime)
{
	if (!strcmp(mime, "image/png"))
		return "png";
	return strcmp(mime, "image/jpeg") ? "image" : "jpg";
}

/* An image within the file goes by the name of that: "bench.glb.0.png". */
static enum tcs_status
image_embed(struct gltf *gltf, size_t source, const struct mesh_bytes *bytes,
	const char *mime, uint32_t wrap, uint32_t *out)
{
	const char *path = gltf->source->path;
	size_t room = strlen(path) + 32;
	char *uri = malloc(room);
	enum tcs_status status;

	if (!uri)
		return fault_memory(gltf->fault);
	snprintf(uri, room, "%s.%zu.%s", path, source, suffix_of(mime));
	status = mesh_add_image(gltf->mesh, gltf->source, uri, mime, wrap,
		bytes, out, gltf->problem, gltf->fault);
	free(uri);
	return status;
}

/* "data:image/png;base64,…" */
static enum tcs_status
image_decode(struct gltf *gltf, size_t source, const char *uri, uint32_t wrap,
	uint32_t *out)
{
	const char *type = uri + strlen("data:");
	size_t length = strcspn(type, ";,");
	struct mesh_bytes bytes;
	char mime[32] = "";
	enum tcs_status status = gltf_data_decode(gltf, uri, &bytes);

	if (length < sizeof mime)
		memcpy(mime, type, length);
	if (!status && !*gltf->problem)
		status = image_embed(gltf, source, &bytes, mime, wrap, out);
	free(bytes.at);
	return status;
}

static enum tcs_status
image_name(struct gltf *gltf, const char *uri, const char *mime, uint32_t wrap,
	uint32_t *out)
{
	char *path = mesh_path_beside(gltf->source->path, uri);
	enum tcs_status status;

	if (!path)
		return fault_memory(gltf->fault);
	status = mesh_add_image(gltf->mesh, gltf->source, path, mime, wrap,
		NULL, out, gltf->problem, gltf->fault);
	free(path);
	return status;
}

static enum tcs_status
image_take(struct gltf *gltf, size_t source, uint32_t wrap, uint32_t *out)
{
	const json_t *image = gltf_element(gltf, "images", source);
	const char *uri = json_string_value(json_object_get(image, "uri"));
	const char *mime =
		json_string_value(json_object_get(image, "mimeType"));
	struct mesh_bytes bytes;
	enum tcs_status status;

	mime = mime ? mime : "";
	if (uri && !strncmp(uri, "data:", 5))
		return image_decode(gltf, source, uri, wrap, out);
	if (uri)
		return image_name(gltf, uri, mime, wrap, out);
	if (!json_object_get(image, "bufferView"))
		return TCS_OK;
	status = gltf_view_find(
		gltf, gltf_number(image, "bufferView", SIZE_MAX), &bytes);
	if (status || *gltf->problem)
		return status;
	return image_embed(gltf, source, &bytes, mime, wrap, out);
}

/* Each texture once. */
static enum tcs_status
texture_take(struct gltf *gltf, size_t index, uint32_t *out)
{
	const json_t *texture = gltf_element(gltf, "textures", index);
	size_t source = gltf_number(texture, "source", SIZE_MAX);
	enum tcs_status status = TCS_OK;

	if (source == SIZE_MAX)
		return TCS_OK;
	if (gltf->images[index] == TCS_NONE)
		status = image_take(gltf, source, wrap_of(gltf, texture),
			&gltf->images[index]);
	*out = gltf->images[index];
	return status;
}

/* ---- where they lie ---------------------------------------------------------- */

/* Turned counterclockwise, the height of glTF's coordinates pointing down. */
static void
look_find(const json_t *info, struct gltf_look *look)
{
	const json_t *transform = json_object_get(
		json_object_get(info, "extensions"), "KHR_texture_transform");
	double offset[2] = {0, 0}, scale[2] = {1, 1};
	double angle =
		json_number_value(json_object_get(transform, "rotation"));

	gltf_array(transform, "offset", offset, 2);
	gltf_array(transform, "scale", scale, 2);
	look->set = gltf_number(
		transform, "texCoord", gltf_number(info, "texCoord", 0));
	memcpy(look->map,
		(double[6]){cos(angle) * scale[0], sin(angle) * scale[1],
			offset[0], -sin(angle) * scale[0],
			cos(angle) * scale[1], offset[1]},
		sizeof look->map);
}

enum tcs_status
gltf_texcoords_find(struct gltf *gltf, const json_t *attributes,
	uint32_t material, struct gltf_numbers *out)
{
	char name[40];
	size_t index;

	*out = (struct gltf_numbers){.count = 0};
	if (material == TCS_NONE ||
		gltf->mesh->materials.at[material].image == TCS_NONE)
		return TCS_OK;
	snprintf(name, sizeof name, "TEXCOORD_%zu", gltf->looks[material].set);
	index = gltf_number(attributes, name, SIZE_MAX);
	if (index == SIZE_MAX)
		return TCS_OK;
	return gltf_numbers_find(gltf, index, 2, out);
}

/* Whole numbers are parts of the largest. */
static double
part_at(const struct gltf_numbers *numbers, size_t index, size_t which)
{
	const unsigned char *at = numbers->at + index * numbers->stride;

	switch (numbers->component) {
	case GLTF_UNSIGNED_BYTE:
		return at[which] / 255.0;
	case GLTF_UNSIGNED_SHORT:
		return (at[2 * which] | at[2 * which + 1] << 8) / 65535.0;
	case GLTF_FLOAT:
		return gltf_float_at(at + 4 * which);
	default:
		return (double)NAN;
	}
}

struct tcs_texcoord
gltf_texcoord_at(const struct gltf *gltf, uint32_t material,
	const struct gltf_numbers *texcoords, size_t index)
{
	const double *m = gltf->looks[material].map;
	double u = part_at(texcoords, index, 0);
	double v = part_at(texcoords, index, 1);

	return (struct tcs_texcoord){
		m[0] * u + m[1] * v + m[2], 1 - (m[3] * u + m[4] * v + m[5])};
}

/* ---- materials --------------------------------------------------------------- */

/* glTF's colours are linear. */
static float
srgb_of(double linear)
{
	if (!(linear > 0))
		return 0;
	if (linear >= 1)
		return 1;
	return (float)(linear <= 0.0031308
			? 12.92 * linear
			: 1.055 * pow(linear, 1 / 2.4) - 0.055);
}

static enum tcs_status
material_take(struct gltf *gltf, const json_t *entry, struct gltf_look *look)
{
	const json_t *shown = json_object_get(entry, "pbrMetallicRoughness");
	const json_t *info = json_object_get(shown, "baseColorTexture");
	const char *name = json_string_value(json_object_get(entry, "name"));
	const char *mode =
		json_string_value(json_object_get(entry, "alphaMode"));
	double colour[4] = {1, 1, 1, 1};
	struct mesh_material *material;
	enum tcs_status status;

	gltf_array(shown, "baseColorFactor", colour, 4);
	status = mesh_add_material(gltf->mesh, name ? name : "",
		name ? strlen(name) : 0, &material, gltf->fault);
	if (status)
		return status;
	for (int j = 0; j < 3; j++)
		material->diffuse[j] = srgb_of(colour[j]);
	if (mode && !strcmp(mode, "BLEND") && colour[3] >= 0 && colour[3] <= 1)
		material->transparency = (float)(1 - colour[3]);
	if (!info)
		return TCS_OK;
	look_find(info, look);
	return texture_take(
		gltf, gltf_number(info, "index", SIZE_MAX), &material->image);
}

enum tcs_status
gltf_materials_take(struct gltf *gltf)
{
	const json_t *all = json_object_get(gltf->root, "materials");
	size_t count = json_array_size(all);
	size_t textures =
		json_array_size(json_object_get(gltf->root, "textures"));
	enum tcs_status status = TCS_OK;

	gltf->looks = calloc(count + 1, sizeof *gltf->looks);
	gltf->images = malloc((textures + 1) * sizeof *gltf->images);
	if (!gltf->looks || !gltf->images)
		return fault_memory(gltf->fault);
	memset(gltf->images, 0xff, textures * sizeof *gltf->images);
	for (size_t i = 0; !status && !*gltf->problem && i < count; i++)
		status = material_take(
			gltf, json_array_get(all, i), &gltf->looks[i]);
	return status;
}
