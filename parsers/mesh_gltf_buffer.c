/* glTF: numbers and bytes, where the JSON says that they lie in buffers. */
#include "mesh_gltf.h"

#include <stdlib.h>
#include <string.h>

#include "base64.h"

enum tcs_status
gltf_data_decode(struct gltf *gltf, const char *uri, struct mesh_bytes *out)
{
	const char *text = strstr(uri, ";base64,");
	size_t length;

	*out = (struct mesh_bytes){.count = 0};
	if (!text)
		return gltf_refuse(gltf, gltf_broken);
	text += 8;
	length = strlen(text);
	out->at = malloc(length / 4 * 3 + 1);
	if (!out->at)
		return fault_memory(gltf->fault);
	if (base64_decode(out->at, &out->count, text, length))
		return gltf_refuse(gltf, gltf_broken);
	return TCS_OK;
}

static enum tcs_status
buffer_read(struct gltf *gltf, size_t index, struct mesh_bytes *out)
{
	const json_t *entry = gltf_element(gltf, "buffers", index);
	const char *uri = json_string_value(json_object_get(entry, "uri"));
	struct mesh_bytes *buffer = &gltf->buffers[index];
	struct mesh_source source = *gltf->source;
	enum tcs_status status = TCS_OK;

	if (!uri) {
		*out = index == 0 ? gltf->binary
				  : (struct mesh_bytes){.count = 0};
		return out->at ? TCS_OK : gltf_refuse(gltf, gltf_broken);
	}
	source.limit -= gltf->held;
	if (!buffer->at && !strncmp(uri, "data:", 5)) {
		status = gltf_data_decode(gltf, uri, buffer);
	} else if (!buffer->at) {
		status = mesh_bytes_read(
			buffer, &source, uri, gltf->problem, gltf->fault);
		gltf->held += buffer->count;
	}
	*out = *buffer;
	return status;
}

static size_t
component_size(int component)
{
	switch (component) {
	case GLTF_UNSIGNED_BYTE:
		return 1;
	case GLTF_UNSIGNED_SHORT:
		return 2;
	case GLTF_UNSIGNED_INT:
	case GLTF_FLOAT:
		return 4;
	default:
		return 0;
	}
}

enum tcs_status
gltf_view_find(struct gltf *gltf, size_t index, struct mesh_bytes *out)
{
	const json_t *view = gltf_element(gltf, "bufferViews", index);
	size_t buffer = gltf_number(view, "buffer", SIZE_MAX);
	size_t first = gltf_number(view, "byteOffset", 0);
	size_t length = gltf_number(view, "byteLength", 0);
	enum tcs_status status;

	if (buffer >= gltf->buffer_count)
		return gltf_refuse(gltf, gltf_broken);
	status = buffer_read(gltf, buffer, out);
	if (status || *gltf->problem)
		return status;
	if (first > out->count || length > out->count - first)
		return gltf_refuse(gltf, gltf_broken);
	*out = (struct mesh_bytes){out->at + first, length};
	return TCS_OK;
}

enum tcs_status
gltf_numbers_find(
	struct gltf *gltf, size_t index, size_t width, struct gltf_numbers *out)
{
	const json_t *accessor = gltf_element(gltf, "accessors", index);
	size_t view = gltf_number(accessor, "bufferView", SIZE_MAX);
	size_t offset = gltf_number(accessor, "byteOffset", 0);
	struct mesh_bytes bytes;
	size_t size;
	enum tcs_status status;

	out->component = (int)gltf_number(accessor, "componentType", 0);
	out->count = gltf_number(accessor, "count", 0);
	size = width * component_size(out->component);
	out->stride = gltf_number(
		gltf_element(gltf, "bufferViews", view), "byteStride", size);
	if (json_object_get(accessor, "sparse"))
		return gltf_refuse(gltf, "it has sparse arrays");
	if (!size || !out->count || out->stride < size)
		return gltf_refuse(gltf, gltf_broken);
	status = gltf_view_find(gltf, view, &bytes);
	if (status || *gltf->problem)
		return status;
	if (offset > bytes.count || bytes.count - offset < size ||
		(bytes.count - offset - size) / out->stride < out->count - 1)
		return gltf_refuse(gltf, gltf_broken);
	out->at = bytes.at + offset;
	return TCS_OK;
}

uint32_t
gltf_whole_at(const struct gltf_numbers *numbers, size_t index)
{
	const unsigned char *at = numbers->at + index * numbers->stride;
	uint32_t value = 0;

	for (size_t i = component_size(numbers->component); i-- > 0;)
		value = value << 8 | at[i];
	return value;
}

double
gltf_float_at(const unsigned char *at)
{
	uint32_t bits = (uint32_t)at[0] | (uint32_t)at[1] << 8 |
		(uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
	float value;

	memcpy(&value, &bits, sizeof value);
	return value;
}
