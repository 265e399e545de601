/*
 * Appearance: what the paints of an object say, as materials and textures of
 * its themes, local to its first feature.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "citygml_polygons.h"

/* In the order of enum tcs_wrap. */
static const char *const wraps[] = {
	"none", "wrap", "mirror", "clamp", "border"};

/* ---- which paints, in which order ----------------------------------------------- */

/* The polygon that stands in the text for a painted one; TCS_NONE for none. */
static uint32_t
painted(const struct composer *composer, const struct tcs_paint *paint)
{
	const struct piece *piece = &composer->pieces.at[paint->polygon];

	if (piece->first != TCS_NONE)
		return piece->first;
	return piece->home == TCS_NONE && !piece->foreign ? TCS_NONE
							  : paint->polygon;
}

/* One painting; they are written in this order. */
struct paint_key {
	uint32_t of[5]; /* theme, image, material, flags, paint */
};

static int
compare_keys(const void *left, const void *right)
{
	const uint32_t *a = ((const struct paint_key *)left)->of;
	const uint32_t *b = ((const struct paint_key *)right)->of;

	for (size_t i = 0; i < 5; i++)
		if (a[i] != b[i])
			return a[i] < b[i] ? -1 : 1;
	return 0;
}

static void
add_keys(struct composer *composer, struct paint_key *keys, size_t *count)
{
	const struct tcs_object *object = &composer->object;

	for (uint32_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];
		uint32_t polygon = painted(composer, paint);
		struct paint_key key = {
			{paint->theme, TCS_NONE, TCS_NONE, paint->flags, i}};

		if (polygon == TCS_NONE || pieces_is_patch(composer, polygon)) {
			compose_lose(composer, "paint",
				polygon == TCS_NONE
					? "its polygon is not written"
					: "triangles of a triangulated surface "
					  "have no ids",
				composer->nodes.count ? composer->nodes.at[0].id
						      : NULL);
			continue;
		}
		composer->pieces.at[polygon].is_target = true;
		if (paint->image != TCS_NONE) {
			composer->pieces.at[polygon].rings_need_ids = true;
			key.of[1] = paint->image;
			keys[(*count)++] = key;
		}
		if (paint->material == TCS_NONE)
			continue;
		key.of[1] = TCS_NONE;
		key.of[2] = paint->material;
		keys[(*count)++] = key;
	}
}

enum tcs_status
paints_prepare(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	uint16_t property = schema_find_content(
		composer->nodes.at[0].class, CONTENT_APPEARANCE);
	struct paint_key *keys;
	size_t count = 0;

	array_clear(&composer->paints);
	if (!object->paints.count || property == SCHEMA_NONE)
		return TCS_OK;
	keys = arena_get(
		&composer->arena, object->paints.count * 2 * sizeof *keys);
	if (!keys || array_grow(&composer->paints, object->paints.count * 2))
		return fault_memory(fault);
	add_keys(composer, keys, &count);
	if (!count)
		return TCS_OK;
	qsort(keys, count, sizeof *keys, compare_keys);
	for (size_t i = 0; i < count; i++)
		composer->paints.at[composer->paints.count++] =
			(struct painting){.index = keys[i].of[4],
				.textured = keys[i].of[1] != TCS_NONE};
	return item_add(composer, 0, property, ITEM_APPEARANCE, 0, fault);
}

/* ---- writing -------------------------------------------------------------------- */

/* The shortest decimal that is the same float. */
static void
print_float(char out[32], float value)
{
	int digits = 6;

	do
		snprintf(out, 32, "%.*g", digits, (double)value);
	while (strtof(out, NULL) != value && ++digits <= 9);
}

static void
write_floats(struct composer *composer, const char *name, const float *values,
	unsigned count)
{
	char text[160] = "";

	for (unsigned i = 0; i < count; i++) {
		char number[32];

		print_float(number, values[i]);
		if (i)
			strcat(text, " ");
		strcat(text, number);
	}
	markup_leaf(&composer->out->markup, "app", name, text);
}

static void
start_feature(struct composer *composer, const char *name, const char *id)
{
	markup_start(&composer->out->markup, "app", name);
	if (*id || compose_is_3(composer))
		markup_attribute(&composer->out->markup, "gml:id",
			compose_id(composer, id));
}

static const char *
face_id(const struct composer *composer, const struct piece *piece,
	uint32_t face)
{
	return face ? composer->faces.at[piece->first_face + face].id
		    : piece->id;
}

static void
write_target(struct composer *composer, const char *id)
{
	struct markup *markup = &composer->out->markup;

	markup_start(markup, "app", "target");
	markup_text(markup, "#");
	markup_text(markup, id);
	markup_end(markup, "app", "target");
}

static void
write_targets(struct composer *composer, const struct tcs_paint *paint)
{
	uint32_t polygon = painted(composer, paint);
	const struct piece *piece = &composer->pieces.at[polygon];

	for (uint32_t i = 0; i < shape_face_count(composer, polygon); i++)
		if (piece->id)
			write_target(composer, face_id(composer, piece, i));
}

static void
write_material(
	struct composer *composer, const struct painting *from, size_t count)
{
	const struct tcs_paint *paints = composer->object.paints.at;
	const struct tcs_paint *paint = &paints[from->index];
	struct gml_material found = gml_material_at(composer, paint->material);
	struct tcs_material material = found.is;
	struct markup *markup = &composer->out->markup;

	start_feature(composer, "X3DMaterial", found.id);
	if (paint->flags & TCS_PAINT_BACK)
		markup_leaf(markup, "app", "isFront", "false");
	write_floats(composer, "ambientIntensity", &material.ambient, 1);
	write_floats(composer, "diffuseColor", material.diffuse, 3);
	write_floats(composer, "emissiveColor", material.emissive, 3);
	write_floats(composer, "specularColor", material.specular, 3);
	write_floats(composer, "shininess", &material.shininess, 1);
	write_floats(composer, "transparency", &material.transparency, 1);
	markup_leaf(
		markup, "app", "isSmooth", material.smooth ? "true" : "false");
	for (size_t i = 0; i < count; i++)
		write_targets(composer, &paints[from[i].index]);
	markup_end(markup, "app", "X3DMaterial");
}

/* A face that a texture is wrapped on: a polygon with its rings, or one
 * joined from triangles. */
struct wrapped {
	const struct tcs_paint *paint;
	const struct face *face; /* NULL: the polygon itself */
	const char *id;
	const char *const *ring_ids;
	uint32_t ring_count;
};

static void
write_coordinates(struct composer *composer, const struct tcs_paint *paint,
	const struct tcs_ring *ring)
{
	const struct tcs_polygon *polygon =
		&composer->object.polygons.at[paint->polygon];
	const struct tcs_texcoord *at =
		&composer->object.texcoords.at[paint->first_texcoord +
			ring->first_vertex - polygon->first_vertex];
	struct markup *markup = &composer->out->markup;

	for (uint32_t i = 0; i <= ring->vertex_count; i++) {
		markup_number(markup, at[i % ring->vertex_count].s);
		markup_number(markup, at[i % ring->vertex_count].t);
	}
}

static void
write_merged_coordinates(struct composer *composer,
	const struct tcs_paint *paint, const struct coplanar_ring *ring)
{
	const uint32_t *corners = composer->merged.corners.at + ring->first;

	for (uint32_t i = 0; i <= ring->count; i++) {
		struct tcs_texcoord at = merged_texcoord(
			composer, paint, corners[i % ring->count]);

		markup_number(&composer->out->markup, at.s);
		markup_number(&composer->out->markup, at.t);
	}
}

static void
write_ring_coordinates(
	struct composer *composer, const struct wrapped *wrapped, uint32_t ring)
{
	const struct tcs_object *object = &composer->object;
	const struct tcs_paint *paint = wrapped->paint;

	markup_begin_text(&composer->out->markup);
	if (wrapped->face)
		write_merged_coordinates(composer, paint,
			&composer->merged.rings
				 .at[wrapped->face->first_ring + ring]);
	else
		write_coordinates(composer, paint,
			&object->rings.at[object->polygons.at[paint->polygon]
						  .first_ring +
				ring]);
}

/* In 1.0 and 2.0 the ring is an attribute; in 3.0 rings follow, in order. */
static void
write_coordinate_list(struct composer *composer, const struct wrapped *wrapped)
{
	struct markup *markup = &composer->out->markup;
	bool is_3 = compose_is_3(composer);

	markup_start(markup, "app", "TexCoordList");
	for (uint32_t i = 0; i < wrapped->ring_count; i++) {
		markup_start(markup, "app", "textureCoordinates");
		if (!is_3)
			markup_link(markup, "ring", wrapped->ring_ids[i]);
		write_ring_coordinates(composer, wrapped, i);
		markup_end(markup, "app", "textureCoordinates");
	}
	for (uint32_t i = 0; is_3 && i < wrapped->ring_count; i++) {
		markup_start(markup, "app", "ring");
		markup_text(markup, "#");
		markup_text(markup, wrapped->ring_ids[i]);
		markup_end(markup, "app", "ring");
	}
	markup_end(markup, "app", "TexCoordList");
}

static void
write_wrapped(struct composer *composer, const struct wrapped *wrapped)
{
	struct markup *markup = &composer->out->markup;

	if (!compose_is_3(composer)) {
		markup_start(markup, "app", "target");
		markup_link(markup, "uri", wrapped->id);
		write_coordinate_list(composer, wrapped);
		markup_end(markup, "app", "target");
		return;
	}
	markup_start(markup, "app", "textureParameterization");
	start_feature(composer, "TextureAssociation", "");
	write_target(composer, wrapped->id);
	markup_start(markup, "app", "textureParameterization");
	write_coordinate_list(composer, wrapped);
	markup_end(markup, "app", "textureParameterization");
	markup_end(markup, "app", "TextureAssociation");
	markup_end(markup, "app", "textureParameterization");
}

static void
write_texture_targets(struct composer *composer, const struct tcs_paint *paint)
{
	const struct tcs_polygon *polygon =
		&composer->object.polygons.at[paint->polygon];
	uint32_t target = painted(composer, paint);
	const struct piece *piece = &composer->pieces.at[target];
	struct wrapped wrapped = {.paint = paint,
		.id = piece->id,
		.ring_count = polygon->ring_count};

	if (!piece->id || piece->first_ring_id == TCS_NONE)
		return;
	wrapped.ring_ids = composer->ring_ids.at + piece->first_ring_id;
	if (polygon->ring_count) {
		write_wrapped(composer, &wrapped);
		return;
	}
	for (uint32_t i = 0; i < piece->face_count; i++) {
		wrapped.face = &composer->faces.at[piece->first_face + i];
		wrapped.id = face_id(composer, piece, i);
		wrapped.ring_ids = composer->ring_ids.at +
			piece->first_ring_id + wrapped.face->rings_before;
		wrapped.ring_count = wrapped.face->ring_count;
		write_wrapped(composer, &wrapped);
	}
}

static bool
is_texture_type(const char *type)
{
	return !strcmp(type, "specific") || !strcmp(type, "typical") ||
		!strcmp(type, "unknown");
}

static bool
has_border(const struct tcs_image *image)
{
	return image->border[0] != 0 || image->border[1] != 0 ||
		image->border[2] != 0 || image->border[3] != 0;
}

static void
write_texture(
	struct composer *composer, const struct painting *from, size_t count)
{
	const struct tcs_paint *paints = composer->object.paints.at;
	const struct tcs_paint *paint = &paints[from->index];
	struct gml_image image = gml_image_at(composer, paint->image);
	struct markup *markup = &composer->out->markup;

	start_feature(composer, "ParameterizedTexture", image.id);
	if (paint->flags & TCS_PAINT_BACK)
		markup_leaf(markup, "app", "isFront", "false");
	markup_leaf(markup, "app", "imageURI", image.uri);
	if (*image.mime)
		markup_leaf(markup, "app", "mimeType", image.mime);
	if (is_texture_type(image.type))
		markup_leaf(markup, "app", "textureType", image.type);
	else if (*image.type)
		compose_lose(composer, "type of a texture",
			"CityGML knows specific, typical and unknown",
			image.type);
	if (image.is.byte_count)
		compose_lose(composer, "image",
			"its bytes are in the stream: only its name is written",
			image.uri);
	if (image.is.wrap <= TCS_WRAP_BORDER)
		markup_leaf(markup, "app", "wrapMode", wraps[image.is.wrap]);
	if (has_border(&image.is))
		write_floats(composer, "borderColor", image.is.border, 4);
	for (size_t i = 0; i < count; i++)
		write_texture_targets(composer, &paints[from[i].index]);
	markup_end(markup, "app", "ParameterizedTexture");
}

/* Whether two paintings share a material or a texture of a theme. */
static bool
goes_with(const struct composer *composer, const struct painting *a,
	const struct painting *b)
{
	const struct tcs_paint *p = &composer->object.paints.at[a->index];
	const struct tcs_paint *q = &composer->object.paints.at[b->index];

	return p->theme == q->theme && a->textured == b->textured &&
		p->flags == q->flags &&
		(a->textured ? p->image == q->image
			     : p->material == q->material);
}

/* The paintings of one theme. */
static void
write_theme(
	struct composer *composer, const struct painting *from, size_t count)
{
	const char *property =
		compose_is_3(composer) ? "surfaceData" : "surfaceDataMember";
	const char *around = compose_is_3(composer) ? "core" : "app";
	struct markup *markup = &composer->out->markup;
	tcs_text theme = composer->object.paints.at[from->index].theme;
	size_t run;

	markup_start(markup, around, "appearance");
	start_feature(composer, "Appearance", "");
	if (theme)
		markup_leaf(
			markup, "app", "theme", compose_text(composer, theme));
	for (size_t i = 0; i < count; i += run) {
		run = 1;
		while (i + run < count &&
			goes_with(composer, &from[i], &from[i + run]))
			run++;
		markup_start(markup, "app", property);
		if (from[i].textured)
			write_texture(composer, &from[i], run);
		else
			write_material(composer, &from[i], run);
		markup_end(markup, "app", property);
	}
	markup_end(markup, "app", "Appearance");
	markup_end(markup, around, "appearance");
}

void
appearances_write(struct composer *composer)
{
	const struct painting *all = composer->paints.at;
	const struct tcs_paint *paints = composer->object.paints.at;
	size_t count = composer->paints.count, run;

	for (size_t i = 0; i < count; i += run) {
		run = 1;
		while (i + run < count &&
			paints[all[i].index].theme ==
				paints[all[i + run].index].theme)
			run++;
		write_theme(composer, &all[i], run);
	}
}
