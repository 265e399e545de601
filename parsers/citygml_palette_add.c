/*
 * What an appearance says of a material or a texture, as an entry of the
 * object's palette. What its number in the stream is comes later: see
 * citygml_palette.h.
 */
#include <string.h>

#include "citygml_numbers.h"
#include "citygml_reader.h"

static enum tcs_status
palette_text_add(struct gml_reader *reader, const struct kept_text *text,
	tcs_text *out, struct tcs_fault *fault)
{
	return text_append(
		&reader->raw->palette, text->at, text->count, out, fault);
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

enum tcs_status
material_add(struct gml_reader *reader, uint32_t *out, struct tcs_fault *fault)
{
	struct tcs_palette *palette = &reader->raw->palette;
	struct tcs_material *material;

	if (array_grow(&palette->materials, 1))
		return fault_memory(fault);
	*out = PALETTE_OWN | (uint32_t)palette->materials.count;
	material = &palette->materials.at[palette->materials.count++];
	*material = reader->material;
	return palette_text_add(reader, &reader->source, &material->id, fault);
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

enum tcs_status
image_add(struct gml_reader *reader, uint32_t *out, struct tcs_fault *fault)
{
	const struct texture_text *texture = &reader->texture;
	struct tcs_palette *palette = &reader->raw->palette;
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
	*out = PALETTE_OWN | (uint32_t)palette->images.count;
	palette->images.at[palette->images.count++] = image;
	return TCS_OK;
}
