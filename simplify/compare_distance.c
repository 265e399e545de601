#include "compare_distance.h"

#include <math.h>
#include <stdlib.h>

#include "split_work.h"
#include "vector.h"

#define ROUNDING 1e-9 /* metres */
#define THINNEST 1e-6 /* metres */

enum {
	PIECE = 1024, /* triangles, or points, per piece of work */
	CUTS = 40 * PIECE, /* of all triangles of a piece of work */
	PARTS = PIECE + 2 * CUTS, /* and what they are cut into */
	MOST_SAMPLES = 2000000,
};

/* A place, and the triangle of the other side nearest to it. */
struct near_hit {
	double distance;
	uint32_t triangle;
};

/* What a piece of work has found. */
struct found {
	double max, at_most;
	double area, sum, squares;
	bool failed; /* for want of memory */
};

/* A part of a triangle. */
struct part {
	struct triangle_shape shape;
	uint32_t triangle; /* nearest to its middle */
	double bound; /* no point of it is farther away */
};

struct measure {
	const struct compare_side *from, *to;
	double tolerance, spacing;
	double corner_max; /* over all points */
	struct near_hit *hits; /* per point of `from` */
	struct found *found; /* per piece of work */
};

static struct tcs_point
centre_of(const struct triangle_shape *t)
{
	return vector_scaled(vector_sum(t->corner[0],
				     vector_sum(t->corner[1], t->corner[2])),
		1.0 / 3);
}

static double
distance_from(const struct measure *measure, uint32_t triangle,
	struct tcs_point point)
{
	struct triangle_shape shape =
		component_set_shape(&measure->to->set, triangle);

	return vector_length(
		vector_difference(triangle_nearest(&shape, point), point));
}

/* The search begins no farther away than the triangle found last. */
static struct near_hit
find_near(const struct measure *measure, struct tcs_point from, uint32_t last)
{
	double reach = distance_from(measure, last, from);
	struct tree_hit hit = triangle_tree_nearest(&measure->to->surfaces,
		measure->to->whole, from, reach * (1 + 1e-9) + 1e-12);

	return (struct near_hit){hit.distance, hit.item};
}

/* ---- the largest --------------------------------------------------------- */

static void
measure_points(void *context, size_t piece, size_t first, size_t end)
{
	struct measure *measure = context;
	uint32_t last = 0;
	double max = 0;

	for (size_t i = first; i < end; i++) {
		struct near_hit hit = find_near(
			measure, measure->from->set.points.at[i], last);

		measure->hits[i] = hit;
		last = hit.triangle;
		max = fmax(max, hit.distance);
	}
	measure->found[piece].max = max;
}

/* No point of the shape is farther from the triangle than this. */
static double
farthest_from(const struct measure *measure, const struct triangle_shape *shape,
	uint32_t triangle)
{
	double farthest = 0;

	for (int i = 0; i < 3; i++)
		farthest = fmax(farthest,
			distance_from(measure, triangle, shape->corner[i]));
	return farthest;
}

/* How far three points lie on the inner side of one edge of a triangle. */
struct sides {
	double at[3];
	double least; /* of how far they are on either side; 0: one side only */
};

static struct sides
sides_of(const struct triangle_shape *shape, const struct triangle_shape *other,
	int number)
{
	struct tcs_point a = other->corner[number];
	struct tcs_point edge =
		vector_difference(other->corner[(number + 1) % 3], a);
	struct tcs_point normal = triangle_normal(other);
	struct tcs_point inwards = vector_cross(normal, edge);
	double length = vector_length(inwards);
	double low = 0, high = 0;
	struct sides sides = {.least = 0};

	/* Of a sliver nobody knows where its inner side is. */
	if (!(vector_length(normal) > THINNEST * vector_length(edge)))
		return sides;
	for (int i = 0; i < 3; i++) {
		sides.at[i] = vector_dot(inwards,
				      vector_difference(shape->corner[i], a)) /
			length;
		low = fmin(low, sides.at[i]);
		high = fmax(high, sides.at[i]);
	}
	sides.least = fmin(-low, high);
	return sides;
}

/* In three, where a plane goes between the corners. */
static size_t
cut_along(const struct triangle_shape *shape, const struct sides *sides,
	struct triangle_shape out[3])
{
	struct tcs_point a, b, c, ab, ac;
	double from, to_b, to_c;
	int lone = 0;

	while (lone < 2 &&
		((sides->at[lone] > 0) == (sides->at[(lone + 1) % 3] > 0) ||
			(sides->at[lone] > 0) ==
				(sides->at[(lone + 2) % 3] > 0)))
		lone++;
	from = sides->at[lone];
	to_b = from - sides->at[(lone + 1) % 3];
	to_c = from - sides->at[(lone + 2) % 3];
	a = shape->corner[lone];
	b = shape->corner[(lone + 1) % 3];
	c = shape->corner[(lone + 2) % 3];
	ab = vector_along(a, vector_difference(b, a), from / to_b);
	ac = vector_along(a, vector_difference(c, a), from / to_c);
	out[0] = (struct triangle_shape){{ab, b, c}};
	out[1] = (struct triangle_shape){{ab, c, ac}};
	out[2] = (struct triangle_shape){{a, ab, ac}};
	return 3;
}

static double
edge_length(const struct triangle_shape *t, int edge)
{
	return vector_length(
		vector_difference(t->corner[(edge + 1) % 3], t->corner[edge]));
}

static size_t
cut_in_half(const struct triangle_shape *shape, struct triangle_shape out[3])
{
	int longest = 0;
	struct tcs_point a, b, c, middle;

	for (int i = 1; i < 3; i++)
		if (edge_length(shape, i) > edge_length(shape, longest))
			longest = i;
	a = shape->corner[longest];
	b = shape->corner[(longest + 1) % 3];
	c = shape->corner[(longest + 2) % 3];
	middle = vector_scaled(vector_sum(a, b), 0.5);
	out[0] = (struct triangle_shape){{a, middle, c}};
	out[1] = (struct triangle_shape){{middle, b, c}};
	return 2;
}

/* Along the edge of the other triangle that has most of it on both sides. */
static size_t
cut_part(const struct measure *measure, const struct triangle_shape *shape,
	uint32_t triangle, struct triangle_shape out[3])
{
	struct triangle_shape other =
		component_set_shape(&measure->to->set, triangle);
	struct sides best = {.least = 0};

	for (int i = 0; i < 3; i++) {
		struct sides sides = sides_of(shape, &other, i);

		if (sides.least > best.least)
			best = sides;
	}
	return best.least > ROUNDING ? cut_along(shape, &best, out)
				     : cut_in_half(shape, out);
}

/* The bound over a triangle from what is nearest to its corners. */
static double
bound_by_corners(const struct measure *measure, size_t triangle,
	const struct triangle_shape *shape)
{
	const uint32_t *corner =
		measure->from->set.triangles.at[triangle].corner;
	double bound = INFINITY;

	for (int i = 0; i < 3; i++)
		bound = fmin(bound,
			farthest_from(measure, shape,
				measure->hits[corner[i]].triangle));
	return bound;
}

/* Parts that are not bounded well enough yet: a heap, the worst first. */
struct parts {
	struct part *at;
	size_t count;
};

static void
parts_push(struct parts *parts, const struct part *part)
{
	size_t at = parts->count++;

	for (; at > 0 && parts->at[(at - 1) / 2].bound < part->bound;
		at = (at - 1) / 2)
		parts->at[at] = parts->at[(at - 1) / 2];
	parts->at[at] = *part;
}

static struct part
parts_pop(struct parts *parts)
{
	struct part worst = parts->at[0], last = parts->at[--parts->count];
	size_t at = 0, child;

	while ((child = 2 * at + 1) < parts->count) {
		if (child + 1 < parts->count &&
			parts->at[child + 1].bound > parts->at[child].bound)
			child++;
		if (parts->at[child].bound <= last.bound)
			break;
		parts->at[at] = parts->at[child];
		at = child;
	}
	parts->at[at] = last;
	return worst;
}

static struct part
bound_part(const struct measure *measure, const struct triangle_shape *shape,
	uint32_t last, struct found *found)
{
	struct near_hit hit = find_near(measure, centre_of(shape), last);

	found->max = fmax(found->max, hit.distance);
	return (struct part){*shape, hit.triangle,
		farthest_from(measure, shape, hit.triangle)};
}

/* Cut the worst part until it is good enough, or there were cuts enough. */
static void
lower_bound(
	const struct measure *measure, struct parts *parts, struct found *found)
{
	for (size_t cuts = 0; parts->count > 0; cuts++) {
		struct triangle_shape shapes[3];
		struct part part;
		size_t count;

		found->at_most = parts->at[0].bound;
		if (found->at_most <= found->max + measure->tolerance ||
			cuts == CUTS)
			break;
		part = parts_pop(parts);
		count = cut_part(measure, &part.shape, part.triangle, shapes);
		for (size_t i = 0; i < count; i++) {
			struct part smaller = bound_part(
				measure, &shapes[i], part.triangle, found);

			parts_push(parts, &smaller);
		}
	}
}

/* ---- the mean ------------------------------------------------------------ */

/* A sequence that fills the triangle evenly; the first is its centre. */
static struct tcs_point
sample_of(const struct triangle_shape *t, size_t i)
{
	double u = 1.0 / 3 + 0.7548776662466927 * (double)i;
	double v = 1.0 / 3 + 0.5698402909980532 * (double)i;

	u -= floor(u);
	v -= floor(v);
	if (u + v > 1) {
		u = 1 - u;
		v = 1 - v;
	}
	return vector_along(
		vector_along(t->corner[0],
			vector_difference(t->corner[1], t->corner[0]), u),
		vector_difference(t->corner[2], t->corner[0]), v);
}

static void
sample_triangle(const struct measure *measure, const struct triangle_shape *t,
	uint32_t last, struct found *found)
{
	double square = measure->spacing * measure->spacing;
	double area = triangle_area(t), count = ceil(area / square);
	double part = area / fmax(count, 1);

	for (size_t i = 0; i < (size_t)count; i++) {
		struct near_hit hit = find_near(measure, sample_of(t, i), last);

		last = hit.triangle;
		found->max = fmax(found->max, hit.distance);
		found->sum += part * hit.distance;
		found->squares += part * hit.distance * hit.distance;
	}
}

static void
measure_triangles(void *context, size_t piece, size_t first, size_t end)
{
	struct measure *measure = context;
	const struct component_set *set = &measure->from->set;
	struct found found = {.max = measure->corner_max};
	struct parts parts = {calloc(PARTS, sizeof *parts.at), 0};

	found.failed = !parts.at;
	for (size_t i = first; parts.at && i < end; i++) {
		struct triangle_shape shape = component_set_shape(set, i);
		uint32_t corner = set->triangles.at[i].corner[0];
		struct part part = bound_part(measure, &shape,
			measure->hits[corner].triangle, &found);

		part.bound =
			fmin(part.bound, bound_by_corners(measure, i, &shape));
		parts_push(&parts, &part);
		found.area += triangle_area(&shape);
		if (part.bound > ROUNDING)
			sample_triangle(measure, &shape, part.triangle, &found);
	}
	lower_bound(measure, &parts, &found);
	free(parts.at);
	measure->found[piece] = found;
}

/* ---- all ----------------------------------------------------------------- */

static double
choose_spacing(const struct compare_side *side)
{
	double area = 0;
	double count = 4 * (double)side->set.triangles.count + 1000;

	for (size_t i = 0; i < side->set.components.count; i++)
		area += side->set.components.at[i].area;
	return fmax(1e-6, sqrt(area / fmin(count, MOST_SAMPLES)));
}

static struct surface_distance
sum_up(const struct measure *measure, size_t pieces)
{
	struct found all = {0};

	for (size_t i = 0; i < pieces; i++) {
		const struct found *found = &measure->found[i];

		all.max = fmax(all.max, found->max);
		all.at_most = fmax(all.at_most, found->at_most);
		all.area += found->area;
		all.sum += found->sum;
		all.squares += found->squares;
	}
	if (!(all.area > 0))
		all.area = 1;
	return (struct surface_distance){all.max, fmax(all.max, all.at_most),
		all.sum / all.area, sqrt(all.squares / all.area),
		measure->spacing};
}

static enum tcs_status
measure_all(struct measure *measure, struct surface_distance *out,
	struct tcs_fault *fault)
{
	size_t points = measure->from->set.points.count;
	size_t triangles = measure->from->set.triangles.count;
	unsigned jobs = measure->from->set.jobs;
	enum tcs_status status =
		split_work(points, PIECE, jobs, measure_points, measure, fault);

	for (size_t i = 0; i < split_pieces(points, PIECE); i++)
		measure->corner_max =
			fmax(measure->corner_max, measure->found[i].max);
	if (!status)
		status = split_work(triangles, PIECE, jobs, measure_triangles,
			measure, fault);
	for (size_t i = 0; i < split_pieces(triangles, PIECE); i++)
		if (!status && measure->found[i].failed)
			status = fault_memory(fault);
	if (!status)
		*out = sum_up(measure, split_pieces(triangles, PIECE));
	return status;
}

enum tcs_status
surface_distance_measure(const struct compare_side *from,
	const struct compare_side *to, double tolerance,
	struct surface_distance *out, struct tcs_fault *fault)
{
	struct measure measure = {
		.from = from, .to = to, .tolerance = tolerance};
	/* A triangle has at most three points of its own. */
	size_t pieces = split_pieces(3 * from->set.triangles.count, PIECE);
	enum tcs_status status;

	*out = (struct surface_distance){
		INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
	if (!from->set.triangles.count || !to->set.triangles.count)
		return TCS_OK;
	measure.spacing = choose_spacing(from);
	measure.hits = calloc(from->set.points.count, sizeof *measure.hits);
	measure.found = calloc(pieces, sizeof *measure.found);
	if (!measure.hits || !measure.found)
		status = fault_memory(fault);
	else
		status = measure_all(&measure, out, fault);
	free(measure.hits);
	free(measure.found);
	return status;
}
