/*
 * How sound a welded mesh is, and which triangles were turned over.
 */
#ifndef TESSERA_COMPARE_HEALTH_H
#define TESSERA_COMPARE_HEALTH_H

#include "compare_match.h"

struct mesh_health {
	size_t open; /* edges of one triangle */
	size_t non_manifold; /* edges of more than two */
	size_t misaligned; /* edges of two that wind against each other */
	size_t degenerate; /* triangles thinner than a micrometre */
	size_t duplicate; /* triangles with the corners of an earlier one */
};

/* Fails with TCS_NO_MEMORY. */
enum tcs_status mesh_health_measure(const struct component_set *set,
	struct mesh_health *health, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Triangles after whose centre lies farther, by more than eps, from what faces
 * their way of the component they come from than from all of it. Fails with
 * TCS_NO_MEMORY, TCS_SYSTEM.
 */
enum tcs_status count_flipped(const struct compare_side *before,
	const struct compare_side *after, const struct compare_match *match,
	double eps, size_t *flipped, struct tcs_fault *fault) TCS_CHECKED;

#endif
