/*
 * Appearances: themes, and the X3D materials they put on surfaces.
 *
 * Materials join the stream's palette when first met, equal ones once. The
 * targets of a feature's own appearance wait in its raw object; those of a
 * global appearance are kept for every object to look up.
 *
 * source: CityGML 2.0 (OGC 12-019) clause 9.
 */
#include "citygml_reader.h"

#include <stdlib.h>
#include <string.h>

#include "number.h"

static const struct tcs_material plain_material = {
	.diffuse = {0.8f, 0.8f, 0.8f},
	.specular = {1, 1, 1},
	.ambient = 0.2f,
	.shininess = 0.2f,
};

/* ---- the palette ------------------------------------------------------------ */

static size_t
material_hash(const struct tcs_material *material)
{
	const unsigned char *bytes = (const unsigned char *)material;
	uint64_t hash = 14695981039346656037u;

	for (size_t i = 0; i < sizeof *material; i++)
		hash = (hash ^ bytes[i]) * 1099511628211u;
	return (size_t)(hash ^ hash >> 32);
}

static int
slots_grow(struct gml_reader *reader)
{
	size_t room = reader->material_slots.count
		? reader->material_slots.count * 2
		: 64;

	array_clear(&reader->material_slots);
	if (array_grow(&reader->material_slots, room))
		return -1;
	reader->material_slots.count = room;
	memset(reader->material_slots.at, 0xff, room * sizeof(uint32_t));
	for (size_t i = 0; i < reader->palette.materials.count; i++) {
		size_t slot = material_hash(&reader->palette.materials.at[i]);

		while (reader->material_slots.at[slot & (room - 1)] != TCS_NONE)
			slot++;
		reader->material_slots.at[slot & (room - 1)] = (uint32_t)i;
	}
	return 0;
}

/* The palette entry equal to the material just read, added if new. */
static enum tcs_status
material_intern(
	struct gml_reader *reader, uint32_t *out, struct tcs_fault *fault)
{
	struct tcs_palette *palette = &reader->palette;
	size_t slot, mask;

	if (palette->materials.count * 2 >= reader->material_slots.count &&
		slots_grow(reader))
		return fault_memory(fault);
	mask = reader->material_slots.count - 1;
	slot = material_hash(&reader->material) & mask;
	for (; reader->material_slots.at[slot] != TCS_NONE;
		slot = (slot + 1) & mask) {
		*out = reader->material_slots.at[slot];
		if (!memcmp(&palette->materials.at[*out], &reader->material,
			    sizeof reader->material))
			return TCS_OK;
	}
	if (array_grow(&palette->materials, 1))
		return fault_memory(fault);
	*out = (uint32_t)palette->materials.count;
	palette->materials.at[palette->materials.count++] = reader->material;
	reader->material_slots.at[slot] = *out;
	return TCS_OK;
}

enum tcs_status
appearance_hand_over(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct tcs_palette *given = &reader->raw->palette;
	size_t count = reader->palette.materials.count - reader->palette_taken;

	if (!count)
		return TCS_OK;
	if (array_grow(&given->materials, count))
		return fault_memory(fault);
	memcpy(given->materials.at + given->materials.count,
		reader->palette.materials.at + reader->palette_taken,
		count * sizeof *given->materials.at);
	given->materials.count += count;
	reader->palette_taken += count;
	return TCS_OK;
}

/* ---- targets ------------------------------------------------------------------ */

static enum tcs_status
global_target(struct gml_reader *reader, const char *at, size_t length,
	struct tcs_fault *fault)
{
	struct gml_paint *paint;

	if (array_grow(&reader->paints, 1))
		return fault_memory(fault);
	paint = &reader->paints.at[reader->paints.count];
	*paint = (struct gml_paint){
		.theme = strndup(reader->theme.at ? reader->theme.at : "",
			reader->theme.count),
		.target = strndup(at, length),
		.material = TCS_NONE,
	};
	reader->paints.count++;
	return paint->theme && paint->target ? TCS_OK : fault_memory(fault);
}

static enum tcs_status
local_target(struct gml_reader *reader, const char *at, size_t length,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint *paint;
	enum tcs_status status;

	if (array_grow(&raw->paints, 1))
		return fault_memory(fault);
	paint = &raw->paints.at[raw->paints.count++];
	*paint = (struct raw_paint){.material = TCS_NONE};
	status = gml_text(reader, reader->theme.at, reader->theme.count,
		&paint->theme, fault);
	if (!status)
		status = gml_text(reader, at, length, &paint->target, fault);
	return status;
}

static enum tcs_status
target_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	if (length && *at == '#')
		at++, length--;
	if (!length)
		return TCS_OK;
	return reader->raw ? local_target(reader, at, length, fault)
			   : global_target(reader, at, length, fault);
}

/* ---- materials ------------------------------------------------------------------ */

static void
read_numbers(struct gml_reader *reader, float *out, int count)
{
	const char *at = reader->text.at;
	const char *end = at + reader->text.count;

	for (int i = 0; i < count && at; i++) {
		double value;

		while (at < end && (unsigned char)*at <= ' ')
			at++;
		at = number_parse(at, end, &value);
		if (at && value >= 0 && value <= 1)
			out[i] = (float)value;
	}
}

static bool
read_boolean(struct gml_reader *reader)
{
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	return length && (*at == 't' || *at == '1');
}

static void
value_end(struct gml_reader *reader, const struct name *name)
{
	struct tcs_material *material = &reader->material;

	switch (name->local[0]) {
	case 'a':
		read_numbers(reader, &material->ambient, 1);
		break;
	case 'd':
		read_numbers(reader, material->diffuse, 3);
		break;
	case 'e':
		read_numbers(reader, material->emissive, 3);
		break;
	case 't':
		read_numbers(reader, &material->transparency, 1);
		break;
	case 'i':
		if (!strcmp(name->local, "isSmooth"))
			material->smooth = read_boolean(reader);
		else
			reader->back = !read_boolean(reader);
		break;
	default:
		if (!strcmp(name->local, "shininess"))
			read_numbers(reader, &material->shininess, 1);
		else
			read_numbers(reader, material->specular, 3);
	}
}

static enum tcs_status
material_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	enum tcs_status status;
	uint32_t material = TCS_NONE;

	status = material_intern(reader, &material, fault);
	if (status)
		return status;
	if (reader->raw)
		for (size_t i = reader->first_paint;
			i < reader->raw->paints.count; i++) {
			reader->raw->paints.at[i].material = material;
			reader->raw->paints.at[i].back = reader->back;
		}
	else
		for (size_t i = reader->first_paint; i < reader->paints.count;
			i++) {
			reader->paints.at[i].material = material;
			reader->paints.at[i].back = reader->back;
		}
	return TCS_OK;
}

/* ---- elements --------------------------------------------------------------------- */

enum tcs_status
appearance_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	struct frame *frame;

	(void)attributes;
	(void)count;
	if (name->kind == NAME_TEXTURE) {
		status = gml_skipped(reader, "texture",
			"images are not read yet", NULL, fault);
		if (status)
			return status;
		return gml_push(reader, name, ROLE_SKIP, NULL, fault);
	}
	status = gml_push(reader, name, ROLE_APPEARANCE, &frame, fault);
	if (status)
		return status;
	frame->wants_text = name->kind == NAME_THEME ||
		name->kind == NAME_TARGET || name->kind == NAME_MATERIAL_VALUE;
	if (name->kind == NAME_APPEARANCE)
		reader->theme.count = 0;
	if (name->kind == NAME_MATERIAL) {
		reader->material = plain_material;
		reader->back = false;
		reader->first_paint =
			(uint32_t)(reader->raw ? reader->raw->paints.count
					       : reader->paints.count);
	}
	return TCS_OK;
}

static enum tcs_status
theme_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	array_clear(&reader->theme);
	if (array_grow(&reader->theme, length))
		return fault_memory(fault);
	if (length)
		memcpy(reader->theme.at, at, length);
	reader->theme.count = length;
	return TCS_OK;
}

enum tcs_status
appearance_end(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	switch (frame->name->kind) {
	case NAME_THEME:
		return theme_end(reader, fault);
	case NAME_TARGET:
		return target_end(reader, fault);
	case NAME_MATERIAL_VALUE:
		value_end(reader, frame->name);
		return TCS_OK;
	case NAME_MATERIAL:
		return material_end(reader, fault);
	default:
		return TCS_OK;
	}
}

void
appearance_release(struct gml_reader *reader)
{
	for (size_t i = 0; i < reader->paints.count; i++) {
		free(reader->paints.at[i].theme);
		free(reader->paints.at[i].target);
	}
	array_release(&reader->paints);
	array_release(&reader->theme);
	array_release(&reader->material_slots);
	palette_release(&reader->palette);
}
