#include "planar.h"

/* An unevaluated sum; |low| is at most half a unit of high's last place. */
struct pair {
	double high, low;
};

static struct pair
sum(double a, double b)
{
	double high = a + b;
	double part = high - a;

	return (struct pair){high, (a - (high - part)) + (b - part)};
}

/* Dekker's split into halves of 26 bits. */
static struct pair
split(double a)
{
	double c = 134217729.0 * a;
	double high = c - (c - a);

	return (struct pair){high, a - high};
}

static struct pair
product(double a, double b)
{
	struct pair p = split(a), q = split(b);
	double high = a * b;
	double rest = high - p.high * q.high;

	rest -= p.low * q.high;
	rest -= p.high * q.low;
	return (struct pair){high, p.low * q.low - rest};
}

/* Nonoverlapping terms of one exact sum, the smallest first. */
struct expansion {
	double terms[12];
	size_t count;
};

static void
expansion_add(struct expansion *all, double term)
{
	size_t count = 0;

	for (size_t i = 0; i < all->count; i++) {
		struct pair both = sum(term, all->terms[i]);

		if (both.low != 0)
			all->terms[count++] = both.low;
		term = both.high;
	}
	if (term != 0)
		all->terms[count++] = term;
	all->count = count;
}

static void
expansion_add_product(struct expansion *all, double a, double b)
{
	struct pair both = product(a, b);

	expansion_add(all, both.low);
	expansion_add(all, both.high);
}

static double
orient_expanded(
	struct planar_point a, struct planar_point b, struct planar_point c)
{
	struct expansion all = {.count = 0};

	expansion_add_product(&all, a.x, b.y);
	expansion_add_product(&all, -a.y, b.x);
	expansion_add_product(&all, b.x, c.y);
	expansion_add_product(&all, -b.y, c.x);
	expansion_add_product(&all, c.x, a.y);
	expansion_add_product(&all, -c.y, a.x);
	return all.count ? all.terms[all.count - 1] : 0;
}

/*
 * Differences of neighbours are mostly exact; then two exact products are to
 * be compared, and rounding is monotonic.
 */
double
planar_orient_exact(
	struct planar_point a, struct planar_point b, struct planar_point c)
{
	struct pair ax = sum(a.x, -c.x), ay = sum(a.y, -c.y);
	struct pair bx = sum(b.x, -c.x), by = sum(b.y, -c.y);
	struct pair left, right;

	if (ax.low != 0 || ay.low != 0 || bx.low != 0 || by.low != 0)
		return orient_expanded(a, b, c);
	left = product(ax.high, by.high);
	right = product(ay.high, bx.high);
	return left.high != right.high ? left.high - right.high
				       : left.low - right.low;
}
