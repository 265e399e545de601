/*
 * The mesh of one object while it is simplified: what may be collapsed, what
 * that costs, and doing it.
 *
 * A collapse moves a node into a neighbour of its component, which stays where
 * it is; all vertices of the node move together. Coordinates should be near 0.
 */
#ifndef TESSERA_COLLAPSES_H
#define TESSERA_COLLAPSES_H

#include "cover_watch.h"
#include "crossing_watch.h"
#include "error_watch.h"
#include "half_edges.h"
#include "node_queue.h"
#include "quadric.h"
#include "seams.h"
#include "sheets.h"
#include "volume_watch.h"

struct collapse_settings {
	double base_ratio; /* of the cost of moving a boundary vertex; >= 1 */
	/* What it costs that a contact breaks, a surface vanishes, or a border
	   between surfaces moves, as a collapse does; INFINITY: none may. */
	double contact_cost;
	bool optimal; /* see placement.h; as it began */
	double max_error; /* metres, see error_watch.h; as it began; 0: any */
};

/*
 * Between what there are borders; both borrowed. A feature that leads decides where its
 * border with one that does not is: a window in a wall keeps its outline, but
 * may come forward or go back with the wall. Two charts have a border in one
 * feature, see paint_charts.h, as long as their faces are of the feature that
 * they came with.
 */
struct collapse_regions {
	const bool *leads; /* per feature */
	const uint32_t *charts; /* per triangle of the set; NULL: one */
};

/* A face of the ring around a vertex that moves, as it will be. */
struct ring_face {
	uint32_t face;
	uint32_t nodes[3];
	struct triangle_shape shape; /* its first corner is where it moves */
	struct tcs_point normal; /* twice the area long */
	struct box box; /* where crossings are looked for */
};

/* Planes upright on such a face through its sides, as seam_moves.c asks of many
   points where they are. */
struct ring_sides {
	struct tcs_point inward[3];
	double lengths[3]; /* of those */
	double far; /* of the side that does not move from where the others
	               meet, times its length */
	double square; /* of twice the area */
};

/* What a collapse does to the faces around the node. */
struct strain {
	double before, after; /* twice the area of all, square metres */
	bool turns; /* one of them, by more than 90 degrees */
};

/* Which face will hold a point of a seam; TCS_NONE: it comes open. */
struct seam_move {
	uint32_t hold, face;
	double off; /* metres from the point */
};

/* All zero is empty; reused from object to object. */
struct collapses {
	const struct component_set *set; /* borrowed */
	struct sheets *sheets; /* borrowed; normals of refilled faces change */
	struct seams *seams; /* borrowed */
	struct collapse_regions regions;
	struct half_edges *mesh;
	struct collapse_settings settings;
	TCS_ARRAY(struct tcs_point) positions; /* per node */
	TCS_ARRAY(struct quadric) quadrics; /* per node */
	TCS_ARRAY(struct quadric) borders; /* of nodes where surfaces meet */
	TCS_ARRAY(uint32_t) border_places; /* per node: of them; TCS_NONE */
	TCS_ARRAY(double) areas; /* per node: of its faces, square metres */
	TCS_ARRAY(bool) fixed; /* per node, see placement.h */
	TCS_ARRAY(uint32_t) targets; /* per node: the best; TCS_NONE */
	TCS_ARRAY(uint32_t) features; /* per face: its surface */
	/* Per face: the triangle of the set that it continues; empty while that
	   is its own. */
	TCS_ARRAY(uint32_t) sources;
	TCS_ARRAY(uint32_t) surfaces; /* per feature: its faces left */
	size_t face_count; /* left */
	/* Per contact: for how many it counts; empty until it matters. */
	TCS_ARRAY(float) worths;
	/* Per component: the share that its shape counts for; empty while that
	   is all of it. */
	TCS_ARRAY(float) shares;
	bool wants_worths; /* collapses_run cannot go on without */
	bool is_stale; /* no node is judged under these settings */
	double ground; /* what is no higher stands on it, and goes no higher */
	struct error_watch watch;
	struct crossing_watch crossings;
	struct volume_watch volume;
	struct cover_watch covers;
	struct node_queue queue;
	TCS_ARRAY(struct spoke) spokes; /* scratch */
	TCS_ARRAY(struct queue_entry) candidates; /* scratch */
	/* What collapse_check found out: */
	double broken; /* contacts, each by its worth, surfaces, crossings,
	                  components crushed or uncovered */
	bool breaks_contact; /* some of it is due to contacts */
	TCS_ARRAY(uint32_t) touched; /* the nodes around */
	TCS_ARRAY(struct seam_move) moves;
	TCS_ARRAY(struct ring_face) ring; /* those that stay */
	size_t fan; /* where in `ring` those of the last vertex begin */
	TCS_ARRAY(struct ring_sides) sides; /* scratch: of faces of the ring */
	bool ring_is_open; /* some vertex is on a rim */
	struct strain strain;
	bool is_strained; /* see collapse_is_strained */
	TCS_ARRAY(uint32_t) apart; /* scratch: vertices, if there are twins */
	TCS_ARRAY(uint32_t) leaving; /* scratch: surfaces, one per face */
	TCS_ARRAY(uint32_t) opened; /* scratch: contacts, one per point */
};

/*
 * Begin with the whole mesh of a set split into sheets; seams as found there.
 * All are borrowed, the seams change. Fails with TCS_NO_MEMORY,
 * TCS_LIMIT.
 */
enum tcs_status collapses_begin(struct collapses *work,
	const struct component_set *set, struct sheets *sheets,
	struct seams *seams, const struct collapse_regions *regions,
	const struct collapse_settings *settings,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Collapse the cheapest until at most `faces` are left, or nothing may be
 * collapsed for less than `dearest`, or a contact would break of which it is
 * not known what it is worth. Fails with TCS_NO_MEMORY.
 */
enum tcs_status collapses_run(struct collapses *work, size_t faces,
	double dearest, struct tcs_fault *fault) TCS_CHECKED;

/* Go on under other settings: the next collapses_run judges every node
   anew. */
void collapses_resume(
	struct collapses *work, const struct collapse_settings *settings);

/*
 * Give the faces of feature i to feature homes[i]: borders between surfaces
 * that become one are no longer kept. `collapses_resume` makes it count. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status collapses_dissolve(struct collapses *work,
	const uint32_t *homes, struct tcs_fault *fault) TCS_CHECKED;

/*
 * Take an edge-connected set of faces away: all that has ever been of it, what
 * is gone already does not matter. Seams that they hold come open. Fails with
 * TCS_NO_MEMORY.
 */
enum tcs_status collapses_take_away(struct collapses *work,
	const uint32_t *faces, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* Triangles that take the place of faces, see half_edges_refill. */
struct refill {
	const uint32_t *faces; /* in ascending order */
	size_t face_count;
	const uint32_t *numbers; /* per triangle: the face that it becomes */
	const uint32_t *corners; /* three vertices per triangle */
	const struct tcs_point *places; /* where they are then; NULL: where
	                                   they are now */
	const uint32_t *models; /* per triangle: a face that it continues, as
	                           regards surface and texture */
	size_t count;
	bool adds; /* what stood at the faces stands in what is added now; else
	              it is off unless a triangle is there */
};

/* Put them there. Nothing may be watched (error_watch.h). Fails with
   TCS_NO_MEMORY. */
enum tcs_status collapses_refill(struct collapses *work,
	const struct refill *refill, struct tcs_fault *fault) TCS_CHECKED;

/* Where corner k of a triangle will be. */
static inline struct tcs_point
refill_place(const struct collapses *work, const struct refill *refill,
	size_t triangle, int k)
{
	size_t corner = 3 * triangle + (size_t)k;

	return refill->places
		? refill->places[corner]
		: work->positions.at[work->sheets->vertex_nodes
					     .at[refill->corners[corner]]];
}

/* The triangle of the set that a face that is left continues. */
static inline uint32_t
collapses_source(const struct collapses *work, uint32_t face)
{
	return work->sources.count > 0 ? work->sources.at[face]
				       : work->sheets->face_triangles.at[face];
}

/* The nodes of a face that is left; false when it is gone. */
bool collapses_face(
	const struct collapses *work, uint32_t face, uint32_t nodes[3]);

/* A face as it is; all zero when it is gone. */
static inline struct triangle_shape
collapses_shape(const struct collapses *work, uint32_t face)
{
	struct triangle_shape shape = {0};
	uint32_t nodes[3];

	if (collapses_face(work, face, nodes))
		for (int k = 0; k < 3; k++)
			shape.corner[k] = work->positions.at[nodes[k]];
	return shape;
}

/* Whether a node is not where it was at the beginning. */
bool collapses_is_moved(const struct collapses *work, uint32_t node);

/* Nothing will be collapsed any more: give back what that takes. Faces,
   positions and counts stay. */
void collapses_end(struct collapses *work);

/* The faces are taken, too: give back what they are and where. Their counts
   stay. */
void collapses_release_mesh(struct collapses *work);

void collapses_release(struct collapses *work);

/* ---- between the files of the simplifier ---------------------------------- */

static inline uint32_t
node_of(const struct collapses *work, uint32_t vertex)
{
	return work->sheets->vertex_nodes.at[vertex];
}

/* The borders between surfaces at a node; NULL where there are none. */
static inline struct quadric *
borders_of(const struct collapses *work, uint32_t node)
{
	uint32_t place = work->border_places.at[node];

	return place == TCS_NONE ? NULL : &work->borders.at[place];
}

/* The edges of a vertex, valid until the next call. */
enum tcs_status spokes_of(struct collapses *work, uint32_t vertex,
	size_t *count, struct tcs_fault *fault) TCS_CHECKED;

/* Whether the edge of a corner that has a face behind it is sharp, as the mesh
   came. */
bool edge_is_sharp(const struct collapses *work, size_t corner);

/* What moving a node into another costs, square metres times area; INFINITY
   where it may not be. What is more than `bound` may be less than it costs. */
double collapse_cost(const struct collapses *work, uint32_t node,
	uint32_t target, double bound);

/* The cheapest neighbour of a node whose edges are in work->spokes, and what
   moving there costs; INFINITY and TCS_NONE where there is none. */
struct queue_entry collapse_cheapest(
	const struct collapses *work, uint32_t node, size_t count);

/* The part of it that is due to the shape: what a node costs at a place. */
double collapse_cost_at(
	const struct collapses *work, uint32_t node, struct tcs_point place);

/*
 * Whether it may be done: the mesh stays manifold, no face turns over, becomes
 * a sliver or the same as another, no component goes through itself where it
 * did not, the surface stays where it may be, and no contact comes wholly apart;
 * and what breaks. Fails with TCS_NO_MEMORY.
 */
enum tcs_status collapse_check(struct collapses *work, uint32_t node,
	uint32_t target, bool *fine, struct tcs_fault *fault) TCS_CHECKED;

/*
 * List which faces of the ring will hold the points that faces around its last
 * vertex hold, `count` spokes, and the contacts of those that none will. Fails
 * with TCS_NO_MEMORY.
 */
enum tcs_status seam_moves_list(struct collapses *work, size_t count,
	struct tcs_fault *fault) TCS_CHECKED;

/* Add up what the points listed break, each contact by its worth; false where
   one comes wholly apart. */
bool seam_moves_break(struct collapses *work);

/* Do what is listed. */
void seam_moves_do(struct collapses *work);

/* How often entry i is listed; 0 unless it is the first time. */
static inline uint32_t
times_listed(const uint32_t *list, size_t count, size_t i)
{
	uint32_t times = 0;

	for (size_t k = 0; k < i; k++)
		if (list[k] == list[i])
			return 0;
	for (size_t k = i; k < count; k++)
		times += list[k] == list[i];
	return times;
}

/* The cost of a collapse that is strained: so many times as much. */
#define STRAIN_PENALTY 200

/* Whether what else is fine turns a face by more than 90 degrees at once, or makes
   the faces around the node more than four times as large or as small. */
bool collapse_is_strained(const struct strain *strain);

/* Do what was just found fine. Fails with TCS_NO_MEMORY. */
enum tcs_status collapse_do(struct collapses *work, uint32_t node,
	uint32_t target, struct tcs_fault *fault) TCS_CHECKED;

/* Aim a node at the cheapest of its neighbours. Fails with TCS_NO_MEMORY. */
enum tcs_status collapses_judge(struct collapses *work, uint32_t node,
	struct tcs_fault *fault) TCS_CHECKED;

/* Fill positions, quadrics and areas. */
void collapses_weigh(struct collapses *work);

/* The same and the borders of one node, from the faces that it has now. Fails
   with TCS_NO_MEMORY. */
enum tcs_status collapses_weigh_node(struct collapses *work, uint32_t node,
	struct tcs_fault *fault) TCS_CHECKED;

/* Fill the quadrics of the borders between surfaces. Fails with
   TCS_NO_MEMORY. */
enum tcs_status collapses_weigh_borders(
	struct collapses *work, struct tcs_fault *fault) TCS_CHECKED;

#endif
