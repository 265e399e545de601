/*
 * Which paints of an object are written, and in which order: those of a theme
 * together, in it those of a texture or of a material.
 */
#include <stdlib.h>

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
enum { THEME, IMAGE, MATERIAL, FLAGS, SURFACE, PAINT, KEYS };

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
			paint->flags, TCS_NONE, i}};

		if (polygon == TCS_NONE) {
			lose_paint(composer, "its polygon is not written");
			continue;
		}
		if (pieces_is_patch(composer, polygon))
			key.of[SURFACE] = composer->owners.at[polygon];
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

static void
add_paintings(
	struct composer *composer, const struct paint_key *keys, size_t count)
{
	size_t run;

	for (size_t i = 0; i < count; i += run) {
		run = 1;
		if (keys[i].of[SURFACE] == TCS_NONE ||
			keys[i].of[IMAGE] != TCS_NONE) {
			add_painting(composer, &keys[i]);
			continue;
		}
		run = key_run(&keys[i], count - i);
		add_material(composer, &keys[i], run);
	}
}

enum tcs_status
paints_prepare(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	uint16_t property = composer->is_prototype
		? SCHEMA_NONE
		: schema_find_content(
			  composer->nodes.at[0].class, CONTENT_APPEARANCE);
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
	add_paintings(composer, keys, count);
	if (!composer->paints.count || composer->is_prototype)
		return TCS_OK;
	return item_add(composer, 0, property, ITEM_APPEARANCE, 0, fault);
}
