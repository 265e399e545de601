/*
 * Megabytes a second of CPU time, one thread: reading a STEP file into memory
 * is left out; indexing it, and decoding every parameter of every instance.
 * Over the larger files of ../shared/data/ifc, or those named; the figure is
 * the best of several passes, and of the whole the total.
 */
#include "parsers/step_file.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "parsers/step_load.h"
#include "parsers/step_string.h"

enum { LARGE = 1 << 18, PASSES = 5 };

struct figures {
	double bytes, index, decode; /* seconds */
	double numbers; /* keeps the decoding from being left out */
};

static double
cpu_seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void
die(const char *name, const char *text)
{
	fprintf(stderr, "step_bench: %s: %s\n", name, text);
	exit(1);
}

/* Every value, lists entered, strings decoded. */
static double
decode_list(struct step_cursor *cursors, struct step_text *text)
{
	double sum = 0, number;
	size_t depth = 0;

	for (;;) {
		struct tcs_fault fault;
		struct step_value value;
		unsigned trouble = 0;

		if (step_next(cursors + depth, &value) <= STEP_END) {
			if (!depth--)
				return sum;
		} else if (value.kind >= STEP_LIST) {
			cursors[++depth] = value.list;
		} else if (value.kind == STEP_STRING) {
			array_clear(text);
			if (step_decode(text, value.text, value.length,
				    &trouble, &fault))
				die("", fault.text);
		} else if (step_number(&value, &number)) {
			sum += number;
		}
	}
}

static void
measure(const char *name, const struct step_bytes *bytes, struct figures *out)
{
	struct step_cursor cursors[STEP_MAX_NESTING + 2];
	struct report report = {.counts = {0}};
	struct step_text text = {.count = 0};
	struct step_file file = {.text = NULL};
	struct tcs_fault fault;
	double begin = cpu_seconds(), middle;

	if (step_index(&file, bytes->at, bytes->count, &report, &fault))
		die(name, fault.text);
	middle = cpu_seconds();
	for (uint32_t i = 0; i < file.instances.count; i++) {
		cursors[0] = step_parameters(&file, i);
		out->numbers += decode_list(cursors, &text);
	}
	if (out->index == 0 || middle - begin < out->index)
		out->index = middle - begin;
	middle = cpu_seconds() - middle;
	if (out->decode == 0 || middle < out->decode)
		out->decode = middle;
	step_release(&file);
	array_release(&text);
	report_release(&report);
}

static void
figures_print(const char *name, const struct figures *figures)
{
	const char *tail = name;

	for (const char *at = name; *at; at++)
		if (*at == '/')
			tail = at + 1;
	printf("%-44.44s %8.2f %8.0f %8.0f\n", tail, figures->bytes / 1e6,
		figures->bytes / figures->index / 1e6,
		figures->bytes / figures->decode / 1e6);
}

static void
file_measure(const char *name, struct figures *total)
{
	struct figures figures = {.bytes = 0};
	struct step_bytes bytes = {.count = 0};
	struct tcs_fault fault;
	struct input input;

	if (input_open(&input, name, &fault) ||
		step_load(&bytes, &input, 0, 1, &fault))
		die(name, fault.text);
	input_close(&input);
	figures.bytes = (double)bytes.count;
	for (int pass = 0; pass < PASSES; pass++)
		measure(name, &bytes, &figures);
	array_release(&bytes);
	figures_print(name, &figures);
	total->bytes += figures.bytes;
	total->index += figures.index;
	total->decode += figures.decode;
}

static bool
is_large(const char *name)
{
	FILE *file = fopen(name, "rb");
	bool large;

	if (!file)
		return false;
	large = !fseek(file, 0, SEEK_END) && ftell(file) >= LARGE;
	fclose(file);
	return large;
}

static void
corpus_measure(struct figures *total)
{
	static const char *const patterns[] = {
		"../shared/data/ifc/*/*.ifc", "../shared/data/ifc/*/*/*.ifc"};
	glob_t found = {.gl_pathc = 0};

	for (size_t i = 0; i < sizeof patterns / sizeof *patterns; i++)
		if (glob(patterns[i], i ? GLOB_APPEND : 0, NULL, &found) ==
			GLOB_NOSPACE)
			die("", "out of memory");
	for (size_t i = 0; i < found.gl_pathc; i++)
		if (is_large(found.gl_pathv[i]))
			file_measure(found.gl_pathv[i], total);
	globfree(&found);
}

int
main(int argc, char **argv)
{
	struct figures total = {.bytes = 0};

	printf("%-44s %8s %8s %8s\n", "", "MB", "index", "decode");
	for (int i = 1; i < argc; i++)
		file_measure(argv[i], &total);
	if (argc == 1)
		corpus_measure(&total);
	if (total.bytes > 0)
		figures_print("total", &total);
	else
		puts("no files");
	return 0;
}
