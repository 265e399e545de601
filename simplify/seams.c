#include "seams.h"

#include <stdlib.h>

#include "vector.h"

/* Edges are lengthened by this share of their length for the test. */
#define BUFFER 0.01

/* Metres: what is this near touches in an object of any size. */
#define TOUCHING 0.01

/* Planes this parallel are one. */
#define SAME_PLANE 0.999

struct walk {
	struct seams *seams;
	const struct component_set *set;
	const struct sheets *sheets;
	double reach;
	bool failed; /* for want of memory */
};

/* A triangle of one component beside one of another. */
struct view {
	const struct triangle_shape *shape, *other;
	int side; /* 0: shape is of the contact's first component */
	uint32_t component; /* the other's */
	uint32_t faces[2]; /* of sides 0 and 1 */
	double heights[3]; /* of the corners over the other's plane */
};

static uint32_t
node_at(const struct walk *walk, uint32_t face, int corner)
{
	uint32_t vertex = walk->sheets->corners.at[3 * face + (uint32_t)corner];

	return walk->sheets->vertex_nodes.at[vertex];
}

static struct tcs_point
unit_normal(const struct triangle_shape *shape)
{
	struct tcs_point normal = triangle_normal(shape);
	double length = vector_length(normal);

	return length > 0 ? vector_scaled(normal, 1 / length) : normal;
}

/* ---- boundary vertices --------------------------------------------------- */

static bool
is_known_plane(const struct seams *seams, uint32_t node, uint32_t component,
	struct tcs_point normal)
{
	for (uint32_t i = seams->nodes.at[node]; i != TCS_NONE;
		i = seams->planes.at[i].next)
		if (seams->planes.at[i].component == component &&
			fabs(vector_dot(seams->planes.at[i].normal, normal)) >
				SAME_PLANE)
			return true;
	return false;
}

static void
add_plane(struct walk *walk, uint32_t node, uint32_t component,
	const struct triangle_shape *other)
{
	struct tcs_point normal = unit_normal(other);
	struct seams *seams = walk->seams;

	if (is_known_plane(seams, node, component, normal))
		return;
	if (array_grow(&seams->planes, 1)) {
		walk->failed = true;
		return;
	}
	seams->planes.at[seams->planes.count] =
		(struct seam_plane){seams->nodes.at[node], component, normal};
	seams->nodes.at[node] = (uint32_t)seams->planes.count++;
}

/*
 * An edge that lies in the other component between two parallel faces, the
 * diagonal of a quad: the corners across it are boundary vertices, too.
 */
static void
add_embedded(struct walk *walk, const struct view *view, int edge)
{
	const struct sheets *sheets = walk->sheets;
	uint32_t face = view->faces[view->side];
	uint32_t back = sheets->opposites.at[3 * face + (uint32_t)edge];
	struct triangle_shape beside;

	if (back == HALF_EDGE_NONE)
		return;
	beside = component_set_shape(
		walk->set, sheets->face_triangles.at[back / 3]);
	if (vector_dot(unit_normal(view->shape), unit_normal(&beside)) <
		SAME_PLANE)
		return;
	add_plane(walk, node_at(walk, face, (edge + 2) % 3), view->component,
		view->other);
	add_plane(walk, node_at(walk, back / 3, (int)(back + 2) % 3),
		view->component, view->other);
}

static void
add_point(struct walk *walk, struct tcs_point at, double gap,
	const uint32_t faces[2])
{
	struct seams *seams = walk->seams;

	if (array_grow(&seams->found, 1) ||
		array_grow(&seams->found_faces, 2)) {
		walk->failed = true;
		return;
	}
	seams->found.at[seams->found.count++] = (struct seam_point){.at = at,
		.limit = gap > TOUCHING
			? fmax(SEAM_LIMIT, SEAM_REACHES * walk->reach)
			: SEAM_LIMIT};
	seams->found_faces.at[seams->found_faces.count++] = faces[0];
	seams->found_faces.at[seams->found_faces.count++] = faces[1];
}

/* The edge of a face that pierces a triangle of another component: the end
   that lies inside is a boundary vertex. */
static void
judge_edge(struct walk *walk, const struct view *view, int edge)
{
	const struct triangle_shape *shape = view->shape;
	double from = view->heights[edge];
	double to = view->heights[(edge + 1) % 3];
	double more = BUFFER * (to - from);
	struct tcs_point along = vector_difference(
		shape->corner[(edge + 1) % 3], shape->corner[edge]);
	struct tcs_point at,
		segment[2] = {vector_along(shape->corner[edge], along, -BUFFER),
			vector_along(
				shape->corner[(edge + 1) % 3], along, BUFFER)};
	bool tail = to >= from;

	if ((from - more < 0) == (to + more < 0) ||
		!triangle_pierced(view->other, segment, &at))
		return;
	add_point(walk, at, 0, view->faces);
	add_plane(walk,
		node_at(walk, view->faces[view->side],
			tail ? edge : (edge + 1) % 3),
		view->component, view->other);
	add_embedded(walk, view, edge);
}

/* The corners of one triangle that are within reach of the other. */
static void
judge_corner(struct walk *walk, const struct view *view, int corner)
{
	struct tcs_point at = view->shape->corner[corner];
	double gap;

	if (fabs(view->heights[corner]) > walk->reach)
		return;
	gap = vector_length(
		vector_difference(at, triangle_nearest(view->other, at)));
	if (gap > walk->reach)
		return;
	add_point(walk, at, gap, view->faces);
	add_plane(walk, node_at(walk, view->faces[view->side], corner),
		view->component, view->other);
}

static double
least(const double a[3])
{
	double low = a[0] < a[1] ? a[0] : a[1];

	return low < a[2] ? low : a[2];
}

static double
most(const double a[3])
{
	double high = a[0] > a[1] ? a[0] : a[1];

	return high > a[2] ? high : a[2];
}

/* A triangle as seen from the other; false when it is out of reach. */
static bool
look_at(const struct walk *walk, struct view *view)
{
	struct tcs_point normal = unit_normal(view->other);
	double low, high;

	for (int k = 0; k < 3; k++)
		view->heights[k] = vector_dot(normal,
			vector_difference(view->shape->corner[k],
				view->other->corner[0]));
	low = least(view->heights);
	high = most(view->heights);
	/* Longer by the buffer, on either side. */
	return low - BUFFER * (high - low) <= walk->reach &&
		high + BUFFER * (high - low) >= -walk->reach;
}

static bool
is_beside(const double a[3], const double b[3], double reach)
{
	return least(a) - most(b) > reach || least(b) - most(a) > reach;
}

/* Whether the boxes of two triangles are farther apart than `reach`. */
static bool
are_far(const struct triangle_shape *a, const struct triangle_shape *b,
	double reach)
{
	const struct tcs_point *p = a->corner, *q = b->corner;

	return is_beside((double[3]){p[0].x, p[1].x, p[2].x},
		       (double[3]){q[0].x, q[1].x, q[2].x}, reach) ||
		is_beside((double[3]){p[0].y, p[1].y, p[2].y},
			(double[3]){q[0].y, q[1].y, q[2].y}, reach) ||
		is_beside((double[3]){p[0].z, p[1].z, p[2].z},
			(double[3]){q[0].z, q[1].z, q[2].z}, reach);
}

/* The two triangles of a pair, each as seen from the other. */
static bool
make_views(const struct walk *walk, uint32_t left, uint32_t right,
	struct view views[2])
{
	const struct triangle_tree *tree = &walk->set->tree;
	const uint32_t places[2] = {left, right};
	uint32_t faces[2];

	if (are_far(&tree->shapes.at[left], &tree->shapes.at[right],
		    walk->reach))
		return false;
	for (int i = 0; i < 2; i++)
		faces[i] = walk->sheets->triangle_faces
				   .at[tree->boxes.items.at[places[i]]];
	if (faces[0] == TCS_NONE || faces[1] == TCS_NONE)
		return false;
	for (int i = 0; i < 2; i++) {
		uint32_t other = tree->boxes.items.at[places[1 - i]];

		views[i] = (struct view){
			.shape = &tree->shapes.at[places[i]],
			.other = &tree->shapes.at[places[1 - i]],
			.side = i,
			.component = walk->set->numbers.at[other],
			.faces = {faces[0], faces[1]},
		};
		if (!look_at(walk, &views[i]))
			return false;
	}
	return true;
}

static bool
visit_pair(void *context, uint32_t left, uint32_t right)
{
	struct walk *walk = context;
	struct view views[2];

	if (!make_views(walk, left, right, views))
		return true;
	for (int i = 0; i < 2; i++)
		for (int k = 0; k < 3; k++) {
			judge_corner(walk, &views[i], k);
			judge_edge(walk, &views[i], k);
		}
	return !walk->failed;
}

/* Where no corner is in reach and no edge pierces, edges are near edges. */
static bool
visit_edges(void *context, uint32_t left, uint32_t right)
{
	struct walk *walk = context;
	struct view views[2];
	struct tcs_point points[2];
	double gap;

	if (!make_views(walk, left, right, views))
		return true;
	gap = triangle_gap(views[0].shape, views[1].shape, points);
	if (gap <= walk->reach)
		add_point(walk, points[0], gap, views[0].faces);
	return !walk->failed;
}

/* ---- the points that are watched ------------------------------------------ */

struct place {
	struct tcs_point at;
	uint32_t index;
};

static int
compare_numbers(double a, double b)
{
	return (a > b) - (a < b);
}

static int
by_place(const void *left, const void *right)
{
	const struct place *a = left, *b = right;
	int order = compare_numbers(a->at.x, b->at.x);

	if (!order)
		order = compare_numbers(a->at.y, b->at.y);
	if (!order)
		order = compare_numbers(a->at.z, b->at.z);
	return order ? order : (a->index > b->index) - (a->index < b->index);
}

static bool
is_same_place(struct tcs_point a, struct tcs_point b)
{
	return !(compare_numbers(a.x, b.x) || compare_numbers(a.y, b.y) ||
		compare_numbers(a.z, b.z));
}

static enum tcs_status
keep_point(struct seams *seams, uint32_t found, uint32_t contact,
	struct tcs_fault *fault)
{
	if (array_grow(&seams->points, 1) || array_grow(&seams->holds, 2))
		return fault_memory(fault);
	seams->points.at[seams->points.count] = seams->found.at[found];
	seams->points.at[seams->points.count++].contact = contact;
	seams->counts.at[contact].points++;
	for (uint32_t side = 0; side < 2; side++) {
		uint32_t hold = (uint32_t)seams->holds.count++;

		seams->holds.at[hold].face = TCS_NONE;
		seams_move_hold(
			seams, hold, seams->found_faces.at[2 * found + side]);
	}
	return TCS_OK;
}

/* Of the places found, each once, those that are spread evenly. */
static enum tcs_status
keep_points(struct seams *seams, uint32_t contact, struct tcs_fault *fault)
{
	size_t count = seams->found.count, kept = 0;
	struct place *places = calloc(count + 1, sizeof *places);
	enum tcs_status status = TCS_OK;
	size_t wanted;

	if (!places)
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++)
		places[i] = (struct place){seams->found.at[i].at, (uint32_t)i};
	if (count > 0)
		qsort(places, count, sizeof *places, by_place);
	for (size_t i = 0; i < count; i++)
		if (!i || !is_same_place(places[i].at, places[kept - 1].at))
			places[kept++] = places[i];
	wanted = kept < SEAM_POINTS ? kept : SEAM_POINTS;
	for (size_t i = 0; !status && i < wanted; i++)
		status = keep_point(seams,
			places[wanted < kept ? i * (kept - 1) / (wanted - 1)
					     : i]
				.index,
			contact, fault);
	free(places);
	return status;
}

/* ---- all contacts -------------------------------------------------------- */

static enum tcs_status
follow(struct walk *walk, const struct contact *contact, uint32_t number,
	struct tcs_fault *fault)
{
	const struct component_set *set = walk->set;
	uint32_t a = set->components.at[contact->a].root;
	uint32_t b = set->components.at[contact->b].root;

	array_clear(&walk->seams->found);
	array_clear(&walk->seams->found_faces);
	box_tree_pairs(&set->tree.boxes, a, b, walk->reach, visit_pair, walk);
	if (!walk->failed && !walk->seams->found.count)
		box_tree_pairs(
			&set->tree.boxes, a, b, walk->reach, visit_edges, walk);
	if (walk->failed)
		return fault_memory(fault);
	return keep_points(walk->seams, number, fault);
}

static enum tcs_status
clear(struct seams *seams, size_t faces, size_t nodes, size_t contacts,
	struct tcs_fault *fault)
{
	array_clear(&seams->points);
	array_clear(&seams->holds);
	array_clear(&seams->faces);
	array_clear(&seams->counts);
	array_clear(&seams->planes);
	array_clear(&seams->nodes);
	if (array_grow(&seams->faces, faces) ||
		array_grow(&seams->nodes, nodes) ||
		array_grow(&seams->counts, contacts))
		return fault_memory(fault);
	seams->faces.count = faces;
	for (size_t i = 0; i < faces; i++)
		seams->faces.at[i] = TCS_NONE;
	seams->nodes.count = nodes;
	for (size_t i = 0; i < nodes; i++)
		seams->nodes.at[i] = TCS_NONE;
	return TCS_OK;
}

enum tcs_status
seams_find(struct seams *seams, const struct component_set *set,
	const struct sheets *sheets, const struct contact_list *contacts,
	double reach, struct tcs_fault *fault)
{
	struct walk walk = {seams, set, sheets, reach, false};
	enum tcs_status status = clear(seams, sheets->face_triangles.count,
		sheets->node_count, contacts->count, fault);

	for (size_t i = 0; !status && i < contacts->count; i++) {
		seams->counts.at[seams->counts.count++] =
			(struct seam_count){0, 0};
		if (!contacts->at[i].inside)
			status = follow(
				&walk, &contacts->at[i], (uint32_t)i, fault);
	}
	return status;
}

/* ---- holding ------------------------------------------------------------- */

static void
let_go(struct seams *seams, uint32_t hold)
{
	uint32_t *link = &seams->faces.at[seams->holds.at[hold].face];

	while (*link != hold)
		link = &seams->holds.at[*link].next;
	*link = seams->holds.at[hold].next;
}

void
seams_move_hold(struct seams *seams, uint32_t hold, uint32_t face)
{
	struct seam_hold *moved = &seams->holds.at[hold];

	if (moved->face != TCS_NONE)
		let_go(seams, hold);
	moved->face = face;
	moved->next = TCS_NONE;
	if (face != TCS_NONE) {
		moved->next = seams->faces.at[face];
		seams->faces.at[face] = hold;
	}
}

void
seams_open(struct seams *seams, uint32_t point)
{
	seams_move_hold(seams, 2 * point, TCS_NONE);
	seams_move_hold(seams, 2 * point + 1, TCS_NONE);
	seams->counts.at[seams->points.at[point].contact].open++;
}

void
seams_release(struct seams *seams)
{
	array_release(&seams->points);
	array_release(&seams->holds);
	array_release(&seams->faces);
	array_release(&seams->counts);
	array_release(&seams->planes);
	array_release(&seams->nodes);
	array_release(&seams->found);
	array_release(&seams->found_faces);
}
