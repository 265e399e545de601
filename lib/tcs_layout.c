#include "tcs_layout.h"

#include <string.h>

#if !defined(__BYTE_ORDER__) || __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "a component stream is read in place: little-endian hosts only"
#endif

/* The structs are the bytes: no size may change, no padding appear. */
_Static_assert(sizeof(struct tcs_feature) == 24, "feature");
_Static_assert(sizeof(struct tcs_attribute) == 40, "attribute");
_Static_assert(sizeof(struct tcs_relation) == 16, "relation");
_Static_assert(sizeof(struct tcs_geometry) == 32, "geometry");
_Static_assert(sizeof(struct tcs_shell) == 20, "shell");
_Static_assert(sizeof(struct tcs_polygon) == 36, "polygon");
_Static_assert(sizeof(struct tcs_ring) == 12, "ring");
_Static_assert(sizeof(struct tcs_point) == 24, "point");
_Static_assert(sizeof(struct tcs_triangle) == 12, "triangle");
_Static_assert(sizeof(struct tcs_paint) == 24, "paint");
_Static_assert(sizeof(struct tcs_texcoord) == 16, "texcoord");
_Static_assert(sizeof(struct tcs_instance) == 168, "instance");
_Static_assert(sizeof(struct tcs_crs) == 112, "crs");
_Static_assert(sizeof(struct tcs_source) == 8, "source");
_Static_assert(sizeof(struct tcs_model) == 12, "model");
_Static_assert(sizeof(struct tcs_stage) == 12, "stage");
_Static_assert(sizeof(struct tcs_image) == 56, "image");
_Static_assert(sizeof(struct tcs_material) == 56, "material");
_Static_assert(sizeof(struct tcs_tally) == 64, "tally");

/* A column whose elements hold no text. */
#define PLAIN(a, b, c, d, kind, member, type) \
	{ \
		.tag = TCS_TAG(a, b, c, d), .size = sizeof(type), \
		.array = offsetof(struct kind, member), \
	}

#define AT(type, member) offsetof(struct type, member)

static const struct tcs_column object_columns[] = {
	{TCS_TAG('F', 'E', 'A', 'T'), sizeof(struct tcs_feature),
		AT(tcs_object, features), 4,
		{AT(tcs_feature, id), AT(tcs_feature, name),
			AT(tcs_feature, type), AT(tcs_feature, role)}},
	{TCS_TAG('A', 'T', 'T', 'R'), sizeof(struct tcs_attribute),
		AT(tcs_object, attributes), 5,
		{AT(tcs_attribute, name), AT(tcs_attribute, space),
			AT(tcs_attribute, value), AT(tcs_attribute, unit),
			AT(tcs_attribute, code_space)}},
	{TCS_TAG('R', 'E', 'L', 'A'), sizeof(struct tcs_relation),
		AT(tcs_object, relations), 3,
		{AT(tcs_relation, role), AT(tcs_relation, target),
			AT(tcs_relation, note)}},
	{TCS_TAG('G', 'E', 'O', 'M'), sizeof(struct tcs_geometry),
		AT(tcs_object, geometries), 2,
		{AT(tcs_geometry, id), AT(tcs_geometry, role)}},
	{TCS_TAG('S', 'H', 'E', 'L'), sizeof(struct tcs_shell),
		AT(tcs_object, shells), 1, {AT(tcs_shell, id)}},
	{TCS_TAG('P', 'O', 'L', 'Y'), sizeof(struct tcs_polygon),
		AT(tcs_object, polygons), 1, {AT(tcs_polygon, id)}},
	{TCS_TAG('R', 'I', 'N', 'G'), sizeof(struct tcs_ring),
		AT(tcs_object, rings), 1, {AT(tcs_ring, id)}},
	PLAIN('V', 'E', 'R', 'T', tcs_object, vertices, struct tcs_point),
	PLAIN('T', 'R', 'I', 'A', tcs_object, triangles, struct tcs_triangle),
	{TCS_PAINT_TAG, sizeof(struct tcs_paint), AT(tcs_object, paints), 1,
		{AT(tcs_paint, theme)}},
	PLAIN('T', 'E', 'X', 'C', tcs_object, texcoords, struct tcs_texcoord),
	{TCS_TAG('I', 'N', 'S', 'T'), sizeof(struct tcs_instance),
		AT(tcs_object, instances), 1, {AT(tcs_instance, id)}},
	PLAIN('T', 'E', 'X', 'T', tcs_object, text, char),
};

static const struct tcs_column head_columns[] = {
	{TCS_TAG('C', 'R', 'S', ' '), sizeof(struct tcs_crs), AT(tcs_head, crs),
		2, {AT(tcs_crs, name), AT(tcs_crs, assumed)}},
	{TCS_TAG('S', 'O', 'U', 'R'), sizeof(struct tcs_source),
		AT(tcs_head, sources), 2,
		{AT(tcs_source, format), AT(tcs_source, name)}},
	{TCS_TAG('M', 'O', 'D', 'L'), sizeof(struct tcs_model),
		AT(tcs_head, models), 3,
		{AT(tcs_model, id), AT(tcs_model, name),
			AT(tcs_model, description)}},
	{TCS_TAG('S', 'T', 'A', 'G'), sizeof(struct tcs_stage),
		AT(tcs_head, stages), 3,
		{AT(tcs_stage, program), AT(tcs_stage, version),
			AT(tcs_stage, arguments)}},
	PLAIN('T', 'E', 'X', 'T', tcs_head, text, char),
};

static const struct tcs_column palette_columns[] = {
	{TCS_TAG('I', 'M', 'A', 'G'), sizeof(struct tcs_image),
		AT(tcs_palette, images), 4,
		{AT(tcs_image, id), AT(tcs_image, uri), AT(tcs_image, mime),
			AT(tcs_image, type)}},
	{TCS_TAG('M', 'A', 'T', 'L'), sizeof(struct tcs_material),
		AT(tcs_palette, materials), 1, {AT(tcs_material, id)}},
	PLAIN('B', 'Y', 'T', 'E', tcs_palette, bytes, unsigned char),
	PLAIN('T', 'E', 'X', 'T', tcs_palette, text, char),
};

static const struct tcs_column end_columns[] = {
	PLAIN('T', 'A', 'L', 'Y', tcs_end, tallies, struct tcs_tally),
};

#define LAYOUT(name) \
	const struct tcs_layout layout_##name = { \
		name##_columns, \
		sizeof name##_columns / sizeof *name##_columns, \
		#name, \
	}

LAYOUT(object);
LAYOUT(head);
LAYOUT(palette);
LAYOUT(end);

struct tcs_array
layout_array(const struct tcs_column *column, const void *kind)
{
	struct tcs_array view;

	memcpy(&view, (const char *)kind + column->array, sizeof view);
	return view;
}

const struct tcs_column *
layout_column(const struct tcs_layout *layout, uint32_t tag)
{
	for (size_t i = 0; i < layout->count; i++)
		if (layout->columns[i].tag == tag)
			return &layout->columns[i];
	return NULL;
}

tcs_text
layout_text(const void *element, size_t at)
{
	tcs_text text;

	memcpy(&text, (const char *)element + at, sizeof text);
	return text;
}
