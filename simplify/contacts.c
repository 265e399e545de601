#include "contacts.h"

#include <math.h>
#include <stdlib.h>

#include "split_work.h"

enum { BATCH = 1 << 16, CONTACTS_AT_ONCE = 64 };

/* A pair of components, and whether it is in contact. */
struct candidate {
	struct contact contact;
	bool holds;
};

struct search {
	const struct component_set *set;
	struct contact_list *contacts;
	double reach;
	struct candidate *batch;
	size_t count; /* of the batch */
	enum tcs_status status;
	struct tcs_fault *fault;
};

double
contact_reach(const struct component_set *set)
{
	return fmin(0.1, fmax(0.01, 0.001 * box_diagonal(&set->bounds)));
}

static struct tcs_point
first_point(const struct component_set *set, const struct component *component)
{
	return component_set_shape(set, set->order.at[component->first])
		.corner[0];
}

/* Surfaces that do not touch: one of its points tells where all lie. */
static bool
encloses(const struct component_set *set, uint32_t outer, uint32_t inner,
	struct contact *contact)
{
	const struct component *shell = &set->components.at[outer];

	contact->at = first_point(set, &set->components.at[inner]);
	return shell->closed &&
		triangle_tree_encloses(&set->tree, shell->root, contact->at);
}

static bool
touches(const struct search *search, struct contact *contact)
{
	const struct component_set *set = search->set;
	struct tree_gap gap = triangle_tree_gap(&set->tree,
		set->components.at[contact->a].root,
		set->components.at[contact->b].root, search->reach,
		search->reach);

	contact->at = gap.points[0];
	return gap.distance <= search->reach;
}

static void
judge_some(void *context, size_t piece, size_t first, size_t end)
{
	const struct search *search = context;
	const struct component_set *set = search->set;

	(void)piece;
	for (size_t i = first; i < end; i++) {
		struct contact *contact = &search->batch[i].contact;

		search->batch[i].holds = touches(search, contact);
		if (search->batch[i].holds)
			continue;
		contact->inside =
			encloses(set, contact->a, contact->b, contact) ||
			encloses(set, contact->b, contact->a, contact);
		search->batch[i].holds = contact->inside;
	}
}

static enum tcs_status
judge_batch(struct search *search)
{
	enum tcs_status status = split_work(search->count, CONTACTS_AT_ONCE,
		search->set->jobs, judge_some, search, search->fault);

	for (size_t i = 0; !status && i < search->count; i++) {
		if (!search->batch[i].holds)
			continue;
		if (array_grow(search->contacts, 1))
			return fault_memory(search->fault);
		search->contacts->at[search->contacts->count++] =
			search->batch[i].contact;
	}
	search->count = 0;
	return status;
}

static bool
add_pair(void *context, uint32_t left, uint32_t right)
{
	struct search *search = context;
	const struct component_set *set = search->set;
	uint32_t a = set->boxes.items.at[left];
	uint32_t b = set->boxes.items.at[right];

	if (box_gap_squared(&set->components.at[a].box,
		    &set->components.at[b].box) > search->reach * search->reach)
		return true;
	search->batch[search->count++] = (struct candidate){
		.contact = {.a = a < b ? a : b, .b = a < b ? b : a}};
	if (search->count == BATCH)
		search->status = judge_batch(search);
	return !search->status;
}

static int
by_components(const void *left, const void *right)
{
	const struct contact *p = left, *q = right;

	if (p->a != q->a)
		return p->a < q->a ? -1 : 1;
	return (p->b > q->b) - (p->b < q->b);
}

enum tcs_status
contacts_find(const struct component_set *set, double reach,
	struct contact_list *contacts, struct tcs_fault *fault)
{
	struct search search = {.set = set,
		.contacts = contacts,
		.reach = reach,
		.fault = fault};

	array_clear(contacts);
	if (!set->components.count)
		return TCS_OK;
	search.batch = calloc(BATCH, sizeof *search.batch);
	if (!search.batch)
		return fault_memory(fault);
	box_tree_pairs(&set->boxes, set->box_root, set->box_root, reach,
		add_pair, &search);
	if (!search.status)
		search.status = judge_batch(&search);
	free(search.batch);
	if (!search.status && contacts->count > 0)
		qsort(contacts->at, contacts->count, sizeof *contacts->at,
			by_components);
	return search.status;
}
