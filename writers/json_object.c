#include "json_object.h"

/* ---- features -------------------------------------------------------- */

/* The attributes of one feature, from *next on. */
static void
print_attributes(struct json_text *json, const struct tcs_object *object,
	size_t feature, size_t *next)
{
	const struct tcs_attribute *attributes = object->attributes.at;
	size_t first = *next, i;

	for (i = first; i < object->attributes.count; i++) {
		if (attributes[i].feature != feature)
			break;
		if (i == first) {
			print_key(json, "attributes");
			print_raw(json, "[");
		}
		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_attribute, &attributes[i],
			object->text.at);
		if (attributes[i].parent != TCS_NONE) {
			print_key(json, "member_of");
			print_unsigned(json, attributes[i].parent - first);
		}
		print_raw(json, "}");
	}
	if (i > first)
		print_raw(json, "]");
	*next = i;
}

static void
print_features(struct json_text *json, const struct tcs_object *object)
{
	size_t attribute = 0;

	print_key(json, "features");
	print_raw(json, "[");
	for (size_t i = 0; i < object->features.count; i++) {
		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_feature, &object->features.at[i],
			object->text.at);
		print_attributes(json, object, i, &attribute);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

static void
print_relations(struct json_text *json, const struct tcs_object *object)
{
	if (!object->relations.count)
		return;
	print_key(json, "relations");
	print_raw(json, "[");
	for (size_t i = 0; i < object->relations.count; i++) {
		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_relation, &object->relations.at[i],
			object->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

/* ---- geometries ------------------------------------------------------ */

static void
print_vertices(struct json_text *json, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	if (!polygon->vertex_count)
		return;
	print_key(json, "vertices");
	print_raw(json, "[");
	for (uint32_t i = 0; i < polygon->vertex_count; i++) {
		const struct tcs_point *point =
			&object->vertices.at[polygon->first_vertex + i];
		double numbers[3] = {point->x, point->y, point->z};

		print_comma(json);
		print_doubles(json, numbers, 3);
	}
	print_raw(json, "]");
}

static void
print_rings(struct json_text *json, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	if (!polygon->ring_count)
		return;
	print_key(json, "rings");
	print_raw(json, "[");
	for (uint32_t i = 0; i < polygon->ring_count; i++) {
		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_ring,
			&object->rings.at[polygon->first_ring + i],
			object->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

/* Corners count from the polygon's own first vertex. */
static void
print_triangles(struct json_text *json, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	if (!polygon->triangle_count)
		return;
	print_key(json, "triangles");
	print_raw(json, "[");
	for (uint32_t i = 0; i < polygon->triangle_count; i++) {
		const struct tcs_triangle *triangle =
			&object->triangles.at[polygon->first_triangle + i];

		print_raw(json, i ? ",[" : "[");
		for (int k = 0; k < 3; k++) {
			if (k)
				print_raw(json, ",");
			print_unsigned(json,
				triangle->corner[k] - polygon->first_vertex);
		}
		print_raw(json, "]");
	}
	print_raw(json, "]");
}

static void
print_polygons(struct json_text *json, const struct tcs_object *object,
	const struct tcs_geometry *geometry)
{
	if (!geometry->polygon_count)
		return;
	print_key(json, "polygons");
	print_raw(json, "[");
	for (uint32_t i = 0; i < geometry->polygon_count; i++) {
		const struct tcs_polygon *polygon =
			&object->polygons.at[geometry->first_polygon + i];

		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_polygon, polygon, object->text.at);
		print_rings(json, object, polygon);
		print_vertices(json, object, polygon);
		print_triangles(json, object, polygon);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

static void
print_shells(struct json_text *json, const struct tcs_object *object,
	const struct tcs_geometry *geometry)
{
	if (!geometry->shell_count)
		return;
	print_key(json, "shells");
	print_raw(json, "[");
	for (uint32_t i = 0; i < geometry->shell_count; i++) {
		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_shell,
			&object->shells.at[geometry->first_shell + i],
			object->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

static void
print_geometries(struct json_text *json, const struct tcs_object *object)
{
	if (!object->geometries.count)
		return;
	print_key(json, "geometries");
	print_raw(json, "[");
	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];

		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_geometry, geometry, object->text.at);
		print_shells(json, object, geometry);
		print_polygons(json, object, geometry);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

/* ---- paints, instances ----------------------------------------------- */

static void
print_texcoords(struct json_text *json, const struct tcs_object *object,
	const struct tcs_paint *paint)
{
	uint32_t count = object->polygons.at[paint->polygon].vertex_count;

	if (paint->first_texcoord == TCS_NONE || !count)
		return;
	print_key(json, "texcoords");
	print_raw(json, "[");
	for (uint32_t i = 0; i < count; i++) {
		const struct tcs_texcoord *texcoord =
			&object->texcoords.at[paint->first_texcoord + i];
		double numbers[2] = {texcoord->s, texcoord->t};

		print_comma(json);
		print_doubles(json, numbers, 2);
	}
	print_raw(json, "]");
}

static void
print_paints(struct json_text *json, const struct tcs_object *object)
{
	if (!object->paints.count)
		return;
	print_key(json, "paints");
	print_raw(json, "[");
	for (size_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];

		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_paint, paint, object->text.at);
		print_texcoords(json, object, paint);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

static void
print_instances(struct json_text *json, const struct tcs_object *object)
{
	if (!object->instances.count)
		return;
	print_key(json, "instances");
	print_raw(json, "[");
	for (size_t i = 0; i < object->instances.count; i++) {
		print_comma(json);
		print_raw(json, "{");
		print_fields(json, &fields_instance, &object->instances.at[i],
			object->text.at);
		print_raw(json, "}");
	}
	print_raw(json, "]");
}

void
print_object(struct json_text *json, const struct tcs_object *object)
{
	print_features(json, object);
	print_relations(json, object);
	print_geometries(json, object);
	print_paints(json, object);
	print_instances(json, object);
}
