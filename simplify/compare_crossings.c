#include "compare_crossings.h"

#include <stdlib.h>

#include "crossing.h"
#include "split_work.h"

enum { COMPONENTS_AT_ONCE = 16 };

/* What some components in turn cross. */
struct found {
	struct crossings crossings;
	enum tcs_status status;
	struct tcs_fault fault;
};

struct search {
	const struct component_set *set;
	struct found *found; /* of this piece of work */
	uint32_t component;
	struct crossing_pair pair;
	bool crosses;
};

static bool
cross(const struct triangle_tree *tree, uint32_t a, uint32_t b)
{
	return triangles_cross(&tree->shapes.at[a], &tree->shapes.at[b]);
}

static bool
count_own(void *context, uint32_t a, uint32_t b)
{
	struct search *search = context;

	search->found->crossings.own += cross(&search->set->tree, a, b);
	return true;
}

/* Ends with the first pair of triangles that do. */
static bool
note_pair(void *context, uint32_t a, uint32_t b)
{
	struct search *search = context;
	const struct triangle_tree *tree = &search->set->tree;

	search->crosses = cross(tree, a, b);
	search->pair.triangles[0] = tree->boxes.items.at[a];
	search->pair.triangles[1] = tree->boxes.items.at[b];
	return !search->crosses;
}

static bool
visit_component(void *context, uint32_t position)
{
	struct search *search = context;
	const struct component_set *set = search->set;
	struct found *found = search->found;
	uint32_t a = search->component, b = set->boxes.items.at[position];

	if (b <= a ||
		box_gap_squared(&set->components.at[a].box,
			&set->components.at[b].box) > 0)
		return true;
	search->pair = (struct crossing_pair){.a = a, .b = b};
	search->crosses = false;
	box_tree_pairs(&set->tree.boxes, set->components.at[a].root,
		set->components.at[b].root, 0, note_pair, search);
	if (!search->crosses)
		return true;
	if (array_grow(&found->crossings.pairs, 1)) {
		found->status = fault_memory(&found->fault);
		return false;
	}
	found->crossings.pairs.at[found->crossings.pairs.count++] =
		search->pair;
	return true;
}

struct all_found {
	const struct component_set *set;
	struct found *pieces;
};

static void
search_some(void *context, size_t piece, size_t first, size_t end)
{
	const struct all_found *all = context;
	const struct component_set *set = all->set;
	struct search search = {.set = set, .found = &all->pieces[piece]};

	for (size_t i = first; i < end && !search.found->status; i++) {
		const struct component *own = &set->components.at[i];

		search.component = (uint32_t)i;
		box_tree_pairs(&set->tree.boxes, own->root, own->root, 0,
			count_own, &search);
		box_tree_near(&set->boxes, set->box_root, &own->box, 0,
			visit_component, &search);
	}
}

static int
by_components(const void *left, const void *right)
{
	const struct crossing_pair *p = left, *q = right;

	if (p->a != q->a)
		return p->a < q->a ? -1 : 1;
	return (p->b > q->b) - (p->b < q->b);
}

/* Append what a piece of work found; its pairs are released. */
static enum tcs_status
take_found(struct crossings *crossings, struct found *found,
	enum tcs_status status, struct tcs_fault *fault)
{
	size_t count = found->crossings.pairs.count;

	crossings->own += found->crossings.own;
	if (!status && found->status) {
		status = found->status;
		*fault = found->fault;
	}
	if (!status && array_grow(&crossings->pairs, count))
		status = fault_memory(fault);
	for (size_t i = 0; !status && i < count; i++)
		crossings->pairs.at[crossings->pairs.count++] =
			found->crossings.pairs.at[i];
	crossings_release(&found->crossings);
	return status;
}

enum tcs_status
crossings_find(const struct component_set *set, struct crossings *crossings,
	struct tcs_fault *fault)
{
	size_t count = set->components.count;
	size_t pieces = split_pieces(count, COMPONENTS_AT_ONCE);
	struct all_found all = {set, calloc(pieces + 1, sizeof *all.pieces)};
	enum tcs_status status;

	crossings->own = 0;
	crossings->pairs.count = 0;
	if (!all.pieces)
		return fault_memory(fault);
	status = split_work(
		count, COMPONENTS_AT_ONCE, set->jobs, search_some, &all, fault);
	for (size_t i = 0; i < pieces; i++)
		status = take_found(crossings, &all.pieces[i], status, fault);
	free(all.pieces);
	if (!status && crossings->pairs.count > 0)
		qsort(crossings->pairs.at, crossings->pairs.count,
			sizeof *crossings->pairs.at, by_components);
	return status;
}

size_t
crossings_count_new(const struct crossings *before,
	const struct crossings *after, const struct compare_match *match)
{
	size_t count = 0;

	for (size_t i = 0; i < after->pairs.count; i++) {
		const uint32_t *triangles = after->pairs.at[i].triangles;
		uint32_t p = match->pieces.at[match->numbers.at[triangles[0]]]
				     .parent;
		uint32_t q = match->pieces.at[match->numbers.at[triangles[1]]]
				     .parent;
		struct crossing_pair key = {
			.a = p < q ? p : q, .b = p < q ? q : p};

		count += before->pairs.count == 0 ||
			!bsearch(&key, before->pairs.at, before->pairs.count,
				sizeof key, by_components);
	}
	return count;
}

void
crossings_release(struct crossings *crossings)
{
	array_release(&crossings->pairs);
}
