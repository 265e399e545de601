/*
 * Prototypes as meshes that many instances share.
 *
 * Feature ids of a mesh would be the same for all its instances, so a shared
 * mesh has none: the instances have, as nodes in their names and extras, or on
 * the GPU as attributes.
 *
 * source: EXT_mesh_gpu_instancing; EXT_instance_features.
 */
#ifndef TESSERA_GLTF_SHARED_H
#define TESSERA_GLTF_SHARED_H

#include <stdbool.h>
#include <stdint.h>

#include "fault.h"
#include "gltf_city.h"
#include "gltf_mesh.h"
#include "report.h"

/* Whether the mesh of this instance's prototype and class was added. */
bool shared_is_there(const struct city *city, const struct mesh_instance *of);

/* Add it; an empty one is remembered as such. */
enum tcs_status shared_add(struct city *city, const struct mesh_instance *of,
	const char *name, struct mesh *mesh, struct report *report,
	struct tcs_fault *fault) TCS_CHECKED;

/* The number of the glTF's mesh for it; TCS_NONE when it is empty. */
uint32_t shared_mesh(const struct city *city, const struct mesh_instance *of);

/* Note the instances of an object, with its rows in the tables. */
enum tcs_status shared_stand(struct city *city, const struct mesh *mesh,
	uint32_t object_row, uint32_t base,
	struct tcs_fault *fault) TCS_CHECKED;

/* All objects have come: one node per shared mesh with its instances. */
enum tcs_status shared_finish(
	struct city *city, struct tcs_fault *fault) TCS_CHECKED;

void shared_release(struct shared_meshes *shared);

#endif
