/*
 * Appearances: themes, and the materials and textures they put on surfaces.
 *
 * Materials and images join the palette of the object. The targets of a feature's own appearance wait in its raw object; those
 * of a global appearance go through a raw object of their own into the store,
 * one surface data element at a time.
 *
 * source: CityGML 2.0 (OGC 12-019) clause 9.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_numbers.h"
#include "citygml_reader.h"
#include "number.h"

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
	if (!status)
		status = gml_text(reader, reader->source.at,
			reader->source.count, &paint->source, fault);
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
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");
	enum tcs_status status;

	frame->wants_text = !uri;
	if (!uri || !uri->length)
		return TCS_OK;
	status = target_add(reader, uri->value, uri->length, fault);
	return status || !href ? status : mapping_link(reader, href, fault);
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
	int count = numbers_first(
		reader->text.at, reader->text.count, values, want);

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
		if (*name->local == *values[i].name &&
			!strcmp(name->local, values[i].name))
			read_numbers(reader, values[i].to, values[i].count);
}

enum tcs_status
text_keep(struct kept_text *to, const char *bytes, size_t length,
	struct tcs_fault *fault)
{
	to->count = 0;
	if (array_grow(to, length + 1))
		return fault_memory(fault);
	if (length)
		memcpy(to->at, bytes, length);
	to->at[length] = 0;
	to->count = length;
	return TCS_OK;
}

enum tcs_status
gml_keep(struct gml_reader *reader, struct kept_text *to,
	struct tcs_fault *fault)
{
	const char *at;
	size_t length;

	gml_trimmed(reader, &at, &length);
	return text_keep(to, at, length, fault);
}

static enum tcs_status
texture_value_end(struct gml_reader *reader, const struct name *name,
	struct tcs_fault *fault)
{
	struct texture_text *texture = &reader->texture;

	if (!strcmp(name->local, "textureMap"))
		return gml_keep(reader, &texture->uri, fault);
	switch (name->local[0]) {
	case 'i':
		return gml_keep(reader, &texture->uri, fault);
	case 'r':
		return text_keep(&texture->wrap,
			read_boolean(reader) ? "wrap" : "none", 4, fault);
	case 'm':
		return gml_keep(reader, &texture->mime, fault);
	case 't':
		return gml_keep(reader, &texture->type, fault);
	case 'w':
		return gml_keep(reader, &texture->wrap, fault);
	default:
		return gml_keep(reader, &texture->border, fault);
	}
}

/* ---- surface data --------------------------------------------------------------------- */

/* Its paints go to the store when the appearance is of the whole model. */
static enum tcs_status
surface_data_store(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	enum tcs_status status =
		palette_number(&reader->numbers, &raw->palette, fault);

	for (size_t i = 0; !status && i < raw->paints.count; i++) {
		struct raw_paint *paint = &raw->paints.at[i];

		paint->material =
			palette_material(&reader->numbers, paint->material);
		paint->image = palette_image(&reader->numbers, paint->image);
		status = store_add(&reader->store, raw, paint, fault);
	}
	if (!status)
		status = report_merge(&reader->report, &raw->report, fault);
	raw_clear(raw);
	return status;
}

static bool
is_georeferenced(const struct name *name)
{
	return name->local[0] == 'G';
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
	if (gml_top(reader)->paints)
		status = textured_end(reader, fault);
	if (status)
		return status;
	if (name->kind == NAME_MATERIAL)
		status = material_add(reader, &material, fault);
	else
		status = image_add(reader, &image, fault);
	if (!status && is_georeferenced(name))
		status = georeference_apply(reader, fault);
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
surface_data_begin(struct gml_reader *reader, const struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *id = attribute_find_id(attributes, count);
	struct texture_text *texture = &reader->texture;
	struct kept_text *const texts[] = {&texture->uri, &texture->mime,
		&texture->type, &texture->wrap, &texture->border};
	enum tcs_status status = TCS_OK;

	reader->first_paint = (uint32_t)reader->raw->paints.count;
	reader->back = false;
	reader->georeference = (struct georeference){.has_anchor = false};
	if (name->kind == NAME_MATERIAL)
		reader->material = material_plain();
	for (size_t i = 0; !status && i < sizeof texts / sizeof *texts; i++)
		status = text_keep(texts[i], "", 0, fault);
	if (status)
		return status;
	return text_keep(&reader->source, id ? id->value : "",
		id ? id->length : 0, fault);
}

/* A material or texture of another theme, or of another appearance. */
static enum tcs_status
surface_data_link(struct gml_reader *reader, const struct xml_attribute *href,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	size_t skip = href->length && *href->value == '#';
	struct raw_alias *alias;
	enum tcs_status status;

	if (array_grow(&raw->aliases, 1))
		return fault_memory(fault);
	alias = &raw->aliases.at[raw->aliases.count++];
	*alias = (struct raw_alias){.theme = 0};
	status = gml_text(reader, reader->theme.at, reader->theme.count,
		&alias->theme, fault);
	if (!status)
		status = gml_text(reader, href->value + skip,
			href->length - skip, &alias->source, fault);
	if (status || reader->pass != PASS_APPEARANCES)
		return status;
	status = store_alias(&reader->store,
		object_text(&raw->tree, alias->theme),
		object_text(&raw->tree, alias->source), fault);
	raw_clear(raw);
	return status;
}

/* ---- elements --------------------------------------------------------------------------- */

enum tcs_status
appearance_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");
	enum tcs_status status;
	struct frame *frame;

	status = gml_push(reader, name, ROLE_APPEARANCE, &frame, fault);
	if (status)
		return status;
	switch (name->kind) {
	case NAME_APPEARANCE:
		return text_keep(&reader->theme, "", 0, fault);
	case NAME_SURFACE_DATA:
		return href ? surface_data_link(reader, href, fault) : TCS_OK;
	case NAME_MATERIAL:
	case NAME_TEXTURE:
		return surface_data_begin(
			reader, name, attributes, count, fault);
	case NAME_TARGET:
		return target_begin(reader, frame, attributes, count, fault);
	case NAME_THEME:
	case NAME_MATERIAL_VALUE:
	case NAME_TEXTURE_VALUE:
		frame->wants_text = true;
		return TCS_OK;
	default:
		status = mapping_child(reader, frame, attributes, count, fault);
		return status ? status
			      : georeference_child(reader, frame, attributes,
					count, fault);
	}
}

enum tcs_status
appearance_end(
	struct gml_reader *reader, struct frame *frame, struct tcs_fault *fault)
{
	switch (frame->name->kind) {
	case NAME_THEME:
		return gml_keep(reader, &reader->theme, fault);
	case NAME_TARGET:
		return frame->wants_text ? target_end(reader, fault) : TCS_OK;
	case NAME_MATERIAL_VALUE:
		material_value_end(reader, frame->name);
		return TCS_OK;
	case NAME_TEXTURE_VALUE:
		return texture_value_end(reader, frame->name, fault);
	case NAME_MATERIAL:
	case NAME_TEXTURE:
		return surface_data_end(reader, frame->name, fault);
	default:
		georeference_end(reader, frame);
		return mapping_end(reader, frame, fault);
	}
}

void
appearance_release(struct gml_reader *reader)
{
	array_release(&reader->theme);
	array_release(&reader->source);
	array_release(&reader->texture.uri);
	array_release(&reader->texture.mime);
	array_release(&reader->texture.type);
	array_release(&reader->texture.wrap);
	array_release(&reader->texture.border);
	keys_release(&reader->meshes);
	array_release(&reader->mesh_problems);
	palette_numbers_release(&reader->numbers);
	store_release(&reader->store);
	folder_close(&reader->folder);
}
