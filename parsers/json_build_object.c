#include <string.h>

#include "json_build.h"

static const char *const none[] = {NULL};

/* Appends one element of a kind to the object. */
typedef enum tcs_status build_one(struct json_place *place, const json_t *value,
	struct tcs_object *object);

/* Build each item of the array under `key`, if there is one. */
static enum tcs_status
build_all(struct json_place *place, const json_t *holder, const char *key,
	struct tcs_object *object, build_one *build)
{
	const json_t *array;
	enum tcs_status status = json_get_array(place, holder, key, &array);

	if (status || !array)
		return status;
	for (size_t i = 0; !status && i < json_array_size(array); i++) {
		json_enter(place, key, i);
		status = build(place, json_array_get(array, i), object);
		json_leave(place);
	}
	return status;
}

/* ---- features -------------------------------------------------------- */

static enum tcs_status
build_attribute(struct json_place *place, const json_t *value,
	struct tcs_object *object, size_t first)
{
	static const char *const nested[] = {"member_of", NULL};
	struct tcs_attribute attribute;
	const json_t *owner;
	uint64_t index;
	enum tcs_status status = json_get_fields(place, value,
		&fields_attribute, nested, &attribute, &object->text);

	if (status)
		return status;
	attribute.feature = (uint32_t)(object->features.count - 1);
	attribute.parent = TCS_NONE;
	owner = json_object_get(value, "member_of");
	if (owner) {
		status = json_get_index(place, "member_of", owner,
			UINT32_MAX - 1 - first, &index);
		if (status)
			return status;
		attribute.parent = (uint32_t)(first + index);
	}
	if (array_grow(&object->attributes, 1))
		return fault_memory(place->fault);
	object->attributes.at[object->attributes.count++] = attribute;
	return TCS_OK;
}

static enum tcs_status
build_feature(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	static const char *const nested[] = {"attributes", NULL};
	struct tcs_feature feature;
	const json_t *attributes;
	size_t first = object->attributes.count;
	enum tcs_status status = json_get_fields(
		place, value, &fields_feature, nested, &feature, &object->text);

	if (status)
		return status;
	if (array_grow(&object->features, 1))
		return fault_memory(place->fault);
	object->features.at[object->features.count++] = feature;
	status = json_get_array(place, value, "attributes", &attributes);
	for (size_t i = 0; !status && i < json_array_size(attributes); i++) {
		json_enter(place, "attributes", i);
		status = build_attribute(
			place, json_array_get(attributes, i), object, first);
		json_leave(place);
	}
	return status;
}

static enum tcs_status
build_relation(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	struct tcs_relation relation;
	enum tcs_status status = json_get_fields(
		place, value, &fields_relation, none, &relation, &object->text);

	if (status)
		return status;
	if (array_grow(&object->relations, 1))
		return fault_memory(place->fault);
	object->relations.at[object->relations.count++] = relation;
	return TCS_OK;
}

/* ---- polygons -------------------------------------------------------- */

/* The polygon under construction is the last one. */
static struct tcs_polygon *
last_polygon(struct tcs_object *object)
{
	return &object->polygons.at[object->polygons.count - 1];
}

static enum tcs_status
build_ring(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	struct tcs_polygon *polygon = last_polygon(object);
	struct tcs_ring ring;
	uint64_t first = polygon->first_vertex;
	enum tcs_status status = json_get_fields(
		place, value, &fields_ring, none, &ring, &object->text);

	if (status)
		return status;
	if (polygon->ring_count) {
		const struct tcs_ring *before =
			&object->rings.at[object->rings.count - 1];

		first = (uint64_t)before->first_vertex + before->vertex_count;
	}
	if (first > UINT32_MAX)
		return json_fault(place, "vertex_count", "too many vertices");
	if (array_grow(&object->rings, 1))
		return fault_memory(place->fault);
	ring.first_vertex = (uint32_t)first;
	object->rings.at[object->rings.count++] = ring;
	polygon->ring_count++;
	return TCS_OK;
}

static enum tcs_status
build_vertex(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	double numbers[3];
	enum tcs_status status =
		json_get_doubles(place, NULL, value, numbers, 3);

	if (status)
		return status;
	if (object->vertices.count == UINT32_MAX)
		return json_fault(place, NULL, "too many vertices");
	if (array_grow(&object->vertices, 1))
		return fault_memory(place->fault);
	object->vertices.at[object->vertices.count++] =
		(struct tcs_point){numbers[0], numbers[1], numbers[2]};
	last_polygon(object)->vertex_count++;
	return TCS_OK;
}

static enum tcs_status
build_triangle(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	struct tcs_polygon *polygon = last_polygon(object);
	struct tcs_triangle triangle;

	if (!json_is_array(value) || json_array_size(value) != 3)
		return json_fault(place, NULL, "not an array of three");
	for (size_t i = 0; i < 3; i++) {
		uint64_t corner;

		if (json_get_index(place, NULL, json_array_get(value, i),
			    UINT32_MAX - polygon->first_vertex, &corner))
			return place->fault->status;
		triangle.corner[i] = (uint32_t)corner + polygon->first_vertex;
	}
	if (array_grow(&object->triangles, 1))
		return fault_memory(place->fault);
	object->triangles.at[object->triangles.count++] = triangle;
	polygon->triangle_count++;
	return TCS_OK;
}

static enum tcs_status
build_polygon(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	static const char *const nested[] = {
		"rings", "vertices", "triangles", NULL};
	struct tcs_polygon polygon;
	enum tcs_status status = json_get_fields(
		place, value, &fields_polygon, nested, &polygon, &object->text);

	if (status)
		return status;
	polygon.first_vertex = (uint32_t)object->vertices.count;
	polygon.first_ring = (uint32_t)object->rings.count;
	polygon.first_triangle = (uint32_t)object->triangles.count;
	if (array_grow(&object->polygons, 1))
		return fault_memory(place->fault);
	object->polygons.at[object->polygons.count++] = polygon;
	status = build_all(place, value, "rings", object, build_ring);
	if (!status)
		status = build_all(
			place, value, "vertices", object, build_vertex);
	if (!status)
		status = build_all(
			place, value, "triangles", object, build_triangle);
	return status;
}

/* ---- geometries ------------------------------------------------------ */

static enum tcs_status
build_shell(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	const struct tcs_geometry *geometry =
		&object->geometries.at[object->geometries.count - 1];
	struct tcs_shell shell;
	uint64_t first = object->polygons.count;
	enum tcs_status status = json_get_fields(
		place, value, &fields_shell, none, &shell, &object->text);

	if (status)
		return status;
	if (object->shells.count > geometry->first_shell) {
		const struct tcs_shell *before =
			&object->shells.at[object->shells.count - 1];

		first = (uint64_t)before->first_polygon + before->polygon_count;
	}
	if (first > UINT32_MAX)
		return json_fault(place, "polygon_count", "too many polygons");
	if (array_grow(&object->shells, 1))
		return fault_memory(place->fault);
	shell.first_polygon = (uint32_t)first;
	object->shells.at[object->shells.count++] = shell;
	return TCS_OK;
}

static enum tcs_status
build_geometry(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	static const char *const nested[] = {"shells", "polygons", NULL};
	struct tcs_geometry geometry;
	size_t index = object->geometries.count;
	enum tcs_status status = json_get_fields(place, value, &fields_geometry,
		nested, &geometry, &object->text);

	if (status)
		return status;
	geometry.first_shell = (uint32_t)object->shells.count;
	geometry.first_polygon = (uint32_t)object->polygons.count;
	if (array_grow(&object->geometries, 1))
		return fault_memory(place->fault);
	object->geometries.at[object->geometries.count++] = geometry;
	status = build_all(place, value, "shells", object, build_shell);
	if (!status)
		status = build_all(
			place, value, "polygons", object, build_polygon);
	object->geometries.at[index].shell_count =
		(uint32_t)object->shells.count - geometry.first_shell;
	object->geometries.at[index].polygon_count =
		(uint32_t)object->polygons.count - geometry.first_polygon;
	return status;
}

/* ---- paints, instances ----------------------------------------------- */

static enum tcs_status
build_texcoord(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	double numbers[2];
	enum tcs_status status =
		json_get_doubles(place, NULL, value, numbers, 2);

	if (status)
		return status;
	if (array_grow(&object->texcoords, 1))
		return fault_memory(place->fault);
	object->texcoords.at[object->texcoords.count++] =
		(struct tcs_texcoord){numbers[0], numbers[1]};
	return TCS_OK;
}

static enum tcs_status
build_paint(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	static const char *const nested[] = {"texcoords", NULL};
	struct tcs_paint paint;
	enum tcs_status status = json_get_fields(
		place, value, &fields_paint, nested, &paint, &object->text);

	if (status)
		return status;
	if (object->texcoords.count >= TCS_NONE)
		return json_fault(place, "texcoords", "too many");
	paint.first_texcoord = paint.image == TCS_NONE
		? TCS_NONE
		: (uint32_t)object->texcoords.count;
	if (array_grow(&object->paints, 1))
		return fault_memory(place->fault);
	object->paints.at[object->paints.count++] = paint;
	return build_all(place, value, "texcoords", object, build_texcoord);
}

static enum tcs_status
build_instance(struct json_place *place, const json_t *value,
	struct tcs_object *object)
{
	struct tcs_instance instance;
	enum tcs_status status = json_get_fields(
		place, value, &fields_instance, none, &instance, &object->text);

	if (status)
		return status;
	if (array_grow(&object->instances, 1))
		return fault_memory(place->fault);
	object->instances.at[object->instances.count++] = instance;
	return TCS_OK;
}

enum tcs_status
json_build_object(
	struct json_place *place, const json_t *line, struct tcs_object *object)
{
	static const struct {
		const char *key;
		build_one *build;
	} parts[] = {
		{"features", build_feature},
		{"relations", build_relation},
		{"geometries", build_geometry},
		{"paints", build_paint},
		{"instances", build_instance},
	};
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < sizeof parts / sizeof *parts; i++)
		status = build_all(
			place, line, parts[i].key, object, parts[i].build);
	return status;
}
