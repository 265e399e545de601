#define _XOPEN_SOURCE 700 /* posix_openpt */

#include "progress.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "check.h"

/* A terminal in the place of standard error; what it got is read behind it. */
static int terminal, before;

static void
terminal_open(void)
{
	int slave;

	terminal = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
	CHECK(terminal >= 0 && !grantpt(terminal) && !unlockpt(terminal));
	slave = open(ptsname(terminal), O_RDWR | O_NOCTTY);
	before = dup(STDERR_FILENO);
	dup2(slave, STDERR_FILENO);
	close(slave);
}

/* What came, as text of less than `room`; it arrives a little later. */
static void
terminal_close(char *text, size_t room)
{
	size_t length = 0;
	ssize_t got;

	fflush(stderr);
	do {
		nanosleep(&(struct timespec){.tv_nsec = 50000000}, NULL);
		got = read(terminal, text + length, room - 1 - length);
		length += got > 0 ? (size_t)got : 0;
	} while (got > 0);
	text[length] = '\0';
	dup2(before, STDERR_FILENO);
	close(before);
	close(terminal);
}

static double
seconds_now(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

/* Show all the time, for so many seconds or, on a busy machine, more. */
static double
show_for(struct progress *progress, double seconds)
{
	double began = seconds_now();

	for (uint64_t i = 0; seconds_now() - began < seconds; i++) {
		progress_show(progress, i, 30, 120);
		nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
	}
	return seconds_now() - began;
}

static int
lines_in(const char *text)
{
	int lines = 0;

	while ((text = strstr(text, "prog: "))) {
		lines++;
		text++;
	}
	return lines;
}

static void
the_first_second_is_silent(void)
{
	struct progress progress;
	char text[4096];

	terminal_open();
	progress_begin(&progress, "prog", "objects", false);
	show_for(&progress, 0.3);
	progress_end(&progress);
	terminal_close(text, sizeof text);
	CHECK(!*text);
}

static void
then_it_shows_six_times_a_second_at_most_and_wipes(void)
{
	struct progress progress;
	char text[4096];
	double seconds;
	size_t length;

	terminal_open();
	progress_begin(&progress, "prog", "objects", false);
	progress.began -= 1;
	progress.last -= 1;
	seconds = show_for(&progress, 0.8);
	progress_end(&progress);
	terminal_close(text, sizeof text);
	CHECK(lines_in(text) >= 2);
	CHECK(lines_in(text) <= 2 + (int)(6 * seconds));
	CHECK(strstr(text, "objects, 25 %, ") != NULL);
	length = strlen(text);
	CHECK(length > 4 && !strcmp(text + length - 4, "\r\033[K"));
}

static void
quiet_or_no_terminal_is_silence(void)
{
	struct progress progress;
	char text[64];

	terminal_open();
	progress_begin(&progress, "prog", "objects", true);
	progress.began -= 10;
	progress.last -= 10;
	show_for(&progress, 0.01);
	progress_end(&progress);
	terminal_close(text, sizeof text);
	CHECK(!*text);
	before = dup(STDERR_FILENO);
	CHECK(freopen("/dev/null", "w", stderr) != NULL);
	progress_begin(&progress, "prog", "objects", false);
	CHECK(progress.off);
	dup2(before, STDERR_FILENO);
	close(before);
}

static const struct check_test tests[] = {
	CHECK_TEST(the_first_second_is_silent),
	CHECK_TEST(then_it_shows_six_times_a_second_at_most_and_wipes),
	CHECK_TEST(quiet_or_no_terminal_is_silence),
	{0},
};

int
main(void)
{
	return check_run(tests);
}
