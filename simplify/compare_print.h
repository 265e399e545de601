/* The report of tcs-compare: one object after the other, then all of them. */
#ifndef TESSERA_COMPARE_PRINT_H
#define TESSERA_COMPARE_PRINT_H

#include "compare_object.h"

struct compare_totals {
	struct compare_metrics metrics;
	uint64_t pairs, lost, added; /* objects */
};

/* Errors are the stream's. `before` names what was lost; NULL for an object
   that was added. */
void compare_print_begin(bool json, FILE *to);
void compare_print_object(const struct compare_result *result,
	const struct tcs_object *before, const struct tcs_object *after,
	bool json, bool first, FILE *to);
void compare_print_end(
	const struct compare_totals *totals, bool json, FILE *to);

#endif
