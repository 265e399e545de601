#include "contacts.h"

#include <math.h>
#include <stdlib.h>

struct search {
	const struct component_set *set;
	struct contact_list *contacts;
	double reach;
	bool failed; /* for want of memory */
};

double
contact_reach(const struct component_set *set)
{
	return fmax(0.01, 0.001 * box_diagonal(&set->bounds));
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

static bool
judge_pair(void *context, uint32_t left, uint32_t right)
{
	struct search *search = context;
	const struct component_set *set = search->set;
	uint32_t a = set->boxes.items.at[left];
	uint32_t b = set->boxes.items.at[right];
	struct contact contact = {.a = a < b ? a : b, .b = a < b ? b : a};

	if (box_gap_squared(&set->components.at[a].box,
		    &set->components.at[b].box) > search->reach * search->reach)
		return true;
	if (!touches(search, &contact)) {
		contact.inside = encloses(set, a, b, &contact) ||
			encloses(set, b, a, &contact);
		if (!contact.inside)
			return true;
	}
	if (array_grow(search->contacts, 1)) {
		search->failed = true;
		return false;
	}
	search->contacts->at[search->contacts->count++] = contact;
	return true;
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
	struct search search = {set, contacts, reach, false};

	array_clear(contacts);
	if (!set->components.count)
		return TCS_OK;
	box_tree_pairs(&set->boxes, set->box_root, set->box_root, reach,
		judge_pair, &search);
	if (search.failed)
		return fault_memory(fault);
	if (contacts->count > 0)
		qsort(contacts->at, contacts->count, sizeof *contacts->at,
			by_components);
	return TCS_OK;
}
