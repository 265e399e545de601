#include "tcs_field.h"

#include <string.h>

static const char *const no_names[] = {NULL};
static const char *const attribute_types[] = {"string", "integer", "double",
	"boolean", "date", "uri", "measure", "code", "set", NULL};
static const char *const attribute_flags[] = {"generic", NULL};
static const char *const geometry_kinds[] = {"solid", "multi-solid",
	"composite-solid", "multi-surface", "composite-surface", "tin",
	"multi-curve", "multi-point", NULL};
static const char *const geometry_flags[] = {"simplified", NULL};
static const char *const polygon_flags[] = {
	"reversed", "repaired", "shared", NULL};
static const char *const paint_flags[] = {"back", NULL};
static const char *const crs_kinds[] = {
	"unknown", "projected", "geographic", "geocentric", "local", NULL};
static const char *const crs_flags[] = {
	"north-first", "assumed", "bounds", "origin", NULL};
static const char *const wraps[] = {
	"none", "repeat", "mirror", "clamp", "border", NULL};

#define SIZE(holder, member) sizeof(((struct holder *)0)->member)

/* A field of one value, of several, with names. */
#define ONE(holder, member, kind) \
	{ \
		.name = #member, .type = FIELD_##kind, \
		.at = offsetof(struct holder, member), \
		.size = SIZE(holder, member), .count = 1, \
	}
#define MANY(holder, member, kind, n) \
	{ \
		.name = #member, .type = FIELD_##kind, \
		.at = offsetof(struct holder, member), \
		.size = SIZE(holder, member) / (n), .count = (n), \
	}
#define NAMES(holder, member, kind, list) \
	{ \
		.name = #member, .type = FIELD_##kind, \
		.at = offsetof(struct holder, member), \
		.size = SIZE(holder, member), .count = 1, .names = (list), \
	}

static const struct tcs_field feature_fields[] = {
	ONE(tcs_feature, class, CLASS),
	ONE(tcs_feature, id, TEXT),
	ONE(tcs_feature, name, TEXT),
	ONE(tcs_feature, type, TEXT),
	ONE(tcs_feature, role, TEXT),
	ONE(tcs_feature, parent, LINK),
	NAMES(tcs_feature, flags, FLAGS, no_names),
};

static const struct tcs_field attribute_fields[] = {
	ONE(tcs_attribute, name, TEXT),
	ONE(tcs_attribute, space, TEXT),
	NAMES(tcs_attribute, type, NAMED, attribute_types),
	ONE(tcs_attribute, value, TEXT),
	ONE(tcs_attribute, number, DOUBLE),
	ONE(tcs_attribute, unit, TEXT),
	ONE(tcs_attribute, code_space, TEXT),
	NAMES(tcs_attribute, flags, FLAGS, attribute_flags),
	ONE(tcs_attribute, feature, RUN),
	ONE(tcs_attribute, parent, RUN),
};

static const struct tcs_field relation_fields[] = {
	ONE(tcs_relation, feature, INDEX),
	ONE(tcs_relation, role, TEXT),
	ONE(tcs_relation, target, TEXT),
	ONE(tcs_relation, note, TEXT),
};

static const struct tcs_field geometry_fields[] = {
	ONE(tcs_geometry, feature, INDEX),
	ONE(tcs_geometry, lod, LOD),
	NAMES(tcs_geometry, kind, NAMED, geometry_kinds),
	ONE(tcs_geometry, role, TEXT),
	ONE(tcs_geometry, id, TEXT),
	NAMES(tcs_geometry, flags, FLAGS, geometry_flags),
	ONE(tcs_geometry, first_shell, RUN),
	ONE(tcs_geometry, shell_count, RUN),
	ONE(tcs_geometry, first_polygon, RUN),
	ONE(tcs_geometry, polygon_count, RUN),
};

static const struct tcs_field shell_fields[] = {
	ONE(tcs_shell, id, TEXT),
	ONE(tcs_shell, solid, COUNT),
	ONE(tcs_shell, interior, YES),
	ONE(tcs_shell, polygon_count, INDEX),
	ONE(tcs_shell, first_polygon, RUN),
};

static const struct tcs_field polygon_fields[] = {
	ONE(tcs_polygon, id, TEXT),
	ONE(tcs_polygon, surface, INDEX),
	NAMES(tcs_polygon, flags, FLAGS, polygon_flags),
	ONE(tcs_polygon, first_vertex, RUN),
	ONE(tcs_polygon, vertex_count, RUN),
	ONE(tcs_polygon, first_ring, RUN),
	ONE(tcs_polygon, ring_count, RUN),
	ONE(tcs_polygon, first_triangle, RUN),
	ONE(tcs_polygon, triangle_count, RUN),
};

static const struct tcs_field ring_fields[] = {
	ONE(tcs_ring, id, TEXT),
	ONE(tcs_ring, vertex_count, INDEX),
	ONE(tcs_ring, first_vertex, RUN),
};

static const struct tcs_field paint_fields[] = {
	ONE(tcs_paint, polygon, INDEX),
	ONE(tcs_paint, theme, TEXT),
	ONE(tcs_paint, material, LINK),
	ONE(tcs_paint, image, LINK),
	NAMES(tcs_paint, flags, FLAGS, paint_flags),
	ONE(tcs_paint, first_texcoord, RUN),
};

static const struct tcs_field instance_fields[] = {
	ONE(tcs_instance, feature, INDEX),
	ONE(tcs_instance, prototype, INDEX),
	ONE(tcs_instance, lod, LOD),
	ONE(tcs_instance, id, TEXT),
	MANY(tcs_instance, anchor, DOUBLE, 3),
	MANY(tcs_instance, matrix, DOUBLE, 16),
	NAMES(tcs_instance, flags, FLAGS, no_names),
};

static const struct tcs_field crs_fields[] = {
	ONE(tcs_crs, name, TEXT),
	ONE(tcs_crs, epsg, INTEGER),
	ONE(tcs_crs, epsg_up, INTEGER),
	NAMES(tcs_crs, kind, NAMED, crs_kinds),
	ONE(tcs_crs, metres_per_unit, DOUBLE),
	ONE(tcs_crs, metres_per_unit_up, DOUBLE),
	MANY(tcs_crs, origin, DOUBLE, 3),
	MANY(tcs_crs, lower, DOUBLE, 3),
	MANY(tcs_crs, upper, DOUBLE, 3),
	NAMES(tcs_crs, flags, FLAGS, crs_flags),
	ONE(tcs_crs, assumed, TEXT),
};

static const struct tcs_field source_fields[] = {
	ONE(tcs_source, format, TEXT),
	ONE(tcs_source, name, TEXT),
};

static const struct tcs_field model_fields[] = {
	ONE(tcs_model, id, TEXT),
	ONE(tcs_model, name, TEXT),
	ONE(tcs_model, description, TEXT),
};

static const struct tcs_field stage_fields[] = {
	ONE(tcs_stage, program, TEXT),
	ONE(tcs_stage, version, TEXT),
	ONE(tcs_stage, arguments, TEXT),
};

static const struct tcs_field image_fields[] = {
	ONE(tcs_image, id, TEXT),
	ONE(tcs_image, uri, TEXT),
	ONE(tcs_image, mime, TEXT),
	ONE(tcs_image, type, TEXT),
	NAMES(tcs_image, wrap, NAMED, wraps),
	MANY(tcs_image, border, FLOAT, 4),
	ONE(tcs_image, reserved, COUNT),
	ONE(tcs_image, first_byte, RUN),
	ONE(tcs_image, byte_count, RUN),
};

static const struct tcs_field material_fields[] = {
	ONE(tcs_material, id, TEXT),
	MANY(tcs_material, diffuse, FLOAT, 3),
	MANY(tcs_material, emissive, FLOAT, 3),
	MANY(tcs_material, specular, FLOAT, 3),
	ONE(tcs_material, ambient, FLOAT),
	ONE(tcs_material, shininess, FLOAT),
	ONE(tcs_material, transparency, FLOAT),
	ONE(tcs_material, smooth, YES),
};

static const struct tcs_field tally_fields[] = {
	ONE(tcs_tally, objects, COUNT),
	ONE(tcs_tally, prototypes, COUNT),
	ONE(tcs_tally, images, COUNT),
	ONE(tcs_tally, materials, COUNT),
	ONE(tcs_tally, features, COUNT),
	ONE(tcs_tally, polygons, COUNT),
	ONE(tcs_tally, triangles, COUNT),
	ONE(tcs_tally, instances, COUNT),
};

#define FIELDS(kind, a, b, c, d) \
	const struct tcs_fields fields_##kind = { \
		kind##_fields, \
		sizeof kind##_fields / sizeof *kind##_fields, \
		sizeof(struct tcs_##kind), \
		TCS_TAG(a, b, c, d), \
	}

FIELDS(feature, 'F', 'E', 'A', 'T');
FIELDS(attribute, 'A', 'T', 'T', 'R');
FIELDS(relation, 'R', 'E', 'L', 'A');
FIELDS(geometry, 'G', 'E', 'O', 'M');
FIELDS(shell, 'S', 'H', 'E', 'L');
FIELDS(polygon, 'P', 'O', 'L', 'Y');
FIELDS(ring, 'R', 'I', 'N', 'G');
FIELDS(paint, 'P', 'A', 'I', 'N');
FIELDS(instance, 'I', 'N', 'S', 'T');
FIELDS(crs, 'C', 'R', 'S', ' ');
FIELDS(source, 'S', 'O', 'U', 'R');
FIELDS(model, 'M', 'O', 'D', 'L');
FIELDS(stage, 'S', 'T', 'A', 'G');
FIELDS(image, 'I', 'M', 'A', 'G');
FIELDS(material, 'M', 'A', 'T', 'L');
FIELDS(tally, 'T', 'A', 'L', 'Y');

uint64_t
field_get(const struct tcs_field *field, const void *element)
{
	uint64_t value = 0;

	memcpy(&value, (const char *)element + field->at, field->size);
	return value;
}

void
field_set(const struct tcs_field *field, void *element, uint64_t value)
{
	memcpy((char *)element + field->at, &value, field->size);
}

void
fields_default(const struct tcs_fields *fields, void *element)
{
	memset(element, 0, fields->size);
	for (size_t i = 0; i < fields->count; i++) {
		if (fields->at[i].type == FIELD_LINK)
			field_set(&fields->at[i], element, TCS_NONE);
		if (fields->at[i].type == FIELD_LOD)
			field_set(&fields->at[i], element, TCS_LOD_NONE);
	}
}

const struct tcs_field *
fields_find(const struct tcs_fields *fields, const char *name)
{
	for (size_t i = 0; i < fields->count; i++)
		if (fields->at[i].type != FIELD_RUN &&
			!strcmp(fields->at[i].name, name))
			return &fields->at[i];
	return NULL;
}
