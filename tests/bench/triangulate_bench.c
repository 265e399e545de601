/*
 * Millions of triangles a second beside GLU's tessellator: the same polygons,
 * the same run, CPU time of one thread, the median of several rounds.
 */
#include "triangulate.h"

#include <GL/glu.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "array.h"

enum { ROUNDS = 7 };

struct sample {
	const char *name;
	TCS_ARRAY(struct tcs_point) vertices;
	TCS_ARRAY(uint32_t) rings; /* of all polygons */
	TCS_ARRAY(uint32_t) ring_counts; /* of each polygon */
};

static double
cpu_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void
die(const char *text)
{
	fprintf(stderr, "triangulate_bench: %s\n", text);
	exit(1);
}

/* ---- samples ----------------------------------------------------------------- */

static void
add_vertex(struct sample *sample, double along, double up, double turn)
{
	if (array_grow(&sample->vertices, 1))
		die("out of memory");
	sample->vertices.at[sample->vertices.count++] =
		(struct tcs_point){691000.25 + along * cos(turn),
			5333000.5 + along * sin(turn), 515.125 + up};
}

static void
add_ring(struct sample *sample, uint32_t count)
{
	if (array_grow(&sample->rings, 1))
		die("out of memory");
	sample->rings.at[sample->rings.count++] = count;
}

static void
add_polygon(struct sample *sample, uint32_t rings)
{
	if (array_grow(&sample->ring_counts, 1))
		die("out of memory");
	sample->ring_counts.at[sample->ring_counts.count++] = rings;
}

static void
add_box(struct sample *sample, double x, double y, double width, double height,
	double turn)
{
	add_vertex(sample, x, y, turn);
	add_vertex(sample, x + width, y, turn);
	add_vertex(sample, x + width, y + height, turn);
	add_vertex(sample, x, y + height, turn);
	add_ring(sample, 4);
}

/* A wall under a stepped gable: a base line and steps above it. */
static void
add_wall(struct sample *sample, uint32_t count, double turn)
{
	uint32_t above = count - 2;
	double width = 12;

	add_vertex(sample, 0, 0, turn);
	add_vertex(sample, width, 0, turn);
	for (uint32_t i = 0; i < above; i++) {
		double t = (double)i / (above - 1);

		add_vertex(sample, width * (1 - t),
			above > 2 ? 5 + (i % 2) + 3 * sin(3.1 * t) : 5, turn);
	}
	add_ring(sample, count);
	add_polygon(sample, 1);
}

static void
add_facade(struct sample *sample, uint32_t holes, double turn)
{
	uint32_t columns = holes > 10 ? 10 : 5;

	add_box(sample, 0, 0, columns * 3, (double)(holes / columns) * 3, turn);
	for (uint32_t i = 0; i < holes; i++)
		add_box(sample, 1 + 3.0 * (i % columns),
			0.8 + 3.0 * (i / columns), 1.2, 1.5, turn);
	add_polygon(sample, 1 + holes);
}

/* A ring around the unit circle, its radius jagged by a fixed pattern. */
static void
add_lake(struct sample *sample, uint32_t count, uint32_t side)
{
	for (uint32_t i = 0; i < count; i++) {
		double t = 2 * 3.14159265358979 * i / count;
		double radius = 1000 + 40 * sin(9 * t) + 0.01 * (i * 7919 % 13);

		add_vertex(sample, radius * cos(t), radius * sin(t), 0.3);
	}
	add_ring(sample, count);
	for (uint32_t i = 0; i < side * side; i++)
		add_box(sample, -600 + 1200.0 * (i % side) / side,
			-600 + 1200.0 * (i / side) / side, 500.0 / side,
			600.0 / side + i % 7 * 0.01, 0.3);
	add_polygon(sample, 1 + side * side);
}

/* Teeth side by side: every edge meets the same line. */
static void
add_comb(struct sample *sample, uint32_t count, double turn)
{
	uint32_t teeth = count / 4;

	add_vertex(sample, -10, 0, turn);
	add_vertex(sample, -10, (double)teeth, turn);
	for (uint32_t i = teeth; i > 0; i--) {
		add_vertex(sample, 100 + i * 31 % 17, i - 0.25, turn);
		add_vertex(sample, 0, i - 0.5, turn);
	}
	add_ring(sample, 2 + 2 * teeth);
	add_polygon(sample, 1);
}

/* ---- both triangulators -------------------------------------------------------- */

static size_t
run_ours(const struct sample *sample, struct triangulator *triangulator)
{
	const struct tcs_point *vertices = sample->vertices.at;
	const uint32_t *rings = sample->rings.at;
	size_t triangles = 0;

	for (size_t i = 0; i < sample->ring_counts.count; i++) {
		uint32_t count = sample->ring_counts.at[i];
		struct triangulation out;
		struct tcs_fault fault;

		if (triangulate(
			    triangulator, vertices, rings, count, &out, &fault))
			die(fault.text);
		if (out.outcome != TRIANGULATION_WHOLE)
			die(out.reason);
		triangles += out.triangle_count;
		for (; count; count--)
			vertices += *rings++;
	}
	return triangles;
}

struct glu_run {
	TCS_ARRAY(uint32_t) corners;
	const struct tcs_point *vertices;
};

static void GLAPIENTRY
glu_vertex(void *vertex, void *context)
{
	struct glu_run *run = context;

	if (array_grow(&run->corners, 1))
		die("out of memory");
	run->corners.at[run->corners.count++] =
		(uint32_t)((struct tcs_point *)vertex - run->vertices);
}

static void GLAPIENTRY
glu_edge_flag(GLboolean flag, void *context)
{
	(void)flag;
	(void)context;
}

static size_t
run_glu(const struct sample *sample, GLUtesselator *tessellator,
	struct glu_run *run)
{
	struct tcs_point *vertices = sample->vertices.at;
	const uint32_t *rings = sample->rings.at;
	size_t triangles = 0;

	run->vertices = vertices;
	for (size_t i = 0; i < sample->ring_counts.count; i++) {
		const struct tcs_point first = *vertices;

		run->corners.count = 0;
		gluTessBeginPolygon(tessellator, run);
		for (uint32_t j = 0; j < sample->ring_counts.at[i]; j++) {
			gluTessBeginContour(tessellator);
			for (uint32_t k = 0; k < *rings; k++, vertices++) {
				GLdouble at[3] = {vertices->x - first.x,
					vertices->y - first.y,
					vertices->z - first.z};

				gluTessVertex(tessellator, at, vertices);
			}
			rings++;
			gluTessEndContour(tessellator);
		}
		gluTessEndPolygon(tessellator);
		triangles += run->corners.count / 3;
	}
	return triangles;
}

static int
compare(const void *a, const void *b)
{
	const double *left = a, *right = b;

	return (*left > *right) - (*left < *right);
}

static double
median(double *times, int count)
{
	qsort(times, (size_t)count, sizeof *times, compare);
	return times[count / 2];
}

static void
sample_measure(struct sample *sample)
{
	struct triangulator *triangulator = triangulator_new();
	GLUtesselator *tessellator = gluNewTess();
	struct glu_run run = {.vertices = NULL};
	double ours[ROUNDS], glus[ROUNDS];
	size_t triangles = 0, glu_triangles = 0;
	int rounds = 0;

	if (!triangulator || !tessellator)
		die("out of memory");
	gluTessCallback(
		tessellator, GLU_TESS_VERTEX_DATA, (_GLUfuncptr)glu_vertex);
	gluTessCallback(tessellator, GLU_TESS_EDGE_FLAG_DATA,
		(_GLUfuncptr)glu_edge_flag);
	for (; rounds < ROUNDS && (!rounds || glus[0] < 0.5); rounds++) {
		double begin = cpu_seconds(), middle;

		triangles = run_ours(sample, triangulator);
		middle = cpu_seconds();
		glu_triangles = run_glu(sample, tessellator, &run);
		ours[rounds] = middle - begin;
		glus[rounds] = cpu_seconds() - middle;
	}
	printf("%-34s %8.2f %8.2f %12zu %10.4f\n", sample->name,
		1e-6 * (double)triangles / median(ours, rounds),
		1e-6 * (double)glu_triangles / median(glus, rounds), triangles,
		median(ours, rounds));
	array_release(&run.corners);
	gluDeleteTess(tessellator);
	triangulator_free(triangulator);
	array_release(&sample->vertices);
	array_release(&sample->rings);
	array_release(&sample->ring_counts);
}

static void
measure_walls(uint32_t least, uint32_t most, const char *name)
{
	struct sample sample = {.name = name};

	for (uint32_t i = 0; i < 20000; i++)
		add_wall(&sample, least + i % (most - least + 1), i * 0.37);
	sample_measure(&sample);
}

static void
measure_facades(uint32_t holes, const char *name)
{
	struct sample sample = {.name = name};

	for (uint32_t i = 0; i < 20000 / holes; i++)
		add_facade(&sample, holes, i * 0.37);
	sample_measure(&sample);
}

int
main(void)
{
	struct sample lake = {.name = "ring of 100,000"};
	struct sample islands = {.name = "ring of 100,000, 10,000 holes"};
	struct sample comb = {.name = "comb of 50,000"};

	printf("%-34s %8s %8s %12s %10s\n", "million triangles a second",
		"ours", "GLU", "triangles", "s");
	measure_walls(4, 4, "walls of 4 vertices");
	measure_walls(5, 5, "walls of 5 vertices");
	measure_walls(6, 6, "walls of 6 vertices");
	measure_walls(12, 12, "walls of 12 vertices");
	measure_walls(4, 12, "walls of 4 to 12 vertices");
	measure_facades(10, "walls with 10 holes");
	measure_facades(20, "walls with 20 holes");
	measure_facades(50, "walls with 50 holes");
	add_lake(&lake, 100000, 0);
	sample_measure(&lake);
	add_lake(&islands, 100000, 100);
	sample_measure(&islands);
	add_comb(&comb, 100000, 0.3);
	sample_measure(&comb);
	return 0;
}
