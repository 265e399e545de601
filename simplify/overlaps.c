#include "overlaps.h"

#include <math.h>
#include <stdlib.h>

/* Metres. */
#define FLICKER 0.001 /* nearer than this is in one plane */
#define SUNK 0.008 /* farther behind than this is hidden on purpose */
#define APART 0.002 /* what is parted gets apart so far, at most */
#define BESIDE 0.1 /* around a place where the original is looked for */

/* Square metres of common area below which nobody sees it. */
#define LEAST_AREA 1e-4

#define PARALLEL 0.9998 /* cosine, about a degree */
#define ROUNDING 1e-5 /* of a normal in single precision */
#define TURN 0.021 /* of a coordinate of a normal from that of a parallel one */

/* A triangle clipped by the three sides of another has so many corners. */
enum { CLIPPED = 6 };

struct flat {
	struct tcs_point at[CLIPPED];
	int count;
};

/* One face that is left. */
struct plate {
	uint32_t face, component;
	uint32_t nodes[3];
	struct triangle_shape shape;
	struct tcs_point normal; /* of length 1 */
};

struct search {
	struct overlaps *overlaps;
	struct collapses *work;
	struct plate own;
	struct tcs_fault *fault;
};

static uint32_t
component_of(const struct collapses *work, uint32_t face)
{
	return work->set->numbers.at[work->sheets->face_triangles.at[face]];
}

/* False for a face that is gone, or has no normal. */
static bool
load_plate(const struct collapses *work, uint32_t face, struct plate *out)
{
	double length;

	if (!collapses_face(work, face, out->nodes))
		return false;
	out->face = face;
	out->component = component_of(work, face);
	for (int k = 0; k < 3; k++)
		out->shape.corner[k] = work->positions.at[out->nodes[k]];
	out->normal = triangle_normal(&out->shape);
	length = vector_length(out->normal);
	if (length > 0)
		out->normal = vector_scaled(out->normal, 1 / length);
	return length > 0;
}

/* ---- what two faces have in common ---------------------------------------- */

/* What lies to the left of a → b, seen against the normal. */
static void
clip(struct flat *flat, struct tcs_point a, struct tcs_point b,
	struct tcs_point normal)
{
	struct tcs_point inward = vector_cross(normal, vector_difference(b, a));
	struct flat out = {.count = 0};

	for (int i = 0; i < flat->count; i++) {
		struct tcs_point from = flat->at[i];
		struct tcs_point to = flat->at[(i + 1) % flat->count];
		double here = vector_dot(inward, vector_difference(from, a));
		double there = vector_dot(inward, vector_difference(to, a));

		if (here >= 0 && out.count < CLIPPED)
			out.at[out.count++] = from;
		if ((here < 0) != (there < 0) && out.count < CLIPPED)
			out.at[out.count++] =
				vector_along(from, vector_difference(to, from),
					here / (here - there));
	}
	*flat = out;
}

/* The part of `upper` that stands over `lower`: its area and centre. */
static double
common_area(const struct plate *upper, const struct plate *lower,
	struct tcs_point *centre)
{
	const struct tcs_point *corner = lower->shape.corner;
	struct flat flat = {.count = 3};
	struct tcs_point sum = {0, 0, 0};
	double area = 0;

	for (int k = 0; k < 3; k++)
		flat.at[k] = upper->shape.corner[k];
	for (int k = 0; k < 3; k++)
		clip(&flat, corner[k], corner[(k + 1) % 3], lower->normal);
	for (int i = 2; i < flat.count; i++) {
		struct triangle_shape part = {
			{flat.at[0], flat.at[i - 1], flat.at[i]}};
		double more = triangle_area(&part);

		area += more;
		sum = vector_along(sum, triangle_centre(&part), more);
	}
	if (area > 0)
		*centre = vector_scaled(sum, 1 / area);
	return area;
}

/* ---- what was there before ------------------------------------------------ */

static enum tcs_status
root_of(struct search *search, uint32_t component, uint32_t *root)
{
	const struct component_set *set = search->work->set;
	const struct component *own = &set->components.at[component];
	struct overlaps *overlaps = search->overlaps;
	enum tcs_status status = TCS_OK;

	if (overlaps->roots.at[component] == TCS_NONE)
		status = triangle_tree_add(&overlaps->tree, set->points.at,
			set->triangles.at, set->order.at + own->first,
			own->count, &overlaps->roots.at[component],
			search->fault);
	*root = overlaps->roots.at[component];
	return status;
}

/* How high over a place a component had a face that looks this way; NaN where
   it had none near it. */
static enum tcs_status
height_before(struct search *search, uint32_t component, struct tcs_point at,
	struct tcs_point normal, double *height)
{
	struct tree_hit hit;
	uint32_t root;
	enum tcs_status status = root_of(search, component, &root);

	*height = NAN;
	if (status)
		return status;
	hit = triangle_tree_nearest_facing(
		&search->overlaps->tree, root, at, normal, BESIDE);
	if (isfinite(hit.distance))
		*height = vector_dot(normal, vector_difference(hit.point, at));
	return TCS_OK;
}

/* ---- parting -------------------------------------------------------------- */

/* A node that already moves as far along the normal needs no more. */
static void
shift_face(struct search *search, const struct plate *plate,
	struct tcs_point normal, double by)
{
	for (int k = 0; k < 3; k++) {
		struct tcs_point *shift =
			&search->overlaps->shifts.at[plate->nodes[k]];
		double more = by - vector_dot(*shift, normal);

		if (by > 0 ? more > 0 : more < 0)
			*shift = vector_along(*shift, normal, more);
	}
}

/* `now` is how high the upper face is over the lower one, `before` was. */
static void
part(struct search *search, const struct plate *upper,
	const struct plate *lower, double now, double before)
{
	const struct component *components = search->work->set->components.at;
	double wanted = copysign(fmin(fabs(before), APART), before);

	search->overlaps->parted++;
	if (components[upper->component].area <
		components[lower->component].area)
		shift_face(search, upper, lower->normal, wanted - now);
	else
		shift_face(search, lower, lower->normal, now - wanted);
}

static enum tcs_status
judge(struct search *search, const struct plate *upper,
	const struct plate *lower)
{
	struct tcs_point normal = lower->normal, at;
	double now, above = NAN, below = NAN;
	enum tcs_status status;

	if (vector_dot(upper->normal, normal) < PARALLEL)
		return TCS_OK;
	now = vector_dot(normal,
		vector_difference(
			upper->shape.corner[0], lower->shape.corner[0]));
	if (fabs(now) > BESIDE ||
		!(common_area(upper, lower, &at) > LEAST_AREA))
		return TCS_OK;
	now = vector_dot(normal, vector_difference(at, lower->shape.corner[0]));
	if (fabs(now) > SUNK)
		return TCS_OK;
	status = height_before(search, upper->component, at, normal, &above);
	if (!status)
		status = height_before(
			search, lower->component, at, normal, &below);
	if (status || !(fabs(above - below) > FLICKER))
		return status;
	if (fabs(now) <= FLICKER || (now > 0) != (above > below))
		part(search, upper, lower, now, above - below);
	return TCS_OK;
}

static struct box
box_of(const struct triangle_shape *shape)
{
	struct box box = BOX_EMPTY;

	for (int k = 0; k < 3; k++)
		box_add_point(&box, shape->corner[k]);
	return box;
}

static bool
may_be_parallel(const struct plate *own, const struct overlap_face *other)
{
	return own->normal.x * (double)other->normal[0] +
		own->normal.y * (double)other->normal[1] +
		own->normal.z * (double)other->normal[2] >
		PARALLEL - ROUNDING;
}

static enum tcs_status
visit(struct search *search, const struct overlap_face *there)
{
	const struct overlaps *overlaps = search->overlaps;
	uint32_t face = there->face;
	struct plate other;

	/* A pair of changed faces once. */
	if (!may_be_parallel(&search->own, there) ||
		(face <= search->own.face && overlaps->changed.at[face]) ||
		component_of(search->work, face) == search->own.component ||
		!load_plate(search->work, face, &other))
		return TCS_OK;
	return judge(search, &search->own, &other);
}

/* ---- ways to look --------------------------------------------------------- */

/* The bin of a coordinate of a normal. */
static unsigned
bin_of(double at)
{
	double bin = (at + 1) / 2 * OVERLAP_BINS;

	return bin < 0			 ? 0
		: bin < OVERLAP_BINS - 1 ? (unsigned)bin
					 : OVERLAP_BINS - 1;
}

static unsigned
way_in(const unsigned bins[3])
{
	return (bins[0] * OVERLAP_BINS + bins[1]) * OVERLAP_BINS + bins[2];
}

static unsigned
way_of(const struct overlap_face *face)
{
	unsigned bins[3];

	for (int i = 0; i < 3; i++)
		bins[i] = bin_of((double)face->normal[i]);
	return way_in(bins);
}

/* All pairs of one face with those that look one way. */
static enum tcs_status
visit_way(struct search *search, unsigned way, const struct float_box *box)
{
	struct overlaps *overlaps = search->overlaps;
	enum tcs_status status;

	if (overlaps->runs[way] == TCS_NONE)
		return TCS_OK;
	status = face_boxes_near(&overlaps->boxes, overlaps->runs[way], box,
		&overlaps->near, search->fault);
	for (size_t i = 0; !status && i < overlaps->near.count; i++)
		status = visit(
			search, &overlaps->faces.at[overlaps->near.at[i]]);
	return status;
}

/* All pairs of one face. */
static enum tcs_status
visit_near(struct search *search)
{
	struct tcs_point normal = search->own.normal;
	const double at[3] = {normal.x, normal.y, normal.z};
	struct box bounds = box_of(&search->own.shape);
	struct float_box box = float_box_around(
		(struct tcs_point){bounds.low[0], bounds.low[1], bounds.low[2]},
		(struct tcs_point){
			bounds.high[0], bounds.high[1], bounds.high[2]},
		SUNK);
	unsigned low[3], high[3], bins[3];
	enum tcs_status status = TCS_OK;

	/* Each coordinate lies in one bin or near the next. */
	for (int i = 0; i < 3; i++) {
		low[i] = bin_of(at[i] - TURN);
		high[i] = bin_of(at[i] + TURN);
	}
	for (bins[2] = low[2]; bins[2] <= high[2]; bins[2]++)
		for (bins[1] = low[1]; bins[1] <= high[1]; bins[1]++)
			for (bins[0] = low[0]; !status && bins[0] <= high[0];
				bins[0]++)
				status = visit_way(search, way_in(bins), &box);
	return status;
}

/* ---- all faces ------------------------------------------------------------ */

/* Whether a face has other corners than it came with, or they are elsewhere. */
static bool
is_changed(const struct collapses *work, const struct plate *plate)
{
	const uint32_t *corners = work->sheets->corners.at + 3 * plate->face;
	uint32_t shift = 0;

	/* They need not begin with the same one. */
	while (shift < 2 && node_of(work, corners[shift]) != plate->nodes[0])
		shift++;
	for (uint32_t k = 0; k < 3; k++)
		if (plate->nodes[k] !=
				node_of(work, corners[(k + shift) % 3]) ||
			collapses_is_moved(work, plate->nodes[k]))
			return true;
	return false;
}

static enum tcs_status
begin(struct overlaps *overlaps, const struct collapses *work,
	struct tcs_fault *fault)
{
	size_t faces = work->sheets->face_triangles.count;
	size_t nodes = work->sheets->node_count;
	size_t components = work->set->components.count;

	overlaps->parted = 0;
	array_clear(&overlaps->faces);
	array_clear(&overlaps->changed);
	array_clear(&overlaps->shifts);
	face_boxes_clear(&overlaps->boxes);
	array_clear(&overlaps->tree.boxes.nodes);
	array_clear(&overlaps->tree.boxes.items);
	array_clear(&overlaps->tree.shapes);
	array_clear(&overlaps->roots);
	if (array_grow(&overlaps->faces, work->face_count) ||
		array_grow(&overlaps->changed, faces) ||
		array_grow(&overlaps->shifts, nodes) ||
		array_grow(&overlaps->roots, components))
		return fault_memory(fault);
	overlaps->changed.count = faces;
	overlaps->shifts.count = nodes;
	overlaps->roots.count = components;
	for (size_t i = 0; i < nodes; i++)
		overlaps->shifts.at[i] = (struct tcs_point){0, 0, 0};
	for (size_t i = 0; i < components; i++)
		overlaps->roots.at[i] = TCS_NONE;
	return TCS_OK;
}

/* The faces that are left, and how many look each way. */
static void
list_faces(struct overlaps *overlaps, const struct collapses *work,
	size_t counts[OVERLAP_WAYS])
{
	size_t faces = work->sheets->face_triangles.count;

	for (uint32_t i = 0; i < faces; i++) {
		struct plate plate;
		struct overlap_face *face =
			&overlaps->faces.at[overlaps->faces.count];

		overlaps->changed.at[i] = false;
		if (!load_plate(work, i, &plate))
			continue;
		overlaps->changed.at[i] = is_changed(work, &plate);
		*face = (struct overlap_face){i,
			{(float)plate.normal.x, (float)plate.normal.y,
				(float)plate.normal.z}};
		counts[way_of(face)]++;
		overlaps->faces.count++;
	}
}

/* Their boxes, those that look the same way together. */
static void
sort_boxes(const struct overlaps *overlaps, const struct collapses *work,
	const size_t counts[OVERLAP_WAYS], uint32_t *places,
	struct float_box *boxes)
{
	size_t ends[OVERLAP_WAYS], end = 0;

	for (unsigned way = 0; way < OVERLAP_WAYS; way++) {
		ends[way] = end;
		end += counts[way];
	}
	for (uint32_t i = 0; i < overlaps->faces.count; i++) {
		const struct overlap_face *face = &overlaps->faces.at[i];
		size_t place = ends[way_of(face)]++;
		struct triangle_shape shape = collapses_shape(work, face->face);

		places[place] = i;
		boxes[place] = float_box_of(&shape);
	}
}

static enum tcs_status
add_ways(struct overlaps *overlaps, const size_t counts[OVERLAP_WAYS],
	const uint32_t *places, const struct float_box *boxes,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	size_t first = 0;

	for (unsigned way = 0; !status && way < OVERLAP_WAYS; way++) {
		overlaps->runs[way] = TCS_NONE;
		if (!counts[way])
			continue;
		overlaps->runs[way] = (uint32_t)overlaps->boxes.runs.count;
		status = face_boxes_add(&overlaps->boxes, places + first,
			boxes + first, counts[way], fault);
		first += counts[way];
	}
	return status;
}

static enum tcs_status
grow_boxes(struct overlaps *overlaps, const struct collapses *work,
	struct tcs_fault *fault)
{
	struct float_box *boxes = calloc(work->face_count + 1, sizeof *boxes);
	uint32_t *places = calloc(work->face_count + 1, sizeof *places);
	size_t counts[OVERLAP_WAYS] = {0};
	enum tcs_status status = TCS_OK;

	if (!boxes || !places)
		status = fault_memory(fault);
	if (!status) {
		list_faces(overlaps, work, counts);
		sort_boxes(overlaps, work, counts, places, boxes);
		status = add_ways(overlaps, counts, places, boxes, fault);
	}
	free(boxes);
	free(places);
	return status;
}

/* Nodes move back where a face would turn over. */
static void
move_nodes(struct overlaps *overlaps, struct collapses *work)
{
	for (size_t i = 0; i < overlaps->faces.count; i++) {
		struct plate plate;

		if (!load_plate(work, overlaps->faces.at[i].face, &plate))
			continue;
		for (int k = 0; k < 3; k++)
			plate.shape.corner[k] =
				vector_sum(plate.shape.corner[k],
					overlaps->shifts.at[plate.nodes[k]]);
		if (vector_dot(triangle_normal(&plate.shape), plate.normal) > 0)
			continue;
		for (int k = 0; k < 3; k++)
			overlaps->shifts.at[plate.nodes[k]] =
				(struct tcs_point){0, 0, 0};
	}
	for (size_t i = 0; i < overlaps->shifts.count; i++)
		work->positions.at[i] = vector_sum(
			work->positions.at[i], overlaps->shifts.at[i]);
	for (size_t i = 0; i < overlaps->faces.count; i++) {
		struct plate plate;

		if (!load_plate(work, overlaps->faces.at[i].face, &plate))
			continue;
		for (int k = 0; k < 3; k++)
			crossing_watch_follow(
				work, plate.face, plate.shape.corner[k]);
	}
}

enum tcs_status
overlaps_part(struct overlaps *overlaps, struct collapses *work,
	struct tcs_fault *fault)
{
	struct search search = {
		.overlaps = overlaps, .work = work, .fault = fault};
	enum tcs_status status = begin(overlaps, work, fault);

	if (status || work->set->components.count < 2)
		return status;
	status = grow_boxes(overlaps, work, fault);
	for (size_t i = 0; !status && i < overlaps->faces.count; i++) {
		uint32_t face = overlaps->faces.at[i].face;

		if (overlaps->changed.at[face] &&
			load_plate(work, face, &search.own))
			status = visit_near(&search);
	}
	if (!status && overlaps->parted > 0)
		move_nodes(overlaps, work);
	return status;
}

void
overlaps_release(struct overlaps *overlaps)
{
	array_release(&overlaps->faces);
	array_release(&overlaps->changed);
	face_boxes_release(&overlaps->boxes);
	array_release(&overlaps->near);
	array_release(&overlaps->shifts);
	triangle_tree_release(&overlaps->tree);
	array_release(&overlaps->roots);
}
