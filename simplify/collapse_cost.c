/*
 * source: W, cost of half-edge collapse (Wang et al. 2021, ISPRS IJGI 10, 422).
 */
#include "collapses.h"

/* 1 / |cos θ| is bounded: at this cosine a pull is straight out. What it opens
   is watched, see seams.h, and has its own price. */
#define LEAST_COSINE 0.5

/* Metres that a border between surfaces may move while it is kept, and contacts
   that it is worth to keep it. */
#define BORDER_LIMIT 0.01
#define BORDER_WORTH 0.2

/* A collapse that is free otherwise prefers the shorter edge. */
#define SHORTNESS 1e-10

/* Whether the node is a boundary vertex at that component. */
static bool
meets(const struct seams *seams, uint32_t node, uint32_t component)
{
	for (uint32_t i = seams->nodes.at[node]; i != TCS_NONE;
		i = seams->planes.at[i].next)
		if (seams->planes.at[i].component == component)
			return true;
	return false;
}

/*
 * The plane of another component that the collapse pulls its boundary vertex
 * out of most: the sine of the angle between edge and plane.
 *
 * What stays inside of the same component slides along it.
 */
static double
worst_sine(const struct collapses *work, uint32_t node, uint32_t target,
	struct tcs_point along)
{
	const struct seams *seams = work->seams;
	const struct tcs_point *normals = work->sheets->normals.at;
	double worst = 0;

	bool stays = false;
	uint32_t asked = TCS_NONE;

	/* Planes of one component stand together. */
	for (uint32_t i = seams->nodes.at[node]; i != TCS_NONE;
		i = seams->planes.at[i].next) {
		const struct seam_plane *plane = &seams->planes.at[i];
		double sine;

		if (plane->component != asked)
			stays = meets(seams, target, plane->component);
		asked = plane->component;
		sine = fabs(vector_dot(normals[plane->face], along));
		if (!stays && sine > worst)
			worst = sine;
	}
	return worst;
}

/* What moving its borders, if there are any, costs. */
static double
border_cost(const struct collapses *work, const struct quadric *borders,
	struct tcs_point to)
{
	double weight, cost;

	if (!borders)
		return 0;
	weight = borders->xx + borders->yy + borders->zz;
	cost = quadric_at(borders, to);
	if (cost > BORDER_LIMIT * BORDER_LIMIT * weight)
		cost += BORDER_WORTH * work->settings.contact_cost;
	return cost;
}

/* What is the same wherever a node goes. */
struct leaving {
	struct tcs_point from;
	const struct quadric *planes, *borders;
	double share; /* of what the planes say */
	double way; /* what the way costs, by its square */
	bool stays_low; /* what stands on the ground stays there */
	bool meets; /* it is a boundary vertex */
};

static inline double
share_of(const struct collapses *work, uint32_t node)
{
	return work->shares.count > 0
		? (double)work->shares
			  .at[work->sheets->nodes.at[node].component]
		: 1;
}

static inline struct leaving
leaving_of(const struct collapses *work, uint32_t node)
{
	struct tcs_point from = work->positions.at[node];

	return (struct leaving){from, &work->quadrics.at[node],
		borders_of(work, node), share_of(work, node),
		SHORTNESS * work->areas.at[node], from.z <= work->ground,
		work->seams->nodes.at[node] != TCS_NONE};
}

/* What keeping its shape costs, and a way of this length, squared. */
static inline double
shape_cost(const struct collapses *work, const struct leaving *leaving,
	struct tcs_point place, double square)
{
	if (leaving->stays_low && place.z > work->ground)
		return INFINITY;
	return leaving->share * quadric_at(leaving->planes, place) +
		border_cost(work, leaving->borders, place) +
		leaving->way * square;
}

double
collapse_cost_at(
	const struct collapses *work, uint32_t node, struct tcs_point place)
{
	struct leaving leaving = leaving_of(work, node);
	struct tcs_point along = vector_difference(place, leaving.from);

	return shape_cost(work, &leaving, place, vector_dot(along, along));
}

static inline double
cost_of(const struct collapses *work, const struct leaving *leaving,
	uint32_t node, uint32_t target, double bound)
{
	double ratio = work->settings.base_ratio;
	struct tcs_point to = work->positions.at[target];
	struct tcs_point along = vector_difference(to, leaving->from);
	double square = vector_dot(along, along), cost, pull, rest;

	/* That is dear enough, whatever the rest is. */
	if (leaving->way * square > bound)
		return leaving->way * square;
	cost = shape_cost(work, leaving, to, square);
	if (!(cost <= bound) || !leaving->meets || !(square > 0))
		return cost;
	if (cost * ratio > bound)
		return cost * ratio;
	pull = worst_sine(work, node, target, along);
	rest = 1 - pull * pull / square;
	rest = rest > LEAST_COSINE * LEAST_COSINE ? sqrt(rest) : LEAST_COSINE;
	return cost * ratio / rest;
}

double
collapse_cost(const struct collapses *work, uint32_t node, uint32_t target,
	double bound)
{
	struct leaving leaving = leaving_of(work, node);

	return cost_of(work, &leaving, node, target, bound);
}

struct queue_entry
collapse_cheapest(const struct collapses *work, uint32_t node, size_t count)
{
	struct queue_entry best = {INFINITY, TCS_NONE};
	struct leaving leaving = leaving_of(work, node);

	for (size_t i = 0; i < count; i++) {
		struct queue_entry there = {
			0, node_of(work, work->spokes.at[i].to)};

		if (there.node == node)
			continue;
		there.cost =
			cost_of(work, &leaving, node, there.node, best.cost);
		if (there.cost < INFINITY && queue_entry_leads(&there, &best))
			best = there;
	}
	return best;
}
