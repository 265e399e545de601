#include "json_object.h"

/* ---- features -------------------------------------------------------- */

/* The attributes of one feature, from *next on. */
static void
json_attributes(struct json_text *json, const struct tcs_object *object,
	size_t feature, size_t *next)
{
	const struct tcs_attribute *attributes = object->attributes.at;
	size_t first = *next, i;

	for (i = first; i < object->attributes.count; i++) {
		if (attributes[i].feature != feature)
			break;
		if (i == first) {
			json_key(json, "attributes");
			json_raw(json, "[");
		}
		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_attribute, &attributes[i],
			object->text.at);
		if (attributes[i].parent != TCS_NONE) {
			json_key(json, "set");
			json_unsigned(json, attributes[i].parent - first);
		}
		json_raw(json, "}");
	}
	if (i > first)
		json_raw(json, "]");
	*next = i;
}

static void
json_features(struct json_text *json, const struct tcs_object *object)
{
	size_t attribute = 0;

	json_key(json, "features");
	json_raw(json, "[");
	for (size_t i = 0; i < object->features.count; i++) {
		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_feature, &object->features.at[i],
			object->text.at);
		json_attributes(json, object, i, &attribute);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

static void
json_relations(struct json_text *json, const struct tcs_object *object)
{
	if (!object->relations.count)
		return;
	json_key(json, "relations");
	json_raw(json, "[");
	for (size_t i = 0; i < object->relations.count; i++) {
		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_relation, &object->relations.at[i],
			object->text.at);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

/* ---- geometries ------------------------------------------------------ */

static void
json_vertices(struct json_text *json, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	if (!polygon->vertex_count)
		return;
	json_key(json, "vertices");
	json_raw(json, "[");
	for (uint32_t i = 0; i < polygon->vertex_count; i++) {
		const struct tcs_point *point =
			&object->vertices.at[polygon->first_vertex + i];
		double numbers[3] = {point->x, point->y, point->z};

		json_comma(json);
		json_doubles(json, numbers, 3);
	}
	json_raw(json, "]");
}

static void
json_rings(struct json_text *json, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	if (!polygon->ring_count)
		return;
	json_key(json, "rings");
	json_raw(json, "[");
	for (uint32_t i = 0; i < polygon->ring_count; i++) {
		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_ring,
			&object->rings.at[polygon->first_ring + i],
			object->text.at);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

/* Corners count from the polygon's own first vertex. */
static void
json_triangles(struct json_text *json, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	if (!polygon->triangle_count)
		return;
	json_key(json, "triangles");
	json_raw(json, "[");
	for (uint32_t i = 0; i < polygon->triangle_count; i++) {
		const struct tcs_triangle *triangle =
			&object->triangles.at[polygon->first_triangle + i];

		json_raw(json, i ? ",[" : "[");
		for (int k = 0; k < 3; k++) {
			if (k)
				json_raw(json, ",");
			json_unsigned(json,
				triangle->corner[k] - polygon->first_vertex);
		}
		json_raw(json, "]");
	}
	json_raw(json, "]");
}

static void
json_polygons(struct json_text *json, const struct tcs_object *object,
	const struct tcs_geometry *geometry)
{
	if (!geometry->polygon_count)
		return;
	json_key(json, "polygons");
	json_raw(json, "[");
	for (uint32_t i = 0; i < geometry->polygon_count; i++) {
		const struct tcs_polygon *polygon =
			&object->polygons.at[geometry->first_polygon + i];

		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_polygon, polygon, object->text.at);
		json_rings(json, object, polygon);
		json_vertices(json, object, polygon);
		json_triangles(json, object, polygon);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

static void
json_shells(struct json_text *json, const struct tcs_object *object,
	const struct tcs_geometry *geometry)
{
	if (!geometry->shell_count)
		return;
	json_key(json, "shells");
	json_raw(json, "[");
	for (uint32_t i = 0; i < geometry->shell_count; i++) {
		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_shell,
			&object->shells.at[geometry->first_shell + i],
			object->text.at);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

static void
json_geometries(struct json_text *json, const struct tcs_object *object)
{
	if (!object->geometries.count)
		return;
	json_key(json, "geometries");
	json_raw(json, "[");
	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];

		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_geometry, geometry, object->text.at);
		json_shells(json, object, geometry);
		json_polygons(json, object, geometry);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

/* ---- paints, instances ----------------------------------------------- */

static void
json_texcoords(struct json_text *json, const struct tcs_object *object,
	const struct tcs_paint *paint)
{
	uint32_t count = object->polygons.at[paint->polygon].vertex_count;

	if (paint->first_texcoord == TCS_NONE || !count)
		return;
	json_key(json, "texcoords");
	json_raw(json, "[");
	for (uint32_t i = 0; i < count; i++) {
		const struct tcs_texcoord *texcoord =
			&object->texcoords.at[paint->first_texcoord + i];
		double numbers[2] = {texcoord->s, texcoord->t};

		json_comma(json);
		json_doubles(json, numbers, 2);
	}
	json_raw(json, "]");
}

static void
json_paints(struct json_text *json, const struct tcs_object *object)
{
	if (!object->paints.count)
		return;
	json_key(json, "paints");
	json_raw(json, "[");
	for (size_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];

		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_paint, paint, object->text.at);
		json_texcoords(json, object, paint);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

static void
json_instances(struct json_text *json, const struct tcs_object *object)
{
	if (!object->instances.count)
		return;
	json_key(json, "instances");
	json_raw(json, "[");
	for (size_t i = 0; i < object->instances.count; i++) {
		json_comma(json);
		json_raw(json, "{");
		json_fields(json, &fields_instance, &object->instances.at[i],
			object->text.at);
		json_raw(json, "}");
	}
	json_raw(json, "]");
}

void
json_object(struct json_text *json, const struct tcs_object *object)
{
	json_features(json, object);
	json_relations(json, object);
	json_geometries(json, object);
	json_paints(json, object);
	json_instances(json, object);
}
