#include "lod_write.h"

#include <stdlib.h>
#include <string.h>

#include "texture_plane.h"

/* Points an empty-handed copy at the elements of another array. */
#define LEND(to, from) \
	((to)->at = (from)->at, (to)->count = (from)->count, (to)->room = 0)

/* ---- beginning ----------------------------------------------------------- */

void
lod_write_begin(struct lod_writer *writer, const struct tcs_object *from,
	const struct paint_charts *charts)
{
	struct tcs_object *to = &writer->to;

	writer->from = from;
	writer->charts = charts;
	object_clear(to);
	array_release(&to->text);
	LEND(&to->text, &from->text);
	LEND(&to->features, &from->features);
	LEND(&to->attributes, &from->attributes);
	LEND(&to->relations, &from->relations);
	LEND(&to->instances, &from->instances);
}

/* ---- polygons ------------------------------------------------------------ */

static enum tcs_status
put_vertex(struct tcs_object *to, struct tcs_point at, struct tcs_fault *fault)
{
	if (to->vertices.count >= TCS_NONE)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"more than 2^32 vertices in one object");
	if (array_grow(&to->vertices, 1))
		return fault_memory(fault);
	to->vertices.at[to->vertices.count++] = at;
	return TCS_OK;
}

/* A polygon without content yet; its runs begin at the ends of the arrays. */
static enum tcs_status
put_polygon(struct tcs_object *to, const struct tcs_polygon *like,
	struct tcs_polygon **out, struct tcs_fault *fault)
{
	struct tcs_polygon polygon = *like;

	polygon.first_vertex = (uint32_t)to->vertices.count;
	polygon.first_ring = (uint32_t)to->rings.count;
	polygon.first_triangle = (uint32_t)to->triangles.count;
	if (array_grow(&to->polygons, 1))
		return fault_memory(fault);
	*out = &to->polygons.at[to->polygons.count++];
	**out = polygon;
	return TCS_OK;
}

/* A paint of the polygon written last, and room for its coordinates. */
static enum tcs_status
put_paint(struct tcs_object *to, const struct tcs_paint *like, size_t vertices,
	struct tcs_fault *fault)
{
	bool textured = like->first_texcoord != TCS_NONE;
	struct tcs_paint paint = *like;

	paint.polygon = (uint32_t)to->polygons.count - 1;
	if (textured)
		paint.first_texcoord = (uint32_t)to->texcoords.count;
	if (array_grow(&to->paints, 1) ||
		(textured && array_grow(&to->texcoords, vertices)))
		return fault_memory(fault);
	to->paints.at[to->paints.count++] = paint;
	return TCS_OK;
}

static enum tcs_status
copy_paints(struct lod_writer *writer, uint32_t polygon, uint32_t vertices,
	struct tcs_fault *fault)
{
	const struct tcs_object *from = writer->from;
	const struct paint_index *index = &writer->charts->index;
	struct tcs_object *to = &writer->to;

	for (uint32_t i = index->first.at[polygon];
		i < index->first.at[polygon + 1]; i++) {
		const struct tcs_paint *paint =
			&from->paints.at[index->paints.at[i]];
		enum tcs_status status = put_paint(to, paint, vertices, fault);

		if (status)
			return status;
		for (uint32_t k = 0;
			paint->first_texcoord != TCS_NONE && k < vertices; k++)
			to->texcoords.at[to->texcoords.count++] =
				from->texcoords.at[paint->first_texcoord + k];
	}
	return TCS_OK;
}

static enum tcs_status
copy_polygon(
	struct lod_writer *writer, uint32_t polygon, struct tcs_fault *fault)
{
	const struct tcs_object *from = writer->from;
	const struct tcs_polygon *own = &from->polygons.at[polygon];
	struct tcs_object *to = &writer->to;
	struct tcs_polygon *out;
	uint32_t shift;

	if (put_polygon(to, own, &out, fault) ||
		array_grow(&to->vertices, own->vertex_count) ||
		array_grow(&to->rings, own->ring_count) ||
		array_grow(&to->triangles, own->triangle_count))
		return fault_memory(fault);
	/* Modulo 2^32, either way. */
	shift = out->first_vertex - own->first_vertex;
	for (uint32_t i = 0; i < own->vertex_count; i++)
		to->vertices.at[to->vertices.count++] =
			from->vertices.at[own->first_vertex + i];
	for (uint32_t i = 0; i < own->ring_count; i++) {
		struct tcs_ring ring = from->rings.at[own->first_ring + i];

		ring.first_vertex += shift;
		to->rings.at[to->rings.count++] = ring;
	}
	for (uint32_t i = 0; i < own->triangle_count; i++) {
		struct tcs_triangle triangle =
			from->triangles.at[own->first_triangle + i];

		for (int k = 0; k < 3; k++)
			triangle.corner[k] += shift;
		to->triangles.at[to->triangles.count++] = triangle;
	}
	return copy_paints(writer, polygon, own->vertex_count, fault);
}

static size_t
put_number(char *out, uint32_t number)
{
	char digits[10];
	size_t count = 0;

	do
		digits[count++] = (char)('0' + number % 10);
	while (number /= 10);
	for (size_t i = 0; i < count; i++)
		out[i] = digits[count - 1 - i];
	return count;
}

/* "ID_L1", then "ID_L1_2" and so on. */
static enum tcs_status
derive_id(struct lod_writer *writer, tcs_text id, unsigned lod, uint32_t number,
	tcs_text *out, struct tcs_fault *fault)
{
	const char *old = object_text(writer->from, id);
	size_t length = strlen(old);
	char *end;

	*out = 0;
	if (!id)
		return TCS_OK;
	writer->id.count = 0;
	if (array_grow(&writer->id, length + 32))
		return fault_memory(fault);
	memcpy(writer->id.at, old, length);
	end = writer->id.at + length;
	*end++ = '_';
	*end++ = 'L';
	end += put_number(end, lod);
	if (number > 0) {
		*end++ = '_';
		end += put_number(end, number + 1);
	}
	return text_append(&writer->to, writer->id.at,
		(size_t)(end - writer->id.at), out, fault);
}

/* The triangle of the source that a face is painted as. */
static uint32_t
painted_as(const struct lod_writer *writer, const struct lod_source *source,
	const struct lod_face *face)
{
	bool own = source->set.features.at[face->triangle] == face->surface;
	uint32_t sample = writer->faces.samples.at[face->surface];

	return own || sample == TCS_NONE ? face->triangle : sample;
}

/* The coordinate of a corner of the face, for paint `number` of the polygon of
   the triangle that it is painted as. */
static struct tcs_texcoord
coordinate_at(const struct lod_writer *writer, const struct lod_source *source,
	const struct lod_face *face, uint32_t triangle, uint32_t number, int k)
{
	const struct tcs_object *from = writer->from;
	const struct paint_index *index = &writer->charts->index;
	uint32_t polygon = source->polygons.at[triangle];
	const struct tcs_paint *paint =
		&from->paints.at[index->paints.at[index->first.at[polygon] +
			number]];
	const uint32_t *old = lod_source_vertices(source, from, triangle);
	struct tcs_texcoord coordinates[3], guess;
	struct tcs_point corners[3];

	for (int i = 0; i < 3; i++) {
		corners[i] = from->vertices.at[old[i]];
		coordinates[i] = paint_coordinate(from, paint, old[i]);
	}
	guess = texture_plane_at(
		corners, coordinates, writer->faces.places.at[face->nodes[k]]);
	if (triangle != face->triangle ||
		writer->faces.moved.at[face->nodes[k]])
		return guess;
	return paint_charts_at(writer->charts, from, source, triangle,
		face->nodes[k], number, guess);
}

static enum tcs_status
project_paints(struct lod_writer *writer, const struct lod_source *source,
	const struct lod_face *face, struct tcs_fault *fault)
{
	const struct tcs_object *from = writer->from;
	const struct paint_index *index = &writer->charts->index;
	uint32_t triangle = painted_as(writer, source, face);
	uint32_t polygon = source->polygons.at[triangle];
	uint32_t first = index->first.at[polygon];
	uint32_t count = index->first.at[polygon + 1] - first;
	struct tcs_object *to = &writer->to;

	for (uint32_t i = 0; i < count; i++) {
		const struct tcs_paint *paint =
			&from->paints.at[index->paints.at[first + i]];
		enum tcs_status status = put_paint(to, paint, 3, fault);

		if (status)
			return status;
		if (paint->first_texcoord == TCS_NONE)
			continue;
		for (int k = 0; k < 3; k++)
			to->texcoords.at[to->texcoords.count++] = coordinate_at(
				writer, source, face, triangle, i, k);
	}
	return TCS_OK;
}

static enum tcs_status
put_face(struct lod_writer *writer, const struct lod_source *source,
	const struct lod_face *face, const struct tcs_polygon *like,
	struct tcs_fault *fault)
{
	struct tcs_object *to = &writer->to;
	struct tcs_polygon *out;
	enum tcs_status status = put_polygon(to, like, &out, fault);

	if (!status && array_grow(&to->triangles, 1))
		status = fault_memory(fault);
	if (status)
		return status;
	to->triangles.at[to->triangles.count++] =
		(struct tcs_triangle){{out->first_vertex, out->first_vertex + 1,
			out->first_vertex + 2}};
	for (int k = 0; !status && k < 3; k++)
		status = put_vertex(
			to, writer->faces.places.at[face->nodes[k]], fault);
	return status ? status : project_paints(writer, source, face, fault);
}

/* What is left of one polygon; of a repeated one the same again. */
static enum tcs_status
simplify_polygon(struct lod_writer *writer, const struct lod_source *source,
	uint32_t polygon, unsigned lod, struct tcs_fault *fault)
{
	const struct tcs_polygon *own = &writer->from->polygons.at[polygon];
	uint32_t home = source->homes.at[polygon];
	uint32_t first = writer->faces.first.at[home];
	uint32_t end = writer->faces.first.at[home + 1];
	enum tcs_status status = TCS_OK;

	for (uint32_t i = first; !status && i < end; i++) {
		struct tcs_polygon like = {
			.surface = writer->homes[writer->faces.faces.at[i]
							 .surface],
			.vertex_count = 3,
			.triangle_count = 1,
			.flags = own->flags & TCS_POLYGON_SHARED,
		};

		status = derive_id(
			writer, own->id, lod, i - first, &like.id, fault);
		if (!status)
			status = put_face(writer, source,
				&writer->faces.faces.at[i], &like, fault);
	}
	return status;
}

/* ---- geometries ---------------------------------------------------------- */

enum tcs_status
lod_write_copy(
	struct lod_writer *writer, uint32_t geometry, struct tcs_fault *fault)
{
	struct tcs_geometry own = writer->from->geometries.at[geometry];
	struct tcs_object *to = &writer->to;
	enum tcs_status status = TCS_OK;
	uint32_t shift = (uint32_t)to->polygons.count - own.first_polygon;

	if (array_grow(&to->geometries, 1) ||
		array_grow(&to->shells, own.shell_count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < own.shell_count; i++) {
		struct tcs_shell shell =
			writer->from->shells.at[own.first_shell + i];

		shell.first_polygon += shift;
		to->shells.at[to->shells.count++] = shell;
	}
	for (uint32_t i = 0; !status && i < own.polygon_count; i++)
		status = copy_polygon(writer, own.first_polygon + i, fault);
	own.first_polygon += shift;
	own.first_shell = (uint32_t)to->shells.count - own.shell_count;
	to->geometries.at[to->geometries.count++] = own;
	return status;
}

static enum tcs_status
simplify_run(struct lod_writer *writer, const struct lod_source *source,
	uint32_t first, uint32_t count, unsigned lod, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < count; i++)
		status =
			simplify_polygon(writer, source, first + i, lod, fault);
	return status;
}

static enum tcs_status
simplify_shells(struct lod_writer *writer, const struct lod_source *source,
	const struct tcs_geometry *own, unsigned lod, struct tcs_fault *fault)
{
	struct tcs_object *to = &writer->to;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < own->shell_count; i++) {
		struct tcs_shell shell =
			writer->from->shells.at[own->first_shell + i];
		uint32_t first = (uint32_t)to->polygons.count;

		status = simplify_run(writer, source, shell.first_polygon,
			shell.polygon_count, lod, fault);
		shell.id = 0;
		shell.first_polygon = first;
		shell.polygon_count = (uint32_t)to->polygons.count - first;
		if (status || !shell.polygon_count)
			continue;
		if (array_grow(&to->shells, 1))
			return fault_memory(fault);
		to->shells.at[to->shells.count++] = shell;
	}
	return status;
}

/* Close the geometry that began where `out` says, if anything is in it. */
static enum tcs_status
put_geometry(struct tcs_object *to, struct tcs_geometry *out,
	struct tcs_fault *fault)
{
	out->shell_count = (uint32_t)to->shells.count - out->first_shell;
	out->polygon_count = (uint32_t)to->polygons.count - out->first_polygon;
	if (!out->polygon_count)
		return TCS_OK;
	if (array_grow(&to->geometries, 1))
		return fault_memory(fault);
	to->geometries.at[to->geometries.count++] = *out;
	return TCS_OK;
}

static struct tcs_geometry
begin_geometry(const struct tcs_object *to, uint32_t feature, uint8_t kind,
	uint8_t lod)
{
	return (struct tcs_geometry){
		.feature = feature,
		.first_shell = (uint32_t)to->shells.count,
		.first_polygon = (uint32_t)to->polygons.count,
		.lod = lod,
		.kind = kind,
		.flags = TCS_GEOMETRY_SIMPLIFIED,
	};
}

/* ---- levels -------------------------------------------------------------- */

static enum tcs_status
clear_solids(struct lod_writer *writer, struct tcs_fault *fault)
{
	size_t count = writer->from->features.count;

	array_clear(&writer->solids);
	if (array_grow(&writer->solids, count))
		return fault_memory(fault);
	writer->solids.count = count;
	for (size_t i = 0; i < count; i++)
		writer->solids.at[i] = TCS_NONE;
	return TCS_OK;
}

static uint8_t
level_of(const struct tcs_geometry *own, int lod)
{
	return lod == LOD_IN_PLACE ? own->lod : (uint8_t)lod;
}

static enum tcs_status
write_solids(struct lod_writer *writer, const struct lod_source *source,
	int lod, struct tcs_fault *fault)
{
	const struct tcs_object *from = writer->from;
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < from->geometries.count; i++) {
		const struct tcs_geometry *own = &from->geometries.at[i];
		uint32_t home = writer->homes[own->feature];
		struct tcs_geometry out;

		if (!source->selection.geometries.at[i] || !own->shell_count ||
			writer->solids.at[home] != TCS_NONE)
			continue;
		writer->solids.at[home] = i;
		out = begin_geometry(
			&writer->to, home, own->kind, level_of(own, lod));
		if (lod == LOD_IN_PLACE)
			out.role = own->role;
		status = simplify_shells(writer, source, own, out.lod, fault);
		if (!status)
			status = put_geometry(&writer->to, &out, fault);
	}
	return status;
}

/* What is of one geometry and not of an earlier one, too. */
static enum tcs_status
write_rest(struct lod_writer *writer, const struct lod_source *source,
	const struct tcs_geometry *own, uint8_t lod, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (uint32_t i = 0; !status && i < own->polygon_count; i++)
		if (source->homes.at[own->first_polygon + i] ==
			own->first_polygon + i)
			status = simplify_polygon(writer, source,
				own->first_polygon + i, lod, fault);
	return status;
}

/* The geometries of one home that are not its solid. */
static enum tcs_status
write_surfaces(struct lod_writer *writer, const struct lod_source *source,
	const struct home_use *uses, size_t count, int lod,
	struct tcs_fault *fault)
{
	const struct tcs_geometry *own =
		&writer->from->geometries.at[uses->geometry];
	struct tcs_geometry out = begin_geometry(
		&writer->to, uses->home, TCS_MULTI_SURFACE, level_of(own, lod));
	enum tcs_status status = TCS_OK;

	if (count == 1 && !own->shell_count)
		out.kind = own->kind;
	if (count == 1 && lod == LOD_IN_PLACE)
		out.role = own->role;
	for (size_t i = 0; !status && i < count; i++)
		status = write_rest(writer, source,
			&writer->from->geometries.at[uses[i].geometry], out.lod,
			fault);
	return status ? status : put_geometry(&writer->to, &out, fault);
}

static int
by_home(const void *left, const void *right)
{
	const struct home_use *a = left, *b = right;

	if (a->home != b->home)
		return a->home < b->home ? -1 : 1;
	return (a->geometry > b->geometry) - (a->geometry < b->geometry);
}

static enum tcs_status
list_uses(struct lod_writer *writer, const struct lod_source *source,
	struct tcs_fault *fault)
{
	const struct tcs_object *from = writer->from;

	array_clear(&writer->uses);
	if (array_grow(&writer->uses, from->geometries.count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < from->geometries.count; i++) {
		uint32_t home = writer->homes[from->geometries.at[i].feature];

		if (source->selection.geometries.at[i] &&
			writer->solids.at[home] != i)
			writer->uses.at[writer->uses.count++] =
				(struct home_use){home, i};
	}
	if (writer->uses.count > 0)
		qsort(writer->uses.at, writer->uses.count,
			sizeof *writer->uses.at, by_home);
	return TCS_OK;
}

enum tcs_status
lod_write_level(struct lod_writer *writer, const struct lod_source *source,
	const uint32_t *homes, int lod, struct tcs_fault *fault)
{
	enum tcs_status status = clear_solids(writer, fault);
	size_t run;

	writer->homes = homes;
	if (!status)
		status = write_solids(writer, source, lod, fault);
	if (!status)
		status = list_uses(writer, source, fault);
	for (size_t i = 0; !status && i < writer->uses.count; i += run) {
		const struct home_use *uses = &writer->uses.at[i];

		for (run = 1; i + run < writer->uses.count &&
			uses[run].home == uses->home;
			run++)
			;
		status = write_surfaces(writer, source, uses, run, lod, fault);
	}
	return status;
}

void
lod_write_release(struct lod_writer *writer)
{
	object_release(&writer->to);
	lod_faces_release(&writer->faces);
	array_release(&writer->solids);
	array_release(&writer->uses);
	array_release(&writer->id);
}
