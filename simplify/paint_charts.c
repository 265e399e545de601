#include "paint_charts.h"

#include <math.h>
#include <string.h>

#include "forest.h"

/* Of a texture's width: coordinates this near are one. */
#define SAME_PLACE 1e-4

struct scene {
	const struct tcs_object *object;
	const struct lod_source *source;
	const struct sheets *sheets;
	const struct paint_index *index;
};

/* ---- where paint goes on ------------------------------------------------- */

static const struct tcs_paint *
paint_of(const struct scene *scene, uint32_t polygon, uint32_t number)
{
	const struct paint_index *index = scene->index;

	return &scene->object->paints.at
			[index->paints.at[index->first.at[polygon] + number]];
}

static uint32_t
paint_count(const struct scene *scene, uint32_t polygon)
{
	return scene->index->first.at[polygon + 1] -
		scene->index->first.at[polygon];
}

static bool
is_near(struct tcs_texcoord a, struct tcs_texcoord b)
{
	return fabs(a.s - b.s) <= SAME_PLACE && fabs(a.t - b.t) <= SAME_PLACE;
}

/* Both ends of an edge as two triangles have them: vertices of the object. */
struct shared_edge {
	uint32_t polygons[2];
	uint32_t vertices[2][2]; /* by triangle, then end */
};

static bool
goes_on(const struct scene *scene, const struct shared_edge *edge,
	uint32_t number)
{
	const struct tcs_paint *a = paint_of(scene, edge->polygons[0], number);
	const struct tcs_paint *b = paint_of(scene, edge->polygons[1], number);

	if (a->theme != b->theme || a->material != b->material ||
		a->image != b->image || a->flags != b->flags)
		return false;
	for (int i = 0; a->first_texcoord != TCS_NONE && i < 2; i++)
		if (!is_near(paint_coordinate(
				     scene->object, a, edge->vertices[0][i]),
			    paint_coordinate(
				    scene->object, b, edge->vertices[1][i])))
			return false;
	return true;
}

/* Over the edge of a corner that has a face behind it. */
static bool
all_go_on(const struct scene *scene, uint32_t corner)
{
	const uint32_t corners[2] = {
		corner, scene->sheets->opposites.at[corner]};
	struct shared_edge edge;
	uint32_t count;

	for (uint32_t i = 0; i < 2; i++) {
		uint32_t triangle =
			scene->sheets->face_triangles.at[corners[i] / 3];
		const uint32_t *vertices = lod_source_vertices(
			scene->source, scene->object, triangle);
		uint32_t k = corners[i] % 3;

		edge.polygons[i] = scene->source->polygons.at[triangle];
		edge.vertices[i][i] = vertices[k];
		edge.vertices[i][1 - i] = vertices[(k + 1) % 3];
	}
	count = paint_count(scene, edge.polygons[0]);
	if (count != paint_count(scene, edge.polygons[1]))
		return false;
	for (uint32_t i = 0; i < count; i++)
		if (!goes_on(scene, &edge, i))
			return false;
	return true;
}

static enum tcs_status
join_triangles(struct paint_charts *charts, const struct scene *scene,
	struct tcs_fault *fault)
{
	const struct sheets *sheets = scene->sheets;
	size_t count = scene->source->polygons.count;
	uint32_t *numbers;

	if (array_grow(&charts->numbers, count))
		return fault_memory(fault);
	charts->numbers.count = count;
	numbers = charts->numbers.at;
	for (size_t i = 0; i < count; i++)
		numbers[i] = (uint32_t)i;
	for (uint32_t i = 0; i < sheets->corners.count; i++) {
		uint32_t back = sheets->opposites.at[i];

		if (back != HALF_EDGE_NONE && back > i && all_go_on(scene, i))
			forest_join(numbers, sheets->face_triangles.at[i / 3],
				sheets->face_triangles.at[back / 3]);
	}
	/* A root is the least of its set. */
	for (size_t i = 0; i < count; i++)
		numbers[i] = numbers[numbers[i]];
	return TCS_OK;
}

/* ---- corners ------------------------------------------------------------- */

/* Count, then place. */
static enum tcs_status
list_corners(struct paint_charts *charts, const struct sheets *sheets,
	struct tcs_fault *fault)
{
	size_t nodes = sheets->node_count, count = sheets->corners.count;
	uint32_t *first;

	if (array_grow(&charts->corners, count) ||
		array_grow(&charts->first, nodes + 2))
		return fault_memory(fault);
	charts->corners.count = count;
	charts->first.count = nodes + 1;
	first = charts->first.at;
	memset(first, 0, (nodes + 2) * sizeof *first);
	for (size_t i = 0; i < count; i++)
		first[sheets->vertex_nodes.at[sheets->corners.at[i]] + 2]++;
	for (size_t i = 0; i < nodes; i++)
		first[i + 2] += first[i + 1];
	for (size_t i = 0; i < count; i++) {
		uint32_t node = sheets->vertex_nodes.at[sheets->corners.at[i]];

		charts->corners.at[first[node + 1]++] = (uint32_t)(i % 3) +
			3 * sheets->face_triangles.at[i / 3];
	}
	return TCS_OK;
}

enum tcs_status
paint_charts_find(struct paint_charts *charts, const struct tcs_object *object,
	const struct lod_source *source, const struct sheets *sheets,
	struct tcs_fault *fault)
{
	const struct scene scene = {object, source, sheets, &charts->index};
	enum tcs_status status =
		paint_index_build(&charts->index, object, fault);

	array_clear(&charts->numbers);
	array_clear(&charts->corners);
	array_clear(&charts->first);
	if (!status && object->paints.count > 0)
		status = join_triangles(charts, &scene, fault);
	if (!status && object->texcoords.count > 0)
		status = list_corners(charts, sheets, fault);
	return status;
}

struct tcs_texcoord
paint_charts_at(const struct paint_charts *charts,
	const struct tcs_object *object, const struct lod_source *source,
	uint32_t triangle, uint32_t node, uint32_t number,
	struct tcs_texcoord guess)
{
	const struct scene scene = {object, source, NULL, &charts->index};
	uint32_t chart = charts->numbers.at[triangle];
	struct tcs_texcoord best = guess;
	double least = INFINITY;

	for (uint32_t i = charts->first.at[node];
		i < charts->first.at[node + 1]; i++) {
		uint32_t there = charts->corners.at[i] / 3;
		struct tcs_texcoord own;
		double away;

		if (charts->numbers.at[there] != chart)
			continue;
		own = paint_coordinate(object,
			paint_of(&scene, source->polygons.at[there], number),
			lod_source_vertices(source, object,
				there)[charts->corners.at[i] % 3]);
		away = hypot(own.s - guess.s, own.t - guess.t);
		if (away < least) {
			least = away;
			best = own;
		}
	}
	return best;
}

void
paint_charts_release(struct paint_charts *charts)
{
	paint_index_release(&charts->index);
	array_release(&charts->numbers);
	array_release(&charts->corners);
	array_release(&charts->first);
}
