#include "solid_loops.h"

#include <math.h>

struct solid_view
solid_view_of(const struct solid_plane *plane, bool up)
{
	double x = fabs(plane->normal.x), y = fabs(plane->normal.y);
	double z = fabs(plane->normal.z), third;
	unsigned axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;

	third = axis == 0   ? plane->normal.x
		: axis == 1 ? plane->normal.y
			    : plane->normal.z;
	return (struct solid_view){axis, (third > 0) != up};
}

struct planar_point
solid_view_at(struct solid_view view, struct tcs_point at)
{
	double x = view.axis == 0 ? at.y : view.axis == 1 ? at.z : at.x;
	double y = view.axis == 0 ? at.z : view.axis == 1 ? at.x : at.y;

	return (struct planar_point){x, view.mirrored ? -y : y};
}

static struct planar_point
place_of(
	const struct solid_outline *outline, struct solid_view view, uint32_t i)
{
	return solid_view_at(view, outline->weld.points.at[i]);
}

/* ---- walking ----------------------------------------------------------------- */

static void
rims_link(struct solid_outline *outline, size_t first, size_t end)
{
	for (size_t i = first; i < end; i++)
		outline->joints.at[outline->rims.at[i].from].rim = 0;
	for (size_t i = end; i > first; i--) {
		struct solid_rim *rim = &outline->rims.at[i - 1];
		uint32_t *head = &outline->joints.at[rim->from].rim;

		rim->next = *head;
		*head = (uint32_t)i;
	}
}

/* The angle from an edge out of a point, counterclockwise, to that back from
 * where the walk came. */
static double
angle_of(const struct solid_outline *outline, struct solid_view view,
	const struct solid_rim *in, const struct solid_rim *out)
{
	struct planar_point at = place_of(outline, view, in->to);
	struct planar_point from = place_of(outline, view, in->from);
	struct planar_point to = place_of(outline, view, out->to);
	double bx = from.x - at.x, by = from.y - at.y;
	double dx = to.x - at.x, dy = to.y - at.y;
	double angle = atan2(dx * by - dy * bx, dx * bx + dy * by);

	return angle > 0 ? angle : angle + 2 * 3.14159265358979323846;
}

/* The next unused edge, with nothing but the face's inside between. */
static uint32_t
rim_after(const struct solid_outline *outline, struct solid_view view,
	uint32_t number)
{
	const struct solid_rim *rims = outline->rims.at, *in = &rims[number];
	uint32_t best = UINT32_MAX, at = outline->joints.at[in->to].rim;
	double best_angle = INFINITY;

	for (; at; at = rims[at - 1].next) {
		double angle;

		if (rims[at - 1].used)
			continue;
		if (best == UINT32_MAX && !rims[at - 1].next)
			return at - 1;
		angle = angle_of(outline, view, in, &rims[at - 1]);
		if (angle < best_angle) {
			best_angle = angle;
			best = at - 1;
		}
	}
	return best;
}

static double
loop_area(const struct solid_outline *outline, struct solid_view view,
	const struct solid_loop *loop)
{
	const uint32_t *points = outline->loop_points.at + loop->first;
	struct planar_point first = place_of(outline, view, points[0]);
	double area = 0, x = 0, y = 0;

	for (uint32_t i = 1; i < loop->count; i++) {
		struct planar_point at = place_of(outline, view, points[i]);
		double to_x = at.x - first.x, to_y = at.y - first.y;

		area += x * to_y - y * to_x;
		x = to_x;
		y = to_y;
	}
	return area / 2;
}

/* The end of the path, from `first` on, is a loop. */
static enum tcs_status
loop_take(struct solid_outline *outline, struct solid_view view, size_t first,
	struct tcs_fault *fault)
{
	struct solid_loop loop = {.first = (uint32_t)outline->loop_points.count,
		.owner = UINT32_MAX};

	if (array_grow(&outline->loop_points, outline->path.count - first) ||
		array_grow(&outline->loops, 1))
		return fault_memory(fault);
	for (size_t i = first; i < outline->path.count; i++) {
		struct solid_rim *rim = &outline->rims.at[outline->path.at[i]];
		struct solid_joint *joint = &outline->joints.at[rim->from];

		rim->loop = (uint32_t)outline->loops.count;
		joint->place = 0;
		if (joint->straight)
			continue;
		outline->loop_points.at[outline->loop_points.count++] =
			rim->from;
		loop.count++;
	}
	outline->path.count = first;
	if (loop.count < 3)
		return TCS_OK;
	loop.area = loop_area(outline, view, &loop);
	outline->loops.at[outline->loops.count++] = loop;
	return TCS_OK;
}

/*
 * As many edges start at a point as end there, so the walk comes back to where
 * it began. Wherever it comes back to a point before, it has walked a loop.
 */
static enum tcs_status
loops_take(struct solid_outline *outline, struct solid_view view, uint32_t at,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	array_clear(&outline->path);
	do {
		struct solid_rim *rim = &outline->rims.at[at];
		const struct solid_joint *to = &outline->joints.at[rim->to];

		if (array_grow(&outline->path, 1))
			return fault_memory(fault);
		outline->path.at[outline->path.count++] = at;
		outline->joints.at[rim->from].place =
			(uint32_t)outline->path.count;
		rim->used = true;
		if (to->place)
			status = loop_take(outline, view, to->place - 1, fault);
		at = rim_after(outline, view, at);
	} while (!status && outline->path.count && at != UINT32_MAX);
	return status;
}

/* ---- holes ------------------------------------------------------------------- */

static bool
loop_holds(const struct solid_outline *outline, struct solid_view view,
	const struct solid_loop *loop, struct planar_point at)
{
	const uint32_t *points = outline->loop_points.at + loop->first;
	struct planar_point a =
		place_of(outline, view, points[loop->count - 1]);
	bool odd = false;

	for (uint32_t i = 0; i < loop->count; i++) {
		struct planar_point b = place_of(outline, view, points[i]);

		if ((a.y <= at.y) != (b.y <= at.y))
			odd ^= a.y <= at.y ? planar_orient(a, b, at) > 0
					   : planar_orient(b, a, at) > 0;
		a = b;
	}
	return odd;
}

/*
 * The smallest loop around the hole; the middle of an edge of it is on no other
 * edge of the face. Where rounding left no loop around it, the largest is taken.
 */
static uint32_t
owner_of(const struct solid_outline *outline, struct solid_view view,
	const struct solid_loop *hole)
{
	const uint32_t *points = outline->loop_points.at + hole->first;
	struct planar_point a = place_of(outline, view, points[0]);
	struct planar_point b = place_of(outline, view, points[1]);
	struct planar_point at = {(a.x + b.x) / 2, (a.y + b.y) / 2};
	uint32_t best = UINT32_MAX, largest = UINT32_MAX;

	for (uint32_t i = 0; i < outline->loops.count; i++) {
		const struct solid_loop *loop = &outline->loops.at[i];

		if (loop->area <= 0)
			continue;
		if (largest == UINT32_MAX ||
			loop->area > outline->loops.at[largest].area)
			largest = i;
		if ((best == UINT32_MAX ||
			    loop->area < outline->loops.at[best].area) &&
			loop_holds(outline, view, loop, at))
			best = i;
	}
	return best == UINT32_MAX ? largest : best;
}

enum tcs_status
solid_loops_walk(struct solid_outline *outline, struct solid_view view,
	size_t first, size_t end, struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	array_clear(&outline->loops);
	array_clear(&outline->loop_points);
	rims_link(outline, first, end);
	for (size_t i = first; !status && i < end; i++)
		if (!outline->rims.at[i].used)
			status = loops_take(outline, view, (uint32_t)i, fault);
	for (size_t i = 0; !status && i < outline->loops.count; i++)
		if (outline->loops.at[i].area < 0)
			outline->loops.at[i].owner =
				owner_of(outline, view, &outline->loops.at[i]);
	return status;
}
