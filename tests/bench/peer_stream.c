/*
 * lod_peer --peer NAME --rate R: simplify every object of a stream by a method
 * to compare with; --seconds prints what the method alone took of CPU time. Components share no vertex, an object has one number of
 * triangles for all of them together, and each triangle gets the surface of
 * the nearest one of its component before. What is drawn at the highest level of detail
 * is taken, as one geometry; placed prototypes are passed on.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "frame.h"
#include "output.h"
#include "peer.h"
#include "program.h"
#include "simplify/compare_side.h"
#include "simplify/vector.h"

struct method {
	const char *name;
	peer_run *run;
};

static const struct method methods[] = {
	{"qem", peer_qem},
	{"clustering", peer_clustering},
	{"meshoptimizer", peer_meshoptimizer},
	{"openmesh", peer_openmesh},
	{"cgal", peer_cgal},
};

struct simplifier {
	peer_run *run;
	double rate;
	double seconds; /* of CPU time, in `run` alone */
	struct compare_side side;
	struct peer_mesh in, out;
	struct tcs_object object; /* the result */
};

/* ---- what a method gets -------------------------------------------------- */

static int
allocate(struct simplifier *simplifier)
{
	size_t triangles = simplifier->side.set.triangles.count;
	struct peer_mesh *in = &simplifier->in, *out = &simplifier->out;

	in->points = calloc(3 * triangles + 1, sizeof *in->points);
	in->triangles = calloc(triangles + 1, sizeof *in->triangles);
	in->components = calloc(3 * triangles + 1, sizeof *in->components);
	out->points = calloc(3 * triangles + 1, sizeof *out->points);
	out->triangles = calloc(triangles + 1, sizeof *out->triangles);
	out->components = calloc(triangles + 1, sizeof *out->components);
	return in->points && in->triangles && in->components && out->points &&
			out->triangles && out->components
		? 0
		: -1;
}

static void
deallocate(struct simplifier *simplifier)
{
	free(simplifier->in.points);
	free(simplifier->in.triangles);
	free(simplifier->in.components);
	free(simplifier->out.points);
	free(simplifier->out.triangles);
	free(simplifier->out.components);
	simplifier->in = simplifier->out = (struct peer_mesh){0};
}

/* Component by component, each with points of its own. Points of the set are
   taken once per component: `taken` says by which, `copies` as what. */
static void
fill_input(struct simplifier *simplifier, uint32_t *taken, uint32_t *copies)
{
	const struct component_set *set = &simplifier->side.set;
	struct peer_mesh *in = &simplifier->in;

	for (size_t i = 0; i < set->order.count; i++) {
		uint32_t triangle = set->order.at[i];
		uint32_t component = set->numbers.at[triangle];

		for (int k = 0; k < 3; k++) {
			uint32_t p = set->triangles.at[triangle].corner[k];

			if (taken[p] != component + 1) {
				taken[p] = component + 1;
				copies[p] = (uint32_t)in->point_count;
				in->components[in->point_count] = component;
				in->points[in->point_count++] =
					set->points.at[p];
			}
			in->triangles[i].corner[k] = copies[p];
		}
	}
	in->triangle_count = set->order.count;
}

static int
make_input(struct simplifier *simplifier)
{
	size_t points = simplifier->side.set.points.count;
	uint32_t *taken = calloc(points + 1, sizeof *taken);
	uint32_t *copies = calloc(points + 1, sizeof *copies);
	int status = taken && copies ? 0 : -1;

	if (!status)
		fill_input(simplifier, taken, copies);
	free(taken);
	free(copies);
	return status;
}

/* ---- what becomes of it -------------------------------------------------- */

/* The surface of the component's triangle that lies nearest and faces that
   way. */
static uint32_t
surface_of(const struct component_set *set, uint32_t component,
	const struct triangle_shape *shape)
{
	uint32_t root = set->components.at[component].root;
	struct tcs_point centre = vector_scaled(
		vector_sum(shape->corner[0],
			vector_sum(shape->corner[1], shape->corner[2])),
		1.0 / 3);
	struct tree_hit hit = triangle_tree_nearest_facing(
		&set->tree, root, centre, triangle_normal(shape), INFINITY);

	if (!isfinite(hit.distance))
		hit = triangle_tree_nearest(&set->tree, root, centre, INFINITY);
	return set->features.at[hit.item];
}

/* A polygon of three vertices of its own. */
static void
put_triangle(struct tcs_object *to, const struct triangle_shape *shape,
	uint32_t surface, const struct frame *frame)
{
	uint32_t vertex = (uint32_t)to->vertices.count;

	to->polygons.at[to->polygons.count++] = (struct tcs_polygon){
		.surface = surface,
		.first_vertex = vertex,
		.vertex_count = 3,
		.first_triangle = (uint32_t)to->triangles.count,
		.triangle_count = 1,
	};
	to->triangles.at[to->triangles.count++] =
		(struct tcs_triangle){{vertex, vertex + 1, vertex + 2}};
	for (int i = 0; i < 3; i++)
		to->vertices.at[to->vertices.count++] =
			frame_from_local(frame, shape->corner[i]);
}

static uint8_t
highest_lod(const struct tcs_object *object)
{
	uint8_t lod = 0;

	for (size_t i = 0; i < object->geometries.count; i++)
		if (object->geometries.at[i].lod < 5 &&
			object->geometries.at[i].lod > lod)
			lod = object->geometries.at[i].lod;
	return lod;
}

static enum tcs_status
make_output(struct simplifier *simplifier, const struct tcs_object *from,
	const struct frame *frame, struct tcs_fault *fault)
{
	const struct peer_mesh *out = &simplifier->out;
	struct tcs_object *to = &simplifier->object;
	size_t count = out->triangle_count;

	array_clear(&to->geometries);
	array_clear(&to->polygons);
	array_clear(&to->vertices);
	array_clear(&to->triangles);
	if (array_grow(&to->geometries, 1) ||
		array_grow(&to->polygons, count) ||
		array_grow(&to->vertices, 3 * count) ||
		array_grow(&to->triangles, count))
		return fault_memory(fault);
	to->geometries.at[to->geometries.count++] = (struct tcs_geometry){
		.polygon_count = (uint32_t)count,
		.lod = highest_lod(from),
		.kind = TCS_MULTI_SURFACE,
		.flags = TCS_GEOMETRY_SIMPLIFIED,
	};
	for (size_t i = 0; i < count; i++) {
		const uint32_t *corner = out->triangles[i].corner;
		const struct triangle_shape shape = {{out->points[corner[0]],
			out->points[corner[1]], out->points[corner[2]]}};

		put_triangle(to, &shape,
			surface_of(&simplifier->side.set, out->components[i],
				&shape),
			frame);
	}
	return TCS_OK;
}

static double
cpu_seconds(void)
{
	struct timespec now = {0};

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int
run_method(struct simplifier *simplifier)
{
	double before = cpu_seconds();
	size_t count = simplifier->in.triangle_count;
	int status = simplifier->run(&simplifier->in,
		(size_t)lround((1 - simplifier->rate) * (double)count),
		&simplifier->out);

	simplifier->seconds += cpu_seconds() - before;
	return status;
}

static enum tcs_status
simplify(struct simplifier *simplifier, const struct tcs_object *from,
	const struct tcs_crs *crs, struct tcs_fault *fault)
{
	struct compare_side *side = &simplifier->side;
	struct frame frame;
	enum tcs_status status;
	size_t count;

	frame_init(&frame, crs,
		from->vertices.count ? &from->vertices.at[0] : NULL);
	status = side_load(side, from, NULL, SELECT_HIGHEST, &frame, fault);
	if (status)
		return status;
	count = side->set.triangles.count;
	if (allocate(simplifier) || make_input(simplifier) ||
		(count > 0 && run_method(simplifier)))
		status = fault_memory(fault);
	else
		status = make_output(simplifier, from, &frame, fault);
	deallocate(simplifier);
	return status;
}

/* ---- the stream ---------------------------------------------------------- */

/* Simplify the object in the record, and encode what it became into it. */
static enum tcs_status
change_object(struct simplifier *simplifier, struct tcs_record *record,
	const struct tcs_crs *crs, struct tcs_fault *fault)
{
	struct tcs_object from = {0}, to;
	enum tcs_status status = object_decode(&from, record, fault);

	if (!status)
		status = simplify(simplifier, &from, crs, fault);
	if (status)
		return status;
	to = from;
	memcpy(&to.geometries, &simplifier->object.geometries,
		sizeof to.geometries);
	memcpy(&to.polygons, &simplifier->object.polygons, sizeof to.polygons);
	memcpy(&to.vertices, &simplifier->object.vertices, sizeof to.vertices);
	memcpy(&to.triangles, &simplifier->object.triangles,
		sizeof to.triangles);
	to.shells.count = to.rings.count = 0;
	to.paints.count = to.texcoords.count = 0;
	return object_encode(&to, TCS_OBJECT, record, fault);
}

static enum tcs_status
filter(struct simplifier *simplifier, FILE *from, FILE *to,
	struct tcs_fault *fault)
{
	struct tcs_reader reader;
	struct tcs_writer writer;
	struct tcs_record record = {0}, first = {0};
	struct tcs_head head = {0};
	enum tcs_status status;

	reader_init(&reader, from);
	writer_init(&writer, to, 0);
	status = reader_next(&reader, &first, fault);
	if (!status)
		status = head_decode(&head, &first, fault);
	if (!status)
		status = writer_put(&writer, &first, fault);
	while (!status) {
		status = reader_next(&reader, &record, fault);
		if (status || reader.ended)
			break;
		if (record.type == TCS_OBJECT)
			status = change_object(
				simplifier, &record, head.crs.at, fault);
		if (!status)
			status = writer_put(&writer, &record, fault);
	}
	if (!status)
		status = writer_end(&writer, fault);
	head_release(&head);
	record_release(&first);
	record_release(&record);
	reader_release(&reader);
	writer_release(&writer);
	return status;
}

static const char *
parse_method(void *target, const char *argument)
{
	peer_run **run = target;

	for (size_t i = 0; i < sizeof methods / sizeof *methods; i++)
		if (!strcmp(argument, methods[i].name))
			*run = methods[i].run;
	return *run ? NULL
		    : "not one of qem, clustering, meshoptimizer, openmesh, "
		      "cgal";
}

int
main(int argc, char **argv)
{
	struct simplifier simplifier = {.rate = 0.5};
	bool tell = false;
	const struct option_row rows[] = {
		{OPTION_PARSE, 0, "peer", "NAME", "which method",
			&simplifier.run, 0, 0, parse_method},
		{OPTION_NUMBER, 0, "rate", "R",
			"share of the triangles to remove (default 0.5)",
			&simplifier.rate, 0, 1, NULL},
		{OPTION_FLAG, 0, "seconds", NULL,
			"print the method's CPU time to standard error", &tell,
			0, 0, NULL},
		{0},
	};
	const struct program program = {
		.name = "lod_peer",
		.synopsis = "--peer NAME [options]",
		.summary = "simplify a stream from standard input",
		.options = rows,
		.flags = PROGRAM_BINARY_OUT,
	};
	struct command command;
	struct tcs_fault fault;
	struct output out;
	int code = EXIT_DONE;

	program_begin(&program, argc, argv, &command);
	if (!simplifier.run)
		program_usage(&command, "--peer is missing");
	if (output_open(&out, command.output, &fault) ||
		filter(&simplifier, stdin, out.file, &fault) ||
		output_commit(&out, &fault))
		code = program_fail(&command, &fault);
	if (code == EXIT_DONE && tell)
		fprintf(stderr, "%.6f\n", simplifier.seconds);
	output_discard(&out);
	side_release(&simplifier.side);
	object_release(&simplifier.object);
	program_end(&command);
	return code;
}
