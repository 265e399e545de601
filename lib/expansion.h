/*
 * Exact sums and products of doubles, as sums of doubles that do not overlap.
 * Exact as long as nothing over- or underflows.
 *
 * source: J. R. Shewchuk, Adaptive precision floating-point arithmetic and
 * fast robust geometric predicates, 1997.
 */
#ifndef TESSERA_EXPANSION_H
#define TESSERA_EXPANSION_H

#include <stddef.h>

/* An unevaluated sum; |low| is at most half a unit of high's last place. */
struct exact_pair {
	double high, low;
};

static inline struct exact_pair
exact_sum(double a, double b)
{
	double high = a + b;
	double part = high - a;

	return (struct exact_pair){high, (a - (high - part)) + (b - part)};
}

/* Dekker's split into halves of 26 bits. */
static inline struct exact_pair
exact_split(double a)
{
	double c = 134217729.0 * a;
	double high = c - (c - a);

	return (struct exact_pair){high, a - high};
}

static inline struct exact_pair
exact_product(double a, double b)
{
	struct exact_pair p = exact_split(a), q = exact_split(b);
	double high = a * b;
	double rest = high - p.high * q.high;

	rest -= p.low * q.high;
	rest -= p.high * q.low;
	return (struct exact_pair){high, p.low * q.low - rest};
}

/*
 * Add a term to an expansion, the smallest term first, none of them 0. There is
 * room for one more than `count` terms. Returns the new count; the last term
 * has the sign of the sum.
 */
static inline size_t
expansion_add(double *terms, size_t count, double term)
{
	size_t kept = 0;

	for (size_t i = 0; i < count; i++) {
		struct exact_pair both = exact_sum(term, terms[i]);

		if (both.low != 0)
			terms[kept++] = both.low;
		term = both.high;
	}
	if (term != 0)
		terms[kept++] = term;
	return kept;
}

/* The same with a product, which takes room for two. */
static inline size_t
expansion_add_product(double *terms, size_t count, double a, double b)
{
	struct exact_pair both = exact_product(a, b);

	count = expansion_add(terms, count, both.low);
	return expansion_add(terms, count, both.high);
}

#endif
