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

/* What moving its borders costs. */
static double
border_cost(const struct collapses *work, uint32_t node, struct tcs_point to)
{
	const struct quadric *borders = borders_of(work, node);
	double weight, cost;

	if (!borders)
		return 0;
	weight = borders->xx + borders->yy + borders->zz;
	cost = quadric_at(borders, to);
	if (cost > BORDER_LIMIT * BORDER_LIMIT * weight)
		cost += BORDER_WORTH * work->settings.contact_cost;
	return cost;
}

double
collapse_cost_at(
	const struct collapses *work, uint32_t node, struct tcs_point place)
{
	struct tcs_point from = work->positions.at[node];
	struct tcs_point along = vector_difference(place, from);

	/* What stands on the ground stays there. */
	if (from.z <= work->ground && place.z > work->ground)
		return INFINITY;
	return quadric_at(&work->quadrics.at[node], place) +
		border_cost(work, node, place) +
		SHORTNESS * work->areas.at[node] * vector_dot(along, along);
}

double
collapse_cost(const struct collapses *work, uint32_t node, uint32_t target,
	double bound)
{
	double ratio = work->settings.base_ratio;
	struct tcs_point to = work->positions.at[target];
	struct tcs_point along =
		vector_difference(to, work->positions.at[node]);
	double square = vector_dot(along, along), pull, rest;
	double cost = collapse_cost_at(work, node, to);

	if (!(cost <= bound) || work->seams->nodes.at[node] == TCS_NONE ||
		!(square > 0))
		return cost;
	if (cost * ratio > bound)
		return cost * ratio;
	pull = worst_sine(work, node, target, along);
	rest = 1 - pull * pull / square;
	rest = rest > LEAST_COSINE * LEAST_COSINE ? sqrt(rest) : LEAST_COSINE;
	return cost * ratio / rest;
}
