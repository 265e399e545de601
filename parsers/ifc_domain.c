#include "ifc_domain.h"

#include <math.h>
#include <stdlib.h>

#include "planar.h"
#include "solid_points.h"

enum { MOST_POINTS = 1 << 18 }; /* of one piece */

/* A triangle whose height is a smaller part of its length is a line. */
static const double SLIVER = 1e-6;

static struct planar_point
flat(const struct ifc_domain *domain, uint32_t point)
{
	return (struct planar_point){
		domain->points.at[point].x, domain->points.at[point].y};
}

static struct tcs_point
surface_point(const struct ifc_surface *surface,
	const struct ifc_domain *domain, double x, double y)
{
	return ifc_surface_at(surface,
		(struct ifc_uv){{x * domain->scale[0], y * domain->scale[1]}});
}

static double
distance(struct tcs_point a, struct tcs_point b)
{
	struct tcs_point d = point_minus(a, b);

	return sqrt(point_dot(d, d));
}

/* ---- building ------------------------------------------------------------ */

enum ifc_outcome
ifc_domain_add(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	struct ifc_domain *domain, struct tcs_point at, struct ifc_uv uv)
{
	double x = uv.at[0] / domain->scale[0], y = uv.at[1] / domain->scale[1];

	if (!isfinite(x) || !isfinite(y))
		return ifc_refuse(shaper, STEP_NONE,
			"a surface's parameter is not finite");
	if (array_grow(&domain->points, 1))
		return IFC_NO_MEMORY;
	domain->points.at[domain->points.count++] = (struct ifc_domain_point){
		at, x, y, distance(at, ifc_surface_at(surface, uv))};
	return IFC_SHAPED;
}

struct side {
	uint32_t low, high; /* its points */
	uint32_t triangle, corner;
};

static int
sides_compare(const void *a, const void *b)
{
	const struct side *left = a, *right = b;

	if (left->low != right->low)
		return left->low < right->low ? -1 : 1;
	return left->high < right->high ? -1 : left->high > right->high;
}

/* Tell triangles of those they share sides with. */
static enum ifc_outcome
sides_join(struct ifc_domain *domain)
{
	size_t count = 3 * domain->triangles.count;
	struct side *sides = malloc((count + 1) * sizeof *sides);

	if (!sides)
		return IFC_NO_MEMORY;
	for (uint32_t i = 0; i < count; i++) {
		const uint32_t *corners = domain->triangles.at[i / 3].corners;
		uint32_t a = corners[i % 3], b = corners[(i + 1) % 3];

		sides[i] = (struct side){
			a < b ? a : b, a < b ? b : a, i / 3, i % 3};
	}
	qsort(sides, count, sizeof *sides, sides_compare);
	for (size_t i = 0; i + 1 < count; i++) {
		struct side *a = sides + i, *b = sides + i + 1;

		if (sides_compare(a, b))
			continue;
		domain->triangles.at[a->triangle].next[a->corner] = b->triangle;
		domain->triangles.at[b->triangle].next[b->corner] = a->triangle;
		i++;
	}
	free(sides);
	return IFC_SHAPED;
}

static enum ifc_outcome
triangles_take(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	struct ifc_domain *domain, const struct triangulation *from,
	bool turned)
{
	enum ifc_outcome outcome = IFC_SHAPED;

	for (size_t i = 0; i < from->extra_count && !outcome; i++) {
		struct tcs_point extra = from->extra[i];
		struct ifc_uv uv = {{extra.x * domain->scale[0],
			extra.y * domain->scale[1]}};

		outcome = ifc_domain_add(shaper, surface, domain,
			ifc_surface_at(surface, uv), uv);
	}
	if (outcome)
		return outcome;
	if (array_grow(&domain->triangles, from->triangle_count))
		return IFC_NO_MEMORY;
	for (size_t i = 0; i < from->triangle_count; i++) {
		const uint32_t *v = from->triangles[i].corner;

		domain->triangles.at[domain->triangles.count++] =
			(struct ifc_domain_triangle){
				{v[0], v[turned ? 2 : 1], v[turned ? 1 : 2]},
				{STEP_NONE, STEP_NONE, STEP_NONE}};
	}
	return sides_join(domain);
}

enum ifc_outcome
ifc_domain_triangulate(struct ifc_shaper *shaper,
	const struct ifc_surface *surface, struct ifc_domain *domain,
	const uint32_t *rings, size_t ring_count, bool *turned)
{
	struct triangulator *triangulator = triangulator_new();
	struct ifc_points flats = {.count = 0};
	struct triangulation all;
	struct tcs_fault fault;
	enum ifc_outcome outcome;

	outcome = triangulator
		? ifc_points_room(shaper, &flats, domain->points.count)
		: IFC_NO_MEMORY;
	for (size_t i = 0; i < domain->points.count && !outcome; i++)
		flats.at[flats.count++] = (struct tcs_point){
			domain->points.at[i].x, domain->points.at[i].y, 0};
	if (!outcome &&
		triangulate(triangulator, flats.at, rings, ring_count, &all,
			&fault))
		outcome = IFC_NO_MEMORY;
	if (!outcome && all.outcome == TRIANGULATION_EMPTY)
		outcome = ifc_refuse(
			shaper, STEP_NONE, "a face has no area in its surface");
	if (!outcome) {
		*turned = all.normal.z < 0;
		outcome =
			triangles_take(shaper, surface, domain, &all, *turned);
	}
	array_release(&flats);
	triangulator_free(triangulator);
	return outcome;
}

void
ifc_domain_release(struct ifc_domain *domain)
{
	array_release(&domain->points);
	array_release(&domain->triangles);
}

/* ---- flips --------------------------------------------------------------- */

static uint32_t
corner_facing(const struct ifc_domain_triangle *triangle, uint32_t next)
{
	return triangle->next[0] == next    ? 0
		: triangle->next[1] == next ? 1
					    : 2;
}

static void
next_replace(struct ifc_domain *domain, uint32_t triangle, uint32_t old,
	uint32_t new)
{
	if (triangle != STEP_NONE)
		domain->triangles.at[triangle].next[corner_facing(
			domain->triangles.at + triangle, old)] = new;
}

/* Whether d lies well within the circle through a, b and c. */
static bool
is_within(struct planar_point a, struct planar_point b, struct planar_point c,
	struct planar_point d)
{
	double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y;
	double cx = c.x - d.x, cy = c.y - d.y;
	double aa = ax * ax + ay * ay, bb = bx * bx + by * by;
	double cc = cx * cx + cy * cy;
	double value = aa * (bx * cy - by * cx) - bb * (ax * cy - ay * cx) +
		cc * (ax * by - ay * bx);
	double size = aa * (fabs(bx * cy) + fabs(by * cx)) +
		bb * (fabs(ax * cy) + fabs(ay * cx)) +
		cc * (fabs(ax * by) + fabs(ay * bx));

	return value > 1e-12 * size;
}

/* Give the edge at a corner to the other two points, if they should have it. */
static bool
edge_flip(struct ifc_domain *domain, uint32_t t, uint32_t i)
{
	struct ifc_domain_triangle *here = domain->triangles.at + t, *there;
	uint32_t o = here->next[i], j, a, b, c, d, n1, n2, m1, m2;

	if (o == STEP_NONE)
		return false;
	there = domain->triangles.at + o;
	j = corner_facing(there, t);
	a = here->corners[i];
	b = here->corners[(i + 1) % 3];
	c = here->corners[(i + 2) % 3];
	d = there->corners[(j + 2) % 3];
	if (!is_within(flat(domain, a), flat(domain, b), flat(domain, c),
		    flat(domain, d)) ||
		!(planar_orient(flat(domain, c), flat(domain, a),
			  flat(domain, d)) > 0) ||
		!(planar_orient(flat(domain, d), flat(domain, b),
			  flat(domain, c)) > 0))
		return false;
	n1 = here->next[(i + 1) % 3];
	n2 = here->next[(i + 2) % 3];
	m1 = there->next[(j + 1) % 3];
	m2 = there->next[(j + 2) % 3];
	*here = (struct ifc_domain_triangle){{c, a, d}, {n2, m1, o}};
	*there = (struct ifc_domain_triangle){{d, b, c}, {m2, n1, t}};
	next_replace(domain, m1, o, t);
	next_replace(domain, n1, t, o);
	return true;
}

/* ---- a list of triangles to look at -------------------------------------- */

TCS_ARRAY_TYPE(worklist, uint32_t);

static enum ifc_outcome
work_add(struct worklist *work, uint32_t triangle)
{
	if (triangle == STEP_NONE)
		return IFC_SHAPED;
	if (array_grow(work, 1))
		return IFC_NO_MEMORY;
	work->at[work->count++] = triangle;
	return IFC_SHAPED;
}

/*
 * Flip until the triangles of the list, and those that flips change, are
 * Delaunay; `seen` gets all of them.
 */
static enum ifc_outcome
flips_make(
	struct ifc_domain *domain, struct worklist *work, struct worklist *seen)
{
	enum ifc_outcome outcome = IFC_SHAPED;
	size_t most = 64 * (domain->triangles.count + 64);

	while (work->count && !outcome) {
		uint32_t t = work->at[--work->count];
		bool flipped = false;

		for (uint32_t i = 0; i < 3 && most && !flipped && !outcome;
			i++) {
			uint32_t other = domain->triangles.at[t].next[i];

			flipped = edge_flip(domain, t, i);
			if (!flipped)
				continue;
			most--;
			outcome = work_add(work, t);
			if (!outcome)
				outcome = work_add(work, other);
		}
		if (!outcome && !flipped)
			outcome = work_add(seen, t);
	}
	return outcome;
}

/* ---- new points ---------------------------------------------------------- */

static enum ifc_outcome
point_new(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	struct ifc_domain *domain, double x, double y, uint32_t *out)
{
	if (shaper->points >= IFC_MOST_POINTS)
		return ifc_refuse(shaper, STEP_NONE, "too many points");
	shaper->points++;
	if (array_grow(&domain->points, 1) || array_grow(&domain->triangles, 2))
		return IFC_NO_MEMORY;
	*out = (uint32_t)domain->points.count;
	domain->points.at[domain->points.count++] = (struct ifc_domain_point){
		surface_point(surface, domain, x, y), x, y, 0};
	return IFC_SHAPED;
}

/* Make three of one triangle; room for two more is there. */
static void
triangle_split(
	struct ifc_domain *domain, uint32_t t, uint32_t p, uint32_t made[4])
{
	struct ifc_domain_triangle old = domain->triangles.at[t];
	uint32_t second = (uint32_t)domain->triangles.count;
	uint32_t third = second + 1;

	domain->triangles.count += 2;
	domain->triangles.at[t] = (struct ifc_domain_triangle){
		{old.corners[0], old.corners[1], p},
		{old.next[0], second, third}};
	domain->triangles.at[second] = (struct ifc_domain_triangle){
		{old.corners[1], old.corners[2], p}, {old.next[1], third, t}};
	domain->triangles.at[third] = (struct ifc_domain_triangle){
		{old.corners[2], old.corners[0], p}, {old.next[2], t, second}};
	next_replace(domain, old.next[1], t, second);
	next_replace(domain, old.next[2], t, third);
	made[0] = t;
	made[1] = second;
	made[2] = third;
	made[3] = STEP_NONE;
}

/* Make four of two triangles that share the edge at a corner of one. */
static void
edge_split(struct ifc_domain *domain, uint32_t t, uint32_t i, uint32_t p,
	uint32_t made[4])
{
	struct ifc_domain_triangle here = domain->triangles.at[t];
	uint32_t o = here.next[i];
	struct ifc_domain_triangle there = domain->triangles.at[o];
	uint32_t j = corner_facing(&there, t);
	uint32_t a = here.corners[i], b = here.corners[(i + 1) % 3];
	uint32_t c = here.corners[(i + 2) % 3], d = there.corners[(j + 2) % 3];
	uint32_t n1 = here.next[(i + 1) % 3], n2 = here.next[(i + 2) % 3];
	uint32_t m1 = there.next[(j + 1) % 3], m2 = there.next[(j + 2) % 3];
	uint32_t t2 = (uint32_t)domain->triangles.count, o2 = t2 + 1;
	struct ifc_domain_triangle *all = domain->triangles.at;

	domain->triangles.count += 2;
	all[t] = (struct ifc_domain_triangle){{a, p, c}, {o2, t2, n2}};
	all[t2] = (struct ifc_domain_triangle){{p, b, c}, {o, n1, t}};
	all[o] = (struct ifc_domain_triangle){{b, p, d}, {t2, o2, m2}};
	all[o2] = (struct ifc_domain_triangle){{p, a, d}, {t, m1, o}};
	next_replace(domain, n1, t, t2);
	next_replace(domain, m1, o, o2);
	made[0] = t;
	made[1] = t2;
	made[2] = o;
	made[3] = o2;
}

/* ---- refining ------------------------------------------------------------ */

/* How far the middle of some corners is off the surface where it should be. */
static double
middle_off(const struct ifc_surface *surface, const struct ifc_domain *domain,
	const uint32_t *corners, size_t count, double *x, double *y)
{
	struct tcs_point sum = {0, 0, 0};

	*x = *y = 0;
	for (size_t i = 0; i < count; i++) {
		const struct ifc_domain_point *point =
			domain->points.at + corners[i];

		sum = point_plus(sum, point->at);
		*x += point->x / (double)count;
		*y += point->y / (double)count;
	}
	sum = (struct tcs_point){sum.x / (double)count, sum.y / (double)count,
		sum.z / (double)count};
	return distance(sum, surface_point(surface, domain, *x, *y));
}

/* What is wrong where: an edge, from its corner, or with 3 the whole. */
struct flaw {
	double x, y;
	uint32_t at;
	double off;
};

/* Whether a triangle is all but a line: no point fits into it. */
static bool
is_sliver(const struct ifc_domain *domain, uint32_t t)
{
	const uint32_t *corners = domain->triangles.at[t].corners;
	struct planar_point a = flat(domain, corners[0]);
	struct planar_point b = flat(domain, corners[1]);
	struct planar_point c = flat(domain, corners[2]);
	double longest = fmax(hypot(b.x - a.x, b.y - a.y),
		fmax(hypot(c.x - b.x, c.y - b.y), hypot(a.x - c.x, a.y - c.y)));

	return !(planar_orient(a, b, c) > SLIVER * longest * longest);
}

/* The worst place of a triangle, beyond what its border makes it be off. */
static bool
flaw_find(const struct ifc_shaper *shaper, const struct ifc_surface *surface,
	const struct ifc_domain *domain, uint32_t t, struct flaw *out)
{
	const struct ifc_domain_triangle *triangle = domain->triangles.at + t;
	double allowed = 0, x, y, off;

	*out = (struct flaw){.off = 0};
	if (is_sliver(domain, t))
		return false;
	for (uint32_t i = 0; i < 3; i++) {
		uint32_t edge[2] = {
			triangle->corners[i], triangle->corners[(i + 1) % 3]};

		allowed = fmax(allowed, domain->points.at[edge[0]].off);
		off = middle_off(surface, domain, edge, 2, &x, &y);
		if (triangle->next[i] == STEP_NONE)
			allowed = fmax(allowed, off);
		else if (off > out->off &&
			!is_sliver(domain, triangle->next[i]))
			*out = (struct flaw){x, y, i, off};
	}
	allowed = fmax(shaper->deflection, 1.1 * allowed);
	if (out->off > allowed)
		return true;
	off = middle_off(surface, domain, triangle->corners, 3, &x, &y);
	*out = (struct flaw){x, y, 3, off};
	return off > allowed;
}

static enum ifc_outcome
flaw_mend(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	struct ifc_domain *domain, uint32_t t, const struct flaw *flaw,
	struct worklist *work)
{
	uint32_t point = 0, made[4];
	enum ifc_outcome outcome =
		point_new(shaper, surface, domain, flaw->x, flaw->y, &point);

	if (outcome)
		return outcome;
	if (flaw->at == 3)
		triangle_split(domain, t, point, made);
	else
		edge_split(domain, t, flaw->at, point, made);
	for (int i = 0; i < 4 && !outcome; i++)
		outcome = work_add(work, made[i]);
	return outcome;
}

enum ifc_outcome
ifc_domain_refine(struct ifc_shaper *shaper, const struct ifc_surface *surface,
	struct ifc_domain *domain)
{
	size_t most = domain->points.count + MOST_POINTS;
	struct worklist work = {.count = 0}, seen = work, now = work;
	enum ifc_outcome outcome = IFC_SHAPED;

	for (uint32_t i = 0; i < domain->triangles.count && !outcome; i++)
		outcome = work_add(&work, i);
	if (!outcome)
		outcome = flips_make(domain, &work, &seen);
	/* Each generation before the next, so that all gets finer alike. */
	while (seen.count && !outcome) {
		struct worklist swap = now;

		now = seen;
		seen = swap;
		array_clear(&seen);
		for (size_t i = 0; i < now.count && !outcome &&
			domain->points.count < most;
			i++) {
			struct flaw flaw;

			if (!flaw_find(
				    shaper, surface, domain, now.at[i], &flaw))
				continue;
			outcome = flaw_mend(shaper, surface, domain, now.at[i],
				&flaw, &work);
			if (!outcome)
				outcome = flips_make(domain, &work, &seen);
		}
	}
	array_release(&now);
	array_release(&work);
	array_release(&seen);
	return outcome;
}
