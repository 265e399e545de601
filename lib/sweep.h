/*
 * Triangulation of a simple polygon with holes by one plane sweep, in
 * n log n steps.
 *
 * source: S. Hertel and K. Mehlhorn, Fast triangulation of simple polygons,
 * 1983. On top of it every vertex is tested against the edges next to it, with
 * exact signs, so that rings that cross or touch are noticed.
 */
#ifndef TESSERA_SWEEP_H
#define TESSERA_SWEEP_H

#include "planar.h"
#include "sweep_status.h"

/* A vertex by its place in the sweep. */
struct sweep_event {
	double x, y;
	uint32_t vertex;
};

/* A vertex of the border between what is triangulated and what is not. */
struct sweep_link {
	uint32_t vertex;
	uint32_t down, up;
};

/* Scratch memory, reused; all zero is empty. */
struct sweep {
	struct sweep_status status;
	TCS_ARRAY(struct sweep_event) events;
	TCS_ARRAY(struct sweep_event) sorted; /* room for the sort */
	TCS_ARRAY(uint32_t) edge_interval;
	TCS_ARRAY(struct sweep_link) links; /* 0 is none */
	double area; /* twice, of the triangles so far */
};

/*
 * Append the triangles, all counterclockwise and of positive area, and set
 * *simple; or find that the polygon is not simple, where nothing is appended.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status sweep_run(struct sweep *sweep, const struct planar *polygon,
	struct triangle_list *out, bool *simple,
	struct tcs_fault *fault) TCS_CHECKED;

/* Give back what a large polygon took; `out` is the caller's. */
void sweep_trim(struct sweep *sweep);
void sweep_release(struct sweep *sweep);

/* Sort by x, then y, then vertex. `room` is as long as `events`. */
void sweep_sort(
	struct sweep_event *events, size_t count, struct sweep_event *room);

#endif
