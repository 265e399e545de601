#include <math.h>

#include "expansion.h"
#include "solid_planes.h"

/* Most terms of a determinant of rank 3, and of four of them times a number. */
enum { TERMS_3 = 24, TERMS_4 = 4 * 2 * TERMS_3 };

/* An exact number. */
struct exact {
	double terms[TERMS_3 + 1];
	size_t count;
};

static void
add_triple(struct exact *sum, double a, double b, double c)
{
	struct exact_pair both = exact_product(a, b);

	sum->count = expansion_add_product(sum->terms, sum->count, both.low, c);
	sum->count =
		expansion_add_product(sum->terms, sum->count, both.high, c);
}

static struct exact
determinant(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	struct exact sum = {.count = 0};

	add_triple(&sum, a.x, b.y, c.z);
	add_triple(&sum, -a.x, b.z, c.y);
	add_triple(&sum, a.y, b.z, c.x);
	add_triple(&sum, -a.y, b.x, c.z);
	add_triple(&sum, a.z, b.x, c.y);
	add_triple(&sum, -a.z, b.y, c.x);
	return sum;
}

static int
sign_of(const double *terms, size_t count)
{
	if (!count)
		return 0;
	return terms[count - 1] > 0 ? 1 : -1;
}

/* Rounded to about the last place. */
static double
value_of(const struct exact *number)
{
	double sum = 0;

	for (size_t i = 0; i < number->count; i++)
		sum += number->terms[i];
	return sum;
}

/*
 * The determinant of the four planes' normals and reaches is that of the
 * corner's three normals times the negative distance.
 */
int
solid_corner_side_exact(const struct solid_plane *planes,
	const struct solid_corner *corner, uint32_t plane)
{
	const struct solid_plane *row[4] = {&planes[corner->planes[0]],
		&planes[corner->planes[1]], &planes[corner->planes[2]],
		&planes[plane]};
	double terms[TERMS_4 + 1];
	size_t count = 0;
	struct exact three = {.count = 0};

	for (unsigned i = 0; i < 4; i++) {
		double reach = i % 2 ? row[i]->reach : -row[i]->reach;

		three = determinant(row[i == 0]->normal,
			row[i <= 1 ? 2 : 1]->normal,
			row[i <= 2 ? 3 : 2]->normal);
		for (size_t j = 0; j < three.count; j++)
			count = expansion_add_product(
				terms, count, three.terms[j], reach);
	}
	return -sign_of(terms, count) * sign_of(three.terms, three.count);
}

/* One coordinate at a time, by Cramer's rule, without an error to speak of. */
static void
corner_solve(const struct solid_plane *planes, struct solid_corner *corner)
{
	const struct solid_plane *a = &planes[corner->planes[0]],
				 *b = &planes[corner->planes[1]],
				 *c = &planes[corner->planes[2]];
	struct tcs_point p = a->normal, q = b->normal, r = c->normal;
	struct exact number = determinant(p, q, r);
	double divisor = value_of(&number);

	p.x = a->reach, q.x = b->reach, r.x = c->reach;
	number = determinant(p, q, r);
	corner->at.x = value_of(&number) / divisor;
	p = a->normal, q = b->normal, r = c->normal;
	p.y = a->reach, q.y = b->reach, r.y = c->reach;
	number = determinant(p, q, r);
	corner->at.y = value_of(&number) / divisor;
	p = a->normal, q = b->normal, r = c->normal;
	p.z = a->reach, q.z = b->reach, r.z = c->reach;
	number = determinant(p, q, r);
	corner->at.z = value_of(&number) / divisor;
	corner->error = 1e-14 *
		(fabs(corner->at.x) + fabs(corner->at.y) + fabs(corner->at.z));
}

/*
 * With u half a unit of the last place of 1, the cross products are off by less
 * than 4 u, the divisor by 16 u and the sums by 12 u times the reaches; the
 * distance from a plane adds 6 u of the coordinates. The factor is 64 u.
 */
struct solid_corner
solid_corner_of(
	const struct solid_plane *planes, uint32_t a, uint32_t b, uint32_t c)
{
	const struct solid_plane *p = &planes[a], *q = &planes[b],
				 *r = &planes[c];
	struct solid_corner corner = {.planes = {a, b, c}};
	struct tcs_point qr = point_cross(q->normal, r->normal);
	struct tcs_point rp = point_cross(r->normal, p->normal);
	struct tcs_point pq = point_cross(p->normal, q->normal);
	double divisor = point_dot(p->normal, qr), size;

	corner.at.x =
		(p->reach * qr.x + q->reach * rp.x + r->reach * pq.x) / divisor;
	corner.at.y =
		(p->reach * qr.y + q->reach * rp.y + r->reach * pq.y) / divisor;
	corner.at.z =
		(p->reach * qr.z + q->reach * rp.z + r->reach * pq.z) / divisor;
	size = fabs(p->reach) + fabs(q->reach) + fabs(r->reach) +
		fabs(corner.at.x) + fabs(corner.at.y) + fabs(corner.at.z);
	corner.error = 7.2e-15 * size / fabs(divisor);
	if (!(fabs(divisor) > 1e-4))
		corner_solve(planes, &corner);
	return corner;
}
