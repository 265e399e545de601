/*
 * The prototypes of a stream, kept for the instances behind them. One thread
 * adds while others look up what was added before: entries never move.
 */
#ifndef TESSERA_PROTOTYPES_H
#define TESSERA_PROTOTYPES_H

#include <stdint.h>

#include "fault.h"
#include "tcs.h"

enum { PROTOTYPE_PAGES = 32 };

struct prototype;

/* All zero is empty. Page n holds 2^n entries. */
struct prototypes {
	struct prototype *pages[PROTOTYPE_PAGES];
	uint32_t count;
};

/* Keep a copy of the record, decoded. */
enum tcs_status prototypes_add(struct prototypes *prototypes,
	const struct tcs_record *record, struct tcs_fault *fault) TCS_CHECKED;

/* `number` is below the count at some earlier moment. */
const struct tcs_object *prototypes_get(
	const struct prototypes *prototypes, uint32_t number);

void prototypes_release(struct prototypes *prototypes);

#endif
