/*
 * Contacts: which components of an object touch, nearly touch, intersect, or
 * lie one inside the other.
 *
 * source: W, boundary vertices and their buffer; here for whole components,
 * and for those that only rest on each other as well.
 */
#ifndef TESSERA_CONTACTS_H
#define TESSERA_CONTACTS_H

#include "component_set.h"

struct contact {
	uint32_t a, b; /* components, a < b */
	uint32_t
		inside; /* 1: their surfaces are apart, one encloses the other */
	struct tcs_point at; /* where they touch; of the inner one a point */
};

TCS_ARRAY_TYPE(contact_list, struct contact);

/* What counts as touching in an object of this size: 0.1 % of the diagonal, but
   from 1 cm to 10 cm: parts of a terminal or of a block of houses are no
   farther apart than those of a house. Metres. */
double contact_reach(const struct component_set *set);

/*
 * Every pair of components whose surfaces are at most `reach` apart, or of
 * which a closed one encloses the other; by a, then b. What the list held is
 * forgotten. Takes n log n steps for n triangles, and a few for every pair of
 * components whose boxes meet. Fails with TCS_NO_MEMORY.
 */
enum tcs_status contacts_find(const struct component_set *set, double reach,
	struct contact_list *contacts, struct tcs_fault *fault) TCS_CHECKED;

#endif
