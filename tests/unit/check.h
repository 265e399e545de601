/*
 * The few lines a unit test needs. A test is a function named as a sentence;
 * main lists them in one table and ends in `return check_run(tests);`.
 *
 *     static void every_proper_prefix_is_truncated(void) { CHECK(1 + 1 == 2); }
 *     static const struct check_test tests[] = {
 *             CHECK_TEST(every_proper_prefix_is_truncated),
 *             {0},
 *     };
 */
#ifndef TESSERA_CHECK_H
#define TESSERA_CHECK_H

#include <stdio.h>

struct check_test {
	const char *name;
	void (*run)(void);
};

#define CHECK_TEST(function) \
	{ \
#function, function \
	}

static int check_failures;

/* Note a failed condition with its place and go on. */
#define CHECK(condition) \
	((condition) ? (void)0 : check_note(#condition, __FILE__, __LINE__))

static inline void
check_note(const char *condition, const char *file, int line)
{
	check_failures++;
	fprintf(stderr, "%s:%d: not so: %s\n", file, line, condition);
}

static inline int
check_run(const struct check_test *tests)
{
	int passed = 0, failed = 0;

	for (; tests->run; tests++) {
		int before = check_failures;

		tests->run();
		if (check_failures == before) {
			passed++;
			continue;
		}
		failed++;
		fprintf(stderr, "failed: %s\n", tests->name);
	}
	printf("%d passed, %d failed\n", passed, failed);
	return failed ? 1 : 0;
}

#endif
