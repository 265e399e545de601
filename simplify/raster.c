#include "raster.h"

#include <math.h>
#include <stdlib.h>

#include "vector.h"

/* A point in pixels, and 1 / its depth; 0 for what is not before the eye. */
struct spot {
	double x, y, nearness;
};

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

struct tcs_point
view_ray(const struct view *view, unsigned size, unsigned x, unsigned y)
{
	double right = ((x + 0.5) / size * 2 - 1) / view->scale;
	double up = (1 - (y + 0.5) / size * 2) / view->scale;

	return vector_along(
		vector_along(view->forward, view->right, right), view->up, up);
}

static struct spot
spot_of(const struct view *view, unsigned size, struct tcs_point point)
{
	struct tcs_point way = vector_difference(point, view->eye);
	double depth = vector_dot(way, view->forward), scale;

	if (!(depth > view->nearest))
		return (struct spot){0, 0, 0};
	scale = view->scale / depth * size / 2;
	return (struct spot){size / 2.0 + scale * vector_dot(way, view->right),
		size / 2.0 - scale * vector_dot(way, view->up), 1 / depth};
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
	*first = low > 0.5 ? (int)fmin(ceil(low - 0.5), size) : 0;
	*last = high < size - 0.5 ? (int)fmax(floor(high - 0.5), -1)
				  : (int)size - 1;
}

static void
draw_triangle(struct raster *raster, const struct spot *a, const struct spot *b,
	const struct spot *c, uint32_t number)
{
	double whole = turn(a, b, c->x, c->y);
	int left, right, top, bottom;

	if (!(fabs(whole) > 0))
		return;
	pixel_range(fmin(a->x, fmin(b->x, c->x)), fmax(a->x, fmax(b->x, c->x)),
		raster->size, &left, &right);
	pixel_range(fmin(a->y, fmin(b->y, c->y)), fmax(a->y, fmax(b->y, c->y)),
		raster->size, &top, &bottom);
	for (int y = top; y <= bottom; y++) {
		for (int x = left; x <= right; x++) {
			double u = turn(b, c, x + 0.5, y + 0.5) / whole;
			double v = turn(c, a, x + 0.5, y + 0.5) / whole;
			double w = 1 - u - v;
			size_t at = (size_t)y * raster->size + (size_t)x;
			float nearness;

			if (u < 0 || v < 0 || w < 0)
				continue;
			nearness = (float)(u * a->nearness + v * b->nearness +
				w * c->nearness);
			if (nearness <= raster->nearness[at])
				continue;
			raster->nearness[at] = nearness;
			raster->triangles[at] = number;
		}
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
	const struct component_set *set, struct tcs_fault *fault)
{
	size_t count = set->points.count;
	struct spot *spots = calloc(count + 1, sizeof *spots);
	enum tcs_status status =
		spots ? raster_clear(raster, size, fault) : fault_memory(fault);

	for (size_t i = 0; !status && i < count; i++)
		spots[i] = spot_of(view, size, set->points.at[i]);
	for (size_t i = 0; !status && i < set->triangles.count; i++) {
		const uint32_t *corner = set->triangles.at[i].corner;
		const struct spot *a = &spots[corner[0]];
		const struct spot *b = &spots[corner[1]];
		const struct spot *c = &spots[corner[2]];

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
