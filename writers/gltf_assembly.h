/*
 * The JSON of a glTF 2.0, assembled by tinygltf.
 *
 * The binary data is the caller's: the assembly knows its views and accessors
 * by number and place only. Objects are turned into JSON in small batches that
 * wait in spools, so that memory does not grow with the city.
 *
 * This is the border to C++: no exception passes it, running out of memory is
 * TCS_NO_MEMORY, and text that is not UTF-8 is TCS_BAD_INPUT.
 *
 * source: glTF 2.0; EXT_texture_webp; EXT_mesh_gpu_instancing;
 * EXT_instance_features; EXT_mesh_features; EXT_structural_metadata;
 * 3D Metadata Semantic Reference (ID, NAME).
 */
#ifndef TESSERA_GLTF_ASSEMBLY_H
#define TESSERA_GLTF_ASSEMBLY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "fault.h"
#include "gltf_column.h"
#include "gltf_material.h"

#ifdef __cplusplus
extern "C" {
#define GLTF_NOEXCEPT noexcept
#else
#define GLTF_NOEXCEPT
#endif

struct gltf_assembly; /* opaque; one thread at a time */

enum { ASSEMBLY_SETS = 2 }; /* feature-id sets: object, surface */

enum assembly_component {
	ASSEMBLY_UNSIGNED_SHORT = 5123,
	ASSEMBLY_UNSIGNED_INT = 5125,
	ASSEMBLY_FLOAT = 5126,
};

struct assembly_accessor {
	uint32_t view;
	uint32_t count;
	uint64_t offset; /* in the view, bytes; below 2 GiB */
	enum assembly_component component;
};

struct assembly_primitive {
	struct assembly_accessor indices;
	uint32_t material;
	bool is_textured; /* it has the mesh's texture coordinates */
};

/*
 * One mesh, whose primitives share their vertices. Without ids in the first
 * set it has no features.
 */
struct assembly_mesh {
	struct assembly_accessor positions;
	struct assembly_accessor normals; /* count 0: none */
	struct assembly_accessor texcoords; /* count 0: none */
	struct assembly_accessor sets[ASSEMBLY_SETS]; /* feature ids */
	uint32_t feature_counts[ASSEMBLY_SETS]; /* different ids in each */
	float lower[3], upper[3]; /* of the positions */
	const struct assembly_primitive *primitives;
	size_t primitive_count;
};

/* A shared mesh below the node of an object. */
struct assembly_child {
	const char *name;
	uint32_t mesh;
	uint32_t rows[ASSEMBLY_SETS]; /* feature ids, for the extras */
	double matrix[16]; /* column by column */
};

/* A shared mesh in many places; an element of each accessor per place. */
struct assembly_instances {
	uint32_t mesh;
	struct assembly_accessor translations, rotations, scales;
	struct assembly_accessor sets[ASSEMBLY_SETS]; /* feature ids */
	uint32_t feature_counts[ASSEMBLY_SETS]; /* different ids in each */
};

enum assembly_target {
	ASSEMBLY_ANYTHING = 0,
	ASSEMBLY_VERTICES = 34962,
	ASSEMBLY_INDICES = 34963,
};

struct assembly_view {
	uint64_t offset, length; /* in the buffer, bytes */
	uint32_t stride; /* 0: tightly packed */
	enum assembly_target target;
};

/* One column of a property table. */
struct assembly_property {
	const char *id, *name;
	const char *description; /* NULL: none */
	const char *semantic; /* NULL: none */
	enum column_type type;
	bool required;
	bool has_gaps; /* noData applies */
	uint32_t values_view;
	uint32_t offsets_view; /* strings */
	bool wide_offsets;
};

struct assembly_root {
	const char *generator;
	const char *name; /* of the root node */
	double matrix[16]; /* of the root node, column by column */
	double origin[3]; /* in units of the coordinate system */
	bool origin_is_translation;
	const char *crs; /* its name as given; "": unknown */
	int32_t epsg, epsg_up; /* 0: unknown */
	const char *buffer_uri; /* ASCII; NULL: the BIN chunk of a GLB */
	uint64_t buffer_size; /* 0: no buffer */
};

/*
 * `beside`: where the spools live, see gltf_spool.h. NULL with the fault
 * filled on failure.
 */
struct gltf_assembly *assembly_new(
	const char *beside, struct tcs_fault *fault) GLTF_NOEXCEPT;
void assembly_free(struct gltf_assembly *assembly) GLTF_NOEXCEPT;

/* One node under the root. `mesh` may be NULL. */
enum tcs_status assembly_add_node(struct gltf_assembly *assembly,
	const char *name, const struct assembly_mesh *mesh,
	const struct assembly_child *children, size_t child_count,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;

/* A mesh for children and instances; its number in *mesh_number. */
enum tcs_status assembly_add_mesh(struct gltf_assembly *assembly,
	const char *name, const struct assembly_mesh *mesh,
	uint32_t *mesh_number,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;

/* One node under the root for all of them. */
enum tcs_status assembly_add_instances(struct gltf_assembly *assembly,
	const char *name, const struct assembly_instances *instances,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;

/* Views, materials, images, textures, tables are numbered from 0 in the order they come. */
enum tcs_status assembly_add_view(struct gltf_assembly *assembly,
	const struct assembly_view *view,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;
enum tcs_status assembly_add_material(struct gltf_assembly *assembly,
	const struct material_look *look,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;
enum tcs_status assembly_add_image(struct gltf_assembly *assembly,
	uint32_t view, const char *mime, const char *name,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;
enum tcs_status assembly_add_texture(struct gltf_assembly *assembly,
	uint32_t image, enum texture_wrap wrap, bool is_webp,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;
enum tcs_status assembly_add_table(struct gltf_assembly *assembly,
	const char *class_name, uint32_t row_count,
	const struct assembly_property *properties, size_t property_count,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;

/*
 * Complete the JSON; its size in bytes in *json_size. Nothing may be added
 * afterwards. With no node at all the scene is empty.
 */
enum tcs_status assembly_finish(struct gltf_assembly *assembly,
	const struct assembly_root *root, uint64_t *json_size,
	struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;

/* Write the JSON to a stream whose name is for messages. */
enum tcs_status assembly_pour(struct gltf_assembly *assembly, FILE *to,
	const char *name, struct tcs_fault *fault) GLTF_NOEXCEPT TCS_CHECKED;

#ifdef __cplusplus
}
#endif

#endif
