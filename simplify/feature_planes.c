/*
 * What a node must not leave: the planes of its faces, and at features, which
 * are open edges, sharp edges, borders between surfaces and seams of their
 * paint, planes through the edge across its face. Those of borders and seams
 * stand apart, for the surfaces may become one.
 *
 * The source's weights of 1000 and 500 for open edges and lines hold for models
 * whose unit it does not tell, and make everything else free beside them; here
 * a plane weighs as much as a triangle of so many squares of the edge would, so
 * that shapes are the same at every scale. A corner has the planes of the lines
 * that meet in it, and no weight of its own. For the missing side of a rim W
 * takes the length of the edge that collapses as the distance: that forbids to
 * straighten what is straight already, so it is the distance from the rim here.
 *
 * source: L, feature edges and their penalties (Liu, Li, Zhao, Liu, Texture
 * feature preserving simplification); W, hole vertices (Wang et al. 2021, ISPRS
 * IJGI 10, 422); M. Garland, P. Heckbert, 1997, boundary
 * constraints.
 */
#include <stdlib.h>
#include <string.h>

#include "collapses.h"

/* Weights of the planes across, per square metre of the edge's square. */
#define OPEN_PENALTY 0.6
#define LINE_PENALTY 0.3
#define SHARP_COSINE 0.866 /* 30 degrees */

static struct tcs_point
unit(struct tcs_point a)
{
	double length = vector_length(a);

	return length > 0 ? vector_scaled(a, 1 / length) : a;
}

static const uint32_t *
corners_of(const struct collapses *work, size_t face)
{
	return work->sheets->corners.at + 3 * face;
}

static void
add_face(struct collapses *work, size_t face)
{
	const uint32_t *corners = corners_of(work, face);
	struct tcs_point normal = work->sheets->normals.at[face];
	struct quadric plane = {0};
	struct triangle_shape shape;
	double area;

	for (int k = 0; k < 3; k++)
		shape.corner[k] = work->positions.at[node_of(work, corners[k])];
	area = triangle_area(&shape);
	quadric_add_plane(
		&plane, normal, -vector_dot(normal, shape.corner[0]), area);
	for (int k = 0; k < 3; k++) {
		uint32_t node = node_of(work, corners[k]);

		quadric_add(&work->quadrics.at[node], &plane);
		work->areas.at[node] += area;
	}
}

bool
edge_is_sharp(const struct collapses *work, size_t corner)
{
	uint32_t back = work->sheets->opposites.at[corner];

	return vector_dot(work->sheets->normals.at[corner / 3],
		       work->sheets->normals.at[back / 3]) < SHARP_COSINE;
}

/* 0 where the edge is nothing to keep. */
static double
penalty_of(const struct collapses *work, size_t corner)
{
	if (work->sheets->opposites.at[corner] == HALF_EDGE_NONE)
		return OPEN_PENALTY;
	return edge_is_sharp(work, corner) ? LINE_PENALTY : 0;
}

static void
add_edge(struct collapses *work, size_t corner)
{
	size_t face = corner / 3;
	const uint32_t *corners = corners_of(work, face);
	double penalty = penalty_of(work, corner);
	struct tcs_point from, along, across;
	uint32_t ends[2];

	if (!(penalty > 0))
		return;
	for (size_t i = 0; i < 2; i++)
		ends[i] = node_of(work, corners[(corner + i) % 3]);
	from = work->positions.at[ends[0]];
	along = vector_difference(work->positions.at[ends[1]], from);
	across = unit(vector_cross(along, work->sheets->normals.at[face]));
	for (int i = 0; i < 2; i++)
		quadric_add_plane(&work->quadrics.at[ends[i]], across,
			-vector_dot(across, from),
			penalty * vector_dot(along, along));
}

/* Whether two faces are of different surfaces, or of different charts of one. */
static bool
have_a_border(const struct collapses *work, uint32_t a, uint32_t b)
{
	const uint32_t *charts = work->regions.charts;
	uint32_t s = collapses_source(work, a);
	uint32_t t = collapses_source(work, b);

	if (work->features.at[a] != work->features.at[b])
		return true;
	return charts && charts[s] != charts[t] &&
		work->set->features.at[s] == work->features.at[a] &&
		work->set->features.at[t] == work->features.at[b];
}

/* Borders of a node, which may be its first. */
static struct quadric *
make_borders(struct collapses *work, uint32_t node)
{
	if (work->border_places.at[node] == TCS_NONE) {
		if (array_grow(&work->borders, 1))
			return NULL;
		work->border_places.at[node] = (uint32_t)work->borders.count;
		work->borders.at[work->borders.count++] = (struct quadric){0};
	}
	return borders_of(work, node);
}

/* What a border between surfaces adds at one of its ends: a plane across the
   face of the one that leads, or across both. */
static enum tcs_status
add_border(struct collapses *work, uint32_t node, const struct spoke *spoke,
	uint32_t other, struct tcs_fault *fault)
{
	struct tcs_point from = work->positions.at[node];
	uint32_t faces[2] = {spoke->face, other};
	struct quadric *borders;
	struct tcs_point along;
	bool leads[2];

	if (spoke->face == HALF_EDGE_NONE || other == HALF_EDGE_NONE ||
		!have_a_border(work, spoke->face, other))
		return TCS_OK;
	borders = make_borders(work, node);
	if (!borders)
		return fault_memory(fault);
	along = vector_difference(
		work->positions.at[node_of(work, spoke->to)], from);
	for (int i = 0; i < 2; i++)
		leads[i] = work->regions.leads[work->features.at[faces[i]]];
	for (int i = 0; i < 2; i++) {
		struct tcs_point across = unit(vector_cross(
			along, work->sheets->normals.at[faces[i]]));

		if (leads[1 - i] && !leads[i])
			continue;
		quadric_add_plane(borders, across, -vector_dot(across, from),
			LINE_PENALTY * vector_dot(along, along));
	}
	return TCS_OK;
}

/* Of a face as it is now. */
static struct tcs_point
now_normal(const struct collapses *work, uint32_t face)
{
	const struct tcs_point *positions = work->positions.at;
	uint32_t nodes[3];

	if (!collapses_face(work, face, nodes))
		return (struct tcs_point){0};
	return unit(vector_cross(
		vector_difference(positions[nodes[1]], positions[nodes[0]]),
		vector_difference(positions[nodes[2]], positions[nodes[0]])));
}

/* The face of a spoke and the line along it, as they are now. */
static void
add_spoke(struct collapses *work, uint32_t node, const struct spoke *spoke,
	const struct spoke *next, uint32_t other)
{
	const struct tcs_point *positions = work->positions.at;
	struct tcs_point from = positions[node], normal, across;
	struct tcs_point along =
		vector_difference(positions[node_of(work, spoke->to)], from);
	bool open = spoke->face == HALF_EDGE_NONE || other == HALF_EDGE_NONE;

	for (int side = 0; side < 2; side++) {
		uint32_t face = side ? other : spoke->face;

		if (face == HALF_EDGE_NONE ||
			(!open &&
				vector_dot(now_normal(work, spoke->face),
					now_normal(work, other)) >=
					SHARP_COSINE))
			continue;
		across = unit(vector_cross(along, now_normal(work, face)));
		quadric_add_plane(&work->quadrics.at[node], across,
			-vector_dot(across, from),
			(open ? OPEN_PENALTY : LINE_PENALTY) *
				vector_dot(along, along));
	}
	if (spoke->face == HALF_EDGE_NONE)
		return;
	normal = vector_cross(along,
		vector_difference(positions[node_of(work, next->to)], from));
	work->areas.at[node] += vector_length(normal) / 2;
	quadric_add_plane(&work->quadrics.at[node], unit(normal),
		-vector_dot(unit(normal), from), vector_length(normal) / 2);
}

enum tcs_status
collapses_weigh_node(
	struct collapses *work, uint32_t node, struct tcs_fault *fault)
{
	const struct sheet_node *fans = &work->sheets->nodes.at[node];
	enum tcs_status status = TCS_OK;
	size_t count;

	work->quadrics.at[node] = (struct quadric){0};
	work->areas.at[node] = 0;
	if (work->border_places.at[node] != TCS_NONE)
		*borders_of(work, node) = (struct quadric){0};
	for (uint32_t v = fans[0].first_vertex;
		!status && v < fans[1].first_vertex; v++) {
		status = spokes_of(work, v, &count, fault);
		for (size_t i = 0; !status && i < count; i++) {
			const struct spoke *spokes = work->spokes.at;
			uint32_t other = spokes[i ? i - 1 : count - 1].face;

			add_spoke(work, node, &spokes[i],
				&spokes[(i + 1) % count], other);
			status = add_border(
				work, node, &spokes[i], other, fault);
		}
	}
	return status;
}

/* Whether two faces are alike in all that makes a border. */
static bool
are_of_one_region(const struct collapses *work, uint32_t a, uint32_t b)
{
	const uint32_t *charts = work->regions.charts;

	return work->features.at[a] == work->features.at[b] &&
		(!charts ||
			charts[collapses_source(work, a)] ==
				charts[collapses_source(work, b)]);
}

/* Tell which vertices have faces that are not all alike: no other is at a
   border. firsts[vertex] is scratch. */
static void
find_mixed(const struct collapses *work, uint32_t *firsts, bool *mixed)
{
	uint32_t corners[3];

	for (uint32_t i = 0; i < work->features.count; i++) {
		if (!half_edges_corners(work->mesh, i, corners))
			continue;
		for (int k = 0; k < 3; k++) {
			uint32_t *first = &firsts[corners[k]];

			if (*first == TCS_NONE)
				*first = i;
			mixed[corners[k]] |=
				!are_of_one_region(work, *first, i);
		}
	}
}

static enum tcs_status
weigh_mixed(struct collapses *work, const bool *mixed, struct tcs_fault *fault)
{
	size_t vertices = work->sheets->vertex_nodes.count, count;
	enum tcs_status status = TCS_OK;

	for (uint32_t v = 0; !status && v < vertices; v++) {
		if (!mixed[v])
			continue;
		status = spokes_of(work, v, &count, fault);
		for (size_t i = 0; !status && i < count; i++)
			status = add_border(work, node_of(work, v),
				&work->spokes.at[i],
				work->spokes.at[i ? i - 1 : count - 1].face,
				fault);
	}
	return status;
}

enum tcs_status
collapses_weigh_borders(struct collapses *work, struct tcs_fault *fault)
{
	size_t vertices = work->sheets->vertex_nodes.count;
	uint32_t *firsts = malloc((vertices + 1) * sizeof *firsts);
	bool *mixed = calloc(vertices + 1, sizeof *mixed);
	enum tcs_status status;

	for (size_t i = 0; i < work->sheets->node_count; i++)
		work->border_places.at[i] = TCS_NONE;
	array_clear(&work->borders);
	if (!firsts || !mixed) {
		status = fault_memory(fault);
	} else {
		/* TCS_NONE is all ones. */
		memset(firsts, 0xff, vertices * sizeof *firsts);
		find_mixed(work, firsts, mixed);
		status = weigh_mixed(work, mixed, fault);
	}
	free(firsts);
	free(mixed);
	return status;
}

void
collapses_weigh(struct collapses *work)
{
	const struct sheets *sheets = work->sheets;

	for (size_t i = 0; i < sheets->node_count; i++) {
		work->positions.at[i] =
			work->set->points.at[sheets->nodes.at[i].point];
		work->quadrics.at[i] = (struct quadric){0};
		work->areas.at[i] = 0;
	}
	for (size_t i = 0; i < sheets->face_triangles.count; i++)
		add_face(work, i);
	for (size_t i = 0; i < sheets->corners.count; i++)
		add_edge(work, i);
}
