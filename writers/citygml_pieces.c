/* Polygons on their way out: which are repeated, and what they are called. */
#include <string.h>

#include "citygml_polygons.h"

/* The slot of a polygon's id: the first polygon that has it, or free. */
static uint32_t *
find_slot(struct composer *composer, const char *id)
{
	size_t room = composer->slots.count;
	size_t at = (size_t)id_hash(&composer->plan->key, id) & (room - 1);

	while (composer->slots.at[at] != TCS_NONE &&
		strcmp(compose_text(composer,
			       composer->object.polygons
				       .at[composer->slots.at[at]]
				       .id),
			id))
		at = (at + 1) & (room - 1);
	return &composer->slots.at[at];
}

static enum tcs_status
clear_slots(struct composer *composer, struct tcs_fault *fault)
{
	size_t room = 16;

	while (room < composer->object.polygons.count * 2)
		room *= 2;
	array_clear(&composer->slots);
	if (array_grow(&composer->slots, room))
		return fault_memory(fault);
	composer->slots.count = room;
	memset(composer->slots.at, 0xff, room * sizeof *composer->slots.at);
	return TCS_OK;
}

/* Whether it is written in full by an earlier object. */
static enum tcs_status
look_elsewhere(struct composer *composer, struct piece *piece, const char *id,
	struct tcs_fault *fault)
{
	const char *legal = id_legal(id, &composer->arena);
	uint64_t hash;

	if (!legal)
		return fault_memory(fault);
	hash = id_hash(&composer->plan->key, legal);
	if (composer->taken && !id_set_has(composer->taken, hash))
		return TCS_OK;
	if (array_grow(&composer->out->needed, 1))
		return fault_memory(fault);
	composer->out->needed.at[composer->out->needed.count++] = hash;
	piece->foreign = true;
	piece->id = legal;
	return TCS_OK;
}

bool
pieces_is_patch(const struct composer *composer, uint32_t polygon)
{
	uint32_t geometry = composer->owners.at[polygon];

	return geometry != TCS_NONE &&
		composer->object.geometries.at[geometry].kind == TCS_TIN;
}

enum tcs_status
pieces_find_repetitions(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	enum tcs_status status = clear_slots(composer, fault);

	for (uint32_t i = 0; i < object->polygons.count && !status; i++) {
		const struct tcs_polygon *polygon = &object->polygons.at[i];
		struct piece *piece = &composer->pieces.at[i];
		uint32_t *slot;

		if (piece->home == TCS_NONE || !polygon->id ||
			!polygon->ring_count || pieces_is_patch(composer, i))
			continue;
		slot = find_slot(composer, compose_text(composer, polygon->id));
		if (*slot == TCS_NONE) {
			*slot = i;
			if (polygon->flags & TCS_POLYGON_SHARED)
				status = look_elsewhere(composer, piece,
					compose_text(composer, polygon->id),
					fault);
		} else if (polygon->flags & TCS_POLYGON_SHARED) {
			piece->first = *slot;
			composer->pieces.at[*slot].is_target = true;
		}
	}
	return status;
}

static void
name_faces(struct composer *composer, const struct piece *piece)
{
	for (uint32_t i = 1; i < piece->face_count; i++)
		composer->faces.at[piece->first_face + i].id =
			piece->id ? compose_id(composer, piece->id) : NULL;
}

bool
pieces_is_triangle(const struct composer *composer, uint32_t polygon)
{
	const struct tcs_polygon *of = &composer->object.polygons.at[polygon];

	return of->ring_count == 1 &&
		composer->object.rings.at[of->first_ring].vertex_count == 3;
}

uint32_t
pieces_patch_count(const struct composer *composer, uint32_t polygon)
{
	return pieces_is_triangle(composer, polygon)
		? 1
		: composer->object.polygons.at[polygon].triangle_count;
}

static enum tcs_status
name_rings(struct composer *composer, const struct tcs_polygon *polygon,
	struct piece *piece, struct tcs_fault *fault)
{
	uint32_t index = (uint32_t)(piece - composer->pieces.at);
	uint32_t count = polygon->ring_count;

	if (!piece->rings_need_ids)
		return TCS_OK;
	if (pieces_is_patch(composer, index))
		count = pieces_patch_count(composer, index);
	for (uint32_t i = 0; i < piece->face_count; i++)
		count += composer->faces.at[piece->first_face + i].ring_count;
	piece->first_ring_id = (uint32_t)composer->ring_ids.count;
	if (array_grow(&composer->ring_ids, count))
		return fault_memory(fault);
	for (uint32_t i = 0; i < count; i++) {
		tcs_text id = i < polygon->ring_count
			? composer->object.rings.at[polygon->first_ring + i].id
			: 0;

		composer->ring_ids.at[composer->ring_ids.count++] =
			compose_id(composer, compose_text(composer, id));
	}
	return TCS_OK;
}

static enum tcs_status
name_piece(struct composer *composer, const struct tcs_geometry *geometry,
	uint32_t index, struct tcs_fault *fault)
{
	const struct tcs_polygon *polygon =
		&composer->object.polygons.at[index];
	struct piece *piece = &composer->pieces.at[index];

	if (piece->home == TCS_NONE || piece->foreign ||
		piece->first != TCS_NONE)
		return TCS_OK;
	if (pieces_is_patch(composer, index))
		return name_rings(composer, polygon, piece, fault);
	if (!shape_face_count(composer, index))
		return TCS_OK;
	if (polygon->id || piece->is_target || compose_is_3(composer))
		piece->id = compose_id_in(composer, geometry, polygon->id);
	name_faces(composer, piece);
	return name_rings(composer, polygon, piece, fault);
}

enum tcs_status
pieces_name(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	enum tcs_status status = merge_polygons(composer, fault);

	for (size_t i = 0; i < object->geometries.count; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];
		struct surface *surface = &composer->surfaces.at[i];

		if (surface->is_target)
			surface->id =
				compose_id_in(composer, geometry, geometry->id);
		for (uint32_t j = 0; j < geometry->polygon_count && !status;
			j++)
			status = name_piece(composer, geometry,
				geometry->first_polygon + j, fault);
	}
	return status;
}

enum tcs_status
pieces_clear(struct composer *composer, struct tcs_fault *fault)
{
	size_t count = composer->object.polygons.count;

	array_clear(&composer->pieces);
	array_clear(&composer->owners);
	array_clear(&composer->faces);
	coplanar_clear(&composer->merged);
	array_clear(&composer->ring_ids);
	array_clear(&composer->surfaces);
	if (array_grow(&composer->pieces, count) ||
		array_grow(&composer->owners, count) ||
		array_grow(
			&composer->surfaces, composer->object.geometries.count))
		return fault_memory(fault);
	composer->surfaces.count = composer->object.geometries.count;
	for (size_t i = 0; i < composer->surfaces.count; i++)
		composer->surfaces.at[i] = (struct surface){0};
	composer->pieces.count = composer->owners.count = count;
	for (size_t i = 0; i < count; i++) {
		composer->pieces.at[i] = (struct piece){.home = TCS_NONE,
			.first = TCS_NONE,
			.first_ring_id = TCS_NONE};
		composer->owners.at[i] = TCS_NONE;
	}
	return TCS_OK;
}

enum tcs_status
place_prototype(struct composer *composer, struct tcs_fault *fault)
{
	const struct tcs_object *object = &composer->object;
	enum tcs_status status = pieces_clear(composer, fault);

	if (!status)
		status = paints_find_parts(composer, fault);
	for (uint32_t i = 0; i < object->geometries.count && !status; i++) {
		const struct tcs_geometry *geometry = &object->geometries.at[i];

		status = paints_break_surface(composer, i, fault);
		for (uint32_t j = 0; j < geometry->polygon_count; j++) {
			uint32_t polygon = geometry->first_polygon + j;

			composer->pieces.at[polygon].home = 0;
			composer->owners.at[polygon] = i;
		}
	}
	if (!status)
		status = pieces_find_repetitions(composer, fault);
	if (!status)
		status = paints_prepare(composer, fault);
	return status ? status : pieces_name(composer, fault);
}
