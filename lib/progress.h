/*
 * Progress on standard error: only on a terminal, after one second, at most
 * six times a second, and never with --quiet.
 */
#ifndef TESSERA_PROGRESS_H
#define TESSERA_PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
	const char *program;
	const char *item; /* what is counted: "objects" */
	bool shown; /* a line stands on the terminal */
	bool off;
	double began, last; /* seconds of the monotonic clock */
};

void progress_begin(struct progress *progress, const char *program,
	const char *item, bool quiet);
/* `total` 0: unknown. Cheap enough for every item. */
void progress_show(struct progress *progress, uint64_t items, uint64_t done,
	uint64_t total);
/* Wipe the line. */
void progress_end(struct progress *progress);

#endif
