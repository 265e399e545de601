/*
 * From one object of the stream to its mesh: choose the level of detail, place
 * what is an instance, paint, and note what is left out.
 */
#ifndef TESSERA_GLTF_CONVERT_H
#define TESSERA_GLTF_CONVERT_H

#include <stdbool.h>
#include <stdint.h>

#include "byte_index.h"
#include "frame.h"
#include "gltf_mesh.h"
#include "lod_select.h"
#include "report.h"
#include "tcs.h"

enum convert_instances {
	INSTANCES_BAKED, /* drawn where they stand, in the object's mesh */
	INSTANCES_NODES, /* nodes that share the prototype's mesh */
	INSTANCES_GPU, /* attributes of one node of the prototype's mesh */
};

struct convert_settings {
	const char *theme; /* NULL: the first one of each object */
	bool drop_textures; /* colour by material and class only */
	int lod; /* a level or SELECT_… */
	enum convert_instances instances;
	enum mesh_normals normals;
	double crease_cosine; /* of smooth normals */
	uint64_t triangle_limit; /* in one object; 0: none */
	struct frame frame;
};

/* Prototype `number` of the stream, for as long as the conversion runs. */
struct prototype_source {
	const struct tcs_object *(*get)(const void *context, uint32_t number);
	const void *context;
};

/* Memory of one worker. All zero is ready; reused from object to object. */
struct converter {
	struct selection selection;
	struct byte_index drawn; /* ids of polygons, where some are shared */
	TCS_ARRAY(struct mesh_paint) paints; /* per polygon; or TCS_NONE */
};

/*
 * Fill `mesh` (cleared first) from `object` and report what has no place in
 * it. Instances that cannot be nodes are always drawn where they stand. Fails with TCS_NO_MEMORY or TCS_LIMIT.
 */
enum tcs_status convert_object(struct converter *converter,
	const struct convert_settings *settings,
	const struct prototype_source *prototypes,
	const struct tcs_object *object, struct mesh *mesh,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Fill `mesh` from a prototype in its own coordinates, for instances that share
 * it; what has no class of its own is coloured as one of `class`.
 */
enum tcs_status convert_prototype(struct converter *converter,
	const struct convert_settings *settings,
	const struct tcs_object *prototype, uint32_t class, struct mesh *mesh,
	struct report *report, struct tcs_fault *fault) TCS_CHECKED;

void converter_release(struct converter *converter);

#endif
