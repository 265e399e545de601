/*
 * Appearances: themes, and the materials and textures they put on surfaces.
 *
 * Materials and images join the stream's palette when first met, equal ones
 * once. The targets of a feature's own appearance wait in its raw object; those
 * of a global appearance go through a raw object of their own into the store,
 * one surface data element at a time.
 *
 * source: CityGML 2.0 (OGC 12-019) clause 9.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_reader.h"
#include "number.h"

static const struct tcs_material plain_material = {
	.diffuse = {0.8f, 0.8f, 0.8f},
	.specular = {1, 1, 1},
	.ambient = 0.2f,
	.shininess = 0.2f,
};

/* ---- the palette ------------------------------------------------------------ */

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

/* The material's fields are its key, as hexadecimal digits. */
static enum tcs_status
material_intern(
	struct gml_reader *reader, uint32_t *out, struct tcs_fault *fault)
{
	const unsigned char *bytes = (const unsigned char *)&reader->material;
	char key[2 * sizeof reader->material + 1];
	struct tcs_palette *palette = &reader->palette;
	enum tcs_status status;
	bool added;

	for (size_t i = 0; i < sizeof reader->material; i++) {
		key[2 * i] = (char)('a' + (bytes[i] >> 4));
		key[2 * i + 1] = (char)('a' + (bytes[i] & 15));
	}
	key[sizeof key - 1] = 0;
	status = keys_add(&reader->materials, key, out, &added, fault);
	if (status || !added)
		return status;
	if (array_grow(&palette->materials, 1))
		return fault_memory(fault);
	palette->materials.at[palette->materials.count++] = reader->material;
	return TCS_OK;
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
	int count = gml_numbers(
		texture->border.at, texture->border.count, border, 4);
	enum tcs_status status;

	for (int i = 0; i < count; i++)
		image.border[i] = (float)border[i];
	status = text_append(palette, texture->uri.at, texture->uri.count,
		&image.uri, fault);
	if (!status)
		status = text_append(palette, texture->mime.at,
			texture->mime.count, &image.mime, fault);
	if (!status)
		status = text_append(palette, texture->type.at,
			texture->type.count, &image.type, fault);
	if (status)
		return status;
	if (array_grow(&palette->images, 1))
		return fault_memory(fault);
	palette->images.at[palette->images.count++] = image;
	return TCS_OK;
}

/* All that a texture says is its key, line by line. */
static enum tcs_status
image_intern(struct gml_reader *reader, uint32_t *out, struct tcs_fault *fault)
{
	const struct texture_text *texture = &reader->texture;
	size_t size = texture->uri.count + texture->mime.count +
		texture->type.count + texture->wrap.count +
		texture->border.count + 5;
	char *key = malloc(size);
	enum tcs_status status;
	bool added = false;

	if (!key)
		return fault_memory(fault);
	snprintf(key, size, "%.*s\n%.*s\n%.*s\n%.*s\n%.*s",
		(int)texture->uri.count, texture->uri.at,
		(int)texture->mime.count, texture->mime.at,
		(int)texture->type.count, texture->type.at,
		(int)texture->wrap.count, texture->wrap.at,
		(int)texture->border.count, texture->border.at);
	status = keys_add(&reader->images, key, out, &added, fault);
	free(key);
	return status || !added ? status : image_add(reader, fault);
}

/* ---- targets ------------------------------------------------------------------ */

static enum tcs_status
target_add(struct gml_reader *reader, const char *at, size_t length,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint *paint;
	enum tcs_status status;

	if (length && *at == '#')
		at++, length--;
	if (!length)
		return TCS_OK;
	if (array_grow(&raw->paints, 1))
		return fault_memory(fault);
	paint = &raw->paints.at[raw->paints.count++];
	*paint = (struct raw_paint){
		.material = TCS_NONE,
		.image = TCS_NONE,
		.first_ring = (uint32_t)raw->texrings.count,
	};
	status = gml_text(reader, reader->theme.at, reader->theme.count,
		&paint->theme, fault);
	if (!status)
		status = gml_text(reader, at, length, &paint->target, fault);
	return status;
}

/* A material names its target as text, a texture as an attribute. */
static enum tcs_status
target_begin(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *uri =
		attribute_find(attributes, count, "uri");

	frame->wants_text = !uri;
	return uri ? target_add(reader, uri->value, uri->length, fault)
		   : TCS_OK;
}

static enum tcs_status
target_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	return target_add(reader, at, length, fault);
}

/* ---- values ---------------------------------------------------------------------- */

static void
read_numbers(struct gml_reader *reader, float *out, int want)
{
	double values[3];
	int count =
		gml_numbers(reader->text.at, reader->text.count, values, want);

	for (int i = 0; i < count; i++)
		if (values[i] >= 0 && values[i] <= 1)
			out[i] = (float)values[i];
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
material_value_end(struct gml_reader *reader, const struct name *name)
{
	struct tcs_material *material = &reader->material;
	const struct {
		const char *name;
		float *to;
		int count;
	} values[] = {
		{"ambientIntensity", &material->ambient, 1},
		{"diffuseColor", material->diffuse, 3},
		{"emissiveColor", material->emissive, 3},
		{"shininess", &material->shininess, 1},
		{"specularColor", material->specular, 3},
		{"transparency", &material->transparency, 1},
	};

	if (!strcmp(name->local, "isFront"))
		reader->back = !read_boolean(reader);
	if (!strcmp(name->local, "isSmooth"))
		material->smooth = read_boolean(reader);
	for (size_t i = 0; i < sizeof values / sizeof *values; i++)
		if (!strcmp(name->local, values[i].name))
			read_numbers(reader, values[i].to, values[i].count);
}

static enum tcs_status
keep_text(struct gml_reader *reader, void *array, struct tcs_fault *fault)
{
	TCS_ARRAY_TYPE(kept, char) *to = array;
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	to->count = 0;
	if (array_grow(to, length + 1))
		return fault_memory(fault);
	memcpy(to->at, at, length);
	to->count = length;
	return TCS_OK;
}

static enum tcs_status
texture_value_end(struct gml_reader *reader, const struct name *name,
	struct tcs_fault *fault)
{
	struct texture_text *texture = &reader->texture;

	switch (name->local[0]) {
	case 'i':
		return keep_text(reader, &texture->uri, fault);
	case 'm':
		return keep_text(reader, &texture->mime, fault);
	case 't':
		return keep_text(reader, &texture->type, fault);
	case 'w':
		return keep_text(reader, &texture->wrap, fault);
	default:
		return keep_text(reader, &texture->border, fault);
	}
}

/* ---- texture coordinates ------------------------------------------------------------ */

static struct raw_paint *
paint_last(struct gml_reader *reader)
{
	struct raw_object *raw = reader->raw;

	return raw->paints.count > reader->first_paint
		? &raw->paints.at[raw->paints.count - 1]
		: NULL;
}

static enum tcs_status
texring_begin(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *id =
		attribute_find(attributes, count, "ring");
	struct raw_object *raw = reader->raw;
	struct raw_texring *ring;
	size_t skip;

	if (!id || !paint_last(reader))
		return TCS_OK;
	frame->wants_text = true;
	if (array_grow(&raw->texrings, 1))
		return fault_memory(fault);
	ring = &raw->texrings.at[raw->texrings.count++];
	*ring = (struct raw_texring){0};
	skip = id->length && *id->value == '#';
	return gml_text(reader, id->value + skip, id->length - skip,
		&ring->ring, fault);
}

static enum tcs_status
texring_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint *paint = paint_last(reader);
	struct raw_texring *ring;
	size_t length = reader->text.count;

	if (!paint || !raw->texrings.count)
		return TCS_OK;
	if (array_grow(&raw->positions, length + 1))
		return fault_memory(fault);
	ring = &raw->texrings.at[raw->texrings.count - 1];
	ring->first = raw->positions.count;
	ring->length = length;
	memcpy(raw->positions.at + ring->first, reader->text.at, length);
	raw->positions.count += length;
	paint->mapping = MAPPING_LIST;
	paint->ring_count = (uint32_t)raw->texrings.count - paint->first_ring;
	return TCS_OK;
}

static enum tcs_status
texmatrix_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint *paint = paint_last(reader);
	struct raw_texmatrix *matrix;

	if (!paint)
		return TCS_OK;
	if (array_grow(&raw->texmatrices, 1))
		return fault_memory(fault);
	matrix = &raw->texmatrices.at[raw->texmatrices.count];
	if (gml_numbers(reader->text.at, reader->text.count, matrix->at, 12) !=
		12)
		return TCS_OK;
	paint->mapping = MAPPING_MATRIX;
	paint->matrix = (uint32_t)raw->texmatrices.count++;
	return TCS_OK;
}

/* ---- surface data --------------------------------------------------------------------- */

/* Its paints go to the store when the appearance is of the whole model. */
static enum tcs_status
surface_data_store(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < raw->paints.count; i++)
		status = store_add(
			&reader->store, raw, &raw->paints.at[i], fault);
	if (!status)
		status = report_merge(&reader->report, &raw->report, fault);
	raw_clear(raw);
	return status;
}

static enum tcs_status
surface_data_end(struct gml_reader *reader, const struct name *name,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	uint32_t material = TCS_NONE, image = TCS_NONE;
	enum tcs_status status = TCS_OK;

	if (raw->paints.count == reader->first_paint)
		return TCS_OK;
	if (name->kind == NAME_MATERIAL)
		status = material_intern(reader, &material, fault);
	else
		status = image_intern(reader, &image, fault);
	if (status)
		return status;
	for (size_t i = reader->first_paint; i < raw->paints.count; i++) {
		raw->paints.at[i].material = material;
		raw->paints.at[i].image = image;
		raw->paints.at[i].back = reader->back;
	}
	return reader->pass == PASS_APPEARANCES
		? surface_data_store(reader, fault)
		: TCS_OK;
}

static enum tcs_status
surface_data_begin(struct gml_reader *reader, const struct name *name)
{
	struct texture_text *texture = &reader->texture;

	reader->first_paint = (uint32_t)reader->raw->paints.count;
	reader->back = false;
	if (name->kind == NAME_MATERIAL)
		reader->material = plain_material;
	texture->uri.count = texture->mime.count = texture->type.count = 0;
	texture->wrap.count = texture->border.count = 0;
	return TCS_OK;
}

/* ---- elements --------------------------------------------------------------------------- */

/* Where its image lies says a file beside the image, or numbers that need the
 * image's size. */
static enum tcs_status
georeferenced_skip(struct gml_reader *reader, struct tcs_fault *fault)
{
	enum tcs_status status = gml_skipped(reader, "texture",
		"georeferenced ones are not read", NULL, fault);

	return status ? status : gml_skip(reader);
}

enum tcs_status
appearance_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	enum tcs_status status;
	struct frame *frame;

	if (name->kind == NAME_TEXTURE &&
		!strcmp(name->local, "GeoreferencedTexture"))
		return georeferenced_skip(reader, fault);
	status = gml_push(reader, name, ROLE_APPEARANCE, &frame, fault);
	if (status)
		return status;
	switch (name->kind) {
	case NAME_APPEARANCE:
		reader->theme.count = 0;
		return TCS_OK;
	case NAME_MATERIAL:
	case NAME_TEXTURE:
		return surface_data_begin(reader, name);
	case NAME_TARGET:
		return target_begin(reader, frame, attributes, count, fault);
	case NAME_TEXTURE_RING:
		return texring_begin(reader, frame, attributes, count, fault);
	case NAME_THEME:
	case NAME_MATERIAL_VALUE:
	case NAME_TEXTURE_VALUE:
	case NAME_TEXTURE_MATRIX:
		frame->wants_text = true;
		return TCS_OK;
	default:
		return TCS_OK;
	}
}

enum tcs_status
appearance_end(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	switch (frame->name->kind) {
	case NAME_THEME:
		return keep_text(reader, &reader->theme, fault);
	case NAME_TARGET:
		return frame->wants_text ? target_end(reader, fault) : TCS_OK;
	case NAME_MATERIAL_VALUE:
		material_value_end(reader, frame->name);
		return TCS_OK;
	case NAME_TEXTURE_VALUE:
		return texture_value_end(reader, frame->name, fault);
	case NAME_TEXTURE_RING:
		return frame->wants_text ? texring_end(reader, fault) : TCS_OK;
	case NAME_TEXTURE_MATRIX:
		return texmatrix_end(reader, fault);
	case NAME_MATERIAL:
	case NAME_TEXTURE:
		return surface_data_end(reader, frame->name, fault);
	default:
		return TCS_OK;
	}
}

void
appearance_release(struct gml_reader *reader)
{
	array_release(&reader->theme);
	array_release(&reader->texture.uri);
	array_release(&reader->texture.mime);
	array_release(&reader->texture.type);
	array_release(&reader->texture.wrap);
	array_release(&reader->texture.border);
	keys_release(&reader->materials);
	keys_release(&reader->images);
	palette_release(&reader->palette);
	store_release(&reader->store);
}
