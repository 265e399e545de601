#include "compare_match.h"

#include <math.h>
#include <stdlib.h>

#include "split_work.h"
#include "vector.h"

enum { TRIANGLES_AT_ONCE = 1024 };

/* The tree of the other side in which to look for a triangle's surface. */
static uint32_t
tree_for(const struct compare_side *side, size_t triangle,
	const struct compare_side *other)
{
	uint32_t twin = side->twins.at[side->set.features.at[triangle]];

	return twin == TCS_NONE ? NO_TREE : other->roots.at[twin];
}

static struct tcs_point
centre_of(const struct component_set *set, size_t triangle)
{
	struct triangle_shape t = component_set_shape(set, triangle);

	return vector_scaled(
		vector_sum(t.corner[0], vector_sum(t.corner[1], t.corner[2])),
		1.0 / 3);
}

/* The component before that each triangle after is nearest to. */
struct ballot {
	const struct compare_side *after, *before;
	uint32_t *cast; /* per triangle after */
	uint32_t *votes; /* per component before, clear between counts */
};

static void
cast_votes(void *context, size_t piece, size_t first, size_t end)
{
	const struct ballot *ballot = context;
	const struct compare_side *before = ballot->before;

	(void)piece;
	for (size_t i = first; i < end; i++) {
		uint32_t root = tree_for(ballot->after, i, before);
		struct tree_hit hit = triangle_tree_nearest(&before->surfaces,
			root == NO_TREE ? before->whole : root,
			centre_of(&ballot->after->set, i), INFINITY);

		ballot->cast[i] = before->set.numbers.at[hit.item];
	}
}

/* The first to have the most votes. */
static uint32_t
find_parent(const struct ballot *ballot, uint32_t number)
{
	const struct component_set *set = &ballot->after->set;
	const struct component *component = &set->components.at[number];
	const uint32_t *order = set->order.at + component->first;
	uint32_t best = TCS_NONE;

	for (uint32_t i = 0; i < component->count; i++) {
		uint32_t found = ballot->cast[order[i]];

		ballot->votes[found]++;
		if (best == TCS_NONE ||
			ballot->votes[found] > ballot->votes[best])
			best = found;
	}
	for (uint32_t i = 0; i < component->count; i++)
		ballot->votes[ballot->cast[order[i]]] = 0;
	return best;
}

static enum tcs_status
find_parents(struct compare_match *match, const struct compare_side *before,
	const struct compare_side *after, struct tcs_fault *fault)
{
	size_t count = after->set.components.count;
	size_t triangles = after->set.triangles.count;
	size_t components = before->set.components.count;
	struct ballot ballot = {after, before,
		calloc(triangles + 1, sizeof *ballot.cast),
		calloc(components + 1, sizeof *ballot.votes)};
	enum tcs_status status = TCS_OK;

	if (!ballot.votes || !ballot.cast || array_grow(&match->parents, count))
		status = fault_memory(fault);
	else if (components)
		status = split_work(triangles, TRIANGLES_AT_ONCE,
			after->set.jobs, cast_votes, &ballot, fault);
	for (uint32_t i = 0; !status && i < count; i++)
		match->parents.at[i] =
			components ? find_parent(&ballot, i) : TCS_NONE;
	if (!status)
		match->parents.count = count;
	free(ballot.votes);
	free(ballot.cast);
	return status;
}

/* Covered by the surfaces of its own features: where its first corner went. */
static uint32_t
find_cover(const struct compare_side *before, uint32_t number,
	const struct compare_side *after, double eps)
{
	const struct component *component = &before->set.components.at[number];
	const uint32_t *order = before->set.order.at + component->first;
	uint32_t cover = TCS_NONE;

	for (uint32_t i = 0; i < component->count; i++) {
		uint32_t root = tree_for(before, order[i], after);
		struct triangle_shape shape =
			component_set_shape(&before->set, order[i]);

		if (root == NO_TREE)
			return TCS_NONE;
		for (int k = 0; k < 3; k++) {
			struct tree_hit hit = triangle_tree_nearest(
				&after->surfaces, root, shape.corner[k], eps);

			if (!isfinite(hit.distance))
				return TCS_NONE;
			if (cover == TCS_NONE)
				cover = after->set.numbers.at[hit.item];
		}
	}
	return cover;
}

/* Those that nothing comes from get what covers them as their only image. */
static void
find_covers(struct compare_match *match, const struct compare_side *before,
	const struct compare_side *after, double eps)
{
	size_t components = before->set.components.count;

	for (size_t i = 0; i < components; i++) {
		match->merged.at[i] = false;
		match->images.at[i] = TCS_NONE;
	}
	for (size_t i = 0; i < match->parents.count; i++)
		if (match->parents.at[i] != TCS_NONE)
			match->merged.at[match->parents.at[i]] = true;
	for (uint32_t i = 0; i < components; i++) {
		if (!match->merged.at[i])
			match->images.at[i] = find_cover(before, i, after, eps);
		match->merged.at[i] = false;
	}
	match->images.count = components;
}

/* Images by counting: first[i] is where those of component i begin. */
static void
list_images(struct compare_match *match, size_t components)
{
	uint32_t *first = match->first.at;

	for (size_t i = 0; i <= components; i++)
		first[i] = 0;
	for (size_t i = 0; i < match->parents.count; i++)
		if (match->parents.at[i] != TCS_NONE)
			first[match->parents.at[i] + 1]++;
	for (size_t i = 0; i < components; i++)
		if (!first[i + 1] && match->images.at[i] != TCS_NONE) {
			match->merged.at[i] = true;
			first[i + 1] = 1;
		}
	for (size_t i = 0; i < components; i++)
		first[i + 1] += first[i];
}

static enum tcs_status
fill_images(
	struct compare_match *match, size_t components, struct tcs_fault *fault)
{
	size_t count = match->first.at[components];
	uint32_t *covers = calloc(components + 1, sizeof *covers);
	uint32_t *next = calloc(components + 1, sizeof *next);

	if (!covers || !next || array_grow(&match->images, count)) {
		free(covers);
		free(next);
		return fault_memory(fault);
	}
	for (size_t i = 0; i < components; i++) {
		covers[i] = match->images.at[i];
		next[i] = match->first.at[i];
	}
	for (uint32_t i = 0; i < match->parents.count; i++)
		if (match->parents.at[i] != TCS_NONE)
			match->images.at[next[match->parents.at[i]]++] = i;
	for (size_t i = 0; i < components; i++)
		if (match->merged.at[i])
			match->images.at[next[i]] = covers[i];
	match->images.count = count;
	free(covers);
	free(next);
	return TCS_OK;
}

enum tcs_status
match_components(struct compare_match *match, const struct compare_side *before,
	const struct compare_side *after, double eps, struct tcs_fault *fault)
{
	size_t components = before->set.components.count;
	enum tcs_status status;

	array_clear(&match->parents);
	array_clear(&match->images);
	status = find_parents(match, before, after, fault);
	if (!status &&
		(array_grow(&match->first, components + 1) ||
			array_grow(&match->merged, components) ||
			array_grow(&match->images, components)))
		status = fault_memory(fault);
	if (status)
		return status;
	find_covers(match, before, after, eps);
	list_images(match, components);
	return fill_images(match, components, fault);
}

const uint32_t *
match_images(
	const struct compare_match *match, uint32_t component, size_t *count)
{
	uint32_t first = match->first.at[component];

	*count = match->first.at[component + 1] - first;
	return match->images.at + first;
}

void
match_release(struct compare_match *match)
{
	array_release(&match->parents);
	array_release(&match->first);
	array_release(&match->images);
	array_release(&match->merged);
}
