/*
 * ifc_bare ROUNDS FILE...: what ifc2tcs takes for each file on one thread,
 * opening it and writing the stream included, starting the program not. A line
 * a file: seconds of CPU time, the median of the rounds, and triangles;
 * "failed" where it gives up.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "parsers/ifc_convert.h"

enum { MOST_ROUNDS = 100 };

static double
cpu_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int
seconds_order(const void *left, const void *right)
{
	const double *a = left, *b = right;

	return *a < *b ? -1 : *a > *b;
}

static enum tcs_status
convert(const char *name, FILE *nowhere, struct report *report)
{
	char arguments[] = "";
	const struct program program = {.name = "ifc_bare"};
	const struct command command = {.program = &program,
		.input = name,
		.jobs = 1,
		.quiet = true,
		.arguments = arguments};
	const struct ifc_options options = {.deflection = 0.001};
	struct tcs_fault fault;
	struct input input = {.name = NULL};
	enum tcs_status status = input_open(&input, name, &fault);

	if (!status)
		status = ifc_convert(
			&input, nowhere, &options, &command, report, &fault);
	input_close(&input);
	return status;
}

static uint64_t
triangles_of(const struct report *report)
{
	for (size_t i = 0; i < report->counts.count; i++)
		if (!strcmp(report->counts.at[i].name, "triangles"))
			return report->counts.at[i].count;
	return 0;
}

static void
measure(const char *name, FILE *nowhere, int rounds)
{
	double seconds[MOST_ROUNDS] = {0};
	uint64_t triangles = 0;

	for (int i = 0; i < rounds; i++) {
		struct report report = {.counts = {0}};
		double before = cpu_seconds();
		enum tcs_status status = convert(name, nowhere, &report);

		seconds[i] = cpu_seconds() - before;
		triangles = triangles_of(&report);
		report_release(&report);
		if (status) {
			puts("failed 0");
			return;
		}
	}
	qsort(seconds, (size_t)rounds, sizeof *seconds, seconds_order);
	printf("%.6f %llu\n", seconds[rounds / 2],
		(unsigned long long)triangles);
}

int
main(int argc, char **argv)
{
	FILE *nowhere = fopen("/dev/null", "wb");
	int rounds = argc > 1 ? atoi(argv[1]) : 0;

	if (!nowhere || rounds < 1 || rounds > MOST_ROUNDS) {
		fputs("usage: ifc_bare ROUNDS FILE...\n", stderr);
		return 2;
	}
	for (int i = 2; i < argc; i++)
		measure(argv[i], nowhere, rounds);
	return fclose(nowhere) != 0;
}
