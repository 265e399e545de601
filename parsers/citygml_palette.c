#include "citygml_palette.h"

#include <string.h>
#include <unistd.h>

void
palette_numbers_release(struct palette_numbers *numbers)
{
	digests_release(&numbers->materials);
	digests_release(&numbers->images);
	keys_release(&numbers->files);
	folder_close(&numbers->folder);
	report_release(&numbers->found);
	palette_release(&numbers->fresh);
	array_release(&numbers->material_numbers);
	array_release(&numbers->image_numbers);
	array_release(&numbers->key);
}

/* ---- keys ------------------------------------------------------------------- */

static enum tcs_status
key_add(struct palette_numbers *numbers, const void *bytes, size_t length,
	struct tcs_fault *fault)
{
	if (array_grow(&numbers->key, length))
		return fault_memory(fault);
	if (length)
		memcpy(numbers->key.at + numbers->key.count, bytes, length);
	numbers->key.count += length;
	return TCS_OK;
}

/* With the NUL behind it. */
static enum tcs_status
key_add_text(struct palette_numbers *numbers, const char *text,
	struct tcs_fault *fault)
{
	return key_add(numbers, text, strlen(text) + 1, fault);
}

static enum tcs_status
text_copy(struct palette_numbers *numbers, const struct tcs_palette *from,
	tcs_text text, tcs_text *to, struct tcs_fault *fault)
{
	const char *string = palette_text(from, text);

	return text_append(&numbers->fresh, string, strlen(string), to, fault);
}

/* ---- materials --------------------------------------------------------------- */

/* The material's fields, and its id, are its key. */
static enum tcs_status
material_number(struct palette_numbers *numbers,
	const struct tcs_palette *palette, const struct tcs_material *material,
	uint32_t *out, struct tcs_fault *fault)
{
	const char *id = palette_text(palette, material->id);
	struct tcs_material fields = *material;
	enum tcs_status status;
	bool added = false;

	fields.id = 0;
	array_clear(&numbers->key);
	status = key_add(numbers, &fields, sizeof fields, fault);
	if (!status)
		status = key_add_text(numbers, id, fault);
	if (!status)
		status = digests_add(&numbers->materials, numbers->key.at,
			numbers->key.count, out, &added, fault);
	if (status || !added)
		return status;
	if (array_grow(&numbers->fresh.materials, 1))
		return fault_memory(fault);
	numbers->fresh.materials.at[numbers->fresh.materials.count] = fields;
	return text_copy(numbers, palette, material->id,
		&numbers->fresh.materials.at[numbers->fresh.materials.count++]
			 .id,
		fault);
}

/* ---- images ------------------------------------------------------------------ */

static enum tcs_status
image_copy(struct palette_numbers *numbers, const struct tcs_palette *palette,
	const struct tcs_image *image, struct tcs_fault *fault)
{
	struct tcs_image copy = *image;
	enum tcs_status status =
		text_copy(numbers, palette, image->id, &copy.id, fault);

	if (!status)
		status = text_copy(
			numbers, palette, image->uri, &copy.uri, fault);
	if (!status)
		status = text_copy(
			numbers, palette, image->mime, &copy.mime, fault);
	if (!status)
		status = text_copy(
			numbers, palette, image->type, &copy.type, fault);
	if (status)
		return status;
	if (array_grow(&numbers->fresh.images, 1) ||
		array_grow(&numbers->fresh.bytes, image->byte_count))
		return fault_memory(fault);
	copy.first_byte = numbers->fresh.bytes.count;
	if (image->byte_count)
		memcpy(numbers->fresh.bytes.at + copy.first_byte,
			palette->bytes.at + image->first_byte,
			image->byte_count);
	numbers->fresh.bytes.count += image->byte_count;
	numbers->fresh.images.at[numbers->fresh.images.count++] = copy;
	return TCS_OK;
}

/* Whether it is there is looked up once for each URI. */
static enum tcs_status
image_look_up(struct palette_numbers *numbers, const char *uri,
	struct tcs_fault *fault)
{
	const struct folder_limit limit = {UINT64_MAX, ""};
	struct folder_file file;
	enum tcs_status status;
	const char *reason;
	uint32_t number;
	bool added;

	if (!numbers->folder.name || !*uri)
		return TCS_OK;
	status = keys_add(&numbers->files, uri, &number, &added, fault);
	if (status || !added)
		return status;
	status = folder_open_file(
		&numbers->folder, uri, &limit, &file, &reason, fault);
	if (status)
		return status;
	if (reason)
		return report_item(&numbers->found, REPORT_NOTE, "image",
			reason, uri, TCS_NOWHERE, fault);
	close(file.file);
	return report_add(&numbers->found, "images present", 1, fault);
}

/* All that a texture says is its key, line by line. */
static enum tcs_status
image_number(struct palette_numbers *numbers, const struct tcs_palette *palette,
	const struct tcs_image *image, uint32_t *out, struct tcs_fault *fault)
{
	const tcs_text texts[] = {
		image->uri, image->mime, image->type, image->id};
	enum tcs_status status = TCS_OK;
	bool added = false;

	array_clear(&numbers->key);
	for (size_t i = 0; !status && i < sizeof texts / sizeof *texts; i++)
		status = key_add_text(
			numbers, palette_text(palette, texts[i]), fault);
	if (!status)
		status = key_add(
			numbers, &image->wrap, sizeof image->wrap, fault);
	if (!status)
		status = key_add(
			numbers, image->border, sizeof image->border, fault);
	if (!status && image->byte_count)
		status = key_add(numbers, palette->bytes.at + image->first_byte,
			image->byte_count, fault);
	if (!status)
		status = digests_add(&numbers->images, numbers->key.at,
			numbers->key.count, out, &added, fault);
	if (!status && added)
		status = image_copy(numbers, palette, image, fault);
	if (!status && added)
		status = report_add(&numbers->found, "images", 1, fault);
	if (status || !added || image->byte_count)
		return status;
	return image_look_up(numbers, palette_text(palette, image->uri), fault);
}

/* ---- all of an object's ------------------------------------------------------- */

enum tcs_status
palette_number(struct palette_numbers *numbers,
	const struct tcs_palette *palette, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	array_clear(&numbers->material_numbers);
	array_clear(&numbers->image_numbers);
	if (array_grow(&numbers->material_numbers, palette->materials.count) ||
		array_grow(&numbers->image_numbers, palette->images.count))
		return fault_memory(fault);
	for (size_t i = 0; !status && i < palette->materials.count; i++)
		status = material_number(numbers, palette,
			&palette->materials.at[i],
			&numbers->material_numbers
				 .at[numbers->material_numbers.count++],
			fault);
	for (size_t i = 0; !status && i < palette->images.count; i++)
		status = image_number(numbers, palette, &palette->images.at[i],
			&numbers->image_numbers
				 .at[numbers->image_numbers.count++],
			fault);
	return status;
}

static bool
is_marked(uint32_t number)
{
	return number != TCS_NONE && number & PALETTE_OWN;
}

uint32_t
palette_material(const struct palette_numbers *numbers, uint32_t material)
{
	return is_marked(material)
		? numbers->material_numbers.at[material - PALETTE_OWN]
		: material;
}

uint32_t
palette_image(const struct palette_numbers *numbers, uint32_t image)
{
	return is_marked(image) ? numbers->image_numbers.at[image - PALETTE_OWN]
				: image;
}

enum tcs_status
palette_renumber(const struct palette_numbers *numbers,
	struct tcs_record *record, struct tcs_fault *fault)
{
	struct tcs_paint *paints;
	size_t count;
	enum tcs_status status = record_paints(record, &paints, &count, fault);

	for (size_t i = 0; !status && i < count; i++) {
		paints[i].material =
			palette_material(numbers, paints[i].material);
		paints[i].image = palette_image(numbers, paints[i].image);
	}
	return status;
}
