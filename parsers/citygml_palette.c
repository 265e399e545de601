/*
 * The materials and images of the stream: each joins its palette when it first
 * comes, equal ones once, so that every pass gives them the same numbers.
 *
 * An image is a file beside the document. Whether it is there is looked up
 * once, for whoever has to deliver both; what is in it is not read.
 */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "citygml_numbers.h"
#include "citygml_reader.h"

enum tcs_status
appearance_hand_over(struct gml_reader *reader, struct tcs_fault *fault)
{
	if (reader->palette.images.count + reader->palette.materials.count == 0)
		return TCS_OK;
	if (palette_append(&reader->raw->palette, &reader->palette, fault))
		return fault->status;
	palette_clear(&reader->palette);
	return TCS_OK;
}

static enum tcs_status
palette_text_add(struct gml_reader *reader, const struct kept_text *text,
	tcs_text *out, struct tcs_fault *fault)
{
	return text_append(&reader->palette, text->at, text->count, out, fault);
}

struct tcs_material
material_plain(void)
{
	return (struct tcs_material){
		.diffuse = {0.8f, 0.8f, 0.8f},
		.specular = {1, 1, 1},
		.ambient = 0.2f,
		.shininess = 0.2f,
	};
}

/* The material's fields as hexadecimal digits, and its id, are its key. */
enum tcs_status
material_intern(
	struct gml_reader *reader, uint32_t *out, struct tcs_fault *fault)
{
	const unsigned char *bytes = (const unsigned char *)&reader->material;
	const size_t digits = 2 * sizeof reader->material;
	struct tcs_palette *palette = &reader->palette;
	char *key = malloc(digits + reader->source.count + 1);
	enum tcs_status status;
	bool added = false;

	if (!key || array_grow(&palette->materials, 1)) {
		free(key);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < sizeof reader->material; i++) {
		key[2 * i] = (char)('a' + (bytes[i] >> 4));
		key[2 * i + 1] = (char)('a' + (bytes[i] & 15));
	}
	memcpy(key + digits, reader->source.at, reader->source.count);
	key[digits + reader->source.count] = 0;
	status = keys_add(&reader->materials, key, out, &added, fault);
	free(key);
	if (status || !added)
		return status;
	palette->materials.at[palette->materials.count] = reader->material;
	return palette_text_add(reader, &reader->source,
		&palette->materials.at[palette->materials.count++].id, fault);
}

static enum tcs_wrap
wrap_of(const char *at, size_t length)
{
	static const struct {
		const char *name;
		enum tcs_wrap wrap;
	} wraps[] = {
		{"wrap", TCS_WRAP_REPEAT},
		{"mirror", TCS_WRAP_MIRROR},
		{"clamp", TCS_WRAP_CLAMP},
		{"border", TCS_WRAP_BORDER},
	};

	for (size_t i = 0; i < sizeof wraps / sizeof *wraps; i++)
		if (strlen(wraps[i].name) == length &&
			!memcmp(wraps[i].name, at, length))
			return wraps[i].wrap;
	return TCS_WRAP_NONE;
}

static enum tcs_status
image_add(struct gml_reader *reader, struct tcs_fault *fault)
{
	const struct texture_text *texture = &reader->texture;
	struct tcs_palette *palette = &reader->palette;
	struct tcs_image image = {
		.border = {0, 0, 0, 0},
		.wrap = wrap_of(texture->wrap.at, texture->wrap.count),
	};
	double border[4];
	int count = numbers_first(
		texture->border.at, texture->border.count, border, 4);
	enum tcs_status status;

	for (int i = 0; i < count; i++)
		if (border[i] >= 0 && border[i] <= 1)
			image.border[i] = (float)border[i];
	status = palette_text_add(reader, &texture->uri, &image.uri, fault);
	if (!status)
		status = palette_text_add(
			reader, &texture->mime, &image.mime, fault);
	if (!status)
		status = palette_text_add(
			reader, &texture->type, &image.type, fault);
	if (!status)
		status = palette_text_add(
			reader, &reader->source, &image.id, fault);
	if (status)
		return status;
	if (array_grow(&palette->images, 1))
		return fault_memory(fault);
	palette->images.at[palette->images.count++] = image;
	return TCS_OK;
}

/* Whether it is there is looked up once for each URI. */
static enum tcs_status
image_look_up(struct gml_reader *reader, struct tcs_fault *fault)
{
	const struct folder_limit limit = {UINT64_MAX, ""};
	const char *reason, *uri = reader->texture.uri.at;
	struct folder_file file;
	enum tcs_status status;
	uint32_t number;
	bool added;

	if (!reader->folder.name || !reader->texture.uri.count)
		return TCS_OK;
	status = keys_add(&reader->files, uri, &number, &added, fault);
	if (status || !added)
		return status;
	status = folder_open_file(
		&reader->folder, uri, &limit, &file, &reason, fault);
	if (status)
		return status;
	if (reason)
		return report_item(&reader->images_found, REPORT_NOTE, "image",
			reason, uri, TCS_NOWHERE, fault);
	close(file.file);
	return report_add(&reader->images_found, "images present", 1, fault);
}

/* All that a texture says is its key, line by line. */
enum tcs_status
image_intern(struct gml_reader *reader, uint32_t *out, struct tcs_fault *fault)
{
	const struct texture_text *texture = &reader->texture;
	size_t size = texture->uri.count + texture->mime.count +
		texture->type.count + texture->wrap.count +
		texture->border.count + reader->source.count + 6;
	char *key = malloc(size);
	enum tcs_status status;
	bool added = false;

	if (!key)
		return fault_memory(fault);
	snprintf(key, size, "%s\n%s\n%s\n%s\n%s\n%s", texture->uri.at,
		texture->mime.at, texture->type.at, texture->wrap.at,
		texture->border.at, reader->source.at);
	status = keys_add(&reader->images, key, out, &added, fault);
	free(key);
	if (!status && added)
		status = image_add(reader, fault);
	if (!status && added)
		status = report_add(&reader->images_found, "images", 1, fault);
	return status || !added ? status : image_look_up(reader, fault);
}
