#include "seams.h"

#include <stdlib.h>

#include "vector.h"

/* Edges are lengthened by this share of their length for the test. */
#define BUFFER 0.01

/* Planes this parallel are one. */
#define SAME_PLANE 0.999

struct walk {
	struct seams *seams;
	const struct component_set *set;
	const struct sheets *sheets;
	double reach;
	bool failed; /* for want of memory */
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

static void
add_plane(struct walk *walk, uint32_t node, uint32_t component,
	const struct triangle_shape *other)
{
	struct seams *seams = walk->seams;

	if (array_grow(&seams->planes, 1)) {
		walk->failed = true;
		return;
	}
	seams->planes.at[seams->planes.count++] =
		(struct seam_plane){node, component, unit_normal(other)};
}

/*
 * An edge that lies in the other component between two parallel faces, the
 * diagonal of a quad: the corners across it are boundary vertices, too.
 */
static void
add_embedded(struct walk *walk, uint32_t face, int edge, uint32_t component,
	const struct triangle_shape *other)
{
	const struct sheets *sheets = walk->sheets;
	uint32_t back = sheets->opposites.at[3 * face + (uint32_t)edge];
	struct triangle_shape shapes[2];

	if (back == HALF_EDGE_NONE)
		return;
	shapes[0] =
		component_set_shape(walk->set, sheets->face_triangles.at[face]);
	shapes[1] = component_set_shape(
		walk->set, sheets->face_triangles.at[back / 3]);
	if (vector_dot(unit_normal(&shapes[0]), unit_normal(&shapes[1])) <
		SAME_PLANE)
		return;
	add_plane(walk, node_at(walk, face, (edge + 2) % 3), component, other);
	add_plane(walk, node_at(walk, back / 3, (int)(back + 2) % 3), component,
		other);
}

/* The edge of a face that pierces a triangle of another component: the end
   that lies inside is a boundary vertex. */
static void
judge_edge(struct walk *walk, uint32_t face, const struct triangle_shape *shape,
	int edge, uint32_t component, const struct triangle_shape *other)
{
	struct tcs_point from = shape->corner[edge];
	struct tcs_point to = shape->corner[(edge + 1) % 3];
	struct tcs_point along = vector_difference(to, from), at;
	struct tcs_point segment[2] = {vector_along(from, along, -BUFFER),
		vector_along(to, along, BUFFER)};
	bool tail;

	if (!triangle_pierced(other, segment, &at))
		return;
	tail = vector_dot(along, triangle_normal(other)) >= 0;
	add_plane(walk, node_at(walk, face, tail ? edge : (edge + 1) % 3),
		component, other);
	add_embedded(walk, face, edge, component, other);
}

/* ---- points of the seam -------------------------------------------------- */

static void
add_point(struct walk *walk, struct tcs_point at, double gap, uint32_t face_a,
	uint32_t face_b)
{
	struct seams *seams = walk->seams;

	if (array_grow(&seams->found, 1) ||
		array_grow(&seams->found_faces, 2)) {
		walk->failed = true;
		return;
	}
	seams->found.at[seams->found.count++] = (struct seam_point){
		.at = at, .limit = gap > SEAM_LIMIT ? gap : SEAM_LIMIT};
	seams->found_faces.at[seams->found_faces.count++] = face_a;
	seams->found_faces.at[seams->found_faces.count++] = face_b;
}

/* The corners of one triangle that are within reach of the other. */
static void
judge_corners(struct walk *walk, const uint32_t faces[2],
	const struct triangle_shape *const shapes[2], int side,
	uint32_t other_component)
{
	for (int k = 0; k < 3; k++) {
		struct tcs_point corner = shapes[side]->corner[k];
		struct tcs_point near =
			triangle_nearest(shapes[1 - side], corner);
		double gap = vector_length(vector_difference(corner, near));

		if (gap > walk->reach)
			continue;
		add_point(walk, corner, gap, faces[0], faces[1]);
		add_plane(walk, node_at(walk, faces[side], k), other_component,
			shapes[1 - side]);
	}
}

static bool
visit_pair(void *context, uint32_t left, uint32_t right)
{
	struct walk *walk = context;
	const struct component_set *set = walk->set;
	const struct triangle_tree *tree = &set->tree;
	const uint32_t triangles[2] = {
		tree->boxes.items.at[left], tree->boxes.items.at[right]};
	const struct triangle_shape *const shapes[2] = {
		&tree->shapes.at[left], &tree->shapes.at[right]};
	uint32_t faces[2];
	struct tcs_point points[2];
	double gap;

	for (int i = 0; i < 2; i++)
		faces[i] = walk->sheets->triangle_faces.at[triangles[i]];
	if (faces[0] == TCS_NONE || faces[1] == TCS_NONE)
		return true;
	gap = triangle_gap(shapes[0], shapes[1], points);
	if (gap > walk->reach)
		return true;
	add_point(walk, points[0], gap, faces[0], faces[1]);
	for (int i = 0; i < 2; i++) {
		uint32_t other = set->numbers.at[triangles[1 - i]];

		judge_corners(walk, faces, shapes, i, other);
		for (int k = 0; k < 3; k++)
			judge_edge(walk, faces[i], shapes[i], k, other,
				shapes[1 - i]);
	}
	return !walk->failed;
}

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

	array_clear(&walk->seams->found);
	array_clear(&walk->seams->found_faces);
	box_tree_pairs(&set->tree.boxes, set->components.at[contact->a].root,
		set->components.at[contact->b].root, walk->reach, visit_pair,
		walk);
	if (walk->failed)
		return fault_memory(fault);
	return keep_points(walk->seams, number, fault);
}

static int
by_node_and_component(const void *left, const void *right)
{
	const struct seam_plane *a = left, *b = right;
	int order;

	if (a->node != b->node)
		return a->node < b->node ? -1 : 1;
	if (a->component != b->component)
		return a->component < b->component ? -1 : 1;
	order = compare_numbers(a->normal.x, b->normal.x);
	if (!order)
		order = compare_numbers(a->normal.y, b->normal.y);
	return order ? order : compare_numbers(a->normal.z, b->normal.z);
}

static bool
is_known_plane(const struct seam_plane *planes, size_t first, size_t count,
	const struct seam_plane *plane)
{
	for (size_t i = count; i-- > first;)
		if (planes[i].component == plane->component &&
			fabs(vector_dot(planes[i].normal, plane->normal)) >
				SAME_PLANE)
			return true;
	return false;
}

/* Sort the planes by node, each direction of a component once. */
static enum tcs_status
sort_planes(struct walk *walk, struct tcs_fault *fault)
{
	struct seams *seams = walk->seams;
	struct seam_plane *planes = seams->planes.at;
	size_t nodes = walk->sheets->node_count, count = 0, i = 0;

	if (array_grow(&seams->nodes, nodes + 1))
		return fault_memory(fault);
	if (seams->planes.count > 0)
		qsort(planes, seams->planes.count, sizeof *planes,
			by_node_and_component);
	for (size_t node = 0; node < nodes; node++) {
		size_t first = count;

		seams->nodes.at[node] = (uint32_t)count;
		for (; i < seams->planes.count && planes[i].node == node; i++)
			if (!is_known_plane(planes, first, count, &planes[i]))
				planes[count++] = planes[i];
	}
	seams->nodes.at[nodes] = (uint32_t)count;
	seams->nodes.count = nodes + 1;
	seams->planes.count = count;
	return TCS_OK;
}

enum tcs_status
seams_find(struct seams *seams, const struct component_set *set,
	const struct sheets *sheets, const struct contact_list *contacts,
	double reach, struct tcs_fault *fault)
{
	struct walk walk = {seams, set, sheets, reach, false};
	size_t faces = sheets->face_triangles.count;
	enum tcs_status status = TCS_OK;

	array_clear(&seams->points);
	array_clear(&seams->holds);
	array_clear(&seams->faces);
	array_clear(&seams->counts);
	array_clear(&seams->planes);
	array_clear(&seams->nodes);
	if (array_grow(&seams->faces, faces) ||
		array_grow(&seams->counts, contacts->count))
		return fault_memory(fault);
	seams->faces.count = faces;
	for (size_t i = 0; i < faces; i++)
		seams->faces.at[i] = TCS_NONE;
	for (size_t i = 0; !status && i < contacts->count; i++) {
		seams->counts.at[seams->counts.count++] =
			(struct seam_count){0, 0};
		if (!contacts->at[i].inside)
			status = follow(
				&walk, &contacts->at[i], (uint32_t)i, fault);
	}
	if (!status)
		status = sort_planes(&walk, fault);
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
