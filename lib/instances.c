#include "instances.h"

#include <math.h>
#include <string.h>

#include "byte_index.h"
#include "frame.h"

/* An object that grows, and what is known of it. */
struct growth {
	struct tcs_object *object;
	const struct tcs_crs *crs;
	struct byte_index themes;
	TCS_ARRAY(tcs_text) named; /* per theme: where it stands */
};

/* ---- limits -------------------------------------------------------------- */

static uint64_t
size_of(const struct tcs_object *object)
{
	return object->geometries.count * sizeof *object->geometries.at +
		object->shells.count * sizeof *object->shells.at +
		object->polygons.count * sizeof *object->polygons.at +
		object->rings.count * sizeof *object->rings.at +
		object->vertices.count * sizeof *object->vertices.at +
		object->triangles.count * sizeof *object->triangles.at +
		object->paints.count * sizeof *object->paints.at +
		object->texcoords.count * sizeof *object->texcoords.at;
}

static enum tcs_status
check_room(const struct tcs_object *object, const struct prototypes *prototypes,
	uint64_t most, struct tcs_fault *fault)
{
	uint64_t bytes = 0;

	for (size_t i = 0; i < object->instances.count; i++) {
		bytes += size_of(prototypes_get(
			prototypes, object->instances.at[i].prototype));
		if (bytes > most)
			return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
				"object '%s': its %zu placed prototypes take "
				"more than %llu bytes",
				object_text(object, object->features.at[0].id),
				object->instances.count,
				(unsigned long long)most);
	}
	return TCS_OK;
}

/* ---- one copy ------------------------------------------------------------ */

static bool
mirrors(const double *m)
{
	return m[0] * (m[5] * m[10] - m[9] * m[6]) -
		m[4] * (m[1] * m[10] - m[9] * m[2]) +
		m[8] * (m[1] * m[6] - m[5] * m[2]) <
		0;
}

static struct tcs_point
turned(const double *m, struct tcs_point p)
{
	return (struct tcs_point){m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
		m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
		m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
}

static enum tcs_status
place_vertices(struct growth *growth, const struct tcs_object *from,
	const struct tcs_instance *by, struct tcs_fault *fault)
{
	struct tcs_object *to = growth->object;
	struct frame frame;

	if (array_grow(&to->vertices, from->vertices.count))
		return fault_memory(fault);
	frame_init(&frame, growth->crs, &by->anchor);
	for (size_t i = 0; i < from->vertices.count; i++) {
		struct tcs_point p = turned(by->matrix, from->vertices.at[i]);

		if (frame.kind == TCS_CRS_GEOGRAPHIC)
			p = frame_from_local(&frame, p);
		else
			p = (struct tcs_point){p.x + by->anchor.x,
				p.y + by->anchor.y, p.z + by->anchor.z};
		if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z))
			return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
				"object '%s': a placed prototype reaches "
				"beyond all numbers",
				object_text(to, to->features.at[0].id));
		to->vertices.at[to->vertices.count++] = p;
	}
	return TCS_OK;
}

static enum tcs_status
copy_triangles(struct tcs_object *to, const struct tcs_object *from,
	uint32_t first_vertex, bool mirrored, struct tcs_fault *fault)
{
	if (array_grow(&to->triangles, from->triangles.count))
		return fault_memory(fault);
	for (size_t i = 0; i < from->triangles.count; i++) {
		const uint32_t *old = from->triangles.at[i].corner;
		uint32_t *corner =
			to->triangles.at[to->triangles.count++].corner;

		for (int k = 0; k < 3; k++)
			corner[k] = first_vertex + old[mirrored ? 2 - k : k];
	}
	return TCS_OK;
}

static enum tcs_status
copy_polygons(struct tcs_object *to, const struct tcs_object *from,
	const struct tcs_instance *by, uint32_t first_vertex, bool mirrored,
	struct tcs_fault *fault)
{
	uint32_t first_ring = (uint32_t)to->rings.count;
	uint32_t first_triangle = (uint32_t)to->triangles.count;

	if (array_grow(&to->polygons, from->polygons.count) ||
		array_grow(&to->rings, from->rings.count))
		return fault_memory(fault);
	for (size_t i = 0; i < from->polygons.count; i++) {
		struct tcs_polygon polygon = from->polygons.at[i];

		polygon.id = 0;
		polygon.surface = by->feature;
		polygon.first_vertex += first_vertex;
		polygon.first_ring += first_ring;
		polygon.first_triangle += first_triangle;
		polygon.flags &= ~(uint32_t)TCS_POLYGON_SHARED;
		if (mirrored && polygon.triangle_count)
			polygon.flags ^= TCS_POLYGON_REVERSED;
		to->polygons.at[to->polygons.count++] = polygon;
	}
	for (size_t i = 0; i < from->rings.count; i++) {
		struct tcs_ring ring = from->rings.at[i];

		ring.id = 0;
		ring.first_vertex += first_vertex;
		to->rings.at[to->rings.count++] = ring;
	}
	return copy_triangles(to, from, first_vertex, mirrored, fault);
}

static enum tcs_status
copy_geometries(struct tcs_object *to, const struct tcs_object *from,
	const struct tcs_instance *by, uint32_t first_polygon,
	struct tcs_fault *fault)
{
	uint32_t first_shell = (uint32_t)to->shells.count;

	if (array_grow(&to->geometries, from->geometries.count) ||
		array_grow(&to->shells, from->shells.count))
		return fault_memory(fault);
	for (size_t i = 0; i < from->geometries.count; i++) {
		struct tcs_geometry geometry = from->geometries.at[i];

		geometry.feature = by->feature;
		geometry.id = i == 0 ? by->id : 0;
		geometry.role = 0;
		geometry.lod = (uint8_t)by->lod;
		geometry.first_shell += first_shell;
		geometry.first_polygon += first_polygon;
		to->geometries.at[to->geometries.count++] = geometry;
	}
	for (size_t i = 0; i < from->shells.count; i++) {
		struct tcs_shell shell = from->shells.at[i];

		shell.id = 0;
		shell.first_polygon += first_polygon;
		to->shells.at[to->shells.count++] = shell;
	}
	return TCS_OK;
}

/* The theme of a prototype as text of the object, each once. */
static enum tcs_status
take_theme(struct growth *growth, const char *theme, tcs_text *out,
	struct tcs_fault *fault)
{
	size_t length = strlen(theme);
	enum tcs_status status;
	uint32_t number;
	bool added;

	*out = 0;
	if (!length)
		return TCS_OK;
	status = byte_index_add(
		&growth->themes, theme, length, &number, &added, fault);
	if (status)
		return status;
	if (added) {
		if (array_grow(&growth->named, 1))
			return fault_memory(fault);
		status = text_append(growth->object, theme, length,
			&growth->named.at[growth->named.count++], fault);
	}
	*out = growth->named.at[number];
	return status;
}

static enum tcs_status
copy_paints(struct growth *growth, const struct tcs_object *from,
	uint32_t first_polygon, struct tcs_fault *fault)
{
	struct tcs_object *to = growth->object;
	uint32_t first_texcoord = (uint32_t)to->texcoords.count;
	enum tcs_status status = TCS_OK;

	if (array_grow(&to->paints, from->paints.count) ||
		array_grow(&to->texcoords, from->texcoords.count))
		return fault_memory(fault);
	for (size_t i = 0; !status && i < from->paints.count; i++) {
		struct tcs_paint paint = from->paints.at[i];

		status = take_theme(growth, object_text(from, paint.theme),
			&paint.theme, fault);
		paint.polygon += first_polygon;
		if (paint.first_texcoord != TCS_NONE)
			paint.first_texcoord += first_texcoord;
		to->paints.at[to->paints.count++] = paint;
	}
	for (size_t i = 0; i < from->texcoords.count; i++)
		to->texcoords.at[to->texcoords.count++] = from->texcoords.at[i];
	return status;
}

static enum tcs_status
check_counts(const struct tcs_object *to, const struct tcs_object *from,
	struct tcs_fault *fault)
{
	if (to->vertices.count + from->vertices.count < TCS_NONE &&
		to->triangles.count + from->triangles.count < TCS_NONE &&
		to->polygons.count + from->polygons.count < TCS_NONE &&
		to->rings.count + from->rings.count < TCS_NONE &&
		to->texcoords.count + from->texcoords.count < TCS_NONE)
		return TCS_OK;
	return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
		"object '%s': its placed prototypes take more than 2^32 of "
		"something",
		object_text(to, to->features.at[0].id));
}

static enum tcs_status
append(struct growth *growth, const struct tcs_object *from,
	const struct tcs_instance *by, struct tcs_fault *fault)
{
	struct tcs_object *to = growth->object;
	uint32_t first_polygon = (uint32_t)to->polygons.count;
	uint32_t first_vertex = (uint32_t)to->vertices.count;
	enum tcs_status status = check_counts(to, from, fault);

	if (!status)
		status = place_vertices(growth, from, by, fault);
	if (!status)
		status = copy_polygons(
			to, from, by, first_vertex, mirrors(by->matrix), fault);
	if (!status)
		status = copy_geometries(to, from, by, first_polygon, fault);
	if (!status)
		status = copy_paints(growth, from, first_polygon, fault);
	return status;
}

/* ---- all of them --------------------------------------------------------- */

enum tcs_status
instances_expand(struct tcs_object *object, const struct prototypes *prototypes,
	const struct tcs_crs *crs, uint64_t most, struct tcs_fault *fault)
{
	struct growth growth = {.object = object, .crs = crs};
	enum tcs_status status = check_room(object, prototypes, most, fault);

	for (size_t i = 0; !status && i < object->instances.count; i++) {
		const struct tcs_instance *by = &object->instances.at[i];

		status = append(&growth,
			prototypes_get(prototypes, by->prototype), by, fault);
	}
	array_release(&object->instances);
	byte_index_release(&growth.themes);
	array_release(&growth.named);
	return status;
}
