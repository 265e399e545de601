/*
 * What a TexturedSurface shows: a material or a texture that stands in the
 * surface itself, as was the custom before appearances, and deprecated since.
 * It becomes what an appearance without a theme would put there.
 *
 * source: CityGML 1.0 (OGC 08-007r1) 9.6, CityGML 2.0 (OGC 12-019) 9.8.
 */
#include <stdio.h>
#include <string.h>

#include "citygml_numbers.h"
#include "citygml_reader.h"

/* ---- targets ---------------------------------------------------------------- */

/* Ids of a document have no control characters. */
enum tcs_status
members_name(struct gml_reader *reader, uint32_t first, tcs_text *id,
	struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	enum tcs_status status;
	char name[32];

	snprintf(name, sizeof name, "\1%zu", raw->targets.count);
	status = gml_text(reader, name, strlen(name), id, fault);
	if (status)
		return status;
	if (array_grow(&raw->targets, 1))
		return fault_memory(fault);
	raw->targets.at[raw->targets.count++] = (struct raw_target){
		.id = *id,
		.first_member = first,
		.member_end = (uint32_t)raw->members.count,
	};
	return TCS_OK;
}

/* What the surface is made of, or the one thing that it links to. */
static enum tcs_status
paint_add(struct gml_reader *reader, uint32_t first_member,
	struct raw_paint **out, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	const struct raw_member *first = &raw->members.at[first_member];
	bool links = raw->members.count - first_member == 1 &&
		first->polygon == TCS_NONE;
	struct raw_paint paint = {
		.material = TCS_NONE,
		.image = TCS_NONE,
		.first_ring = (uint32_t)raw->texrings.count,
	};
	enum tcs_status status = TCS_OK;

	*out = NULL;
	if (first_member == raw->members.count)
		return gml_skipped(reader, "appearance",
			"no surface stands before it", NULL, fault);
	if (links)
		paint.target = first->href;
	else
		status = members_name(
			reader, first_member, &paint.target, fault);
	if (status)
		return status;
	if (array_grow(&raw->paints, 1))
		return fault_memory(fault);
	*out = &raw->paints.at[raw->paints.count];
	raw->paints.at[raw->paints.count++] = paint;
	return TCS_OK;
}

/* ---- elements ---------------------------------------------------------------- */

/* A material of the object, of this id, that was read before. */
static uint32_t
material_find(const struct raw_object *raw, const char *id, size_t length)
{
	const struct tcs_palette *palette = &raw->palette;

	for (size_t i = 0; i < palette->materials.count; i++) {
		const char *known =
			palette_text(palette, palette->materials.at[i].id);

		if (!strncmp(known, id, length) && !known[length])
			return PALETTE_OWN | (uint32_t)i;
	}
	return TCS_NONE;
}

/* Textures have their coordinates with them, so that nobody can share them. */
static enum tcs_status
appearance_link(struct gml_reader *reader, uint32_t first_member, bool back,
	const struct xml_attribute *href, struct tcs_fault *fault)
{
	size_t skip = href->length && *href->value == '#';
	uint32_t material = material_find(
		reader->raw, href->value + skip, href->length - skip);
	struct raw_paint *paint;
	enum tcs_status status;

	if (material == TCS_NONE)
		return gml_skipped(reader, "appearance",
			"it links to no material that stands before it in the "
			"feature",
			NULL, fault);
	status = paint_add(reader, first_member, &paint, fault);
	if (status || !paint)
		return status;
	paint->material = material;
	paint->back = back;
	return TCS_OK;
}

enum tcs_status
textured_begin(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");
	const struct xml_attribute *orientation =
		attribute_find(attributes, count, "orientation");
	uint32_t first_member = gml_top(reader)->first_member;
	struct frame *frame;
	enum tcs_status status =
		gml_push(reader, name, ROLE_GEOMETRY, &frame, fault);

	if (status)
		return status;
	frame->paints = true;
	frame->back = orientation && orientation->length == 1 &&
		*orientation->value == '-';
	frame->first_member = first_member;
	return href ? appearance_link(
			      reader, first_member, frame->back, href, fault)
		    : TCS_OK;
}

enum tcs_status
textured_child(struct gml_reader *reader, struct name *name,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct frame appearance = *gml_top(reader);
	enum tcs_status status;
	struct raw_paint *paint;

	if (name->kind != NAME_TEXTURE && name->kind != NAME_MATERIAL) {
		status = gml_skipped(reader, "appearance",
			"neither a material nor a texture", name->local, fault);
		return status ? status : gml_skip(reader);
	}
	status = appearance_child(reader, name, attributes, count, fault);
	if (!status)
		status = text_keep(&reader->theme, "", 0, fault);
	reader->back = appearance.back;
	return status
		? status
		: paint_add(reader, appearance.first_member, &paint, fault);
}

/* ---- texture coordinates ------------------------------------------------------- */

/* Behind so many words, or all there are; *count becomes how many it was. */
static const char *
words_pass(const char *at, const char *end, size_t *count)
{
	size_t most = *count;

	for (*count = 0; *count < most; ++*count) {
		while (at < end && is_blank(*at))
			at++;
		if (at == end)
			break;
		while (at < end && !is_blank(*at))
			at++;
	}
	return at;
}

/* Positions of a ring, the first one repeated. */
static size_t
positions_count(const struct raw_object *raw, const struct raw_ring *ring)
{
	const char *at = raw->positions.at + ring->first;
	size_t count = SIZE_MAX;

	if (!ring->has_list && ring->pos_count)
		return ring->pos_count;
	words_pass(at, at + ring->length, &count);
	return count / (ring->dimension ? ring->dimension : 3);
}

/* One list for all rings: what each of them takes. The last takes the rest. */
static enum tcs_status
coordinates_split(struct raw_object *raw, struct raw_paint *paint,
	uint32_t first_ring, struct tcs_fault *fault)
{
	struct raw_texring all = raw->texrings.at[paint->first_ring];
	const char *at = raw->positions.at + all.first;
	const char *end = at + all.length;
	size_t rings = raw->rings.count - first_ring;

	if (array_grow(&raw->texrings, rings))
		return fault_memory(fault);
	raw->texrings.count = paint->first_ring;
	for (size_t i = first_ring; i < raw->rings.count; i++) {
		const char *behind = end;
		size_t count;

		if (i + 1 < raw->rings.count) {
			count = 2 * positions_count(raw, &raw->rings.at[i]);
			behind = words_pass(at, end, &count);
		}
		raw->texrings.at[raw->texrings.count++] = (struct raw_texring){
			.first = (size_t)(at - raw->positions.at),
			.length = (size_t)(behind - at),
		};
		at = behind;
	}
	paint->ring_count = (uint32_t)rings;
	return TCS_OK;
}

enum tcs_status
textured_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint *paint = paint_last(reader);
	uint32_t first = raw->members.at[gml_top(reader)->first_member].polygon;

	if (!paint || paint->mapping != MAPPING_LIST || first == TCS_NONE ||
		paint->ring_count != 1 ||
		raw->texrings.count / MOST_THEMES > raw->rings.count)
		return TCS_OK;
	paint->mapping = MAPPING_ORDER;
	paint->first_polygon = first;
	return coordinates_split(
		raw, paint, raw->polygons.at[first].first_ring, fault);
}
