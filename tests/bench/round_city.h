/*
 * A city of round houses for benches: each is a solid of `corners` walls, a
 * roof and a ground, every one a surface with an id, and carries a few
 * attributes: 4 · corners - 4 triangles.
 */
#ifndef TESSERA_ROUND_CITY_H
#define TESSERA_ROUND_CITY_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "labels.h"
#include "tcs.h"

static inline void
city_must(enum tcs_status status, const struct tcs_fault *fault)
{
	if (!status)
		return;
	fprintf(stderr, "set-up failed: %s\n", fault->text);
	exit(1);
}

#define CITY_PUSH(array, ...) \
	do { \
		if (array_grow(&(array), 1)) \
			abort(); \
		(array).at[(array).count++] = __VA_ARGS__; \
	} while (0)

static inline tcs_text
city_text(struct tcs_object *o, const char *kind, unsigned house, unsigned n)
{
	struct tcs_fault fault;
	char text[64];
	tcs_text out;
	int length = snprintf(
		text, sizeof text, "UUID_%s_%07u_%03u", kind, house, n);

	city_must(text_append(o, text, (size_t)length, &out, &fault), &fault);
	return out;
}

static inline void
city_feature(struct tcs_object *o, unsigned house, uint16_t class)
{
	unsigned n = (unsigned)o->features.count;

	CITY_PUSH(o->features,
		(struct tcs_feature){
			.id = city_text(o, label_of(class)->name, house, n),
			.parent = n ? 0 : TCS_NONE,
			.class = class});
}

static inline void
city_attribute(
	struct tcs_object *o, const char *name, double number, uint16_t type)
{
	struct tcs_fault fault;
	struct tcs_attribute made = {
		.parent = TCS_NONE, .type = type, .number = number};
	char text[32];
	int length = snprintf(text, sizeof text, "%.2f", number);

	city_must(
		text_append(o, name, strlen(name), &made.name, &fault), &fault);
	city_must(text_append(o, text, (size_t)length, &made.value, &fault),
		&fault);
	CITY_PUSH(o->attributes, made);
}

/* A fan over the `count` vertices that were just appended. */
static inline void
city_polygon(
	struct tcs_object *o, unsigned house, uint32_t surface, uint32_t count)
{
	uint32_t first = (uint32_t)o->vertices.count - count;
	struct tcs_polygon made = {
		.id = city_text(o, "poly", house, (unsigned)o->polygons.count),
		.surface = surface,
		.first_vertex = first,
		.vertex_count = count,
		.first_ring = (uint32_t)o->rings.count,
		.ring_count = 1,
		.first_triangle = (uint32_t)o->triangles.count,
		.triangle_count = count - 2,
	};

	CITY_PUSH(o->rings, (struct tcs_ring){0, first, count});
	for (uint32_t i = 1; i + 1 < count; i++)
		CITY_PUSH(o->triangles,
			(struct tcs_triangle){
				{first, first + i, first + i + 1}});
	CITY_PUSH(o->polygons, made);
}

static inline struct tcs_point
city_corner(unsigned house, unsigned corners, unsigned i, double z)
{
	double angle = 6.283185307179586 * i / corners;

	return (struct tcs_point){
		500000 + 20.0 * (house % 400) + 7 * cos(angle),
		5300000 + 20.0 * (house / 400) + 7 * sin(angle), z};
}

static inline void
city_house(struct tcs_object *o, unsigned house, unsigned corners)
{
	double top = 6 + house % 17;

	object_clear(o);
	CITY_PUSH(o->text, '\0');
	city_feature(o, house, TCS_CLASS_Building);
	city_attribute(o, "measuredHeight", top, TCS_MEASURE);
	city_attribute(o, "storeysAboveGround", (int)(top / 3), TCS_INTEGER);
	city_attribute(o, "function", 1000 + house % 7, TCS_CODE);
	for (unsigned i = 0; i < corners; i++) {
		unsigned next = (i + 1) % corners;

		city_feature(o, house, TCS_CLASS_WallSurface);
		CITY_PUSH(o->vertices, city_corner(house, corners, i, 0));
		CITY_PUSH(o->vertices, city_corner(house, corners, next, 0));
		CITY_PUSH(o->vertices, city_corner(house, corners, next, top));
		CITY_PUSH(o->vertices, city_corner(house, corners, i, top));
		city_polygon(o, house, i + 1, 4);
	}
	city_feature(o, house, TCS_CLASS_RoofSurface);
	for (unsigned i = 0; i < corners; i++)
		CITY_PUSH(o->vertices, city_corner(house, corners, i, top));
	city_polygon(o, house, corners + 1, corners);
	city_feature(o, house, TCS_CLASS_GroundSurface);
	for (unsigned i = corners; i-- > 0;)
		CITY_PUSH(o->vertices, city_corner(house, corners, i, 0));
	city_polygon(o, house, corners + 2, corners);
	CITY_PUSH(o->shells, (struct tcs_shell){.polygon_count = corners + 2});
	CITY_PUSH(o->geometries,
		(struct tcs_geometry){.kind = TCS_SOLID,
			.lod = 2,
			.shell_count = 1,
			.polygon_count = corners + 2});
}

static inline void
city_write(FILE *to, unsigned houses, unsigned corners)
{
	struct tcs_object object = {.text = {NULL, 0, 0}};
	struct tcs_record record = {.type = 0};
	struct tcs_head head = {.text = {NULL, 0, 0}};
	struct tcs_writer writer;
	struct tcs_fault fault;

	writer_init(&writer, to, 0);
	CITY_PUSH(head.text, '\0');
	CITY_PUSH(head.crs,
		(struct tcs_crs){.metres_per_unit = 1,
			.metres_per_unit_up = 1,
			.origin = {504000, 5302000, 0},
			.epsg = 25832,
			.kind = TCS_CRS_PROJECTED,
			.flags = TCS_HAS_ORIGIN});
	city_must(head_encode(&head, &record, &fault), &fault);
	city_must(writer_put(&writer, &record, &fault), &fault);
	for (unsigned i = 0; i < houses; i++) {
		city_house(&object, i, corners);
		city_must(object_encode(&object, TCS_OBJECT, &record, &fault),
			&fault);
		city_must(writer_put(&writer, &record, &fault), &fault);
	}
	city_must(writer_end(&writer, &fault), &fault);
	writer_release(&writer);
	record_release(&record);
	object_release(&object);
	head_release(&head);
}

#endif
