#include "prism.h"

#include <stdlib.h>

#include "vector.h"

/* Sides up to PRISM_SIDES are kept where without one of them the outline would
   be larger by this share; beyond four, where it would not, they go. */
#define WORTH_A_SIDE 0.05

/* A rectangle is preferred to what is smaller by no more than this share. */
#define RECTANGLE_SHARE 0.02

/* Metres: what is thinner is flat. */
#define LEAST_SIZE 1e-4

/* Metres. */
#define HAIR 1e-7

/* Reducing takes n squared steps. */
enum { MOST_SIDES = 256 };

/* ---- in the plane across the axis ---------------------------------------- */

struct frame {
	struct tcs_point x, y, axis;
};

static struct frame
frame_of(struct tcs_point axis)
{
	struct tcs_point level = {-axis.y, axis.x, 0};
	struct frame frame = {.axis = axis};
	double length = vector_length(level);

	/* Upright ones have a frame along the coordinates. */
	frame.x = length > 1e-9 ? vector_scaled(level, 1 / length)
				: (struct tcs_point){1, 0, 0};
	frame.y = vector_cross(axis, frame.x);
	return frame;
}

static double
cross(struct planar_point a, struct planar_point b)
{
	return a.x * b.y - a.y * b.x;
}

static struct planar_point
between(struct planar_point from, struct planar_point to)
{
	return (struct planar_point){to.x - from.x, to.y - from.y};
}

static int
by_place(const void *left, const void *right)
{
	const struct planar_point *a = left, *b = right;

	if (a->x < b->x || b->x < a->x)
		return a->x < b->x ? -1 : 1;
	return (b->y < a->y) - (a->y < b->y);
}

static void
hull_add(struct planar_points *hull, size_t least, struct planar_point point)
{
	while (hull->count >= least + 2) {
		struct planar_point a = hull->at[hull->count - 2];

		if (cross(between(a, hull->at[hull->count - 1]),
			    between(a, point)) > 0)
			break;
		hull->count--;
	}
	hull->at[hull->count++] = point;
}

/* How far a point is from the line between two others. */
static double
distance_from(
	struct planar_point point, struct planar_point a, struct planar_point b)
{
	struct planar_point along = between(a, b);
	double length = hypot(along.x, along.y);

	return length > 0 ? cross(between(a, point), along) / length : 0;
}

/* Points that are a hair from the line between their neighbours go: rounding
   has put them there. */
static void
straighten(struct planar_points *hull)
{
	size_t kept = 0;

	for (size_t i = 0; i < hull->count; i++) {
		struct planar_point last =
			hull->at[kept > 0 ? kept - 1 : hull->count - 1];
		struct planar_point next = hull->at[(i + 1) % hull->count];

		if (distance_from(hull->at[i], last, next) > HAIR)
			hull->at[kept++] = hull->at[i];
	}
	hull->count = kept;
}

/*
 * The convex hull, counterclockwise.
 *
 * source: A. Andrew, Another efficient algorithm for convex hulls in two
 * dimensions, 1979.
 */
static enum tcs_status
find_hull(struct prism_outline *outline, struct tcs_fault *fault)
{
	struct planar_points *points = &outline->points;
	struct planar_points *hull = &outline->hull;
	size_t lower;

	array_clear(hull);
	if (array_grow(hull, 2 * points->count + 1))
		return fault_memory(fault);
	qsort(points->at, points->count, sizeof *points->at, by_place);
	for (size_t i = 0; i < points->count; i++)
		hull_add(hull, 0, points->at[i]);
	lower = hull->count - 1;
	for (size_t i = points->count - 1; i-- > 0;)
		hull_add(hull, lower, points->at[i]);
	hull->count--;
	straighten(hull);
	return TCS_OK;
}

static double
area_of(const struct planar_point *points, size_t count)
{
	double area = 0;

	for (size_t i = 2; i < count; i++)
		area += cross(between(points[0], points[i - 1]),
			between(points[0], points[i]));
	return area / 2;
}

/* ---- fewer sides --------------------------------------------------------- */

/* Where the sides before and behind side i meet, and what that adds. */
static double
area_without(const struct planar_points *hull, size_t i,
	struct planar_point *meeting)
{
	size_t count = hull->count;
	struct planar_point a = hull->at[(i + count - 1) % count];
	struct planar_point b = hull->at[i], c = hull->at[(i + 1) % count];
	struct planar_point d = hull->at[(i + 2) % count];
	struct planar_point before = between(a, b), behind = between(c, d);
	double turn = cross(before, behind), along;

	if (!(turn > 1e-6 * hypot(before.x, before.y) *
			    hypot(behind.x, behind.y)))
		return INFINITY;
	along = cross(between(b, c), behind) / turn;
	*meeting = (struct planar_point){
		b.x + along * before.x, b.y + along * before.y};
	return cross(between(b, *meeting), between(b, c)) / 2;
}

static void
drop_side(struct planar_points *hull, size_t side, struct planar_point meeting)
{
	size_t next = (side + 1) % hull->count;

	hull->at[side] = meeting;
	for (size_t i = next; i + 1 < hull->count; i++)
		hull->at[i] = hull->at[i + 1];
	hull->count--;
}

/* Whether some side can go for less than `most`: the cheapest is gone. */
static bool
drop_cheapest(struct planar_points *hull, double most)
{
	struct planar_point meeting = {0}, best_meeting = {0};
	double least = INFINITY;
	size_t best = 0;

	for (size_t i = 0; i < hull->count; i++) {
		double area = area_without(hull, i, &meeting);

		if (area < least) {
			least = area;
			best = i;
			best_meeting = meeting;
		}
	}
	if (!(least <= most) || !(least < INFINITY))
		return false;
	drop_side(hull, best, best_meeting);
	return true;
}

/* ---- the rectangle ------------------------------------------------------- */

/* The rectangle along a direction of length 1; its area. */
static double
rectangle_along(const struct planar_points *hull, struct planar_point along,
	struct planar_point out[4])
{
	double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

	for (size_t i = 0; i < hull->count; i++) {
		struct planar_point at = hull->at[i];
		const double place[2] = {
			at.x * along.x + at.y * along.y, cross(along, at)};

		for (int k = 0; k < 2; k++) {
			low[k] = fmin(low[k], place[k]);
			high[k] = fmax(high[k], place[k]);
		}
	}
	for (int i = 0; i < 4; i++) {
		double x = i == 1 || i == 2 ? high[0] : low[0];
		double y = i >= 2 ? high[1] : low[1];

		out[i] = (struct planar_point){
			x * along.x - y * along.y, x * along.y + y * along.x};
	}
	return (high[0] - low[0]) * (high[1] - low[1]);
}

/* The least rectangle around a convex outline lies along one of its sides. */
static double
least_rectangle(const struct planar_points *hull, struct planar_point best[4])
{
	double least = INFINITY;

	for (size_t i = 0; i < hull->count; i++) {
		struct planar_point side =
			between(hull->at[i], hull->at[(i + 1) % hull->count]);
		double length = hypot(side.x, side.y), area;
		struct planar_point own[4];

		if (!(length > 0))
			continue;
		area = rectangle_along(hull,
			(struct planar_point){side.x / length, side.y / length},
			own);
		/* The first of those that are as good. */
		if (area < least * (1 - 1e-9)) {
			least = area;
			for (int k = 0; k < 4; k++)
				best[k] = own[k];
		}
	}
	return least;
}

/* The hull becomes an outline of few sides. */
static void
reduce_hull(struct planar_points *hull, unsigned sides)
{
	struct planar_point rectangle[4] = {{0}};
	double area = area_of(hull->at, hull->count);
	double least = least_rectangle(hull, rectangle);

	while (hull->count > 4 &&
		drop_cheapest(hull,
			hull->count > sides ? INFINITY : WORTH_A_SIDE * area))
		continue;
	if (hull->count == 3 ||
		(hull->count <= sides &&
			area_of(hull->at, hull->count) <
				(1 - RECTANGLE_SHARE) * least))
		return;
	hull->count = 4;
	for (int i = 0; i < 4; i++)
		hull->at[i] = rectangle[i];
}

/* ---- the prism ----------------------------------------------------------- */

static enum tcs_status
project(struct prism_outline *outline, const struct frame *frame,
	const struct tcs_point *points, size_t count, double range[2],
	struct tcs_fault *fault)
{
	array_clear(&outline->points);
	if (array_grow(&outline->points, count))
		return fault_memory(fault);
	range[0] = INFINITY;
	range[1] = -INFINITY;
	for (size_t i = 0; i < count; i++) {
		double height = vector_dot(points[i], frame->axis);

		outline->points.at[i] =
			(struct planar_point){vector_dot(points[i], frame->x),
				vector_dot(points[i], frame->y)};
		range[0] = fmin(range[0], height);
		range[1] = fmax(range[1], height);
	}
	outline->points.count = count;
	return TCS_OK;
}

static void
find_planes(struct prism *prism, const double range[2])
{
	unsigned sides = prism->sides;

	for (unsigned i = 0; i < sides; i++) {
		struct tcs_point from = prism->corners[i];
		struct tcs_point across = vector_cross(
			vector_difference(
				prism->corners[(i + 1) % sides], from),
			prism->axis);
		struct tcs_point normal =
			vector_scaled(across, 1 / vector_length(across));

		prism->planes[i] =
			(struct prism_plane){normal, vector_dot(normal, from)};
	}
	prism->planes[sides] =
		(struct prism_plane){vector_scaled(prism->axis, -1), -range[0]};
	prism->planes[sides + 1] = (struct prism_plane){prism->axis, range[1]};
}

static void
erect(struct prism *prism, const struct planar_points *hull,
	const struct frame *frame, const double range[2])
{
	prism->sides = (unsigned)hull->count;
	prism->axis = frame->axis;
	prism->volume = area_of(hull->at, hull->count) * (range[1] - range[0]);
	for (unsigned i = 0; i < 2 * prism->sides; i++) {
		struct planar_point at = hull->at[i % prism->sides];
		struct tcs_point flat =
			vector_sum(vector_scaled(frame->x, at.x),
				vector_scaled(frame->y, at.y));

		prism->corners[i] = vector_along(
			flat, frame->axis, range[i >= prism->sides]);
	}
	find_planes(prism, range);
}

static bool
is_solid(const struct planar_points *hull, const double range[2])
{
	double around = 0;

	if (hull->count < 3 || range[1] - range[0] < LEAST_SIZE)
		return false;
	for (size_t i = 0; i < hull->count; i++) {
		struct planar_point side =
			between(hull->at[i], hull->at[(i + 1) % hull->count]);
		double length = hypot(side.x, side.y);

		if (length < LEAST_SIZE)
			return false;
		around += length;
	}
	return area_of(hull->at, hull->count) > LEAST_SIZE * around;
}

enum tcs_status
prism_around(struct prism *prism, struct prism_outline *outline,
	const struct tcs_point *points, size_t count, struct tcs_point axis,
	unsigned sides, bool *fine, struct tcs_fault *fault)
{
	struct frame frame = frame_of(axis);
	enum tcs_status status;
	double range[2];

	*fine = false;
	if (count < 4)
		return TCS_OK;
	status = project(outline, &frame, points, count, range, fault);
	if (!status)
		status = find_hull(outline, fault);
	if (status || outline->hull.count < 3 ||
		outline->hull.count > MOST_SIDES)
		return status;
	reduce_hull(&outline->hull, sides < PRISM_SIDES ? sides : PRISM_SIDES);
	*fine = is_solid(&outline->hull, range);
	if (*fine)
		erect(prism, &outline->hull, &frame, range);
	return TCS_OK;
}

void
prism_triangle(
	const struct prism *prism, unsigned triangle, unsigned corners[3])
{
	unsigned sides = prism->sides, fan = sides - 2, side;

	if (triangle < 2 * fan) {
		unsigned first = triangle % fan;
		bool upper = triangle >= fan;

		corners[0] = upper ? sides : 0;
		corners[1] = upper ? sides + first + 1 : first + 2;
		corners[2] = upper ? sides + first + 2 : first + 1;
		return;
	}
	triangle -= 2 * fan;
	side = triangle / 2;
	corners[0] = side;
	corners[1] =
		triangle % 2 ? sides + (side + 1) % sides : (side + 1) % sides;
	corners[2] = triangle % 2 ? sides + side : sides + (side + 1) % sides;
}

struct triangle_shape
prism_shape(const struct prism *prism, unsigned triangle)
{
	struct triangle_shape shape;
	unsigned corners[3];

	prism_triangle(prism, triangle, corners);
	for (int k = 0; k < 3; k++)
		shape.corner[k] = prism->corners[corners[k]];
	return shape;
}

double
prism_height(const struct prism *prism, struct tcs_point from)
{
	double most = -INFINITY;

	for (unsigned i = 0; i < prism->sides + 2; i++) {
		double height = vector_dot(prism->planes[i].normal, from) -
			prism->planes[i].height;

		most = height > most ? height : most;
	}
	return most;
}

void
prism_outline_release(struct prism_outline *outline)
{
	array_release(&outline->points);
	array_release(&outline->hull);
}
