#include <math.h>
#include <string.h>

#include "tcs.h"
#include "tcs_codec.h"

const char *
palette_text(const struct tcs_palette *palette, tcs_text text)
{
	return text ? palette->text.at + text : "";
}

void
palette_release(struct tcs_palette *palette)
{
	array_release(&palette->text);
	array_release(&palette->images);
	array_release(&palette->materials);
	array_release(&palette->bytes);
}

void
palette_clear(struct tcs_palette *palette)
{
	array_clear(&palette->text);
	array_clear(&palette->images);
	array_clear(&palette->materials);
	array_clear(&palette->bytes);
}

/* Append the text of `more`; *shift is what its offsets grow by. */
static enum tcs_status
append_text(struct tcs_palette *all, const struct tcs_palette *more,
	tcs_text *shift, struct tcs_fault *fault)
{
	size_t length = more->text.count;

	*shift = 0;
	if (length < 2)
		return TCS_OK;
	if (length > UINT32_MAX - all->text.count)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"the text of one palette exceeds 4 GiB");
	if (array_grow(&all->text, length))
		return fault_memory(fault);
	if (!all->text.count)
		all->text.at[all->text.count++] = '\0';
	*shift = (tcs_text)all->text.count - 1;
	memcpy(all->text.at + all->text.count, more->text.at + 1, length - 1);
	all->text.count += length - 1;
	return TCS_OK;
}

static tcs_text
shifted(tcs_text text, tcs_text shift)
{
	return text ? text + shift : 0;
}

static void
append_images(
	struct tcs_palette *all, const struct tcs_palette *more, tcs_text shift)
{
	for (size_t i = 0; i < more->images.count; i++) {
		struct tcs_image image = more->images.at[i];

		image.id = shifted(image.id, shift);
		image.uri = shifted(image.uri, shift);
		image.mime = shifted(image.mime, shift);
		image.type = shifted(image.type, shift);
		image.first_byte += all->bytes.count;
		all->images.at[all->images.count++] = image;
	}
}

static void
append_materials(
	struct tcs_palette *all, const struct tcs_palette *more, tcs_text shift)
{
	for (size_t i = 0; i < more->materials.count; i++) {
		struct tcs_material material = more->materials.at[i];

		material.id = shifted(material.id, shift);
		all->materials.at[all->materials.count++] = material;
	}
}

enum tcs_status
palette_append(struct tcs_palette *all, const struct tcs_palette *more,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	tcs_text shift;

	if (array_grow(&all->images, more->images.count) ||
		array_grow(&all->materials, more->materials.count) ||
		array_grow(&all->bytes, more->bytes.count))
		return fault_memory(fault);
	status = append_text(all, more, &shift, fault);
	if (status)
		return status;
	append_images(all, more, shift);
	append_materials(all, more, shift);
	if (more->bytes.count)
		memcpy(all->bytes.at + all->bytes.count, more->bytes.at,
			more->bytes.count);
	all->bytes.count += more->bytes.count;
	return TCS_OK;
}

static bool
floats_are_finite(const float *at, size_t count)
{
	for (size_t i = 0; i < count; i++)
		if (!isfinite(at[i]))
			return false;
	return true;
}

static enum tcs_status
check_images(const struct tcs_palette *palette, uint64_t where,
	struct tcs_fault *fault)
{
	uint64_t next = 0;

	for (size_t i = 0; i < palette->images.count; i++) {
		const struct tcs_image *image = &palette->images.at[i];

		if (image->wrap > TCS_WRAP_BORDER ||
			!floats_are_finite(image->border, 4))
			return fault_set(fault, TCS_BAD_INPUT, where,
				"image %zu of a palette has a value out of "
				"range",
				i);
		if (image->first_byte != next ||
			image->byte_count > palette->bytes.count - next)
			return fault_set(fault, TCS_BAD_INPUT, where,
				"the bytes of image %zu of a palette do not "
				"follow those before",
				i);
		next += image->byte_count;
	}
	if (next != palette->bytes.count)
		return fault_set(fault, TCS_BAD_INPUT, where,
			"a palette has bytes that no image owns");
	return TCS_OK;
}

static enum tcs_status
check_materials(const struct tcs_palette *palette, uint64_t where,
	struct tcs_fault *fault)
{
	for (size_t i = 0; i < palette->materials.count; i++) {
		const struct tcs_material *material = &palette->materials.at[i];

		if (material->smooth > 1 ||
			!floats_are_finite(material->diffuse, 3) ||
			!floats_are_finite(material->emissive, 3) ||
			!floats_are_finite(material->specular, 3) ||
			!isfinite(material->ambient) ||
			!isfinite(material->shininess) ||
			!isfinite(material->transparency))
			return fault_set(fault, TCS_BAD_INPUT, where,
				"material %zu of a palette has a value out of "
				"range",
				i);
	}
	return TCS_OK;
}

enum tcs_status
palette_decode(struct tcs_palette *out, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		record_decode(out, &layout_palette, record, fault);

	if (!status)
		status = check_images(out, record->at, fault);
	if (!status)
		status = check_materials(out, record->at, fault);
	return status;
}

enum tcs_status
palette_encode(const struct tcs_palette *palette, struct tcs_record *record,
	struct tcs_fault *fault)
{
	record->type = TCS_PALETTE;
	return record_encode(palette, &layout_palette, record, fault);
}
