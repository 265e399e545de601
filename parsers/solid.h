/*
 * Solids with plane faces, and their booleans. Knows nothing of IFC.
 *
 * A solid is a list of faces; a face is a polygon in a plane: an outer ring,
 * counterclockwise as seen from outside, and holes the other way round. Faces
 * share no points: equal positions, bit for bit, are the same point. A solid
 * may have many shells and cavities. Lengths are metres; coordinates may be far
 * from 0.
 *
 * Booleans. The planes of all faces cut the space into convex cells; a cell is
 * inside a solid where the faces around it say so; what comes out is the
 * border between the cells that belong to the result and those that do not.
 * Which side of a plane a corner of a cell lies on is decided exactly, so the
 * border is closed whatever the input does. Faces within `tolerance` of a
 * common plane are taken to lie in it, corners that come out within it of one
 * of the input's are that corner, and details smaller than it may be lost.
 * Nothing else is rounded but the coordinates of new corners, to doubles.
 *
 * source: B. Naylor, J. Amanatides and W. Thibault, Merging BSP trees yields
 * polyhedral set operations, 1990, for cells instead of faces; G. Bernstein and
 * D. Fussell, Fast, exact, linear booleans, 2009, for corners as triples of
 * planes.
 */
#ifndef TESSERA_SOLID_H
#define TESSERA_SOLID_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"
#include "tcs.h"

#define SOLID_TOLERANCE 1e-5 /* metres */
#define SOLID_NO_FACE UINT32_MAX

struct solid_face {
	uint32_t first_ring, ring_count; /* the outer ring first */
	uint32_t label; /* the caller's; what is left of a face keeps it */
	/* Set in results, of no meaning in operands: */
	uint32_t origin; /* 0: of the host; 1 + i: of tool i; behind the
	                    tools: of half-space i */
	uint32_t face; /* its number there; SOLID_NO_FACE: of none */
};

/* All zero is the empty solid. */
struct solid {
	TCS_ARRAY(struct tcs_point) points; /* ring by ring */
	TCS_ARRAY(uint32_t) ring_ends; /* in points, of each ring */
	TCS_ARRAY(struct solid_face) faces; /* their rings in order */
};

void solid_release(struct solid *solid);
void solid_clear(struct solid *solid); /* keeps the room */

/* The points of a ring; NULL where it has none. */
const struct tcs_point *solid_ring(
	const struct solid *solid, size_t ring, size_t *count);

/*
 * Append a face: `points` are those of its rings in order, `rings` counts the
 * points of each, and no ring repeats its first point. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status solid_add_face(struct solid *solid,
	const struct tcs_point *points, const uint32_t *rings,
	size_t ring_count, uint32_t label, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Append a prism: a polygon as above, in a plane, and the same polygon moved by
 * `along`, which need not be normal to it. Whatever the winding of its rings,
 * the faces look outwards. Faces: the polygon, the moved one, then one for each
 * edge in the order of the points (it leads from that point to the next of the
 * ring). Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_add_prism(struct solid *solid,
	const struct tcs_point *points, const uint32_t *rings,
	size_t ring_count, struct tcs_point along, uint32_t label,
	struct tcs_fault *fault) TCS_CHECKED;

struct solid_measure {
	double volume; /* negative where the faces look inwards */
	double area;
	struct tcs_point lower, upper; /* of the points; 0 without any */
	bool closed; /* every edge is met by one in the other direction */
};

/*
 * Faces need not be plane. The volume is that of the cones from the box's
 * centre to the faces, and exact but for rounding when the solid is closed.
 * Takes n log n steps. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_measure(const struct solid *solid,
	struct solid_measure *out, struct tcs_fault *fault) TCS_CHECKED;

/* ---- booleans ---------------------------------------------------------------- */

enum solid_operation {
	SOLID_DIFFERENCE, /* host without any of the tools */
	SOLID_INTERSECTION, /* host within at least one of the tools */
	SOLID_UNION, /* host and all tools */
};

/* Everything on the side of a plane that the normal points to. */
struct solid_half_space {
	struct tcs_point point; /* of the plane */
	struct tcs_point normal; /* of any length but 0 */
	uint32_t label; /* for the faces that it cuts */
};

/*
 * What to do, all at once and in no order: the operation on the host and the
 * tools, then every half-space taken away from what it gives. The tools may
 * overlap each other. The same result as one after the other, and quicker: a
 * slab with its 300 openings is one task.
 *
 * To keep a half-space instead, turn its normal over. A half-space with
 * a boundary is a tool: a prism over the boundary, higher than the host, from
 * which a task of its own has taken the half-space of the other side away.
 */
struct solid_task {
	enum solid_operation operation;
	const struct solid *host;
	const struct solid *const *tools;
	size_t tool_count;
	const struct solid_half_space *half_spaces;
	size_t half_space_count;
	double tolerance; /* 0: SOLID_TOLERANCE */
};

enum solid_outcome {
	SOLID_DONE,
	SOLID_EMPTY, /* nothing is left, and rightly so */
	SOLID_OPEN, /* the host is not closed: its faces are cut, but what the
	               cuts laid open has no faces */
	SOLID_REFUSED, /* see `reason`; the result is the host as it was */
};

/* What is wrong with a tool; one that is used has no fault. */
enum solid_tool_fault {
	SOLID_TOOL_SOUND,
	SOLID_TOOL_OPEN, /* not closed: left out */
	SOLID_TOOL_FLAT, /* no volume: left out */
};

struct solid_report {
	enum solid_outcome outcome;
	const char *reason; /* static text; NULL unless refused */
	double volume; /* of the result */
	double host_volume; /* as it should be: positive */
	bool turned; /* faces of the host looked inwards: taken turned over */
	bool crossing; /* the host's faces cross or overlap one another */
	size_t tools_left_out; /* those with a fault */
	size_t tools_turned; /* those whose faces looked inwards */
};

struct solid_cutter; /* scratch memory; one per thread, reused */

struct solid_cutter *solid_cutter_new(void); /* NULL without memory */
void solid_cutter_free(struct solid_cutter *cutter);

/*
 * Carry the task out. `out` is overwritten and must be none of the operands.
 * `tool_faults` has room for one enum solid_tool_fault a tool, or is NULL.
 *
 * The result's faces are plane up to the tolerance, none lies next to another
 * of the same origin, face and plane, and every point on an edge of two faces
 * is a corner of both: it is closed point by point. Faces where host and tool
 * coincide are the host's. No face of the input keeps a corner that lies
 * within a straight edge of the result.
 *
 * Operands may be non-convex, have many shells and cavities, overlap
 * themselves (what is inside more than once is inside), have faces that are
 * not plane (they are triangulated) or that repeat points. A face with no area
 * is ignored. Points that are not finite are refused.
 *
 * Deterministic. Takes about n log n steps for what buildings are made of, and
 * memory in proportion to the cells; refused where those are too many. Fails
 * with TCS_NO_MEMORY only.
 */
enum tcs_status solid_cut(struct solid_cutter *cutter,
	const struct solid_task *task, struct solid *out,
	struct solid_report *report, enum solid_tool_fault *tool_faults,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
