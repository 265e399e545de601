/*
 * What a node must not leave: the planes of its faces, and at features, which
 * are open edges, sharp edges and borders between surfaces, planes through the
 * edge across its face.
 *
 * source: L, feature edges and their penalties (Liu, Li, Zhao, Liu, Texture
 * feature preserving simplification); M. Garland, P. Heckbert, 1997, boundary
 * constraints.
 */
#include "collapses.h"

/* Weights of the planes across, per square metre of the edge's square. */
#define OPEN_PENALTY 1000
#define LINE_PENALTY 500
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
	struct tcs_point at[3], normal;
	double area;

	for (int k = 0; k < 3; k++)
		at[k] = work->positions.at[node_of(work, corners[k])];
	normal = vector_cross(vector_difference(at[1], at[0]),
		vector_difference(at[2], at[0]));
	area = vector_length(normal) / 2;
	normal = unit(normal);
	work->normals.at[face] = normal;
	for (int k = 0; k < 3; k++) {
		uint32_t node = node_of(work, corners[k]);

		quadric_add_plane(&work->quadrics.at[node], normal,
			-vector_dot(normal, at[0]), area);
		work->areas.at[node] += area;
	}
}

/* 0 where the edge is nothing to keep. */
static double
penalty_of(const struct collapses *work, size_t corner)
{
	uint32_t back = work->sheets->opposites.at[corner];

	if (back == HALF_EDGE_NONE)
		return OPEN_PENALTY;
	if (surface_of(work, corner / 3) != surface_of(work, back / 3) ||
		vector_dot(work->normals.at[corner / 3],
			work->normals.at[back / 3]) < SHARP_COSINE)
		return LINE_PENALTY;
	return 0;
}

static void
add_edge(struct collapses *work, size_t corner)
{
	size_t face = corner / 3;
	const uint32_t *corners = corners_of(work, face);
	double penalty = penalty_of(work, corner);
	uint32_t ends[2] = {node_of(work, corners[corner % 3]),
		node_of(work, corners[(corner + 1) % 3])};
	struct tcs_point from = work->positions.at[ends[0]];
	struct tcs_point along =
		vector_difference(work->positions.at[ends[1]], from);
	struct tcs_point across =
		unit(vector_cross(along, work->normals.at[face]));

	if (!(penalty > 0))
		return;
	for (int i = 0; i < 2; i++)
		quadric_add_plane(&work->quadrics.at[ends[i]], across,
			-vector_dot(across, from),
			penalty * vector_dot(along, along));
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
