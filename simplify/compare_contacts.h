/*
 * What became of the contacts and of the components of an object.
 */
#ifndef TESSERA_COMPARE_CONTACTS_H
#define TESSERA_COMPARE_CONTACTS_H

#include "compare_match.h"
#include "compare_metrics.h"

enum contact_state {
	CONTACT_KEPT,
	CONTACT_SEPARATED, /* both sides alive, over 2 eps apart */
	CONTACT_HALF_OPEN, /* a quarter of the seam or more gapes over 2 eps */
	CONTACT_LOST, /* a side vanished */
};

/* One contact that was not kept. */
struct broken_contact {
	enum contact_state state;
	uint32_t a, b; /* components before */
	double gap; /* metres; INFINITY when lost */
};

TCS_ARRAY_TYPE(broken_list, struct broken_contact);

/*
 * Judge the contacts of `before`, which are known, and its components: fills
 * the metrics of both, and lists what broke, in the order of the contacts.
 * Fails with TCS_NO_MEMORY.
 */
enum tcs_status compare_contacts(const struct compare_side *before,
	struct compare_side *after, const struct compare_match *match,
	double eps, struct compare_metrics *metrics, struct broken_list *broken,
	struct tcs_fault *fault) TCS_CHECKED;

#endif
