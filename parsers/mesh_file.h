/*
 * A mesh from a file beside the document: glTF 2.0 (.gltf, .glb) or Wavefront
 * OBJ, as far as its shape, its plain colours and the images of these go.
 * Animations, skins and compressed or sparse arrays are not read.
 *
 * source: glTF 2.0 (ISO/IEC 12113) 3 and 4, KHR_texture_transform; Wavefront's
 * Advanced Visualizer manual, appendix B1.
 */
#ifndef TESSERA_MESH_FILE_H
#define TESSERA_MESH_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "folder.h"
#include "tcs.h"

struct mesh_face {
	uint32_t first_corner, corner_count; /* at least three */
	uint32_t material; /* TCS_NONE: none */
	bool textured; /* the material has an image, and every corner a place
	                  in it */
};

struct mesh_material {
	float diffuse[3]; /* sRGB 0…1 */
	float transparency; /* 0 opaque … 1 clear */
	size_t name; /* in `names` */
	uint32_t image; /* TCS_NONE: none */
};

struct mesh_image {
	size_t uri; /* in `names`: relative to the folder, and for an image
	               within the mesh's file a name made of that */
	size_t mime; /* in `names` */
	uint32_t wrap; /* enum tcs_wrap */
	size_t first_byte; /* in `bytes`: the encoded image, where it is */
	size_t byte_count; /* within the mesh's file; else 0 */
};

/* Metres, z up. All zero is empty. */
struct mesh_file {
	TCS_ARRAY(struct tcs_point) points;
	TCS_ARRAY(uint32_t) corners; /* points, in the order of the faces */
	TCS_ARRAY(struct tcs_texcoord)
	texcoords; /* one for each corner; not
	                                             finite: none */
	/* In the order of their materials, those without last; of a material,
	   the plain ones first. */
	TCS_ARRAY(struct mesh_face) faces;
	TCS_ARRAY(struct mesh_material) materials;
	TCS_ARRAY(struct mesh_image) images;
	TCS_ARRAY(char) names; /* NUL-terminated each */
	TCS_ARRAY(unsigned char) bytes;
	const char *lacks; /* NULL, or static text: what could not be had */
};

void mesh_file_release(struct mesh_file *mesh);

/* Where the file and those it names are, and how large each may be; points
 * and corners may not take more either. */
struct mesh_source {
	struct folder *folder; /* NULL: only bytes at hand can be read */
	const char *path; /* within the folder */
	uint64_t limit; /* bytes */
};

/* NULL if files of that name are read, or static text that says what they are
 * instead. */
const char *mesh_kind_problem(const char *path);

/*
 * Fill the empty mesh. *problem is NULL, or static text that says why the file
 * cannot be had or used. Fails with TCS_NO_MEMORY and TCS_SYSTEM only.
 */
enum tcs_status mesh_read(struct mesh_file *mesh,
	const struct mesh_source *source, const char **problem,
	struct tcs_fault *fault) TCS_CHECKED;

/* ---- of the readers ---------------------------------------------------------- */

/* The bytes of one file; `at` is owned, a NUL stands behind. */
struct mesh_bytes {
	unsigned char *at;
	size_t count;
};

/* Read a file that the mesh's file names, relative to itself. */
enum tcs_status mesh_bytes_read(struct mesh_bytes *bytes,
	const struct mesh_source *source, const char *name,
	const char **problem, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The path in the folder of a file that the file `path` of it names: beside
 * that, "." and ".." resolved as far as they stay in the folder. Absolute names
 * and addresses stay what they are. The caller frees; NULL without memory.
 */
char *mesh_path_beside(const char *path, const char *name);

/* Append a point, or a face of the last `count` corners that were added, which
 * have a place in an image or NULL; *problem is set when that passes the
 * limit. */
enum tcs_status mesh_add_point(struct mesh_file *mesh,
	const struct mesh_source *source, const struct tcs_point *point,
	const char **problem, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status mesh_add_corner(struct mesh_file *mesh,
	const struct mesh_source *source, uint32_t point,
	const struct tcs_texcoord *texcoord, const char **problem,
	struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status mesh_add_face(struct mesh_file *mesh, uint32_t count,
	uint32_t material, struct tcs_fault *fault) TCS_CHECKED;

/* A grey material of that name, to be filled. */
enum tcs_status mesh_add_material(struct mesh_file *mesh, const char *name,
	size_t length, struct mesh_material **out,
	struct tcs_fault *fault) TCS_CHECKED;

/* An image by its path in the folder, and, unless NULL, its bytes. *problem is
 * set when those of all images pass the limit. */
enum tcs_status mesh_add_image(struct mesh_file *mesh,
	const struct mesh_source *source, const char *uri, const char *mime,
	uint32_t wrap, const struct mesh_bytes *bytes, uint32_t *out,
	const char **problem, struct tcs_fault *fault) TCS_CHECKED;

enum tcs_status mesh_parse_gltf(struct mesh_file *mesh,
	const struct mesh_source *source, const struct mesh_bytes *bytes,
	const char **problem, struct tcs_fault *fault) TCS_CHECKED;
enum tcs_status mesh_parse_obj(struct mesh_file *mesh,
	const struct mesh_source *source, const struct mesh_bytes *bytes,
	const char **problem, struct tcs_fault *fault) TCS_CHECKED;

/* The materials of an OBJ; `source` is their own file. */
enum tcs_status mesh_parse_mtl(struct mesh_file *mesh,
	const struct mesh_source *source, const struct mesh_bytes *bytes,
	const char **problem, struct tcs_fault *fault) TCS_CHECKED;

#endif
