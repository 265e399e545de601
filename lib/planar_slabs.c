#include "planar_slabs.h"

#include <stdlib.h>

/* An edge that passes through a slab, by its place in the slab's middle. */
struct passage {
	double x;
	uint32_t edge;
};

/* A side of a triangle; none is level. */
struct side {
	struct planar_point low, high;
};

struct slabs {
	TCS_ARRAY(double) heights;
	TCS_ARRAY(struct passage) passages;
	TCS_ARRAY(struct side) sides; /* by the height where they begin */
	TCS_ARRAY(uint32_t) open; /* the sides that have begun, not ended */
	size_t begun; /* how many of the sides have */
};

static void
slabs_release(struct slabs *slabs)
{
	array_release(&slabs->heights);
	array_release(&slabs->passages);
	array_release(&slabs->sides);
	array_release(&slabs->open);
}

static int
height_compare(const void *a, const void *b)
{
	const double *left = a, *right = b;

	return (*left > *right) - (*left < *right);
}

static int
passage_compare(const void *a, const void *b)
{
	const struct passage *left = a, *right = b;

	if (left->x != right->x)
		return left->x < right->x ? -1 : 1;
	return (left->edge > right->edge) - (left->edge < right->edge);
}

static struct planar_point
edge_from(const struct planar *polygon, uint32_t edge)
{
	return polygon->points.at[edge];
}

static struct planar_point
edge_to(const struct planar *polygon, uint32_t edge)
{
	return polygon->points.at[polygon->next.at[edge]];
}

/* A height between an edge's ends at which it may cross another. */
static bool
edges_meet(const struct planar *polygon, uint32_t a, uint32_t b, double *y)
{
	struct planar_point a0 = edge_from(polygon, a),
			    a1 = edge_to(polygon, a);
	struct planar_point b0 = edge_from(polygon, b),
			    b1 = edge_to(polygon, b);
	double by = b1.y - b0.y, bx = b1.x - b0.x;
	double area = (a1.x - a0.x) * by - (a1.y - a0.y) * bx;
	double t = ((b0.x - a0.x) * by - (b0.y - a0.y) * bx) / area;

	*y = a0.y + t * (a1.y - a0.y);
	return t > 0 && t < 1;
}

static enum tcs_status
heights_find(struct slabs *slabs, const struct planar *polygon,
	struct tcs_fault *fault)
{
	size_t count = polygon->kept.count;
	const uint32_t *edges = polygon->kept.at;
	double y;

	for (size_t i = 0; i < count; i++) {
		if (array_grow(&slabs->heights, count))
			return fault_memory(fault);
		slabs->heights.at[slabs->heights.count++] =
			edge_from(polygon, edges[i]).y;
		for (size_t j = 0; j < i; j++) {
			if (edges_meet(polygon, edges[i], edges[j], &y))
				slabs->heights.at[slabs->heights.count++] = y;
		}
	}
	qsort(slabs->heights.at, slabs->heights.count,
		sizeof *slabs->heights.at, height_compare);
	if (array_grow(&slabs->passages, count))
		return fault_memory(fault);
	return TCS_OK;
}

static double
edge_at(const struct planar *polygon, uint32_t edge, double y)
{
	struct planar_point from = edge_from(polygon, edge);
	struct planar_point to = edge_to(polygon, edge);

	return from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y));
}

/* The edges at a height where none ends, from left to right. */
static void
passages_find(struct slabs *slabs, const struct planar *polygon, double y)
{
	slabs->passages.count = 0;
	for (size_t i = 0; i < polygon->kept.count; i++) {
		uint32_t edge = polygon->kept.at[i];

		if ((edge_from(polygon, edge).y > y) ==
			(edge_to(polygon, edge).y > y))
			continue;
		slabs->passages.at[slabs->passages.count++] =
			(struct passage){edge_at(polygon, edge, y), edge};
	}
	qsort(slabs->passages.at, slabs->passages.count,
		sizeof *slabs->passages.at, passage_compare);
}

/* The next slab from `i` on, or false behind the last. */
static bool
slab_next(const struct slabs *slabs, size_t *i, double *low, double *high)
{
	for (; *i + 1 < slabs->heights.count; ++*i) {
		*low = slabs->heights.at[*i];
		*high = slabs->heights.at[*i + 1];
		if (*high > *low)
			return true;
	}
	return false;
}

/* What lies between every other passage and the next. */
static double
width_between(const struct slabs *slabs)
{
	const struct passage *at = slabs->passages.at;
	double width = 0;

	for (size_t i = 1; i < slabs->passages.count; i += 2)
		width += at[i].x - at[i - 1].x;
	return width;
}

/* ---- checking ----------------------------------------------------------------- */

static int
side_compare(const void *a, const void *b)
{
	const struct side *left = a, *right = b;

	return (left->low.y > right->low.y) - (left->low.y < right->low.y);
}

static enum tcs_status
sides_find(struct slabs *slabs, const struct planar *polygon,
	const struct triangle_list *triangles, struct tcs_fault *fault)
{
	const struct planar_point *points = polygon->points.at;

	if (array_grow(&slabs->sides, 3 * triangles->count) ||
		array_grow(&slabs->open, 3 * triangles->count) ||
		array_grow(&slabs->passages,
			polygon->kept.count + 3 * triangles->count))
		return fault_memory(fault);
	for (size_t i = 0; i < 3 * triangles->count; i++) {
		const uint32_t *corner = triangles->at[i / 3].corner;
		struct planar_point a = points[corner[i % 3]];
		struct planar_point b = points[corner[(i + 1) % 3]];

		if (a.y != b.y)
			slabs->sides.at[slabs->sides.count++] = a.y < b.y
				? (struct side){a, b}
				: (struct side){b, a};
	}
	if (slabs->sides.count)
		qsort(slabs->sides.at, slabs->sides.count,
			sizeof *slabs->sides.at, side_compare);
	return TCS_OK;
}

/* Add the passages of the triangles; heights only grow from call to call. */
static void
passages_add_sides(struct slabs *slabs, double y)
{
	const struct side *sides = slabs->sides.at;
	size_t open = 0;

	while (slabs->begun < slabs->sides.count &&
		sides[slabs->begun].low.y <= y)
		slabs->open.at[slabs->open.count++] = (uint32_t)slabs->begun++;
	for (size_t i = 0; i < slabs->open.count; i++) {
		const struct side *side = &sides[slabs->open.at[i]];
		struct planar_point low = side->low, high = side->high;

		if (high.y <= y)
			continue;
		slabs->open.at[open++] = slabs->open.at[i];
		slabs->passages.at[slabs->passages.count++] = (struct passage){
			low.x +
				(high.x - low.x) *
					((y - low.y) / (high.y - low.y)),
			0};
	}
	slabs->open.count = open;
	qsort(slabs->passages.at, slabs->passages.count,
		sizeof *slabs->passages.at, passage_compare);
}

enum tcs_status
slabs_check(const struct planar *polygon, const struct triangle_list *triangles,
	double *area, double *wrong, struct tcs_fault *fault)
{
	struct slabs slabs = {.heights = {0}};
	enum tcs_status status = heights_find(&slabs, polygon, fault);
	double low, high;

	*area = 0;
	*wrong = 0;
	if (!status)
		status = sides_find(&slabs, polygon, triangles, fault);
	for (size_t i = 0; !status && slab_next(&slabs, &i, &low, &high); i++) {
		double middle = low + (high - low) / 2;

		passages_find(&slabs, polygon, middle);
		*area += (high - low) * width_between(&slabs);
		passages_add_sides(&slabs, middle);
		*wrong += (high - low) * width_between(&slabs);
	}
	slabs_release(&slabs);
	return status;
}

/* ---- filling ------------------------------------------------------------------ */

struct filling {
	struct planar *polygon;
	const struct tcs_point *vertices;
	struct triangle_list *out;
	struct point_list *extra;
};

static double
vertex_height(const struct filling *filling, uint32_t vertex)
{
	const struct planar *polygon = filling->polygon;

	return planar_height(&polygon->plane, polygon->points.at[vertex],
		filling->vertices[vertex]);
}

/* The edge's own vertex at that height, or an extra one. */
static uint32_t
corner_at(struct filling *filling, uint32_t edge, double y)
{
	struct planar *polygon = filling->polygon;
	struct planar_point from = edge_from(polygon, edge);
	struct planar_point to = edge_to(polygon, edge), at;
	double t = (y - from.y) / (to.y - from.y), off;

	if (from.y == y)
		return edge;
	if (to.y == y)
		return polygon->next.at[edge];
	off = (1 - t) * vertex_height(filling, edge) +
		t * vertex_height(filling, polygon->next.at[edge]);
	at = (struct planar_point){edge_at(polygon, edge, y), y};
	filling->extra->at[filling->extra->count++] =
		planar_lift(&polygon->plane, at, off);
	polygon->points.at[polygon->points.count] = at;
	return (uint32_t)polygon->points.count++;
}

static void
triangle_add(struct filling *filling, uint32_t a, uint32_t b, uint32_t c)
{
	const struct planar_point *points = filling->polygon->points.at;

	if (planar_orient(points[a], points[b], points[c]) > 0)
		filling->out->at[filling->out->count++] =
			(struct tcs_triangle){{a, b, c}};
}

static enum tcs_status
trapezoid_add(struct filling *filling, uint32_t left, uint32_t right,
	double low, double high, struct tcs_fault *fault)
{
	uint32_t a, b, c, d;

	if (filling->polygon->points.count > UINT32_MAX - 8 ||
		array_grow(&filling->polygon->points, 4) ||
		array_grow(filling->extra, 4) || array_grow(filling->out, 2))
		return fault_memory(fault);
	a = corner_at(filling, left, low);
	b = corner_at(filling, right, low);
	c = corner_at(filling, right, high);
	d = corner_at(filling, left, high);
	triangle_add(filling, a, b, c);
	triangle_add(filling, a, c, d);
	return TCS_OK;
}

enum tcs_status
slabs_fill(struct planar *polygon, const struct tcs_point *vertices,
	struct triangle_list *out, struct point_list *extra,
	struct tcs_fault *fault)
{
	struct filling filling = {polygon, vertices, out, extra};
	struct slabs slabs = {.heights = {0}};
	enum tcs_status status = heights_find(&slabs, polygon, fault);
	const struct passage *at = slabs.passages.at;
	double low, high;

	for (size_t i = 0; !status && slab_next(&slabs, &i, &low, &high); i++) {
		passages_find(&slabs, polygon, low + (high - low) / 2);
		for (size_t j = 1; !status && j < slabs.passages.count; j += 2)
			status = trapezoid_add(&filling, at[j - 1].edge,
				at[j].edge, low, high, fault);
	}
	slabs_release(&slabs);
	return status;
}
