/*
 * Positions: from the text of rings to points.
 */
#include "citygml_build.h"

#include "citygml_numbers.h"

/* ---- dimensions ---------------------------------------------------------------- */

static bool
closes(const struct number_list *numbers, size_t dimension)
{
	const double *first = numbers->at;
	const double *last = numbers->at + numbers->count - dimension;

	for (size_t i = 0; i < dimension; i++)
		if (first[i] < last[i] || first[i] > last[i])
			return false;
	return true;
}

/*
 * 2 or 3 numbers a position; 0 when neither fits. A declaration holds if the
 * count agrees with it; else single positions tell; else three, unless only
 * pairs close the ring.
 */
static size_t
dimension_find(const struct raw_ring *ring, const struct number_list *numbers)
{
	size_t count = numbers->count;

	if (!count)
		return 0;
	if (!ring->has_list && ring->pos_count && !(count % ring->pos_count)) {
		size_t each = count / ring->pos_count;

		return each == 2 || each == 3 ? each : 0;
	}
	if (ring->dimension && !(count % ring->dimension))
		return ring->dimension;
	if (!ring->dimension && !(count % 6) && !closes(numbers, 3) &&
		closes(numbers, 2))
		return 2;
	if (!(count % 3))
		return 3;
	return !ring->dimension && !(count % 2) ? 2 : 0;
}

/* ---- one ring --------------------------------------------------------------------- */

static bool
points_equal(const struct tcs_point *a, const struct tcs_point *b)
{
	return !(a->x < b->x || a->x > b->x || a->y < b->y || a->y > b->y ||
		a->z < b->z || a->z > b->z);
}

/* Whether at least three points of the run differ. */
static bool
has_three(const struct tcs_point *points, size_t count)
{
	const struct tcs_point *second = NULL;

	for (size_t i = 1; i < count; i++) {
		if (points_equal(&points[i], &points[0]))
			continue;
		if (!second)
			second = &points[i];
		else if (!points_equal(&points[i], second))
			return true;
	}
	return false;
}

static enum tcs_status
points_append(struct builder *builder, size_t dimension, bool swap,
	struct tcs_fault *fault)
{
	const struct number_list *numbers = &builder->numbers;
	size_t count = numbers->count / dimension;
	struct tcs_point *to;

	if (array_grow(&builder->points, count))
		return fault_memory(fault);
	to = builder->points.at + builder->points.count;
	for (size_t i = 0; i < count; i++) {
		const double *from = numbers->at + i * dimension;

		to[i].x = from[swap];
		to[i].y = from[!swap];
		to[i].z = dimension == 3 ? from[2] : 0;
	}
	builder->points.count += count;
	return TCS_OK;
}

/* The closing point goes; a ring that lacks it is closed all the same. */
static enum tcs_status
ring_close(struct builder *builder, size_t first, const char *id, uint32_t line,
	struct report *report, struct tcs_fault *fault)
{
	size_t count = builder->points.count - first;
	const struct tcs_point *points = builder->points.at + first;

	if (count > 1 && points_equal(&points[0], &points[count - 1])) {
		builder->points.count--;
		return TCS_OK;
	}
	return raw_report(report, REPORT_REPAIRED, "ring",
		"closed: its last point was not its first", id, line, fault);
}

static enum tcs_status
ring_read(struct builder *builder, const struct raw_object *home,
	const struct raw_polygon *polygon, const struct raw_ring *ring,
	const char **problem, struct report *report, struct tcs_fault *fault)
{
	const char *id = object_text(&home->tree, polygon->id);
	size_t first = builder->points.count;
	enum tcs_status status;
	size_t dimension;
	bool bad;

	status = numbers_read(&builder->numbers,
		home->positions.at + ring->first, ring->length, &bad, fault);
	if (status)
		return status;
	dimension = dimension_find(ring, &builder->numbers);
	if (bad)
		*problem = "a coordinate is no finite number";
	else if (!builder->numbers.count)
		*problem = "no positions";
	else if (!dimension)
		*problem = "the numbers are no triples";
	if (*problem)
		return TCS_OK;
	status = points_append(builder, dimension, polygon->swap, fault);
	array_trim(&builder->numbers);
	if (!status && polygon->shape == RAW_AREA)
		status = ring_close(
			builder, first, id, polygon->line, report, fault);
	return status;
}

/* ---- the polygon ---------------------------------------------------------------------- */

static enum tcs_status
ring_keep(struct builder *builder, const struct raw_ring *ring, uint32_t place,
	size_t first, struct tcs_fault *fault)
{
	if (array_grow(&builder->ring_sizes, 1) ||
		array_grow(&builder->ring_ids, 1) ||
		array_grow(&builder->ring_places, 1))
		return fault_memory(fault);
	builder->ring_sizes.at[builder->ring_sizes.count++] =
		(uint32_t)(builder->points.count - first);
	builder->ring_ids.at[builder->ring_ids.count++] = ring->id;
	builder->ring_places.at[builder->ring_places.count++] = place;
	return TCS_OK;
}

/* Outer rings in the first round, holes in the second. */
static enum tcs_status
rings_take(struct builder *builder, const struct raw_object *home,
	const struct raw_polygon *polygon, bool interior, const char **problem,
	struct report *report, struct tcs_fault *fault)
{
	const char *id = object_text(&home->tree, polygon->id);

	for (uint32_t i = 0; i < polygon->ring_count && !*problem; i++) {
		const struct raw_ring *ring =
			&home->rings.at[polygon->first_ring + i];
		size_t first = builder->points.count;
		enum tcs_status status;

		if (polygon->shape == RAW_AREA && ring->interior != interior)
			continue;
		status = ring_read(
			builder, home, polygon, ring, problem, report, fault);
		if (status || *problem)
			return status;
		if (polygon->shape == RAW_AREA &&
			!has_three(builder->points.at + first,
				builder->points.count - first)) {
			if (!interior) {
				*problem = "fewer than three points";
				return TCS_OK;
			}
			builder->points.count = first;
			status = raw_report(report, REPORT_REPAIRED, "hole",
				"left out: fewer than three points", id,
				polygon->line, fault);
		} else {
			status = ring_keep(builder, ring, i, first, fault);
		}
		if (status)
			return status;
	}
	return TCS_OK;
}

enum tcs_status
rings_read(struct builder *builder, const struct raw_object *home,
	const struct raw_polygon *polygon, const char **problem,
	struct report *report, struct tcs_fault *fault)
{
	enum tcs_status status;

	builder->points.count = 0;
	builder->ring_sizes.count = 0;
	builder->ring_ids.count = 0;
	builder->ring_places.count = 0;
	*problem = NULL;
	status = rings_take(
		builder, home, polygon, false, problem, report, fault);
	if (status || *problem)
		return status;
	if (builder->ring_sizes.count != 1) {
		*problem = builder->ring_sizes.count
			? "more than one outer ring"
			: "no outer ring";
		return TCS_OK;
	}
	if (polygon->shape != RAW_AREA)
		return TCS_OK;
	return rings_take(builder, home, polygon, true, problem, report, fault);
}
