#include "parsers/step_load.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "check.h"

enum { LONG = 9000001 }; /* bytes: more than two threads read in one go */

static char name[] = "/tmp/tessera-load-XXXXXX";
static char *text;

static void
store(size_t length)
{
	FILE *file = fopen(name, "wb");

	CHECK(file && fwrite(text, 1, length, file) == length);
	fclose(file);
}

/* The file becomes so long between being opened and being read. */
static bool
loads(size_t length, size_t becomes, unsigned jobs)
{
	struct step_bytes bytes = {.count = 0};
	struct input input = {0};
	struct tcs_fault fault;
	bool same;

	store(length);
	if (input_open(&input, name, &fault))
		return false;
	if (becomes < length)
		CHECK(!truncate(name, (off_t)becomes));
	else if (becomes > length)
		store(becomes);
	same = !step_load(&bytes, &input, 0, jobs, &fault) &&
		bytes.count == becomes && !memcmp(bytes.at, text, becomes) &&
		input.at == becomes;
	input_close(&input);
	array_release(&bytes);
	return same;
}

static void
threads_read_what_one_reads(void)
{
	for (unsigned jobs = 1; jobs < 5; jobs++) {
		CHECK(loads(LONG, LONG, jobs));
		CHECK(loads(1 << 23, 1 << 23, jobs));
		CHECK(loads(3, 3, jobs));
	}
}

static void
a_file_that_is_cut_meanwhile_is_read_as_far_as_it_goes(void)
{
	CHECK(loads(LONG, 5000000, 2));
	CHECK(loads(LONG, 1 << 22, 2));
}

static void
a_file_that_grows_meanwhile_is_read_to_its_end(void)
{
	CHECK(loads(LONG - 1000000, LONG, 2));
}

static void
a_limit_holds_for_threads_too(void)
{
	for (unsigned jobs = 1; jobs < 3; jobs++) {
		struct step_bytes bytes = {.count = 0};
		struct input input = {0};
		struct tcs_fault fault;

		store(LONG);
		CHECK(!input_open(&input, name, &fault));
		CHECK(step_load(&bytes, &input, LONG - 1, jobs, &fault) ==
			TCS_LIMIT);
		input_close(&input);
		array_release(&bytes);
	}
}

static const struct check_test tests[] = {
	CHECK_TEST(threads_read_what_one_reads),
	CHECK_TEST(a_file_that_is_cut_meanwhile_is_read_as_far_as_it_goes),
	CHECK_TEST(a_file_that_grows_meanwhile_is_read_to_its_end),
	CHECK_TEST(a_limit_holds_for_threads_too),
	{0},
};

int
main(void)
{
	int file = mkstemp(name);
	int code;

	text = malloc(LONG);
	if (file < 0 || !text)
		return 1;
	close(file);
	for (size_t i = 0; i < LONG; i++)
		text[i] = (char)('a' + i * i / 4097 % 26);
	code = check_run(tests);
	unlink(name);
	free(text);
	return code;
}
