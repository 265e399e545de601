/*
 * Lists of numbers in ascending order.
 */
#ifndef TESSERA_NUMBER_SORT_H
#define TESSERA_NUMBER_SORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

static inline int
number_order(const void *left, const void *right)
{
	const uint32_t *a = left, *b = right;

	return (*a > *b) - (*a < *b);
}

/* `at` may be NULL where there are none. */
static inline void
number_sort(uint32_t *at, size_t count)
{
	if (count > 1)
		qsort(at, count, sizeof *at, number_order);
}

/* The same, each once; how many are left. */
static inline size_t
number_sort_once(uint32_t *at, size_t count)
{
	size_t kept = 0;

	number_sort(at, count);
	for (size_t i = 0; i < count; i++)
		if (i == 0 || at[i] != at[kept - 1])
			at[kept++] = at[i];
	return kept;
}

/* Whether a sorted list has it. */
static inline bool
number_is_among(const uint32_t *at, size_t count, uint32_t number)
{
	return count > 0 &&
		bsearch(&number, at, count, sizeof *at, number_order) != NULL;
}

#endif
