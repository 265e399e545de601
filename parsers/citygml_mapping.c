/*
 * How a texture lies on its targets: coordinates ring by ring, a matrix, or a
 * link to what is said of another target.
 *
 * Up to 2.0 the coordinates name their ring in an attribute; in 3.0 the names
 * follow the coordinates as elements, in the same order.
 *
 * source: CityGML 2.0 (OGC 12-019) 9.4, CityGML 3.0 (OGC 20-010) 7.9.
 */
#include <string.h>

#include "citygml_numbers.h"
#include "citygml_reader.h"

struct raw_paint *
paint_last(struct gml_reader *reader)
{
	struct raw_object *raw = reader->raw;

	return raw->paints.count > reader->first_paint
		? &raw->paints.at[raw->paints.count - 1]
		: NULL;
}

enum tcs_status
mapping_link(struct gml_reader *reader, const struct xml_attribute *href,
	struct tcs_fault *fault)
{
	struct raw_paint *paint = paint_last(reader);
	size_t skip = href->length && *href->value == '#';

	if (!paint)
		return TCS_OK;
	return gml_text(reader, href->value + skip, href->length - skip,
		&paint->link, fault);
}

/* 3.0 has a property of this name for the target, and one below it. */
static enum tcs_status
association_link(struct gml_reader *reader, const struct frame *frame,
	const struct xml_attribute *href, struct tcs_fault *fault)
{
	if (frame[-1].name->kind != NAME_TEXTURE)
		return mapping_link(reader, href, fault);
	return gml_skipped(reader, "texture",
		"its target is a link, not followed", NULL, fault);
}

/* TexCoordList or TexCoordGen: others may link to it. */
static enum tcs_status
mapping_begin(struct gml_reader *reader, const struct xml_attribute *attributes,
	size_t count, struct tcs_fault *fault)
{
	const struct xml_attribute *id = attribute_find_id(attributes, count);
	struct raw_paint *paint = paint_last(reader);

	reader->next_texring = (uint32_t)reader->raw->texrings.count;
	if (!paint || !id)
		return TCS_OK;
	return gml_text(
		reader, id->value, id->length, &paint->mapping_id, fault);
}

static enum tcs_status
texring_set_name(struct gml_reader *reader, struct raw_texring *ring,
	const char *at, size_t length, struct tcs_fault *fault)
{
	size_t skip = length && *at == '#';

	return gml_text(reader, at + skip, length - skip, &ring->ring, fault);
}

static enum tcs_status
texring_begin(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *id =
		attribute_find(attributes, count, "ring");
	struct raw_object *raw = reader->raw;
	struct raw_texring *ring;

	if (!paint_last(reader))
		return TCS_OK;
	frame->wants_text = true;
	if (array_grow(&raw->texrings, 1))
		return fault_memory(fault);
	ring = &raw->texrings.at[raw->texrings.count++];
	*ring = (struct raw_texring){0};
	return id ? texring_set_name(reader, ring, id->value, id->length, fault)
		  : TCS_OK;
}

static enum tcs_status
texring_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint *paint = paint_last(reader);
	struct raw_texring *ring;
	size_t length = reader->text.count;

	if (!paint || !raw->texrings.count)
		return TCS_OK;
	if (array_grow(&raw->positions, length + 1))
		return fault_memory(fault);
	ring = &raw->texrings.at[raw->texrings.count - 1];
	ring->first = raw->positions.count;
	ring->length = length;
	memcpy(raw->positions.at + ring->first, reader->text.at, length);
	raw->positions.count += length;
	paint->mapping = MAPPING_LIST;
	paint->ring_count = (uint32_t)raw->texrings.count - paint->first_ring;
	return TCS_OK;
}

/* The name of the next ring that came without one. */
static enum tcs_status
texring_name_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	const char *at;
	size_t length;

	if (reader->next_texring >= raw->texrings.count)
		return TCS_OK;
	gml_trimmed(reader, &at, &length);
	return texring_set_name(reader,
		&raw->texrings.at[reader->next_texring++], at, length, fault);
}

static enum tcs_status
texmatrix_end(struct gml_reader *reader, struct tcs_fault *fault)
{
	struct raw_object *raw = reader->raw;
	struct raw_paint *paint = paint_last(reader);
	struct raw_texmatrix *matrix;

	if (!paint)
		return TCS_OK;
	if (array_grow(&raw->texmatrices, 1))
		return fault_memory(fault);
	matrix = &raw->texmatrices.at[raw->texmatrices.count];
	matrix->east_first = false;
	if (numbers_first(
		    reader->text.at, reader->text.count, matrix->at, 12) != 12)
		return TCS_OK;
	paint->mapping = MAPPING_MATRIX;
	paint->matrix = (uint32_t)raw->texmatrices.count++;
	return TCS_OK;
}

enum tcs_status
mapping_child(struct gml_reader *reader, struct frame *frame,
	const struct xml_attribute *attributes, size_t count,
	struct tcs_fault *fault)
{
	const struct xml_attribute *href =
		attribute_find(attributes, count, "href");

	switch (frame->name->kind) {
	case NAME_TEXTURE_ASSOCIATION:
		return href ? association_link(reader, frame, href, fault)
			    : TCS_OK;
	case NAME_TEXTURE_LIST:
	case NAME_TEXTURE_MATRIX_HOLDER:
		return mapping_begin(reader, attributes, count, fault);
	case NAME_TEXTURE_RING:
		return texring_begin(reader, frame, attributes, count, fault);
	case NAME_TEXTURE_RING_NAME:
	case NAME_TEXTURE_MATRIX:
		frame->wants_text = true;
		return TCS_OK;
	default:
		return TCS_OK;
	}
}

enum tcs_status
mapping_end(struct gml_reader *reader, const struct frame *frame,
	struct tcs_fault *fault)
{
	switch (frame->name->kind) {
	case NAME_TEXTURE_RING:
		return frame->wants_text ? texring_end(reader, fault) : TCS_OK;
	case NAME_TEXTURE_RING_NAME:
		return texring_name_end(reader, fault);
	case NAME_TEXTURE_MATRIX:
		return texmatrix_end(reader, fault);
	default:
		return TCS_OK;
	}
}
