#include "lod_source.h"

#include <string.h>

#include "shells.h"

static void
clear(struct lod_source *source)
{
	component_set_clear(&source->set);
	array_clear(&source->polygons);
	array_clear(&source->triangles);
	array_clear(&source->homes);
	byte_index_clear(&source->ids);
	array_clear(&source->named);
}

/* A shared polygon is the first one with its id. */
static enum tcs_status
find_home(struct lod_source *source, const struct tcs_object *object,
	uint32_t polygon, struct tcs_fault *fault)
{
	const struct tcs_polygon *own = &object->polygons.at[polygon];
	const char *id = object_text(object, own->id);
	uint32_t number;
	bool added;

	source->homes.at[polygon] = polygon;
	if (!own->id || !source->shared)
		return TCS_OK;
	if (byte_index_add(
		    &source->ids, id, strlen(id), &number, &added, fault) ||
		array_grow(&source->named, 1))
		return fault_memory(fault);
	if (added)
		source->named.at[source->named.count++] = polygon;
	else if (own->flags & TCS_POLYGON_SHARED)
		source->homes.at[polygon] = source->named.at[number];
	return TCS_OK;
}

static enum tcs_status
take_polygon(struct lod_source *source, const struct tcs_object *object,
	uint32_t polygon, uint32_t shell, struct tcs_fault *fault)
{
	const struct tcs_polygon *own = &object->polygons.at[polygon];
	const struct tcs_triangle *triangle =
		object->triangles.at + own->first_triangle;

	if (array_grow(&source->polygons, own->triangle_count) ||
		array_grow(&source->triangles, own->triangle_count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < own->triangle_count; i++) {
		struct tcs_point corners[3];
		enum tcs_status status;

		for (int k = 0; k < 3; k++)
			corners[k] = frame_to_local(&source->frame,
				object->vertices.at[triangle[i].corner[k]]);
		status = component_set_add(
			&source->set, corners, own->surface, shell, fault);
		if (status)
			return status;
		source->polygons.at[source->polygons.count++] = polygon;
		source->triangles.at[source->triangles.count++] =
			own->first_triangle + i;
	}
	return TCS_OK;
}

static enum tcs_status
take_geometry(struct lod_source *source, const struct tcs_object *object,
	const struct tcs_geometry *geometry, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	uint32_t shell = TCS_NONE;

	for (uint32_t i = 0; !status && i < geometry->polygon_count; i++) {
		uint32_t polygon = geometry->first_polygon + i;

		shell = shell_after(object, geometry, shell, polygon);
		status = find_home(source, object, polygon, fault);
		if (!status && source->homes.at[polygon] == polygon)
			status = take_polygon(
				source, object, polygon, shell, fault);
	}
	return status;
}

enum tcs_status
lod_source_load(struct lod_source *source, const struct tcs_object *object,
	int lod, const struct tcs_crs *crs, struct tcs_fault *fault)
{
	size_t count = object->polygons.count;
	enum tcs_status status;

	clear(source);
	frame_init(&source->frame, crs,
		object->vertices.count ? &object->vertices.at[0] : NULL);
	if (array_grow(&source->homes, count))
		return fault_memory(fault);
	source->homes.count = count;
	source->shared = false;
	for (size_t i = 0; i < count; i++) {
		source->homes.at[i] = TCS_NONE;
		source->shared |= (object->polygons.at[i].flags &
					  TCS_POLYGON_SHARED) != 0;
	}
	status = selection_make(&source->selection, object, lod, fault);
	if (!status)
		status = component_set_begin(&source->set, object, fault);
	for (size_t i = 0; !status && i < object->geometries.count; i++)
		if (source->selection.geometries.at[i])
			status = take_geometry(source, object,
				&object->geometries.at[i], fault);
	if (!status)
		status = component_set_join(&source->set, fault);
	return status;
}

void
lod_source_release(struct lod_source *source)
{
	selection_release(&source->selection);
	component_set_release(&source->set);
	array_release(&source->polygons);
	array_release(&source->triangles);
	array_release(&source->homes);
	byte_index_release(&source->ids);
	array_release(&source->named);
}
