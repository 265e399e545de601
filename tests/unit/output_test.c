#include "output.h"

#include <dirent.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "check.h"

/* A folder of our own, which the tests make the current one. */
static char folder[] = "/tmp/tessera-output-XXXXXX";

static int
files_here(void)
{
	DIR *directory = opendir(".");
	int count = 0;

	while (readdir(directory))
		count++;
	closedir(directory);
	return count - 2;
}

static bool
holds(const char *name, const char *text)
{
	char content[64] = "";
	FILE *file = fopen(name, "r");
	size_t length;

	if (!file)
		return false;
	length = fread(content, 1, sizeof content - 1, file);
	fclose(file);
	return length == strlen(text) && !memcmp(content, text, length);
}

static unsigned
mode_of(const char *name)
{
	struct stat there;

	return stat(name, &there) ? 0 : there.st_mode & 0777;
}

static void
put(const char *name, const char *text)
{
	struct output output;
	struct tcs_fault fault;

	CHECK(!output_open(&output, name, &fault));
	CHECK(fputs(text, output.file) >= 0);
	CHECK(!output_commit(&output, &fault));
	output_discard(&output);
}

static void
a_file_appears_with_its_commit_only(void)
{
	struct output output;
	struct tcs_fault fault;

	CHECK(!output_open(&output, "town", &fault));
	CHECK(fputs("wall", output.file) >= 0);
	CHECK(access("town", F_OK) != 0);
	CHECK(!output_commit(&output, &fault));
	CHECK(holds("town", "wall") && files_here() == 1);
	unlink("town");
}

static void
what_is_discarded_leaves_the_old_file(void)
{
	struct output output;
	struct tcs_fault fault;

	put("town", "old");
	CHECK(!output_open(&output, "town", &fault));
	CHECK(fputs("new", output.file) >= 0);
	output_discard(&output);
	CHECK(holds("town", "old") && files_here() == 1);
	unlink("town");
}

static void
modes_follow_the_umask_and_the_old_file(void)
{
	mode_t before = umask(027);

	put("town", "a");
	CHECK(mode_of("town") == 0640);
	CHECK(!chmod("town", 0604));
	put("town", "b");
	CHECK(mode_of("town") == 0604 && holds("town", "b"));
	umask(before);
	unlink("town");
}

static void
a_link_stays_and_its_file_is_replaced(void)
{
	CHECK(!mkdir("deep", 0755) && !symlink("deep/town", "link"));
	CHECK(!symlink("link", "link2"));
	put("link2", "through a link to nothing yet");
	CHECK(holds("deep/town", "through a link to nothing yet"));
	put("link2", "again");
	CHECK(holds("deep/town", "again") && files_here() == 3);
	unlink("link");
	unlink("link2");
	unlink("deep/town");
	rmdir("deep");
}

static void
a_loop_of_links_is_a_fault(void)
{
	struct output output;
	struct tcs_fault fault;

	CHECK(!symlink("loop", "loop"));
	CHECK(output_open(&output, "loop", &fault) == TCS_SYSTEM);
	unlink("loop");
	CHECK(files_here() == 0);
}

static void
a_device_is_written_directly(void)
{
	struct output output;
	struct tcs_fault fault;

	put("/dev/null", "gone");
	CHECK(!output_open(&output, "/dev/full", &fault));
	CHECK(output.temporary == NULL);
	CHECK(fputs("no room", output.file) >= 0);
	CHECK(output_commit(&output, &fault) == TCS_SYSTEM);
	CHECK(strstr(fault.text, "cannot write /dev/full: No space") != NULL);
}

static void
a_folder_that_is_not_there_is_a_fault(void)
{
	struct output output;
	struct tcs_fault fault;

	CHECK(output_open(&output, "nowhere/town", &fault) == TCS_SYSTEM);
	CHECK(strstr(fault.text, "cannot write nowhere/town: ") != NULL);
	CHECK(output_open(&output, ".", &fault) == TCS_SYSTEM);
}

static void
a_name_as_long_as_names_may_be_works(void)
{
	char name[256];

	memset(name, 'n', 255);
	name[255] = '\0';
	put(name, "long");
	CHECK(holds(name, "long") && files_here() == 1);
	unlink(name);
}

/* A child opens two outputs and then ends as `end` says. */
static int
child_ends(void (*end)(void))
{
	pid_t child = fork();
	int status = -1;

	if (child == 0) {
		struct output a, b;
		struct tcs_fault fault;

		if (output_open(&a, "town", &fault) ||
			output_open(&b, "stats", &fault))
			_exit(9);
		fputs("half", a.file);
		fflush(a.file);
		end();
		_exit(8);
	}
	CHECK(child > 0 && waitpid(child, &status, 0) == child);
	return status;
}

static void
end_by_term(void)
{
	raise(SIGTERM);
}

static void
end_by_int(void)
{
	raise(SIGINT);
}

static void
end_by_exit(void)
{
	exit(3);
}

static void
a_signal_or_an_exit_leaves_nothing_behind(void)
{
	int status = child_ends(end_by_term);

	CHECK(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
	CHECK(files_here() == 0);
	status = child_ends(end_by_int);
	CHECK(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
	CHECK(files_here() == 0);
	status = child_ends(end_by_exit);
	CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 3);
	CHECK(files_here() == 0);
}

static void
end_after_ignored_hup(void)
{
	raise(SIGHUP);
	_exit(5);
}

static void
an_ignored_signal_stays_ignored(void)
{
	int status;

	signal(SIGHUP, SIG_IGN);
	status = child_ends(end_after_ignored_hup);
	signal(SIGHUP, SIG_DFL);
	CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 5);
	CHECK(files_here() == 2); /* _exit runs no clean-up */
	CHECK(system("rm -f .tessera-*.tmp") == 0);
}

static const struct check_test tests[] = {
	CHECK_TEST(a_signal_or_an_exit_leaves_nothing_behind),
	CHECK_TEST(an_ignored_signal_stays_ignored),
	CHECK_TEST(a_file_appears_with_its_commit_only),
	CHECK_TEST(what_is_discarded_leaves_the_old_file),
	CHECK_TEST(modes_follow_the_umask_and_the_old_file),
	CHECK_TEST(a_link_stays_and_its_file_is_replaced),
	CHECK_TEST(a_loop_of_links_is_a_fault),
	CHECK_TEST(a_device_is_written_directly),
	CHECK_TEST(a_folder_that_is_not_there_is_a_fault),
	CHECK_TEST(a_name_as_long_as_names_may_be_works),
	{0},
};

int
main(void)
{
	int result;

	if (!mkdtemp(folder) || chdir(folder))
		return 1;
	result = check_run(tests);
	return chdir("/") || rmdir(folder) ? 1 : result;
}
