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

TCS_ARRAY_TYPE(number_list, double);

#endif
