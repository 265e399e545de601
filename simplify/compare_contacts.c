#include "compare_contacts.h"

#include <math.h>
#include <stdlib.h>

#include "compare_seam.h"
#include "forest.h"
#include "split_work.h"

enum { CONTACTS_AT_ONCE = 32, COMPONENTS_AT_ONCE = 32 };

struct judge {
	const struct compare_side *before, *after;
	const struct compare_match *match;
	double eps;
	bool *still; /* per component before: moved by half an eps at most */
	bool *crushed; /* per component before: hardly anything is left */
};

static const struct match_piece *
piece_at(const struct judge *judge, uint32_t number)
{
	return &judge->match->pieces.at[number];
}

static const struct component *
component_of(const struct judge *judge, const struct match_piece *piece)
{
	return &judge->after->set.components.at[piece->component];
}

/* ---- gaps ---------------------------------------------------------------- */

static bool
is_enclosed(const struct judge *judge, const struct match_piece *inner,
	const struct match_piece *outer)
{
	const struct component_set *set = &judge->after->set;
	const struct component *shell = component_of(judge, outer);
	uint32_t first = set->order.at[component_of(judge, inner)->first];

	return shell->closed && inner->component != outer->component &&
		triangle_tree_encloses(&set->tree, shell->root,
			component_set_shape(set, first).corner[0]);
}

/* Between all that the sides are in, or their regions of what has both; 0 for
   what is one piece, or one inside the other. */
static double
gap_between(const struct judge *judge, const struct match_piece *a,
	const struct match_piece *b, double reach)
{
	bool in_one = a->component == b->component;
	double gap;

	if (a == b)
		return 0;
	gap = triangle_tree_gap(&judge->after->set.tree,
		in_one ? a->root : component_of(judge, a)->root,
		in_one ? b->root : component_of(judge, b)->root, reach,
		2 * judge->eps)
		      .distance;
	if (gap > 2 * judge->eps &&
		(is_enclosed(judge, a, b) || is_enclosed(judge, b, a)))
		return 0;
	return gap;
}

static double
least_gap(const struct judge *judge, struct images a, struct images b)
{
	double least = INFINITY;

	for (size_t i = 0; i < a.count; i++)
		for (size_t k = 0; k < b.count; k++) {
			least = fmin(least,
				gap_between(judge, piece_at(judge, a.at[i]),
					piece_at(judge, b.at[k]), least));
			if (least <= 2 * judge->eps)
				return least;
		}
	return least;
}

static struct broken_contact
judge_contact(const struct judge *judge, const struct contact *contact)
{
	struct images a = match_images(judge->match, contact->a);
	struct images b = match_images(judge->match, contact->b);
	struct broken_contact out = {
		CONTACT_LOST, contact->a, contact->b, INFINITY};

	if (!a.count || !b.count)
		return out;
	out.state = CONTACT_KEPT;
	out.gap = 0;
	if (!contact->inside && judge->still[contact->a] &&
		judge->still[contact->b])
		return out;
	out.gap = least_gap(judge, a, b);
	if (out.gap > 2 * judge->eps)
		out.state = CONTACT_SEPARATED;
	else if (seam_is_half_open(judge->before, judge->after, judge->match,
			 contact, judge->eps))
		out.state = CONTACT_HALF_OPEN;
	return out;
}

static void
find_still(void *context, size_t piece, size_t first, size_t end)
{
	const struct judge *judge = context;

	(void)piece;
	for (size_t i = first; i < end; i++)
		judge->still[i] = component_is_still(judge->before, (uint32_t)i,
			judge->after, judge->match, judge->eps / 2);
}

/* The judgements of all contacts. */
struct verdicts {
	const struct judge *judge;
	struct broken_contact *at;
};

static void
judge_some(void *context, size_t piece, size_t first, size_t end)
{
	const struct verdicts *verdicts = context;
	const struct judge *judge = verdicts->judge;

	(void)piece;
	for (size_t i = first; i < end; i++)
		verdicts->at[i] =
			judge_contact(judge, &judge->before->contacts.at[i]);
}

static enum tcs_status
count_verdicts(const struct verdicts *verdicts, struct compare_metrics *metrics,
	struct broken_list *broken, struct tcs_fault *fault)
{
	static const enum compare_metric counts[] = {COMPARE_CONTACTS_KEPT,
		COMPARE_CONTACTS_SEPARATED, COMPARE_CONTACTS_HALF_OPEN,
		COMPARE_CONTACTS_LOST};
	const struct judge *judge = verdicts->judge;
	size_t count = judge->before->contacts.count;

	metrics->at[COMPARE_CONTACTS_BEFORE] = (double)count;
	for (size_t i = 0; i < count; i++) {
		struct broken_contact found = verdicts->at[i];

		metrics->at[counts[found.state]]++;
		metrics->at[COMPARE_CONTACTS_CRUSHED] +=
			found.state != CONTACT_LOST &&
			(judge->crushed[found.a] || judge->crushed[found.b]);
		if (found.state == CONTACT_KEPT)
			continue;
		if (found.state == CONTACT_SEPARATED)
			metrics->at[COMPARE_GAP_MAX] =
				fmax(metrics->at[COMPARE_GAP_MAX], found.gap);
		if (array_grow(broken, 1))
			return fault_memory(fault);
		broken->at[broken->count++] = found;
	}
	return TCS_OK;
}

static enum tcs_status
judge_contacts(const struct judge *judge, struct compare_metrics *metrics,
	struct broken_list *broken, struct tcs_fault *fault)
{
	size_t count = judge->before->contacts.count;
	struct verdicts verdicts = {
		judge, calloc(count + 1, sizeof *verdicts.at)};
	enum tcs_status status;

	if (!verdicts.at)
		return fault_memory(fault);
	status = split_work(count, CONTACTS_AT_ONCE, judge->before->set.jobs,
		judge_some, &verdicts, fault);
	if (!status)
		status = count_verdicts(&verdicts, metrics, broken, fault);
	free(verdicts.at);
	return status;
}

/* ---- what stands on the ground ------------------------------------------- */

/* Per component whether a chain of contacts leads to one at the ground. The
   ground is an element behind the components. NULL without memory. */
static uint32_t *
find_grounded(const struct compare_side *side, double ground)
{
	uint32_t count = (uint32_t)side->set.components.count;
	uint32_t *parents = calloc((size_t)count + 1, sizeof *parents);

	if (!parents)
		return NULL;
	for (uint32_t i = 0; i <= count; i++)
		parents[i] = i;
	for (uint32_t i = 0; i < count; i++)
		if (side->set.components.at[i].box.low[2] <= ground)
			parents[i] = count;
	for (size_t i = 0; i < side->contacts.count; i++) {
		uint32_t a = forest_root(parents, side->contacts.at[i].a);
		uint32_t b = forest_root(parents, side->contacts.at[i].b);

		if (a < b)
			parents[a] = b;
		else
			parents[b] = a;
	}
	for (uint32_t i = 0; i < count; i++)
		parents[i] = forest_root(parents, i);
	return parents;
}

static double
count_floating(const struct judge *judge, const uint32_t *before,
	const uint32_t *after)
{
	uint32_t count = (uint32_t)judge->before->set.components.count;
	uint32_t ground = (uint32_t)judge->after->set.components.count;
	double floating = 0;

	for (uint32_t i = 0; i < count; i++) {
		struct images images = match_images(judge->match, i);
		bool stands = false;

		for (size_t k = 0; k < images.count; k++)
			stands |= after[piece_at(judge, images.at[k])
						  ->component] == ground;
		floating += before[i] == count && images.count > 0 && !stands;
	}
	return floating;
}

static enum tcs_status
judge_floating(const struct judge *judge, struct compare_metrics *metrics,
	struct tcs_fault *fault)
{
	double ground = judge->before->set.bounds.low[2];
	uint32_t *before = find_grounded(judge->before, ground + judge->eps);
	uint32_t *after = find_grounded(judge->after, ground + 2 * judge->eps);
	enum tcs_status status = TCS_OK;

	if (!before || !after)
		status = fault_memory(fault);
	else
		metrics->at[COMPARE_COMPONENTS_FLOATING] =
			count_floating(judge, before, after);
	free(before);
	free(after);
	return status;
}

/* ---- components ---------------------------------------------------------- */

/* What is left of a component, over all its images. */
struct remains {
	double area, volume;
	bool closed;
};

static struct remains
remains_of(const struct judge *judge, struct images images)
{
	struct remains remains = {.closed = true};

	for (size_t i = 0; i < images.count; i++) {
		const struct match_piece *piece = piece_at(judge, images.at[i]);
		const struct component *image = component_of(judge, piece);

		remains.area += piece->area;
		remains.volume += image->volume;
		remains.closed &= image->closed && !piece->region;
	}
	return remains;
}

static void
judge_components(const struct judge *judge, struct compare_metrics *metrics)
{
	const struct component_set *set = &judge->before->set;

	for (uint32_t i = 0; i < set->components.count; i++) {
		const struct component *own = &set->components.at[i];
		struct images images = match_images(judge->match, i);
		struct remains left = remains_of(judge, images);
		bool solid = own->closed && left.closed;

		if (!images.count)
			metrics->at[COMPARE_COMPONENTS_LOST]++;
		if (!images.count || judge->match->swallowed.at[i])
			continue;
		judge->crushed[i] = 10 * left.area < own->area ||
			(solid && 10 * fabs(left.volume) < fabs(own->volume));
		metrics->at[COMPARE_COMPONENTS_CRUSHED] += judge->crushed[i];
		metrics->at[COMPARE_COMPONENTS_FLIPPED] +=
			solid && left.volume * own->volume < 0;
	}
}

enum tcs_status
compare_contacts(const struct compare_side *before, struct compare_side *after,
	const struct compare_match *match, double eps,
	struct compare_metrics *metrics, struct broken_list *broken,
	struct tcs_fault *fault)
{
	size_t count = before->set.components.count;
	struct judge judge = {before, after, match, eps,
		calloc(count + 1, sizeof *judge.still),
		calloc(count + 1, sizeof *judge.crushed)};
	enum tcs_status status = TCS_OK;

	broken->count = 0;
	if (!judge.still || !judge.crushed)
		status = fault_memory(fault);
	else
		judge_components(&judge, metrics);
	if (!status)
		status = contacts_find(
			&after->set, 2 * eps, &after->contacts, fault);
	if (!status)
		status = split_work(count, COMPONENTS_AT_ONCE, before->set.jobs,
			find_still, &judge, fault);
	if (!status)
		status = judge_contacts(&judge, metrics, broken, fault);
	if (!status)
		status = judge_floating(&judge, metrics, fault);
	free(judge.still);
	free(judge.crushed);
	return status;
}
