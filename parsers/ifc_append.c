#include "ifc_append.h"

#include <string.h>

/* Both are arrays of elements of `size` bytes. */
static enum tcs_status
array_append(
	void *array, const void *more, size_t size, struct tcs_fault *fault)
{
	struct tcs_array from, to;

	memcpy(&from, more, sizeof from);
	if (!from.count)
		return TCS_OK;
	if (array_grow_bytes(array, size, from.count))
		return fault_memory(fault);
	memcpy(&to, array, sizeof to);
	memcpy((char *)to.at + to.count * size, from.at, from.count * size);
	to.count += from.count;
	memcpy(array, &to, sizeof to);
	return TCS_OK;
}

#define APPEND(out, more, fault) \
	array_append((out), (more), sizeof *(out)->at, (fault))

/* Where the indices and the text of what is appended begin. */
struct bases {
	uint32_t attribute, shell, polygon, ring, vertex, triangle;
	uint32_t text; /* of what comes: its offset 1 */
};

static void
text_shift(tcs_text *text, const struct bases *by)
{
	if (*text)
		*text += by->text - 1;
}

static enum tcs_status
text_take(struct tcs_object *out, const struct tcs_object *more,
	struct bases *by, struct tcs_fault *fault)
{
	size_t skip = out->text.count > 0, length;

	by->text = out->text.count ? (uint32_t)out->text.count : 1;
	if (!more->text.count)
		return TCS_OK;
	length = more->text.count - skip;
	if (length > UINT32_MAX - out->text.count)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"the text of one record exceeds 4 GiB");
	if (array_grow(&out->text, length))
		return fault_memory(fault);
	memcpy(out->text.at + out->text.count, more->text.at + skip, length);
	out->text.count += length;
	return TCS_OK;
}

static void
attribute_shift(struct tcs_attribute *attribute, const struct bases *by)
{
	if (attribute->parent != TCS_NONE)
		attribute->parent += by->attribute;
	text_shift(&attribute->name, by);
	text_shift(&attribute->space, by);
	text_shift(&attribute->value, by);
	text_shift(&attribute->unit, by);
	text_shift(&attribute->code_space, by);
}

static enum tcs_status
features_append(struct tcs_object *out, const struct tcs_object *more,
	struct bases *by, struct tcs_fault *fault)
{
	size_t feature = out->features.count, relation = out->relations.count;
	enum tcs_status status = text_take(out, more, by, fault);

	if (status)
		return status;
	if (APPEND(&out->features, &more->features, fault) ||
		APPEND(&out->attributes, &more->attributes, fault) ||
		APPEND(&out->relations, &more->relations, fault))
		return TCS_NO_MEMORY;
	for (size_t i = feature; i < out->features.count; i++) {
		text_shift(&out->features.at[i].id, by);
		text_shift(&out->features.at[i].name, by);
		text_shift(&out->features.at[i].type, by);
		text_shift(&out->features.at[i].role, by);
	}
	for (size_t i = by->attribute; i < out->attributes.count; i++)
		attribute_shift(out->attributes.at + i, by);
	for (size_t i = relation; i < out->relations.count; i++) {
		text_shift(&out->relations.at[i].role, by);
		text_shift(&out->relations.at[i].target, by);
		text_shift(&out->relations.at[i].note, by);
	}
	return TCS_OK;
}

static void
polygons_shift(struct tcs_object *out, size_t first, const struct bases *by)
{
	for (size_t i = first; i < out->polygons.count; i++) {
		out->polygons.at[i].first_vertex += by->vertex;
		out->polygons.at[i].first_ring += by->ring;
		out->polygons.at[i].first_triangle += by->triangle;
	}
	for (size_t i = by->ring; i < out->rings.count; i++)
		out->rings.at[i].first_vertex += by->vertex;
	for (size_t i = by->triangle; i < out->triangles.count; i++)
		for (int k = 0; k < 3; k++)
			out->triangles.at[i].corner[k] += by->vertex;
}

static enum tcs_status
geometries_append(struct tcs_object *out, const struct tcs_object *more,
	const struct bases *by, struct tcs_fault *fault)
{
	size_t geometry = out->geometries.count, paint = out->paints.count;

	if (APPEND(&out->geometries, &more->geometries, fault) ||
		APPEND(&out->shells, &more->shells, fault) ||
		APPEND(&out->polygons, &more->polygons, fault) ||
		APPEND(&out->rings, &more->rings, fault) ||
		APPEND(&out->vertices, &more->vertices, fault) ||
		APPEND(&out->triangles, &more->triangles, fault) ||
		APPEND(&out->paints, &more->paints, fault) ||
		APPEND(&out->instances, &more->instances, fault))
		return TCS_NO_MEMORY;
	for (size_t i = geometry; i < out->geometries.count; i++) {
		out->geometries.at[i].first_shell += by->shell;
		out->geometries.at[i].first_polygon += by->polygon;
	}
	for (size_t i = by->shell; i < out->shells.count; i++)
		out->shells.at[i].first_polygon += by->polygon;
	for (size_t i = paint; i < out->paints.count; i++)
		out->paints.at[i].polygon += by->polygon;
	polygons_shift(out, by->polygon, by);
	return TCS_OK;
}

enum tcs_status
ifc_object_append(struct tcs_object *out, const struct tcs_object *more,
	struct tcs_fault *fault)
{
	struct bases by = {.attribute = (uint32_t)out->attributes.count,
		.shell = (uint32_t)out->shells.count,
		.polygon = (uint32_t)out->polygons.count,
		.ring = (uint32_t)out->rings.count,
		.vertex = (uint32_t)out->vertices.count,
		.triangle = (uint32_t)out->triangles.count};
	enum tcs_status status;

	if (out->vertices.count + more->vertices.count > UINT32_MAX / 2 ||
		out->attributes.count + more->attributes.count > UINT32_MAX / 2)
		return fault_set(fault, TCS_LIMIT, TCS_NOWHERE,
			"an object has too many vertices or attributes");
	status = features_append(out, more, &by, fault);
	return status ? status : geometries_append(out, more, &by, fault);
}
