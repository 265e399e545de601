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
write_targets(struct composer *composer, const struct painting *painting)
{
	uint32_t polygon = paint_polygon(
		composer, &composer->object.paints.at[painting->index]);
	const struct piece *piece = &composer->pieces.at[polygon];

	if (painting->surface != TCS_NONE) {
		write_target(
			composer, composer->surfaces.at[painting->surface].id);
		return;
	}
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
		write_targets(composer, &from[i]);
	markup_end(markup, "app", "X3DMaterial");
}

/*
 * What a texture is wrapped on: a polygon with its rings, a face joined from
 * triangles, or as many triangles of a triangulated surface.
 */
struct wrapped {
	const struct painting *from;
	size_t count; /* 1 but for a triangulated surface */
	const struct face *face; /* NULL: not joined */
	const char *id;
};

/* A ring of it; each by ring_first and ring_next. */
struct wrapped_ring {
	size_t painting;
	uint32_t number; /* among those of the painting */
};

static const struct tcs_paint *
ring_paint(const struct composer *composer, const struct wrapped *wrapped,
	const struct wrapped_ring *ring)
{
	return &composer->object.paints.at[wrapped->from[ring->painting].index];
}

static uint32_t
ring_count(const struct composer *composer, const struct wrapped *wrapped,
	const struct wrapped_ring *ring)
{
	uint32_t polygon = ring_paint(composer, wrapped, ring)->polygon;

	if (wrapped->face)
		return wrapped->face->ring_count;
	return pieces_is_patch(composer, polygon)
		? pieces_patch_count(composer, polygon)
		: composer->object.polygons.at[polygon].ring_count;
}

static bool
ring_next(const struct composer *composer, const struct wrapped *wrapped,
	struct wrapped_ring *ring)
{
	ring->number++;
	while (ring->painting < wrapped->count &&
		ring->number >= ring_count(composer, wrapped, ring))
		*ring = (struct wrapped_ring){ring->painting + 1, 0};
	return ring->painting < wrapped->count;
}

static const char *
ring_id(const struct composer *composer, const struct wrapped *wrapped,
	const struct wrapped_ring *ring)
{
	uint32_t polygon =
		paint_polygon(composer, ring_paint(composer, wrapped, ring));
	uint32_t first = composer->pieces.at[polygon].first_ring_id;

	if (wrapped->face)
		first += wrapped->face->rings_before;
	return composer->ring_ids.at[first + ring->number];
}

static void
write_coordinate(struct composer *composer, struct tcs_texcoord at)
{
	markup_number(&composer->out->markup, at.s);
	markup_number(&composer->out->markup, at.t);
}

/* Of the polygon's own vertex. */
static struct tcs_texcoord
texcoord_of(const struct composer *composer, const struct tcs_paint *paint,
	uint32_t vertex)
{
	const struct tcs_polygon *polygon =
		&composer->object.polygons.at[paint->polygon];

	return composer->object.texcoords
		.at[paint->first_texcoord + vertex - polygon->first_vertex];
}

static void
write_coordinates(struct composer *composer, const struct tcs_paint *paint,
	const struct tcs_ring *ring)
{
	for (uint32_t i = 0; i <= ring->vertex_count; i++)
		write_coordinate(composer,
			texcoord_of(composer, paint,
				ring->first_vertex + i % ring->vertex_count));
}

static void
write_patch_coordinates(
	struct composer *composer, const struct tcs_paint *paint, uint32_t n)
{
	const struct tcs_polygon *polygon =
		&composer->object.polygons.at[paint->polygon];
	const uint32_t *corner =
		composer->object.triangles.at[polygon->first_triangle + n]
			.corner;

	for (unsigned i = 0; i < 4; i++)
		write_coordinate(
			composer, texcoord_of(composer, paint, corner[i % 3]));
}

static void
write_merged_coordinates(struct composer *composer,
	const struct tcs_paint *paint, const struct coplanar_ring *ring)
{
	const uint32_t *corners = composer->merged.corners.at + ring->first;

	for (uint32_t i = 0; i <= ring->count; i++)
		write_coordinate(composer,
			merged_texcoord(
				composer, paint, corners[i % ring->count]));
}

static void
write_ring_coordinates(struct composer *composer, const struct wrapped *wrapped,
	const struct wrapped_ring *ring)
{
	const struct tcs_object *object = &composer->object;
	const struct tcs_paint *paint = ring_paint(composer, wrapped, ring);
	uint32_t polygon = paint->polygon;

	markup_begin_text(&composer->out->markup);
	if (wrapped->face)
		write_merged_coordinates(composer, paint,
			&composer->merged.rings
				 .at[wrapped->face->first_ring + ring->number]);
	else if (pieces_is_patch(composer, polygon) &&
		!pieces_is_triangle(composer, polygon))
		write_patch_coordinates(composer, paint, ring->number);
	else
		write_coordinates(composer, paint,
			&object->rings
				 .at[object->polygons.at[polygon].first_ring +
					 ring->number]);
}

static bool
ring_first(const struct composer *composer, const struct wrapped *wrapped,
	struct wrapped_ring *ring)
{
	*ring = (struct wrapped_ring){0, UINT32_MAX};
	return ring_next(composer, wrapped, ring);
}

/* In 1.0 and 2.0 the ring is an attribute; in 3.0 rings follow, in order. */
static void
write_coordinate_list(struct composer *composer, const struct wrapped *wrapped)
{
	struct markup *markup = &composer->out->markup;
	bool is_3 = compose_is_3(composer), more;
	struct wrapped_ring ring;

	markup_start(markup, "app", "TexCoordList");
	for (more = ring_first(composer, wrapped, &ring); more;
		more = ring_next(composer, wrapped, &ring)) {
		markup_start(markup, "app", "textureCoordinates");
		if (!is_3)
			markup_link(markup, "ring",
				ring_id(composer, wrapped, &ring));
		write_ring_coordinates(composer, wrapped, &ring);
		markup_end(markup, "app", "textureCoordinates");
	}
	for (more = is_3 && ring_first(composer, wrapped, &ring); more;
		more = ring_next(composer, wrapped, &ring)) {
		markup_start(markup, "app", "ring");
		markup_text(markup, "#");
		markup_text(markup, ring_id(composer, wrapped, &ring));
		markup_end(markup, "app", "ring");
	}
	markup_end(markup, "app", "TexCoordList");
}

static void
write_wrapped(struct composer *composer, const struct wrapped *wrapped)
{
	struct markup *markup = &composer->out->markup;
	struct wrapped_ring ring;

	if (!ring_first(composer, wrapped, &ring))
		return;
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

/* The paintings from the first that are on the same surface. */
static size_t
surface_run(const struct painting *from, size_t count)
{
	size_t run = 1;

	while (from->surface != TCS_NONE && run < count &&
		from[run].surface == from->surface)
		run++;
	return run;
}

static void
write_texture_targets(
	struct composer *composer, const struct painting *from, size_t count)
{
	const struct tcs_paint *paint =
		&composer->object.paints.at[from->index];
	uint32_t target = paint_polygon(composer, paint);
	const struct piece *piece = &composer->pieces.at[target];
	struct wrapped wrapped = {
		.from = from, .count = count, .id = piece->id};

	if (from->surface != TCS_NONE)
		wrapped.id = composer->surfaces.at[from->surface].id;
	if (!wrapped.id || piece->first_ring_id == TCS_NONE)
		return;
	if (from->surface != TCS_NONE ||
		composer->object.polygons.at[paint->polygon].ring_count) {
		write_wrapped(composer, &wrapped);
		return;
	}
	for (uint32_t i = 0; i < piece->face_count; i++) {
		wrapped.face = &composer->faces.at[piece->first_face + i];
		wrapped.id = face_id(composer, piece, i);
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
	if (image.is.byte_count && !composer->plan->writes_images)
		compose_lose(composer, "image",
			"its bytes are in the stream: only its name is written",
			image.uri);
	if (image.is.wrap <= TCS_WRAP_BORDER)
		markup_leaf(markup, "app", "wrapMode", wraps[image.is.wrap]);
	if (has_border(&image.is))
		write_floats(composer, "borderColor", image.is.border, 4);
	for (size_t i = 0, run; i < count; i += run) {
		run = surface_run(&from[i], count - i);
		write_texture_targets(composer, &from[i], run);
	}
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

/* The property of an object that an appearance is local to, or of the model. */
static void
appearance_property(
	const struct composer *composer, const char **module, const char **name)
{
	*module = compose_is_3(composer) ? "core" : "app";
	*name = composer->is_prototype ? "appearanceMember" : "appearance";
}

/* The paintings of one theme. */
static void
write_theme(
	struct composer *composer, const struct painting *from, size_t count)
{
	const char *property =
		compose_is_3(composer) ? "surfaceData" : "surfaceDataMember";
	const char *around, *name;
	struct markup *markup = &composer->out->markup;
	tcs_text theme = composer->object.paints.at[from->index].theme;
	size_t run;

	appearance_property(composer, &around, &name);
	markup_start(markup, around, name);
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
	markup_end(markup, around, name);
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

void
prototype_appearances_write(struct composer *composer)
{
	struct composed *out = composer->out;
	struct markup shape = out->markup;

	out->markup = out->appearance;
	appearances_write(composer);
	out->appearance = out->markup;
	out->markup = shape;
}
