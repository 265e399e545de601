/*
 * Disjoint sets of numbers as a forest: parents[i] is the parent of i, that of
 * a root itself. A set's root is its least number.
 *
 * source: R. Tarjan, J. van Leeuwen, Worst-case analysis of set union
 * algorithms, 1984: path halving.
 */
#ifndef TESSERA_FOREST_H
#define TESSERA_FOREST_H

#include <stdint.h>

static inline uint32_t
forest_root(uint32_t *parents, uint32_t i)
{
	while (parents[i] != i) {
		parents[i] = parents[parents[i]];
		i = parents[i];
	}
	return i;
}

static inline void
forest_join(uint32_t *parents, uint32_t a, uint32_t b)
{
	a = forest_root(parents, a);
	b = forest_root(parents, b);
	if (a < b)
		parents[b] = a;
	else
		parents[a] = b;
}

#endif
