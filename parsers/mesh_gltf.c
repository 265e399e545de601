/*
 * glTF 2.0: the triangles of a scene, placed by its nodes, y up turned to z up.
 *
 * The JSON says where numbers lie in the buffers; every such claim is checked
 * against the bytes that are there before one is read.
 */
#include "mesh_gltf.h"

#include <stdlib.h>
#include <string.h>

const char gltf_broken[] = "the glTF is broken";

enum tcs_status
gltf_refuse(struct gltf *gltf, const char *problem)
{
	if (!*gltf->problem)
		*gltf->problem = problem;
	return TCS_OK;
}

size_t
gltf_number(const json_t *object, const char *key, size_t otherwise)
{
	const json_t *value = json_object_get(object, key);
	json_int_t number = json_integer_value(value);

	return json_is_integer(value) && number >= 0 && number <= UINT32_MAX
		? (size_t)number
		: otherwise;
}

const json_t *
gltf_element(const struct gltf *gltf, const char *array, size_t index)
{
	return json_array_get(json_object_get(gltf->root, array), index);
}

void
gltf_array(const json_t *object, const char *key, double *out, size_t count)
{
	const json_t *array = json_object_get(object, key);

	if (json_array_size(array) != count)
		return;
	for (size_t i = 0; i < count; i++)
		out[i] = json_number_value(json_array_get(array, i));
}

/* ---- primitives -------------------------------------------------------------- */

enum { TRIANGLES = 4, TRIANGLE_STRIP = 5, TRIANGLE_FAN = 6 };

/* The points of the primitive, placed and turned; *first is that of them. */
static enum tcs_status
points_take(struct gltf *gltf, const struct gltf_numbers *positions,
	const double m[16], uint32_t *first)
{
	enum tcs_status status = TCS_OK;

	*first = (uint32_t)gltf->mesh->points.count;
	for (size_t i = 0; !status && !*gltf->problem && i < positions->count;
		i++) {
		const unsigned char *at = positions->at + i * positions->stride;
		double p[3] = {gltf_float_at(at), gltf_float_at(at + 4),
			gltf_float_at(at + 8)};
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

/* A primitive whose points have been taken. */
struct primitive {
	const struct gltf_numbers *indices; /* NULL: the points in order */
	struct gltf_numbers texcoords; /* of the points; may count none */
	size_t corner_count, mode;
	uint32_t first_point; /* of the mesh */
	uint32_t material;
	bool mirrored;
};

static enum tcs_status
corner_take(struct gltf *gltf, const struct primitive *primitive, size_t corner)
{
	size_t points = gltf->mesh->points.count - primitive->first_point;
	size_t point = primitive->indices
		? gltf_whole_at(primitive->indices, corner)
		: corner;
	bool textured = point < primitive->texcoords.count;
	struct tcs_texcoord texcoord = {0, 0};

	if (textured)
		texcoord = gltf_texcoord_at(gltf, primitive->material,
			&primitive->texcoords, point);
	return mesh_add_corner(gltf->mesh, gltf->source,
		point < points ? primitive->first_point + (uint32_t)point
			       : TCS_NONE,
		textured ? &texcoord : NULL, gltf->problem, gltf->fault);
}

static enum tcs_status
triangles_take(struct gltf *gltf, const struct primitive *primitive)
{
	size_t count = primitive->corner_count;
	size_t triangles = primitive->mode == TRIANGLES ? count / 3
		: count < 3				? 0
							: count - 2;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; !status && !*gltf->problem && i < triangles; i++) {
		size_t corners[3];

		triangle_corners(primitive->mode, i, corners);
		for (int j = 0; j < 3 && !status && !*gltf->problem; j++)
			status = corner_take(gltf, primitive,
				corners[primitive->mirrored ? 2 - j : j]);
		if (!status && !*gltf->problem)
			status = mesh_add_face(gltf->mesh, 3,
				primitive->material, gltf->fault);
	}
	return status;
}

static enum tcs_status
primitive_take(struct gltf *gltf, const json_t *entry, const double matrix[16])
{
	const json_t *attributes = json_object_get(entry, "attributes");
	size_t material = gltf_number(entry, "material", SIZE_MAX);
	bool indexed = json_object_get(entry, "indices");
	struct gltf_numbers positions, indices;
	struct primitive primitive = {
		.mode = gltf_number(entry, "mode", TRIANGLES),
		.material = material < gltf->mesh->materials.count
			? (uint32_t)material
			: TCS_NONE,
		.mirrored = mirrors(matrix),
	};
	enum tcs_status status;

	if (primitive.mode < TRIANGLES || primitive.mode > TRIANGLE_FAN)
		return TCS_OK; /* points and lines */
	status = gltf_numbers_find(gltf,
		gltf_number(attributes, "POSITION", SIZE_MAX), 3, &positions);
	if (!status && !*gltf->problem && positions.component != GLTF_FLOAT)
		return gltf_refuse(gltf, gltf_broken);
	if (!status && !*gltf->problem && indexed)
		status = gltf_numbers_find(gltf,
			gltf_number(entry, "indices", SIZE_MAX), 1, &indices);
	if (!status && !*gltf->problem && indexed &&
		indices.component == GLTF_FLOAT)
		return gltf_refuse(gltf, gltf_broken);
	if (!status && !*gltf->problem)
		status = gltf_texcoords_find(gltf, attributes,
			primitive.material, &primitive.texcoords);
	if (!status && !*gltf->problem)
		status = points_take(
			gltf, &positions, matrix, &primitive.first_point);
	if (status || *gltf->problem)
		return status;
	primitive.indices = indexed ? &indices : NULL;
	primitive.corner_count = indexed ? indices.count : positions.count;
	return triangles_take(gltf, &primitive);
}

/* ---- nodes ------------------------------------------------------------------- */

/* Column by column, as in the file. */
static void
node_matrix(const json_t *node, double m[16])
{
	double t[3] = {0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
	double x, y, z, w;

	gltf_array(node, "translation", t, 3);
	gltf_array(node, "rotation", r, 4);
	gltf_array(node, "scale", s, 3);
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
	gltf_array(node, "matrix", m, 16);
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
			return gltf_refuse(gltf, gltf_broken);
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
	const json_t *node = gltf_element(gltf, "nodes", place.node);
	const json_t *mesh = gltf_element(
		gltf, "meshes", gltf_number(node, "mesh", SIZE_MAX));
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
	const json_t *scene = gltf_element(
		gltf, "scenes", gltf_number(gltf->root, "scene", 0));
	struct places places = {0};
	enum tcs_status status = places_add(
		gltf, &places, json_object_get(scene, "nodes"), unit);

	while (!status && !*gltf->problem && places.count)
		status = node_take(gltf, &places);
	array_release(&places);
	return status;
}

/* ---- all of it --------------------------------------------------------------- */

static enum tcs_status
document_take(struct gltf *gltf)
{
	size_t nodes = json_array_size(json_object_get(gltf->root, "nodes"));
	enum tcs_status status;

	if (!json_is_object(gltf->root))
		return gltf_refuse(gltf, "it is no glTF");
	if (json_array_size(json_object_get(gltf->root, "extensionsRequired")))
		return gltf_refuse(gltf, "it requires extensions of glTF");
	gltf->buffer_count =
		json_array_size(json_object_get(gltf->root, "buffers"));
	gltf->buffers = calloc(gltf->buffer_count + 1, sizeof *gltf->buffers);
	gltf->visited = calloc(nodes + 1, sizeof *gltf->visited);
	if (!gltf->buffers || !gltf->visited)
		return fault_memory(gltf->fault);
	status = gltf_materials_take(gltf);
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
		return gltf_refuse(&gltf, gltf_broken);
	gltf.root = json_loadb((const char *)text.at, text.count,
		JSON_DISABLE_EOF_CHECK, NULL);
	status = document_take(&gltf);
	for (size_t i = 0; gltf.buffers && i < gltf.buffer_count; i++)
		free(gltf.buffers[i].at);
	free(gltf.buffers);
	free(gltf.visited);
	free(gltf.looks);
	free(gltf.images);
	json_decref(gltf.root);
	return status;
}
