/*
 * Texture coordinates as a function of place: a triangle with coordinates at
 * its corners gives those of every point of its plane.
 */
#ifndef TESSERA_TEXTURE_PLANE_H
#define TESSERA_TEXTURE_PLANE_H

#include "tcs.h"

/*
 * The coordinates at `at`, projected on the plane of the corners; those of the
 * nearest corner where the triangle is too thin to tell.
 */
struct tcs_texcoord texture_plane_at(const struct tcs_point corners[3],
	const struct tcs_texcoord coordinates[3], struct tcs_point at);

#endif
