/*
 * Polygons without rings: what a filter has left of a surface are triangles,
 * which are written as the fewest polygons that are flat.
 *
 * Those that stand in one shell, below one feature, and are painted alike are
 * joined. A face that comes of several polygons belongs to the first of them,
 * and goes by its id; the others have none of it.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_compose.h"

/* A polygon, and what it must share with those it is joined to. */
struct derived {
	uint64_t coat;
	uint32_t shell;
	uint32_t home;
	uint32_t polygon;
};

/* ---- paint ------------------------------------------------------------------ */

static uint64_t
mixed(uint64_t hash, uint64_t word)
{
	hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
	return hash ^ hash >> 32;
}

static uint64_t
bits_of(double number)
{
	uint64_t bits;

	memcpy(&bits, &number, sizeof bits);
	return bits;
}

static uint64_t
coat_of(const struct tcs_paint *paint)
{
	uint64_t hash = mixed(paint->theme, paint->flags);

	return mixed(mixed(hash, paint->image), paint->material);
}

/* By polygon, and then by what it is painted with. */
static int
compare_paints(const struct tcs_paint *a, const struct tcs_paint *b)
{
	const uint32_t left[] = {
		a->polygon, a->theme, a->image, a->material, a->flags};
	const uint32_t right[] = {
		b->polygon, b->theme, b->image, b->material, b->flags};

	for (size_t i = 0; i < 5; i++)
		if (left[i] != right[i])
			return left[i] < right[i] ? -1 : 1;
	return 0;
}

static int
compare_lent_paints(const void *left, const void *right)
{
	return compare_paints(*(const struct tcs_paint *const *)left,
		*(const struct tcs_paint *const *)right);
}

/* The textures of polygons without rings, in order. */
static enum tcs_status
sort_textures(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;

	array_clear(&composer->textures);
	if (array_grow(&composer->textures, object->paints.count))
		return fault_memory(fault);
	for (size_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];

		if (paint->image != TCS_NONE &&
			!object->polygons.at[paint->polygon].ring_count)
			composer->textures.at[composer->textures.count++] =
				paint;
	}
	if (composer->textures.count)
		qsort(composer->textures.at, composer->textures.count,
			sizeof(void *), compare_lent_paints);
	return TCS_OK;
}

/* Number vertices so that those of one position with other coordinates in a
 * texture differ. */
static enum tcs_status
number_vertices(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	size_t count = composer->textures.count ? object->vertices.count : 0;

	array_clear(&composer->coats);
	if (array_grow(&composer->coats, count))
		return fault_memory(fault);
	composer->coats.count = count;
	for (size_t i = 0; i < count; i++)
		composer->coats.at[i] = 0;
	for (size_t i = 0; i < composer->textures.count; i++) {
		const struct tcs_paint *paint = composer->textures.at[i];
		const struct tcs_polygon *of =
			&object->polygons.at[paint->polygon];
		const struct tcs_texcoord *at =
			&object->texcoords.at[paint->first_texcoord];

		for (uint32_t j = 0; j < of->vertex_count; j++)
			composer->coats.at[of->first_vertex + j] +=
				mixed(mixed(coat_of(paint), bits_of(at[j].s)),
					bits_of(at[j].t));
	}
	return TCS_OK;
}

/* The polygon that a vertex is of. */
static uint32_t
polygon_of(const struct tcs_object *object, uint32_t vertex)
{
	size_t low = 0, high = object->polygons.count;

	while (high - low > 1) {
		size_t middle = low + (high - low) / 2;

		if (object->polygons.at[middle].first_vertex <= vertex)
			low = middle;
		else
			high = middle;
	}
	return (uint32_t)low;
}

struct tcs_texcoord
merged_texcoord(const struct composer *composer, const struct tcs_paint *paint,
	uint32_t vertex)
{
	const struct tcs_object *object = &composer->object;
	struct tcs_paint like = *paint;
	const struct tcs_paint *key = &like, **found;

	like.polygon = polygon_of(object, vertex);
	found = !composer->textures.count
		? NULL
		: bsearch(&key, composer->textures.at, composer->textures.count,
			  sizeof(void *), compare_lent_paints);
	if (!found)
		return (struct tcs_texcoord){0, 0};
	return object->texcoords.at[(*found)->first_texcoord + vertex -
		object->polygons.at[like.polygon].first_vertex];
}

/* ---- groups ------------------------------------------------------------------- */

/* Triangles to be joined: patches of a triangulated surface are not. */
static bool
is_derived(const struct composer *composer, uint32_t polygon)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];
	uint32_t geometry = composer->owners.at[polygon];

	return !of->ring_count && of->triangle_count &&
		composer->pieces.at[polygon].home != TCS_NONE &&
		(geometry == TCS_NONE ||
			composer->object.geometries.at[geometry].kind !=
				TCS_TIN);
}

static void
add_derived(struct composer *composer, struct derived *all, size_t *count,
	uint32_t polygon, uint32_t shell)
{
	if (is_derived(composer, polygon))
		all[(*count)++] = (struct derived){.shell = shell,
			.home = composer->pieces.at[polygon].home,
			.polygon = polygon};
}

/* In the order of polygons; a shell, or what has none, has a number. */
static size_t
list_derived(struct composer *composer, struct derived *all)
{
	const struct tcs_object *object = &composer->object;
	size_t count = 0;
	uint32_t shell = 0;

	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];
		uint32_t at = geometry->first_polygon;
		uint32_t end = at + geometry->polygon_count;

		for (uint32_t j = 0; j < geometry->shell_count; j++, shell++) {
			uint32_t index = geometry->first_shell + j;
			uint32_t left = object->shells.at[index].polygon_count;

			for (; left > 0; left--)
				add_derived(composer, all, &count, at++, shell);
		}
		while (at < end)
			add_derived(composer, all, &count, at++, shell);
		shell++;
	}
	return count;
}

static int
compare_derived_polygons(const void *left, const void *right)
{
	const struct derived *a = left, *b = right;

	return a->polygon < b->polygon ? -1 : a->polygon > b->polygon;
}

static int
compare_derived(const void *left, const void *right)
{
	const struct derived *a = left, *b = right;

	if (a->shell != b->shell)
		return a->shell < b->shell ? -1 : 1;
	if (a->home != b->home)
		return a->home < b->home ? -1 : 1;
	if (a->coat != b->coat)
		return a->coat < b->coat ? -1 : 1;
	return compare_derived_polygons(left, right);
}

static void
add_coats(const struct composer *composer, struct derived *all, size_t count)
{
	const struct tcs_object *object = &composer->object;

	for (size_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];
		struct derived key = {.polygon = paint->polygon};
		struct derived *of = bsearch(&key, all, count, sizeof *all,
			compare_derived_polygons);

		if (of)
			of->coat += coat_of(paint);
	}
}

/* ---- joining -------------------------------------------------------------------- */

static enum tcs_status
gather(struct composer *composer, const struct derived *group, size_t count,
	struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;

	array_clear(&composer->triangles);
	array_clear(&composer->triangle_polygons);
	for (size_t i = 0; i < count; i++) {
		const struct tcs_polygon *of =
			&object->polygons.at[group[i].polygon];
		size_t at = composer->triangles.count;

		if (array_grow(&composer->triangles, of->triangle_count) ||
			array_grow(&composer->triangle_polygons,
				of->triangle_count))
			return fault_memory(fault);
		memcpy(composer->triangles.at + at,
			object->triangles.at + of->first_triangle,
			of->triangle_count * sizeof *object->triangles.at);
		for (uint32_t j = 0; j < of->triangle_count; j++)
			composer->triangle_polygons.at[at + j] =
				group[i].polygon;
		composer->triangles.count += of->triangle_count;
		composer->triangle_polygons.count += of->triangle_count;
	}
	return TCS_OK;
}

/* Give the faces from `first` on to the polygons of their first triangles. */
static enum tcs_status
give_faces(struct composer *composer, size_t first, struct tcs_fault *fault)
{
	size_t count = composer->merged.faces.count;

	if (array_grow(&composer->faces, count - first))
		return fault_memory(fault);
	for (size_t i = first; i < count; i++) {
		const struct coplanar_face *face =
			&composer->merged.faces.at[i];
		uint32_t polygon =
			composer->triangle_polygons.at[face->first_triangle];
		struct piece *piece = &composer->pieces.at[polygon];

		struct face *out = &composer->faces.at[composer->faces.count];

		*out = (struct face){.first_ring = face->first_ring,
			.ring_count = face->ring_count};
		if (!piece->face_count++)
			piece->first_face = (uint32_t)composer->faces.count;
		else
			out->rings_before =
				out[-1].rings_before + out[-1].ring_count;
		composer->faces.count++;
	}
	return TCS_OK;
}

static enum tcs_status
join(struct composer *composer, const struct derived *group, size_t count,
	struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	size_t first = composer->merged.faces.count;
	enum tcs_status status = gather(composer, group, count, fault);

	if (!status)
		status = coplanar_join(&composer->merged, object->vertices.at,
			composer->coats.count ? composer->coats.at : NULL,
			compose_metres(composer), composer->triangles.at,
			composer->triangles.count, fault);
	return status ? status : give_faces(composer, first, fault);
}

static size_t
count_bare(const struct tcs_object *object)
{
	size_t count = 0;

	for (size_t i = 0; i < object->polygons.count; i++)
		count += !object->polygons.at[i].ring_count;
	return count;
}

enum tcs_status
merge_polygons(struct composer *composer, struct tcs_fault *fault)
{
	size_t count = count_bare(&composer->object), run;
	struct derived *all;
	enum tcs_status status;

	if (!count)
		return TCS_OK;
	all = arena_get(&composer->arena, count * sizeof *all);
	if (!all)
		return fault_memory(fault);
	count = list_derived(composer, all);
	add_coats(composer, all, count);
	if (count)
		qsort(all, count, sizeof *all, compare_derived);
	status = sort_textures(composer, fault);
	if (!status)
		status = number_vertices(composer, fault);
	for (size_t i = 0; i < count && !status; i += run) {
		run = 1;
		while (i + run < count && all[i + run].shell == all[i].shell &&
			all[i + run].home == all[i].home &&
			all[i + run].coat == all[i].coat)
			run++;
		status = join(composer, &all[i], run, fault);
	}
	return status;
}
