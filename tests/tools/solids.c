/*
 * Are the solids of a stream closed, flat and the right way out?
 *
 *     solids STREAM          all of them
 *     solids BEFORE AFTER    those of AFTER that were so in BEFORE, one by one
 *                            in the order of the streams
 *
 * Closed: every edge of a shell's rings is passed as often one way as the
 * other; a polygon without rings has the edges of its triangles. Flat: no
 * vertex of a ring is more than a millimetre off the plane of the outer one
 * (Newell's normal, through the centre of its vertices). The right way out:
 * outer shells have a positive volume, voids a negative one.
 *
 * Prints the solids at fault and a summary; exits 1 when there are any.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tcs.h"

enum { CLOSED = 1, FLAT = 2, OUTWARD = 4, GOOD = 7 };

static const struct {
	unsigned bit;
	const char *is_not;
} faults[] = {
	{CLOSED, "not closed"},
	{FLAT, "not flat"},
	{OUTWARD, "inside out"},
};

/* An edge between two positions, the lesser one first; `way` is +1 where it
 * was passed from there, else -1. */
struct edge {
	struct tcs_point least, most;
	int way;
};

struct solid {
	char name[160];
	unsigned is;
};

struct model {
	TCS_ARRAY(struct solid) solids;
	TCS_ARRAY(struct edge) edges;
	struct tcs_object object;
	struct tcs_point metres; /* per unit */
};

static void
die(const char *what, const char *why)
{
	fprintf(stderr, "solids: %s: %s\n", what, why);
	exit(2);
}

static void
no_memory(int failed)
{
	if (failed)
		die("memory", "there is none");
}

static int
compare_points(const struct tcs_point *a, const struct tcs_point *b)
{
	if (a->x != b->x)
		return a->x < b->x ? -1 : 1;
	if (a->y != b->y)
		return a->y < b->y ? -1 : 1;
	return a->z < b->z ? -1 : a->z > b->z;
}

static int
compare_edges(const void *left, const void *right)
{
	const struct edge *a = left, *b = right;
	int order = compare_points(&a->least, &b->least);

	return order ? order : compare_points(&a->most, &b->most);
}

/* ---- closed ---------------------------------------------------------------- */

static void
add_edge(struct model *model, struct tcs_point from, struct tcs_point to)
{
	int order = compare_points(&from, &to);

	if (!order)
		return;
	no_memory(array_grow(&model->edges, 1));
	model->edges.at[model->edges.count++] = order < 0
		? (struct edge){from, to, 1}
		: (struct edge){to, from, -1};
}

static void
add_ring(struct model *model, const struct tcs_point *at, uint32_t count,
	bool reversed)
{
	for (uint32_t i = 0; i < count; i++) {
		struct tcs_point a = at[i], b = at[(i + 1) % count];

		add_edge(model, reversed ? b : a, reversed ? a : b);
	}
}

static void
add_polygon(struct model *model, const struct tcs_polygon *polygon)
{
	const struct tcs_object *object = &model->object;
	const struct tcs_point *vertices = object->vertices.at;

	for (uint32_t i = 0; i < polygon->ring_count; i++) {
		const struct tcs_ring *ring =
			&object->rings.at[polygon->first_ring + i];

		add_ring(model, vertices + ring->first_vertex,
			ring->vertex_count,
			polygon->flags & TCS_POLYGON_REVERSED);
	}
	for (uint32_t i = 0;
		!polygon->ring_count && i < polygon->triangle_count; i++) {
		const uint32_t *corner =
			object->triangles.at[polygon->first_triangle + i]
				.corner;

		for (unsigned k = 0; k < 3; k++)
			add_edge(model, vertices[corner[k]],
				vertices[corner[(k + 1) % 3]]);
	}
}

static bool
edges_are_closed(struct model *model)
{
	struct edge *edges = model->edges.at;
	size_t count = model->edges.count;
	int sum = 0;

	if (!count)
		return false;
	qsort(edges, count, sizeof *edges, compare_edges);
	for (size_t i = 0; i < count; i++) {
		if (i > 0 && compare_edges(&edges[i - 1], &edges[i])) {
			if (sum)
				return false;
		}
		sum += edges[i].way;
	}
	return !sum;
}

/* ---- flat ------------------------------------------------------------------- */

static struct tcs_point
scaled(const struct model *model, struct tcs_point at, struct tcs_point origin)
{
	return (struct tcs_point){(at.x - origin.x) * model->metres.x,
		(at.y - origin.y) * model->metres.y,
		(at.z - origin.z) * model->metres.z};
}

static bool
is_flat(const struct model *model, const struct tcs_polygon *polygon)
{
	const struct tcs_object *object = &model->object;
	const struct tcs_point *at =
		object->vertices.at + polygon->first_vertex;
	struct tcs_point n = {0, 0, 0}, centre = {0, 0, 0}, last;
	uint32_t outer, all = 0;
	double length;

	if (!polygon->ring_count)
		return true;
	outer = object->rings.at[polygon->first_ring].vertex_count;
	for (uint32_t i = 0; i < polygon->ring_count; i++)
		all += object->rings.at[polygon->first_ring + i].vertex_count;
	last = scaled(model, at[outer - 1], at[0]);
	for (uint32_t i = 0; i < outer; i++) {
		struct tcs_point p = scaled(model, at[i], at[0]);

		n.x += (last.y - p.y) * (last.z + p.z);
		n.y += (last.z - p.z) * (last.x + p.x);
		n.z += (last.x - p.x) * (last.y + p.y);
		centre.x += p.x / outer;
		centre.y += p.y / outer;
		centre.z += p.z / outer;
		last = p;
	}
	length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
	for (uint32_t i = 0; i < all; i++) {
		struct tcs_point p = scaled(model, at[i], at[0]);
		double off = (p.x - centre.x) * n.x + (p.y - centre.y) * n.y +
			(p.z - centre.z) * n.z;

		/* a hair for what rounding does to a millimetre */
		if (fabs(off) > 0.001001 * length)
			return false;
	}
	return true;
}

/* ---- the right way out ---------------------------------------------------- */

static double
volume_of(const struct tcs_object *object, const struct tcs_polygon *polygon,
	struct tcs_point o)
{
	const struct tcs_point *vertices = object->vertices.at;
	double sum = 0;

	for (uint32_t i = 0; i < polygon->triangle_count; i++) {
		const uint32_t *corner =
			object->triangles.at[polygon->first_triangle + i]
				.corner;
		struct tcs_point a = vertices[corner[0]];
		struct tcs_point b = vertices[corner[1]];
		struct tcs_point c = vertices[corner[2]];

		a.x -= o.x, a.y -= o.y, a.z -= o.z;
		b.x -= o.x, b.y -= o.y, b.z -= o.z;
		c.x -= o.x, c.y -= o.y, c.z -= o.z;
		sum += a.x * (b.y * c.z - b.z * c.y) -
			a.y * (b.x * c.z - b.z * c.x) +
			a.z * (b.x * c.y - b.y * c.x);
	}
	return sum;
}

static unsigned
check_shell(struct model *model, const struct tcs_shell *shell)
{
	const struct tcs_object *object = &model->object;
	struct tcs_point origin = {0, 0, 0};
	unsigned is = FLAT;
	double volume = 0;

	array_clear(&model->edges);
	for (uint32_t i = 0; i < shell->polygon_count; i++) {
		const struct tcs_polygon *polygon =
			&object->polygons.at[shell->first_polygon + i];

		if (i == 0)
			origin = object->vertices.at[polygon->first_vertex];
		add_polygon(model, polygon);
		volume += volume_of(object, polygon, origin);
		if (!is_flat(model, polygon))
			is &= ~(unsigned)FLAT;
	}
	if (edges_are_closed(model))
		is |= CLOSED;
	if (shell->interior ? volume < 0 : volume > 0)
		is |= OUTWARD;
	return is;
}

/* ---- streams ---------------------------------------------------------------- */

static void
check_geometry(struct model *model, const struct tcs_geometry *geometry)
{
	const struct tcs_object *object = &model->object;

	for (uint32_t i = 0; i < geometry->shell_count; i++) {
		uint32_t shell = geometry->first_shell + i;
		struct solid *solid;

		no_memory(array_grow(&model->solids, 1));
		solid = &model->solids.at[model->solids.count++];
		solid->is = check_shell(model, &object->shells.at[shell]);
		snprintf(solid->name, sizeof solid->name,
			"%s, LOD %d, shell %u",
			object_text(object,
				object->features.at[geometry->feature].id),
			geometry->lod, i);
	}
}

static void
take_head(struct model *model, const struct tcs_record *record)
{
	struct tcs_head head = {0};
	const struct tcs_crs *crs;
	struct tcs_fault fault;

	if (head_decode(&head, record, &fault))
		die("head", fault.text);
	crs = &head.crs.at[0];
	model->metres = (struct tcs_point){crs->metres_per_unit,
		crs->metres_per_unit, crs->metres_per_unit_up};
	if (crs->kind == TCS_CRS_GEOGRAPHIC)
		model->metres.x = model->metres.y = 111300;
	head_release(&head);
}

static void
take_record(struct model *model, const struct tcs_record *record)
{
	struct tcs_fault fault;

	if (record->type == TCS_HEAD)
		take_head(model, record);
	if (record->type != TCS_OBJECT)
		return;
	if (object_decode(&model->object, record, &fault))
		die("object", fault.text);
	for (size_t i = 0; i < model->object.geometries.count; i++)
		check_geometry(model, &model->object.geometries.at[i]);
}

static void
read_model(struct model *model, const char *name)
{
	FILE *file = fopen(name, "rb");
	struct tcs_record record = {0};
	struct tcs_reader reader;
	struct tcs_fault fault;

	if (!file)
		die(name, "cannot open");
	reader_init(&reader, file);
	while (!reader.ended) {
		if (reader_next(&reader, &record, &fault))
			die(name, fault.text);
		take_record(model, &record);
	}
	object_release(&model->object);
	array_release(&model->edges);
	record_release(&record);
	reader_release(&reader);
	fclose(file);
}

static size_t
tell(const struct solid *solid, unsigned wanted)
{
	unsigned lacks = wanted & ~solid->is;

	for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
		if (lacks & faults[i].bit)
			printf("%s: %s\n", solid->name, faults[i].is_not);
	return lacks != 0;
}

int
main(int argc, char **argv)
{
	struct model before = {0}, after = {0};
	size_t bad = 0;

	if (argc != 2 && argc != 3)
		die("usage", "solids [BEFORE] STREAM");
	read_model(&after, argv[argc - 1]);
	if (argc == 3) {
		read_model(&before, argv[1]);
		if (before.solids.count != after.solids.count) {
			printf("%zu shells before, %zu after\n",
				before.solids.count, after.solids.count);
			bad++;
		}
	}
	for (size_t i = 0; i < after.solids.count; i++) {
		unsigned wanted = GOOD;

		if (argc == 3)
			wanted = i < before.solids.count
				? before.solids.at[i].is
				: 0;
		bad += tell(&after.solids.at[i], wanted);
	}
	printf("%zu shells, %zu at fault\n", after.solids.count, bad);
	array_release(&before.solids);
	array_release(&after.solids);
	return bad > 0;
}
