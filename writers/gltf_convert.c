#include "gltf_convert.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "gltf_placement.h"
#include "labels.h"

#define NEAR 65536 /* metres; 32-bit floats are true to 4 mm there */

/* Everything a conversion passes down. */
struct conversion {
	struct converter *converter;
	const struct convert_settings *settings;
	const struct prototype_source *prototypes;
	const struct tcs_object *object;
	struct mesh *mesh;
	struct report *report;
	struct tcs_fault *fault;
};

/* ---- paint ----------------------------------------------------------- */

/* The theme to show: the one asked for, or the first the object has. */
static const char *
object_theme(const struct tcs_object *object, const char *wanted)
{
	if (wanted || !object->paints.count)
		return wanted;
	return object_text(object, object->paints.at->theme);
}

/* glTF keeps texture coordinates in 32-bit floats. */
static bool
texcoords_fit(const struct tcs_texcoord *at, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++)
		if (fabs(at[i].s) > FLT_MAX || fabs(1 - at[i].t) > FLT_MAX)
			return false;
	return true;
}

static enum tcs_status
take_texture(struct conversion *to, const struct tcs_object *object,
	const struct tcs_paint *paint)
{
	const struct tcs_polygon *polygon =
		object->polygons.at + paint->polygon;
	struct mesh_paint *chosen = to->converter->paints.at + paint->polygon;
	const struct tcs_texcoord *texcoords =
		object->texcoords.at + paint->first_texcoord;

	if (chosen->image != TCS_NONE)
		return report_item(to->report, REPORT_SKIPPED, "texture",
			"another one is there already",
			object_text(object, polygon->id), TCS_NOWHERE,
			to->fault);
	if (!texcoords_fit(texcoords, polygon->vertex_count))
		return report_item(to->report, REPORT_SKIPPED, "texture",
			"coordinates beyond 32-bit floats",
			object_text(object, polygon->id), TCS_NOWHERE,
			to->fault);
	chosen->image = paint->image;
	chosen->texcoords = texcoords;
	return TCS_OK;
}

/* The material and the image of each polygon, TCS_NONE without one. */
static enum tcs_status
find_paints(struct conversion *to, const struct tcs_object *object)
{
	struct converter *converter = to->converter;
	const char *theme = object_theme(object, to->settings->theme);
	enum tcs_status status = TCS_OK;

	array_clear(&converter->paints);
	if (array_grow(&converter->paints, object->polygons.count))
		return fault_memory(to->fault);
	converter->paints.count = object->polygons.count;
	for (size_t i = 0; i < object->polygons.count; i++)
		converter->paints.at[i] =
			(struct mesh_paint){TCS_NONE, TCS_NONE, NULL};
	for (size_t i = 0; i < object->paints.count && !status; i++) {
		const struct tcs_paint *paint = object->paints.at + i;
		struct mesh_paint *chosen =
			converter->paints.at + paint->polygon;

		if (strcmp(object_text(object, paint->theme), theme) ||
			paint->flags & TCS_PAINT_BACK)
			continue;
		if (chosen->paint == TCS_NONE)
			chosen->paint = paint->material;
		if (paint->image != TCS_NONE && !to->settings->drop_textures)
			status = take_texture(to, object, paint);
	}
	return status;
}

static struct mesh_paint
polygon_paint(const struct conversion *to, uint32_t polygon, uint32_t class,
	const struct tcs_geometry *geometry)
{
	struct mesh_paint paint = to->converter->paints.at[polygon];
	bool solid = geometry->kind == TCS_SOLID ||
		geometry->kind == TCS_MULTI_SOLID ||
		geometry->kind == TCS_COMPOSITE_SOLID;

	paint.paint = paint.paint > PAINT_NUMBER ? class
						 : paint.paint | PAINT_MATERIAL;
	if (!solid)
		paint.paint |= PAINT_DOUBLE_SIDED;
	return paint;
}

/* ---- polygons -------------------------------------------------------- */

static enum tcs_status
note_outcome(struct conversion *to, enum mesh_outcome outcome, const char *id)
{
	switch (outcome) {
	case MESH_NO_AREA:
		return report_item(to->report, REPORT_SKIPPED, "polygon",
			"no area", id, TCS_NOWHERE, to->fault);
	case MESH_TOO_FAR:
		return report_item(to->report, REPORT_SKIPPED, "polygon",
			"too far from the origin for 32-bit floats", id,
			TCS_NOWHERE, to->fault);
	case MESH_DRAWN:
		break;
	}
	return TCS_OK;
}

/*
 * A polygon that stands in an earlier geometry too is drawn once. Not every
 * earlier geometry is drawn, so this goes by the ids of those that were.
 */
static bool
is_repeated(const struct conversion *to, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	const char *id = object_text(object, polygon->id);

	return polygon->flags & TCS_POLYGON_SHARED && polygon->id &&
		byte_index_find(&to->converter->drawn, id, strlen(id)) !=
		INDEX_NONE;
}

static enum tcs_status
remember_drawn(struct conversion *to, const struct tcs_object *object,
	const struct tcs_geometry *geometry)
{
	const struct tcs_polygon *polygon =
		object->polygons.at + geometry->first_polygon;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; i < geometry->polygon_count && !status; i++) {
		const char *id = object_text(object, polygon[i].id);
		uint32_t number;
		bool added;

		if (polygon[i].id)
			status = byte_index_add(&to->converter->drawn, id,
				strlen(id), &number, &added, to->fault);
	}
	return status;
}

/* For whom a prototype is drawn: every surface of it is this feature. */
struct placed {
	uint32_t feature;
	uint32_t class;
};

/* Draw one geometry of `object`; it is a prototype if it is placed. */
static enum tcs_status
draw_geometry(struct conversion *to, const struct tcs_object *object,
	const struct tcs_geometry *geometry, const struct mesh_place *place,
	const struct placed *placed)
{
	enum tcs_status status = TCS_OK;
	uint32_t end = geometry->first_polygon + geometry->polygon_count;

	for (uint32_t i = geometry->first_polygon; i < end && !status; i++) {
		const struct tcs_polygon *polygon = object->polygons.at + i;
		uint32_t feature = placed ? placed->feature : polygon->surface;
		uint32_t class = object->features.at[polygon->surface].class;
		struct mesh_paint paint;
		enum mesh_outcome outcome;

		if (is_repeated(to, object, polygon))
			continue;
		if (placed && class == TCS_CLASS_Unknown)
			class = placed->class;
		paint = polygon_paint(to, i, class, geometry);
		status = mesh_add_polygon(to->mesh, object, polygon, place,
			feature, &paint, to->settings->normals, &outcome,
			to->fault);
		if (!status)
			status = note_outcome(
				to, outcome, object_text(object, polygon->id));
	}
	return status;
}

static bool
shares_polygons(const struct tcs_object *object)
{
	for (size_t i = 0; i < object->polygons.count; i++)
		if (object->polygons.at[i].flags & TCS_POLYGON_SHARED)
			return true;
	return false;
}

static enum tcs_status
note_geometry(struct conversion *to, const struct tcs_geometry *geometry)
{
	const char *id = object_text(to->object, geometry->id);

	if (geometry->kind == TCS_MULTI_CURVE)
		return report_item(to->report, REPORT_SKIPPED, "geometry",
			"curves are not carried", id, TCS_NOWHERE, to->fault);
	if (geometry->kind == TCS_MULTI_POINT)
		return report_item(to->report, REPORT_SKIPPED, "geometry",
			"points are not carried", id, TCS_NOWHERE, to->fault);
	return report_add(
		to->report, "geometries of other levels", 1, to->fault);
}

static enum tcs_status
draw_geometries(struct conversion *to)
{
	const struct tcs_object *object = to->object;
	struct mesh_place place = {&to->settings->frame, NULL};
	bool shared = shares_polygons(object);
	enum tcs_status status = find_paints(to, object);

	byte_index_clear(&to->converter->drawn);
	for (size_t i = 0; i < object->geometries.count && !status; i++) {
		const struct tcs_geometry *geometry = object->geometries.at + i;

		if (!to->converter->selection.geometries.at[i]) {
			status = note_geometry(to, geometry);
			continue;
		}
		status = draw_geometry(to, object, geometry, &place, NULL);
		if (!status && shared)
			status = remember_drawn(to, object, geometry);
	}
	return status;
}

/* ---- instances ------------------------------------------------------- */

static enum tcs_status
draw_prototype(struct conversion *to, const struct tcs_object *prototype,
	const struct mesh_place *place, const struct placed *placed)
{
	enum tcs_status status = find_paints(to, prototype);

	byte_index_clear(&to->converter->drawn);
	for (size_t i = 0; i < prototype->geometries.count && !status; i++) {
		const struct tcs_geometry *geometry =
			prototype->geometries.at + i;

		status = geometry_has_area(geometry)
			? draw_geometry(to, prototype, geometry, place, placed)
			: note_geometry(to, geometry);
	}
	return status;
}

/*
 * Coordinates of its own are small in a prototype that can stay a mesh: others
 * would lose their digits before the matrix brings them near.
 */
static bool
can_be_shared(const struct conversion *to, const struct tcs_object *prototype,
	const struct tcs_instance *instance, double matrix[16])
{
	const struct tcs_point *first = prototype->vertices.at;

	return to->settings->instances != INSTANCES_BAKED &&
		prototype->vertices.count && fabs(first->x) < NEAR &&
		fabs(first->y) < NEAR && fabs(first->z) < NEAR &&
		placement_matrix(matrix, &to->settings->frame, instance);
}

static enum tcs_status
draw_instance(struct conversion *to, const struct tcs_instance *instance)
{
	const struct tcs_object *prototype = to->prototypes->get(
		to->prototypes->context, instance->prototype);
	const struct mesh_place place = {&to->settings->frame, instance};
	const struct placed placed = {instance->feature,
		to->object->features.at[instance->feature].class};
	struct mesh_instance shared = {
		instance->feature, instance->prototype, placed.class, {0}};
	enum tcs_status status;

	if (!can_be_shared(to, prototype, instance, shared.matrix)) {
		status = draw_prototype(to, prototype, &place, &placed);
		return status
			? status
			: report_add(to->report, "instances", 1, to->fault);
	}
	if (array_grow(&to->mesh->instances, 1))
		return fault_memory(to->fault);
	to->mesh->instances.at[to->mesh->instances.count++] = shared;
	return report_add(to->report, "instances", 1, to->fault);
}

static enum tcs_status
draw_instances(struct conversion *to)
{
	const struct tcs_object *object = to->object;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < object->instances.count && !status; i++)
		status = to->converter->selection.instances.at[i]
			? draw_instance(to, object->instances.at + i)
			: report_add(to->report, "instances of other levels", 1,
				  to->fault);
	return status;
}

/* ---- the whole ------------------------------------------------------- */

static enum tcs_status
note_relations(struct conversion *to)
{
	const struct tcs_object *object = to->object;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < object->relations.count && !status; i++) {
		uint32_t feature = object->relations.at[i].feature;

		status = report_item(to->report, REPORT_SKIPPED, "relation",
			"links between features are not carried",
			object_text(object, object->features.at[feature].id),
			TCS_NOWHERE, to->fault);
	}
	return status;
}

/* What all polygons need once they are drawn. */
static enum tcs_status
finish_mesh(struct conversion *to)
{
	struct mesh *mesh = to->mesh;
	enum tcs_status status = TCS_OK;

	if (to->settings->normals == MESH_SMOOTH)
		status = mesh_smooth(
			mesh, to->settings->crease_cosine, to->fault);
	if (!status)
		status = report_add(
			to->report, "polygons", mesh->runs.count, to->fault);
	return status ? status : mesh_group(mesh, to->fault);
}

static enum tcs_status
note_triangles(const struct conversion *to)
{
	enum tcs_status status = TCS_OK;

	if (to->mesh->flat_triangles)
		status = report_add(to->report, "triangles without area",
			to->mesh->flat_triangles, to->fault);
	return status ? status
		      : report_add(to->report, "triangles",
				to->mesh->indices.count / 3, to->fault);
}

enum tcs_status
convert_object(struct converter *converter,
	const struct convert_settings *settings,
	const struct prototype_source *prototypes,
	const struct tcs_object *object, struct mesh *mesh,
	struct report *report, struct tcs_fault *fault)
{
	struct conversion to = {
		converter, settings, prototypes, object, mesh, report, fault};
	enum tcs_status status;

	mesh_clear(mesh);
	mesh->triangle_limit = settings->triangle_limit;
	status = selection_make(
		&converter->selection, object, settings->lod, fault);
	if (!status)
		status = draw_geometries(&to);
	if (!status)
		status = draw_instances(&to);
	if (!status)
		status = finish_mesh(&to);
	if (!status)
		status = note_relations(&to);
	return status ? status : note_triangles(&to);
}

enum tcs_status
convert_prototype(struct converter *converter,
	const struct convert_settings *settings,
	const struct tcs_object *prototype, uint32_t class, struct mesh *mesh,
	struct report *report, struct tcs_fault *fault)
{
	struct conversion to = {
		converter, settings, NULL, prototype, mesh, report, fault};
	const struct mesh_place place = {NULL, NULL};
	const struct placed placed = {0, class};
	enum tcs_status status;

	mesh_clear(mesh);
	mesh->triangle_limit = settings->triangle_limit;
	status = draw_prototype(&to, prototype, &place, &placed);
	if (!status)
		status = finish_mesh(&to);
	return status ? status : note_triangles(&to);
}

void
converter_release(struct converter *converter)
{
	selection_release(&converter->selection);
	byte_index_release(&converter->drawn);
	array_release(&converter->paints);
}
