#include "lod_faces.h"

#include <stdlib.h>

/* Where every node is in stream coordinates. */
static enum tcs_status
place_nodes(struct lod_faces *faces, const struct tcs_object *from,
	const struct lod_source *source, const struct collapses *work,
	struct tcs_fault *fault)
{
	const struct sheets *sheets = work->sheets;

	array_clear(&faces->places);
	array_clear(&faces->moved);
	if (array_grow(&faces->places, sheets->node_count) ||
		array_grow(&faces->moved, sheets->node_count))
		return fault_memory(fault);
	faces->places.count = faces->moved.count = sheets->node_count;
	for (size_t i = sheets->corners.count; i-- > 0;) {
		uint32_t triangle = sheets->face_triangles.at[i / 3];
		uint32_t vertex =
			lod_source_vertices(source, from, triangle)[i % 3];

		faces->places.at[node_of(work, sheets->corners.at[i])] =
			from->vertices.at[vertex];
	}
	for (uint32_t i = 0; i < sheets->node_count; i++) {
		faces->moved.at[i] = collapses_is_moved(work, i);
		if (faces->moved.at[i])
			faces->places.at[i] = frame_from_local(
				&source->frame, work->positions.at[i]);
	}
	return TCS_OK;
}

static enum tcs_status
find_samples(struct lod_faces *faces, size_t features,
	const struct lod_source *source, struct tcs_fault *fault)
{
	array_clear(&faces->samples);
	if (array_grow(&faces->samples, features))
		return fault_memory(fault);
	faces->samples.count = features;
	for (size_t i = 0; i < features; i++)
		faces->samples.at[i] = TCS_NONE;
	for (size_t i = source->set.features.count; i-- > 0;)
		faces->samples.at[source->set.features.at[i]] = (uint32_t)i;
	return TCS_OK;
}

static int
by_polygon(const void *left, const void *right)
{
	const struct lod_face *a = left, *b = right;

	if (a->polygon != b->polygon)
		return a->polygon < b->polygon ? -1 : 1;
	if (a->triangle != b->triangle)
		return a->triangle < b->triangle ? -1 : 1;
	return (a->face > b->face) - (a->face < b->face);
}

static enum tcs_status
index_faces(struct lod_faces *faces, size_t polygons, struct tcs_fault *fault)
{
	size_t face = 0;

	array_clear(&faces->first);
	if (array_grow(&faces->first, polygons + 1))
		return fault_memory(fault);
	faces->first.count = polygons + 1;
	for (size_t i = 0; i <= polygons; i++) {
		while (face < faces->faces.count &&
			faces->faces.at[face].polygon < i)
			face++;
		faces->first.at[i] = (uint32_t)face;
	}
	return TCS_OK;
}

/* In the order of the source, which is by polygon as a rule; there is room.
   Whether it is. */
static bool
list_faces(struct lod_faces *faces, const struct lod_source *source,
	const struct collapses *work)
{
	const uint32_t *polygons = source->polygons.at;
	uint32_t last = 0;
	bool sorted = true;

	for (uint32_t i = 0; i < source->polygons.count; i++) {
		struct lod_face face = {
			.face = work->sheets->triangle_faces.at[i]};

		if (face.face == TCS_NONE ||
			!collapses_face(work, face.face, face.nodes))
			continue;
		face.triangle = collapses_source(work, face.face);
		face.polygon = polygons[face.triangle];
		face.surface = work->features.at[face.face];
		sorted &= face.polygon >= last;
		last = face.polygon;
		faces->faces.at[faces->faces.count++] = face;
	}
	return sorted;
}

enum tcs_status
lod_faces_take(struct lod_faces *faces, const struct tcs_object *from,
	const struct lod_source *source, const struct collapses *work,
	struct tcs_fault *fault)
{
	enum tcs_status status = place_nodes(faces, from, source, work, fault);

	if (!status)
		status = find_samples(
			faces, from->features.count, source, fault);
	array_clear(&faces->faces);
	if (!status && array_grow(&faces->faces, work->face_count))
		status = fault_memory(fault);
	if (status)
		return status;
	if (!list_faces(faces, source, work))
		qsort(faces->faces.at, faces->faces.count,
			sizeof *faces->faces.at, by_polygon);
	return index_faces(faces, from->polygons.count, fault);
}

void
lod_faces_release(struct lod_faces *faces)
{
	array_release(&faces->faces);
	array_release(&faces->first);
	array_release(&faces->samples);
	array_release(&faces->places);
	array_release(&faces->moved);
}
