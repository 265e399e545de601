/*
 * A pipe of programs, started and watched as one.
 *
 * Each stage reads what the one before it writes; the first has the caller's
 * standard input, the last the caller's standard output. When one fails, those
 * still running are ended; a stage never sees the end of its input before the
 * one feeding it has succeeded, so no stage mistakes a failure upstream for a
 * short input. Fatal signals that reach the caller meanwhile end all stages,
 * then the caller.
 */
#ifndef TESSERA_PIPELINE_H
#define TESSERA_PIPELINE_H

#include <stdbool.h>
#include <stdio.h>
#include <sys/types.h>

#include "array.h"
#include "fault.h"

struct pipeline_stage {
	const char *program; /* its name; borrowed */
	char *path; /* the file it is; owned */
	TCS_ARRAY(char *) arguments; /* argv: the name first; owned */
	pid_t process; /* 0: not running */
	int feed; /* kept end of the pipe into the next stage; -1: none */
	int status; /* as waitpid gives it */
	bool ended; /* by us, because another failed */
};

/* All zero is the empty pipe. */
struct pipeline {
	TCS_ARRAY(struct pipeline_stage) stages;
};

/*
 * Append a stage; the program is looked for in the caller's own folder, then
 * along PATH. Fails with TCS_SYSTEM, naming it, when it is in neither.
 */
enum tcs_status pipeline_add(struct pipeline *pipeline, const char *program,
	struct tcs_fault *fault) TCS_CHECKED;

/* Append an argument to a stage, counted from 0. */
enum tcs_status pipeline_argument(struct pipeline *pipeline, size_t stage,
	const char *argument, struct tcs_fault *fault) TCS_CHECKED;

/* "a --x 'in file' | b -o out", as a shell reads it. */
void pipeline_print(const struct pipeline *pipeline, FILE *to);

/*
 * Run all stages to their end. *exit_status is 0 when all succeeded, else that
 * of the stage to blame: the first one that neither a broken pipe nor we
 * ended; 1 for a signal. Fails with TCS_SYSTEM, and a text that names the
 * stage to blame, or what could not be started. A fatal signal to the caller,
 * or SIGPIPE when nobody reads what the last stage writes, is returned in
 * *signal_number once no stage runs; 0 for none.
 */
enum tcs_status pipeline_run(struct pipeline *pipeline, int *exit_status,
	int *signal_number, struct tcs_fault *fault) TCS_CHECKED;

void pipeline_release(struct pipeline *pipeline);

#endif
