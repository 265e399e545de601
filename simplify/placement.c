#include "placement.h"

#include <math.h>

/* Of a determinant, as a share of the cube of the mean of its diagonal: less
   is no single point. */
#define SINGULAR 1e-6

enum { SPOKES = 64 }; /* around a vertex that may move, at most */

enum tcs_status
placement_begin(struct collapses *work, struct tcs_fault *fault)
{
	const struct sheets *sheets = work->sheets;
	size_t nodes = sheets->node_count;

	array_clear(&work->fixed);
	if (array_grow(&work->fixed, nodes))
		return fault_memory(fault);
	work->fixed.count = nodes;
	for (size_t i = 0; i < nodes; i++)
		work->fixed.at[i] = sheets->nodes.at[i + 1].first_vertex -
				sheets->nodes.at[i].first_vertex >
			1;
	for (size_t i = 0; i < sheets->corners.count; i++) {
		size_t next = i % 3 == 2 ? i - 2 : i + 1;

		if (sheets->opposites.at[i] != HALF_EDGE_NONE)
			continue;
		work->fixed.at[node_of(work, sheets->corners.at[i])] = true;
		work->fixed.at[node_of(work, sheets->corners.at[next])] = true;
	}
	return TCS_OK;
}

static bool
may_move(const struct collapses *work, uint32_t node)
{
	uint32_t vertex = work->sheets->nodes.at[node].first_vertex;
	struct spoke spokes[SPOKES];
	size_t count;

	if (work->fixed.at[node] || work->seams->nodes.at[node] != TCS_NONE)
		return false;
	count = half_edges_spokes(work->mesh, vertex, spokes, SPOKES);
	if (count > SPOKES)
		return false;
	for (size_t i = 0; i < count; i++)
		if (spokes[i].face == HALF_EDGE_NONE ||
			work->seams->faces.at[spokes[i].face] != TCS_NONE)
			return false;
	return true;
}

/* Cramer's rule on the gradient of both quadrics and their borders. */
static bool
solve(const struct quadric *q, struct tcs_point *place)
{
	double a = q->yy * q->zz - q->yz * q->yz;
	double b = q->xz * q->yz - q->xy * q->zz;
	double c = q->xy * q->yz - q->xz * q->yy;
	double d = q->xx * q->zz - q->xz * q->xz;
	double e = q->xy * q->xz - q->xx * q->yz;
	double f = q->xx * q->yy - q->xy * q->xy;
	double determinant = q->xx * a + q->xy * b + q->xz * c;
	double mean = (q->xx + q->yy + q->zz) / 3;

	if (!(determinant > SINGULAR * mean * mean * mean))
		return false;
	*place = (struct tcs_point){
		-(a * q->x + b * q->y + c * q->z) / determinant,
		-(b * q->x + d * q->y + e * q->z) / determinant,
		-(c * q->x + e * q->y + f * q->z) / determinant,
	};
	return true;
}

static double
cost_at(const struct collapses *work, const uint32_t nodes[2],
	struct tcs_point place)
{
	double cost = 0;

	for (int i = 0; i < 2; i++)
		cost += collapse_cost_at(work, nodes[i], place);
	return cost;
}

/*
 * Under optimal placement: the best place for what an edge between two nodes
 * becomes, and its cost, which is INFINITY where a border between surfaces
 * forbids it; false where half-edge collapse is meant.
 */
static bool
find_place(const struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_point *place, double *cost)
{
	const uint32_t nodes[2] = {node, target};
	struct tcs_point a = work->positions.at[node];
	struct tcs_point b = work->positions.at[target];
	struct tcs_point middle = vector_middle(a, b);
	struct tcs_point places[4] = {b, middle, a};
	struct quadric sum;
	int count = 3;

	if (!may_move(work, node) || !may_move(work, target))
		return false;
	sum = work->quadrics.at[node];
	quadric_add(&sum, &work->quadrics.at[target]);
	for (int i = 0; i < 2; i++) {
		const struct quadric *borders = borders_of(work, nodes[i]);

		if (borders)
			quadric_add(&sum, borders);
	}
	if (solve(&sum, &places[3]) &&
		vector_length(vector_difference(places[3], middle)) <=
			vector_length(vector_difference(b, a)))
		count = 4;
	*place = b;
	*cost = INFINITY;
	for (int i = 0; i < count; i++) {
		double own = cost_at(work, nodes, places[i]);

		if (own < *cost) {
			*cost = own;
			*place = places[i];
		}
	}
	return true;
}

double
placement_cost(const struct collapses *work, uint32_t node, uint32_t target,
	double bound)
{
	struct tcs_point place;
	double cost;

	if (work->settings.optimal &&
		find_place(work, node, target, &place, &cost))
		return cost;
	return collapse_cost(work, node, target, bound);
}

struct queue_entry
placement_cheapest(const struct collapses *work, uint32_t node, size_t count)
{
	struct queue_entry best = {INFINITY, TCS_NONE};

	if (!work->settings.optimal)
		return collapse_cheapest(work, node, count);
	for (size_t i = 0; i < count; i++) {
		struct queue_entry there = {
			0, node_of(work, work->spokes.at[i].to)};

		if (there.node == node)
			continue;
		there.cost = placement_cost(work, node, there.node, best.cost);
		if (there.cost < INFINITY && queue_entry_leads(&there, &best))
			best = there;
	}
	return best;
}

/* Both ends of an edge, with what is around them. */
struct edge_rings {
	struct spoke spokes[2][SPOKES];
	struct watch_ring rings[2];
};

static void
load_rings(const struct collapses *work, uint32_t node, uint32_t target,
	struct edge_rings *out)
{
	const uint32_t nodes[2] = {node, target};

	for (int i = 0; i < 2; i++) {
		struct watch_ring *ring = &out->rings[i];

		ring->vertex = work->sheets->nodes.at[nodes[i]].first_vertex;
		ring->without = nodes[1 - i];
		ring->spokes = out->spokes[i];
		ring->count = half_edges_spokes(
			work->mesh, ring->vertex, out->spokes[i], SPOKES);
	}
}

/* Both nodes go to the place: each is checked as if the other were there. */
static enum tcs_status
check_both(struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_point place, bool *fine, struct tcs_fault *fault)
{
	struct tcs_point *at = work->positions.at;
	struct tcs_point here = at[node], there = at[target];
	enum tcs_status status;

	at[node] = place;
	status = collapse_check(work, target, node, fine, fault);
	at[node] = here;
	at[target] = place;
	/* What is found last is what collapse_do goes by. */
	if (!status && *fine)
		status = collapse_check(work, node, target, fine, fault);
	at[target] = there;
	return status;
}

/* Faces that both have count once. */
static void
look_at_volume(struct collapses *work, uint32_t node, struct edge_rings *rings,
	struct tcs_point place)
{
	struct watch_ring all = rings->rings[0];

	all.without = TCS_NONE;
	volume_watch_look(work, &all, place);
	volume_watch_look(work, &rings->rings[1], place);
	work->broken += volume_watch_worth(work, node);
}

enum tcs_status
placement_check(struct collapses *work, uint32_t node, uint32_t target,
	bool *fine, struct tcs_fault *fault)
{
	struct edge_rings rings;
	struct tcs_point place;
	enum tcs_status status;
	double cost;

	if (!work->settings.optimal ||
		!find_place(work, node, target, &place, &cost))
		return collapse_check(work, node, target, fine, fault);
	work->watch.paused = true;
	status = check_both(work, node, target, place, fine, fault);
	work->watch.paused = false;
	if (status || !*fine)
		return status;
	load_rings(work, node, target, &rings);
	*fine = error_watch_allows(work, rings.rings, 2, place);
	look_at_volume(work, node, &rings, place);
	return TCS_OK;
}

enum tcs_status
placement_do(struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_fault *fault)
{
	struct edge_rings rings;
	struct tcs_point place;
	enum tcs_status status;
	double cost;

	if (!work->settings.optimal)
		return collapse_do(work, node, target, fault);
	work->fixed.at[target] |= work->fixed.at[node];
	if (!find_place(work, node, target, &place, &cost))
		return collapse_do(work, node, target, fault);
	load_rings(work, node, target, &rings);
	error_watch_follow(work, rings.rings, 2, place);
	for (int i = 0; i < 2; i++)
		for (size_t k = 0; k < rings.rings[i].count; k++)
			crossing_watch_follow(
				work, rings.spokes[i][k].face, place);
	work->positions.at[target] = place;
	work->watch.paused = true;
	status = collapse_do(work, node, target, fault);
	work->watch.paused = false;
	return status;
}
