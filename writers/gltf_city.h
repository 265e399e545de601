/*
 * A city on its way into a glTF: takes objects in order, spools their numbers,
 * and writes the file when all have come.
 *
 * Vertices and indices of many objects share buffer views of up to CITY_VIEW
 * bytes, so that a viewer loads few buffers. Feature-id set 0 counts objects,
 * set 1 every feature of their trees; attributes of an object stand in the
 * table of set 0, those of its parts and surfaces in that of set 1.
 */
#ifndef TESSERA_GLTF_CITY_H
#define TESSERA_GLTF_CITY_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "gltf_assembly.h"
#include "gltf_material.h"
#include "gltf_mesh.h"
#include "gltf_spool.h"
#include "gltf_table.h"
#include "gltf_texture.h"
#include "output.h"
#include "report.h"
#include "tcs.h"

#define CITY_VIEW (UINT64_C(64) << 20) /* bytes; one object may exceed it */

/* The buffer's parts, in the order of the file. */
enum city_part {
	CITY_POSITIONS,
	CITY_NORMALS,
	CITY_TEXCOORDS,
	CITY_IDS,
	CITY_ROTATIONS,
	CITY_INDICES,
	CITY_METADATA,
	CITY_IMAGES,
	CITY_PARTS,
};

struct city_view {
	enum city_part part;
	uint64_t start, end; /* in the part's spool */
};

/* An instance, drawn by the GPU among the others of its mesh. */
struct shared_stand {
	double matrix[16];
	uint32_t rows[ASSEMBLY_SETS]; /* of its object and its feature */
};

/* A prototype that is a mesh of its own, coloured for one class. */
struct shared_mesh {
	uint32_t mesh; /* of the glTF; TCS_NONE: nothing to see */
	char *name; /* owned */
	TCS_ARRAY(struct shared_stand) stands; /* if on the GPU */
};

struct shared_meshes {
	bool on_gpu; /* else a node per instance */
	struct byte_index keys; /* prototype and class; same numbers as … */
	TCS_ARRAY(struct shared_mesh) all;
};

struct city {
	struct gltf_assembly *assembly;
	struct spool parts[CITY_PARTS];
	TCS_ARRAY(struct city_view) views;
	uint32_t open[CITY_PARTS]; /* the part's last view; TCS_NONE */
	struct materials materials;
	struct textures textures;
	bool drop_textures;
	struct tcs_palette palette; /* all entries so far, without bytes */
	struct table tables[ASSEMBLY_SETS];
	struct shared_meshes shared;
	TCS_ARRAY(struct assembly_primitive) primitives; /* scratch */
	TCS_ARRAY(struct assembly_child) children; /* scratch */
};

struct city_settings {
	const char *beside; /* where spools live, see gltf_spool.h */
	const char *image_folder; /* NULL: none */
	uint64_t image_limit; /* bytes of one image */
	uint32_t column_limit; /* of attributes in a table */
	bool drop_textures;
	bool gpu_instances; /* what is shared: attributes, not nodes */
};

/* On failure too the city must be released. */
enum tcs_status city_begin(struct city *city,
	const struct city_settings *settings,
	struct tcs_fault *fault) TCS_CHECKED;

/* Images that the palette brings along are taken at once. */
enum tcs_status city_add_palette(struct city *city,
	const struct tcs_palette *palette, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * The meshes that the object's instances share were added before; see
 * gltf_shared.h. The mesh's scratch arrays are used. Fails with TCS_LIMIT among
 * others.
 */
enum tcs_status city_add_object(struct city *city,
	const struct tcs_object *object, struct mesh *mesh,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

/* Append all of a mesh but its feature ids. */
enum tcs_status city_add_mesh(struct city *city, struct mesh *mesh,
	struct assembly_mesh *out, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * All objects have come: complete tables and JSON. Fills root->buffer_size;
 * *json_size is that of the JSON.
 */
enum tcs_status city_finish(struct city *city, struct assembly_root *root,
	uint64_t *json_size, struct tcs_fault *fault) TCS_CHECKED;

/* Write a GLB. Fails with TCS_LIMIT past 4 GiB, which GLB cannot express. */
enum tcs_status city_write_glb(struct city *city, uint64_t json_size,
	uint64_t buffer_size, struct output *out,
	struct tcs_fault *fault) TCS_CHECKED;

/* Write a .gltf and the .bin that it names. */
enum tcs_status city_write_pair(struct city *city, struct output *json,
	struct output *bin, struct tcs_fault *fault) TCS_CHECKED;

void city_release(struct city *city);

#endif
