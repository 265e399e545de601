/* Lists of numbers as GML writes them, with white space between. */
#ifndef TESSERA_CITYGML_NUMBERS_H
#define TESSERA_CITYGML_NUMBERS_H

#include <stdbool.h>
#include <stddef.h>

#include "number.h"

/* XML's white space. */
static inline bool
is_blank(char c)
{
	return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/*
 * All numbers of a text, in place of those in the list; *bad when something
 * else stands there too, or a number is not finite.
 */
enum tcs_status numbers_read(struct number_list *numbers, const char *at,
	size_t length, bool *bad, struct tcs_fault *fault) TCS_CHECKED;

/*
 * The first numbers of a text, at most `want`, up to what is none; commas may
 * stand between them too. How many there were.
 */
int numbers_first(const char *at, size_t length, double *out, int want);

#endif
