/*
 * Cuts a second: what buildings are made of, CPU time of one thread, the median
 * of several rounds. Every result is closed and has the volume that it must.
 */
#include "parsers/solid.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { ROUNDS = 7, MOST_TOOLS = 2400 };

static const double turn = 6.283185307179586;

struct sample {
	const char *name;
	struct solid host;
	struct solid tools[MOST_TOOLS];
	const struct solid *pointers[MOST_TOOLS];
	size_t tool_count;
	struct solid_half_space half_spaces[4];
	size_t half_space_count;
	double volume; /* of the result */
	int repeats;
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
	fprintf(stderr, "solid_bench: %s\n", text);
	exit(1);
}

static void
must(enum tcs_status status)
{
	if (status)
		die("out of memory");
}

/* ---- samples ----------------------------------------------------------------- */

static void
add_box(struct solid *solid, const double low[3], const double high[3])
{
	const struct tcs_point base[4] = {{low[0], low[1], low[2]},
		{high[0], low[1], low[2]}, {high[0], high[1], low[2]},
		{low[0], high[1], low[2]}};
	const uint32_t four = 4;
	struct tcs_fault fault;

	must(solid_add_prism(solid, base, &four, 1,
		(struct tcs_point){0, 0, high[2] - low[2]}, 0, &fault));
}

static void
add_column(struct solid *solid, double x, double y, double radius, double low,
	double high)
{
	const uint32_t corners = 24;
	struct tcs_point base[24];
	struct tcs_fault fault;

	for (uint32_t i = 0; i < corners; i++)
		base[i] = (struct tcs_point){
			x + radius * cos(0.1 + i * turn / corners),
			y + radius * sin(0.1 + i * turn / corners), low};
	must(solid_add_prism(solid, base, &corners, 1,
		(struct tcs_point){0, 0, high - low}, 0, &fault));
}

/* Rotate everything about an axis that is none of the coordinates'. */
static void
tilt(struct solid *solid)
{
	static const double m[9] = {
		0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6};

	for (size_t i = 0; i < solid->points.count; i++) {
		struct tcs_point p = solid->points.at[i];

		solid->points.at[i] = (struct tcs_point){
			m[0] * p.x + m[1] * p.y + m[2] * p.z + 691000.25,
			m[3] * p.x + m[4] * p.y + m[5] * p.z + 5333000.5,
			m[6] * p.x + m[7] * p.y + m[8] * p.z + 512};
	}
}

static void
wall_make(struct sample *sample, size_t openings, bool tilted)
{
	add_box(&sample->host, (double[]){0, 0, 0},
		(double[]){2.0 * (double)openings, 0.24, 3});
	for (size_t i = 0; i < openings; i++)
		add_box(&sample->tools[i],
			(double[]){2.0 * (double)i + 0.5, 0, 1},
			(double[]){2.0 * (double)i + 1.5, 0.24, 2.2});
	sample->tool_count = openings;
	sample->volume = (double)openings * (6 - 1.2) * 0.24;
	if (!tilted)
		return;
	tilt(&sample->host);
	for (size_t i = 0; i < openings; i++)
		tilt(&sample->tools[i]);
}

/* Holes flush with the slab, or through it. */
static void
slab_make(struct sample *sample, size_t rows, size_t columns, double over)
{
	double area = 12 * 0.04 * sin(turn / 24);

	add_box(&sample->host, (double[]){0, 0, 0},
		(double[]){2 * (double)columns, 2 * (double)rows, 0.3});
	for (size_t i = 0; i < rows * columns; i++)
		add_column(&sample->tools[i], 1 + 2 * (double)(i % columns),
			1 + 2 * (double)(i / columns), 0.2, -over, 0.3 + over);
	sample->tool_count = rows * columns;
	sample->volume = 0.3 * (double)(rows * columns) * (4 - area);
}

static void
gable_make(struct sample *sample)
{
	add_box(&sample->host, (double[]){0, 0, 0}, (double[]){4, 0.3, 5});
	sample->half_spaces[0] =
		(struct solid_half_space){{0, 0, 3}, {-1, 0, 1}, 0};
	sample->half_spaces[1] =
		(struct solid_half_space){{4, 0, 3}, {1, 0, 1}, 0};
	sample->half_space_count = 2;
	sample->volume = 0.3 * (4 * 3 + 4);
}

/* ---- measuring --------------------------------------------------------------- */

static int
order(const void *left, const void *right)
{
	double a = *(const double *)left, b = *(const double *)right;

	return (a > b) - (a < b);
}

static void
check(const struct sample *sample, const struct solid *out,
	const struct solid_report *report)
{
	struct solid_measure measure;
	struct tcs_fault fault;

	must(solid_measure(out, &measure, &fault));
	if (report->outcome != SOLID_DONE || !measure.closed)
		die("a result is not closed");
	if (fabs(measure.volume - sample->volume) > 1e-6 * sample->volume)
		die("a volume is wrong");
}

static void
measure(const struct sample *sample)
{
	struct solid_task task = {.host = &sample->host,
		.tools = sample->pointers,
		.tool_count = sample->tool_count,
		.half_spaces = sample->half_spaces,
		.half_space_count = sample->half_space_count};
	size_t cuts = sample->tool_count + sample->half_space_count;
	struct solid_cutter *cutter = solid_cutter_new();
	struct solid_report report;
	struct solid out = {0};
	struct tcs_fault fault;
	double seconds[ROUNDS];

	if (!cutter)
		die("out of memory");
	for (int i = 0; i < ROUNDS; i++) {
		double start = cpu_seconds();

		for (int j = 0; j < sample->repeats; j++)
			must(solid_cut(
				cutter, &task, &out, &report, NULL, &fault));
		seconds[i] = (cpu_seconds() - start) / sample->repeats;
	}
	check(sample, &out, &report);
	qsort(seconds, ROUNDS, sizeof *seconds, order);
	printf("%-44s %8.3f ms %8.0f cuts/s %6zu faces\n", sample->name,
		1e3 * seconds[ROUNDS / 2], (double)cuts / seconds[ROUNDS / 2],
		out.faces.count);
	solid_release(&out);
	solid_cutter_free(cutter);
}

static void
sample_run(struct sample *sample, const char *name, int repeats)
{
	sample->name = name;
	sample->repeats = repeats;
	for (size_t i = 0; i < sample->tool_count; i++)
		sample->pointers[i] = &sample->tools[i];
	measure(sample);
	solid_release(&sample->host);
	for (size_t i = 0; i < sample->tool_count; i++)
		solid_release(&sample->tools[i]);
	*sample = (struct sample){0};
}

int
main(void)
{
	struct sample *sample = calloc(1, sizeof *sample);

	if (!sample)
		die("out of memory");
	gable_make(sample);
	sample_run(sample, "gable wall, 2 half-spaces", 500);
	wall_make(sample, 1, false);
	sample_run(sample, "wall, 1 opening", 500);
	wall_make(sample, 50, false);
	sample_run(sample, "wall, 50 openings", 20);
	wall_make(sample, 50, true);
	sample_run(sample, "wall, 50 openings, tilted and far away", 20);
	slab_make(sample, 15, 20, 0);
	sample_run(sample, "slab, 300 round holes of 24 sides, flush", 1);
	slab_make(sample, 15, 20, 0.1);
	sample_run(sample, "slab, 300 round holes of 24 sides", 1);
	slab_make(sample, 40, 60, 0.1);
	sample_run(sample, "slab, 2400 round holes of 24 sides", 1);
	free(sample);
	return 0;
}
