#include "output.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum {
	MAX_PENDING = 16, /* named outputs open at the same time */
	MAX_LINKS = 40,
	MAX_LINK_LENGTH = 4096,
	MAX_TRIES = 1000,
};

/*
 * The temporaries there are, for those who leave in a hurry: a signal handler
 * can be handed nothing. `dying` keeps a name alive that a handler on another
 * thread may have just looked up.
 */
static char *_Atomic pending[MAX_PENDING];
static atomic_bool dying;

static void
remove_pending(void)
{
	dying = true;
	for (int i = 0; i < MAX_PENDING; i++) {
		char *name = pending[i];

		if (name)
			unlink(name);
	}
}

static void
on_fatal_signal(int number)
{
	remove_pending();
	raise(number); /* the default action is back: SA_RESETHAND */
}

/* A signal that is ignored, as under nohup, stays ignored. */
static void
catch_fatal_signals(void)
{
	static const int numbers[] = {
		SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU, SIGXFSZ};
	struct sigaction action = {
		.sa_handler = on_fatal_signal,
		.sa_flags = (int)SA_RESETHAND | SA_NODEFER,
	};

	sigemptyset(&action.sa_mask);
	for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
		struct sigaction before;

		if (!sigaction(numbers[i], NULL, &before) &&
			before.sa_handler == SIG_DFL)
			sigaction(numbers[i], &action, NULL);
	}
}

static bool
pending_add(char *name)
{
	static atomic_flag prepared = ATOMIC_FLAG_INIT;

	if (!atomic_flag_test_and_set(&prepared)) {
		catch_fatal_signals();
		if (atexit(remove_pending))
			return false;
	}
	for (int i = 0; i < MAX_PENDING; i++) {
		char *none = NULL;

		if (atomic_compare_exchange_strong(&pending[i], &none, name))
			return true;
	}
	return false;
}

static void
pending_drop(char *name)
{
	for (int i = 0; i < MAX_PENDING; i++)
		if (pending[i] == name)
			pending[i] = NULL;
	if (!dying)
		free(name);
}

/* `name` put into the folder of `beside`, unless it is absolute. */
static char *
name_beside(const char *beside, const char *name)
{
	const char *slash = strrchr(beside, '/');
	size_t folder =
		slash && *name != '/' ? (size_t)(slash - beside) + 1 : 0;
	size_t length = strlen(name) + 1;
	char *joined = malloc(folder + length);

	if (!joined)
		return NULL;
	memcpy(joined, beside, folder);
	memcpy(joined + folder, name, length);
	return joined;
}

/* What `name` stands for when its links are followed; to be freed. */
static char *
follow_links(const char *name)
{
	char *at = strdup(name);

	for (int i = 0; at; i++) {
		char target[MAX_LINK_LENGTH];
		ssize_t length = readlink(at, target, sizeof target - 1);
		char *next;

		if (length < 0)
			return at; /* no link: here, or nothing yet */
		if (i == MAX_LINKS) {
			free(at);
			errno = ELOOP;
			return NULL;
		}
		target[length] = '\0';
		next = name_beside(at, target);
		free(at);
		at = next;
	}
	return NULL;
}

/* A new file beside `target`, its name in *out; -1 with errno. */
static int
temporary_create(const char *target, char **out)
{
	struct timespec now;

	clock_gettime(CLOCK_REALTIME, &now);
	for (int i = 0; i < MAX_TRIES; i++) {
		char base[64];
		char *name;
		int fd;

		snprintf(base, sizeof base, ".tessera-%ld-%09ld-%d.tmp",
			(long)getpid(), now.tv_nsec, i);
		name = name_beside(target, base);
		if (!name)
			return -1;
		fd = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
		if (fd >= 0) {
			*out = name;
			return fd;
		}
		free(name);
		if (errno != EEXIST)
			return -1;
	}
	return -1;
}

/* Everything errno names is in the text; the caller's fault is filled. */
static enum tcs_status
open_beside(struct output *output, const struct stat *there,
	struct tcs_fault *fault)
{
	char *target = follow_links(output->name);
	char *temporary = NULL;
	int fd = target ? temporary_create(target, &temporary) : -1;

	if (fd < 0) {
		fault_system(fault, "cannot write", output->name);
		free(target);
		return fault->status;
	}
	output->target = target;
	output->temporary = temporary;
	if (!pending_add(temporary)) {
		close(fd);
		output_discard(output);
		return fault_memory(fault);
	}
	if (!there || !fchmod(fd, there->st_mode & 0777))
		output->file = fdopen(fd, "wb");
	if (!output->file) {
		fault_system(fault, "cannot write", output->name);
		close(fd);
		output_discard(output);
		return fault->status;
	}
	return TCS_OK;
}

enum tcs_status
output_open(struct output *output, const char *name, struct tcs_fault *fault)
{
	struct stat there;
	bool exists;

	*output = (struct output){.name = name};
	if (!name || !strcmp(name, "-")) {
		output->name = "standard output";
		output->file = stdout;
		return TCS_OK;
	}
	exists = !stat(name, &there);
	if (!exists || S_ISREG(there.st_mode))
		return open_beside(output, exists ? &there : NULL, fault);
	output->file = fopen(name, "wb");
	return output->file ? TCS_OK
			    : fault_system(fault, "cannot write", name);
}

/*
 * Flush and close, so that a disk that fills up at the very end is noticed.
 * Standard output stays open, but its descriptor's copy reports the same.
 */
static int
close_checked(FILE *file)
{
	int copy, bad;

	if (file != stdout)
		return fclose(file);
	if (fflush(file))
		return -1;
	copy = dup(fileno(file));
	bad = copy < 0 || close(copy);
	return bad ? -1 : 0;
}

static void
output_forget(struct output *output)
{
	if (output->temporary)
		pending_drop(output->temporary);
	free(output->target);
	output->file = NULL;
	output->temporary = NULL;
	output->target = NULL;
}

enum tcs_status
output_commit(struct output *output, struct tcs_fault *fault)
{
	FILE *file = output->file;

	if (ferror(file)) {
		output_discard(output);
		return fault_set(fault, TCS_SYSTEM, TCS_NOWHERE,
			"cannot write %s: an earlier write failed",
			output->name);
	}
	output->file = NULL;
	if (close_checked(file)) {
		fault_system(fault, "cannot write", output->name);
		output_discard(output);
		return fault->status;
	}
	if (output->temporary && rename(output->temporary, output->target)) {
		fault_system(fault, "cannot write", output->name);
		output_discard(output);
		return fault->status;
	}
	output_forget(output);
	return TCS_OK;
}

void
output_discard(struct output *output)
{
	if (output->file && output->file != stdout)
		fclose(output->file);
	if (output->temporary)
		unlink(output->temporary);
	output_forget(output);
}
