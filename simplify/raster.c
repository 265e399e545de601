#include "raster.h"

#include <math.h>
#include <stdlib.h>

#include "vector.h"

enum { SHORT_ROW = 8 }; /* pixels; of shorter ones, each is looked at */

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

/* Of one side of a triangle: its ends in y, and where it is at a height y. */
struct side {
	double low, high;
	double x, y, slope;
};

static struct side
side_of(const struct spot *a, const struct spot *b)
{
	return (struct side){.low = lesser(a->y, b->y),
		.high = greater(a->y, b->y),
		.x = a->x,
		.y = a->y,
		.slope = (b->x - a->x) / (b->y - a->y)};
}

/* The pixels of a row, at y, that a triangle may cover: one more at each end,
   for rounding. */
static void
row_range(const struct side sides[3], double y, double left, double right,
	unsigned size, int *first, int *last)
{
	double low = right, high = left;

	for (int i = 0; i < 3; i++) {
		double x = sides[i].x + sides[i].slope * (y - sides[i].y);

		if (y < sides[i].low || y > sides[i].high)
			continue;
		low = x > left ? lesser(low, x) : left; /* level: NaN */
		high = x < right ? greater(high, x) : right;
	}
	pixel_range(greater(low - 1, left), lesser(high + 1, right), size,
		first, last);
}

/* A triangle in pixels; u, v, w are barycentric at the middle of a pixel. */
struct drawn {
	const struct spot *a, *b, *c;
	double inverse; /* 1 / twice its area */
	double u_step, v_step; /* from a pixel to the next on its right */
	uint32_t number;
};

static void
draw_row(struct raster *raster, const struct drawn *drawn, int y, int first,
	int last)
{
	size_t row = (size_t)y * raster->size;
	double x = first + 0.5, middle = y + 0.5;
	double u0 = turn(drawn->b, drawn->c, x, middle) * drawn->inverse;
	double v0 = turn(drawn->c, drawn->a, x, middle) * drawn->inverse;

	for (int i = first; i <= last; i++) {
		double u = u0 + (i - first) * drawn->u_step;
		double v = v0 + (i - first) * drawn->v_step;
		double w = 1 - u - v;
		size_t at = row + (size_t)i;
		float nearness;

		if (u < 0 || v < 0 || w < 0)
			continue;
		nearness = (float)(u * drawn->a->nearness +
			v * drawn->b->nearness + w * drawn->c->nearness);
		if (nearness <= raster->nearness[at])
			continue;
		raster->nearness[at] = nearness;
		raster->triangles[at] = drawn->number;
	}
}

static void
draw_triangle(struct raster *raster, const struct spot *a, const struct spot *b,
	const struct spot *c, uint32_t number)
{
	double whole = turn(a, b, c->x, c->y);
	double left = lesser(a->x, lesser(b->x, c->x));
	double right = greater(a->x, greater(b->x, c->x));
	struct drawn drawn = {.a = a,
		.b = b,
		.c = c,
		.inverse = 1 / whole,
		.u_step = (b->y - c->y) / whole,
		.v_step = (c->y - a->y) / whole,
		.number = number};
	struct side sides[3];
	int first, last, top, bottom;
	bool wide;

	if (!(fabs(whole) > 0))
		return;
	pixel_range(left, right, raster->size, &first, &last);
	pixel_range(lesser(a->y, lesser(b->y, c->y)),
		greater(a->y, greater(b->y, c->y)), raster->size, &top,
		&bottom);
	if (first > last || top > bottom)
		return;
	wide = last - first >= SHORT_ROW;
	sides[0] = side_of(a, b);
	sides[1] = side_of(b, c);
	sides[2] = side_of(c, a);
	for (int y = top; y <= bottom; y++) {
		if (wide)
			row_range(sides, y + 0.5, left, right, raster->size,
				&first, &last);
		draw_row(raster, &drawn, y, first, last);
	}
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
	struct tcs_fault *fault)
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
			draw_triangle(raster, a, b, c, (uint32_t)i);
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
