/*
 * simplify_bare RATE <stream: what tcs-simplify takes for its objects alone, in
 * seconds of CPU time: no reading, writing or encoding of the stream. That is
 * what lod_peer counts of others, and more: they are given the components, and
 * return triangles instead of polygons and surfaces.
 */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "simplify/object_simplifier.h"

static double
cpu_seconds(void)
{
	struct timespec now = {0};

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static enum tcs_status
simplify_record(struct object_simplifier *simplifier,
	const struct simplify_settings *settings, struct tcs_record *record,
	double *seconds, struct tcs_fault *fault)
{
	struct tcs_object object = {0};
	const struct tcs_object *out;
	struct report report = {0};
	enum tcs_status status = object_decode(&object, record, fault);
	double before = cpu_seconds();

	if (!status)
		status = simplify_object(
			simplifier, settings, &object, &out, &report, fault);
	*seconds += cpu_seconds() - before;
	object_release(&object);
	report_release(&report);
	return status;
}

static enum tcs_status
simplify_stream(struct simplify_settings *settings, double *seconds,
	struct tcs_fault *fault)
{
	struct object_simplifier simplifier = {0};
	struct tcs_reader reader;
	struct tcs_record first = {0}, record = {0};
	struct tcs_head head = {0};
	enum tcs_status status;

	reader_init(&reader, stdin);
	status = reader_next(&reader, &first, fault);
	if (!status)
		status = head_decode(&head, &first, fault);
	if (!status)
		settings->crs = *head.crs.at;
	while (!status) {
		status = reader_next(&reader, &record, fault);
		if (status || reader.ended)
			break;
		if (record.type == TCS_OBJECT)
			status = simplify_record(
				&simplifier, settings, &record, seconds, fault);
	}
	head_release(&head);
	record_release(&first);
	record_release(&record);
	reader_release(&reader);
	object_simplifier_release(&simplifier);
	return status;
}

int
main(int argc, char **argv)
{
	struct simplify_settings settings = {
		.levels = {{{BUDGET_RATE, argc > 1 ? atof(argv[1]) : 0.5},
			LOD_IN_PLACE}},
		.level_count = 1,
		.source = SELECT_HIGHEST,
		.base_ratio = 2,
		.jobs = 1,
	};
	struct tcs_fault fault = {0};
	double seconds = 0;

	if (simplify_stream(&settings, &seconds, &fault)) {
		fprintf(stderr, "%s\n", fault.text);
		return 1;
	}
	printf("%.6f\n", seconds);
	return 0;
}
