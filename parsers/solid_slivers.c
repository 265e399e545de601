#include "solid_slivers.h"

#include <math.h>
#include <stdlib.h>

#include "solid_loops.h"

/* ---- loops of all faces ------------------------------------------------------ */

/* Add up a face's loops, numbered from `base` on. */
static enum tcs_status
spans_add(struct solid_outline *outline, size_t first, size_t end,
	struct tcs_fault *fault)
{
	size_t base = outline->spans.count;

	if (array_grow(&outline->spans, outline->loops.count))
		return fault_memory(fault);
	for (size_t i = 0; i < outline->loops.count; i++)
		outline->spans.at[outline->spans.count++] =
			(struct solid_span){.area = outline->loops.at[i].area,
				.parent = (uint32_t)(base + i)};
	for (size_t i = first; i < end; i++) {
		struct solid_rim *rim = &outline->rims.at[i];
		struct solid_span *span;
		struct tcs_point off =
			point_minus(outline->weld.points.at[rim->to],
				outline->weld.points.at[rim->from]);
		double length = sqrt(point_dot(off, off));

		rim->loop += (uint32_t)base;
		span = &outline->spans.at[rim->loop];
		span->face = rim->face;
		span->length += length;
		if (length > span->longest) {
			span->longest = length;
			span->rim = (uint32_t)i;
		}
	}
	return TCS_OK;
}

static enum tcs_status
spans_find(struct solid_outline *outline, const struct solid_carver *carver,
	struct tcs_fault *fault)
{
	size_t first = 0;
	enum tcs_status status = TCS_OK;

	array_clear(&outline->spans);
	for (uint32_t i = 0; !status && i < outline->rim_ends.count; i++) {
		size_t end = outline->rim_ends.at[i];
		const struct solid_fragment *like =
			&outline->fragments.at[outline->face_fragments.at[i]];

		for (size_t j = first; j < end; j++)
			outline->rims.at[j].face = i;
		status = solid_loops_walk(outline,
			solid_view_of(
				&carver->planes.list.at[like->plane], like->up),
			first, end, fault);
		if (!status)
			status = spans_add(outline, first, end, fault);
		first = end;
	}
	for (size_t i = 0; i < outline->rims.count; i++)
		outline->rims.at[i].used = false;
	return status;
}

/* ---- the face beyond an edge ------------------------------------------------- */

static int
order_by_ends(const struct solid_rim *a, const struct solid_rim *b)
{
	if (a->from != b->from)
		return a->from < b->from ? -1 : 1;
	return (a->to > b->to) - (a->to < b->to);
}

static int
rim_order(const void *left, const void *right)
{
	const struct solid_rim *a = left, *b = right;
	int order = order_by_ends(a, b);

	return order ? order : (a->loop > b->loop) - (a->loop < b->loop);
}

/* The loop beyond an edge, which has it the other way round. `sorted` are all
 * rims. UINT32_MAX: none but its own. */
static uint32_t
loop_beyond(const struct solid_outline *outline, const struct solid_rim *sorted,
	const struct solid_rim *rim)
{
	const struct solid_rim key = {.from = rim->to, .to = rim->from};
	size_t low = 0, high = outline->rims.count;

	while (low < high) {
		size_t middle = low + (high - low) / 2;

		if (order_by_ends(&sorted[middle], &key) < 0)
			low = middle + 1;
		else
			high = middle;
	}
	for (; low < outline->rims.count && !order_by_ends(&sorted[low], &key);
		low++)
		if (sorted[low].loop != rim->loop)
			return sorted[low].loop;
	return UINT32_MAX;
}

static bool
is_narrow(const struct solid_span *span, double tolerance)
{
	return 2 * fabs(span->area) <= tolerance * span->length;
}

static struct solid_fragment *
span_fragment(const struct solid_outline *outline, uint32_t loop)
{
	uint32_t face = outline->spans.at[loop].face;

	return &outline->fragments.at[outline->face_fragments.at[face]];
}

/* Let faces without a name have that of one beyond one of their edges. */
static void
spans_name(struct solid_outline *outline, const struct solid_rim *sorted)
{
	for (size_t i = 0; i < outline->rims.count; i++) {
		const struct solid_rim *rim = &outline->rims.at[i];
		struct solid_fragment *own = span_fragment(outline, rim->loop);
		uint32_t beyond = own->named
			? UINT32_MAX
			: loop_beyond(outline, sorted, rim);
		const struct solid_fragment *other;

		if (beyond == UINT32_MAX)
			continue;
		other = span_fragment(outline, beyond);
		own->origin = other->origin;
		own->face = other->face;
		own->label = other->label;
		own->named = other->named;
	}
}

/* Find for every narrow loop that is not joined what it may be joined to: a
 * loop that is not narrow, or what that is joined to. */
static void
wishes_find(struct solid_outline *outline, const struct solid_rim *sorted,
	double tolerance)
{
	for (uint32_t i = 0; i < outline->spans.count; i++) {
		struct solid_span *span = &outline->spans.at[i];
		uint32_t beyond, parent;

		span->wish = UINT32_MAX;
		span->off = 0;
		if (span->parent != i || !is_narrow(span, tolerance))
			continue;
		beyond = loop_beyond(
			outline, sorted, &outline->rims.at[span->rim]);
		if (beyond == UINT32_MAX)
			continue;
		parent = outline->spans.at[beyond].parent;
		if (parent != beyond ||
			!is_narrow(&outline->spans.at[beyond], tolerance))
			span->wish = parent;
	}
}

/* How far the points of a loop are off the plane of what it may be joined to. */
static void
wishes_measure(struct solid_outline *outline, const struct solid_plane *planes)
{
	for (size_t i = 0; i < outline->rims.count; i++) {
		const struct solid_rim *rim = &outline->rims.at[i];
		struct solid_span *span = &outline->spans.at[rim->loop];
		const struct solid_plane *plane;

		if (span->wish == UINT32_MAX)
			continue;
		plane = &planes[span_fragment(outline, span->wish)->plane];
		span->off = fmax(span->off,
			fabs(solid_plane_distance(
				plane, outline->weld.points.at[rim->from])));
	}
}

/* Join what lies in the plane of the face beyond; false when nothing does. */
static bool
spans_join(struct solid_outline *outline, double tolerance)
{
	bool joined = false;

	for (size_t i = 0; i < outline->spans.count; i++) {
		struct solid_span *span = &outline->spans.at[i];

		if (span->wish == UINT32_MAX || span->off > 2 * tolerance)
			continue;
		span->parent = span->wish;
		joined = true;
	}
	return joined;
}

/* ---- edges by face again ----------------------------------------------------- */

static int
face_order(const void *left, const void *right)
{
	const struct solid_rim *a = left, *b = right;

	if (a->face != b->face)
		return a->face < b->face ? -1 : 1;
	return rim_order(left, right);
}

static enum tcs_status
rims_regroup(struct solid_outline *outline, struct tcs_fault *fault)
{
	size_t count = outline->rims.count, end = 0;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < count; i++) {
		struct solid_rim *rim = &outline->rims.at[i];

		uint32_t parent = outline->spans.at[rim->loop].parent;

		rim->face = outline->spans.at[parent].face;
	}
	qsort(outline->rims.at, count, sizeof *outline->rims.at, face_order);
	array_clear(&outline->sorted);
	if (array_grow(&outline->sorted, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		outline->sorted.at[outline->sorted.count++] =
			outline->rims.at[i];
	array_clear(&outline->rims);
	for (uint32_t i = 0; !status && i < outline->rim_ends.count; i++) {
		size_t first = end;

		while (end < count && outline->sorted.at[end].face == i)
			end++;
		status = solid_outline_cancel(outline,
			outline->sorted.at + first, end - first, fault);
		outline->rim_ends.at[i] = (uint32_t)outline->rims.count;
	}
	return status;
}

enum { MOST_ROUNDS = 8 }; /* of slivers beyond slivers */

enum tcs_status
solid_slivers_join(struct solid_outline *outline,
	const struct solid_carver *carver, struct tcs_fault *fault)
{
	double tolerance = carver->planes.tolerance;
	enum tcs_status status = spans_find(outline, carver, fault);
	size_t count = outline->rims.count;
	bool needed = false;

	for (uint32_t i = 0; !status && i < outline->spans.count; i++)
		needed |= is_narrow(&outline->spans.at[i], tolerance) ||
			!span_fragment(outline, i)->named;
	if (status || !needed)
		return status;
	array_clear(&outline->sorted);
	if (array_grow(&outline->sorted, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		outline->sorted.at[outline->sorted.count++] =
			outline->rims.at[i];
	qsort(outline->sorted.at, count, sizeof *outline->sorted.at, rim_order);
	for (unsigned i = 0; i < MOST_ROUNDS; i++)
		spans_name(outline, outline->sorted.at);
	for (unsigned i = 0; i < MOST_ROUNDS; i++) {
		wishes_find(outline, outline->sorted.at, tolerance);
		wishes_measure(outline, carver->planes.list.at);
		if (!spans_join(outline, tolerance))
			break;
	}
	return rims_regroup(outline, fault);
}
