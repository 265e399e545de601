#include "exterior.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "box_tree.h"
#include "frame.h"
#include "labels.h"
#include "lod_select.h"
#include "object_filter.h"
#include "triangle_shape.h"

/* An object of more triangles is worth several threads. */
enum { LARGE = 50000 };

/* Pixels, wide and high; for few triangles, few will do. */
enum { SMALLEST_PICTURE = 128, LARGEST_PICTURE = 2048, PER_ROOT = 32 };

/* A convex body shows a quarter of its surface, in the mean. */
enum { SHOWN_OF_ALL = 4 };

/* ---- the polygons -------------------------------------------------------- */

/* A shared polygon is the first one with its id. */
static enum tcs_status
home_find(struct exterior *exterior, const struct tcs_object *object,
	uint32_t i, struct tcs_fault *fault)
{
	const struct tcs_polygon *polygon = &object->polygons.at[i];
	const char *id = object_text(object, polygon->id);
	uint32_t number;
	bool added;

	exterior->homes.at[i] = i;
	if (!*id)
		return TCS_OK;
	if (array_grow(&exterior->named, 1))
		return fault_memory(fault);
	if (byte_index_add(
		    &exterior->ids, id, strlen(id), &number, &added, fault))
		return TCS_NO_MEMORY;
	if (added)
		exterior->named.at[exterior->named.count++] = i;
	else if (polygon->flags & TCS_POLYGON_SHARED)
		exterior->homes.at[i] = exterior->named.at[number];
	return TCS_OK;
}

static enum tcs_status
begin(struct exterior *exterior, const struct exterior_settings *settings,
	const struct tcs_object *object, struct tcs_fault *fault)
{
	size_t count = object->polygons.count;
	struct frame frame;
	enum tcs_status status = TCS_OK;

	array_clear(&exterior->points);
	array_clear(&exterior->named);
	byte_index_clear(&exterior->ids);
	array_clear(&exterior->seen);
	array_clear(&exterior->whole);
	array_clear(&exterior->homes);
	array_clear(&exterior->keep);
	if (array_grow(&exterior->points, object->vertices.count + 1) ||
		array_grow(&exterior->seen, count + 1) ||
		array_grow(&exterior->whole, count + 1) ||
		array_grow(&exterior->homes, count + 1) ||
		array_grow(&exterior->keep, count + 1))
		return fault_memory(fault);
	frame_init(&frame, &settings->crs,
		object->vertices.count ? object->vertices.at : NULL);
	for (size_t i = 0; i < object->vertices.count; i++)
		exterior->points.at[i] =
			frame_to_local(&frame, object->vertices.at[i]);
	for (uint32_t i = 0; i < count && !status; i++) {
		exterior->seen.at[i] = exterior->whole.at[i] = 0;
		exterior->keep.at[i] = true;
		status = home_find(exterior, object, i, fault);
	}
	return status;
}

/* Rooms and the like, and the surfaces that are theirs. */
static bool
is_space(const struct tcs_object *object, uint32_t feature)
{
	const struct tcs_feature *features = object->features.at;

	while (feature &&
		label_of(features[feature].class)->kind == LABEL_SURFACE)
		feature = features[feature].parent;
	switch (features[feature].class) {
	case TCS_CLASS_BuildingRoom:
	case TCS_CLASS_BridgeRoom:
	case TCS_CLASS_HollowSpace:
	case TCS_CLASS_Storey:
	case TCS_CLASS_BuildingUnit:
		return true;
	default:
		return false;
	}
}

/* ---- one level ----------------------------------------------------------- */

static enum tcs_status
polygon_draw(struct exterior *exterior, const struct tcs_object *object,
	uint32_t i, struct tcs_fault *fault)
{
	const struct tcs_polygon *polygon = &object->polygons.at[i];
	size_t count = polygon->triangle_count;

	if (array_grow(&exterior->triangles, count) ||
		array_grow(&exterior->polygons, count))
		return fault_memory(fault);
	for (size_t k = 0; k < count; k++) {
		exterior->triangles.at[exterior->triangles.count++] =
			object->triangles.at[polygon->first_triangle + k];
		exterior->polygons.at[exterior->polygons.count++] = i;
	}
	return TCS_OK;
}

static enum tcs_status
level_draw(struct exterior *exterior, const struct tcs_object *object,
	unsigned lod, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	array_clear(&exterior->triangles);
	array_clear(&exterior->polygons);
	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];

		if (geometry->lod != lod || !geometry_has_area(geometry))
			continue;
		for (uint32_t k = 0; k < geometry->polygon_count && !status;
			k++) {
			uint32_t polygon = geometry->first_polygon + k;

			if (exterior->homes.at[polygon] == polygon &&
				!is_space(object,
					object->polygons.at[polygon].surface))
				status = polygon_draw(
					exterior, object, polygon, fault);
		}
	}
	return status;
}

static struct triangle_shape
shape_at(const struct exterior *exterior, size_t i)
{
	const uint32_t *corner = exterior->triangles.at[i].corner;
	const struct tcs_point *points = exterior->points.at;

	return (struct triangle_shape){
		{points[corner[0]], points[corner[1]], points[corner[2]]}};
}

/* As wide as the level in pixels, within bounds. */
static unsigned
picture_size(const struct exterior *exterior, double pixel)
{
	struct box box = BOX_EMPTY;
	double size;

	for (size_t i = 0; i < exterior->triangles.count; i++) {
		struct triangle_shape shape = shape_at(exterior, i);

		for (int k = 0; k < 3; k++)
			box_add_point(&box, shape.corner[k]);
	}
	size = fmin(ceil(box_diagonal(&box) / pixel),
		PER_ROOT * sqrt((double)exterior->triangles.count));
	return size < SMALLEST_PICTURE	 ? SMALLEST_PICTURE
		: size < LARGEST_PICTURE ? (unsigned)size
					 : LARGEST_PICTURE;
}

static enum tcs_status
level_look(struct exterior *exterior, const struct exterior_settings *settings,
	const struct tcs_object *object, unsigned lod, struct tcs_fault *fault)
{
	struct visible_views views = VISIBLE_ALL_ROUND;
	enum tcs_status status = level_draw(exterior, object, lod, fault);
	size_t count = exterior->triangles.count;

	if (status || !count)
		return status;
	array_clear(&exterior->areas);
	if (array_grow(&exterior->areas, count))
		return fault_memory(fault);
	views.jobs = count > LARGE ? settings->jobs : 1;
	views.size = picture_size(exterior, settings->pixel);
	status = visible_find(exterior->points.at, object->vertices.count,
		exterior->triangles.at, count, &views, exterior->areas.at,
		fault);
	for (size_t i = 0; i < count && !status; i++) {
		struct triangle_shape shape = shape_at(exterior, i);
		uint32_t polygon = exterior->polygons.at[i];

		exterior->seen.at[polygon] += exterior->areas.at[i];
		exterior->whole.at[polygon] += triangle_area(&shape);
	}
	return status;
}

/* ---- what stays ---------------------------------------------------------- */

static bool
is_enough(const struct exterior_settings *settings, double seen, double whole)
{
	return seen > 0 && SHOWN_OF_ALL * seen >= settings->least * whole;
}

/* Keep a run of polygons, all of it or none. */
static void
run_decide(struct exterior *exterior, const struct exterior_settings *settings,
	uint32_t first, uint32_t count)
{
	double seen = 0, whole = 0;
	bool keep;

	for (uint32_t i = first; i < first + count; i++) {
		seen += exterior->seen.at[exterior->homes.at[i]];
		whole += exterior->whole.at[exterior->homes.at[i]];
	}
	keep = is_enough(settings, seen, whole);
	for (uint32_t i = first; i < first + count; i++)
		exterior->keep.at[i] = keep;
}

/* The shells of a solid follow each other, and so do their polygons. */
static void
solids_decide(struct exterior *exterior,
	const struct exterior_settings *settings,
	const struct tcs_object *object, const struct tcs_geometry *geometry)
{
	const struct tcs_shell *shells =
		object->shells.at + geometry->first_shell;

	for (uint32_t i = 0, end; i < geometry->shell_count; i = end) {
		uint32_t count = 0;

		for (end = i; end < geometry->shell_count &&
			shells[end].solid == shells[i].solid;
			end++)
			count += shells[end].polygon_count;
		run_decide(exterior, settings, shells[i].first_polygon, count);
	}
}

static void
geometry_decide(struct exterior *exterior,
	const struct exterior_settings *settings,
	const struct tcs_object *object, const struct tcs_geometry *geometry)
{
	uint32_t end = geometry->first_polygon + geometry->polygon_count;

	if (!geometry_has_area(geometry))
		return;
	if (settings->faces)
		for (uint32_t i = geometry->first_polygon; i < end; i++)
			run_decide(exterior, settings, i, 1);
	else if (geometry->shell_count)
		solids_decide(exterior, settings, object, geometry);
	else
		run_decide(exterior, settings, geometry->first_polygon,
			geometry->polygon_count);
}

static enum tcs_status
leave(struct exterior *exterior, struct tcs_object *object,
	struct report *report, struct tcs_fault *fault)
{
	size_t features = object->features.count;
	size_t polygons = object->polygons.count;
	bool all = true;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < polygons; i++)
		all &= exterior->keep.at[i];
	if (!all)
		status = object_keep_polygons(object, exterior->keep.at, fault);
	if (!status)
		status = report_add(report, "polygons unseen",
			polygons - object->polygons.count, fault);
	if (!status)
		status = report_add(report, "features unseen",
			features - object->features.count, fault);
	return status;
}

enum tcs_status
exterior_keep(struct exterior *exterior,
	const struct exterior_settings *settings, struct tcs_object *object,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status = begin(exterior, settings, object, fault);
	bool done[TCS_LOD_NONE + 1] = {false};

	for (size_t i = 0; i < object->geometries.count && !status; i++) {
		unsigned lod = object->geometries.at[i].lod;

		if (!done[lod])
			status = level_look(
				exterior, settings, object, lod, fault);
		done[lod] = true;
	}
	for (size_t i = 0; i < object->geometries.count && !status; i++)
		geometry_decide(
			exterior, settings, object, &object->geometries.at[i]);
	return status ? status : leave(exterior, object, report, fault);
}

void
exterior_release(struct exterior *exterior)
{
	array_release(&exterior->points);
	array_release(&exterior->triangles);
	array_release(&exterior->polygons);
	array_release(&exterior->areas);
	array_release(&exterior->seen);
	array_release(&exterior->whole);
	array_release(&exterior->homes);
	array_release(&exterior->keep);
	byte_index_release(&exterior->ids);
	array_release(&exterior->named);
}
