#include "compare_match.h"

#include <math.h>
#include <stdlib.h>

#include "split_work.h"
#include "vector.h"

enum { TRIANGLES_AT_ONCE = 1024 };

/* Several components have triangles of the feature. */
#define SEVERAL (TCS_NONE - 1)

/* A triangle after, and the component before that it comes from. */
struct settled {
	uint32_t parent, triangle;
};

/* What is worked with while two sides are matched. */
struct matching {
	struct compare_match *match;
	const struct compare_side *before;
	struct compare_side *after;
	double eps;
	uint32_t *owners; /* per feature before: the component that alone has
	                     it; TCS_NONE, SEVERAL */
	uint32_t *cast; /* per triangle after: the component it comes from */
	uint32_t *parents; /* per component after; TCS_NONE */
	double *votes; /* per component before, 0 between counts */
	bool *alive; /* per component before: a component comes from it */
	struct settled *settled; /* scratch: of one component after */
	uint32_t *items; /* scratch: triangles of one piece */
};

/* ---- where each triangle comes from -------------------------------------- */

static void
find_owners(struct matching *matching)
{
	const struct component_set *set = &matching->before->set;

	for (size_t i = 0; i < matching->before->roots.count; i++)
		matching->owners[i] = TCS_NONE;
	for (size_t i = 0; i < set->triangles.count; i++) {
		uint32_t *owner = &matching->owners[set->features.at[i]];

		if (*owner == TCS_NONE)
			*owner = set->numbers.at[i];
		else if (*owner != set->numbers.at[i])
			*owner = SEVERAL;
	}
}

static uint32_t
owner_of(const struct matching *matching, size_t triangle)
{
	const struct compare_side *after = matching->after;
	uint32_t twin = after->twins.at[after->set.features.at[triangle]];

	return twin == TCS_NONE ? TCS_NONE : matching->owners[twin];
}

/* The tree of the other side in which to look for a triangle's surface. */
static uint32_t
tree_for(const struct compare_side *side, size_t triangle,
	const struct compare_side *other)
{
	uint32_t twin = side->twins.at[side->set.features.at[triangle]];

	return twin == TCS_NONE ? NO_TREE : other->roots.at[twin];
}

/* A triangle's corners and its centre. */
struct marks {
	struct tcs_point at[4];
	struct tcs_point normal;
};

static struct marks
marks_of(const struct component_set *set, size_t triangle)
{
	struct triangle_shape t = component_set_shape(set, triangle);
	struct tcs_point sum =
		vector_sum(t.corner[0], vector_sum(t.corner[1], t.corner[2]));

	return (struct marks){{t.corner[0], t.corner[1], t.corner[2],
				      vector_scaled(sum, 1.0 / 3)},
		triangle_normal(&t)};
}

static double
strangeness(const struct matching *matching, uint32_t component,
	const struct marks *marks)
{
	const struct component_set *set = &matching->before->set;
	struct triangle_shape nearest;
	double sum = 0;

	for (int i = 0; i < 4; i++) {
		struct tree_hit hit = triangle_tree_nearest(&set->tree,
			set->components.at[component].root, marks->at[i],
			INFINITY);

		sum += hit.distance;
		nearest = component_set_shape(set, hit.item);
	}
	if (vector_dot(triangle_normal(&nearest), marks->normal) < 0)
		sum += matching->eps / 2;
	return sum;
}

/* Of several, the one with the lowest number. */
static uint32_t
least_strange(const struct matching *matching, const uint32_t candidates[4],
	const struct marks *marks)
{
	uint32_t best = candidates[0];
	double least = INFINITY;

	for (int i = 0; i < 4; i++) {
		double sum;
		bool known = false;

		for (int k = 0; k < i; k++)
			known |= candidates[k] == candidates[i];
		if (known)
			continue;
		sum = strangeness(matching, candidates[i], marks);
		if (sum < least || (sum <= least && candidates[i] < best)) {
			least = sum;
			best = candidates[i];
		}
	}
	return best;
}

static uint32_t
cast_vote(const struct matching *matching, size_t triangle)
{
	const struct compare_side *before = matching->before;
	uint32_t root = tree_for(matching->after, triangle, before);
	struct marks marks = marks_of(&matching->after->set, triangle);
	uint32_t candidates[4];
	bool one = true;

	if (root == NO_TREE)
		root = before->whole;
	for (int i = 0; i < 4; i++) {
		struct tree_hit hit = triangle_tree_nearest(
			&before->surfaces, root, marks.at[i], INFINITY);

		candidates[i] = before->set.numbers.at[hit.item];
		one &= candidates[i] == candidates[0];
	}
	return one ? candidates[0]
		   : least_strange(matching, candidates, &marks);
}

static void
cast_votes(void *context, size_t piece, size_t first, size_t end)
{
	const struct matching *matching = context;

	(void)piece;
	for (size_t i = first; i < end; i++) {
		uint32_t owner = owner_of(matching, i);

		matching->cast[i] =
			owner < SEVERAL ? owner : cast_vote(matching, i);
	}
}

/* ---- what has another feature now ---------------------------------------- */

/* A component before that no triangle came from so far, and where it was. */
struct claim {
	struct matching *matching;
	uint32_t component;
	struct box box;
};

static bool
claim_triangle(void *context, uint32_t position)
{
	const struct claim *claim = context;
	const struct matching *matching = claim->matching;
	uint32_t triangle = matching->after->surfaces.boxes.items.at[position];
	uint32_t *from = &matching->cast[triangle];
	struct marks marks = marks_of(&matching->after->set, triangle);

	for (int i = 0; i < 3; i++)
		if (box_distance_squared(&claim->box, marks.at[i]) >
			matching->eps * matching->eps)
			return true;
	if (strangeness(matching, claim->component, &marks) <
		strangeness(matching, *from, &marks))
		*from = claim->component;
	return true;
}

/* Components that nothing comes from by feature get what lies where they were
   and is nearer to them than to what it came from. */
static void
claim_triangles(struct matching *matching)
{
	const struct component_set *before = &matching->before->set;
	const struct compare_side *after = matching->after;

	for (size_t i = 0; i < after->set.triangles.count; i++)
		matching->alive[matching->cast[i]] = true;
	for (uint32_t i = 0; i < before->components.count; i++) {
		struct claim claim = {
			matching, i, before->components.at[i].box};

		if (!matching->alive[i] && after->whole != NO_TREE)
			box_tree_near(&after->surfaces.boxes, after->whole,
				&claim.box, matching->eps, claim_triangle,
				&claim);
		matching->alive[i] = false;
	}
}

/* ---- where each component comes from ------------------------------------- */

static const uint32_t *
triangles_of(const struct component_set *set, const struct component *component)
{
	return set->order.at + component->first;
}

/* What most of its triangles come from; the first of several. */
static uint32_t
find_parent(const struct matching *matching, const struct component *component)
{
	const uint32_t *order = triangles_of(&matching->after->set, component);
	double *votes = matching->votes;
	uint32_t best = matching->cast[order[0]];

	for (uint32_t i = 0; i < component->count; i++) {
		uint32_t found = matching->cast[order[i]];

		if (++votes[found] > votes[best])
			best = found;
	}
	for (uint32_t i = 0; i < component->count; i++)
		votes[matching->cast[order[i]]] = 0;
	return best;
}

static void
find_parents(struct matching *matching)
{
	const struct component_set *after = &matching->after->set;
	bool any = matching->before->set.components.count > 0;

	for (size_t i = 0; i < after->components.count; i++) {
		uint32_t parent = TCS_NONE;

		if (any) {
			parent =
				find_parent(matching, &after->components.at[i]);
			matching->alive[parent] = true;
		}
		matching->parents[i] = parent;
	}
}

/* ---- regions ------------------------------------------------------------- */

/* Add up, by component before, what of a component after may be its region. */
static void
weigh_regions(struct matching *matching, const struct component *component)
{
	const struct component_set *set = &matching->after->set;
	const uint32_t *order = triangles_of(set, component);

	for (uint32_t i = 0; i < component->count; i++) {
		uint32_t from = matching->cast[order[i]];
		struct triangle_shape shape =
			component_set_shape(set, order[i]);

		if (owner_of(matching, order[i]) == from)
			matching->votes[from] = INFINITY;
		else if (!matching->alive[from])
			matching->votes[from] += triangle_area(&shape);
	}
}

/* Regions stay with what they come from; the other triangles come from what
   their component does. */
static void
settle_triangles(struct matching *matching, uint32_t number)
{
	const struct component_set *before = &matching->before->set;
	const struct component *component =
		&matching->after->set.components.at[number];
	const uint32_t *order = triangles_of(&matching->after->set, component);
	double *votes = matching->votes;

	for (uint32_t i = 0; i < component->count; i++)
		matching->settled[i] =
			(struct settled){matching->parents[number], order[i]};
	if (!before->components.count)
		return;
	weigh_regions(matching, component);
	for (uint32_t i = 0; i < component->count; i++) {
		uint32_t from = matching->cast[order[i]];

		if (votes[from] > 0 &&
			10 * votes[from] >= before->components.at[from].area)
			matching->settled[i].parent = from;
	}
	for (uint32_t i = 0; i < component->count; i++)
		votes[matching->cast[order[i]]] = 0;
}

static int
by_parent(const void *left, const void *right)
{
	const struct settled *a = left, *b = right;

	if (a->parent != b->parent)
		return a->parent < b->parent ? -1 : 1;
	return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

static enum tcs_status
put_piece(struct matching *matching, uint32_t component,
	const struct settled *settled, size_t count, bool region,
	struct tcs_fault *fault)
{
	struct compare_match *match = matching->match;
	struct component_set *set = &matching->after->set;
	struct match_piece piece = {settled->parent, component,
		set->components.at[component].root,
		set->components.at[component].area, region};
	enum tcs_status status = TCS_OK;

	if (array_grow(&match->pieces, 1))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		match->numbers.at[settled[i].triangle] =
			(uint32_t)match->pieces.count;
	if (region) {
		piece.area = 0;
		for (size_t i = 0; i < count; i++) {
			struct triangle_shape shape =
				component_set_shape(set, settled[i].triangle);

			matching->items[i] = settled[i].triangle;
			piece.area += triangle_area(&shape);
		}
		status = triangle_tree_add(&set->tree, set->points.at,
			set->triangles.at, matching->items, count, &piece.root,
			fault);
	}
	match->pieces.at[match->pieces.count++] = piece;
	return status;
}

static enum tcs_status
divide_component(
	struct matching *matching, uint32_t number, struct tcs_fault *fault)
{
	size_t count = matching->after->set.components.at[number].count, run;
	struct settled *settled = matching->settled;
	enum tcs_status status = TCS_OK;

	settle_triangles(matching, number);
	qsort(settled, count, sizeof *settled, by_parent);
	for (size_t i = 0; !status && i < count; i += run) {
		for (run = 1; i + run < count &&
			settled[i + run].parent == settled[i].parent;
			run++)
			;
		status = put_piece(
			matching, number, settled + i, run, run < count, fault);
	}
	return status;
}

static enum tcs_status
divide_components(struct matching *matching, struct tcs_fault *fault)
{
	const struct component_set *after = &matching->after->set;
	enum tcs_status status = TCS_OK;

	if (array_grow(&matching->match->numbers, after->triangles.count))
		return fault_memory(fault);
	matching->match->numbers.count = after->triangles.count;
	for (uint32_t i = 0; !status && i < after->components.count; i++)
		status = divide_component(matching, i, fault);
	return status;
}

/* ---- images -------------------------------------------------------------- */

/* A component after, and the piece of it that is nearest to a point; TCS_NONE
   before it is known. */
struct shell {
	uint32_t component, piece;
};

static struct shell
nearest_shell(
	const struct matching *matching, uint32_t root, struct tcs_point point)
{
	struct tree_hit hit = triangle_tree_nearest(
		&matching->after->surfaces, root, point, INFINITY);

	return (struct shell){matching->after->set.numbers.at[hit.item],
		matching->match->numbers.at[hit.item]};
}

static bool
is_within(const struct matching *matching, uint32_t root,
	const struct component *shell, struct tcs_point point)
{
	const struct compare_side *after = matching->after;

	return isfinite(triangle_tree_nearest(
		       &after->surfaces, root, point, matching->eps)
				.distance) ||
		(shell->closed &&
			triangle_tree_encloses(
				&after->set.tree, shell->root, point));
}

/* What its first corner went to, if the surfaces of its own features pass by
   the corners and centres of all its triangles, or a closed component of them
   encloses those that they do not: a piece of it. */
static uint32_t
find_cover(const struct matching *matching, uint32_t number)
{
	const struct compare_side *before = matching->before;
	const struct compare_side *after = matching->after;
	const struct component *component = &before->set.components.at[number];
	const uint32_t *order = triangles_of(&before->set, component);
	struct shell shell = {TCS_NONE, TCS_NONE};

	for (uint32_t i = 0; i < component->count; i++) {
		uint32_t root = tree_for(before, order[i], after);
		struct marks marks = marks_of(&before->set, order[i]);

		if (root == NO_TREE)
			return TCS_NONE;
		if (shell.component == TCS_NONE)
			shell = nearest_shell(matching, root, marks.at[0]);
		for (int k = 0; k < 4; k++)
			if (!is_within(matching, root,
				    &after->set.components.at[shell.component],
				    marks.at[k]))
				return TCS_NONE;
	}
	return shell.piece;
}

/* The pieces of the component that a piece is of. */
static size_t
pieces_beside(const struct compare_match *match, uint32_t piece, size_t *first)
{
	uint32_t component = match->pieces.at[piece].component;
	size_t end = piece;

	*first = piece;
	while (*first > 0 &&
		match->pieces.at[*first - 1].component == component)
		--*first;
	while (end < match->pieces.count &&
		match->pieces.at[end].component == component)
		end++;
	return end - *first;
}

/* Fill first[i + 2] with how many images component i has; covers[i] is what
   has swallowed it. */
static void
count_images(const struct matching *matching, uint32_t *covers, uint32_t *first)
{
	struct compare_match *match = matching->match;
	size_t components = matching->before->set.components.count, beside;

	for (size_t i = 0; i < match->pieces.count; i++)
		if (match->pieces.at[i].parent != TCS_NONE)
			first[match->pieces.at[i].parent + 2]++;
	for (uint32_t i = 0; i < components; i++) {
		covers[i] = first[i + 2] ? TCS_NONE : find_cover(matching, i);
		match->swallowed.at[i] = covers[i] != TCS_NONE;
		if (match->swallowed.at[i])
			first[i + 2] = (uint32_t)pieces_beside(
				match, covers[i], &beside);
	}
}

/* Where first[i + 1] is where those of component i begin, and then is where they
   end. */
static void
place_images(
	struct compare_match *match, const uint32_t *covers, size_t components)
{
	uint32_t *first = match->first.at;

	for (size_t i = 0; i < components; i++) {
		size_t piece = 0,
		       count = match->swallowed.at[i]
			? pieces_beside(match, covers[i], &piece)
			: 0;

		for (; count > 0; count--, piece++)
			match->images.at[first[i + 1]++] = (uint32_t)piece;
	}
	for (uint32_t i = 0; i < match->pieces.count; i++)
		if (match->pieces.at[i].parent != TCS_NONE)
			match->images
				.at[first[match->pieces.at[i].parent + 1]++] =
				i;
}

/* Images by counting: first[i] is where those of component i begin. */
static enum tcs_status
list_images(struct matching *matching, struct tcs_fault *fault)
{
	struct compare_match *match = matching->match;
	size_t components = matching->before->set.components.count;
	uint32_t *covers = malloc((components + 1) * sizeof *covers), *first;

	if (!covers || array_grow(&match->first, components + 2) ||
		array_grow(&match->swallowed, components)) {
		free(covers);
		return fault_memory(fault);
	}
	first = match->first.at;
	for (size_t i = 0; i < components + 2; i++)
		first[i] = 0;
	count_images(matching, covers, first);
	for (size_t i = 1; i < components + 2; i++)
		first[i] += first[i - 1];
	match->first.count = components + 1;
	if (array_grow(&match->images, first[components + 1])) {
		free(covers);
		return fault_memory(fault);
	}
	match->images.count = first[components + 1];
	place_images(match, covers, components);
	free(covers);
	return TCS_OK;
}

/* ---- all ----------------------------------------------------------------- */

static enum tcs_status
match_all(struct matching *matching, struct tcs_fault *fault)
{
	const struct component_set *after = &matching->after->set;
	enum tcs_status status = TCS_OK;

	find_owners(matching);
	if (matching->before->set.components.count)
		status = split_work(after->triangles.count, TRIANGLES_AT_ONCE,
			after->jobs, cast_votes, matching, fault);
	if (!status) {
		claim_triangles(matching);
		find_parents(matching);
		status = divide_components(matching, fault);
	}
	return status ? status : list_images(matching, fault);
}

enum tcs_status
match_components(struct compare_match *match, const struct compare_side *before,
	struct compare_side *after, double eps, struct tcs_fault *fault)
{
	size_t components = before->set.components.count;
	size_t triangles = after->set.triangles.count;
	struct matching matching = {match, before, after, eps,
		calloc(before->roots.count + 1, sizeof *matching.owners),
		calloc(triangles + 1, sizeof *matching.cast),
		calloc(after->set.components.count + 1,
			sizeof *matching.parents),
		calloc(components + 1, sizeof *matching.votes),
		calloc(components + 1, sizeof *matching.alive),
		calloc(triangles + 1, sizeof *matching.settled),
		calloc(triangles + 1, sizeof *matching.items)};
	enum tcs_status status;

	array_clear(&match->pieces);
	array_clear(&match->numbers);
	array_clear(&match->images);
	if (!matching.owners || !matching.cast || !matching.parents ||
		!matching.votes || !matching.alive || !matching.settled ||
		!matching.items)
		status = fault_memory(fault);
	else
		status = match_all(&matching, fault);
	free(matching.owners);
	free(matching.cast);
	free(matching.parents);
	free(matching.votes);
	free(matching.alive);
	free(matching.settled);
	free(matching.items);
	return status;
}

struct images
match_images(const struct compare_match *match, uint32_t component)
{
	uint32_t first = match->first.at[component];

	return (struct images){match->images.at + first,
		match->first.at[component + 1] - first};
}

void
match_release(struct compare_match *match)
{
	array_release(&match->pieces);
	array_release(&match->numbers);
	array_release(&match->first);
	array_release(&match->images);
	array_release(&match->swallowed);
}
