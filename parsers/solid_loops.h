/*
 * The edges around a face as rings.
 */
#ifndef TESSERA_SOLID_LOOPS_H
#define TESSERA_SOLID_LOOPS_H

#include "planar.h"
#include "solid_outline.h"

/* How points of a face lie in its plane, counterclockwise from outside. */
struct solid_view {
	unsigned axis; /* 0 to 2: the one left out */
	bool mirrored;
};

struct solid_view solid_view_of(const struct solid_plane *plane, bool up);
struct planar_point solid_view_at(struct solid_view view, struct tcs_point at);

/*
 * Walk the rims from `first` to `end`, those of one face: outline->loops, holes
 * with their owners. No loop comes to a point twice. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status solid_loops_walk(struct solid_outline *outline,
	struct solid_view view, size_t first, size_t end,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
