/*
 * Outlines from triangles: the edges that no neighbour shares, in loops.
 *
 * Equal positions are one point. An edge is shared when the other direction of
 * it is there too; the rest are the boundary. Loops follow the triangles'
 * winding, so the outer one runs counterclockwise and holes clockwise seen
 * from outside.
 */
#include <stdlib.h>
#include <string.h>

#include "citygml_compose.h"

struct sorted_vertex {
	struct tcs_point at;
	uint32_t vertex;
};

struct edge {
	uint32_t from, to; /* first vertices of their positions */
};

/* Scratch of one polygon, in the composer's arena. */
struct outline {
	const struct tcs_point *vertices; /* of the object */
	uint32_t first_vertex, vertex_count;
	uint32_t *same; /* per vertex: the first one of its position */
	uint32_t *next; /* per vertex: where its boundary edge goes */
	uint32_t *part; /* per vertex: its connected part, as a forest */
	struct edge *edges;
	size_t edge_count;
};

static int
compare_positions(const void *left, const void *right)
{
	const struct sorted_vertex *a = left, *b = right;

	if (a->at.x != b->at.x)
		return a->at.x < b->at.x ? -1 : 1;
	if (a->at.y != b->at.y)
		return a->at.y < b->at.y ? -1 : 1;
	if (a->at.z != b->at.z)
		return a->at.z < b->at.z ? -1 : 1;
	return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static bool
unite_positions(struct outline *outline, struct arena *arena)
{
	uint32_t count = outline->vertex_count, first = outline->first_vertex;
	struct sorted_vertex *sorted =
		arena_get(arena, count * sizeof *sorted + 1);

	if (!sorted)
		return false;
	for (uint32_t i = 0; i < count; i++)
		sorted[i] =
			(struct sorted_vertex){outline->vertices[first + i], i};
	qsort(sorted, count, sizeof *sorted, compare_positions);
	for (uint32_t i = 0; i < count; i++) {
		bool equal = i > 0 && sorted[i].at.x == sorted[i - 1].at.x &&
			sorted[i].at.y == sorted[i - 1].at.y &&
			sorted[i].at.z == sorted[i - 1].at.z;

		outline->same[sorted[i].vertex] = equal
			? outline->same[sorted[i - 1].vertex]
			: sorted[i].vertex;
	}
	return true;
}

static uint32_t
part_of(struct outline *outline, uint32_t vertex)
{
	while (outline->part[vertex] != vertex) {
		outline->part[vertex] = outline->part[outline->part[vertex]];
		vertex = outline->part[vertex];
	}
	return vertex;
}

static void
add_triangle(struct outline *outline, const struct tcs_triangle *triangle)
{
	uint32_t corner[3];

	for (unsigned i = 0; i < 3; i++)
		corner[i] = outline->same[triangle->corner[i] -
			outline->first_vertex];
	if (corner[0] == corner[1] || corner[1] == corner[2] ||
		corner[2] == corner[0])
		return;
	for (unsigned i = 0; i < 3; i++) {
		uint32_t a = part_of(outline, corner[i]);
		uint32_t b = part_of(outline, corner[(i + 1) % 3]);

		outline->edges[outline->edge_count++] =
			(struct edge){corner[i], corner[(i + 1) % 3]};
		outline->part[a > b ? a : b] = a > b ? b : a;
	}
}

static int
compare_edges(const void *left, const void *right)
{
	const struct edge *a = left, *b = right;
	uint32_t p = a->from < a->to ? a->from : a->to;
	uint32_t q = b->from < b->to ? b->from : b->to;

	if (p != q)
		return p < q ? -1 : 1;
	p = a->from ^ a->to ^ p;
	q = b->from ^ b->to ^ q;
	if (p != q)
		return p < q ? -1 : 1;
	return a->from < b->from ? -1 : a->from > b->from;
}

/* Keep the edges without a partner. False if one stands there twice. */
static bool
keep_boundary(struct outline *outline)
{
	size_t kept = 0, count = outline->edge_count;

	if (count)
		qsort(outline->edges, count, sizeof *outline->edges,
			compare_edges);
	for (size_t i = 0; i < count; i++) {
		struct edge edge = outline->edges[i];
		bool pair = i + 1 < count &&
			outline->edges[i + 1].from == edge.to &&
			outline->edges[i + 1].to == edge.from;

		if (i + 1 < count && outline->edges[i + 1].from == edge.from &&
			outline->edges[i + 1].to == edge.to)
			return false;
		if (pair)
			i++;
		else
			outline->edges[kept++] = edge;
	}
	outline->edge_count = kept;
	return true;
}

/* One way out of each point, or the boundary is not made of simple loops. */
static bool
chain(struct outline *outline)
{
	for (uint32_t i = 0; i < outline->vertex_count; i++)
		outline->next[i] = TCS_NONE;
	for (size_t i = 0; i < outline->edge_count; i++) {
		if (outline->next[outline->edges[i].from] != TCS_NONE)
			return false;
		outline->next[outline->edges[i].from] = outline->edges[i].to;
	}
	return outline->edge_count > 2;
}

static struct tcs_point
area_vector(const struct composer *composer, const struct loop *loop)
{
	const struct tcs_point *vertices = composer->object.vertices.at;
	const uint32_t *corners = composer->corners.at + loop->first;
	struct tcs_point o = vertices[corners[0]], sum = {0};

	for (uint32_t i = 1; i + 1 < loop->count; i++) {
		struct tcs_point a = vertices[corners[i]];
		struct tcs_point b = vertices[corners[i + 1]];

		a.x -= o.x, a.y -= o.y, a.z -= o.z;
		b.x -= o.x, b.y -= o.y, b.z -= o.z;
		sum.x += a.y * b.z - a.z * b.y;
		sum.y += a.z * b.x - a.x * b.z;
		sum.z += a.x * b.y - a.y * b.x;
	}
	return sum;
}

static double
squared_area(const struct composer *composer, const struct loop *loop)
{
	struct tcs_point v = area_vector(composer, loop);

	return v.x * v.x + v.y * v.y + v.z * v.z;
}

static enum tcs_status
take_loop(struct composer *composer, struct outline *outline, uint32_t start,
	struct tcs_fault *fault)
{
	struct loop loop = {.first = (uint32_t)composer->corners.count};
	uint32_t at = start;

	if (array_grow(&composer->loops, 1))
		return fault_memory(fault);
	while (at != TCS_NONE && outline->next[at] != TCS_NONE) {
		uint32_t next = outline->next[at];

		if (array_grow(&composer->corners, 1))
			return fault_memory(fault);
		composer->corners.at[composer->corners.count++] =
			outline->first_vertex + at;
		outline->next[at] = TCS_NONE;
		at = next;
	}
	loop.count = (uint32_t)composer->corners.count - loop.first;
	loop.part = part_of(outline, start);
	loop.area = squared_area(composer, &loop);
	composer->loops.at[composer->loops.count++] = loop;
	return TCS_OK;
}

static int
compare_loops(const void *left, const void *right)
{
	const struct loop *a = left, *b = right;

	if (a->part != b->part)
		return a->part < b->part ? -1 : 1;
	if (a->area != b->area)
		return a->area > b->area ? -1 : 1;
	return a->first < b->first ? -1 : a->first > b->first;
}

/* The loops of one connected part are one face, the largest its outside. */
static enum tcs_status
take_faces(struct composer *composer, size_t from, struct piece *piece,
	struct tcs_fault *fault)
{
	size_t count = composer->loops.count;

	if (count > from)
		qsort(&composer->loops.at[from], count - from,
			sizeof *composer->loops.at, compare_loops);
	if (array_grow(&composer->faces, count - from))
		return fault_memory(fault);
	for (size_t i = from; i < count; i++) {
		if (i > from &&
			composer->loops.at[i].part ==
				composer->loops.at[i - 1].part) {
			composer->faces.at[composer->faces.count - 1]
				.loop_count++;
			continue;
		}
		composer->faces.at[composer->faces.count++] = (struct face){
			.first_loop = (uint32_t)i, .loop_count = 1};
		piece->face_count++;
	}
	return TCS_OK;
}

static enum tcs_status
take_triangle(struct composer *composer, struct piece *piece,
	const struct tcs_triangle *triangle, struct tcs_fault *fault)
{
	struct face face = {
		.first_loop = (uint32_t)composer->loops.count, .loop_count = 1};

	if (array_grow(&composer->faces, 1) ||
		array_grow(&composer->loops, 1) ||
		array_grow(&composer->corners, 3))
		return fault_memory(fault);
	composer->loops.at[composer->loops.count++] = (struct loop){
		.first = (uint32_t)composer->corners.count, .count = 3};
	for (unsigned i = 0; i < 3; i++)
		composer->corners.at[composer->corners.count++] =
			triangle->corner[i];
	composer->faces.at[composer->faces.count++] = face;
	piece->face_count++;
	return TCS_OK;
}

static bool
prepare(struct outline *outline, struct composer *composer,
	const struct tcs_polygon *polygon)
{
	struct arena *arena = &composer->arena;
	size_t vertices = polygon->vertex_count;

	*outline = (struct outline){
		.vertices = composer->object.vertices.at,
		.first_vertex = polygon->first_vertex,
		.vertex_count = polygon->vertex_count,
		.same = arena_get(arena, vertices * sizeof(uint32_t) + 1),
		.next = arena_get(arena, vertices * sizeof(uint32_t) + 1),
		.part = arena_get(arena, vertices * sizeof(uint32_t) + 1),
		.edges = arena_get(arena,
			(size_t)polygon->triangle_count * 3 *
					sizeof(struct edge) +
				1),
	};
	if (!outline->same || !outline->next || !outline->part ||
		!outline->edges || !unite_positions(outline, arena))
		return false;
	for (uint32_t i = 0; i < polygon->vertex_count; i++)
		outline->part[i] = i;
	return true;
}

enum tcs_status
outline_find(struct composer *composer, uint32_t index, struct tcs_fault *fault)
{
	const struct tcs_polygon *polygon =
		&composer->object.polygons.at[index];
	const struct tcs_triangle *triangles =
		&composer->object.triangles.at[polygon->first_triangle];
	struct piece *piece = &composer->pieces.at[index];
	enum tcs_status status = TCS_OK;
	size_t first_loop = composer->loops.count;
	struct outline outline;
	bool simple;

	piece->first_face = (uint32_t)composer->faces.count;
	if (!prepare(&outline, composer, polygon))
		return fault_memory(fault);
	for (uint32_t i = 0; i < polygon->triangle_count; i++)
		add_triangle(&outline, &triangles[i]);
	simple = keep_boundary(&outline) && chain(&outline);
	if (!simple) {
		for (uint32_t i = 0; i < polygon->triangle_count && !status;
			i++)
			status = take_triangle(
				composer, piece, &triangles[i], fault);
		return status;
	}
	for (size_t i = 0; i < outline.edge_count && !status; i++)
		if (outline.next[outline.edges[i].from] != TCS_NONE)
			status = take_loop(composer, &outline,
				outline.edges[i].from, fault);
	return status ? status : take_faces(composer, first_loop, piece, fault);
}
