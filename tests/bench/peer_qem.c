#include "peer.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "simplify/edge_table.h"
#include "simplify/vector.h"

#define RIM_WEIGHT 1000 /* of the planes that hold open edges */

/* Sum of squared distances from planes: the upper half of a 4 × 4 matrix. */
struct quadric {
	double at[10];
};

/* Vertex `from` moves to where `to` is. */
struct collapse {
	double cost;
	uint32_t from, to;
	uint32_t from_stamp, to_stamp; /* valid while both are as they were */
};

struct qem {
	const struct peer_mesh *mesh;
	struct tcs_triangle *triangles;
	bool *gone; /* per triangle */
	uint32_t *first, *last; /* per point: of its corners; TCS_NONE */
	uint32_t *next; /* per corner: of the same point */
	uint32_t *stamps; /* per point: changes with its surroundings */
	struct quadric *quadrics;
	TCS_ARRAY(struct collapse) heap;
	size_t left; /* triangles */
};

static void
add_plane(struct quadric *quadric, struct tcs_point normal, double offset,
	double weight)
{
	const double plane[4] = {normal.x, normal.y, normal.z, offset};
	int at = 0;

	for (int i = 0; i < 4; i++)
		for (int k = i; k < 4; k++)
			quadric->at[at++] += weight * plane[i] * plane[k];
}

static double
evaluate(const struct quadric *quadric, struct tcs_point point)
{
	const double p[4] = {point.x, point.y, point.z, 1};
	double sum = 0;
	int at = 0;

	for (int i = 0; i < 4; i++)
		for (int k = i; k < 4; k++)
			sum += (i == k ? 1 : 2) * quadric->at[at++] * p[i] *
				p[k];
	return sum;
}

static struct tcs_point
point_at(const struct qem *qem, uint32_t point)
{
	return qem->mesh->points[point];
}

/* Twice the area, along the normal. */
static struct tcs_point
normal_of(struct tcs_point a, struct tcs_point b, struct tcs_point c)
{
	return vector_cross(vector_difference(b, a), vector_difference(c, a));
}

static void
add_unit_plane(struct quadric *quadric, struct tcs_point normal,
	struct tcs_point on, double weight)
{
	double length = vector_length(normal);

	if (!(length > 0))
		return;
	normal = vector_scaled(normal, 1 / length);
	add_plane(quadric, normal, -vector_dot(normal, on), weight);
}

static void
add_face_planes(struct qem *qem)
{
	for (size_t i = 0; i < qem->mesh->triangle_count; i++) {
		const uint32_t *c = qem->triangles[i].corner;
		struct tcs_point a = point_at(qem, c[0]);
		struct tcs_point normal =
			normal_of(a, point_at(qem, c[1]), point_at(qem, c[2]));

		for (int k = 0; k < 3; k++)
			add_unit_plane(&qem->quadrics[c[k]], normal, a,
				vector_length(normal) / 2);
	}
}

/* Garland & Heckbert 6: an edge of one triangle, by a plane across it. */
static void
add_rim_planes(struct qem *qem, const struct edge_table *edges)
{
	size_t run;

	for (size_t i = 0; i < edges->uses.count; i += run) {
		const struct edge_use *use = &edges->uses.at[i];
		const uint32_t *c = qem->triangles[use->triangle].corner;
		struct tcs_point a = point_at(qem, use->low);
		struct tcs_point way =
			vector_difference(point_at(qem, use->high), a);
		struct tcs_point across;

		run = edge_table_run(edges, i);
		if (run > 1)
			continue;
		across = vector_cross(way,
			normal_of(point_at(qem, c[0]), point_at(qem, c[1]),
				point_at(qem, c[2])));
		add_unit_plane(&qem->quadrics[use->low], across, a,
			RIM_WEIGHT * vector_dot(way, way));
		add_unit_plane(&qem->quadrics[use->high], across, a,
			RIM_WEIGHT * vector_dot(way, way));
	}
}

/* ---- the queue ----------------------------------------------------------- */

static bool
is_before(const struct collapse *a, const struct collapse *b)
{
	if (a->cost != b->cost)
		return a->cost < b->cost;
	return a->from != b->from ? a->from < b->from : a->to < b->to;
}

static int
push(struct qem *qem, uint32_t from, uint32_t to)
{
	struct quadric sum = qem->quadrics[from];
	struct collapse own;
	size_t at;

	if (array_grow(&qem->heap, 1))
		return -1;
	for (int i = 0; i < 10; i++)
		sum.at[i] += qem->quadrics[to].at[i];
	own = (struct collapse){evaluate(&sum, point_at(qem, to)), from, to,
		qem->stamps[from], qem->stamps[to]};
	for (at = qem->heap.count++; at > 0; at = (at - 1) / 2) {
		if (!is_before(&own, &qem->heap.at[(at - 1) / 2]))
			break;
		qem->heap.at[at] = qem->heap.at[(at - 1) / 2];
	}
	qem->heap.at[at] = own;
	return 0;
}

static struct collapse
pop(struct qem *qem)
{
	struct collapse best = qem->heap.at[0];
	struct collapse last = qem->heap.at[--qem->heap.count];
	size_t at = 0, child;

	while ((child = 2 * at + 1) < qem->heap.count) {
		if (child + 1 < qem->heap.count &&
			is_before(
				&qem->heap.at[child + 1], &qem->heap.at[child]))
			child++;
		if (!is_before(&qem->heap.at[child], &last))
			break;
		qem->heap.at[at] = qem->heap.at[child];
		at = child;
	}
	if (qem->heap.count > 0)
		qem->heap.at[at] = last;
	return best;
}

/* ---- collapses ----------------------------------------------------------- */

static bool
has_corner(const struct tcs_triangle *triangle, uint32_t point)
{
	return triangle->corner[0] == point || triangle->corner[1] == point ||
		triangle->corner[2] == point;
}

static bool
turns_a_face(const struct qem *qem, const struct collapse *collapse)
{
	uint32_t corner = qem->first[collapse->from];

	for (; corner != TCS_NONE; corner = qem->next[corner]) {
		const struct tcs_triangle *t = &qem->triangles[corner / 3];
		struct tcs_point old[3], moved[3], before, after;

		if (qem->gone[corner / 3] || has_corner(t, collapse->to))
			continue;
		for (int i = 0; i < 3; i++) {
			old[i] = moved[i] = point_at(qem, t->corner[i]);
			if (t->corner[i] == collapse->from)
				moved[i] = point_at(qem, collapse->to);
		}
		before = normal_of(old[0], old[1], old[2]);
		after = normal_of(moved[0], moved[1], moved[2]);
		if (vector_dot(before, after) <
			0.2 * vector_length(before) * vector_length(after))
			return true;
	}
	return false;
}

static void
move_corners(struct qem *qem, const struct collapse *collapse)
{
	uint32_t from = collapse->from, to = collapse->to;
	uint32_t corner = qem->first[from];

	for (; corner != TCS_NONE; corner = qem->next[corner]) {
		struct tcs_triangle *t = &qem->triangles[corner / 3];

		if (qem->gone[corner / 3])
			continue;
		if (has_corner(t, to)) {
			qem->gone[corner / 3] = true;
			qem->left--;
		}
		t->corner[corner % 3] = to;
	}
	if (qem->first[to] == TCS_NONE)
		qem->first[to] = qem->first[from];
	else
		qem->next[qem->last[to]] = qem->first[from];
	if (qem->first[from] != TCS_NONE)
		qem->last[to] = qem->last[from];
	qem->first[from] = TCS_NONE;
	for (int i = 0; i < 10; i++)
		qem->quadrics[to].at[i] += qem->quadrics[from].at[i];
	qem->stamps[from]++;
	qem->stamps[to]++;
}

/* Queue all edges around a point anew. */
static int
push_around(struct qem *qem, uint32_t point)
{
	uint32_t corner = qem->first[point];

	for (; corner != TCS_NONE; corner = qem->next[corner]) {
		const uint32_t *c = qem->triangles[corner / 3].corner;

		if (qem->gone[corner / 3])
			continue;
		for (int i = 0; i < 3; i++)
			if (c[i] != point &&
				(push(qem, point, c[i]) ||
					push(qem, c[i], point)))
				return -1;
	}
	return 0;
}

static int
collapse_until(struct qem *qem, size_t target)
{
	while (qem->left > target && qem->heap.count > 0) {
		struct collapse best = pop(qem);

		if (best.from_stamp != qem->stamps[best.from] ||
			best.to_stamp != qem->stamps[best.to] ||
			turns_a_face(qem, &best))
			continue;
		move_corners(qem, &best);
		if (push_around(qem, best.to))
			return -1;
	}
	return 0;
}

/* ---- all ----------------------------------------------------------------- */

static int
begin(struct qem *qem, struct edge_table *edges)
{
	size_t points = qem->mesh->point_count;
	size_t triangles = qem->mesh->triangle_count;
	struct tcs_fault fault;

	qem->gone = calloc(triangles, sizeof *qem->gone);
	qem->first = calloc(points, sizeof *qem->first);
	qem->last = calloc(points, sizeof *qem->last);
	qem->next = calloc(3 * triangles, sizeof *qem->next);
	qem->stamps = calloc(points, sizeof *qem->stamps);
	qem->quadrics = calloc(points, sizeof *qem->quadrics);
	if (!qem->gone || !qem->first || !qem->last || !qem->next ||
		!qem->stamps || !qem->quadrics ||
		edge_table_build(
			edges, qem->triangles, triangles, points, &fault))
		return -1;
	for (size_t i = 0; i < points; i++)
		qem->first[i] = qem->last[i] = TCS_NONE;
	for (size_t i = 0; i < triangles; i++) {
		qem->gone[i] = is_collapsed(&qem->triangles[i]);
		qem->left += !qem->gone[i];
	}
	for (uint32_t i = 0; i < 3 * triangles; i++) {
		uint32_t point = qem->triangles[i / 3].corner[i % 3];

		qem->next[i] = qem->first[point];
		if (qem->first[point] == TCS_NONE)
			qem->last[point] = i;
		qem->first[point] = i;
	}
	add_face_planes(qem);
	add_rim_planes(qem, edges);
	return 0;
}

static int
push_edges(struct qem *qem, const struct edge_table *edges)
{
	for (size_t i = 0; i < edges->uses.count;
		i += edge_table_run(edges, i)) {
		const struct edge_use *use = &edges->uses.at[i];

		if (push(qem, use->low, use->high) ||
			push(qem, use->high, use->low))
			return -1;
	}
	return 0;
}

static void
take_result(const struct qem *qem, struct peer_mesh *out)
{
	out->triangle_count = 0;
	for (size_t i = 0; i < qem->mesh->triangle_count; i++)
		if (!qem->gone[i])
			peer_put(qem->mesh, &qem->triangles[i], out);
}

int
peer_qem(const struct peer_mesh *in, size_t target, struct peer_mesh *out)
{
	struct qem qem = {.mesh = in, .triangles = out->triangles};
	struct edge_table edges = {0};
	int status;

	for (size_t i = 0; i < in->triangle_count; i++)
		out->triangles[i] = in->triangles[i];
	for (size_t i = 0; i < in->point_count; i++)
		out->points[i] = in->points[i];
	out->point_count = in->point_count;
	status = begin(&qem, &edges);
	if (!status)
		status = push_edges(&qem, &edges);
	if (!status)
		status = collapse_until(&qem, target);
	if (!status)
		take_result(&qem, out);
	free(qem.gone);
	free(qem.first);
	free(qem.last);
	free(qem.next);
	free(qem.stamps);
	free(qem.quadrics);
	array_release(&qem.heap);
	edge_table_release(&edges);
	return status;
}
