#include "sheets.h"

#include <math.h>
#include <stdlib.h>

#include "forest.h"
#include "vector.h"

/* One face's use of an edge that more than two use. */
struct wing {
	double turn; /* radians around the edge, from low to high */
	uint32_t component, corner, forward;
};

struct split {
	const struct component_set *set;
	struct sheets *sheets;
	uint32_t *parents; /* per corner: of the forest of fans */
	TCS_ARRAY(struct wing) wings;
};

/* ---- edges --------------------------------------------------------------- */

static uint32_t
next_corner(uint32_t corner)
{
	return corner % 3 == 2 ? corner - 2 : corner + 1;
}

static void
join_edge(struct split *split, uint32_t a, uint32_t b)
{
	split->sheets->opposites.at[a] = b;
	split->sheets->opposites.at[b] = a;
	forest_join(split->parents, a, next_corner(b));
	forest_join(split->parents, next_corner(a), b);
}

/* The corner of a face from which it uses an edge. */
static uint32_t
corner_of(const struct split *split, const struct edge_use *use)
{
	const uint32_t *points = split->set->triangles.at[use->triangle].corner;
	uint32_t from = use->forward ? use->low : use->high;
	uint32_t first = 3 * split->sheets->triangle_faces.at[use->triangle];

	for (uint32_t k = 0; k < 2; k++)
		if (points[k] == from)
			return first + k;
	return first + 2;
}

/* The angle of a face around its edge, between any two directions across. */
static double
turn_of(const struct split *split, const struct edge_use *use,
	const struct tcs_point across[2])
{
	const struct tcs_point *points = split->set->points.at;
	const uint32_t *corner = split->set->triangles.at[use->triangle].corner;
	uint32_t apex = corner[0];
	struct tcs_point arm;

	for (int k = 1; k < 3; k++)
		if (apex == use->low || apex == use->high)
			apex = corner[k];
	arm = vector_difference(points[apex], points[use->low]);
	return atan2(vector_dot(arm, across[1]), vector_dot(arm, across[0]));
}

static int
by_component_and_turn(const void *left, const void *right)
{
	const struct wing *a = left, *b = right;

	if (a->component != b->component)
		return a->component < b->component ? -1 : 1;
	if (a->turn < b->turn || a->turn > b->turn)
		return a->turn < b->turn ? -1 : 1;
	/* At the same angle the material comes to its end before it begins
	   again. */
	if (a->forward != b->forward)
		return a->forward ? -1 : 1;
	return (a->corner > b->corner) - (a->corner < b->corner);
}

/* Two directions across an edge, the second a quarter turn on. */
static void
find_across(struct tcs_point along, struct tcs_point across[2])
{
	struct tcs_point least = {1, 0, 0};

	if (fabs(along.y) <= fabs(along.x) && fabs(along.y) <= fabs(along.z))
		least = (struct tcs_point){0, 1, 0};
	else if (fabs(along.z) <= fabs(along.x))
		least = (struct tcs_point){0, 0, 1};
	across[0] = vector_cross(along, least);
	across[1] = vector_cross(along, across[0]);
	across[0] = vector_scaled(across[0], vector_length(along));
}

/*
 * Seen along the edge, the material of a backward face begins at it
 * counterclockwise and ends at the next forward one.
 */
static void
pair_wings(struct split *split, const struct wing *wings, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		const struct wing *ahead = &wings[(i + 1) % count];

		if (!wings[i].forward && ahead->forward)
			join_edge(split, wings[i].corner, ahead->corner);
	}
}

static enum tcs_status
join_crowd(struct split *split, const struct edge_use *uses, size_t count,
	struct tcs_fault *fault)
{
	const struct tcs_point *points = split->set->points.at;
	struct tcs_point across[2];
	size_t run;

	split->wings.count = 0;
	if (array_grow(&split->wings, count))
		return fault_memory(fault);
	find_across(vector_difference(points[uses->high], points[uses->low]),
		across);
	for (size_t i = 0; i < count; i++)
		split->wings.at[split->wings.count++] =
			(struct wing){turn_of(split, &uses[i], across),
				split->set->numbers.at[uses[i].triangle],
				corner_of(split, &uses[i]), uses[i].forward};
	qsort(split->wings.at, count, sizeof *split->wings.at,
		by_component_and_turn);
	for (size_t i = 0; i < count; i += run) {
		const struct wing *wings = &split->wings.at[i];

		for (run = 1; i + run < count &&
			wings[run].component == wings->component;
			run++)
			;
		pair_wings(split, wings, run);
	}
	return TCS_OK;
}

static enum tcs_status
join_edges(struct split *split, struct tcs_fault *fault)
{
	const struct edge_table *edges = &split->set->edges;
	enum tcs_status status = TCS_OK;
	size_t run;

	for (size_t i = 0; !status && i < edges->uses.count; i += run) {
		const struct edge_use *use = &edges->uses.at[i];

		run = edge_table_run(edges, i);
		if (run == 2 && use[0].forward != use[1].forward)
			join_edge(split, corner_of(split, &use[0]),
				corner_of(split, &use[1]));
		else if (run > 2)
			status = join_crowd(split, use, run, fault);
	}
	return status;
}

/* ---- faces, nodes, vertices ---------------------------------------------- */

static enum tcs_status
number_faces(struct split *split, struct tcs_fault *fault)
{
	const struct component_set *set = split->set;
	struct sheets *sheets = split->sheets;
	size_t count = set->triangles.count;

	if (array_grow(&sheets->face_triangles, count) ||
		array_grow(&sheets->triangle_faces, count) ||
		array_grow(&sheets->corners, 3 * count) ||
		array_grow(&sheets->opposites, 3 * count))
		return fault_memory(fault);
	sheets->triangle_faces.count = count;
	for (size_t i = 0; i < count; i++) {
		uint32_t triangle = set->order.at[i];

		sheets->triangle_faces.at[triangle] = TCS_NONE;
		if (is_collapsed(&set->triangles.at[triangle]))
			continue;
		sheets->triangle_faces.at[triangle] =
			(uint32_t)sheets->face_triangles.count;
		sheets->face_triangles.at[sheets->face_triangles.count++] =
			triangle;
	}
	count = 3 * sheets->face_triangles.count;
	sheets->corners.count = sheets->opposites.count = count;
	for (size_t i = 0; i < count; i++) {
		sheets->opposites.at[i] = HALF_EDGE_NONE;
		split->parents[i] = (uint32_t)i;
	}
	return TCS_OK;
}

static uint32_t
point_of(const struct split *split, size_t corner)
{
	uint32_t triangle = split->sheets->face_triangles.at[corner / 3];

	return split->set->triangles.at[triangle].corner[corner % 3];
}

/*
 * Nodes in the order of their first corners; corners.at holds node numbers
 * meanwhile. seen[point] is the last node there: faces stand component by
 * component, so an older component's is never asked for again.
 */
static enum tcs_status
number_nodes(struct split *split, uint32_t *seen, struct tcs_fault *fault)
{
	struct sheets *sheets = split->sheets;

	for (size_t i = 0; i < split->set->points.count; i++)
		seen[i] = TCS_NONE;
	for (size_t i = 0; i < sheets->corners.count; i++) {
		uint32_t point = point_of(split, i);
		uint32_t triangle = sheets->face_triangles.at[i / 3];
		uint32_t component = split->set->numbers.at[triangle];

		if (seen[point] == TCS_NONE ||
			sheets->nodes.at[seen[point]].component != component) {
			if (array_grow(&sheets->nodes, 2))
				return fault_memory(fault);
			seen[point] = (uint32_t)sheets->nodes.count;
			sheets->nodes.at[sheets->nodes.count++] =
				(struct sheet_node){point, component, 0};
		}
		sheets->corners.at[i] = seen[point];
		/* Counts its fans, until they are numbered. */
		sheets->nodes.at[seen[point]].first_vertex +=
			split->parents[i] == i;
	}
	sheets->node_count = sheets->nodes.count;
	return TCS_OK;
}

/* Vertices by node, those of one node in the order of their first corners. */
static enum tcs_status
number_vertices(struct split *split, struct tcs_fault *fault)
{
	struct sheets *sheets = split->sheets;
	uint32_t count = 0;

	for (size_t i = 0; i < sheets->node_count; i++) {
		uint32_t fans = sheets->nodes.at[i].first_vertex;

		sheets->nodes.at[i].first_vertex = count;
		count += fans;
	}
	if (array_grow(&sheets->vertex_nodes, count) ||
		array_grow(&sheets->nodes, 1))
		return fault_memory(fault);
	sheets->vertex_nodes.count = count;
	for (size_t i = 0; i < sheets->corners.count; i++) {
		uint32_t node = sheets->corners.at[i];

		if (forest_root(split->parents, (uint32_t)i) == i) {
			uint32_t vertex = sheets->nodes.at[node].first_vertex++;

			sheets->corners.at[i] = vertex;
			sheets->vertex_nodes.at[vertex] = node;
		} else {
			uint32_t root =
				forest_root(split->parents, (uint32_t)i);

			sheets->corners.at[i] = sheets->corners.at[root];
		}
	}
	/* Every first vertex has moved to the next node's. */
	sheets->nodes.at[sheets->node_count] =
		(struct sheet_node){TCS_NONE, TCS_NONE, count};
	for (size_t i = sheets->node_count; i-- > 1;)
		sheets->nodes.at[i].first_vertex =
			sheets->nodes.at[i - 1].first_vertex;
	if (sheets->node_count > 0)
		sheets->nodes.at[0].first_vertex = 0;
	return TCS_OK;
}

static void
flatten(struct split *split)
{
	for (size_t i = 0; i < split->sheets->corners.count; i++)
		split->parents[i] = forest_root(split->parents, (uint32_t)i);
}

static enum tcs_status
find_normals(struct split *split, struct tcs_fault *fault)
{
	struct sheets *sheets = split->sheets;
	size_t count = sheets->face_triangles.count;

	if (array_grow(&sheets->normals, count))
		return fault_memory(fault);
	for (size_t i = 0; i < count; i++) {
		struct triangle_shape shape = component_set_shape(
			split->set, sheets->face_triangles.at[i]);
		struct tcs_point normal = triangle_normal(&shape);
		double length = vector_length(normal);

		sheets->normals.at[i] =
			length > 0 ? vector_scaled(normal, 1 / length) : normal;
	}
	sheets->normals.count = count;
	return TCS_OK;
}

static enum tcs_status
build(struct split *split, uint32_t *seen, struct tcs_fault *fault)
{
	enum tcs_status status = number_faces(split, fault);

	if (!status)
		status = join_edges(split, fault);
	if (status)
		return status;
	flatten(split);
	status = number_nodes(split, seen, fault);
	if (!status)
		status = number_vertices(split, fault);
	return status ? status : find_normals(split, fault);
}

enum tcs_status
sheets_build(struct sheets *sheets, const struct component_set *set,
	struct tcs_fault *fault)
{
	size_t count = set->triangles.count;
	struct split split = {
		.set = set,
		.sheets = sheets,
		.parents = calloc(3 * count + 1, sizeof *split.parents),
	};
	uint32_t *seen = calloc(set->points.count + 1, sizeof *seen);
	enum tcs_status status;

	array_clear(&sheets->nodes);
	array_clear(&sheets->vertex_nodes);
	array_clear(&sheets->face_triangles);
	array_clear(&sheets->triangle_faces);
	array_clear(&sheets->corners);
	array_clear(&sheets->opposites);
	array_clear(&sheets->normals);
	sheets->node_count = 0;
	if (!split.parents || !seen)
		status = fault_memory(fault);
	else
		status = build(&split, seen, fault);
	array_release(&split.wings);
	free(split.parents);
	free(seen);
	return status;
}

void
sheets_release(struct sheets *sheets)
{
	array_release(&sheets->nodes);
	array_release(&sheets->vertex_nodes);
	array_release(&sheets->face_triangles);
	array_release(&sheets->triangle_faces);
	array_release(&sheets->corners);
	array_release(&sheets->opposites);
	array_release(&sheets->normals);
}
