/*
 * The frame of a program: what happens between its command line and its exit
 * status, the same everywhere.
 *
 * The program's work opens the input and the output, and closes what it opened
 * but for the outputs. When it succeeds, --stats is written and the outputs
 * appear; when it fails, neither does. What was skipped or repaired is said
 * on standard error either way.
 */
#ifndef TESSERA_STAGE_H
#define TESSERA_STAGE_H

#include "output.h"
#include "program.h"
#include "report.h"

struct stage {
	const struct command *command;
	struct output out; /* for the work to open */
	struct output beside; /* the same: a second file, which appears first
	                         and goes again if `out` cannot appear */
	struct report report; /* for the work to fill; of --stats, too */
};

typedef enum tcs_status stage_work(
	void *context, struct stage *stage, struct tcs_fault *fault);

/* Do the work, print what there is to say, return the exit status. */
int stage_run(const struct command *command, stage_work *work, void *context);

#endif
