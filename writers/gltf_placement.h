/*
 * Where an instance stands, as a glTF node says it.
 *
 * source: ISO 19136 / CityGML 2.0, 8.2 (implicit geometry); glTF 2.0, 5.25
 * (node.matrix is a translation, a rotation and a scale).
 */
#ifndef TESSERA_GLTF_PLACEMENT_H
#define TESSERA_GLTF_PLACEMENT_H

#include <stdbool.h>

#include "frame.h"
#include "tcs.h"

/*
 * The matrix, column by column, from coordinates of the prototype to metres of
 * the frame. False when a node cannot say it: sheared, flat, or too far away
 * for 32-bit floats.
 */
bool placement_matrix(double matrix[16], const struct frame *frame,
	const struct tcs_instance *instance);

/* The same in three parts; the rotation is a unit quaternion x, y, z, w. */
struct placement {
	float translation[3];
	float rotation[4];
	float scale[3]; /* one is negative when the matrix mirrors */
};

struct placement placement_split(const double matrix[16]);

#endif
