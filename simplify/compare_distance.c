#include "compare_distance.h"

#include <assert.h>
#include <math.h>

#include "vector.h"

#define ROUNDING 1e-9 /* metres */

enum { MAX_CUTS = 8, MAX_PARTS = 64 };

/* A piece of a triangle, and how often it was cut. */
struct piece {
	struct triangle_shape shape;
	uint32_t cuts;
};

struct measure {
	const struct compare_side *to;
	double tolerance;
	double max, at_most; /* so far */
};

static struct tcs_point
centre_of(const struct triangle_shape *t)
{
	return vector_scaled(vector_sum(t->corner[0],
				     vector_sum(t->corner[1], t->corner[2])),
		1.0 / 3);
}

/* ---- the largest --------------------------------------------------------- */

/* No point of the piece is farther from the triangle than this. */
static double
farthest_from(const struct measure *measure, const struct piece *piece,
	uint32_t triangle)
{
	struct triangle_shape shape =
		component_set_shape(&measure->to->set, triangle);
	double farthest = 0;

	for (int i = 0; i < 3; i++) {
		struct tcs_point corner = piece->shape.corner[i];
		struct tcs_point at = triangle_nearest(&shape, corner);

		farthest = fmax(
			farthest, vector_length(vector_difference(at, corner)));
	}
	return farthest;
}

/* Raise the maximum to what is found and return the bound over the piece. */
static double
bound_piece(struct measure *measure, const struct piece *piece)
{
	const struct compare_side *to = measure->to;
	double bound = INFINITY;

	for (int i = 3; i >= 0; i--) {
		struct tcs_point from = i < 3 ? piece->shape.corner[i]
					      : centre_of(&piece->shape);
		struct tree_hit hit = triangle_tree_nearest(
			&to->surfaces, to->whole, from, INFINITY);

		measure->max = fmax(measure->max, hit.distance);
		bound = fmin(bound, farthest_from(measure, piece, hit.item));
		if (bound <= measure->max + ROUNDING)
			break;
	}
	return bound;
}

static struct tcs_point
middle_of(struct tcs_point a, struct tcs_point b)
{
	return vector_scaled(vector_sum(a, b), 0.5);
}

static void
cut_piece(const struct piece *piece, struct piece out[4])
{
	const struct tcs_point *c = piece->shape.corner;
	struct tcs_point m[3];

	for (int i = 0; i < 3; i++)
		m[i] = middle_of(c[i], c[(i + 1) % 3]);
	for (int i = 0; i < 3; i++)
		out[i] = (struct piece){
			{{c[i], m[i], m[(i + 2) % 3]}}, piece->cuts + 1};
	out[3] = (struct piece){{{m[0], m[1], m[2]}}, piece->cuts + 1};
}

static void
bound_triangle(struct measure *measure, const struct triangle_shape *shape)
{
	struct piece stack[3 * MAX_CUTS + 4];
	size_t height = 1;

	stack[0] = (struct piece){*shape, 0};
	while (height > 0) {
		struct piece piece = stack[--height];
		double bound = bound_piece(measure, &piece);

		if (bound <= measure->max + measure->tolerance ||
			piece.cuts == MAX_CUTS) {
			measure->at_most = fmax(measure->at_most, bound);
			continue;
		}
		assert(height + 4 <= sizeof stack / sizeof *stack);
		cut_piece(&piece, stack + height);
		height += 4;
	}
}

/* ---- the mean ------------------------------------------------------------ */

struct mean {
	double area, sum, squares;
};

static double
longest_edge(const struct triangle_shape *t)
{
	double longest = 0;

	for (int i = 0; i < 3; i++)
		longest = fmax(longest,
			vector_length(vector_difference(
				t->corner[(i + 1) % 3], t->corner[i])));
	return longest;
}

static void
sample_at(const struct compare_side *to, const struct triangle_shape *t,
	double u, double v, double area, struct mean *mean)
{
	struct tcs_point at = vector_along(
		vector_along(t->corner[0],
			vector_difference(t->corner[1], t->corner[0]), u),
		vector_difference(t->corner[2], t->corner[0]), v);
	double distance =
		triangle_tree_nearest(&to->surfaces, to->whole, at, INFINITY)
			.distance;

	mean->area += area;
	mean->sum += area * distance;
	mean->squares += area * distance * distance;
}

/* n² congruent pieces: those like the triangle, and those turned round. */
static void
sample_triangle(const struct compare_side *to, const struct triangle_shape *t,
	double spacing, struct mean *mean)
{
	double parts = ceil(longest_edge(t) / spacing), area;
	int n = parts < MAX_PARTS ? (int)fmax(parts, 1) : MAX_PARTS;

	area = triangle_area(t) / ((double)n * n);
	for (int i = 0; i < n; i++) {
		for (int k = 0; i + k < n; k++) {
			sample_at(to, t, (i + 1.0 / 3) / n, (k + 1.0 / 3) / n,
				area, mean);
			if (i + k + 1 < n)
				sample_at(to, t, (i + 2.0 / 3) / n,
					(k + 2.0 / 3) / n, area, mean);
		}
	}
}

/* About four pieces for every triangle, and a thousand. */
static double
choose_spacing(const struct compare_side *side)
{
	double area = 0;

	for (size_t i = 0; i < side->set.components.count; i++)
		area += side->set.components.at[i].area;
	return fmax(1e-6,
		sqrt(area / (4 * (double)side->set.triangles.count + 1000)));
}

struct surface_distance
surface_distance_measure(const struct compare_side *from,
	const struct compare_side *to, double tolerance)
{
	struct measure measure = {.to = to, .tolerance = tolerance};
	struct mean mean = {0};
	double spacing;

	if (!from->set.triangles.count || !to->set.triangles.count)
		return (struct surface_distance){
			INFINITY, INFINITY, INFINITY, INFINITY, INFINITY};
	spacing = choose_spacing(from);
	for (size_t i = 0; i < from->set.triangles.count; i++) {
		struct triangle_shape shape =
			component_set_shape(&from->set, i);

		bound_triangle(&measure, &shape);
		sample_triangle(to, &shape, spacing, &mean);
	}
	if (!(mean.area > 0))
		mean.area = 1;
	return (struct surface_distance){measure.max,
		fmax(measure.max, measure.at_most), mean.sum / mean.area,
		sqrt(mean.squares / mean.area), spacing};
}
