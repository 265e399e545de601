#include "pipeline.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum {
	MAX_PATH = 4096,
	PATIENCE = 5, /* seconds from SIGTERM to SIGKILL */
	EXIT_CANNOT_RUN = 127,
};

static char *
join_path(const char *folder, size_t length, const char *program)
{
	size_t name_length = strlen(program) + 1;
	char *path = malloc(length + 1 + name_length);

	if (!path)
		return NULL;
	memcpy(path, folder, length);
	path[length] = '/';
	memcpy(path + length + 1, program, name_length);
	return path;
}

/* Beside the running program; NULL with errno where there is none. */
static char *
find_beside(const char *program)
{
	char self[MAX_PATH];
	ssize_t length = readlink("/proc/self/exe", self, sizeof self);
	char *path;

	while (length > 0 && self[length - 1] != '/')
		length--;
	if (length <= 0)
		return NULL;
	path = join_path(self, (size_t)length - 1, program);
	if (!path || !access(path, X_OK))
		return path;
	free(path);
	return NULL;
}

/* Along PATH; NULL with errno where there is none. */
static char *
find_along_path(const char *program)
{
	const char *at = getenv("PATH");

	while (at && *at) {
		size_t length = strcspn(at, ":");
		char *path = length ? join_path(at, length, program)
				    : join_path(".", 1, program);

		if (!path || !access(path, X_OK))
			return path;
		free(path);
		at += length;
		at += *at == ':';
	}
	errno = ENOENT;
	return NULL;
}

enum tcs_status
pipeline_add(
	struct pipeline *pipeline, const char *program, struct tcs_fault *fault)
{
	struct pipeline_stage *stage;
	char *path = find_beside(program);

	if (!path)
		path = find_along_path(program);
	if (!path && errno == ENOMEM)
		return fault_memory(fault);
	if (!path)
		return fault_set(fault, TCS_SYSTEM, TCS_NOWHERE,
			"needs %s, which is neither beside this program nor "
			"on PATH",
			program);
	if (array_grow(&pipeline->stages, 1)) {
		free(path);
		return fault_memory(fault);
	}
	stage = &pipeline->stages.at[pipeline->stages.count++];
	*stage = (struct pipeline_stage){
		.program = program, .path = path, .feed = -1};
	return pipeline_argument(
		pipeline, pipeline->stages.count - 1, program, fault);
}

enum tcs_status
pipeline_argument(struct pipeline *pipeline, size_t number,
	const char *argument, struct tcs_fault *fault)
{
	struct pipeline_stage *stage = &pipeline->stages.at[number];
	char *copy = strdup(argument);

	/* One more is kept free for the NULL that ends argv. */
	if (!copy || array_grow(&stage->arguments, 2)) {
		free(copy);
		return fault_memory(fault);
	}
	stage->arguments.at[stage->arguments.count++] = copy;
	stage->arguments.at[stage->arguments.count] = NULL;
	return TCS_OK;
}

void
pipeline_release(struct pipeline *pipeline)
{
	for (size_t i = 0; i < pipeline->stages.count; i++) {
		struct pipeline_stage *stage = &pipeline->stages.at[i];

		for (size_t k = 0; k < stage->arguments.count; k++)
			free(stage->arguments.at[k]);
		array_release(&stage->arguments);
		free(stage->path);
	}
	array_release(&pipeline->stages);
}

/* ---- printing ----------------------------------------------------------- */

static void
print_quoted(const char *word, FILE *to)
{
	static const char plain[] = "abcdefghijklmnopqrstuvwxyz"
				    "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
				    "0123456789-_./,:=+@%";

	if (*word && strspn(word, plain) == strlen(word)) {
		fputs(word, to);
		return;
	}
	putc('\'', to);
	for (; *word; word++) {
		if (*word == '\'')
			fputs("'\\''", to);
		else
			putc(*word, to);
	}
	putc('\'', to);
}

void
pipeline_print(const struct pipeline *pipeline, FILE *to)
{
	for (size_t i = 0; i < pipeline->stages.count; i++) {
		const struct pipeline_stage *stage = &pipeline->stages.at[i];

		if (i)
			fputs(" | ", to);
		for (size_t k = 0; k < stage->arguments.count; k++) {
			if (k)
				putc(' ', to);
			print_quoted(stage->arguments.at[k], to);
		}
	}
	putc('\n', to);
}

/* ---- running ------------------------------------------------------------ */

/* The signals we wait for, and the mask that the stages get. */
struct watch {
	sigset_t awaited, before;
	int fatal; /* the first fatal signal that came; 0: none */
	bool ending; /* the stages have been told to end */
};

static void
watch_begin(struct watch *watch)
{
	static const int fatal[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM};

	*watch = (struct watch){0};
	signal(SIGCHLD, SIG_DFL); /* ignored, there would be no status */
	sigemptyset(&watch->awaited);
	sigaddset(&watch->awaited, SIGCHLD);
	for (size_t i = 0; i < sizeof fatal / sizeof *fatal; i++) {
		struct sigaction action;

		/* Ignored, as under nohup, it stays ignored. */
		if (!sigaction(fatal[i], NULL, &action) &&
			action.sa_handler != SIG_IGN)
			sigaddset(&watch->awaited, fatal[i]);
	}
	sigprocmask(SIG_BLOCK, &watch->awaited, &watch->before);
}

static _Noreturn void
become_stage(const struct pipeline_stage *stage, const struct watch *watch,
	int in, int out)
{
	signal(SIGPIPE, SIG_DFL);
	signal(SIGCHLD, SIG_DFL);
	sigprocmask(SIG_SETMASK, &watch->before, NULL);
	if ((in < 0 || dup2(in, STDIN_FILENO) >= 0) &&
		(out < 0 || dup2(out, STDOUT_FILENO) >= 0))
		execv(stage->path, stage->arguments.at);
	fprintf(stderr, "%s: cannot be started: %s\n", stage->path,
		strerror(errno));
	_exit(EXIT_CANNOT_RUN);
}

static int
pipe_private(int ends[2])
{
	if (pipe(ends))
		return -1;
	if (fcntl(ends[0], F_SETFD, FD_CLOEXEC) >= 0 &&
		fcntl(ends[1], F_SETFD, FD_CLOEXEC) >= 0)
		return 0;
	close(ends[0]);
	close(ends[1]);
	return -1;
}

static void
close_feed(struct pipeline_stage *stage)
{
	if (stage->feed >= 0)
		close(stage->feed);
	stage->feed = -1;
}

/* `*in` is the end to read from, and becomes the next stage's. */
static enum tcs_status
start_stage(struct pipeline_stage *stage, const struct watch *watch,
	bool is_last, int *in, struct tcs_fault *fault)
{
	int ends[2] = {-1, -1};

	if (!is_last && pipe_private(ends))
		return fault_system(fault, "cannot start", stage->program);
	stage->process = fork();
	if (stage->process == 0)
		become_stage(stage, watch, *in, ends[1]);
	stage->feed = ends[1];
	if (*in >= 0)
		close(*in);
	*in = ends[0];
	if (stage->process > 0)
		return TCS_OK;
	stage->process = 0;
	close_feed(stage);
	return fault_system(fault, "cannot start", stage->program);
}

static void
end_stages(struct pipeline *pipeline, struct watch *watch, int number)
{
	for (size_t i = 0; i < pipeline->stages.count; i++) {
		struct pipeline_stage *stage = &pipeline->stages.at[i];

		if (!stage->process)
			continue;
		stage->ended = true;
		kill(stage->process, number);
	}
	watch->ending = true;
}

static bool
is_running(const struct pipeline *pipeline)
{
	for (size_t i = 0; i < pipeline->stages.count; i++)
		if (pipeline->stages.at[i].process)
			return true;
	return false;
}

static bool
is_broken_pipe(const struct pipeline_stage *stage)
{
	return WIFSIGNALED(stage->status) && WTERMSIG(stage->status) == SIGPIPE;
}

/*
 * Take the stages that are over. The kept end of a pipe is closed when its
 * writer has succeeded; a broken pipe is the fault of who should have read.
 */
static void
collect(struct pipeline *pipeline, struct watch *watch)
{
	bool failed = false;

	for (size_t i = 0; i < pipeline->stages.count; i++) {
		struct pipeline_stage *stage = &pipeline->stages.at[i];

		if (!stage->process ||
			waitpid(stage->process, &stage->status, WNOHANG) !=
				stage->process)
			continue;
		stage->process = 0;
		if (!stage->status)
			close_feed(stage);
		else if (!is_broken_pipe(stage))
			failed = true;
	}
	if (failed && !watch->ending)
		end_stages(pipeline, watch, SIGTERM);
}

static void
await_all(struct pipeline *pipeline, struct watch *watch)
{
	while (is_running(pipeline)) {
		const struct timespec patience = {.tv_sec = PATIENCE};
		int number = watch->ending
			? sigtimedwait(&watch->awaited, NULL, &patience)
			: sigwaitinfo(&watch->awaited, NULL);

		if (number < 0 && errno == EAGAIN)
			end_stages(pipeline, watch, SIGKILL);
		if (number > 0 && number != SIGCHLD) {
			if (!watch->fatal)
				watch->fatal = number;
			end_stages(pipeline, watch, SIGTERM);
		}
		collect(pipeline, watch);
	}
}

/* The stage that failed by itself; NULL for none. */
static const struct pipeline_stage *
find_culprit(const struct pipeline *pipeline)
{
	const struct pipeline_stage *last = NULL;

	for (size_t i = 0; i < pipeline->stages.count; i++) {
		const struct pipeline_stage *stage = &pipeline->stages.at[i];

		if (!stage->status)
			continue;
		if (!stage->ended && !is_broken_pipe(stage))
			return stage;
		last = stage;
	}
	return last;
}

static enum tcs_status
describe(const struct pipeline_stage *stage, int *exit_status,
	struct tcs_fault *fault)
{
	if (WIFSIGNALED(stage->status)) {
		*exit_status = 1;
		return fault_set(fault, TCS_SYSTEM, TCS_NOWHERE,
			"%s was ended by signal %d (%s)", stage->program,
			WTERMSIG(stage->status),
			strsignal(WTERMSIG(stage->status)));
	}
	*exit_status = WEXITSTATUS(stage->status);
	return fault_set(fault, TCS_SYSTEM, TCS_NOWHERE,
		"%s failed with exit status %d", stage->program, *exit_status);
}

enum tcs_status
pipeline_run(struct pipeline *pipeline, int *exit_status, int *signal_number,
	struct tcs_fault *fault)
{
	enum tcs_status status = TCS_OK;
	const struct pipeline_stage *culprit;
	struct watch watch;
	int in = -1;

	*exit_status = 0;
	watch_begin(&watch);
	for (size_t i = 0; !status && i < pipeline->stages.count; i++)
		status = start_stage(&pipeline->stages.at[i], &watch,
			i + 1 == pipeline->stages.count, &in, fault);
	if (in >= 0)
		close(in);
	if (status)
		end_stages(pipeline, &watch, SIGTERM);
	await_all(pipeline, &watch);
	for (size_t i = 0; i < pipeline->stages.count; i++)
		close_feed(&pipeline->stages.at[i]);
	sigprocmask(SIG_SETMASK, &watch.before, NULL);
	*signal_number = watch.fatal;
	if (status) {
		*exit_status = 1;
		return status;
	}
	culprit = find_culprit(pipeline);
	if (!culprit)
		return TCS_OK;
	if (is_broken_pipe(culprit) && !*signal_number)
		*signal_number = SIGPIPE;
	return describe(culprit, exit_status, fault);
}
