/*
 * An output that appears whole or not at all.
 *
 * A named file is written under a temporary name beside it and renamed by
 * output_commit; output_discard, a fatal signal or an exit without commit
 * removes it. It has the mode of the file it replaces, or the one the umask
 * grants a new one; behind a symbolic link it is the file pointed to that is
 * replaced. Standard output is written as it comes.
 */
#ifndef TESSERA_OUTPUT_H
#define TESSERA_OUTPUT_H

#include <stdio.h>

#include "fault.h"

struct output {
	FILE *file; /* to write to; belongs to the output */
	const char *name; /* as given, for messages; borrowed */
	char *temporary; /* NULL for what is written directly */
	char *target; /* what the temporary becomes: the name, links followed */
};

/*
 * NULL and "-" are standard output. A name that is there and no regular file
 * (a device, a pipe) is written directly. The first named output of a process
 * arranges the clean-up on exit and on fatal signals whose action is still the
 * default; at most 16 may be open at a time. Fails with TCS_SYSTEM or
 * TCS_NO_MEMORY.
 */
enum tcs_status output_open(struct output *output, const char *name,
	struct tcs_fault *fault) TCS_CHECKED;

/*
 * Flush, check that every byte arrived, close, rename. On failure the file is
 * discarded.
 */
enum tcs_status output_commit(
	struct output *output, struct tcs_fault *fault) TCS_CHECKED;

/* Close and remove; harmless after a commit. */
void output_discard(struct output *output);

#endif
