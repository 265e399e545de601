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

/* Lists that are longer are left to the library. */
enum { NUMBER_SORT_MOST = 512 };

/*
 * `at` may be NULL where there are none.
 *
 * source: D. L. Shell, A high-speed sorting procedure, 1959; gaps of M. Ciura,
 * Best increments for the average case of Shellsort, 2001.
 */
static inline void
number_sort(uint32_t *at, size_t count)
{
	static const size_t gaps[] = {301, 132, 57, 23, 10, 4, 1};

	if (count > NUMBER_SORT_MOST) {
		qsort(at, count, sizeof *at, number_order);
		return;
	}
	for (size_t g = 0; g < sizeof gaps / sizeof *gaps; g++)
		for (size_t i = gaps[g]; i < count; i++) {
			uint32_t own = at[i];
			size_t place = i;

			for (; place >= gaps[g] && at[place - gaps[g]] > own;
				place -= gaps[g])
				at[place] = at[place - gaps[g]];
			at[place] = own;
		}
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
