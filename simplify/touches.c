#include "touches.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "enclosure.h"
#include "vector.h"

/* Edges are lengthened by this share of their length for the test. */
#define BUFFER 0.01

/* Planes this parallel are one. */
#define SAME_PLANE 0.999

/* Metres: places this near to each other are one. */
#define SAME_PLACE 0.001

/* One component looking at the other. */
struct look {
	const struct touch_scene *scene;
	struct touches *touches;
	uint32_t components[2]; /* a and b */
	int side; /* the one whose vertices and edges are asked */
	size_t first_plane; /* of this pair */
	bool touching;
	struct tcs_fault *fault;
};

/* An edge, as its face winds: from corner k to the next. */
struct edge {
	uint32_t face, k;
	struct tcs_point from, to;
};

/* ---- the mesh ------------------------------------------------------------ */

enum tcs_status
touch_faces_fill(struct touch_face *faces, const struct component_set *set,
	const struct sheets *sheets, struct tcs_fault *fault)
{
	bool *seen = calloc(sheets->node_count + 1, sizeof *seen);

	if (!seen)
		return fault_memory(fault);
	for (uint32_t i = 0; i < sheets->corners.count; i++) {
		struct touch_face *face = &faces[i / 3];
		uint32_t node = sheets->vertex_nodes.at[sheets->corners.at[i]];
		uint32_t back = sheets->opposites.at[i], k = i % 3;

		if (k == 0)
			*face = (struct touch_face){
				.shape = component_set_shape(
					set, sheets->face_triangles.at[i / 3])};
		face->nodes[k] = node;
		if (!seen[node])
			face->asks |= (uint32_t)TOUCH_VERTEX << k;
		if (back == HALF_EDGE_NONE || i < back)
			face->asks |= (uint32_t)TOUCH_EDGE << k;
		seen[node] = true;
	}
	free(seen);
	return TCS_OK;
}

static const struct touch_face *
face_at(const struct look *look, uint32_t face)
{
	return &look->scene->faces[face];
}

static uint32_t
next_of(uint32_t k)
{
	return k < 2 ? k + 1 : 0;
}

static struct edge
edge_at(const struct look *look, uint32_t face, uint32_t k)
{
	const struct tcs_point *corners = face_at(look, face)->shape.corner;

	return (struct edge){face, k, corners[k], corners[next_of(k)]};
}

/* How far a point is above the plane of a face; 0 if it has none. */
static double
height_over(const struct look *look, uint32_t face, struct tcs_point point)
{
	return vector_dot(look->scene->sheets->normals.at[face],
		vector_difference(point, face_at(look, face)->shape.corner[0]));
}

/* ---- what is found ------------------------------------------------------- */

/* A place, `offs` metres from a face of the side that is asked and from one of
   the other. */
static enum tcs_status
add_place(struct look *look, struct tcs_point at, const uint32_t faces[2],
	const double offs[2])
{
	struct touches *touches = look->touches;
	int own = look->side, other = 1 - own;

	if (array_grow(&touches->places, 1))
		return fault_memory(look->fault);
	touches->places.at[touches->places.count++] =
		(struct touch){at, offs[1], {faces[own], faces[other]},
			{rounded_up(offs[own]), rounded_up(offs[other])}};
	return TCS_OK;
}

/* The planes of one vertex that are added in a row differ. */
static bool
is_last_plane(const struct look *look, uint32_t node, uint32_t face)
{
	const struct touches *touches = look->touches;
	const struct tcs_point *normals = look->scene->sheets->normals.at;

	for (size_t i = touches->planes.count;
		i > look->first_plane && touches->planes.at[i - 1].node == node;
		i--)
		if (fabs(vector_dot(normals[touches->planes.at[i - 1].face],
			    normals[face])) > SAME_PLANE)
			return true;
	return false;
}

static enum tcs_status
add_plane(struct look *look, uint32_t node, uint32_t face)
{
	struct touches *touches = look->touches;

	if (is_last_plane(look, node, face))
		return TCS_OK;
	if (array_grow(&touches->planes, 1))
		return fault_memory(look->fault);
	touches->planes.at[touches->planes.count++] = (struct touch_plane){
		node, look->components[1 - look->side], face};
	return TCS_OK;
}

static enum tcs_status
list_near(struct look *look, const struct float_box *box, struct face_list *out)
{
	return face_extract_near(&look->touches->extracts[1 - look->side], box,
		out, look->fault);
}

/* ---- vertices ------------------------------------------------------------ */

static bool
has_met(const struct look *look, uint32_t node)
{
	return look->touches->met.at[node / 32] >> node % 32 & 1;
}

static void
set_met(struct touches *touches, uint32_t node, bool met)
{
	uint32_t bit = (uint32_t)1 << node % 32;

	if (met)
		touches->met.at[node / 32] |= bit;
	else
		touches->met.at[node / 32] &= ~bit;
}

/* No vertex has met anything yet. */
static enum tcs_status
clear_met(struct look *look)
{
	struct touches *touches = look->touches;
	size_t words = look->scene->sheets->node_count / 32 + 1;

	if (touches->met.count >= words)
		return TCS_OK;
	if (array_grow(&touches->met, words - touches->met.count))
		return fault_memory(look->fault);
	memset(touches->met.at, 0, words * sizeof *touches->met.at);
	touches->met.count = words;
	return TCS_OK;
}

/* All that have met something have planes. */
static void
forget_met(struct touches *touches, size_t first_plane)
{
	for (size_t i = first_plane; i < touches->planes.count; i++)
		set_met(touches, touches->planes.at[i].node, false);
}

static enum tcs_status
ask_vertex(struct look *look, uint32_t own, uint32_t k)
{
	double reach = look->scene->reach, least = INFINITY;
	struct tcs_point at = face_at(look, own)->shape.corner[k];
	uint32_t node = face_at(look, own)->nodes[k], nearest = TCS_NONE;
	struct float_box box = float_box_around(at, at, reach);
	const struct face_list *there = &look->touches->there;
	enum tcs_status status = list_near(look, &box, &look->touches->there);

	for (size_t i = 0; !status && i < there->count; i++) {
		uint32_t face = there->at[i];
		double gap;

		if (fabs(height_over(look, face, at)) > reach)
			continue;
		gap = vector_length(vector_difference(at,
			triangle_nearest_along(&face_at(look, face)->shape,
				look->scene->sheets->normals.at[face], at)));
		if (gap > reach)
			continue;
		if (gap < least) {
			least = gap;
			nearest = face;
		}
		status = add_plane(look, node, face);
	}
	if (status || nearest == TCS_NONE)
		return status;
	look->touching = true;
	set_met(look->touches, node, true);
	return add_place(
		look, at, (uint32_t[]){own, nearest}, (double[]){0, least});
}

/* ---- edges that pierce --------------------------------------------------- */

/* The corner opposite to an edge, if it lies in the other component, too:
   behind the face that the edge passes through, or on its plane. */
static enum tcs_status
add_opposite(struct look *look, uint32_t corner, uint32_t other)
{
	const struct touch_face *face = face_at(look, corner / 3);
	uint32_t apex = (corner + 2) % 3;

	return height_over(look, other, face->shape.corner[apex]) >
			look->scene->reach
		? TCS_OK
		: add_plane(look, face->nodes[apex], other);
}

/*
 * An edge that lies in the other component between two parallel faces, the
 * diagonal of a quad: the corners across it are boundary vertices, too, where
 * they are embedded as it is. The upper ends of a column that rests on a slab
 * are not, though diagonals of its sides end there.
 */
static enum tcs_status
add_embedded(struct look *look, uint32_t corner, uint32_t other)
{
	uint32_t back = look->scene->sheets->opposites.at[corner];
	const struct tcs_point *normals = look->scene->sheets->normals.at;
	enum tcs_status status;

	if (back == HALF_EDGE_NONE ||
		vector_dot(normals[corner / 3], normals[back / 3]) < SAME_PLANE)
		return TCS_OK;
	status = add_opposite(look, corner, other);
	return status ? status : add_opposite(look, back, other);
}

/* The box around an edge, lengthened. */
static struct float_box
box_around_edge(const struct edge *edge)
{
	struct tcs_point along = vector_difference(edge->to, edge->from);

	return float_box_around(vector_along(edge->from, along, -BUFFER),
		vector_along(edge->to, along, BUFFER), 0);
}

/* How far a place is off the edge, `t` of its length from where it begins. */
static double
off_edge(const struct edge *edge, double t)
{
	double beyond = t < 0 ? -t : t > 1 ? t - 1 : 0;

	return beyond * vector_length(vector_difference(edge->to, edge->from));
}

/* Where a lengthened edge passes through a face: the end that lies inside is a
   boundary vertex. */
static enum tcs_status
pierce(struct look *look, const struct edge *edge, uint32_t face)
{
	const struct triangle_shape *shape = &face_at(look, face)->shape;
	struct tcs_point normal = look->scene->sheets->normals.at[face];
	double base = vector_dot(normal, shape->corner[0]);
	double from = vector_dot(normal, edge->from) - base;
	double to = vector_dot(normal, edge->to) - base;
	double more = BUFFER * (to - from), t;
	uint32_t inside = to >= from ? edge->k : next_of(edge->k);
	enum tcs_status status;
	struct tcs_point at;

	if ((from - more < 0) == (to + more < 0))
		return TCS_OK;
	t = from / (from - to);
	at = vector_along(
		edge->from, vector_difference(edge->to, edge->from), t);
	if (!triangle_is_above(shape, normal, at))
		return TCS_OK;
	look->touching |= (from < 0) != (to < 0);
	status = add_place(look, at, (uint32_t[]){edge->face, face},
		(double[]){off_edge(edge, t), 0});
	if (!status)
		status = add_plane(
			look, face_at(look, edge->face)->nodes[inside], face);
	return status ? status
		      : add_embedded(look, 3 * edge->face + edge->k, face);
}

static enum tcs_status
ask_edge(struct look *look, const struct edge *edge)
{
	const struct face_list *there = &look->touches->there;
	const uint32_t *nodes = face_at(look, edge->face)->nodes;
	struct float_box box;
	enum tcs_status status;

	if (has_met(look, nodes[edge->k]) &&
		has_met(look, nodes[next_of(edge->k)]))
		return TCS_OK;
	box = box_around_edge(edge);
	status = list_near(look, &box, &look->touches->there);
	for (size_t i = 0; !status && i < there->count; i++)
		status = pierce(look, edge, there->at[i]);
	return status;
}

/* ---- edges near edges ---------------------------------------------------- */

static bool
range_meets(double a, double b, float low, float high)
{
	double least = a < b ? a : b, most = a < b ? b : a;

	return least <= (double)high && most >= (double)low;
}

/* Whether the box around an edge meets another. */
static bool
edge_is_near(const struct edge *edge, const struct float_box *box)
{
	return range_meets(
		       edge->from.x, edge->to.x, box->low[0], box->high[0]) &&
		range_meets(
			edge->from.y, edge->to.y, box->low[1], box->high[1]) &&
		range_meets(
			edge->from.z, edge->to.z, box->low[2], box->high[2]);
}

/* An edge with those of a face; `box` is around all that is in its reach. */
static enum tcs_status
compare_edges(struct look *look, const struct edge *edge,
	const struct float_box *box, uint32_t face)
{
	uint32_t asks = face_at(look, face)->asks;
	double reach = look->scene->reach;
	enum tcs_status status = TCS_OK;

	for (uint32_t k = 0; !status && k < 3; k++) {
		struct edge other = edge_at(look, face, k);
		struct tcs_point points[2];
		double gap;

		if (!(asks >> k & TOUCH_EDGE) || !edge_is_near(&other, box))
			continue;
		gap = segment_gap((struct tcs_point[]){edge->from, edge->to},
			(struct tcs_point[]){other.from, other.to}, points);
		if (gap > reach)
			continue;
		look->touching = true;
		status = add_place(look, points[0],
			(uint32_t[]){edge->face, face}, (double[]){0, gap});
	}
	return status;
}

static enum tcs_status
ask_near_edges(struct look *look, const struct edge *edge)
{
	struct float_box box =
		float_box_around(edge->from, edge->to, look->scene->reach);
	const struct face_list *there = &look->touches->there;
	enum tcs_status status = list_near(look, &box, &look->touches->there);

	for (size_t i = 0; !status && i < there->count; i++)
		status = compare_edges(look, edge, &box, there->at[i]);
	return status;
}

/* ---- one side ------------------------------------------------------------ */

static struct float_box
box_around_component(const struct look *look, uint32_t component)
{
	const struct box *box = &look->scene->set->components.at[component].box;

	return float_box_around(
		(struct tcs_point){box->low[0], box->low[1], box->low[2]},
		(struct tcs_point){box->high[0], box->high[1], box->high[2]},
		look->scene->reach);
}

typedef enum tcs_status ask(struct look *look, const struct edge *edge);

/* Every edge of the faces listed whose box meets that of the other side. */
static enum tcs_status
ask_edges(struct look *look, const struct float_box *other, ask *ask_one)
{
	const struct face_list *near = &look->touches->near;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < near->count; i++) {
		uint32_t asks = face_at(look, near->at[i])->asks;

		for (uint32_t k = 0; !status && k < 3; k++) {
			struct edge edge;

			if (!(asks >> k & TOUCH_EDGE))
				continue;
			edge = edge_at(look, near->at[i], k);
			if (edge_is_near(&edge, other))
				status = ask_one(look, &edge);
		}
	}
	return status;
}

static enum tcs_status
ask_vertices(struct look *look, const struct float_box *other)
{
	const struct face_list *near = &look->touches->near;
	enum tcs_status status = TCS_OK;

	for (size_t i = 0; i < near->count; i++) {
		const struct touch_face *face = face_at(look, near->at[i]);

		for (uint32_t k = 0; !status && k < 3; k++)
			if (face->asks >> k & TOUCH_VERTEX &&
				float_box_holds(other, face->shape.corner[k]))
				status = ask_vertex(look, near->at[i], k);
	}
	return status;
}

/* List the faces of the side that are near the other's box. */
static enum tcs_status
list_own(struct look *look, struct float_box *other)
{
	*other = box_around_component(look, look->components[1 - look->side]);
	return face_extract_near(&look->touches->extracts[look->side], other,
		&look->touches->near, look->fault);
}

static enum tcs_status
look_across(struct look *look)
{
	struct float_box other;
	enum tcs_status status = list_own(look, &other);

	if (!status)
		status = ask_vertices(look, &other);
	return status ? status : ask_edges(look, &other, ask_edge);
}

/* ---- one inside the other ------------------------------------------------ */

/* Surfaces that do not touch: one of the inner one's points tells where all
   of it lies. */
static enum tcs_status
look_inside(struct look *look, int outer, struct contact *contact)
{
	const struct touch_scene *scene = look->scene;
	uint32_t shell = look->components[outer];
	const struct component *inner =
		&scene->set->components.at[look->components[1 - outer]];
	bool encloses = false;
	enum tcs_status status = TCS_OK;

	contact->at = component_set_shape(
		scene->set, scene->set->order.at[inner->first])
			      .corner[0];
	if (scene->set->components.at[shell].closed &&
		!(box_distance_squared(&scene->set->components.at[shell].box,
			  contact->at) > 0))
		status = component_encloses(scene->set, scene->sheets,
			scene->boxes, shell, contact->at, &look->touches->there,
			&encloses, look->fault);
	contact->inside = encloses;
	return status;
}

/* ---- the places that are kept -------------------------------------------- */

static bool
is_same_place(struct tcs_point a, struct tcs_point b)
{
	return fabs(a.x - b.x) <= SAME_PLACE && fabs(a.y - b.y) <= SAME_PLACE &&
		fabs(a.z - b.z) <= SAME_PLACE;
}

static int
compare_numbers(double a, double b)
{
	return (a > b) - (a < b);
}

static int
by_place(const void *left, const void *right)
{
	const struct touch *a = left, *b = right;
	int order = compare_numbers(a->at.x, b->at.x);

	if (!order)
		order = compare_numbers(a->at.y, b->at.y);
	if (!order)
		order = compare_numbers(a->at.z, b->at.z);
	if (!order)
		order = compare_numbers(a->faces[0], b->faces[0]);
	return order ? order : compare_numbers(a->faces[1], b->faces[1]);
}

/* Each place once, as far as the last few found tell. */
static size_t
drop_repeated(struct touch *places, size_t count)
{
	size_t kept = 0;

	for (size_t i = 0; i < count; i++) {
		size_t k = kept > TOUCH_PLACES ? kept - TOUCH_PLACES : 0;

		while (k < kept && !is_same_place(places[k].at, places[i].at))
			k++;
		if (k == kept)
			places[kept++] = places[i];
	}
	return kept;
}

/* Of many those that are spread evenly. */
static void
thin_out(struct touches *touches, size_t first)
{
	struct touch *places = touches->places.at + first;
	size_t count = touches->places.count - first;

	if (count > TOUCH_PLACES)
		qsort(places, count, sizeof *places, by_place);
	count = drop_repeated(places, count);
	if (count > TOUCH_PLACES) {
		for (size_t i = 0; i < TOUCH_PLACES; i++)
			places[i] =
				places[i * (count - 1) / (TOUCH_PLACES - 1)];
		count = TOUCH_PLACES;
	}
	touches->places.count = first + count;
}

/* ---- two components ------------------------------------------------------ */

/* Extract the faces of either side that anything will be asked of: those near
   the other's box, grown by as much as its edges are lengthened. */
static enum tcs_status
extract_near(struct look *look)
{
	enum tcs_status status = TCS_OK;

	for (int side = 0; !status && side < 2; side++) {
		struct box box = look->scene->set->components
					 .at[look->components[1 - side]]
					 .box;
		struct float_box wide;

		for (int i = 0; i < 3; i++) {
			double more = BUFFER * (box.high[i] - box.low[i]);

			box.low[i] -= more;
			box.high[i] += more;
		}
		wide = float_box_around(
			(struct tcs_point){box.low[0], box.low[1], box.low[2]},
			(struct tcs_point){
				box.high[0], box.high[1], box.high[2]},
			look->scene->reach);
		status = face_extract_fill(&look->touches->extracts[side],
			look->scene->boxes, look->components[side], &wide,
			look->fault);
	}
	return status;
}

/* No vertex is in reach, no edge pierces. */
static enum tcs_status
compare_all_edges(struct look *look)
{
	struct float_box other;
	enum tcs_status status;

	look->side = 0;
	status = list_own(look, &other);
	return status ? status : ask_edges(look, &other, ask_near_edges);
}

static enum tcs_status
add_contact(struct touches *touches, const struct contact *contact,
	struct tcs_fault *fault)
{
	if (array_grow(&touches->contacts, 1) || array_grow(&touches->ends, 1))
		return fault_memory(fault);
	touches->contacts.at[touches->contacts.count++] = *contact;
	touches->ends.at[touches->ends.count++] =
		(uint32_t)touches->places.count;
	return TCS_OK;
}

enum tcs_status
touches_add(struct touches *touches, const struct touch_scene *scene,
	uint32_t a, uint32_t b, struct tcs_fault *fault)
{
	struct look look = {.scene = scene,
		.touches = touches,
		.components = {a, b},
		.first_plane = touches->planes.count,
		.fault = fault};
	size_t places = touches->places.count;
	struct contact contact = {.a = a, .b = b};
	enum tcs_status status = clear_met(&look);

	if (!status)
		status = extract_near(&look);
	for (; !status && look.side < 2; look.side++)
		status = look_across(&look);
	if (!status && !look.touching)
		status = compare_all_edges(&look);
	if (status)
		return status;
	forget_met(touches, look.first_plane);
	if (look.touching) {
		contact.at = touches->places.at[places].at;
		thin_out(touches, places);
		return add_contact(touches, &contact, fault);
	}
	touches->places.count = places;
	touches->planes.count = look.first_plane;
	for (int outer = 0; !status && !contact.inside && outer < 2; outer++)
		status = look_inside(&look, outer, &contact);
	if (!status && contact.inside)
		status = add_contact(touches, &contact, fault);
	return status;
}

void
touches_clear(struct touches *touches)
{
	array_clear(&touches->contacts);
	array_clear(&touches->ends);
	array_clear(&touches->places);
	array_clear(&touches->planes);
}

void
touches_release(struct touches *touches)
{
	array_release(&touches->contacts);
	array_release(&touches->ends);
	array_release(&touches->places);
	array_release(&touches->planes);
	array_release(&touches->met);
	array_release(&touches->near);
	array_release(&touches->there);
	for (int i = 0; i < 2; i++)
		face_extract_release(&touches->extracts[i]);
}
