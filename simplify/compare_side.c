#include "compare_side.h"

#include <stdlib.h>
#include <string.h>

#include "shells.h"
#include "vector.h"

static void
side_clear(struct compare_side *side)
{
	component_set_clear(&side->set);
	array_clear(&side->contacts);
	array_clear(&side->surfaces.boxes.nodes);
	array_clear(&side->surfaces.boxes.items);
	array_clear(&side->surfaces.shapes);
	array_clear(&side->roots);
	array_clear(&side->twins);
	array_clear(&side->named);
	byte_index_clear(&side->ids);
	byte_index_clear(&side->drawn);
	side->whole = NO_TREE;
}

/* ---- triangles ----------------------------------------------------------- */

static enum tcs_status
take_polygon(struct compare_side *side, const struct tcs_object *object,
	const struct tcs_polygon *polygon, uint32_t shell,
	const struct frame *frame, struct tcs_fault *fault)
{
	const struct tcs_triangle *triangle =
		object->triangles.at + polygon->first_triangle;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < polygon->triangle_count; i++) {
		struct tcs_point corners[3];

		for (int k = 0; k < 3; k++)
			corners[k] = frame_to_local(frame,
				object->vertices.at[triangle[i].corner[k]]);
		status = component_set_add(
			&side->set, corners, polygon->surface, shell, fault);
	}
	return status;
}

/* A polygon that an earlier geometry has, too, is taken once. */
static bool
is_taken(const struct compare_side *side, const struct tcs_object *object,
	const struct tcs_polygon *polygon)
{
	const char *id = object_text(object, polygon->id);

	return polygon->flags & TCS_POLYGON_SHARED && polygon->id &&
		byte_index_find(&side->drawn, id, strlen(id)) != INDEX_NONE;
}

static enum tcs_status
take_geometry(struct compare_side *side, const struct tcs_object *object,
	const struct tcs_geometry *geometry, const struct frame *frame,
	struct tcs_fault *fault)
{
	const struct tcs_polygon *polygon =
		object->polygons.at + geometry->first_polygon;
	enum tcs_status status = TCS_OK;
	uint32_t count = geometry->polygon_count, shell = TCS_NONE, number;
	bool added;

	for (uint32_t i = 0; !status && i < count; i++) {
		shell = shell_after(
			object, geometry, shell, geometry->first_polygon + i);
		if (!is_taken(side, object, polygon + i))
			status = take_polygon(
				side, object, polygon + i, shell, frame, fault);
	}
	for (uint32_t i = 0; !status && i < count; i++) {
		const char *id = object_text(object, polygon[i].id);

		if (polygon[i].id)
			status = byte_index_add(&side->drawn, id, strlen(id),
				&number, &added, fault);
	}
	return status;
}

/* ---- prototypes ---------------------------------------------------------- */

/* ISO 19136: point = anchor + matrix · (x, y, z, 1), the matrix by rows; over
   degrees the matrix is in metres. */
static struct tcs_point
place_point(const struct frame *frame, const struct tcs_instance *by,
	struct tcs_point p)
{
	const double *m = by->matrix;
	const struct tcs_point moved = {
		m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
		m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
		m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};

	if (frame->kind == TCS_CRS_GEOGRAPHIC)
		return vector_sum(frame_to_local(frame, by->anchor), moved);
	return frame_to_local(frame, vector_sum(by->anchor, moved));
}

/* A mirroring matrix turns every triangle inside out. */
static bool
mirrors(const struct tcs_instance *by)
{
	const double *m = by->matrix;
	const struct tcs_point x = {m[0], m[4], m[8]}, y = {m[1], m[5], m[9]};
	const struct tcs_point z = {m[2], m[6], m[10]};

	return vector_dot(vector_cross(x, y), z) < 0;
}

static enum tcs_status
take_instance(struct compare_side *side, const struct tcs_object *prototype,
	const struct tcs_instance *by, const struct frame *frame,
	struct tcs_fault *fault)
{
	bool turned = mirrors(by);
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < prototype->triangles.count; i++) {
		const uint32_t *from = prototype->triangles.at[i].corner;
		struct tcs_point corners[3];

		for (int k = 0; k < 3; k++)
			corners[turned ? 2 - k : k] = place_point(
				frame, by, prototype->vertices.at[from[k]]);
		status = component_set_add(
			&side->set, corners, by->feature, TCS_NONE, fault);
	}
	return status;
}

static enum tcs_status
take_instances(struct compare_side *side, const struct tcs_object *object,
	const struct tcs_object *const *placed, const struct frame *frame,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < object->instances.count; i++)
		if (side->selection.instances.at[i])
			status = take_instance(side, placed[i],
				&object->instances.at[i], frame, fault);
	return status;
}

/* ---- trees by feature ---------------------------------------------------- */

/* The triangles, feature by feature: count, then place. */
static void
sort_by_feature(const struct compare_side *side, uint32_t *items,
	uint32_t *starts, size_t features)
{
	const struct component_set *set = &side->set;

	for (size_t i = 0; i < set->triangles.count; i++)
		starts[set->features.at[i] + 1]++;
	for (size_t i = 0; i < features; i++)
		starts[i + 1] += starts[i];
	for (size_t i = 0; i < set->triangles.count; i++)
		items[starts[set->features.at[i]]++] = (uint32_t)i;
}

static enum tcs_status
grow_surfaces(struct compare_side *side, uint32_t *items, uint32_t *starts,
	struct tcs_fault *fault)
{
	const struct component_set *set = &side->set;
	size_t features = side->roots.count;
	enum tcs_status status;
	uint32_t first = 0;

	sort_by_feature(side, items, starts, features);
	status = triangle_tree_add(&side->surfaces, set->points.at,
		set->triangles.at, items, set->triangles.count, &side->whole,
		fault);
	/* Every start has moved to the end of its run. */
	for (size_t i = 0; !status && i < features; i++) {
		side->roots.at[i] = NO_TREE;
		if (starts[i] > first)
			status = triangle_tree_add(&side->surfaces,
				set->points.at, set->triangles.at,
				items + first, starts[i] - first,
				&side->roots.at[i], fault);
		first = starts[i];
	}
	return status;
}

static enum tcs_status
build_surfaces(struct compare_side *side, struct tcs_fault *fault)
{
	uint32_t *items = calloc(side->set.triangles.count + 1, sizeof *items);
	uint32_t *starts = calloc(side->roots.count + 1, sizeof *starts);
	enum tcs_status status;

	if (!items || !starts)
		status = fault_memory(fault);
	else
		status = grow_surfaces(side, items, starts, fault);
	free(items);
	free(starts);
	return status;
}

enum tcs_status
side_load(struct compare_side *side, const struct tcs_object *object,
	const struct tcs_object *const *placed, int lod,
	const struct frame *frame, struct tcs_fault *fault)
{
	size_t features = object ? object->features.count : 0;
	enum tcs_status status = TCS_OK;

	side_clear(side);
	if (array_grow(&side->roots, features) ||
		array_grow(&side->twins, features))
		return fault_memory(fault);
	side->roots.count = side->twins.count = features;
	for (size_t i = 0; i < features; i++)
		side->roots.at[i] = side->twins.at[i] = TCS_NONE;
	if (object)
		status = selection_make(&side->selection, object, lod, fault);
	if (object && !status)
		status = component_set_begin(&side->set, object, fault);
	for (size_t i = 0; object && !status && i < object->geometries.count;
		i++)
		if (side->selection.geometries.at[i])
			status = take_geometry(side, object,
				&object->geometries.at[i], frame, fault);
	if (object && placed && !status)
		status = take_instances(side, object, placed, frame, fault);
	if (!status)
		status = component_set_build(&side->set, fault);
	if (!status && side->set.triangles.count > 0)
		status = build_surfaces(side, fault);
	return status;
}

/* ---- features ------------------------------------------------------------ */

static enum tcs_status
index_features(struct compare_side *side, const struct tcs_object *object,
	struct tcs_fault *fault)
{
	for (size_t i = 0; i < side->twins.count; i++) {
		const char *id = object_text(object, object->features.at[i].id);
		uint32_t number;
		bool added;

		if (!*id)
			continue;
		if (byte_index_add(&side->ids, id, strlen(id), &number, &added,
			    fault) ||
			array_grow(&side->named, 1))
			return fault_memory(fault);
		if (added)
			side->named.at[side->named.count++] = (uint32_t)i;
	}
	return TCS_OK;
}

static uint32_t
find_twin(const struct tcs_object *object, size_t feature,
	const struct compare_side *others, const struct tcs_object *other)
{
	const struct tcs_feature *own = &object->features.at[feature];
	const char *id = object_text(object, own->id);
	uint32_t number;

	if (*id) {
		number = byte_index_find(&others->ids, id, strlen(id));
		return number == INDEX_NONE ? TCS_NONE
					    : others->named.at[number];
	}
	if (feature >= other->features.count ||
		other->features.at[feature].id ||
		other->features.at[feature].class != own->class)
		return TCS_NONE;
	return (uint32_t)feature;
}

enum tcs_status
side_match_features(struct compare_side *before,
	const struct tcs_object *object, struct compare_side *after,
	const struct tcs_object *other, struct tcs_fault *fault)
{
	if (!object || !other)
		return TCS_OK;
	if (index_features(before, object, fault) ||
		index_features(after, other, fault))
		return TCS_NO_MEMORY;
	for (size_t i = 0; i < before->twins.count; i++)
		before->twins.at[i] = find_twin(object, i, after, other);
	for (size_t i = 0; i < after->twins.count; i++)
		after->twins.at[i] = find_twin(other, i, before, object);
	return TCS_OK;
}

void
side_release(struct compare_side *side)
{
	component_set_release(&side->set);
	array_release(&side->contacts);
	triangle_tree_release(&side->surfaces);
	array_release(&side->roots);
	array_release(&side->twins);
	array_release(&side->named);
	byte_index_release(&side->ids);
	byte_index_release(&side->drawn);
	selection_release(&side->selection);
}
