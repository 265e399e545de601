/*
 * Loops narrower than the tolerance, which near-coincident planes leave, joined
 * to the face beyond their longest edge; and names for faces that have none.
 */
#ifndef TESSERA_SOLID_SLIVERS_H
#define TESSERA_SOLID_SLIVERS_H

#include "solid_outline.h"

/*
 * Change outline->rims and the names of outline->fragments. No joint is
 * straight yet. Fails with TCS_NO_MEMORY.
 */
enum tcs_status solid_slivers_join(struct solid_outline *outline,
	const struct solid_carver *carver, struct tcs_fault *fault) TCS_CHECKED;

#endif
