#include "expansion.h"
#include "planar.h"

static double
orient_expanded(
	struct planar_point a, struct planar_point b, struct planar_point c)
{
	double terms[12];
	size_t count = 0;

	count = expansion_add_product(terms, count, a.x, b.y);
	count = expansion_add_product(terms, count, -a.y, b.x);
	count = expansion_add_product(terms, count, b.x, c.y);
	count = expansion_add_product(terms, count, -b.y, c.x);
	count = expansion_add_product(terms, count, c.x, a.y);
	count = expansion_add_product(terms, count, -c.y, a.x);
	return count ? terms[count - 1] : 0;
}

/*
 * Differences of neighbours are mostly exact; then two exact products are to
 * be compared, and rounding is monotonic.
 */
double
planar_orient_exact(
	struct planar_point a, struct planar_point b, struct planar_point c)
{
	struct exact_pair ax = exact_sum(a.x, -c.x), ay = exact_sum(a.y, -c.y);
	struct exact_pair bx = exact_sum(b.x, -c.x), by = exact_sum(b.y, -c.y);
	struct exact_pair left, right;

	if (ax.low != 0 || ay.low != 0 || bx.low != 0 || by.low != 0)
		return orient_expanded(a, b, c);
	left = exact_product(ax.high, by.high);
	right = exact_product(ay.high, bx.high);
	return left.high != right.high ? left.high - right.high
				       : left.low - right.low;
}
