/*
 * Which paints of an object are written, and in which order: those of a theme
 * together, in it those of a texture or of a material.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_compose.h"

uint32_t
paint_polygon(const struct composer *composer, const struct tcs_paint *paint)
{
	const struct piece *piece = &composer->pieces.at[paint->polygon];

	if (piece->first != TCS_NONE)
		return piece->first;
	return piece->home == TCS_NONE && !piece->foreign ? TCS_NONE
							  : paint->polygon;
}

/* What is compared, from the first. */
enum { THEME, IMAGE, MATERIAL, FLAGS, SURFACE, TARGET, PAINT, KEYS };

struct paint_key {
	uint32_t of[KEYS];
};

static int
compare_keys(const void *left, const void *right)
{
	const uint32_t *a = ((const struct paint_key *)left)->of;
	const uint32_t *b = ((const struct paint_key *)right)->of;

	for (size_t i = 0; i < KEYS; i++)
		if (a[i] != b[i])
			return a[i] < b[i] ? -1 : 1;
	return 0;
}

static void
lose_paint(struct composer *composer, const char *reason)
{
	compose_lose(composer, "paint", reason,
		composer->nodes.count ? composer->nodes.at[0].id : NULL);
}

static void
add_keys(struct composer *composer, struct paint_key *keys, size_t *count)
{
	const struct tcs_object *object = &composer->object;

	for (uint32_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];
		uint32_t polygon = paint_polygon(composer, paint);
		struct paint_key key = {{paint->theme, TCS_NONE, TCS_NONE,
			paint->flags, TCS_NONE, polygon, i}};

		if (polygon == TCS_NONE) {
			lose_paint(composer, "its polygon is not written");
			continue;
		}
		if (pieces_is_patch(composer, polygon)) {
			key.of[SURFACE] = composer->owners.at[polygon];
			key.of[TARGET] = TCS_NONE;
		}
		if (paint->image != TCS_NONE) {
			key.of[IMAGE] = paint->image;
			keys[(*count)++] = key;
		}
		if (paint->material == TCS_NONE)
			continue;
		key.of[IMAGE] = TCS_NONE;
		key.of[MATERIAL] = paint->material;
		keys[(*count)++] = key;
	}
}

static void
add_painting(struct composer *composer, const struct paint_key *key)
{
	bool textured = key->of[IMAGE] != TCS_NONE;
	uint32_t polygon = paint_polygon(
		composer, &composer->object.paints.at[key->of[PAINT]]);
	struct piece *piece = &composer->pieces.at[polygon];

	if (key->of[SURFACE] == TCS_NONE)
		piece->is_target = true;
	else
		composer->surfaces.at[key->of[SURFACE]].is_target = true;
	if (textured)
		piece->rings_need_ids = true;
	composer->paints.at[composer->paints.count++] =
		(struct painting){.index = key->of[PAINT],
			.surface = key->of[SURFACE],
			.textured = textured};
}

/* How many keys from the first differ in their paint only. */
static size_t
key_run(const struct paint_key *keys, size_t count)
{
	size_t run = 1, same = 0;

	for (; run < count; run++) {
		for (same = 0; same < PAINT; same++)
			if (keys[run].of[same] != keys[0].of[same])
				break;
		if (same < PAINT)
			break;
	}
	return run;
}

/* ---- triangulated surfaces ----------------------------------------------------- */

/* Of every polygon of a triangulated surface the geometry, of others TCS_NONE;
 * NULL without memory. */
static uint32_t *
find_surfaces(struct composer *composer)
{
	const struct tcs_object *object = &composer->object;
	size_t size = object->polygons.count * sizeof(uint32_t);
	uint32_t *surfaces = arena_get(&composer->arena, size);

	if (!surfaces)
		return NULL;
	memset(surfaces, 0xff, size);
	for (uint32_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];

		for (uint32_t k = 0; k < geometry->polygon_count &&
			geometry->kind == TCS_TIN;
			k++)
			surfaces[geometry->first_polygon + k] = i;
	}
	return surfaces;
}

/* Sorted keys whose first entry, in place of a theme, is the surface. */
static void
find_parts(
	struct composer *composer, const struct paint_key *keys, size_t count)
{
	size_t run;

	for (size_t i = 0; i < count; i += run) {
		uint32_t surface = keys[i].of[THEME];
		const struct tcs_geometry *geometry =
			&composer->object.geometries.at[surface];
		uint32_t polygons = 1;

		for (run = 1; i + run < count &&
			!memcmp(&keys[i], &keys[i + run],
				TARGET * sizeof *keys->of);
			run++)
			polygons += keys[i + run].of[TARGET] !=
				keys[i + run - 1].of[TARGET];
		if (polygons < geometry->polygon_count)
			composer->surfaces.at[surface].in_parts = true;
	}
}

enum tcs_status
paints_find_parts(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	uint32_t *surfaces;
	struct paint_key *keys;
	size_t count = 0;

	if (!object->paints.count)
		return TCS_OK;
	surfaces = find_surfaces(composer);
	keys = arena_get(&composer->arena, object->paints.count * sizeof *keys);
	if (!keys || !surfaces)
		return fault_memory(fault);
	for (uint32_t i = 0; i < object->paints.count; i++) {
		const struct tcs_paint *paint = &object->paints.at[i];

		if (paint->material != TCS_NONE &&
			surfaces[paint->polygon] != TCS_NONE)
			keys[count++] =
				(struct paint_key){{surfaces[paint->polygon],
					paint->theme, paint->material,
					paint->flags, 0, paint->polygon, i}};
	}
	if (count)
		qsort(keys, count, sizeof *keys, compare_keys);
	find_parts(composer, keys, count);
	return TCS_OK;
}

enum tcs_status
paints_break_surface(
	struct composer *composer, uint32_t index, struct tcs_fault *fault)
{
	struct tcs_geometry *geometry = &composer->object.geometries.at[index];

	if (geometry->kind != TCS_TIN || !composer->surfaces.at[index].in_parts)
		return TCS_OK;
	geometry->kind = TCS_MULTI_SURFACE;
	return compose_note(composer, REPORT_NOTE, "triangulated surface",
		"written as polygons, some of which a material paints",
		compose_text(composer, geometry->id), fault);
}

/* ---- paintings ----------------------------------------------------------------- */

/* A material paints a triangulated surface as a whole or not at all. */
static void
add_material(
	struct composer *composer, const struct paint_key *keys, size_t count)
{
	const struct tcs_geometry *surface =
		&composer->object.geometries.at[keys->of[SURFACE]];

	if (count >= surface->polygon_count) {
		add_painting(composer, keys);
		return;
	}
	for (size_t i = 0; i < count; i++)
		lose_paint(composer,
			"triangles of a triangulated surface have no ids");
}

/* How often each polygon stands in the object; NULL without memory. */
static uint32_t *
count_uses(struct composer *composer)
{
	size_t count = composer->pieces.count;
	uint32_t *uses = arena_get(&composer->arena, count * sizeof *uses);

	if (!uses)
		return NULL;
	memset(uses, 0, count * sizeof *uses);
	for (size_t i = 0; i < count; i++) {
		uint32_t first = composer->pieces.at[i].first;

		uses[first == TCS_NONE ? i : first]++;
	}
	return uses;
}

/* What paints a polygon paints all uses of it, and is said once. */
static enum tcs_status
add_target(struct composer *composer, const struct paint_key *keys,
	size_t count, const uint32_t *uses, struct tcs_fault *fault)
{
	const struct tcs_polygon *polygon =
		&composer->object.polygons.at[keys->of[TARGET]];

	add_painting(composer, keys);
	if (count >= uses[keys->of[TARGET]])
		return TCS_OK;
	return compose_note(composer, REPORT_NOTE, "paint",
		"it is on all uses of its polygon now, not on some",
		compose_text(composer, polygon->id), fault);
}

static enum tcs_status
add_paintings(struct composer *composer, const struct paint_key *keys,
	size_t count, struct tcs_fault *fault)
{
	const uint32_t *uses = count_uses(composer);
	enum tcs_status status = uses ? TCS_OK : fault_memory(fault);
	size_t run;

	for (size_t i = 0; i < count && !status; i += run) {
		run = key_run(&keys[i], count - i);
		if (keys[i].of[SURFACE] == TCS_NONE)
			status = add_target(
				composer, &keys[i], run, uses, fault);
		else if (keys[i].of[IMAGE] == TCS_NONE)
			add_material(composer, &keys[i], run);
		else
			for (size_t k = 0; k < run; k++)
				add_painting(composer, &keys[i + k]);
	}
	return status;
}

enum tcs_status
paints_prepare(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	uint16_t property = composer->is_prototype
		? SCHEMA_NONE
		: schema_find_content(
			  composer->nodes.at[0].class, CONTENT_APPEARANCE);
	enum tcs_status status;
	struct paint_key *keys;
	size_t count = 0;

	array_clear(&composer->paints);
	if (!object->paints.count ||
		(property == SCHEMA_NONE && !composer->is_prototype))
		return TCS_OK;
	keys = arena_get(
		&composer->arena, object->paints.count * 2 * sizeof *keys);
	if (!keys || array_grow(&composer->paints, object->paints.count * 2))
		return fault_memory(fault);
	add_keys(composer, keys, &count);
	if (count)
		qsort(keys, count, sizeof *keys, compare_keys);
	status = add_paintings(composer, keys, count, fault);
	if (status || !composer->paints.count || composer->is_prototype)
		return status;
	return item_add(composer, 0, property, ITEM_APPEARANCE, 0, fault);
}
