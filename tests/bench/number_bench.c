/*
 * Nanoseconds a number beside strtod and snprintf("%.17g"): the same numbers,
 * the same run, CPU time of one thread.
 */
#include "number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { COUNT = 300000 };
struct sample {
	double *values;
	char *text; /* one after the other, a blank behind each */
	size_t *begins; /* COUNT + 1 of them */
};

static double
cpu_nanoseconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
	return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static void
die(const char *text)
{
	fprintf(stderr, "number_bench: %s\n", text);
	exit(1);
}

static uint64_t
random_bits(uint64_t *state)
{
	uint64_t z = *state += 0x9e3779b97f4a7c15u; /* splitmix64 */

	z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
	z = (z ^ z >> 27) * 0x94d049bb133111ebu;
	return z ^ z >> 31;
}

static double
unit(uint64_t *state)
{
	return (double)(random_bits(state) >> 11) * 0x1p-53;
}

/* ---- what is measured ------------------------------------------------------- */

static double
millimetres(uint64_t *state)
{
	return rint(unit(state) * 6e9) / 1000;
}

static double
full_coordinate(uint64_t *state)
{
	return unit(state) * 6e6;
}

static double
latitude(uint64_t *state)
{
	return 48 + unit(state);
}

static double
nearly_zero(uint64_t *state)
{
	return unit(state) * 1e-16;
}

static double
any(uint64_t *state)
{
	double value;

	do {
		uint64_t bits = random_bits(state);

		memcpy(&value, &bits, sizeof value);
	} while (!isfinite(value));
	return value;
}

static void
sample_fill(struct sample *sample, double (*make)(uint64_t *state))
{
	uint64_t state = 1;
	size_t at = 0;

	for (size_t i = 0; i < COUNT; i++) {
		double value = make(&state);

		sample->values[i] = value;
		sample->begins[i] = at;
		at += (size_t)snprintf(sample->text + at, 32, "%.*g ",
			make == millimetres ? 10 : 17, value);
	}
	sample->begins[COUNT] = at;
}

/* ---- measuring --------------------------------------------------------------- */

static double
time_parse(const struct sample *sample)
{
	double begin = cpu_nanoseconds(), value;

	for (size_t i = 0; i < COUNT; i++) {
		const char *end = sample->text + sample->begins[i + 1];

		if (!number_parse(
			    sample->text + sample->begins[i], end, &value) ||
			value != sample->values[i])
			die("a number reads wrong");
	}
	return (cpu_nanoseconds() - begin) / COUNT;
}

static double
time_strtod(const struct sample *sample)
{
	double begin = cpu_nanoseconds();

	for (size_t i = 0; i < COUNT; i++) {
		if (strtod(sample->text + sample->begins[i], NULL) !=
			sample->values[i])
			die("strtod reads wrong");
	}
	return (cpu_nanoseconds() - begin) / COUNT;
}

static double
time_print(const struct sample *sample, size_t *length)
{
	char text[NUMBER_LENGTH];
	double begin = cpu_nanoseconds();

	for (size_t i = 0; i < COUNT; i++)
		*length += number_print(text, sample->values[i]);
	return (cpu_nanoseconds() - begin) / COUNT;
}

static double
time_printf(const struct sample *sample, size_t *length)
{
	char text[NUMBER_LENGTH];
	double begin = cpu_nanoseconds();

	for (size_t i = 0; i < COUNT; i++)
		*length += (size_t)snprintf(
			text, sizeof text, "%.17g", sample->values[i]);
	return (cpu_nanoseconds() - begin) / COUNT;
}

static void
measure(struct sample *sample, const char *name, double (*make)(uint64_t *))
{
	size_t ours = 0, theirs = 0;

	sample_fill(sample, make);
	printf("%-28s %8.1f %8.1f", name, time_parse(sample),
		time_strtod(sample));
	printf(" %8.1f %8.1f", time_print(sample, &ours),
		time_printf(sample, &theirs));
	printf(" %6.1f %6.1f\n", (double)ours / COUNT, (double)theirs / COUNT);
}

int
main(void)
{
	struct sample sample = {calloc(COUNT, sizeof(double)),
		malloc((size_t)32 * COUNT), calloc(COUNT + 1, sizeof(size_t))};

	if (!sample.values || !sample.text || !sample.begins)
		die("out of memory");
	printf("%-28s %8s %8s %8s %8s %13s\n", "nanoseconds a number", "parse",
		"strtod", "print", "printf", "bytes printed");
	measure(&sample, "millimetre coordinates", millimetres);
	measure(&sample, "16 to 17 digit coordinates", full_coordinate);
	measure(&sample, "degrees", latitude);
	measure(&sample, "directions near zero", nearly_zero);
	measure(&sample, "any bits", any);
	free(sample.values);
	free(sample.text);
	free(sample.begins);
	return 0;
}
