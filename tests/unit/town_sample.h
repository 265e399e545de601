/*
 * A small stream that uses every array and every kind of record, for the
 * tests of whatever reads or writes streams.
 */
#ifndef TESSERA_TOWN_SAMPLE_H
#define TESSERA_TOWN_SAMPLE_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "labels.h"
#include "tcs.h"

/* For a test's set-up, which cannot fail by itself. */
static inline void
sample_must(enum tcs_status status, const struct tcs_fault *fault)
{
	if (!status)
		return;
	fprintf(stderr, "set-up failed: %s\n", fault->text);
	abort();
}

#define SAMPLE_PUSH(array, ...) \
	do { \
		if (array_grow(&(array), 1)) \
			abort(); \
		memset(&(array).at[(array).count], 0, sizeof *(array).at); \
		(array).at[(array).count++] = __VA_ARGS__; \
	} while (0)

static inline tcs_text
sample_text_in(void *text, const char *string)
{
	struct tcs_fault fault;
	tcs_text out;

	sample_must(text_append_to(text, string, strlen(string), &out, &fault),
		&fault);
	return out;
}

#define SAMPLE_TEXT(record, string) sample_text_in(&(record)->text, (string))

static inline void
sample_features(struct tcs_object *o)
{
	SAMPLE_PUSH(o->features,
		(struct tcs_feature){.id = SAMPLE_TEXT(o, "b1"),
			.name = SAMPLE_TEXT(o, "Town hall \xc3\xa4"),
			.parent = TCS_NONE,
			.class = TCS_CLASS_Building});
	SAMPLE_PUSH(o->features,
		(struct tcs_feature){.id = SAMPLE_TEXT(o, "w1"),
			.parent = 0,
			.role = SAMPLE_TEXT(o, "boundedBy"),
			.class = TCS_CLASS_WallSurface});
	SAMPLE_PUSH(o->features,
		(struct tcs_feature){.id = SAMPLE_TEXT(o, "d1"),
			.type = SAMPLE_TEXT(o, "IfcDoor"),
			.parent = 1,
			.class = TCS_CLASS_Door});
}

static inline void
sample_attributes(struct tcs_object *o)
{
	SAMPLE_PUSH(o->attributes,
		(struct tcs_attribute){.number = 12.5,
			.parent = TCS_NONE,
			.name = SAMPLE_TEXT(o, "measuredHeight"),
			.value = SAMPLE_TEXT(o, "12.50"),
			.unit = SAMPLE_TEXT(o, "m"),
			.type = TCS_MEASURE});
	SAMPLE_PUSH(o->attributes,
		(struct tcs_attribute){.parent = TCS_NONE,
			.name = SAMPLE_TEXT(o, "owner"),
			.type = TCS_SET,
			.flags = TCS_ATTRIBUTE_GENERIC});
	SAMPLE_PUSH(o->attributes,
		(struct tcs_attribute){.number = NAN,
			.parent = 1,
			.name = SAMPLE_TEXT(o, "share"),
			.space = SAMPLE_TEXT(o, "uro"),
			.value = SAMPLE_TEXT(o, "half"),
			.type = TCS_DOUBLE});
	SAMPLE_PUSH(o->attributes,
		(struct tcs_attribute){.feature = 1,
			.parent = TCS_NONE,
			.name = SAMPLE_TEXT(o, "function"),
			.value = SAMPLE_TEXT(o, "1000"),
			.code_space = SAMPLE_TEXT(o, "codes.xml"),
			.type = TCS_CODE});
	SAMPLE_PUSH(o->relations,
		(struct tcs_relation){2, SAMPLE_TEXT(o, "fills"),
			SAMPLE_TEXT(o, "w1"), SAMPLE_TEXT(o, "note")});
}

static inline void
sample_polygons(struct tcs_object *o)
{
	SAMPLE_PUSH(o->geometries,
		(struct tcs_geometry){.id = SAMPLE_TEXT(o, "s1"),
			.shell_count = 1,
			.polygon_count = 2,
			.lod = 2,
			.kind = TCS_SOLID});
	SAMPLE_PUSH(o->geometries,
		(struct tcs_geometry){.role = SAMPLE_TEXT(o, "lod0Point"),
			.first_shell = 1,
			.first_polygon = 2,
			.polygon_count = 1,
			.lod = TCS_LOD_NONE,
			.kind = TCS_MULTI_POINT});
	SAMPLE_PUSH(o->shells,
		(struct tcs_shell){
			.id = SAMPLE_TEXT(o, "shell"), .polygon_count = 2});
	SAMPLE_PUSH(o->polygons,
		(struct tcs_polygon){.id = SAMPLE_TEXT(o, "p1"),
			.surface = 1,
			.vertex_count = 4,
			.ring_count = 1,
			.triangle_count = 2});
	SAMPLE_PUSH(o->polygons,
		(struct tcs_polygon){.id = SAMPLE_TEXT(o, "p2"),
			.surface = 2,
			.first_vertex = 4,
			.vertex_count = 4,
			.first_ring = 1,
			.ring_count = 1,
			.first_triangle = 2,
			.triangle_count = 2,
			.flags = TCS_POLYGON_REVERSED});
	SAMPLE_PUSH(o->polygons,
		(struct tcs_polygon){.first_vertex = 8,
			.vertex_count = 1,
			.first_ring = 2,
			.ring_count = 1,
			.first_triangle = 4});
}

static inline void
sample_vertices(struct tcs_object *o)
{
	SAMPLE_PUSH(o->rings,
		(struct tcs_ring){
			.id = SAMPLE_TEXT(o, "r1"), .vertex_count = 4});
	SAMPLE_PUSH(o->rings,
		(struct tcs_ring){.first_vertex = 4, .vertex_count = 4});
	SAMPLE_PUSH(o->rings,
		(struct tcs_ring){.first_vertex = 8, .vertex_count = 1});
	for (uint32_t i = 0; i < 8; i++)
		SAMPLE_PUSH(o->vertices,
			(struct tcs_point){
				500000.125 + (i % 4 == 1 || i % 4 == 2),
				5333770.3 + i / 4, (i % 4 >= 2) * 0.1});
	SAMPLE_PUSH(o->vertices, (struct tcs_point){-0.0, 1e-300, 1e300});
	for (uint32_t i = 0; i < 2; i++) {
		SAMPLE_PUSH(o->triangles,
			(struct tcs_triangle){{4 * i, 4 * i + 1, 4 * i + 2}});
		SAMPLE_PUSH(o->triangles,
			(struct tcs_triangle){{4 * i, 4 * i + 2, 4 * i + 3}});
	}
}

static inline void
sample_paints(struct tcs_object *o)
{
	SAMPLE_PUSH(o->paints,
		(struct tcs_paint){.polygon = 1,
			.theme = SAMPLE_TEXT(o, "summer"),
			.material = 0,
			.image = 0,
			.flags = TCS_PAINT_BACK});
	SAMPLE_PUSH(o->paints,
		(struct tcs_paint){.polygon = 0,
			.theme = SAMPLE_TEXT(o, "winter"),
			.material = 0,
			.image = TCS_NONE,
			.first_texcoord = TCS_NONE});
	for (int i = 0; i < 4; i++)
		SAMPLE_PUSH(o->texcoords,
			(struct tcs_texcoord){0.25 * i, 1 - 0.1 * i});
	SAMPLE_PUSH(o->instances,
		(struct tcs_instance){.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0,
					      1, 0, 0, 0, 0, 1},
			.anchor = {500010, 5333780, 7},
			.feature = 2,
			.id = SAMPLE_TEXT(o, "tree"),
			.lod = 3});
}

/* Two quads of a solid, a point, three features, two themes, an instance. */
static inline void
sample_object(struct tcs_object *o)
{
	object_clear(o);
	sample_features(o);
	sample_attributes(o);
	sample_polygons(o);
	sample_vertices(o);
	sample_paints(o);
}

/* A triangle in coordinates of its own. */
static inline void
sample_prototype(struct tcs_object *o)
{
	object_clear(o);
	SAMPLE_PUSH(o->features, (struct tcs_feature){.parent = TCS_NONE});
	SAMPLE_PUSH(o->geometries,
		(struct tcs_geometry){.polygon_count = 1,
			.lod = TCS_LOD_NONE,
			.kind = TCS_MULTI_SURFACE,
			.flags = TCS_GEOMETRY_SIMPLIFIED});
	SAMPLE_PUSH(o->polygons,
		(struct tcs_polygon){.vertex_count = 3, .triangle_count = 1});
	SAMPLE_PUSH(o->vertices, (struct tcs_point){0, 0, 0});
	SAMPLE_PUSH(o->vertices, (struct tcs_point){1, 0, 0});
	SAMPLE_PUSH(o->vertices, (struct tcs_point){0, 0, 1});
	SAMPLE_PUSH(o->triangles, (struct tcs_triangle){{0, 1, 2}});
}

static inline void
sample_head(struct tcs_head *head)
{
	struct tcs_fault fault;

	SAMPLE_PUSH(head->crs,
		(struct tcs_crs){.metres_per_unit = 1,
			.metres_per_unit_up = 0.3048,
			.origin = {500000, 5333000, 500},
			.lower = {500000.125, 5333770.3, 0},
			.upper = {500001.125, 5333771.3, 0.1},
			.name = SAMPLE_TEXT(head, "EPSG:25832"),
			.assumed = SAMPLE_TEXT(head, "the unit of heights"),
			.epsg = 25832,
			.epsg_up = -1,
			.kind = TCS_CRS_PROJECTED,
			.flags = TCS_CRS_NORTH_FIRST | TCS_HAS_ORIGIN});
	SAMPLE_PUSH(head->sources,
		(struct tcs_source){SAMPLE_TEXT(head, "CityGML 2.0"),
			SAMPLE_TEXT(head, "town.gml")});
	sample_must(
		head_sign(head, "sample", "1.0", "--quick", &fault), &fault);
	sample_must(head_sign(head, "other", "1.0", "", &fault), &fault);
}

static inline void
sample_palette(struct tcs_palette *palette)
{
	palette_clear(palette);
	SAMPLE_PUSH(palette->images,
		(struct tcs_image){.border = {0.1f, 0, 1, 1},
			.id = SAMPLE_TEXT(palette, "brick"),
			.uri = SAMPLE_TEXT(palette, "brick.png"),
			.mime = SAMPLE_TEXT(palette, "image/png"),
			.type = SAMPLE_TEXT(palette, "typical"),
			.wrap = TCS_WRAP_REPEAT,
			.byte_count = 5});
	SAMPLE_PUSH(palette->images,
		(struct tcs_image){.uri = SAMPLE_TEXT(palette, "far.jpg"),
			.first_byte = 5});
	SAMPLE_PUSH(palette->materials,
		(struct tcs_material){.diffuse = {0.7f, 0.1f, 0},
			.ambient = 0.2f,
			.shininess = 0.3f,
			.transparency = 0.25f,
			.id = SAMPLE_TEXT(palette, "red"),
			.smooth = 1});
	for (unsigned char i = 0; i < 5; i++)
		SAMPLE_PUSH(palette->bytes, (unsigned char)(i * 60));
}

/* Head, palette, prototype, two objects, a record of an unknown type, end. */
static inline void
sample_stream(FILE *file, int level)
{
	struct tcs_writer writer;
	struct tcs_record record = {0};
	struct tcs_head head = {0};
	struct tcs_palette palette = {0};
	struct tcs_object object = {0};
	struct tcs_fault fault;

	writer_init(&writer, file, level);
	sample_head(&head);
	sample_must(head_encode(&head, &record, &fault), &fault);
	sample_must(writer_put(&writer, &record, &fault), &fault);
	sample_palette(&palette);
	sample_must(palette_encode(&palette, &record, &fault), &fault);
	sample_must(writer_put(&writer, &record, &fault), &fault);
	sample_prototype(&object);
	sample_must(
		object_encode(&object, TCS_PROTOTYPE, &record, &fault), &fault);
	sample_must(writer_put(&writer, &record, &fault), &fault);
	sample_object(&object);
	sample_must(
		object_encode(&object, TCS_OBJECT, &record, &fault), &fault);
	sample_must(writer_put(&writer, &record, &fault), &fault);
	sample_must(writer_put(&writer, &record, &fault), &fault);
	record.type = TCS_TAG('N', 'E', 'W', '!');
	record.bytes.count = 0;
	for (unsigned char i = 0; i < 16; i++)
		SAMPLE_PUSH(record.bytes, (unsigned char)(i * 16));
	sample_must(writer_put(&writer, &record, &fault), &fault);
	sample_must(writer_end(&writer, &fault), &fault);
	writer_release(&writer);
	record_release(&record);
	head_release(&head);
	palette_release(&palette);
	object_release(&object);
}

#endif
