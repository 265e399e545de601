#include "compare_picture.h"

#include <math.h>
#include <stdlib.h>

#include "labels.h"
#include "vector.h"

enum {
	FINER = 2, /* a pixel is the mean of so many, squared */
	FINE = FINER * PICTURE_SIZE,
};

/* Parts from 0 to 1. */
struct colour {
	double red, green, blue;
};

static const struct colour sky = {0.95, 0.96, 0.98};
static const struct colour ink = {0.25, 0.25, 0.28};
static const struct colour only_after = {0.35, 0.5, 0.85};

struct painter {
	const struct compare_side *sides[2];
	const struct tcs_object *const *objects;
	struct view view;
	struct tcs_point sun;
	double far;
	struct raster rasters[2];
	struct colour *pixels; /* FINE × FINE */
	unsigned char *bytes;
};

static struct colour
mix(struct colour a, struct colour b, double part)
{
	return (struct colour){a.red + part * (b.red - a.red),
		a.green + part * (b.green - a.green),
		a.blue + part * (b.blue - a.blue)};
}

static struct tcs_point
facing_normal(const struct painter *painter, const struct component_set *set,
	size_t i)
{
	struct triangle_shape shape = component_set_shape(set, i);
	struct tcs_point normal = triangle_normal(&shape);
	double length = vector_length(normal);
	double side = vector_dot(normal, painter->view.forward) > 0 ? -1 : 1;

	return vector_scaled(normal, length > 0 ? side / length : 0);
}

static struct colour
shaded(struct colour colour, const struct painter *painter,
	struct tcs_point normal)
{
	double light = 0.7 + 0.3 * vector_dot(normal, painter->sun);

	return (struct colour){
		light * colour.red, light * colour.green, light * colour.blue};
}

static struct colour
class_colour(const struct tcs_object *object, uint32_t feature)
{
	uint32_t colour = label_of(object->features.at[feature].class)->colour;

	return (struct colour){(colour >> 16 & 0xff) / 255.0,
		(colour >> 8 & 0xff) / 255.0, (colour & 0xff) / 255.0};
}

/* Grey, yellow, red. */
static struct colour
error_colour(double part)
{
	static const struct colour none = {0.85, 0.85, 0.85};
	static const struct colour some = {1, 0.85, 0.2};
	static const struct colour much = {0.85, 0.1, 0.1};

	return part < 0.5 ? mix(none, some, 2 * part)
			  : mix(some, much, fmin(2 * part - 1, 1));
}

/* An outline: where another component or a bend begins. */
static bool
is_outline(const struct painter *painter, int side, unsigned x, unsigned y)
{
	const struct component_set *set = &painter->sides[side]->set;
	const uint32_t *at =
		painter->rasters[side].triangles + (size_t)y * FINE + x;
	const uint32_t others[2] = {
		x + 1 < FINE ? at[1] : at[0], y + 1 < FINE ? at[FINE] : at[0]};
	struct tcs_point normal = facing_normal(painter, set, at[0]);

	for (int i = 0; i < 2; i++) {
		struct tcs_point other;

		if (others[i] == at[0])
			continue;
		if (others[i] == RASTER_NOTHING ||
			set->numbers.at[others[i]] != set->numbers.at[at[0]])
			return true;
		other = facing_normal(painter, set, others[i]);
		if (vector_dot(normal, other) < 0.9)
			return true;
	}
	return false;
}

static struct colour
surface_colour(const struct painter *painter, int side, unsigned x, unsigned y)
{
	const struct component_set *set = &painter->sides[side]->set;
	uint32_t triangle =
		painter->rasters[side].triangles[(size_t)y * FINE + x];
	struct colour colour;

	if (triangle == RASTER_NOTHING)
		return sky;
	colour = shaded(class_colour(painter->objects[side],
				set->features.at[triangle]),
		painter, facing_normal(painter, set, triangle));
	return is_outline(painter, side, x, y) ? mix(colour, ink, 0.6) : colour;
}

/* How far what the pixel shows of `before` is from `after`. */
static struct colour
difference_colour(const struct painter *painter, unsigned x, unsigned y)
{
	const struct compare_side *after = painter->sides[1];
	size_t at = (size_t)y * FINE + x;
	uint32_t triangle = painter->rasters[0].triangles[at];
	struct tcs_point point;
	struct colour colour;
	double distance = INFINITY;

	if (triangle == RASTER_NOTHING)
		return painter->rasters[1].triangles[at] == RASTER_NOTHING
			? sky
			: only_after;
	point = vector_along(painter->view.eye,
		view_ray(&painter->view, FINE, x, y),
		1 / (double)painter->rasters[0].nearness[at]);
	if (after->whole != NO_TREE)
		distance = triangle_tree_nearest(
			&after->surfaces, after->whole, point, painter->far)
				   .distance;
	colour = shaded(error_colour(fmin(distance / painter->far, 1)), painter,
		facing_normal(painter, &painter->sides[0]->set, triangle));
	return is_outline(painter, 0, x, y) ? mix(colour, ink, 0.4) : colour;
}

static void
paint(struct painter *painter, int picture)
{
	for (unsigned y = 0; y < FINE; y++)
		for (unsigned x = 0; x < FINE; x++)
			painter->pixels[(size_t)y * FINE + x] =
				picture == PICTURE_ERROR
				? difference_colour(painter, x, y)
				: surface_colour(painter, picture, x, y);
}

static unsigned char
to_byte(double value)
{
	return (unsigned char)lround(255 * fmin(fmax(value, 0), 1));
}

static void
shrink(struct painter *painter)
{
	for (size_t i = 0; i < (size_t)PICTURE_SIZE * PICTURE_SIZE; i++) {
		size_t x = i % PICTURE_SIZE, y = i / PICTURE_SIZE;
		struct colour sum = {0, 0, 0};

		for (size_t k = 0; k < FINER * FINER; k++) {
			const struct colour *pixel =
				&painter->pixels[(y * FINER + k / FINER) *
						FINE +
					x * FINER + k % FINER];

			sum.red += pixel->red / (FINER * FINER);
			sum.green += pixel->green / (FINER * FINER);
			sum.blue += pixel->blue / (FINER * FINER);
		}
		painter->bytes[3 * i] = to_byte(sum.red);
		painter->bytes[3 * i + 1] = to_byte(sum.green);
		painter->bytes[3 * i + 2] = to_byte(sum.blue);
	}
}

static enum tcs_status
paint_all(struct painter *painter, struct object_pictures *out,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	for (int i = 0; !status && i < 2; i++) {
		const struct component_set *set = &painter->sides[i]->set;

		status = raster_draw(&painter->rasters[i], FINE, &painter->view,
			set->points.at, set->points.count, set->triangles.at,
			set->triangles.count, NULL, fault);
	}
	for (int i = 0; !status && i < PICTURE_COUNT; i++) {
		paint(painter, i);
		shrink(painter);
		status = png_encode(painter->bytes, PICTURE_SIZE, PICTURE_SIZE,
			&out->png[i], fault);
	}
	return status;
}

/* From south-south-east and a little above, so that it fills the picture. */
static struct view
portrait_view(const struct component_set *set)
{
	static const struct tcs_point way = {0.35, -0.84, 0.42};
	const struct box *box = &set->bounds;
	double diagonal = fmax(box_diagonal(box), 0.001), widest = 0;
	struct tcs_point middle = {(box->low[0] + box->high[0]) / 2,
		(box->low[1] + box->high[1]) / 2,
		(box->low[2] + box->high[2]) / 2};
	struct view view = view_of(
		vector_along(middle, way, 2 * diagonal), middle, diagonal / 2);

	for (size_t i = 0; i < set->points.count; i++) {
		struct tcs_point to =
			vector_difference(set->points.at[i], view.eye);
		double depth = vector_dot(to, view.forward);

		widest = fmax(widest,
			fmax(fabs(vector_dot(to, view.right)),
				fabs(vector_dot(to, view.up))) /
				depth);
	}
	if (widest > 0)
		view.scale = 0.94 / widest;
	return view;
}

enum tcs_status
object_pictures_draw(const struct compare_side *before,
	const struct compare_side *after, const struct tcs_object *objects[2],
	double far, struct object_pictures *out, struct tcs_fault *fault)
{
	struct painter painter = {
		.sides = {before, after},
		.objects = objects,
		.view = portrait_view(&before->set),
		.far = far,
		.pixels = calloc((size_t)FINE * FINE, sizeof *painter.pixels),
		.bytes = calloc((size_t)PICTURE_SIZE * PICTURE_SIZE, 3),
	};
	enum tcs_status status;

	painter.sun = vector_sum(vector_scaled(painter.view.right, -0.5),
		vector_scaled(painter.view.up, 0.8));
	painter.sun = vector_along(painter.sun, painter.view.forward, -0.33);
	if (!painter.pixels || !painter.bytes)
		status = fault_memory(fault);
	else
		status = paint_all(&painter, out, fault);
	for (int i = 0; i < 2; i++)
		raster_release(&painter.rasters[i]);
	free(painter.pixels);
	free(painter.bytes);
	return status;
}

void
object_pictures_release(struct object_pictures *pictures)
{
	for (int i = 0; i < PICTURE_COUNT; i++)
		array_release(&pictures->png[i]);
}
