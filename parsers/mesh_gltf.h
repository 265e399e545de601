/*
 * A glTF document while it is read: what its JSON says where, and the bytes of
 * its buffers. Every claim is checked against these before one is read.
 */
#ifndef TESSERA_MESH_GLTF_H
#define TESSERA_MESH_GLTF_H

#include <jansson.h>

#include "mesh_file.h"

/* How a material lies on its faces. */
struct gltf_look {
	size_t set; /* of texture coordinates */
	double map[6]; /* from these to those of the image: a b c; d e f */
};

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
	struct gltf_look *looks; /* per material */
	uint32_t *images; /* per texture: of the mesh; TCS_NONE: not yet */
};

/* An array of numbers in a buffer. */
struct gltf_numbers {
	const unsigned char *at;
	size_t count, stride;
	int component; /* 5121, 5123, 5125, 5126 */
};

enum {
	GLTF_UNSIGNED_BYTE = 5121,
	GLTF_UNSIGNED_SHORT = 5123,
	GLTF_UNSIGNED_INT = 5125,
	GLTF_FLOAT = 5126
};

extern const char gltf_broken[]; /* the problem of most */

/* Set the problem, unless there is one; TCS_OK. */
enum tcs_status gltf_refuse(struct gltf *gltf, const char *problem);

/* A whole number; `otherwise` where there is none or it is none. */
size_t gltf_number(const json_t *object, const char *key, size_t otherwise);
/* `count` numbers; *out stays where they are not there. */
void gltf_array(
	const json_t *object, const char *key, double *out, size_t count);
/* An element of an array of the document; NULL. */
const json_t *gltf_element(
	const struct gltf *gltf, const char *array, size_t index);

/* ---- mesh_gltf_buffer.c --------------------------------------------------- */

/* An accessor of `width` components, all of whose bytes are there. */
enum tcs_status gltf_numbers_find(struct gltf *gltf, size_t index, size_t width,
	struct gltf_numbers *out) TCS_CHECKED;
uint32_t gltf_whole_at(const struct gltf_numbers *numbers, size_t index);
double gltf_float_at(const unsigned char *at);

/* The bytes of a view; borrowed. */
enum tcs_status gltf_view_find(
	struct gltf *gltf, size_t index, struct mesh_bytes *out) TCS_CHECKED;

/* Those of a "data:" URI; the caller frees. */
enum tcs_status gltf_data_decode(
	struct gltf *gltf, const char *uri, struct mesh_bytes *out) TCS_CHECKED;

/* ---- mesh_gltf_material.c ------------------------------------------------- */

/* All materials of the document, with their images. */
enum tcs_status gltf_materials_take(struct gltf *gltf) TCS_CHECKED;

/* Where the images of a material lie on a primitive: *out counts none where it
 * has no image, or no coordinates. */
enum tcs_status gltf_texcoords_find(struct gltf *gltf, const json_t *attributes,
	uint32_t material, struct gltf_numbers *out) TCS_CHECKED;
struct tcs_texcoord gltf_texcoord_at(const struct gltf *gltf, uint32_t material,
	const struct gltf_numbers *texcoords, size_t index);

#endif
