#include "gltf_material.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gltf_mesh.h"
#include "gltf_texture.h"
#include "labels.h"
#include "tcs.h"

static double
clamp_unit(double value)
{
	return value > 0 ? (value < 1 ? value : 1) : 0;
}

double
colour_linear(double srgb)
{
	double value = clamp_unit(srgb);

	return value <= 0.04045 ? value / 12.92
				: pow((value + 0.055) / 1.055, 2.4);
}

static struct material_look
class_look(unsigned class)
{
	uint32_t colour = label_of(class)->colour;
	struct material_look look = {.colour = {0, 0, 0, 1},
		.roughness = 0.9,
		.texture = MATERIAL_PLAIN};

	for (int k = 0; k < 3; k++)
		look.colour[k] = colour_linear(
			(double)(colour >> (16 - 8 * k) & 0xff) / 255);
	return look;
}

static double
roughness(const struct tcs_material *material)
{
	double width = 2 / (2 + 128 * clamp_unit((double)material->shininess));
	double shine = 0;

	for (int k = 0; k < 3; k++)
		shine = fmax(shine, clamp_unit((double)material->specular[k]));
	return 1 - shine * (1 - pow(width, 0.25));
}

static struct material_look
stream_look(const struct tcs_material *material)
{
	struct material_look look = {.texture = MATERIAL_PLAIN};

	for (int k = 0; k < 3; k++) {
		look.colour[k] = colour_linear((double)material->diffuse[k]);
		look.emissive[k] = colour_linear((double)material->emissive[k]);
	}
	look.colour[3] = 1 - clamp_unit((double)material->transparency);
	look.roughness = roughness(material);
	return look;
}

static struct material_look
texture_look(const struct textures *textures, uint32_t number)
{
	const struct texture *texture = textures->list.at + number;

	return (struct material_look){
		.colour = {1, 1, 1, 1},
		.roughness = 0.9,
		.texture = number,
		.has_holes = textures->images.at[texture->image].kind.has_alpha,
	};
}

/* What makes two looks the same: their values, or their class. */
struct look_key {
	double values[8];
	double texture;
	double class; /* -1: a stream material */
	double double_sided;
};

static struct look_key
look_key(const struct material_look *look, double class)
{
	struct look_key key = {.class = class};

	memcpy(key.values, look->colour, sizeof look->colour);
	memcpy(key.values + 4, look->emissive, sizeof look->emissive);
	key.values[7] = look->roughness;
	key.texture = look->texture;
	key.double_sided = look->double_sided;
	return key;
}

static enum tcs_status
materials_make(struct materials *materials, uint32_t paint,
	const struct tcs_palette *palette, const struct textures *textures,
	uint32_t *number, struct tcs_fault *fault)
{
	uint32_t entry = paint & PAINT_NUMBER;
	bool is_class = false;
	struct material_look look;
	struct look_key key;
	const char *name;
	bool added;
	enum tcs_status status;

	if (paint & PAINT_TEXTURE) {
		look = texture_look(textures, entry);
		name = textures->images.at[textures->list.at[entry].image].name;
	} else if (paint & PAINT_MATERIAL && entry < palette->materials.count) {
		look = stream_look(palette->materials.at + entry);
		name = palette_text(palette, palette->materials.at[entry].id);
	} else {
		is_class = true;
		entry = paint & PAINT_MATERIAL ? TCS_CLASS_Unknown : entry;
		look = class_look(entry);
		name = label_of(entry)->name;
	}
	look.double_sided = (paint & PAINT_DOUBLE_SIDED) != 0;
	key = look_key(&look, is_class ? (double)entry : -1);
	status = byte_index_add(
		&materials->by_look, &key, sizeof key, number, &added, fault);
	if (status || !added)
		return status;
	look.name = strdup(*name ? name : "material");
	if (!look.name || array_grow(&materials->looks, 1)) {
		free(look.name);
		return fault_memory(fault);
	}
	materials->looks.at[materials->looks.count++] = look;
	return TCS_OK;
}

enum tcs_status
materials_find(struct materials *materials, uint32_t paint,
	const struct tcs_palette *palette, const struct textures *textures,
	uint32_t *number, struct tcs_fault *fault)
{
	uint32_t seen;
	bool added;
	enum tcs_status status = byte_index_add(&materials->by_paint, &paint,
		sizeof paint, &seen, &added, fault);

	if (status)
		return status;
	if (!added) {
		*number = materials->of_paint.at[seen];
		return TCS_OK;
	}
	if (array_grow(&materials->of_paint, 1))
		return fault_memory(fault);
	status = materials_make(
		materials, paint, palette, textures, number, fault);
	if (!status)
		materials->of_paint.at[materials->of_paint.count++] = *number;
	return status;
}

void
materials_release(struct materials *materials)
{
	for (size_t i = 0; i < materials->looks.count; i++)
		free(materials->looks.at[i].name);
	array_release(&materials->looks);
	byte_index_release(&materials->by_look);
	byte_index_release(&materials->by_paint);
	array_release(&materials->of_paint);
}
