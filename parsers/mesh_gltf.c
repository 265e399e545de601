/*
 * glTF 2.0: the triangles of a scene, placed by its nodes, y up turned to z up.
 *
 * The JSON says where numbers lie in the buffers; every such claim is checked
 * against the bytes that are there before one is read.
 */
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base64.h"
#include "mesh_file.h"

struct gltf {
	struct mesh_file *mesh;
	const struct mesh_source *source;
	const char **problem;
	struct tcs_fault *fault;
	json_t *root;
	struct mesh_bytes binary; /* of a .glb; borrowed */
	struct mesh_bytes *buffers; /* owned, NULL until they are read */
	size_t buffer_count;
	uint64_t held; /* bytes of those that were read */
	bool *visited; /* per node */
};

/* An array of numbers in a buffer. */
struct numbers {
	const unsigned char *at;
	size_t count, stride;
	int component; /* 5121, 5123, 5125, 5126 */
};

enum {
	UNSIGNED_BYTE = 5121,
	UNSIGNED_SHORT = 5123,
	UNSIGNED_INT = 5125,
	FLOAT = 5126
};

static const char broken[] = "the glTF is broken";

static enum tcs_status
refuse(struct gltf *gltf, const char *problem)
{
	if (!*gltf->problem)
		*gltf->problem = problem;
	return TCS_OK;
}

/* A whole number; `otherwise` where there is none or it is none. */
static size_t
get_number(const json_t *object, const char *key, size_t otherwise)
{
	const json_t *value = json_object_get(object, key);
	json_int_t number = json_integer_value(value);

	return json_is_integer(value) && number >= 0 && number <= UINT32_MAX
		? (size_t)number
		: otherwise;
}

static const json_t *
get_element(const struct gltf *gltf, const char *array, size_t index)
{
	return json_array_get(json_object_get(gltf->root, array), index);
}

/* ---- buffers ----------------------------------------------------------------- */

static enum tcs_status
decode_data(struct gltf *gltf, struct mesh_bytes *buffer, const char *uri)
{
	const char *text = strstr(uri, ";base64,");
	size_t length;

	if (!text)
		return refuse(gltf, broken);
	text += 8;
	length = strlen(text);
	buffer->at = malloc(length / 4 * 3 + 1);
	if (!buffer->at)
		return fault_memory(gltf->fault);
	if (base64_decode(buffer->at, &buffer->count, text, length))
		return refuse(gltf, broken);
	return TCS_OK;
}

static enum tcs_status
buffer_read(struct gltf *gltf, size_t index, struct mesh_bytes *out)
{
	const json_t *entry = get_element(gltf, "buffers", index);
	const char *uri = json_string_value(json_object_get(entry, "uri"));
	struct mesh_bytes *buffer = &gltf->buffers[index];
	struct mesh_source source = *gltf->source;
	enum tcs_status status = TCS_OK;

	if (!uri) {
		*out = index == 0 ? gltf->binary
				  : (struct mesh_bytes){.count = 0};
		return out->at ? TCS_OK : refuse(gltf, broken);
	}
	source.limit -= gltf->held;
	if (!buffer->at && !strncmp(uri, "data:", 5)) {
		status = decode_data(gltf, buffer, uri);
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
	case UNSIGNED_BYTE:
		return 1;
	case UNSIGNED_SHORT:
		return 2;
	case UNSIGNED_INT:
	case FLOAT:
		return 4;
	default:
		return 0;
	}
}

/* An accessor of `width` components, all of whose bytes are there. */
static enum tcs_status
numbers_find(struct gltf *gltf, size_t index, size_t width, struct numbers *out)
{
	const json_t *accessor = get_element(gltf, "accessors", index);
	size_t view_index = get_number(accessor, "bufferView", SIZE_MAX);
	const json_t *view = get_element(gltf, "bufferViews", view_index);
	size_t buffer_index = get_number(view, "buffer", SIZE_MAX);
	size_t first = get_number(view, "byteOffset", 0);
	size_t length = get_number(view, "byteLength", 0);
	size_t offset = get_number(accessor, "byteOffset", 0);
	struct mesh_bytes bytes;
	size_t size;
	enum tcs_status status;

	out->component = (int)get_number(accessor, "componentType", 0);
	out->count = get_number(accessor, "count", 0);
	size = width * component_size(out->component);
	out->stride = get_number(view, "byteStride", size);
	if (json_object_get(accessor, "sparse"))
		return refuse(gltf, "it has sparse arrays");
	if (buffer_index >= gltf->buffer_count || !size || !out->count ||
		out->stride < size)
		return refuse(gltf, broken);
	status = buffer_read(gltf, buffer_index, &bytes);
	if (status || *gltf->problem)
		return status;
	if (first > bytes.count || length > bytes.count - first ||
		offset > length || length - offset < size ||
		(length - offset - size) / out->stride < out->count - 1)
		return refuse(gltf, broken);
	out->at = bytes.at + first + offset;
	return TCS_OK;
}

static uint32_t
whole_at(const struct numbers *numbers, size_t index)
{
	const unsigned char *at = numbers->at + index * numbers->stride;
	uint32_t value = 0;

	for (size_t i = component_size(numbers->component); i-- > 0;)
		value = value << 8 | at[i];
	return value;
}

static double
float_at(const unsigned char *at)
{
	uint32_t bits = (uint32_t)at[0] | (uint32_t)at[1] << 8 |
		(uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
	float value;

	memcpy(&value, &bits, sizeof value);
	return value;
}

/* ---- primitives -------------------------------------------------------------- */

enum { TRIANGLES = 4, TRIANGLE_STRIP = 5, TRIANGLE_FAN = 6 };

/* The points of the primitive, placed and turned; *first is that of them. */
static enum tcs_status
points_take(struct gltf *gltf, const struct numbers *positions,
	const double m[16], uint32_t *first)
{
	enum tcs_status status = TCS_OK;

	*first = (uint32_t)gltf->mesh->points.count;
	for (size_t i = 0; !status && !*gltf->problem && i < positions->count;
		i++) {
		const unsigned char *at = positions->at + i * positions->stride;
		double p[3] = {
			float_at(at), float_at(at + 4), float_at(at + 8)};
		double q[3];

		for (int j = 0; j < 3; j++)
			q[j] = m[j] * p[0] + m[4 + j] * p[1] + m[8 + j] * p[2] +
				m[12 + j];
		status = mesh_add_point(gltf->mesh, gltf->source,
			&(struct tcs_point){q[0], 0 - q[2], q[1]},
			gltf->problem, gltf->fault);
	}
	return status;
}

/* The three corners of triangle `i`, in the order they wind. */
static void
triangle_corners(size_t mode, size_t i, size_t corners[3])
{
	size_t odd = i & 1;

	corners[0] = mode == TRIANGLES ? 3 * i : mode == TRIANGLE_FAN ? 0 : i;
	corners[1] = mode == TRIANGLES ? 3 * i + 1 : i + 1;
	corners[2] = mode == TRIANGLES ? 3 * i + 2 : i + 2;
	if (mode == TRIANGLE_STRIP && odd) {
		corners[1] = i + 2;
		corners[2] = i + 1;
	}
}

static bool
mirrors(const double m[16])
{
	return m[0] * (m[5] * m[10] - m[6] * m[9]) -
		m[4] * (m[1] * m[10] - m[2] * m[9]) +
		m[8] * (m[1] * m[6] - m[2] * m[5]) <
		0;
}

/* Without indices the points come in their order. */
static enum tcs_status
triangles_take(struct gltf *gltf, const struct numbers *indices, size_t count,
	size_t mode, uint32_t first, bool mirrored, uint32_t material)
{
	size_t points = gltf->mesh->points.count - first;
	size_t triangles = mode == TRIANGLES ? count / 3
		: count < 3		     ? 0
					     : count - 2;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && !*gltf->problem && i < triangles; i++) {
		size_t corners[3];

		triangle_corners(mode, i, corners);
		for (int j = 0; j < 3 && !status && !*gltf->problem; j++) {
			size_t corner = corners[mirrored ? 2 - j : j];
			size_t point =
				indices ? whole_at(indices, corner) : corner;

			status = mesh_add_corner(gltf->mesh, gltf->source,
				point < points ? first + (uint32_t)point
					       : TCS_NONE,
				gltf->problem, gltf->fault);
		}
		if (!status && !*gltf->problem)
			status = mesh_add_face(
				gltf->mesh, 3, material, gltf->fault);
	}
	return status;
}

static enum tcs_status
primitive_take(
	struct gltf *gltf, const json_t *primitive, const double matrix[16])
{
	const json_t *attributes = json_object_get(primitive, "attributes");
	size_t mode = get_number(primitive, "mode", TRIANGLES);
	size_t material = get_number(primitive, "material", SIZE_MAX);
	size_t indices_index = get_number(primitive, "indices", SIZE_MAX);
	struct numbers positions, indices;
	bool indexed = json_object_get(primitive, "indices");
	enum tcs_status status;
	uint32_t first;

	if (mode < TRIANGLES || mode > TRIANGLE_FAN)
		return TCS_OK; /* points and lines */
	status = numbers_find(gltf,
		get_number(attributes, "POSITION", SIZE_MAX), 3, &positions);
	if (!status && !*gltf->problem && positions.component != FLOAT)
		return refuse(gltf, broken);
	if (!status && !*gltf->problem && indexed)
		status = numbers_find(gltf, indices_index, 1, &indices);
	if (!status && !*gltf->problem && indexed && indices.component == FLOAT)
		return refuse(gltf, broken);
	if (!status && !*gltf->problem)
		status = points_take(gltf, &positions, matrix, &first);
	if (status || *gltf->problem)
		return status;
	return triangles_take(gltf, indexed ? &indices : NULL,
		indexed ? indices.count : positions.count, mode, first,
		mirrors(matrix),
		material < gltf->mesh->materials.count ? (uint32_t)material
						       : TCS_NONE);
}

/* ---- nodes ------------------------------------------------------------------- */

static void
get_numbers(const json_t *object, const char *key, double *out, size_t count)
{
	const json_t *array = json_object_get(object, key);

	if (json_array_size(array) != count)
		return;
	for (size_t i = 0; i < count; i++)
		out[i] = json_number_value(json_array_get(array, i));
}

/* Column by column, as in the file. */
static void
node_matrix(const json_t *node, double m[16])
{
	double t[3] = {0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
	double x, y, z, w;

	get_numbers(node, "translation", t, 3);
	get_numbers(node, "rotation", r, 4);
	get_numbers(node, "scale", s, 3);
	x = r[0], y = r[1], z = r[2], w = r[3];
	memcpy(m,
		(double[16]){(1 - 2 * (y * y + z * z)) * s[0],
			2 * (x * y + z * w) * s[0], 2 * (x * z - y * w) * s[0],
			0, 2 * (x * y - z * w) * s[1],
			(1 - 2 * (x * x + z * z)) * s[1],
			2 * (y * z + x * w) * s[1], 0,
			2 * (x * z + y * w) * s[2], 2 * (y * z - x * w) * s[2],
			(1 - 2 * (x * x + y * y)) * s[2], 0, t[0], t[1], t[2],
			1},
		16 * sizeof *m);
	get_numbers(node, "matrix", m, 16);
}

static void
matrix_multiply(const double a[16], const double b[16], double out[16])
{
	for (int column = 0; column < 4; column++)
		for (int row = 0; row < 4; row++) {
			double sum = 0;

			for (int i = 0; i < 4; i++)
				sum += a[4 * i + row] * b[4 * column + i];
			out[4 * column + row] = sum;
		}
}

struct place {
	size_t node;
	double parent[16];
};

TCS_ARRAY_TYPE(places, struct place);

static enum tcs_status
places_add(struct gltf *gltf, struct places *places, const json_t *nodes,
	const double parent[16])
{
	size_t known = json_array_size(json_object_get(gltf->root, "nodes"));

	for (size_t i = json_array_size(nodes); i-- > 0;) {
		const json_t *value = json_array_get(nodes, i);
		json_int_t node = json_integer_value(value);
		struct place *place;

		if (!json_is_integer(value) || node < 0 ||
			(size_t)node >= known || gltf->visited[node])
			return refuse(gltf, broken);
		gltf->visited[node] = true;
		if (array_grow(places, 1))
			return fault_memory(gltf->fault);
		place = &places->at[places->count++];
		place->node = (size_t)node;
		memcpy(place->parent, parent, sizeof place->parent);
	}
	return TCS_OK;
}

static enum tcs_status
node_take(struct gltf *gltf, struct places *places)
{
	const struct place place = places->at[--places->count];
	const json_t *node = get_element(gltf, "nodes", place.node);
	const json_t *mesh =
		get_element(gltf, "meshes", get_number(node, "mesh", SIZE_MAX));
	const json_t *primitives = json_object_get(mesh, "primitives");
	double own[16], matrix[16];
	enum tcs_status status = TCS_OK;

	node_matrix(node, own);
	matrix_multiply(place.parent, own, matrix);
	for (size_t i = 0;
		!status && !*gltf->problem && i < json_array_size(primitives);
		i++)
		status = primitive_take(
			gltf, json_array_get(primitives, i), matrix);
	if (status || *gltf->problem)
		return status;
	return places_add(
		gltf, places, json_object_get(node, "children"), matrix);
}

/* Depth first, by a stack: a node comes once, so that it ends. */
static enum tcs_status
scene_take(struct gltf *gltf)
{
	static const double unit[16] = {
		1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
	const json_t *scene =
		get_element(gltf, "scenes", get_number(gltf->root, "scene", 0));
	struct places places = {0};
	enum tcs_status status = places_add(
		gltf, &places, json_object_get(scene, "nodes"), unit);

	while (!status && !*gltf->problem && places.count)
		status = node_take(gltf, &places);
	array_release(&places);
	return status;
}

/* ---- materials --------------------------------------------------------------- */

/* glTF's colours are linear. */
static float
srgb_of(double linear)
{
	if (!(linear > 0))
		return 0;
	if (linear >= 1)
		return 1;
	return (float)(linear <= 0.0031308
			? 12.92 * linear
			: 1.055 * pow(linear, 1 / 2.4) - 0.055);
}

static enum tcs_status
materials_take(struct gltf *gltf)
{
	const json_t *all = json_object_get(gltf->root, "materials");
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && i < json_array_size(all); i++) {
		const json_t *entry = json_array_get(all, i);
		const json_t *shown =
			json_object_get(entry, "pbrMetallicRoughness");
		const json_t *named = json_object_get(entry, "name");
		const char *name = json_string_value(named);
		const char *mode =
			json_string_value(json_object_get(entry, "alphaMode"));
		double colour[4] = {1, 1, 1, 1};
		struct mesh_material *material;

		get_numbers(shown, "baseColorFactor", colour, 4);
		status = mesh_add_material(gltf->mesh, name ? name : "",
			name ? strlen(name) : 0, &material, gltf->fault);
		if (status)
			break;
		for (int j = 0; j < 3; j++)
			material->diffuse[j] = srgb_of(colour[j]);
		if (mode && !strcmp(mode, "BLEND") && colour[3] >= 0 &&
			colour[3] <= 1)
			material->transparency = (float)(1 - colour[3]);
	}
	return status;
}

/* ---- all of it --------------------------------------------------------------- */

static enum tcs_status
document_take(struct gltf *gltf)
{
	size_t nodes = json_array_size(json_object_get(gltf->root, "nodes"));
	enum tcs_status status;

	if (!json_is_object(gltf->root))
		return refuse(gltf, "it is no glTF");
	if (json_array_size(json_object_get(gltf->root, "extensionsRequired")))
		return refuse(gltf, "it requires extensions of glTF");
	gltf->buffer_count =
		json_array_size(json_object_get(gltf->root, "buffers"));
	gltf->buffers = calloc(gltf->buffer_count + 1, sizeof *gltf->buffers);
	gltf->visited = calloc(nodes + 1, sizeof *gltf->visited);
	if (!gltf->buffers || !gltf->visited)
		return fault_memory(gltf->fault);
	status = materials_take(gltf);
	return status ? status : scene_take(gltf);
}

static uint32_t
word_at(const unsigned char *at)
{
	return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 |
		(uint32_t)at[3] << 24;
}

/* A .glb holds the JSON and the first buffer; all else is the JSON. */
static bool
parts_find(const struct mesh_bytes *bytes, struct mesh_bytes *text,
	struct mesh_bytes *binary)
{
	const unsigned char *at = bytes->at;
	size_t length;

	*text = *bytes;
	*binary = (struct mesh_bytes){.count = 0};
	if (bytes->count < 4 || memcmp(at, "glTF", 4) != 0)
		return true;
	if (bytes->count < 20 || word_at(at + 4) != 2 ||
		memcmp(at + 16, "JSON", 4) != 0)
		return false;
	length = word_at(at + 12);
	if (length > bytes->count - 20)
		return false;
	*text = (struct mesh_bytes){bytes->at + 20, length};
	at += 20 + length;
	if (bytes->count - 20 - length < 8)
		return true;
	if (memcmp(at + 4, "BIN", 4) != 0 ||
		word_at(at) > bytes->count - 28 - length)
		return false;
	*binary =
		(struct mesh_bytes){bytes->at + 28 + text->count, word_at(at)};
	return true;
}

enum tcs_status
mesh_parse_gltf(struct mesh_file *mesh, const struct mesh_source *source,
	const struct mesh_bytes *bytes, const char **problem,
	struct tcs_fault *fault)
{
	struct gltf gltf = {
		.mesh = mesh,
		.source = source,
		.problem = problem,
		.fault = fault,
	};
	struct mesh_bytes text;
	enum tcs_status status;

	*problem = NULL;
	if (!parts_find(bytes, &text, &gltf.binary))
		return refuse(&gltf, broken);
	gltf.root = json_loadb((const char *)text.at, text.count,
		JSON_DISABLE_EOF_CHECK, NULL);
	status = document_take(&gltf);
	for (size_t i = 0; gltf.buffers && i < gltf.buffer_count; i++)
		free(gltf.buffers[i].at);
	free(gltf.buffers);
	free(gltf.visited);
	json_decref(gltf.root);
	return status;
}
