#include "raster.h"

#include <math.h>
#include <stdlib.h>

#include "vector.h"

/* Pixels: no edge is farther from where it is said to be. */
#define ROUNDING 1e-3

static struct tcs_point
unit(struct tcs_point a)
{
	return vector_scaled(a, 1 / vector_length(a));
}

struct view
view_of(struct tcs_point eye, struct tcs_point target, double radius)
{
	struct tcs_point way = vector_difference(target, eye);
	double distance = vector_length(way);
	struct view view = {
		.eye = eye, .forward = unit(way), .nearest = 0.001 * distance};

	view.right =
		unit(vector_cross(view.forward, (struct tcs_point){0, 0, 1}));
	view.up = vector_cross(view.right, view.forward);
	view.scale = sqrt(distance * distance - radius * radius) / radius;
	return view;
}

struct view
view_parallel(struct tcs_point forward, struct tcs_point target, double radius)
{
	bool steep = fabs(forward.z) > 0.9;
	struct tcs_point aside = {steep ? 1 : 0, 0, steep ? 0 : 1};
	struct view view = {.eye = vector_along(target, forward, -2 * radius),
		.forward = forward,
		.right = unit(vector_cross(forward, aside)),
		.scale = 1 / radius,
		.nearest = 0.999 * radius,
		.farthest = 3.001 * radius,
		.parallel = true};

	view.up = vector_cross(view.right, view.forward);
	return view;
}

struct tcs_point
view_ray(const struct view *view, unsigned size, unsigned x, unsigned y)
{
	double right = ((x + 0.5) / size * 2 - 1) / view->scale;
	double up = (1 - (y + 0.5) / size * 2) / view->scale;

	return vector_along(
		vector_along(view->forward, view->right, right), view->up, up);
}

struct spot
view_spot(const struct view *view, unsigned size, struct tcs_point point)
{
	struct tcs_point way = vector_difference(point, view->eye);
	double depth = vector_dot(way, view->forward), scale;

	if (!(depth > view->nearest) ||
		(view->parallel && depth >= view->farthest))
		return (struct spot){0, 0, 0};
	scale = view->scale * size / 2 / (view->parallel ? 1 : depth);
	return (struct spot){size / 2.0 + scale * vector_dot(way, view->right),
		size / 2.0 - scale * vector_dot(way, view->up),
		view->parallel ? view->farthest - depth : 1 / depth};
}

/* Twice the area of a, b, c as the pixels see it. */
static double
turn(const struct spot *a, const struct spot *b, double x, double y)
{
	return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

/* The first and the last pixel whose middle lies between two edges. */
static void
pixel_range(double low, double high, unsigned size, int *first, int *last)
{
	*first = !(low > 0.5) ? 0
		: low < size  ? (int)ceil(low - 0.5)
			      : (int)size;
	*last = !(high < size - 0.5) ? (int)size - 1
		: high > 0	     ? (int)floor(high - 0.5)
				     : -1;
}

static double
lesser(double a, double b)
{
	return a < b ? a : b;
}

static double
greater(double a, double b)
{
	return a > b ? a : b;
}

/* What is linear over the picture: at + x · X + y · Y, in pixels. */
struct linear {
	double at, x, y;
};

/* 0 along one side of a triangle, 1 at the corner across. */
static struct linear
linear_from(const struct spot *a, const struct spot *b, double whole)
{
	double x = (a->y - b->y) / whole, y = (b->x - a->x) / whole;

	return (struct linear){-(x * a->x + y * a->y), x, y};
}

/* Where one side of a triangle is in a row, in pixels: linear in y. */
struct side {
	double at, slope;
};

static double
side_at(const struct side *side, double y)
{
	return side->at + side->slope * y;
}

/* A run of pixels of one row. */
struct run {
	float *nearness;
	uint32_t *triangles;
	float first, step; /* of the nearness */
	uint32_t number;
};

static void
draw_run(const struct run *run, int count)
{
	for (int i = 0; i < count; i++) {
		float now = run->first + (float)i * run->step;

		if (now <= run->nearness[i])
			continue;
		run->nearness[i] = now;
		run->triangles[i] = run->number;
	}
}

/* A triangle in pixels. It has two sides on its left, or two on its right; what
   is less than two is no bound. */
struct drawn {
	struct side left[2], right[2];
	struct linear nearness;
	uint32_t number;
};

static void
set_sides(struct drawn *drawn, const struct linear inside[3])
{
	int left = 0, right = 0;

	drawn->left[0] = drawn->left[1] = (struct side){-INFINITY, 0};
	drawn->right[0] = drawn->right[1] = (struct side){INFINITY, 0};
	for (int i = 0; i < 3; i++) {
		struct side side = {-inside[i].at / inside[i].x - 0.5,
			-inside[i].y / inside[i].x};

		/* A level one leaves the rows as they are. */
		if (inside[i].x > 0)
			drawn->left[left++] = side;
		else if (inside[i].x < 0)
			drawn->right[right++] = side;
	}
}

static void
draw_row(struct raster *raster, const struct drawn *drawn, int row)
{
	const struct linear *nearness = &drawn->nearness;
	double low = 0, high = raster->size - 1, y = row + 0.5;
	int first, last;
	size_t at;

	for (int i = 0; i < 2; i++) {
		low = greater(low, side_at(&drawn->left[i], y));
		high = lesser(high, side_at(&drawn->right[i], y));
	}
	if (!(low <= high))
		return;
	last = (int)high;
	first = (int)low;
	first += first < low;
	at = (size_t)row * raster->size + (size_t)first;
	if (first <= last)
		draw_run(&(struct run){raster->nearness + at,
				 raster->triangles + at,
				 (float)(nearness->at +
					 (first + 0.5) * nearness->x +
					 y * nearness->y),
				 (float)nearness->x, drawn->number},
			last - first + 1);
}

/* Whether no middle of a pixel lies between two edges, however they are
   rounded. */
static bool
is_between_pixels(double low, double high)
{
	return high - low < 1 &&
		ceil(low - 0.5 - ROUNDING) > floor(high - 0.5 + ROUNDING);
}

static void
draw_rows(struct raster *raster, const struct spot *a, const struct spot *b,
	const struct spot *c, double whole, int top, int bottom,
	uint32_t number)
{
	double near_u = a->nearness - c->nearness;
	double near_v = b->nearness - c->nearness;
	struct linear sides[3] = {linear_from(b, c, whole),
		linear_from(c, a, whole), linear_from(a, b, whole)};
	const struct linear *u = &sides[0], *v = &sides[1];
	struct drawn drawn = {
		.nearness = {c->nearness + u->at * near_u + v->at * near_v,
			u->x * near_u + v->x * near_v,
			u->y * near_u + v->y * near_v},
		.number = number};

	set_sides(&drawn, sides);
	for (int row = top; row <= bottom; row++)
		draw_row(raster, &drawn, row);
}

static void
draw_triangle(struct raster *raster, const struct spot *a, const struct spot *b,
	const struct spot *c, uint32_t number, int front)
{
	double whole = turn(a, b, c->x, c->y);
	int top, bottom;

	/* Rows go down: what is counterclockwise turns the other way. */
	if (!(fabs(whole) > 0) || front * whole > 0 ||
		is_between_pixels(lesser(a->x, lesser(b->x, c->x)),
			greater(a->x, greater(b->x, c->x))))
		return;
	pixel_range(lesser(a->y, lesser(b->y, c->y)),
		greater(a->y, greater(b->y, c->y)), raster->size, &top,
		&bottom);
	if (top <= bottom)
		draw_rows(raster, a, b, c, whole, top, bottom, number);
}

static enum tcs_status
raster_clear(struct raster *raster, unsigned size, struct tcs_fault *fault)
{
	size_t count = (size_t)size * size;

	if (raster->size != size) {
		raster_release(raster);
		raster->triangles = calloc(count, sizeof *raster->triangles);
		raster->nearness = calloc(count, sizeof *raster->nearness);
		if (!raster->triangles || !raster->nearness)
			return fault_memory(fault);
		raster->size = size;
	}
	for (size_t i = 0; i < count; i++) {
		raster->triangles[i] = RASTER_NOTHING;
		raster->nearness[i] = 0;
	}
	return TCS_OK;
}

enum tcs_status
raster_draw(struct raster *raster, unsigned size, const struct view *view,
	const struct tcs_point *points, size_t point_count,
	const struct tcs_triangle *triangles, size_t triangle_count,
	const signed char *fronts, struct tcs_fault *fault)
{
	struct spot *spots = calloc(point_count + 1, sizeof *spots);
	enum tcs_status status =
		spots ? raster_clear(raster, size, fault) : fault_memory(fault);

	for (size_t i = 0; !status && i < point_count; i++)
		spots[i] = view_spot(view, size, points[i]);
	for (size_t i = 0; !status && i < triangle_count; i++) {
		const struct spot *a = &spots[triangles[i].corner[0]];
		const struct spot *b = &spots[triangles[i].corner[1]];
		const struct spot *c = &spots[triangles[i].corner[2]];

		if (a->nearness > 0 && b->nearness > 0 && c->nearness > 0)
			draw_triangle(raster, a, b, c, (uint32_t)i,
				fronts ? fronts[i] : 0);
	}
	free(spots);
	return status;
}

void
raster_release(struct raster *raster)
{
	free(raster->triangles);
	free(raster->nearness);
	*raster = (struct raster){0};
}
