#include "merge_price.h"

#include "number_sort.h"
#include "vector.h"

/* Samples of a triangle: so many by so many smaller ones have their centres
   asked. */
enum { FINEST = 4, SAMPLES = 256 };

/* Squares along each side of what is looked through. */
enum { GRID = 24 };

/* What could be looked through is off by this share of its width. */
#define THROUGH_SHARE 0.25

/* What a contact is worth that is left, but farther in. */
#define SWALLOWED_WORTH 0.1

/* Metres: what is nearer does not matter. */
#define LEAST_OFF 1e-3

/* Metres: no distance is rounded by more. */
#define ROUNDING 1e-6

/* What is nearer than this share of a distance is nearer, however it is
   rounded. */
#define CLEARLY 0.999

/* ---- how far it is off --------------------------------------------------- */

/* Into how many by how many parts a triangle is divided, so that all of an area
   has about SAMPLES. */
static unsigned
fineness(double area, double all)
{
	double fine = sqrt(SAMPLES * area / all);

	return fine < 1 ? 1 : fine > FINEST ? FINEST : (unsigned)fine;
}

/* The centre of part `number` of fine · fine. */
static struct tcs_point
sample_of(const struct triangle_shape *shape, unsigned fine, unsigned number)
{
	unsigned row = 0, left = number, width = 2 * fine - 1;
	double u, v;

	for (; left >= width; left -= width, width -= 2)
		row++;
	/* Every other one stands on its head. */
	u = (left / 2 + (left % 2 ? 2 : 1) / 3.0) / fine;
	v = (row + (left % 2 ? 2 : 1) / 3.0) / fine;
	return vector_along(
		vector_along(shape->corner[0],
			vector_difference(shape->corner[1], shape->corner[0]),
			u),
		vector_difference(shape->corner[2], shape->corner[0]), v);
}

/* From what one of the parts came with, if that is less than `least`; but for
   what is not more than `enough`. */
static enum tcs_status
distance_to_part(struct removals *removals, uint32_t part,
	struct tcs_point from, double enough, double *least,
	struct tcs_fault *fault)
{
	const struct box *box = &removals->parts.at.at[part].box;
	double distance = INFINITY;
	enum tcs_status status;

	if (!(box_distance_squared(box, from) < *least * *least))
		return TCS_OK;
	status = removals_distance(
		removals, part, from, *least, enough, &distance, fault);
	*least = fmin(*least, distance);
	return status;
}

/* The last point that was asked how far it is from the parts. */
struct asked {
	struct tcs_point from;
	double off;
	size_t nearest; /* of the parts */
};

/* From what all of them came with: no more than the last point's and the way from
   there. What was nearest to that comes first. */
static enum tcs_status
distance_to_parts(const struct merge_plan *plan, struct removals *removals,
	struct tcs_point from, struct asked *last, struct tcs_fault *fault)
{
	const uint32_t *parts = plan->parts.at;
	double step = vector_length(vector_difference(from, last->from));
	double least = last->off + step + ROUNDING;
	size_t first = last->nearest;
	enum tcs_status status = distance_to_part(
		removals, parts[first], from, 0, &least, fault);

	for (size_t i = 0; !status && i < plan->parts.count; i++) {
		double before = least;

		if (i != first)
			status = distance_to_part(
				removals, parts[i], from, 0, &least, fault);
		if (least < before)
			last->nearest = i;
	}
	last->from = from;
	last->off = least;
	return status;
}

/* Whether another part touches a point. */
static enum tcs_status
is_hidden(const struct merge_plan *plan, struct removals *removals,
	uint32_t part, struct tcs_point from, bool *hidden,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;

	*hidden = false;
	for (size_t i = 0; !status && !*hidden && i < plan->parts.count; i++) {
		double near = removals->reach;

		if (plan->parts.at[i] != part)
			status = distance_to_part(removals, plan->parts.at[i],
				from, CLEARLY * near, &near, fault);
		*hidden = near < removals->reach;
	}
	return status;
}

/* The prism from the parts. */
static enum tcs_status
prism_off(const struct merge_plan *plan, struct removals *removals, double *sum,
	struct tcs_fault *fault)
{
	unsigned count = PRISM_TRIANGLES_OF(plan->prism.sides);
	enum tcs_status status = TCS_OK;
	struct asked last = {.off = INFINITY};
	double all = 0;

	*sum = 0;
	for (unsigned i = 0; i < count; i++) {
		struct triangle_shape shape = prism_shape(&plan->prism, i);

		all += triangle_area(&shape);
	}
	for (unsigned i = 0; !status && i < count; i++) {
		struct triangle_shape shape = prism_shape(&plan->prism, i);
		double area = triangle_area(&shape);
		unsigned fine = fineness(area, all);

		for (unsigned k = 0; !status && k < fine * fine; k++) {
			status = distance_to_parts(plan, removals,
				sample_of(&shape, fine, k), &last, fault);
			*sum += area / (fine * fine) *
				removals_steep(removals, last.off);
		}
	}
	return status;
}

/* How much of a face as it came is not hidden by another of the parts, and what
   that is off from the prism. */
struct face_gap {
	double exposed; /* share */
	double sum; /* square metres times area */
};

static enum tcs_status
face_off(const struct merge_plan *plan, struct removals *removals,
	uint32_t part, uint32_t face, struct face_gap *gap,
	struct tcs_fault *fault)
{
	const struct collapses *work = removals->work;
	struct triangle_shape shape = component_set_shape(
		work->set, work->sheets->face_triangles.at[face]);
	double area = triangle_area(&shape);
	unsigned fine = fineness(area, plan->area);
	enum tcs_status status = TCS_OK;
	double share = 1.0 / (fine * fine);

	*gap = (struct face_gap){0, 0};
	for (unsigned i = 0; !status && i < fine * fine; i++) {
		struct tcs_point from = sample_of(&shape, fine, i);
		double off = fabs(prism_height(&plan->prism, from));
		bool hidden = false;

		if (off >= LEAST_OFF)
			status = is_hidden(
				plan, removals, part, from, &hidden, fault);
		if (hidden)
			continue;
		gap->exposed += share;
		if (off >= LEAST_OFF)
			gap->sum +=
				share * area * removals_steep(removals, off);
	}
	return status;
}

/* The parts from the prism. What was hidden when a part was merged is not known
   from its surface any more. */
static enum tcs_status
parts_off(const struct merge_plan *plan, struct merge_pricing *pricing,
	struct removals *removals, double *sum, struct tcs_fault *fault)
{
	const struct parts *parts = &removals->parts;
	enum tcs_status status = TCS_OK;

	*sum = 0;
	for (size_t i = 0; i < plan->parts.count; i++) {
		const struct part *own = &parts->at.at[plan->parts.at[i]];

		for (uint32_t k = 0; !status && k < own->count; k++) {
			uint32_t face = parts->faces.at[own->first + k];
			float *exposed = &pricing->exposed.at[face];
			struct face_gap gap = {0, 0};

			status = face_off(plan, removals, plan->parts.at[i],
				face, &gap, fault);
			if (own->rebuilt) {
				gap.sum *= (double)*exposed;
				gap.exposed =
					fmin(gap.exposed, (double)*exposed);
			}
			*exposed = (float)gap.exposed;
			*sum += gap.sum;
		}
	}
	return status;
}

/* ---- what one could look through ----------------------------------------- */

/* A window over the outline, in the plane across the axis. */
struct window {
	struct tcs_point origin, x, y; /* sides of one square */
	bool covered[GRID][GRID];
	unsigned left; /* that are not */
};

static struct window
window_of(const struct prism *prism)
{
	struct tcs_point from = prism->corners[0];
	struct tcs_point side = vector_difference(prism->corners[1], from);
	struct tcs_point x = vector_scaled(side, 1 / vector_length(side));
	struct tcs_point y = vector_cross(prism->axis, x);
	double low[2] = {0, 0}, high[2] = {0, 0};
	struct window window = {.left = GRID * GRID};

	for (unsigned i = 0; i < prism->sides; i++) {
		struct tcs_point at =
			vector_difference(prism->corners[i], from);
		const double place[2] = {vector_dot(at, x), vector_dot(at, y)};

		for (int k = 0; k < 2; k++) {
			low[k] = fmin(low[k], place[k]);
			high[k] = fmax(high[k], place[k]);
		}
	}
	window.origin = vector_along(vector_along(from, x, low[0]), y, low[1]);
	window.x = vector_scaled(x, (high[0] - low[0]) / GRID);
	window.y = vector_scaled(y, (high[1] - low[1]) / GRID);
	return window;
}

/* The middle of a square. */
static struct tcs_point
middle_of(const struct window *window, int row, int column)
{
	return vector_along(
		vector_along(window->origin, window->x, column + 0.5),
		window->y, row + 0.5);
}

/* A triangle as lines along the axis meet it. */
struct shade {
	struct tcs_point corner, side, across;
	double determinant;
};

static struct shade
shade_of(const struct triangle_shape *shape, struct tcs_point axis)
{
	struct tcs_point a = shape->corner[0];
	struct tcs_point side = vector_difference(shape->corner[1], a);
	struct tcs_point across =
		vector_cross(axis, vector_difference(shape->corner[2], a));

	return (struct shade){a, side, across, vector_dot(side, across)};
}

/*
 * Whether the line through a point meets it.
 *
 * source: T. Moeller, B. Trumbore, Fast, minimum storage ray-triangle
 * intersection, 1997.
 */
static bool
is_in_shade(const struct shade *shade, struct tcs_point axis,
	struct tcs_point point)
{
	struct tcs_point from = vector_difference(point, shade->corner);
	double u = vector_dot(from, shade->across) / shade->determinant;
	double v = vector_dot(axis, vector_cross(from, shade->side)) /
		shade->determinant;

	return u >= 0 && v >= 0 && 1 - u - v >= 0;
}

static void
cover(struct window *window, const struct triangle_shape *shape,
	struct tcs_point axis)
{
	struct shade shade = shade_of(shape, axis);
	double sizes[2] = {vector_dot(window->x, window->x),
		vector_dot(window->y, window->y)};
	double low[2] = {GRID, GRID}, high[2] = {0, 0};

	if (!(fabs(shade.determinant) > 0))
		return;
	for (int k = 0; k < 3; k++) {
		struct tcs_point at =
			vector_difference(shape->corner[k], window->origin);
		const double place[2] = {vector_dot(at, window->x) / sizes[0],
			vector_dot(at, window->y) / sizes[1]};

		for (int c = 0; c < 2; c++) {
			low[c] = fmax(0, fmin(low[c], floor(place[c])));
			high[c] = fmin(GRID, fmax(high[c], ceil(place[c])));
		}
	}
	for (int row = (int)low[1]; row < (int)high[1]; row++)
		for (int column = (int)low[0]; column < (int)high[0];
			column++) {
			if (window->covered[row][column] ||
				!is_in_shade(&shade, axis,
					middle_of(window, row, column)))
				continue;
			window->covered[row][column] = true;
			window->left--;
		}
}

static bool
is_in_outline(const struct prism *prism, struct tcs_point at)
{
	for (unsigned i = 0; i < prism->sides; i++) {
		struct tcs_point from = prism->corners[i];
		struct tcs_point along = vector_difference(
			prism->corners[(i + 1) % prism->sides], from);

		if (vector_dot(vector_cross(along, vector_difference(at, from)),
			    prism->axis) < 0)
			return false;
	}
	return true;
}

double
merge_open_area(const struct merge_plan *plan, const struct removals *removals)
{
	const struct collapses *work = removals->work;
	const struct parts *parts = &removals->parts;
	struct window window = window_of(&plan->prism);
	int open = 0;

	for (size_t i = 0; i < plan->parts.count; i++) {
		const struct part *own = &parts->at.at[plan->parts.at[i]];

		for (uint32_t k = 0; window.left > 0 && k < own->count; k++) {
			uint32_t face = parts->faces.at[own->first + k];
			struct triangle_shape shape =
				component_set_shape(work->set,
					work->sheets->face_triangles.at[face]);

			cover(&window, &shape, plan->prism.axis);
		}
	}
	for (int row = 0; window.left > 0 && row < GRID; row++)
		for (int column = 0; column < GRID; column++)
			open += !window.covered[row][column] &&
				is_in_outline(&plan->prism,
					middle_of(&window, row, column));
	return open * vector_length(window.x) * vector_length(window.y);
}

/* ---- what was paid ------------------------------------------------------- */

enum tcs_status
merge_pricing_begin(struct merge_pricing *pricing,
	const struct removals *removals, struct tcs_fault *fault)
{
	size_t faces = removals->parts.numbers.count;

	array_clear(&pricing->exposed);
	array_clear(&pricing->paid);
	if (array_grow(&pricing->exposed, faces) ||
		array_grow(&pricing->paid, removals->parts.count))
		return fault_memory(fault);
	pricing->exposed.count = faces;
	pricing->paid.count = removals->parts.count;
	for (size_t i = 0; i < faces; i++)
		pricing->exposed.at[i] = 1;
	for (size_t i = 0; i < removals->parts.count; i++)
		pricing->paid.at[i] = 0;
	return TCS_OK;
}

double
merge_paid(const struct merge_plan *plan, const struct merge_pricing *pricing)
{
	double paid = 0;

	for (size_t i = 0; i < plan->parts.count; i++)
		paid += pricing->paid.at[plan->parts.at[i]];
	return paid;
}

/* ---- the shape ----------------------------------------------------------- */

enum tcs_status
merge_off(const struct merge_plan *plan, struct merge_pricing *pricing,
	struct removals *removals, double *off, struct tcs_fault *fault)
{
	double open = merge_open_area(plan, removals);
	double width = THROUGH_SHARE * sqrt(open);
	double prism = 0, parts = 0;
	enum tcs_status status = prism_off(plan, removals, &prism, fault);

	if (!status)
		status = parts_off(plan, pricing, removals, &parts, fault);
	if (!status)
		*off = prism + parts + 2 * open * width * width;
	return status;
}

double
merge_seen_share(const struct merge_plan *plan, const struct removals *removals)
{
	const double *visible = removals->visible.at;
	double seen = 0;

	for (size_t i = 0; removals->visible.count > 0 && i < plan->parts.count;
		i++)
		seen += visible[plan->parts.at[i]];
	return fmax(plan->area > 0 ? seen / plan->area : 0, HIDDEN_SHARE);
}

/* ---- what breaks --------------------------------------------------------- */

static bool
is_among(
	const struct merge_plan *plan, const struct parts *parts, uint32_t face)
{
	return number_is_among(
		plan->parts.at, plan->parts.count, parts->numbers.at[face]);
}

/* Whether a point that a face of the parts holds is far from the prism: as it
   is around all of them, within it. */
static bool
is_swallowed(const struct merge_plan *plan, const struct removals *removals,
	uint32_t hold)
{
	const struct seams *seams = removals->work->seams;
	const struct seam_point *point = &seams->points.at[hold / 2];
	const struct seam_hold *other = &seams->holds.at[hold ^ 1];

	if (other->face == TCS_NONE ||
		is_among(plan, &removals->parts, other->face))
		return false;
	return fabs(prism_height(&plan->prism, point->at)) +
		(double)other->off >
		(double)point->limit;
}

static enum tcs_status
list_swallowed(const struct merge_plan *plan, struct merge_pricing *pricing,
	const struct removals *removals, struct tcs_fault *fault)
{
	const struct seams *seams = removals->work->seams;

	pricing->swallowed.count = 0;
	for (size_t i = 0; i < plan->faces.count; i++)
		for (uint32_t hold = seams->faces.at[plan->faces.at[i]];
			hold != TCS_NONE; hold = seams->holds.at[hold].next) {
			if (!is_swallowed(plan, removals, hold))
				continue;
			if (array_grow(&pricing->swallowed, 1))
				return fault_memory(fault);
			pricing->swallowed.at[pricing->swallowed.count++] =
				seams->points.at[hold / 2].contact;
		}
	number_sort(pricing->swallowed.at, pricing->swallowed.count);
	return TCS_OK;
}

/* Those of which so many points are swallowed that they look half open. */
static double
count_broken(const struct merge_pricing *pricing, const struct collapses *work)
{
	double broken = 0;

	for (size_t i = 0, end; i < pricing->swallowed.count; i = end) {
		uint32_t contact = pricing->swallowed.at[i];
		const struct seam_count *count =
			&work->seams->counts.at[contact];

		for (end = i; end < pricing->swallowed.count &&
			pricing->swallowed.at[end] == contact;)
			end++;
		if (SEAM_KEPT_TO_OPEN * (end - i) >= count->points)
			broken += SWALLOWED_WORTH *
				(double)work->worths.at[contact];
	}
	return broken;
}

enum tcs_status
merge_harm(const struct merge_plan *plan, struct merge_pricing *pricing,
	struct removals *removals, double *harm, bool *fine,
	struct tcs_fault *fault)
{
	struct refill refill = merge_plan_refill(plan);
	enum tcs_status status =
		crossing_watch_admits(removals->work, &refill, fine, fault);

	*harm = removals->work->broken;
	if (status || !*fine)
		return status;
	status = list_swallowed(plan, pricing, removals, fault);
	*harm += count_broken(pricing, removals->work);
	return status;
}

void
merge_pricing_release(struct merge_pricing *pricing)
{
	array_release(&pricing->exposed);
	array_release(&pricing->paid);
	array_release(&pricing->swallowed);
}
