#include <math.h>

#include "tcs.h"
#include "tcs_codec.h"

/* "object ID: `what` N …": every broken rule is told this way. */
#define BROKEN(object, fault, format, ...) \
	fault_set((fault), TCS_BAD_INPUT, TCS_NOWHERE, \
		"object %.80s: " format, object_name(object), __VA_ARGS__)

static const char *
object_name(const struct tcs_object *object)
{
	if (!object->features.count || !object->features.at[0].id)
		return "without id";
	return object_text(object, object->features.at[0].id);
}

static enum tcs_status
check_features(const struct tcs_object *object, struct tcs_fault *fault)
{
	const struct tcs_feature *features = object->features.at;

	if (!object->features.count)
		return fault_set(fault, TCS_BAD_INPUT, TCS_NOWHERE,
			"an object has no feature");
	if (object->features.count >= TCS_NONE)
		return BROKEN(object, fault, "%s", "too many features");
	if (features[0].parent != TCS_NONE)
		return BROKEN(object, fault, "%s", "its root has a parent");
	for (size_t i = 1; i < object->features.count; i++)
		if (features[i].parent >= i)
			return BROKEN(object, fault,
				"feature %zu does not stand behind its parent",
				i);
	return TCS_OK;
}

static enum tcs_status
check_attributes(const struct tcs_object *object, struct tcs_fault *fault)
{
	const struct tcs_attribute *attributes = object->attributes.at;
	uint32_t feature = 0;

	for (size_t i = 0; i < object->attributes.count; i++) {
		const struct tcs_attribute *attribute = &attributes[i];
		uint32_t parent = attribute->parent;

		if (attribute->feature >= object->features.count ||
			attribute->feature < feature)
			return BROKEN(object, fault,
				"attribute %zu is not in the order of features",
				i);
		feature = attribute->feature;
		if (attribute->type > TCS_SET)
			return BROKEN(object, fault,
				"attribute %zu has no known type", i);
		if (parent == TCS_NONE)
			continue;
		if (parent >= i || attributes[parent].feature != feature)
			return BROKEN(object, fault,
				"attribute %zu does not stand behind its parent",
				i);
	}
	return TCS_OK;
}

static enum tcs_status
check_relations(const struct tcs_object *object, struct tcs_fault *fault)
{
	for (size_t i = 0; i < object->relations.count; i++)
		if (object->relations.at[i].feature >= object->features.count)
			return BROKEN(object, fault,
				"relation %zu belongs to no feature", i);
	return TCS_OK;
}

static bool
lod_is_known(unsigned lod)
{
	return lod <= 4 || lod == TCS_LOD_NONE;
}

static bool
is_solid(const struct tcs_geometry *geometry)
{
	return geometry->kind <= TCS_COMPOSITE_SOLID;
}

/* A geometry's shells cover its polygons, solid after solid. */
static enum tcs_status
check_shells(
	const struct tcs_object *object, size_t index, struct tcs_fault *fault)
{
	const struct tcs_geometry *geometry = &object->geometries.at[index];
	const struct tcs_shell *shell = object->shells.at;
	uint32_t solid = 0;
	uint64_t polygon = geometry->first_polygon;

	if (geometry->shell_count == 0 &&
		(!is_solid(geometry) || !geometry->polygon_count))
		return TCS_OK;
	if (geometry->shell_count == 0 || !is_solid(geometry))
		return BROKEN(object, fault,
			"geometry %zu: shells are for solids, and solids have "
			"them",
			index);
	shell += geometry->first_shell;
	for (uint32_t i = 0; i < geometry->shell_count; i++, shell++) {
		if (shell->first_polygon != polygon || shell->interior > 1 ||
			shell->solid < solid)
			return BROKEN(object, fault,
				"geometry %zu: shell %u is out of order", index,
				i);
		solid = shell->solid;
		polygon += shell->polygon_count;
	}
	if (polygon !=
		(uint64_t)geometry->first_polygon + geometry->polygon_count)
		return BROKEN(object, fault,
			"geometry %zu: its shells do not cover its polygons",
			index);
	return TCS_OK;
}

static enum tcs_status
check_geometries(const struct tcs_object *object, struct tcs_fault *fault)
{
	uint64_t polygon = 0, shell = 0;

	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];
		enum tcs_status status;

		if (geometry->feature >= object->features.count ||
			!lod_is_known(geometry->lod) ||
			geometry->kind > TCS_MULTI_POINT)
			return BROKEN(object, fault,
				"geometry %zu has a value out of range", i);
		if (geometry->first_polygon != polygon ||
			geometry->first_shell != shell)
			return BROKEN(object, fault,
				"geometry %zu does not follow the one before",
				i);
		polygon += geometry->polygon_count;
		shell += geometry->shell_count;
		if (polygon > object->polygons.count ||
			shell > object->shells.count)
			return BROKEN(object, fault,
				"geometry %zu has more polygons or shells than "
				"there are",
				i);
		status = check_shells(object, i, fault);
		if (status)
			return status;
	}
	if (polygon != object->polygons.count || shell != object->shells.count)
		return BROKEN(object, fault, "%s",
			"there are polygons or shells of no geometry");
	return TCS_OK;
}

/* Where the runs of the next polygon begin. */
struct cursor {
	uint64_t vertex;
	uint64_t ring;
	uint64_t triangle;
};

static bool
rings_are_sound(
	const struct tcs_object *object, const struct tcs_polygon *polygon)
{
	const struct tcs_ring *ring = object->rings.at;
	uint64_t vertex = polygon->first_vertex;
	uint64_t end = vertex + polygon->vertex_count;

	if (!polygon->ring_count)
		return true;
	ring += polygon->first_ring;
	for (uint32_t i = 0; i < polygon->ring_count; i++, ring++) {
		if (ring->first_vertex != vertex || !ring->vertex_count ||
			ring->vertex_count > end - vertex)
			return false;
		vertex += ring->vertex_count;
	}
	return true;
}

static bool
triangles_are_sound(
	const struct tcs_object *object, const struct tcs_polygon *polygon)
{
	const struct tcs_triangle *triangle = object->triangles.at;
	uint32_t first = polygon->first_vertex, count = polygon->vertex_count;
	unsigned bad = 0;

	if (!polygon->triangle_count)
		return true;
	triangle += polygon->first_triangle;
	for (uint32_t i = 0; i < polygon->triangle_count; i++, triangle++)
		bad |= (triangle->corner[0] - first >= count) |
			(triangle->corner[1] - first >= count) |
			(triangle->corner[2] - first >= count);
	return !bad;
}

static enum tcs_status
check_polygon(const struct tcs_object *object, size_t index,
	struct cursor *next, struct tcs_fault *fault)
{
	const struct tcs_polygon *polygon = &object->polygons.at[index];

	if (polygon->surface >= object->features.count)
		return BROKEN(object, fault,
			"polygon %zu belongs to no surface", index);
	if (polygon->first_vertex != next->vertex ||
		polygon->first_ring != next->ring ||
		polygon->first_triangle != next->triangle)
		return BROKEN(object, fault,
			"polygon %zu does not follow the one before", index);
	next->vertex += polygon->vertex_count;
	next->ring += polygon->ring_count;
	next->triangle += polygon->triangle_count;
	if (next->vertex > object->vertices.count ||
		next->ring > object->rings.count ||
		next->triangle > object->triangles.count)
		return BROKEN(object, fault,
			"polygon %zu has more vertices, rings or triangles "
			"than there are",
			index);
	if (!rings_are_sound(object, polygon))
		return BROKEN(object, fault,
			"polygon %zu: its rings do not run over its vertices",
			index);
	if (!triangles_are_sound(object, polygon))
		return BROKEN(object, fault,
			"polygon %zu: a triangle has a foreign corner", index);
	return TCS_OK;
}

static enum tcs_status
check_polygons(const struct tcs_object *object, struct tcs_fault *fault)
{
	struct cursor next = {0, 0, 0};

	for (size_t i = 0; i < object->polygons.count; i++) {
		enum tcs_status status = check_polygon(object, i, &next, fault);

		if (status)
			return status;
	}
	if (next.vertex != object->vertices.count ||
		next.ring != object->rings.count ||
		next.triangle != object->triangles.count)
		return BROKEN(object, fault, "%s",
			"there are vertices, rings or triangles of no polygon");
	return TCS_OK;
}

/* Curves and points have nothing to fill. */
static enum tcs_status
check_kinds(const struct tcs_object *object, struct tcs_fault *fault)
{
	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];
		const struct tcs_polygon *polygon = object->polygons.at;

		if (geometry->kind < TCS_MULTI_CURVE)
			continue;
		for (uint32_t k = 0; k < geometry->polygon_count; k++)
			if (polygon[geometry->first_polygon + k].triangle_count)
				return BROKEN(object, fault,
					"geometry %zu: a curve or a point has "
					"triangles",
					i);
	}
	return TCS_OK;
}

static enum tcs_status
check_paints(const struct tcs_object *object, struct tcs_fault *fault)
{
	uint64_t texcoord = 0;

	for (size_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];
		uint32_t first = paint->image == TCS_NONE ? TCS_NONE
							  : (uint32_t)texcoord;

		if (paint->polygon >= object->polygons.count)
			return BROKEN(object, fault,
				"paint %zu paints no polygon", i);
		if (paint->first_texcoord != first)
			return BROKEN(object, fault,
				"paint %zu: its texture coordinates do not "
				"follow those before",
				i);
		if (paint->image == TCS_NONE)
			continue;
		texcoord += object->polygons.at[paint->polygon].vertex_count;
		if (texcoord > object->texcoords.count)
			return BROKEN(object, fault,
				"paint %zu has more texture coordinates than "
				"there are",
				i);
	}
	if (texcoord != object->texcoords.count)
		return BROKEN(object, fault, "%s",
			"there are texture coordinates of no paint");
	return TCS_OK;
}

/* Whether all are finite: x - x is 0 for those, NaN for the others. */
static bool
numbers_are_finite(const double *at, size_t count)
{
	double sum[4] = {0, 0, 0, 0};
	size_t i = 0;

	for (; i + 4 <= count; i += 4) {
		sum[0] += at[i] - at[i];
		sum[1] += at[i + 1] - at[i + 1];
		sum[2] += at[i + 2] - at[i + 2];
		sum[3] += at[i + 3] - at[i + 3];
	}
	for (; i < count; i++)
		sum[0] += at[i] - at[i];
	return sum[0] + sum[1] + sum[2] + sum[3] == 0;
}

static bool
anchor_is_finite(const struct tcs_point *anchor)
{
	return isfinite(anchor->x) && isfinite(anchor->y) &&
		isfinite(anchor->z);
}

static enum tcs_status
check_instances(const struct tcs_object *object, struct tcs_fault *fault)
{
	for (size_t i = 0; i < object->instances.count; i++) {
		const struct tcs_instance *instance = &object->instances.at[i];

		if (instance->feature >= object->features.count ||
			!lod_is_known(instance->lod))
			return BROKEN(object, fault,
				"instance %zu has a value out of range", i);
		if (!numbers_are_finite(instance->matrix, 16) ||
			!anchor_is_finite(&instance->anchor))
			return BROKEN(object, fault,
				"instance %zu has a number that is not finite",
				i);
	}
	return TCS_OK;
}

static enum tcs_status
check_numbers(const struct tcs_object *object, struct tcs_fault *fault)
{
	const void *vertices = object->vertices.at;
	const void *texcoords = object->texcoords.at;

	if (!numbers_are_finite(vertices, 3 * object->vertices.count))
		return BROKEN(object, fault, "%s", "a position is not finite");
	if (!numbers_are_finite(texcoords, 2 * object->texcoords.count))
		return BROKEN(object, fault, "%s",
			"a texture coordinate is not finite");
	return TCS_OK;
}

enum tcs_status
object_check(const struct tcs_object *object, struct tcs_fault *fault)
{
	static enum tcs_status (*const checks[])(
		const struct tcs_object *, struct tcs_fault *) = {
		check_features,
		check_attributes,
		check_relations,
		check_geometries,
		check_polygons,
		check_kinds,
		check_paints,
		check_instances,
		check_numbers,
	};
	enum tcs_status status =
		layout_check_text(&layout_object, object, TCS_NOWHERE, fault);

	for (size_t i = 0; !status && i < sizeof checks / sizeof *checks; i++)
		status = checks[i](object, fault);
	return status;
}

/* What the object names in the stream's tables has passed already. */
static enum tcs_status
check_references(const struct tcs_object *object,
	const struct tcs_tally *before, struct tcs_fault *fault)
{
	for (size_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];

		if ((paint->material != TCS_NONE &&
			    paint->material >= before->materials) ||
			(paint->image != TCS_NONE &&
				paint->image >= before->images))
			return BROKEN(object, fault,
				"paint %zu names no material or image that "
				"stands before it",
				i);
	}
	for (size_t i = 0; i < object->instances.count; i++)
		if (object->instances.at[i].prototype >= before->prototypes)
			return BROKEN(object, fault,
				"instance %zu names no prototype that stands "
				"before it",
				i);
	return TCS_OK;
}

enum tcs_status
object_decode(struct tcs_object *out, const struct tcs_record *record,
	struct tcs_fault *fault)
{
	enum tcs_status status =
		record_decode(out, &layout_object, record, fault);

	if (!status)
		status = object_check(out, fault);
	if (!status)
		status = check_references(out, &record->before, fault);
	if (status)
		fault->at = record->at;
	return status;
}

enum tcs_status
object_encode(const struct tcs_object *object, enum tcs_record_type type,
	struct tcs_record *record, struct tcs_fault *fault)
{
	record->type = type;
	return record_encode(object, &layout_object, record, fault);
}
