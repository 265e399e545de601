/*
 * Numbers as text, whatever the locale: exact in, shortest out.
 */
#ifndef TESSERA_NUMBER_H
#define TESSERA_NUMBER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "array.h"
#include "fault.h"

/*
 * Parse the longest prefix of [at, end) that is a decimal number: an optional
 * sign, digits with an optional point, an optional exponent (e or E). Leading
 * white space is not skipped; hexadecimal, "inf" and "nan" are not numbers.
 * The result is the double nearest to the written value, ties to even, for any
 * count of digits; beyond the range it is ±infinity, below it ±0.
 *
 * Returns the first byte behind the number, or NULL where none begins. An "e"
 * that no digit follows is not part of the number.
 */
const char *number_parse(const char *at, const char *end, double *out);

/* The longest prefix that is a decimal integer within int64_t, else NULL. */
const char *number_parse_integer(const char *at, const char *end, int64_t *out);

#define NUMBER_LENGTH 32 /* room that number_print needs */

/*
 * Write the shortest decimal that number_parse reads back to the same bits;
 * among the shortest, the nearest. Plain digits for 1e-5 ≤ |value| < 1e17
 * ("0.00012", "5333770"), else with an exponent ("1e-7", "-2.5e+300"); no
 * ".0" behind an integer; -0 is "-0"; NaN and infinities are "nan", "inf",
 * "-inf". Returns the length; the text is not terminated.
 */
size_t number_print(char out[NUMBER_LENGTH], double value);

/*
 * A run of numbers separated by XML white space that arrives in pieces, as
 * the text of a gml:posList does: a number may be cut anywhere. All zero is
 * the start; number_scan_finish makes it ready for the next run.
 */
struct number_scan {
	TCS_ARRAY(char) held; /* the cut number at the end of the last piece */
	uint64_t seen; /* bytes of the run in earlier pieces */
	uint64_t bad; /* tokens that are no finite number */
	uint64_t bad_at; /* where in the run the first of them begins */
};

#define NUMBER_MAX_TOKEN 4096 /* bytes of one number; longer ones are bad */

TCS_ARRAY_TYPE(number_list, double);

/*
 * Append the numbers of the next piece to `out`. A token that is no number,
 * that overflows, or is too long is counted in `bad` and stands in `out` as
 * NaN, so that positions keep their places. Fails with TCS_NO_MEMORY.
 */
enum tcs_status number_scan_feed(struct number_scan *scan, const char *bytes,
	size_t length, struct number_list *out,
	struct tcs_fault *fault) TCS_CHECKED;

/* The run is over: take the number still held. Resets all but bad, bad_at. */
enum tcs_status number_scan_finish(struct number_scan *scan,
	struct number_list *out, struct tcs_fault *fault) TCS_CHECKED;

void number_scan_release(struct number_scan *scan);

#endif
