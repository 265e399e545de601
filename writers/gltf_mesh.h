/*
 * The mesh of one object as glTF wants it: 32-bit positions and normals, a
 * feature per vertex, triangles grouped by material.
 */
#ifndef TESSERA_GLTF_MESH_H
#define TESSERA_GLTF_MESH_H

#include <stdbool.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "frame.h"
#include "tcs.h"

enum mesh_normals {
	MESH_FLAT, /* one normal per polygon; per triangle where it is bent */
	MESH_SMOOTH, /* averaged within one surface, up to the crease angle */
	MESH_PLAIN, /* none: viewers shade flat by themselves */
};

/*
 * What a polygon is painted with: its class's colour, an entry of the stream's
 * materials or a texture of the glTF, seen from one side or both.
 */
#define PAINT_DOUBLE_SIDED UINT32_C(0x80000000)
#define PAINT_MATERIAL UINT32_C(0x40000000)
#define PAINT_TEXTURE UINT32_C(0x20000000) /* neither: a class */
#define PAINT_NUMBER UINT32_C(0x1fffffff)

/* The paint of a polygon, and the image over it where there is one. */
struct mesh_paint {
	uint32_t paint; /* also without the image */
	uint32_t image; /* entry of the stream's images; TCS_NONE */
	/* One per vertex of the polygon; within 32-bit floats. */
	const struct tcs_texcoord *texcoords;
};

/* A run of indices with one paint. */
struct mesh_run {
	uint32_t image; /* as in mesh_paint */
	uint32_t paint;
	uint32_t first; /* in indices */
	uint32_t count;
};

struct mesh_point {
	float x, y, z;
};

/* A prototype that stays a mesh of its own. */
struct mesh_instance {
	uint32_t feature; /* that owns the instance */
	uint32_t prototype;
	uint32_t class; /* for the colour of what has no other */
	double matrix[16]; /* placement_matrix */
};

TCS_ARRAY_TYPE(mesh_indices, uint32_t);
TCS_ARRAY_TYPE(mesh_runs, struct mesh_run);

/* All zero is empty. The scratch arrays keep their room between polygons. */
struct mesh {
	TCS_ARRAY(float) positions; /* 3 per vertex, metres */
	TCS_ARRAY(float) normals; /* 3 per vertex, unit; empty when plain */
	/* 2 per vertex, from the upper left; empty while no image is used. */
	TCS_ARRAY(float) texcoords;
	TCS_ARRAY(uint32_t) features; /* per vertex: index in the object */
	struct mesh_indices indices; /* three a triangle */
	struct mesh_runs runs; /* one per polygon, then one per paint */
	TCS_ARRAY(struct mesh_instance) instances; /* not in the arrays */
	uint64_t triangle_limit; /* 0: none */
	uint64_t flat_triangles; /* left out: no area */
	TCS_ARRAY(struct mesh_point) local; /* scratch: the polygon, metres */
	TCS_ARRAY(uint32_t) used; /* scratch: the vertex it became */
	bool mirrored; /* scratch: the polygon arrived mirror-inverted */
	struct mesh_indices sorted; /* scratch */
};

/* How a polygon reaches the frame: by an instance, or NULL directly. */
struct mesh_place {
	const struct frame *frame; /* NULL: it stays where it is */
	const struct tcs_instance *instance;
};

enum mesh_outcome {
	MESH_DRAWN,
	MESH_NO_AREA, /* every triangle is flat */
	MESH_TOO_FAR, /* a position does not fit 32-bit floats */
};

/*
 * Append one polygon of `object` for the feature `feature`. What came of it
 * stands in *outcome. Fails with TCS_NO_MEMORY, or with TCS_LIMIT past
 * triangle_limit.
 */
enum tcs_status mesh_add_polygon(struct mesh *mesh,
	const struct tcs_object *object, const struct tcs_polygon *polygon,
	const struct mesh_place *place, uint32_t feature,
	const struct mesh_paint *paint, enum mesh_normals normals,
	enum mesh_outcome *outcome, struct tcs_fault *fault) TCS_CHECKED;

/* Turn runs into one per image and paint, ordered by both. */
enum tcs_status mesh_group(
	struct mesh *mesh, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Replace flat normals by the average over the neighbours at the same
 * position and of the same feature whose normals differ by less than the angle
 * whose cosine is given.
 */
enum tcs_status mesh_smooth(struct mesh *mesh, double crease_cosine,
	struct tcs_fault *fault) TCS_CHECKED;

/* The box of the positions; there must be some. */
void mesh_bounds(const struct mesh *mesh, float lower[3], float upper[3]);

/* The number of different features. Uses the scratch arrays. */
enum tcs_status mesh_count_features(struct mesh *mesh, size_t feature_count,
	uint32_t *out, struct tcs_fault *fault) TCS_CHECKED;

/* Forget the content, keep room and limit. */
void mesh_clear(struct mesh *mesh);
void mesh_release(struct mesh *mesh);

#endif
